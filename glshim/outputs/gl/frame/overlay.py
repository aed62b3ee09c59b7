"""A small panel of text over the picture that is about to be presented.

Drawn with glDrawPixels: it leaves no object in the app's context, and every fixed-function context
has it.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from glshim.outputs.gl.device.guard import Guard, possible
from glshim.outputs.gl.device.plain import plainly
from glshim.outputs.wrapping import wrapped
from glshim.spec.ask import integer
from glshim.spec.context import shortcoming
from glshim.spec.driver import gl

MARGIN, PADDING = 8, 7
"""Pixels around the panel, and in it around the text."""
_SIZE = 13.0
_PAPER, _INK, _FAINT = (12, 14, 18, 200), (255, 255, 255, 255), (190, 198, 208, 255)
_FRAMEBUFFER = 0x8D40
_BLEND, _ADD, _ONE, _REST = 0x0BE2, 0x8006, 1, 0x0303
_SCISSOR_TEST, _RGBA, _BYTE = 0x0C11, 0x1908, 0x1401
_UNPACK_BUFFER = 0x88EC
_UNPACKING = ((0x0CF0, 0), (0x0CF1, 0), (0x0CF2, 0), (0x0CF3, 0), (0x0CF4, 0), (0x0CF5, 1))
"""GL_UNPACK_SWAP_BYTES, LSB_FIRST, ROW_LENGTH, SKIP_ROWS, SKIP_PIXELS, ALIGNMENT."""
_TRANSFER = (
    (0x0D10, 0.0),  # GL_MAP_COLOR
    *((scale, 1.0) for scale in (0x0D14, 0x0D18, 0x0D1A, 0x0D1C)),
    *((bias, 0.0) for bias in (0x0D15, 0x0D19, 0x0D1B, 0x0D1D)),
)
_TEXTURING = (0x0DE0, 0x0DE1, 0x806F, 0x8513, 0x84F5)
_FOG, _COLOR_SUM, _FRAGMENT_PROGRAM = 0x0B60, 0x8458, 0x8804
_TEXTURE_0, _TEXTURE_UNITS = 0x84C0, 0x84E2


def panel(lines: Sequence[str], most_width: int) -> NDArray[np.uint8]:
    """(H, W, 4) premultiplied, the top row first: lines of text on a dark ground, the first one
    bright, wrapped where they are wider than so many pixels."""
    from PIL import Image, ImageDraw, ImageFont

    font = ImageFont.load_default(_SIZE)
    room = max(most_width - 2 * (MARGIN + PADDING), 40)
    rows = [
        (part, number)
        for number, line in enumerate(lines)
        for part in wrapped(line, font.getlength, room)
    ]
    ascent, descent = font.getmetrics()  # type: ignore[union-attr]
    step = ascent + descent + 3
    width = max((int(font.getlength(text)) + 1 for text, _ in rows), default=1)
    size = (width + 2 * PADDING, step * len(rows) - 3 + 2 * PADDING)
    image = Image.new("RGBA", size, _PAPER)
    draw = ImageDraw.Draw(image)
    for row, (text, line) in enumerate(rows):
        ink = _FAINT if line else _INK
        draw.text((PADDING, PADDING + row * step), text, font=font, fill=ink)
    pixels = np.array(image, np.uint8)
    pixels[..., :3] = np.rint(pixels[..., :3] * (pixels[..., 3:] / 255.0))
    return pixels


def show(pixels: NDArray[np.uint8], size: tuple[int, int] | None, framebuffer: int) -> None:
    """Lay a panel over the top left corner of what is presented, of a size in pixels (None: of the
    viewport's). Where GL cannot draw now, nothing."""
    if shortcoming() or not possible():
        return
    if size is None:
        viewport = (ctypes.c_int * 4)()
        gl.glGetIntegerv(0x0BA2, ctypes.addressof(viewport))
        size = viewport[0] + viewport[2], viewport[1] + viewport[3]
    rows = np.ascontiguousarray(pixels[::-1])
    height, width = rows.shape[:2]
    with Guard():
        gl.glBindFramebuffer(_FRAMEBUFFER, framebuffer)
        _plainly()
        gl.glWindowPos2i(MARGIN, size[1] - MARGIN - height)
        gl.glDrawPixels(width, height, _RGBA, _BYTE, rows.ctypes.data)


def _plainly() -> None:
    """Inside the guard: pixels that are drawn arrive as they are, blended."""
    plainly()
    gl.glDisable(_SCISSOR_TEST)
    gl.glUseProgram(0)
    for unit in range(integer(_TEXTURE_UNITS)):
        gl.glActiveTexture(_TEXTURE_0 + unit)
        for target in _TEXTURING:
            gl.glDisable(target)
    for switch in (_FOG, _COLOR_SUM, _FRAGMENT_PROGRAM):
        gl.glDisable(switch)
    gl.glEnable(_BLEND)
    gl.glBlendEquation(_ADD)
    gl.glBlendFunc(_ONE, _REST)
    gl.glPixelZoom(1.0, 1.0)
    for name, value in _TRANSFER:
        gl.glPixelTransferf(name, value)
    gl.glBindBuffer(_UNPACK_BUFFER, 0)
    for setting in _UNPACKING:
        gl.glPixelStorei(*setting)
