"""Queries of the program that are open: what we draw while one counts would be in its result, and
GL cannot pause them. Times are no such counts."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import cache, partial
from typing import Any

from glshim.driver import errorflag
from glshim.driver.context import version, version_text
from glshim.driver.functions import quick
from glshim.driver.unnoticed import Unnoticed
from glshim.spec.constants import (
    GL_ANY_SAMPLES_PASSED,
    GL_ANY_SAMPLES_PASSED_CONSERVATIVE,
    GL_CLIPPING_INPUT_PRIMITIVES_ARB,
    GL_CLIPPING_OUTPUT_PRIMITIVES_ARB,
    GL_CURRENT_QUERY,
    GL_FRAGMENT_SHADER_INVOCATIONS_ARB,
    GL_GEOMETRY_SHADER_INVOCATIONS,
    GL_GEOMETRY_SHADER_PRIMITIVES_EMITTED_ARB,
    GL_PRIMITIVES_GENERATED,
    GL_PRIMITIVES_SUBMITTED_ARB,
    GL_SAMPLES_PASSED,
    GL_VERTEX_SHADER_INVOCATIONS_ARB,
    GL_VERTICES_SUBMITTED_ARB,
)
from glshim.system.interrupts import at_once

_TARGETS = (
    GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE,
    GL_PRIMITIVES_GENERATED, GL_VERTICES_SUBMITTED_ARB, GL_PRIMITIVES_SUBMITTED_ARB,
    GL_VERTEX_SHADER_INVOCATIONS_ARB, GL_GEOMETRY_SHADER_INVOCATIONS,
    GL_GEOMETRY_SHADER_PRIMITIVES_EMITTED_ARB, GL_FRAGMENT_SHADER_INVOCATIONS_ARB,
    GL_CLIPPING_INPUT_PRIMITIVES_ARB, GL_CLIPPING_OUTPUT_PRIMITIVES_ARB,
)  # fmt: skip
"""What drawing of ours would change. We tessellate and compute nothing, draw in vertex stream 0 and
pause transform feedback: queries of those count as they do without us."""
_FIRST = (1, 5)
"""Version that has queries."""
UNCOUNTED = "layers that end while a query of the program's counts what is drawn"
"""What goes without lines, in words."""



def counting() -> bool:
    """Whether a query is open in the current context that would count what we draw. Outside
    primitives."""
    questions, names = _asked(version_text())
    at_once(questions)
    return any(names)


_begun = False


def begin_seen() -> None:
    """A query of the program's was seen to begin, in whatever context."""
    global _begun
    _begun = True


def counting_if_seen() -> bool:
    """`counting`, for paths where a question each time costs too much: asks only once a query was
    seen to begin."""
    return _begun and counting()


@cache
def _asked(told: str) -> tuple[tuple[Callable[[], Any], ...], Any]:
    """Questions for the names of open queries, of the targets that a version has, and where the
    answers are."""
    names = (ctypes.c_int * len(_TARGETS))()
    if (version() or (0, 0)) < _FIRST:
        return (), names
    ask, questions = quick("glGetQueryiv"), []
    with Unnoticed():
        for at, target in enumerate(_TARGETS):
            place = ctypes.c_void_p(ctypes.addressof(names) + at * ctypes.sizeof(ctypes.c_int))
            question = partial(ask, target, GL_CURRENT_QUERY, place)
            question()
            if not errorflag.taken():
                questions.append(question)
    return tuple(questions), names
