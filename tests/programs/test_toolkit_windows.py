"""Windows of toolkits that paint into framebuffer objects of their own: captured, counted, with
lines, and ended cleanly. Toolkits that are not here are left out, and say so."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests import sweep

from .catalog import HERE
from .harness import ROOT
from .sources import LIBRARIES, SourceMissing, unpacked

PYQT5 = (
    ("qt_kinds", "PyQt5", "widget", "samples"),
    ("qt_kinds", "PyQt5", "window"),
    ("qt_kinds", "PyQt5", "old", "samples"),
    ("qml_scenes", "PyQt5", "under"),
    ("qml_scenes", "PyQt5", "item"),
)
"""The binding that comes with a program of Debian's, so that it is nearly always here."""
OTHERS = (
    *(("qt_kinds", binding, kind, "samples") for binding in ("PyQt6", "PySide6")
      for kind in ("widget", "window")),
    *(("qml_scenes", binding, kind) for binding in ("PyQt6", "PySide6")
      for kind in ("under", "item")),
    ("gtk_area", "3"),
    ("gtk_area", "4"),
)  # fmt: skip


def environment(program: tuple[str, ...], display: str) -> dict[str, str]:
    """Skips the test where the program's toolkit is not here."""
    package = program[1] if program[0] != "gtk_area" else "gi"
    paths, libraries = [str(ROOT)], ""
    if find_spec(package) is None:
        if package != "PyQt5":
            pytest.skip(f"this Python has no {package}")
        try:
            paths.append(str(unpacked("PyQt5")))
            libraries = str(unpacked("dxf2gcode") / LIBRARIES["dxf2gcode"])
        except SourceMissing as reason:
            pytest.skip(str(reason))
    kept = {k: v for k, v in os.environ.items() if not k.startswith("GLSHIM")}
    return kept | {
        "DISPLAY": display, "PYTHONPATH": os.pathsep.join(paths), "LD_LIBRARY_PATH": libraries,
        "QT_QPA_PLATFORM": "xcb", "XDG_RUNTIME_DIR": os.environ.get("XDG_RUNTIME_DIR", "/tmp"),
    }  # fmt: skip


@pytest.mark.parametrize("program", (*sweep.some(PYQT5, 2), *OTHERS), ids=" ".join)
def test_a_window_that_paints_once(
    program: tuple[str, ...], display: str, tmp_path: Path
) -> None:
    environ = environment(program, display)
    app, *arguments = program
    seen = []
    for style in ("none", "raskar:ink=#e8641b"):
        out = tmp_path / style[:6]
        done = subprocess.run(
            [sys.executable, str(HERE / "apps" / f"{app}.py"), *arguments], cwd=tmp_path,
            env=environ | {"GLSHIM_STYLE": style, "GLSHIM_FRAMES": "2",
                           "GLSHIM_CAPTURE": str(out / "%d.png")},
            capture_output=True, text=True, timeout=120, check=False,
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        assert "glshim" not in done.stderr
        wanted = {"qt_kinds": "painted True\nexit functions\n"}.get(app, "left\n")
        assert done.stdout.endswith(wanted)
        pictures = [np.array(Image.open(path)) for path in sorted(out.glob("*.png"))]
        assert len(pictures) == 2
        assert len(set(map(bytes, pictures[-1].reshape(-1, 3)))) > 50, "nothing was drawn"
        seen.append(pictures[-1])
    ink = [int((picture == (232, 100, 27)).all(2).sum()) for picture in seen]
    assert ink[0] == 0
    assert ink[1] > 200
