"""The frame as it is presented, read from the driver and written as PNG; the app's state stays."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glshim.notices import say
from glshim.spec.ask import integer, integers, real
from glshim.spec.driver import gl

if TYPE_CHECKING:
    from PIL.Image import Image

_VIEWPORT, _VERSION, _DOUBLEBUFFER = 0x0BA2, 0x1F02, 0x0C32
_FRAMEBUFFERS = ((0x8CA8, 0x8CAA), (0x8CA9, 0x8CA6))  # read, draw: target and binding
_PIXEL_PACK_BUFFER, _PIXEL_PACK_BUFFER_BINDING = 0x88EB, 0x88ED
_READ_BUFFER, _FRONT, _BACK = 0x0C02, 0x0404, 0x0405
_COLOR_ATTACHMENT, _SAMPLE_BUFFERS = 0x8CE0, 0x80A8
_RGB, _UNSIGNED_BYTE = 0x1907, 0x1401
_CONTEXT_PROFILE_MASK, _CORE_PROFILE = 0x9126, 0x1

_PACKING = (
    (0x0D00, 0),  # GL_PACK_SWAP_BYTES
    (0x0D01, 0),  # GL_PACK_LSB_FIRST
    (0x0D02, 0),  # GL_PACK_ROW_LENGTH
    (0x0D03, 0),  # GL_PACK_SKIP_ROWS
    (0x0D04, 0),  # GL_PACK_SKIP_PIXELS
    (0x0D05, 1),  # GL_PACK_ALIGNMENT
)
_TRANSFER = (
    (0x0D10, 0.0),  # GL_MAP_COLOR
    (0x0D14, 1.0),  # GL_RED_SCALE, GL_RED_BIAS, and so on
    (0x0D15, 0.0),
    (0x0D18, 1.0),
    (0x0D19, 0.0),
    (0x0D1A, 1.0),
    (0x0D1B, 0.0),
)


def grab(size: tuple[int, int] | None = None, framebuffer: int = 0) -> Image:
    """What the current context is about to present; without a size, as much as the viewport.
    Black where the framebuffer is an object with several samples.

    Every GL call here is legal in the context's own version, so no error arises, and one that the
    app has yet to fetch stays where it is.
    """
    from PIL import Image

    if size is None:
        _, _, *extent = integers(_VIEWPORT, 4)
        size = extent[0], extent[1]
    pixels = ctypes.create_string_buffer(size[0] * size[1] * 3)
    with _plain_reading(framebuffer) as readable:
        if readable:
            gl.glReadPixels(0, 0, *size, _RGB, _UNSIGNED_BYTE, pixels)
    return Image.frombytes("RGB", size, pixels.raw, "raw", "RGB", 0, -1)


class FrameWriter:
    """Writes each frame to ``pattern``, whose ``%d`` is the frame's number, from 1."""

    def __init__(
        self,
        pattern: str,
        size: Callable[[], tuple[int, int] | None],
        framebuffer: Callable[[], int] = lambda: 0,
    ) -> None:
        self._pattern = pattern
        self._size = size
        self._framebuffer = framebuffer
        self._number = 0
        self._usable = True

    def write(self) -> None:
        """Write the frame that the current context is about to present."""
        self._number += 1
        if not self._usable:
            return
        size = self._size()
        if size is not None and 0 in size:  # a minimised window has no picture
            return
        path = Path(self._numbered())
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            grab(size, self._framebuffer()).save(path)
        except OSError as error:
            self._usable = False
            say(f"cannot write {path}: {error.strerror or error}; no more frames are written")

    def _numbered(self) -> str:
        # No ``%`` operator: a folder's name may hold another percent sign.
        return re.sub(
            "%(0?[0-9]*)d", lambda found: format(self._number, f"{found[1]}d"), self._pattern
        )


@contextmanager
def _plain_reading(framebuffer: int) -> Iterator[bool]:
    """Tight pixels of what is shown, whatever framebuffer and pixel state the app has set. Gives
    whether GL can read them."""
    undo: list[tuple[Callable[..., Any], tuple[Any, ...]]] = []

    def change(function: Callable[..., Any], *new: Any, back_to: Any) -> None:
        function(*new)
        undo.append((function, (*new[:-1], back_to)))

    version = _version()
    if version >= (3, 0):
        # The draw binding too: GL_DOUBLEBUFFER tells about that one.
        for target, binding in _FRAMEBUFFERS:
            change(gl.glBindFramebuffer, target, framebuffer, back_to=integer(binding))
    if version >= (2, 1):
        bound = integer(_PIXEL_PACK_BUFFER_BINDING)
        change(gl.glBindBuffer, _PIXEL_PACK_BUFFER, 0, back_to=bound)
    window_buffer = _BACK if integer(_DOUBLEBUFFER) else _FRONT
    buffer = _COLOR_ATTACHMENT if framebuffer else window_buffer
    change(gl.glReadBuffer, buffer, back_to=integer(_READ_BUFFER))
    for name, value in _PACKING:
        change(gl.glPixelStorei, name, value, back_to=integer(name))
    if version < (3, 2) or not integer(_CONTEXT_PROFILE_MASK) & _CORE_PROFILE:
        for name, plain in _TRANSFER:
            change(_pixel_transfer(), name, plain, back_to=real(name))
    try:
        yield not (framebuffer and integer(_SAMPLE_BUFFERS))
    finally:
        for function, arguments in reversed(undo):
            function(*arguments)


@cache
def _pixel_transfer() -> Callable[..., Any]:
    from OpenGL.platform import PLATFORM

    prototype = ctypes.CFUNCTYPE(None, ctypes.c_uint, ctypes.c_float)
    return prototype(("glPixelTransferf", PLATFORM.GL))


def _version() -> tuple[int, int]:
    text = ctypes.string_at(gl.glGetString(_VERSION))
    found = re.search(rb"(\d+)\.(\d+)", text)
    return (int(found[1]), int(found[2])) if found else (1, 1)
