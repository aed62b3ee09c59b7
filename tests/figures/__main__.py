"""``python -m tests.figures OUT``: figures of the papers as PNGs: of McGuire & Hughes 2004, Rideout
2010 and Hajagos 2012. What cannot be drawn is named at the end, and the status is 1."""

import sys
from pathlib import Path

from tests.figures import hajagos, rideout
from tests.figures.mcguire import figure5
from tests.figures.pictures import write_figures

out = Path(sys.argv[1])
out.mkdir(parents=True, exist_ok=True)
for path in (figure5(out), *write_figures(out)):
    print(path)
faults = []
for figure in (*rideout.FIGURES, *hajagos.FIGURES):
    try:
        print(figure.write(out))
    except RuntimeError as error:
        faults.append(f"{figure.name}: {error}")
sys.exit("\n".join(faults) or None)
