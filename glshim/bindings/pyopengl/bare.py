"""Functions of the driver's that the program takes bare: by ``ctypes`` from a library.

Nobody sees their calls. What PyOpenGL is told between glBegin and glEnd must not fall behind them:
from the first such function on nothing is held back any more.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

from glshim.bindings.pyopengl.record import Record
from glshim.spec.roles import INSIDE, LIST_CALLS, Role, role_of

_ORDERED = INSIDE | LIST_CALLS | {Role.BEGIN, Role.END, Role.ATTRIBUTE, Role.RENDER_MODE}
"""What may be called inside a primitive, or makes the driver write memory there."""


def watch(record: Record) -> Callable[[], None]:
    """Have a record stand aside when such a function is taken; gives what ends the watch."""
    from OpenGL.platform import PLATFORM

    if any(map(_is_ordered, vars(PLATFORM.GL))):
        record.stand_aside()
    found = ctypes.CDLL.__getitem__

    def __getitem__(self: Any, name_or_ordinal: Any) -> Any:
        if _is_ordered(name_or_ordinal):
            record.stand_aside()
        return found(self, name_or_ordinal)

    ctypes.CDLL.__getitem__ = __getitem__  # type: ignore[method-assign]

    def end() -> None:
        if ctypes.CDLL.__getitem__ is __getitem__:
            ctypes.CDLL.__getitem__ = found  # type: ignore[method-assign]

    return end


def _is_ordered(name: Any) -> bool:
    return isinstance(name, str) and role_of(name) in _ORDERED
