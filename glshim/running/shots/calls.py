"""The GL calls that mean something else while a tile is drawn: what speaks of pixels of the window
is said to the driver in pixels of the tile, and answered in those of the window.

They stand below every other hook (`RawLayer.hook_below`), so that all that the shim itself reads
from the driver is of the tile.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any, Protocol

import numpy as np

from glshim.bindings.pyopengl.raw import Call
from glshim.driver.ask import integer, reals
from glshim.driver.context import compiles_a_list
from glshim.driver.functions import gl
from glshim.notices import say_once
from glshim.running.shots import bitmaps
from glshim.running.shots.mapping import Mapping
from glshim.running.shots.target import Target
from glshim.spec.constants import (
    GL_ALIASED_LINE_WIDTH_RANGE,
    GL_COLOR_ATTACHMENT0,
    GL_CURRENT_RASTER_POSITION,
    GL_DOUBLEBUFFER,
    GL_DRAW_BUFFER,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_FRAMEBUFFER,
    GL_LINE_STIPPLE_PATTERN,
    GL_LINE_STIPPLE_REPEAT,
    GL_LINE_WIDTH,
    GL_POINT_SIZE,
    GL_READ_BUFFER,
    GL_READ_FRAMEBUFFER_BINDING,
    GL_SCISSOR_BOX,
    GL_VIEWPORT,
    GL_ZOOM_X,
    GL_ZOOM_Y,
)
from glshim.spec.pixels import ANSWERS, POSITIONS, PixelRole, Position, pixel_role
from glshim.system import memory

_ZOOM = (GL_ZOOM_X, GL_ZOOM_Y)
_MOST_STIPPLE = 256


class OpenTile(Protocol):
    """A tile being drawn."""

    mapping: Mapping
    target: Target
    home: int
    """The framebuffer that the target stands for."""
    buffers: dict[int, int]
    """What the program thinks glDrawBuffer and glReadBuffer to be, by their names."""
    double: bool


class Calls:
    """Makes the hooks. One a shot."""

    def __init__(
        self,
        current: Callable[[], OpenTile | None],
        ahead: Callable[[], Mapping | None],
        settle: Callable[[], None],
    ) -> None:
        """current: the tile that is drawn in the current context, if one is; ahead: the mapping of
        shots to come, for what goes into display lists before; settle: called before anything that
        may be the first call of a frame."""
        self._current, self._ahead, self._settle = current, ahead, settle
        self._changes: dict[PixelRole, Callable[[Call, Any], Any]] = {
            PixelRole.RECTANGLE: self._rect, PixelRole.LINE_WIDTH: self._line_width,
            PixelRole.POINT_SIZE: self._length, PixelRole.STIPPLE: self._stipple,
            PixelRole.ZOOM: self._zoom, PixelRole.BITMAP: self._bitmap,
            PixelRole.FRAMEBUFFER: self._bind, PixelRole.DRAW_BUFFER: self._draw_buffer,
            PixelRole.READ_BUFFER: self._read_buffer, PixelRole.DRAW_BUFFERS: self._buffers,
            PixelRole.READBACK: self._reading, PixelRole.COPY: self._copy,
            PixelRole.BLIT: self._blit, PixelRole.ACCUMULATION: self._accum,
            PixelRole.FIRST: self._first,
        }  # fmt: skip

    def maker(self, name: str) -> Callable[[Call], Call] | None:
        """The hook for a name, if it has one."""
        role = pixel_role(name)
        if role is None:
            return None
        if role is PixelRole.QUESTION:
            element = _ELEMENTS[ANSWERS[name]]
            return lambda real: lambda *args: self._asked(element, real, args)
        if role is PixelRole.RASTER_PLACE:
            position = POSITIONS[name]
            return lambda real: lambda *args: self._window_place(position, real, args)
        change = self._changes[role]
        return lambda real: lambda *args: change(real, args)

    # -- what is said ----------------------------------------------------------------------------

    def _mapping(self) -> Mapping | None:
        """The mapping for a call that is about the window, None for one about something else."""
        if compiles_a_list():
            return self._ahead()
        self._settle()
        now = self._current()
        if now is None or not now.target.is_drawn_to:
            return None
        return now.mapping

    def _first(self, real: Call, args: Any) -> Any:
        self._settle()
        return real(*args)

    def _rect(self, real: Call, args: Any) -> Any:
        mapping = self._mapping()
        if mapping is None or len(args) != 4:
            return real(*args)
        return real(*mapping.rect([int(a) for a in args]))

    def _length(self, real: Call, args: Any) -> Any:
        mapping = self._mapping()
        if mapping is None or len(args) != 1:
            return real(*args)
        return real(mapping.length(float(args[0])))

    def _line_width(self, real: Call, args: Any) -> Any:
        mapping = self._mapping()
        if mapping is None or len(args) != 1:
            return real(*args)
        width = mapping.length(float(args[0]))
        say_width_limit(width)
        return real(width)

    def _stipple(self, real: Call, args: Any) -> Any:
        mapping = self._mapping()
        if mapping is None or len(args) != 2:
            return real(*args)
        return real(min(round(mapping.length(max(int(args[0]), 1))), _MOST_STIPPLE), args[1])

    def _zoom(self, real: Call, args: Any) -> Any:
        mapping = self._mapping()
        if mapping is None or len(args) != 2:
            return real(*args)
        return real(float(args[0]) * mapping.across, float(args[1]) * mapping.up)

    def _window_place(self, position: Position, real: Call, args: Any) -> Any:
        mapping = self._mapping()
        if mapping is None:
            return real(*args)
        values = args[0] if position.vector else args
        x, y, *z = (float(values[k]) for k in range(position.size))
        gl.glWindowPos3f(*mapping.place(x, y), z[0] if z else 0.0)
        return None

    def _bitmap(self, real: Call, args: Any) -> Any:
        mapping = self._mapping()
        if mapping is None or len(args) != 7:
            return real(*args)
        width, height = int(args[0]), int(args[1])
        origin, move = ((float(args[k]) * mapping.across, float(args[k + 1]) * mapping.up)
                        for k in (2, 4))  # fmt: skip
        bits, address = None, address_of(args[6])
        if width > 0 and height > 0 and address:
            bits = bitmaps.read(width, height, address)
        if bits is None:
            return real(width, height, *origin, *move, args[6])
        bitmaps.draw(bitmaps.magnified(bits, mapping.across, mapping.up), origin, move)
        return None

    # -- where to --------------------------------------------------------------------------------

    def _bind(self, real: Call, args: Any) -> Any:
        self._settle()
        now = self._current()
        if now is None or len(args) != 2:
            return real(*args)
        target, framebuffer = int(args[0]), int(args[1])
        before = now.target.is_drawn_to
        result = real(target, now.target.name if framebuffer == now.home else framebuffer)
        after = now.target.is_drawn_to
        if target in (GL_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER) and before != after:
            convert(now.mapping if before else None, now.mapping if after else None)
        return result

    def _draw_buffer(self, real: Call, args: Any) -> Any:
        self._settle()
        now = self._current()
        ours = now is not None and now.target.is_drawn_to
        return self._buffer(now if ours else None, GL_DRAW_BUFFER, real, args)

    def _read_buffer(self, real: Call, args: Any) -> Any:
        self._settle()
        now = self._current()
        ours = now is not None and now.target.is_read
        return self._buffer(now if ours else None, GL_READ_BUFFER, real, args)

    def _buffer(self, now: OpenTile | None, which: int, real: Call, args: Any) -> Any:
        if now is None or len(args) != 1:
            return real(*args)
        now.buffers[which] = int(args[0])
        return real(_attached(int(args[0])))

    def _buffers(self, real: Call, args: Any) -> Any:
        self._settle()
        now = self._current()
        if now is None or not now.target.is_drawn_to or int(args[0]) != 1:
            return real(*args)
        address = address_of(args[1])
        found = memory.read(address, ctypes.sizeof(ctypes.c_uint))
        if found is None:
            return real(*args)
        asked = int(found.view(np.uint32)[0])
        now.buffers[GL_DRAW_BUFFER] = asked
        gl.glDrawBuffer(_attached(asked))
        return None

    # -- what is read ----------------------------------------------------------------------------

    def _reading(self, real: Call, args: Any) -> Any:
        self._settle()
        now = self._current()
        if now is None or not now.target.is_read:
            return real(*args)
        with now.target.as_window(now.mapping):
            return real(*args)

    def _copy(self, real: Call, args: Any) -> Any:
        mapping = self._mapping()
        if mapping is None or compiles_a_list() or len(args) != 5:
            return real(*args)
        zoom = [reals(each, 1)[0] for each in _ZOOM]
        gl.glPixelZoom(zoom[0] / mapping.across, zoom[1] / mapping.up)
        try:
            return real(*mapping.rect([int(a) for a in args[:4]]), args[4])
        finally:
            gl.glPixelZoom(*zoom)

    def _blit(self, real: Call, args: Any) -> Any:
        self._settle()
        now = self._current()
        if now is None or len(args) != 10:
            return real(*args)
        corners = [int(a) for a in args[:8]]
        for at, ours in ((0, now.target.is_read), (4, now.target.is_drawn_to)):
            if ours:
                for k in (at, at + 2):
                    corners[k : k + 2] = map(round, now.mapping.place(*corners[k : k + 2]))
        return real(*corners, *args[8:])

    def _accum(self, real: Call, args: Any) -> Any:
        self._settle()
        if self._current() is None:
            return real(*args)
        say_once("shots have no accumulation buffer: glAccum is ignored")
        return None

    # -- what is asked ---------------------------------------------------------------------------

    def _asked(self, element: Any, real: Call, args: Any) -> Any:
        result = real(*args)
        now = self._current()
        if now is None or len(args) != 2:
            return result
        name = int(args[0])
        answer = self._answers(now).get(name)
        address = address_of(args[1]) if answer else 0
        if answer and address:
            count, change = answer
            values = (element * count).from_address(address)
            whole = element not in (ctypes.c_float, ctypes.c_double)
            for k, value in enumerate(change(list(values))):
                values[k] = int(value) if whole else value
        return result

    def _answers(
        self, now: OpenTile
    ) -> dict[int, tuple[int, Callable[[list[Any]], Any]]]:
        """By name how many values an answer has, and what they are for the program."""
        found: dict[int, tuple[int, Callable[[list[Any]], Any]]] = {
            binding: (1, lambda v: [now.home if int(v[0]) == now.target.name else v[0]])
            for binding in (GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING)
        }
        drawn_to = now.target.is_drawn_to
        for name, ours in ((GL_DRAW_BUFFER, drawn_to), (GL_READ_BUFFER, now.target.is_read)):
            if name in now.buffers and ours:
                found[name] = (1, lambda v, name=name: [now.buffers[name]])  # type: ignore[misc]
        if not drawn_to:
            return found
        mapping = now.mapping

        def rect(values: list[Any]) -> Any:
            return mapping.rect_back([round(v) for v in values])

        def length(values: list[Any]) -> Any:
            return [mapping.length_back(float(values[0]))]

        found |= {
            GL_VIEWPORT: (4, rect), GL_SCISSOR_BOX: (4, rect),
            GL_LINE_WIDTH: (1, length), GL_POINT_SIZE: (1, length),
            GL_LINE_STIPPLE_REPEAT: (1, lambda v: [max(round(v[0] / mapping.scale), 1)]),
            _ZOOM[0]: (1, lambda v: [v[0] / mapping.across]),
            _ZOOM[1]: (1, lambda v: [v[0] / mapping.up]),
            GL_CURRENT_RASTER_POSITION: (4, lambda v: [*mapping.place_back(v[0], v[1]), *v[2:]]),
            GL_DOUBLEBUFFER: (1, lambda v: [int(now.double)]),
        }  # fmt: skip
        return found


_ELEMENTS: dict[str, Any] = {
    "i": ctypes.c_int, "f": ctypes.c_float, "d": ctypes.c_double, "b": ctypes.c_ubyte,
}  # fmt: skip


def convert(before: Mapping | None, after: Mapping | None) -> None:
    """Say the state that is in pixels anew: it was the driver's under one mapping (None: the
    program's own numbers) and shall be under another. The driver's current framebuffer stays."""
    for name, say in ((GL_VIEWPORT, gl.glViewport), (GL_SCISSOR_BOX, gl.glScissor)):
        values = (ctypes.c_int * 4)()
        gl.glGetIntegerv(name, ctypes.addressof(values))
        own = before.rect_back(list(values)) if before else tuple(values)
        say(*(after.rect(own) if after else own))
    for name, say in ((GL_LINE_WIDTH, gl.glLineWidth), (GL_POINT_SIZE, gl.glPointSize)):
        value = reals(name, 1)[0]
        length = before.length_back(value) if before else value
        if after and name == GL_LINE_WIDTH:
            say_width_limit(after.length(length), asked=length != 1.0)
        say(after.length(length) if after else length)
    repeat, pattern = integer(GL_LINE_STIPPLE_REPEAT), integer(GL_LINE_STIPPLE_PATTERN)
    repeat = max(round(repeat / before.scale), 1) if before else repeat
    repeat = min(round(repeat * after.scale), _MOST_STIPPLE) if after else repeat
    gl.glLineStipple(max(repeat, 1), pattern & 0xFFFF)
    x, y = (reals(name, 1)[0] for name in _ZOOM)
    if before:
        x, y = x / before.across, y / before.up
    if after:
        x, y = x * after.across, y * after.up
    gl.glPixelZoom(x, y)


def say_width_limit(width: float, *, asked: bool = True) -> None:
    """Say once when this GL has no lines of a width."""
    most = reals(GL_ALIASED_LINE_WIDTH_RANGE, 2)[1]
    if asked and width > most:
        say_once(f"lines of this driver are at most {most:g} pixels wide: some stay thinner")


def address_of(argument: Any) -> int:
    """Where a pointer-like argument of a raw call points to, 0 for nowhere or unknown."""
    if argument is None or isinstance(argument, int):
        return argument or 0
    if isinstance(argument, bytes):
        return ctypes.cast(ctypes.c_char_p(argument), ctypes.c_void_p).value or 0
    interface = getattr(argument, "ctypes", None)
    if interface is not None:
        return int(interface.data)
    if isinstance(argument, (ctypes.Array, ctypes._SimpleCData)):
        if isinstance(argument, (ctypes.c_void_p, ctypes.c_char_p)):
            return ctypes.cast(argument, ctypes.c_void_p).value or 0
        return ctypes.addressof(argument)
    if isinstance(argument, ctypes._Pointer):
        return ctypes.cast(argument, ctypes.c_void_p).value or 0
    referred = getattr(argument, "_obj", None)  # byref
    return ctypes.addressof(referred) if referred is not None else 0


def _attached(buffer: int) -> int:
    """The target's buffer for one of the window: none stays none."""
    return GL_COLOR_ATTACHMENT0 if buffer else 0
