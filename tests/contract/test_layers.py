"""The rooms: who may import whom, how long a file may be, and that demos know nothing of glshim."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LONGEST = 420
"""About 400 lines: past that a file holds two things."""

# What each room may import of glshim besides itself. A name stands for the module and all below.
COMMON = ("glshim.errors", "glshim.notices", "glshim.caches", "glshim.spec")
ROOMS = {
    "glshim/spec": (),
    "glshim/capture": ("glshim.geometry.camera", "glshim.geometry.lights"),
    "glshim/assembly": ("glshim.capture.state", "glshim.geometry"),
    "glshim/following": ("glshim.capture", "glshim.assembly"),
    "glshim/geometry": ("glshim.assembly.batch",),
    "glshim/styling": ("glshim.assembly.batch", "glshim.geometry"),
    "glshim/render": ("glshim.styling.protocol", "glshim.styling.pictures.Image",
                      "glshim.styling.passes", "glshim.assembly.batch", "glshim.geometry"),
    "stylers": ("glshim.styling", "glshim.assembly.batch", "glshim.geometry"),
}
# The one way in from start-up; it loads the composition when PyOpenGL comes.
EXCEPTIONS = {
    ("glshim/capture/startup.py", "glshim.session"),
    ("glshim/capture/startup.py", "glshim.stillness"),
}


def imports(path: Path) -> Iterator[str]:
    """Every module that a file imports, with the names taken from it."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = "." * node.level + (node.module or "")
            if node.level:
                package = path.relative_to(ROOT).parts[: -node.level]
                base = ".".join([*package, *([node.module] if node.module else [])])
            yield from (f"{base}.{alias.name}" for alias in node.names)


def is_below(module: str, room: str) -> bool:
    return module == room or module.startswith(room + ".")


def sources(*folders: str) -> list[Path]:
    return sorted(path for folder in folders for path in (ROOT / folder).rglob("*.py"))


@pytest.mark.parametrize("room", ROOMS)
def test_a_stage_sees_only_what_comes_before_it(room: str) -> None:
    own = room.replace("/", ".")
    allowed = (own, *COMMON, *ROOMS[room])
    strangers = [
        f"{name}: {module}"
        for path in sources(room)
        for name in [str(path.relative_to(ROOT))]
        for module in imports(path)
        if module.partition(".")[0] in ("glshim", "stylers", "demo_apps", "tests")
        and not any(is_below(module, part) for part in allowed)
        and (name, module) not in EXCEPTIONS
    ]
    assert strangers == []


@pytest.mark.parametrize("room", ["glshim/geometry", "glshim/styling", "stylers"])
def test_formulas_and_stylers_know_no_gl(room: str) -> None:
    found = [
        f"{path.relative_to(ROOT)}: {module}"
        for path in sources(room)
        for module in imports(path)
        if module.partition(".")[0] in ("OpenGL", "moderngl", "glfw", "pygame", "ctypes")
        or is_below(module, "glshim.spec.driver")
    ]
    assert found == []


def test_demo_apps_are_ordinary_programs() -> None:
    found = [
        f"{path.name}: {module}"
        for path in sources("demo_apps")
        for module in imports(path)
        if "glshim" in module or "stylers" in module
    ]
    assert found == []


@pytest.mark.parametrize("path", sources("glshim", "stylers", "demo_apps"), ids=str)
def test_a_file_is_short_enough_to_read(path: Path) -> None:
    lines = len(path.read_text(encoding="utf-8").splitlines())
    assert lines <= LONGEST


def test_the_reader_of_imports_sees_every_form(tmp_path: Path) -> None:
    path = ROOT / "glshim" / "capture" / "frames.py"
    assert "glshim.capture.imports.after_import" in set(imports(path))
    assert "glshim.capture.toolkits.TOOLKITS" in set(imports(path))  # inside a function
