"""The table of roles claims every name once, and nothing that draws slips through."""

from __future__ import annotations

import importlib
import pkgutil
import re

import pytest

from glshim.spec import pixels, roles
from glshim.spec.attributes import BY_NAME, NORMALS
from glshim.spec.draws import EVALUATOR_MESHES, RECTANGLES, signature_of
from glshim.spec.matrices import MATRIX_CALLS
from glshim.spec.pixels import PixelRole
from glshim.spec.roles import KNOWN_PASS, ROWS, Role, role_of
from glshim.spec.shapes import ROWS as SHAPES


@pytest.fixture(scope="module")
def names() -> set[str]:
    import OpenGL.raw.GL as package

    found: set[str] = set()
    for module in pkgutil.walk_packages(package.__path__, package.__name__ + "."):
        try:
            namespace = vars(importlib.import_module(module.name))
        except AttributeError:  # two modules of PyOpenGL 3.1.10 name types it does not have
            continue
        found |= {k for k, v in namespace.items() if k.startswith("gl") and hasattr(v, "argNames")}
    assert len(found) > 2500
    return found


TABLES = [ROWS, pixels.ROWS]


@pytest.mark.parametrize("rows", TABLES, ids=["roles", "pixels"])
def test_no_name_is_claimed_twice(names: set[str], rows: tuple[tuple[object, str], ...]) -> None:
    claims = {n: [p for _, p in rows if re.fullmatch(p, n)] for n in names}
    assert {n: c for n, c in claims.items() if len(c) > 1} == {}


@pytest.mark.parametrize("rows", TABLES, ids=["roles", "pixels"])
def test_no_row_is_dead(names: set[str], rows: tuple[tuple[object, str], ...]) -> None:
    dead = [p for _, p in rows if not any(re.fullmatch(p, n) for n in names)]
    assert dead == []


def test_every_role_has_a_row() -> None:
    assert {role for role, _ in ROWS} == set(Role) - {Role.PASS}
    assert {role for role, _ in pixels.ROWS} == set(PixelRole)


def test_shapes_are_claimed_once_and_no_row_is_dead() -> None:
    for home in {home for home, _, _ in SHAPES}:
        known = vars(importlib.import_module(home))
        patterns = [pattern for module, _, pattern in SHAPES if module == home]
        claims = {n: [p for p in patterns if re.fullmatch(p, n)] for n in known}
        assert {n: c for n, c in claims.items() if len(c) > 1} == {}
        assert {p for c in claims.values() for p in c} == set(patterns)


def test_nothing_that_draws_is_passed_unseen(names: set[str]) -> None:
    suspicious = re.compile(
        r"gl(Draw|MultiDraw|Multi|Begin|End|Vertex|Normal|Color|TexCoord|EdgeFlag|Array|Clear|Read"
        r"|Copy(?!Path)|CallL|Rect|Eval|Bitmap|Accum|NewList|Flush|Finish|Blit|BindFrame|Buffer|Map"
        r"|Unmap)\w*"
    )
    harmless = re.compile(
        r"gl(Color(Mask|Material|Table|Sub|Format|Pointer|Fragment)|ColorP|Normal(Pointer|Format"
        r"|Stream)|TexCoord(Pointer|Format)|EdgeFlag(Pointer|Format)|Bind)\w*"
    )
    missed = [
        n for n in sorted(names)
        if role_of(n) is Role.PASS and suspicious.fullmatch(n)
        and not KNOWN_PASS.fullmatch(n) and not harmless.fullmatch(n)
    ]
    assert missed == []


def test_recorded_attributes_have_a_signature_each(names: set[str]) -> None:
    recorded = {n for n in names if role_of(n) is Role.ATTRIBUTE}
    assert {n.removesuffix("v") for n in recorded} == set(BY_NAME)


def test_calls_with_arguments_that_matter_have_a_row_each(names: set[str]) -> None:
    def of(role: Role) -> set[str]:
        return {n for n in names if role_of(n) is role}

    assert of(Role.RECT) == set(RECTANGLES)
    assert of(Role.EVALUATOR_MESH) == set(EVALUATOR_MESHES)
    assert all(signature_of(n).parameters[0] == "mode" for n in of(Role.ARRAY_DRAW))
    assert set(NORMALS) <= of(Role.NORMAL)
    assert set(MATRIX_CALLS) <= of(Role.MATRIX)
    extensions = re.compile(r"\w+(OES|ARB)|gl(Ortho|Frustum)f")
    assert [n for n in of(Role.MATRIX) - set(MATRIX_CALLS) if not extensions.fullmatch(n)] == []
    assert {n for n in names if pixels.pixel_role(n) is PixelRole.RASTER_PLACE} <= set(
        pixels.POSITIONS
    )
    assert {n for n in names if pixels.pixel_role(n) is PixelRole.QUESTION} == set(pixels.ANSWERS)


def test_groups_of_roles_do_not_overlap() -> None:
    told = [roles.POLYGON_DRAWS, roles.OTHER_DRAWS, roles.LIST_BRACKETS, roles.BUFFER_WRITES]
    assert sum(map(len, [*told, roles.INSIDE, roles.IN_LISTS])) == len(
        frozenset().union(*told, roles.INSIDE, roles.IN_LISTS)
    )
    assert not roles.WATCHED & (roles.INSIDE | roles.IN_LISTS)
