"""The rooms: who may import whom, how long a file may be, and that demos know nothing of glshim."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import glshim

ROOT = Path(__file__).parents[2]
LONGEST = 420
"""About 400 lines: past that a file holds two things."""
GENERATED = ("glshim/spec/constants.py",)
"""Lists that scripts write, and that nobody reads from top to bottom."""

EVERYWHERE = ("glshim.errors", "glshim.system.interrupts", "glshim.notices")
"""Modules that every room may import."""
ROOMS = {
    "system": (),
    "model": (),
    "spec": (),
    "driver": ("system", "spec"),
    "bindings": ("system", "model", "spec", "driver"),
    "toolkits": ("system", "spec", "driver", "bindings"),
    "sources": ("system", "model", "spec", "driver", "bindings"),
    "geometry": ("model",),
    "styling": ("system", "model", "geometry"),
    "linework": ("model", "geometry", "styling"),
    "outputs": ("system", "model", "spec", "driver", "geometry", "styling", "linework"),
    "pipeline": (
        "system", "model", "spec", "driver", "bindings", "toolkits", "sources", "styling",
        "outputs",
    ),
    "control": ("system", "model", "styling", "toolkits", "outputs", "pipeline"),
    "running": (
        "system", "model", "spec", "driver", "bindings", "toolkits", "styling", "outputs",
        "pipeline", "control",
    ),
    "checks": ("model", "spec", "driver", "geometry", "styling", "outputs", "pipeline", "running"),
    "commands": ("system", "spec", "driver", "toolkits", "styling", "control", "running", "checks"),
}  # fmt: skip
"""What each room may import besides itself, in the order of the flow."""
OURS = ("glshim", "stylers", "demo_apps")
INSTALLED_AS = ("glshim_stylers", "glshim_demos")
"""What `stylers` and `demo_apps` are called once installed. Inside they import relatively, so that
they do not depend on it."""
TOP = {"__init__.py", "__main__.py", "errors.py", "notices.py", "pipeline.py"}
"""All that lies at the top: public names, the way to the command line, and the composition root."""


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


def of_room(room: str) -> list[Path]:
    folder = ROOT / "glshim" / room
    return sources(f"glshim/{room}") if folder.is_dir() else [folder.with_suffix(".py")]


def strangers(paths: list[Path], allowed: tuple[str, ...]) -> list[str]:
    """What files import of ours besides the modules allowed and all below them."""
    return [
        f"{path.relative_to(ROOT)}: {module}"
        for path in paths
        for module in imports(path)
        if module.partition(".")[0] in (*OURS, *INSTALLED_AS, "tests")
        and not any(is_below(module, part) for part in allowed)
    ]


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_sees_only_what_comes_before_it(room: str) -> None:
    before = list(ROOMS)[: list(ROOMS).index(room)]
    assert set(ROOMS[room]) <= set(before)
    allowed = (*EVERYWHERE, *(f"glshim.{name}" for name in (room, *ROOMS[room])))
    assert strangers(of_room(room), allowed) == []


def test_errors_files_and_notices_import_nothing_of_ours() -> None:
    paths = [ROOT / "glshim" / name for name in ("errors.py", "notices.py")]
    assert strangers(paths, ("glshim.errors",)) == []


def test_stylers_see_values_formulas_and_the_protocol() -> None:
    allowed = ("stylers", "glshim.model", "glshim.geometry", "glshim.styling", *EVERYWHERE)
    assert strangers(sources("stylers"), allowed) == []


def test_what_stylers_import_others_can_import_from_the_top() -> None:
    """Stylers of ours have nothing that somebody else's cannot have."""
    names = {
        name
        for path in sources("stylers")
        for name in imports(path)
        if name.startswith("glshim.") and name not in EVERYWHERE
    }
    assert len(names) > 40
    private = [name for name in names if name.rpartition(".")[2] not in glshim.__all__]
    assert private == []  # a row of `_HOMES` in glshim/__init__.py, and docs/reference/api.md


def test_references_of_shaders_are_for_tests_alone() -> None:
    room = "glshim.geometry.references"
    shipped = sources(*OURS)
    users = [path for path in shipped if any(is_below(name, room) for name in imports(path))]
    assert [path for path in users if path.parent.name != "references"] == []


def test_every_folder_is_a_room() -> None:
    folders = {p.name for p in (ROOT / "glshim").iterdir() if any(p.rglob("*.py"))}
    assert folders - {"__pycache__"} <= {*ROOMS}
    assert {p.name for p in (ROOT / "glshim").glob("*.py")} == TOP


def module_of(name: str) -> str | None:
    """The file of ours that an imported name lies in, as a dotted name."""
    parts = name.split(".")
    while parts:
        path = ROOT.joinpath(*parts)
        if path.with_suffix(".py").is_file() or (path / "__init__.py").is_file():
            return ".".join(parts)
        parts.pop()
    return None


def arrows(depth: int) -> dict[str, set[str]]:
    """Which folder imports from which, cut off at a depth; a file counts with its folder."""
    found: dict[str, set[str]] = {}
    for path in sources("glshim", "stylers"):
        room = ".".join(path.relative_to(ROOT).parent.parts[:depth])
        for name in imports(path):
            module = module_of(name)
            if module is None or module.partition(".")[0] not in ("glshim", "stylers"):
                continue
            file = ROOT.joinpath(*module.split("."))
            parts = module.split(".") if file.is_dir() else module.split(".")[:-1]
            other = ".".join(parts[:depth])
            if other != room:
                found.setdefault(room, set()).add(other)
    return found


def circles(graph: dict[str, set[str]]) -> list[list[str]]:
    """Ways that come back to where they began, one for each arrow that closes one."""
    found: list[list[str]] = []
    done: set[str] = set()

    def walk(at: str, way: list[str]) -> None:
        for following in sorted(graph.get(at, ())):
            if following in way:
                found.append([*way[way.index(following) :], following])
            elif following not in done:
                walk(following, [*way, following])
        done.add(at)

    for room in sorted(graph):
        if room not in done:
            walk(room, [room])
    return found


@pytest.mark.parametrize("depth", [3, 4])
def test_no_circle_of_folders(depth: int) -> None:
    # The package itself holds the public names and the composition root: not a room.
    graph = {room: others - {"glshim"} for room, others in arrows(depth).items()}
    graph.pop("glshim", None)
    assert circles(graph) == []


def test_no_circle_of_files() -> None:
    graph: dict[str, set[str]] = {}
    for path in sources("glshim", "stylers"):
        name = ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
        found = {module_of(each) for each in imports(path)}
        graph[name] = {
            each
            for each in found
            if each and each != name and each.partition(".")[0] in ("glshim", "stylers")
        }
    assert circles({name: others - {"glshim"} for name, others in graph.items()}) == []


@pytest.mark.parametrize("room", ["glshim/model", "glshim/geometry", "glshim/styling", "stylers"])
def test_formulas_and_stylers_know_no_gl(room: str) -> None:
    found = [
        f"{path.relative_to(ROOT)}: {module}"
        for path in sources(room)
        for module in imports(path)
        if module.partition(".")[0] in ("OpenGL", "moderngl", "glfw", "pygame", "ctypes")
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


@pytest.mark.parametrize("path", sources(*OURS), ids=str)
def test_a_file_is_short_enough_to_read(path: Path) -> None:
    lines = len(path.read_text(encoding="utf-8").splitlines())
    assert lines <= LONGEST or str(path.relative_to(ROOT)) in GENERATED


def test_the_reader_of_imports_sees_every_form() -> None:
    path = ROOT / "glshim" / "pipeline.py"
    assert "glshim.sources.following.follower.Follower" in set(imports(path))
    assert "glshim.styling.texts.parse_style" in set(imports(path))  # inside a function


def test_a_circle_is_found() -> None:
    graph = {"a": {"b"}, "b": {"c"}, "c": {"a"}, "d": {"a"}}
    assert circles(graph) == [["a", "b", "c", "a"]]


def _census() -> str:
    """How many rooms there are (folders of ``glshim``, files at its top, ``stylers``), how many
    arrows between them, and how many circles."""

    def room(path: Path) -> str:
        parts = path.relative_to(ROOT).parts
        return parts[0] if parts[0] == "stylers" else "/".join(parts[:2])

    graph: dict[str, set[str]] = {}
    for path in sources("glshim", "stylers"):
        others = graph.setdefault(room(path), set())
        for module in filter(None, map(module_of, imports(path))):
            file = ROOT.joinpath(*module.split("."))
            file = file / "__init__.py" if file.is_dir() else file.with_suffix(".py")
            if module.partition(".")[0] in ("glshim", "stylers"):
                others.add(room(file))
    between = {name: others - {name} for name, others in graph.items()}
    arrows = sum(map(len, between.values()))
    return f"{len(between)} rooms, {arrows} arrows, {len(circles(between))} circles"


if __name__ == "__main__":
    print(_census())
