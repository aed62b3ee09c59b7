"""Conditional rendering: what the app has open, by its own calls, for GL does not tell.

While the app's draws depend on a query, ours must not: it is lifted for them, and set again.
"""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import dataclass

from glshim.driver import errorflag
from glshim.driver.ask import integer
from glshim.driver.functions import gl
from glshim.driver.unnoticed import Unnoticed
from glshim.spec.constants import (
    GL_QUERY_BUFFER,
    GL_QUERY_BUFFER_BINDING,
    GL_QUERY_BY_REGION_NO_WAIT,
    GL_QUERY_BY_REGION_NO_WAIT_INVERTED,
    GL_QUERY_BY_REGION_WAIT_INVERTED,
    GL_QUERY_NO_WAIT,
    GL_QUERY_NO_WAIT_INVERTED,
    GL_QUERY_RESULT,
    GL_QUERY_RESULT_AVAILABLE,
    GL_QUERY_WAIT_INVERTED,
)

_INVERTED = frozenset((
    GL_QUERY_WAIT_INVERTED, GL_QUERY_NO_WAIT_INVERTED, GL_QUERY_BY_REGION_WAIT_INVERTED,
    GL_QUERY_BY_REGION_NO_WAIT_INVERTED,
))  # fmt: skip
"""Modes that draw where the query found nothing."""
_NOT_WAITING = frozenset((
    GL_QUERY_NO_WAIT, GL_QUERY_BY_REGION_NO_WAIT, GL_QUERY_NO_WAIT_INVERTED,
    GL_QUERY_BY_REGION_NO_WAIT_INVERTED,
))  # fmt: skip
"""Modes that draw while the result is not there."""


@dataclass(slots=True)
class _Open:
    query: int
    mode: int
    discards: bool | None = None
    """Whether the app's draws leave nothing, once that is known."""


class Condition:
    """Of one context."""

    def __init__(self) -> None:
        self._open: _Open | None = None
        self._followed = True

    def opened(self, query: int, mode: int) -> None:
        """The app has called for one. Whether the driver took it shows when it is set again: the
        call may have failed in silence."""
        if self._open is not None or not self._followed:  # an open one stays
            return
        with Unnoticed():
            gl.glEndConditionalRender()
            if errorflag.taken():
                return
            gl.glBeginConditionalRender(query, mode)
            if not errorflag.taken():
                self._open = _Open(query, mode)

    def closed(self) -> None:
        """The app has called for its end."""
        self._open = None

    def lose(self) -> None:
        """From now on it may be opened and closed unseen, by a display list: it is never lifted."""
        self._open, self._followed = None, False

    @property
    def discards(self) -> bool:
        """Whether the app's draws leave nothing now."""
        found = self._open
        if found is None:
            return False
        if found.discards is None:
            found.discards = _discards(found)
        return bool(found.discards)

    def lifted(self) -> AbstractContextManager[None]:
        """Draws inside depend on nothing."""
        return nullcontext() if self._open is None else self._lift(self._open)

    @contextmanager
    def _lift(self, found: _Open) -> Iterator[None]:
        with Unnoticed():
            lifted = bool(gl.glIsQuery(found.query))  # a name that is gone cannot be set again
            if lifted:
                gl.glEndConditionalRender()
                lifted = not errorflag.taken()
            try:
                yield
            finally:
                if lifted:
                    gl.glBeginConditionalRender(found.query, found.mode)
                else:
                    self._open = None


def _discards(found: _Open) -> bool | None:
    """None: not known yet, and the driver does not wait for it."""
    with Unnoticed():
        bound = integer(GL_QUERY_BUFFER_BINDING)
        if bound:  # answers would go there
            gl.glBindBuffer(GL_QUERY_BUFFER, 0)
        try:
            if found.mode in _NOT_WAITING and not _result(found.query, GL_QUERY_RESULT_AVAILABLE):
                return None
            passed = bool(_result(found.query, GL_QUERY_RESULT))
        finally:
            if bound:
                gl.glBindBuffer(GL_QUERY_BUFFER, bound)
    return passed is (found.mode in _INVERTED)


def _result(query: int, name: int) -> int:
    value = ctypes.c_uint()
    gl.glGetQueryObjectuiv(query, name, ctypes.byref(value))
    return value.value
