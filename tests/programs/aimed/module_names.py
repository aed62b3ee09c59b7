"""A program's own modules, found on a path that it adds later, called as folders of ours are."""

import sys
import tempfile
from pathlib import Path

import window

folder = Path(tempfile.mkdtemp())
sys.path.insert(0, str(folder))
window.swap()
for name in ("stylers", "demo_apps", "tests", "docs", "glshim_style"):
    (folder / f"{name}.py").write_text("def paint():\n    return 'mine'\n")
    print(name, __import__(name).paint())
