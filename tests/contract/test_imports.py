"""Modules of a program's own, called as those that glshim imports: neither meets the other's.

The names are computed: all that a shimmed run imports and a plain one does not. The program has a
module of every one of them.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.sweep import some

ROOT = Path(__file__).parents[2]
pytestmark = pytest.mark.programs

STYLE = "watercolour"
"""A style file: it asks for all that can be asked for, pictures and random numbers too."""
DRAW = """
import glfw
from OpenGL import GL

def draw():
    glfw.init()
    glfw.window_hint(glfw.VISIBLE, False)
    window = glfw.create_window(96, 96, "", None, None)
    glfw.make_context_current(window)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glClearColor(1.0, 1.0, 1.0, 1.0)
    for _ in range(2):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glBegin(GL.GL_QUADS)
        for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
            GL.glVertex3f(x, y, 0.0)
        GL.glEnd()
        glfw.swap_buffers(window)
"""
TELL = """
import sys
def tell():
    for name in sys.argv[1].split(","):
        module = __import__(name)
        print(name, getattr(module, "MINE", module), __import__(name) is module)
"""
BEFORE = TELL + "tell()\n" + DRAW + "draw()\ntell()\n"
AFTER = DRAW + TELL + "draw()\ntell()\ndraw()\n"
BETWEEN = TELL + "import OpenGL.GL\ntell()\n" + DRAW + "draw()\n"
LATER = DRAW + TELL + "draw()\nsys.path.insert(0, sys.argv[2])\ntell()\ndraw()\n"
LAST = DRAW + TELL + "draw()\nsys.path.append(sys.argv[2])\ntell()\ndraw()\n"


def run(
    python: str, folder: Path, program: str, *arguments: str, flags: tuple[str, ...] = (),
    **variables: str,
) -> subprocess.CompletedProcess[str]:  # fmt: skip
    (folder / "program.py").write_text(program)
    environ = {name: text for name, text in os.environ.items() if not name.startswith("GLSHIM_")}
    command = [python, *flags, str(folder / "program.py"), *arguments]
    return subprocess.run(
        command, env=environ | variables, cwd=folder, capture_output=True, text=True, timeout=120,
        check=False,
    )  # fmt: skip


@pytest.fixture(scope="module")
def names(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """The first names of what glshim imports, and the plain run does not."""
    folder = tmp_path_factory.mktemp("names")

    def imported(**variables: str) -> set[str]:
        done = run(
            sys.executable, folder, DRAW + "draw()", flags=("-X", "importtime"), **variables
        )
        assert done.returncode == 0, done.stderr
        return set(re.findall(r"\|\s+([\w]+)[\w.]*$", done.stderr, re.MULTILINE))

    ours = imported(GLSHIM_STYLE=STYLE, GLSHIM_KEYS="on", GLSHIM_CAPTURE=str(folder / "%d.png"))
    found = ours - imported() - set(sys.builtin_module_names) - {"ntpath"}  # which is frozen
    assert {"glshim", "glshim_stylers", "numpy", "moderngl", "PIL", "email", "inspect"} <= found
    return sorted(found | {"stylers", "demo_apps", "glshim_demos", "tests", "scripts", "docs"})


@pytest.fixture(scope="module")
def wheel_python(tmp_path_factory: pytest.TempPathFactory) -> str:
    """An interpreter with our wheel in its environment."""
    folder = tmp_path_factory.mktemp("wheel")
    code = (
        "import sys; sys.path.insert(0, 'scripts'); import build_backend; "
        "build_backend.build_wheel(sys.argv[1])"
    )
    subprocess.run(["cp", "-r", *(str(ROOT / name) for name in (
        "glshim", "stylers", "demo_apps", "scripts", "pyproject.toml", "README.md", "MANIFEST.in",
        "LICENSE", "_glshim_start.py", "glshim.pth", "glshim.start")), str(folder)],
        check=True)  # fmt: skip
    hook = [sys.executable, "-c", code, str(folder)]
    subprocess.run(hook, cwd=folder, check=True, capture_output=True)
    venv.create(folder / "venv", with_pip=False)
    python = folder / "venv" / "bin" / "python"
    asked = [str(python), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
    packages = subprocess.run(asked, capture_output=True, text=True, check=True).stdout.strip()
    (wheel,) = folder.glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(packages)
    # What it depends on; start-up files there are not read.
    Path(packages, "others.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return str(python)


@pytest.fixture(scope="module")
def styled(tmp_path_factory: pytest.TempPathFactory) -> np.ndarray:
    """The picture of a program without such modules."""
    folder = tmp_path_factory.mktemp("styled")
    for name, variables in (("plain", {}), ("styled", {"GLSHIM_STYLE": STYLE})):
        capture = {"GLSHIM_CAPTURE": str(folder / f"{name}-%d.png")}
        assert run(sys.executable, folder, DRAW + "draw()", **capture, **variables).returncode == 0
    plain, found = (np.asarray(Image.open(folder / f"{n}-2.png")) for n in ("plain", "styled"))
    assert (plain != found).any()
    return found


CASES = [
    (form, name) for name in ("BEFORE", "LATER", "BETWEEN", "AFTER", "LAST")
    for form in ("editable", "wheel")
]  # fmt: skip


@pytest.mark.parametrize(("form", "when"), some(CASES, 2))
def test_a_program_with_modules_of_every_name_runs_as_plain_and_is_styled(
    form: str, when: str, names: list[str], tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    python = sys.executable if form == "editable" else request.getfixturevalue("wheel_python")
    styled = request.getfixturevalue("styled")
    program = globals()[when]
    folder = tmp_path / "later" if when in ("LATER", "LAST") else tmp_path
    folder.mkdir(exist_ok=True)
    asked = names
    if program is LAST:  # what Python has at hand comes first there
        asked = ["stylers", "demo_apps", "tests", "scripts", "docs"]
    for name in asked:
        (folder / f"{name}.py").write_text(f"MINE = 'the program\\'s {name}'\n")
    arguments = (",".join(asked), str(folder))
    plain = run(python, tmp_path, program, *arguments)
    assert plain.returncode == 0, plain.stderr
    assert plain.stdout.count("the program's") >= len(asked)
    capture = str(tmp_path / "%d.png")
    done = run(
        python, tmp_path, program, *arguments, GLSHIM_STYLE=STYLE, GLSHIM_CAPTURE=capture,
        GLSHIM_KEYS="on",
    )  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (0, plain.stdout, plain.stderr)
    assert np.array_equal(np.asarray(Image.open(tmp_path / "2.png")), styled)


SAME = """
import sys, OpenGL.GL
shown = sorted(name for name in sys.modules if "." not in name)
ours = sys.modules["glshim.model.arrays"], sys.modules["glshim.styling.options"]
import numpy, dataclasses, importlib.util
assert importlib.util.find_spec("numpy").origin == numpy.__file__
assert (numpy, dataclasses.dataclass) == (ours[0].np, ours[1].dataclass)
assert numpy.__spec__.loader is numpy.__loader__ and sys.modules["numpy"] is numpy
assert "inspect" in sys.modules  # which dataclasses imports
asking = vars(sys.modules["glshim.styling.registry"])
assert eval("find_spec('no_such_module')", asking) is None  # asked by code of ours
import glshim
from glshim.bindings.imports import after_import
after_import("wave", lambda module: setattr(module, "hooked", True))
eval("exec('import wave')", asking)  # both finders have to do with it
assert asking["wave"].hooked
import wave
assert wave is asking["wave"]
assert glshim.Option is ours[1].Option and glshim.uninstall() is None
print(*shown)
"""


def test_where_both_mean_the_same_file_there_is_one_module(tmp_path: Path) -> None:
    done = run(sys.executable, tmp_path, SAME, GLSHIM_STYLE=STYLE)
    assert (done.returncode, done.stderr) == (0, "")
    plain = run(sys.executable, tmp_path, SAME.partition("ours =")[0] + "print(*shown)")
    more = set(done.stdout.split()) - set(plain.stdout.split())
    more = {name for name in more if not name.startswith("_cython_")}
    assert more <= {"_ast", "cython_runtime", "ntpath"}  # which lie in no folder


def test_a_style_file_may_import_what_lies_in_the_programs_folder(tmp_path: Path) -> None:
    (tmp_path / "colours.py").write_text("INK = (1.0, 0.0, 0.0)")
    (tmp_path / "queue.py").write_text("raise SystemExit('not this one')")
    (tmp_path / "mine.py").write_text(
        "import queue\nfrom dataclasses import dataclass\nfrom typing import ClassVar\n"
        "from colours import INK\nfrom glshim import Styler\n"
        "@dataclass(frozen=True)\nclass Mine(Styler):\n    name: ClassVar[str] = 'mine'\n"
        "    def draws(self, layer):\n        print(INK, queue.Queue.__name__)\n        return ()\n"
    )
    done = run(sys.executable, tmp_path, DRAW + "draw()", GLSHIM_STYLE="mine.py:Mine")
    assert done.returncode == 0 and "the style adds nothing" in done.stderr
    assert done.stdout == "(1.0, 0.0, 0.0) Queue\n" * 2


def test_glshim_found_in_another_way_is_the_same(tmp_path: Path) -> None:
    (tmp_path / "glshim").symlink_to(ROOT / "glshim")  # another file, by its name
    code = (
        "import sys; before = sys.modules['glshim.system.modules']\n"
        "import glshim, OpenGL.GL\nfrom glshim.styling import registry\n"
        "assert registry.OURS_ALONE is before.OURS_ALONE\n"
        "assert registry.load('crease').name == 'crease'"
    )
    for folder in (tmp_path, ROOT):
        done = subprocess.run(
            [sys.executable, "-c", code], cwd=folder, env={**os.environ, "GLSHIM_STYLE": "crease"},
            capture_output=True, text=True, timeout=60, check=False,
        )  # fmt: skip
        assert (done.returncode, done.stderr) == (0, "")
