"""Nothing outside `glshim.spec` decides by the name of a GL function: that is data there."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ENTRY_POINT = re.compile(r"(gl|glu|gle)[A-Z(\[].*", re.DOTALL)
"""A string that names entry points, or a pattern of such."""
HEARERS = ("bindings", "sources", "running/shots", "pipeline.py")
"""Below `glshim`: what hears calls by their names. Whatever is called a name there is one."""
TESTS_OF_TEXT = {
    "startswith", "endswith", "removeprefix", "removesuffix", "match", "fullmatch", "search",
    "find", "partition", "get",
}  # fmt: skip
ALLOWED = {
    "glshim/bindings/pyopengl/recorder.py": (
        "{'glBegin': partial(begin, checked=True), 'glEnd': end}"
    ),
    "glshim/driver/objects.py": (
        "{'glGenBuffers': _make_buffers, 'glDeleteBuffers': _delete_buffers, "
        "'glCreateProgram': made_program, 'glDeleteProgram': _delete_program}"
    ),
}
"""By file a decision that may be: the hooks of a primitive's brackets, and the functions that
moderngl is given, are named there, once."""


def is_entry_point(node: ast.AST) -> bool:
    if isinstance(node, (ast.Tuple, ast.List, ast.Set)):
        return any(map(is_entry_point, node.elts))
    return (
        isinstance(node, ast.Constant)
        and isinstance(node.value, str)
        and ENTRY_POINT.fullmatch(node.value) is not None
    )


def is_name(node: ast.AST) -> bool:
    return isinstance(node, ast.Name) and node.id == "name"


def looks_into_a_name(node: ast.Compare) -> bool:
    text = isinstance(node.left, ast.Constant) and isinstance(node.left.value, str)
    looks = any(isinstance(op, (ast.In, ast.NotIn)) for op in node.ops)
    return text and looks and is_name(node.comparators[0])


def decisions(source: str, *, hears: bool = True) -> Iterator[str]:
    """Comparisons, tests of text and tables that go by the name of a GL function; hears: whether
    the source hears calls."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Compare):
            sides = [node.left, *node.comparators]
            if any(map(is_entry_point, sides)) or (hears and looks_into_a_name(node)):
                yield ast.unparse(node)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            ends = node.func.attr in ("startswith", "endswith") and is_name(node.func.value)
            known = node.func.attr in TESTS_OF_TEXT and any(map(is_entry_point, node.args))
            if known or (hears and ends):
                yield ast.unparse(node)
        elif isinstance(node, ast.Dict):
            if any(key is not None and is_entry_point(key) for key in node.keys):
                yield ast.unparse(node)
        elif isinstance(node, ast.MatchValue) and is_entry_point(node.value):
            yield ast.unparse(node)


FILES = [p for p in sorted((ROOT / "glshim").rglob("*.py")) if p.parent.name != "spec"]


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(ROOT / "glshim")))
def test_no_decision_by_the_name_of_a_call(path: Path) -> None:
    allowed = ALLOWED.get(str(path.relative_to(ROOT)))
    below = str(path.relative_to(ROOT / "glshim"))
    source = path.read_text(encoding="utf-8")
    found = decisions(source, hears=below.startswith(HEARERS))
    assert [each for each in found if each != allowed] == []


def test_what_is_allowed_is_there() -> None:
    for file, decision in ALLOWED.items():
        assert decision in set(decisions((ROOT / file).read_text(encoding="utf-8")))


@pytest.mark.parametrize(
    "source",
    [
        "name == 'glClear'", "call.name in ('glEnable', 'glDisable')", "'Named' in name",
        "name.startswith('glEval')", "name.endswith('v')", "re.fullmatch('glRect([dfis])v', x)",
        "{'glEvalMesh1': 1}", "settings.get('gluQuadricDrawStyle')", "re.match(r'gl(A|B)', x)",
    ],
)  # fmt: skip
def test_a_decision_is_seen(source: str) -> None:
    assert list(decisions(source)) == [ast.unparse(ast.parse(source))]


@pytest.mark.parametrize(
    "source", ["gl.glClear(1)", "quick('glBegin')", "f'glUniform{kind}'", "'global' == name"]
)
def test_calls_of_the_driver_are_none(source: str) -> None:
    assert list(decisions(source)) == []
