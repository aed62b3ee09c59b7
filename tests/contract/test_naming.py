"""Calls with names of programs and shaders among their arguments: PyOpenGL's own argument names
say which those are."""

from __future__ import annotations

import pkgutil
import re
import warnings
from importlib import import_module

import pytest

from glshim.spec import naming

pytestmark = pytest.mark.gl  # modules of PyOpenGL's ask for a context

CALLED = {"program", "programObj", "shader", "shaderObj", "containerObj", "obj", "attachedObj"}
OTHERS = ("NamedProgram", "glBindProgramARB", "glIsProgramARB", "glLoadProgramNV",
          "glGetProgramStringNV")  # fmt: skip
"""Programs in assembly language, which have names of their own."""


@pytest.fixture(scope="module")
def arguments() -> dict[str, tuple[str, ...]]:
    """Names of arguments by entry point, of all that PyOpenGL knows."""
    import OpenGL.raw.GL

    found: dict[str, tuple[str, ...]] = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for module in pkgutil.walk_packages(OpenGL.raw.GL.__path__, "OpenGL.raw.GL."):
            try:
                known = import_module(module.name)
            except AttributeError:  # some of its extensions cannot be imported
                continue
            for name, value in vars(known).items():
                names = getattr(value, "argNames", None)
                if name.startswith("gl") and names is not None:
                    found[name] = tuple(names)
    assert len(found) > 2500
    return found


def test_places_are_those_that_pyopengl_names(arguments: dict[str, tuple[str, ...]]) -> None:
    for name, known in arguments.items():
        row = naming.row_of_names(name) or ()
        expected = tuple(at for at, each in enumerate(known) if each in CALLED and at not in row)
        if any(other in name for other in OTHERS):
            expected = ()
        assert (name, naming.places_of(name)) == (name, expected)


def test_every_row_has_calls(arguments: dict[str, tuple[str, ...]]) -> None:
    patterns = [row.pattern for row in naming.ROWS] + [pattern for _, pattern in naming.PLACES]
    patterns += [naming.MAKERS, naming.RETURNS, naming.LABELS, *naming.ROWS_OF_NAMES]
    for pattern in patterns:
        for part in pattern.split("|") if "(" not in pattern else [pattern]:
            assert any(re.fullmatch(part, name) for name in arguments), part
    assert {*naming.ANSWERS} <= {*arguments}


def test_positions_are_those_of_the_names(arguments: dict[str, tuple[str, ...]]) -> None:
    for name, known in arguments.items():
        row = naming.row_of(name)
        if row is None:
            continue
        if row.naming is naming.Naming.MEETS:
            assert known[row.position] == row.kind.singular.lower(), name
        else:
            assert known[row.position] == "n", name
            assert known[row.position + 1].endswith(row.kind.plural.lower()), name
