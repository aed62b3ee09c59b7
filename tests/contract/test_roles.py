"""The table of roles claims every name once, and nothing that draws slips through."""

from __future__ import annotations

import importlib
import pkgutil
import re

import pytest

from glshim.spec.attributes import BY_NAME
from glshim.spec.roles import KNOWN_PASS, ROWS, Role, role_of


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


def test_no_name_is_claimed_twice(names: set[str]) -> None:
    claims = {n: [p for _, p in ROWS if re.fullmatch(p, n)] for n in names}
    assert {n: c for n, c in claims.items() if len(c) > 1} == {}


def test_no_row_is_dead(names: set[str]) -> None:
    dead = [p for _, p in ROWS if not any(re.fullmatch(p, n) for n in names)]
    assert dead == []


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
