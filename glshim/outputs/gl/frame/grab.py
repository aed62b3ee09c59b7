"""The frame as it is presented, read from the driver and written as PNG; the app's state stays."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from PIL import Image as Pillow
from PIL.Image import Image

from glshim.driver.ask import integer, integers, is_enabled, real
from glshim.driver.context import has_fixed_function, number_of_any_api, version
from glshim.driver.functions import gl
from glshim.driver.objects import delete, made
from glshim.driver.pixels import BUFFERS, PACKING, TRANSFER
from glshim.driver.unnoticed import Unnoticed
from glshim.errors import shown
from glshim.notices import say
from glshim.spec.constants import (
    GL_BACK,
    GL_COLOR_ATTACHMENT0,
    GL_COLOR_BUFFER_BIT,
    GL_DOUBLEBUFFER,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_FRONT,
    GL_NEAREST,
    GL_PIXEL_PACK_BUFFER,
    GL_PIXEL_PACK_BUFFER_BINDING,
    GL_READ_BUFFER,
    GL_READ_FRAMEBUFFER,
    GL_READ_FRAMEBUFFER_BINDING,
    GL_RENDERBUFFER,
    GL_RENDERBUFFER_BINDING,
    GL_RGB,
    GL_RGB8,
    GL_SAMPLE_BUFFERS,
    GL_SCISSOR_TEST,
    GL_UNSIGNED_BYTE,
    GL_VIEWPORT,
)
from glshim.spec.kinds import FRAMEBUFFER, RENDERBUFFER
from glshim.spec.pixels import TextureImage
from glshim.system.writing import picture_target, write_picture

Size = tuple[int, int]
_FRAMEBUFFERS = (
    (GL_READ_FRAMEBUFFER, GL_READ_FRAMEBUFFER_BINDING),
    (GL_DRAW_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER_BINDING),
)
"""Targets and bindings."""


def grab(
    size: Size | None = None, framebuffer: int = 0, buffer: int = 0,
    texture: TextureImage | None = None,
) -> Image:  # fmt: skip
    """What the current context is about to present; without a size, as much as the viewport.

    buffer: of the framebuffer, in place of the one that is shown. texture: a level of that size in
    place of a framebuffer. Every GL call here is legal in the context's own version, or what it
    causes stays `Unnoticed`.
    """
    if size is None:
        _, _, *extent = integers(GL_VIEWPORT, 4)
        size = extent[0], extent[1]
    pixels = ctypes.create_string_buffer(size[0] * size[1] * 3)
    with Unnoticed(), ExitStack() as undo:
        _pack_plainly(undo)
        if texture is not None:
            _read_texture(texture, pixels)
        else:
            _read_framebuffer(framebuffer, buffer, size, pixels, undo)
    return Pillow.frombytes("RGB", size, pixels.raw, "raw", "RGB", 0, -1)


class FrameWriter:
    """Writes each frame to ``pattern``, whose ``%d`` is the frame's number, from 1."""

    def __init__(
        self, pattern: str, picture: Callable[[], Image | None], number: Callable[[], int]
    ) -> None:
        """picture: of the frame, None where there is none to be had."""
        self._pattern = pattern
        self._picture = picture
        self._number = number
        self._usable = True

    def write(self) -> None:
        """Write the frame that the current context is about to present, or has read back."""
        if not self._usable:
            return
        path = Path(self._numbered())
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            picture_target(path)  # known before any work
            picture = self._picture()
            if picture is not None:
                write_picture(path, picture)
        except OSError as error:
            self._usable = False
            reason = error.strerror or error
            say(f"cannot write {shown(path, 500)}: {reason}; no more frames are written")

    def _numbered(self) -> str:
        # No ``%`` operator: a folder's name may hold another percent sign.
        found = re.fullmatch("(.*)%(0?[0-9]{0,2})d(.*)", self._pattern, re.DOTALL)
        if found is None:
            return self._pattern
        return f"{found[1]}{self._number():{found[2]}d}{found[3]}"


def _read_texture(image: TextureImage, pixels: Any) -> None:
    if image.texture:
        gl.glGetTextureImage(
            image.texture, image.level, GL_RGB, GL_UNSIGNED_BYTE, len(pixels), pixels
        )
    else:
        gl.glGetTexImage(image.target, image.level, GL_RGB, GL_UNSIGNED_BYTE, pixels)


def _read_framebuffer(
    framebuffer: int, buffer: int, size: Size, pixels: Any, undo: ExitStack
) -> None:
    if number_of_any_api() >= (3, 0):
        # The draw binding too: GL_DOUBLEBUFFER tells about that one.
        for target, binding in _FRAMEBUFFERS:
            _change(undo, gl.glBindFramebuffer, target, framebuffer, back_to=integer(binding))
    if not buffer:
        window_buffer = GL_BACK if integer(GL_DOUBLEBUFFER) else GL_FRONT
        buffer = GL_COLOR_ATTACHMENT0 if framebuffer else window_buffer
    _change(undo, gl.glReadBuffer, buffer, back_to=integer(GL_READ_BUFFER))
    if framebuffer and integer(GL_SAMPLE_BUFFERS):
        _resolve(size, undo)
    gl.glReadPixels(0, 0, *size, GL_RGB, GL_UNSIGNED_BYTE, pixels)


def _resolve(size: Size, undo: ExitStack) -> None:
    """Read from an object of ours with one sample for each pixel of the one that is bound."""
    box = (0, 0, *size)
    copy, colours = made(FRAMEBUFFER), made(RENDERBUFFER)
    undo.callback(delete, FRAMEBUFFER, [copy])
    undo.callback(delete, RENDERBUFFER, [colours])
    bound = integer(GL_RENDERBUFFER_BINDING)
    _change(undo, gl.glBindRenderbuffer, GL_RENDERBUFFER, colours, back_to=bound)
    gl.glRenderbufferStorage(GL_RENDERBUFFER, GL_RGB8, *size)
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, copy)
    gl.glFramebufferRenderbuffer(
        GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours
    )
    if is_enabled(GL_SCISSOR_TEST):
        gl.glDisable(GL_SCISSOR_TEST)
        undo.callback(gl.glEnable, GL_SCISSOR_TEST)
    gl.glBlitFramebuffer(*box, *box, GL_COLOR_BUFFER_BIT, GL_NEAREST)
    read = integer(GL_READ_FRAMEBUFFER_BINDING)
    _change(undo, gl.glBindFramebuffer, GL_READ_FRAMEBUFFER, copy, back_to=read)


def _change(undo: ExitStack, function: Callable[..., Any], *new: Any, back_to: Any) -> None:
    function(*new)
    undo.callback(function, *new[:-1], back_to)


def _pack_plainly(undo: ExitStack) -> None:
    """Tight pixels as they are, whatever pixel state the app has set."""
    if number_of_any_api() >= BUFFERS:
        bound = integer(GL_PIXEL_PACK_BUFFER_BINDING)
        _change(undo, gl.glBindBuffer, GL_PIXEL_PACK_BUFFER, 0, back_to=bound)
    for name, value in PACKING:
        _change(undo, gl.glPixelStorei, name, value, back_to=integer(name))
    if version() is None or has_fixed_function():
        for name, plain in TRANSFER:
            _change(undo, gl.glPixelTransferf, name, plain, back_to=real(name))
