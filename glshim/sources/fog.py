"""The app's fog, read from the driver."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import partial

from glshim.driver.ask import integer, real, reals
from glshim.driver.functions import quick
from glshim.model.fog import Fog, FogMode
from glshim.spec.constants import (
    GL_EXP,
    GL_EXP2,
    GL_FOG_COLOR,
    GL_FOG_COORD,
    GL_FOG_COORD_SRC,
    GL_FOG_DENSITY,
    GL_FOG_END,
    GL_FOG_MODE,
    GL_FOG_START,
    GL_LINEAR,
)

_MODES = {GL_LINEAR: FogMode.LINEAR, GL_EXP: FogMode.EXP, GL_EXP2: FogMode.EXP2}
_WHAT = (
    (GL_FOG_COLOR, 4), (GL_FOG_DENSITY, 1), (GL_FOG_START, 1), (GL_FOG_END, 1), (GL_FOG_MODE, 1),
    (GL_FOG_COORD_SRC, 1),
)  # fmt: skip


def fog() -> Fog | None:
    """As the driver holds it now; None where the app says the depth of fog vertex by vertex."""
    mode = _MODES.get(integer(GL_FOG_MODE))
    if mode is None or integer(GL_FOG_COORD_SRC) == GL_FOG_COORD:
        return None
    red, green, blue, _ = reals(GL_FOG_COLOR, 4)
    return Fog(
        mode, (red, green, blue), real(GL_FOG_DENSITY), real(GL_FOG_START), real(GL_FOG_END)
    )


class FogReader:
    """Tells draws apart by the fog that lies over them."""

    def __init__(self) -> None:
        self._values = (ctypes.c_float * sum(count for _, count in _WHAT))()
        self._calls: list[Callable[[], None]] = []

    def read(self) -> bytes:
        """Equal for equal ones."""
        for get in self._calls or self._prepare():
            get()
        return bytes(self._values)

    def _prepare(self) -> list[Callable[[], None]]:
        floats, at = quick("glGetFloatv"), ctypes.addressof(self._values)
        for name, count in _WHAT:
            self._calls.append(partial(floats, name, ctypes.c_void_p(at)))
            at += 4 * count
        return self._calls
