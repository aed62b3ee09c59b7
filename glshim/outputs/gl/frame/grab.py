"""The frame as it is presented, read from the driver and written as PNG; the app's state stays."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glshim.errors import shown
from glshim.notices import say
from glshim.spec.ask import integer, integers, real
from glshim.spec.constants import (
    GL_BACK,
    GL_BLUE_BIAS,
    GL_BLUE_SCALE,
    GL_COLOR_ATTACHMENT0,
    GL_DOUBLEBUFFER,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_FRONT,
    GL_GREEN_BIAS,
    GL_GREEN_SCALE,
    GL_MAP_COLOR,
    GL_PACK_ALIGNMENT,
    GL_PACK_LSB_FIRST,
    GL_PACK_ROW_LENGTH,
    GL_PACK_SKIP_PIXELS,
    GL_PACK_SKIP_ROWS,
    GL_PACK_SWAP_BYTES,
    GL_PIXEL_PACK_BUFFER,
    GL_PIXEL_PACK_BUFFER_BINDING,
    GL_READ_BUFFER,
    GL_READ_FRAMEBUFFER,
    GL_READ_FRAMEBUFFER_BINDING,
    GL_RED_BIAS,
    GL_RED_SCALE,
    GL_RGB,
    GL_SAMPLE_BUFFERS,
    GL_UNSIGNED_BYTE,
    GL_VIEWPORT,
)
from glshim.spec.context import has_fixed_function, number_of_any_api, version
from glshim.spec.driver import gl
from glshim.system.interrupts import Held
from glshim.system.writing import picture_target, write_picture

if TYPE_CHECKING:
    from PIL.Image import Image

_FRAMEBUFFERS = (
    (GL_READ_FRAMEBUFFER, GL_READ_FRAMEBUFFER_BINDING),
    (GL_DRAW_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER_BINDING),
)
"""Targets and bindings."""
_PACKING = (
    (GL_PACK_SWAP_BYTES, 0), (GL_PACK_LSB_FIRST, 0), (GL_PACK_ROW_LENGTH, 0),
    (GL_PACK_SKIP_ROWS, 0), (GL_PACK_SKIP_PIXELS, 0), (GL_PACK_ALIGNMENT, 1),
)  # fmt: skip
_TRANSFER = (
    (GL_MAP_COLOR, 0.0), (GL_RED_SCALE, 1.0), (GL_RED_BIAS, 0.0), (GL_GREEN_SCALE, 1.0),
    (GL_GREEN_BIAS, 0.0), (GL_BLUE_SCALE, 1.0), (GL_BLUE_BIAS, 0.0),
)  # fmt: skip


def grab(size: tuple[int, int] | None = None, framebuffer: int = 0) -> Image:
    """What the current context is about to present; without a size, as much as the viewport.
    Black where the framebuffer is an object with several samples.

    Every GL call here is legal in the context's own version, so no error arises, and one that the
    app has yet to fetch stays where it is.
    """
    from PIL import Image

    if size is None:
        _, _, *extent = integers(GL_VIEWPORT, 4)
        size = extent[0], extent[1]
    pixels = ctypes.create_string_buffer(size[0] * size[1] * 3)
    with Held(), _plain_reading(framebuffer) as readable:
        if readable:
            gl.glReadPixels(0, 0, *size, GL_RGB, GL_UNSIGNED_BYTE, pixels)
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
            picture_target(path)  # known before any work
            write_picture(path, grab(size, self._framebuffer()))
        except OSError as error:
            self._usable = False
            reason = error.strerror or error
            say(f"cannot write {shown(path, 500)}: {reason}; no more frames are written")

    def _numbered(self) -> str:
        # No ``%`` operator: a folder's name may hold another percent sign.
        found = re.fullmatch("(.*)%(0?[0-9]{0,2})d(.*)", self._pattern, re.DOTALL)
        if found is None:
            return self._pattern
        return f"{found[1]}{self._number:{found[2]}d}{found[3]}"


@contextmanager
def _plain_reading(framebuffer: int) -> Iterator[bool]:
    """Tight pixels of what is shown, whatever framebuffer and pixel state the app has set. Gives
    whether GL can read them."""
    undo: list[tuple[Callable[..., Any], tuple[Any, ...]]] = []

    def change(function: Callable[..., Any], *new: Any, back_to: Any) -> None:
        function(*new)
        undo.append((function, (*new[:-1], back_to)))

    number = number_of_any_api()
    if number >= (3, 0):
        # The draw binding too: GL_DOUBLEBUFFER tells about that one.
        for target, binding in _FRAMEBUFFERS:
            change(gl.glBindFramebuffer, target, framebuffer, back_to=integer(binding))
    if number >= (2, 1):
        bound = integer(GL_PIXEL_PACK_BUFFER_BINDING)
        change(gl.glBindBuffer, GL_PIXEL_PACK_BUFFER, 0, back_to=bound)
    window_buffer = GL_BACK if integer(GL_DOUBLEBUFFER) else GL_FRONT
    buffer = GL_COLOR_ATTACHMENT0 if framebuffer else window_buffer
    change(gl.glReadBuffer, buffer, back_to=integer(GL_READ_BUFFER))
    for name, value in _PACKING:
        change(gl.glPixelStorei, name, value, back_to=integer(name))
    if version() is None or has_fixed_function():
        for name, plain in _TRANSFER:
            change(gl.glPixelTransferf, name, plain, back_to=real(name))
    try:
        yield not (framebuffer and integer(GL_SAMPLE_BUFFERS))
    finally:
        for function, arguments in reversed(undo):
            function(*arguments)
