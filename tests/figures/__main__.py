"""``python -m tests.figures OUT``: the figures of McGuire & Hughes 2004, as PNGs."""

import sys
from pathlib import Path

from tests.figures.mcguire import figure5
from tests.figures.pictures import write_figures

out = Path(sys.argv[1])
out.mkdir(parents=True, exist_ok=True)
for path in (figure5(out), *write_figures(out)):
    print(path)
