"""A small panel of text over the picture that is about to be presented.

Drawn with glDrawPixels: it leaves no object in the app's context, and every fixed-function context
has it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from glshim.driver.ask import integer, integers
from glshim.driver.context import shortcoming
from glshim.driver.functions import gl
from glshim.driver.pixels import transfer_plainly, unpack_plainly
from glshim.driver.queries import counting
from glshim.outputs.gl.device.guard import Guard, possible
from glshim.outputs.gl.device.plain import plainly
from glshim.outputs.wrapping import wrapped
from glshim.spec.constants import (
    GL_BLEND,
    GL_COLOR_SUM,
    GL_FOG,
    GL_FRAGMENT_PROGRAM_ARB,
    GL_FRAMEBUFFER,
    GL_FUNC_ADD,
    GL_MAX_TEXTURE_UNITS,
    GL_ONE,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_RGBA,
    GL_SCISSOR_TEST,
    GL_TEXTURE0,
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_TEXTURE_3D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_RECTANGLE,
    GL_UNSIGNED_BYTE,
    GL_VIEWPORT,
)

MARGIN, PADDING = 8, 7
"""Pixels around the panel, and in it around the text."""
_SIZE = 13.0
_PAPER, _INK, _FAINT = (12, 14, 18, 200), (255, 255, 255, 255), (190, 198, 208, 255)
_TEXTURES = (
    GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE,
)  # fmt: skip


def panel(lines: Sequence[str], most_width: int) -> NDArray[np.uint8]:
    """(H, W, 4) premultiplied, the top row first: lines of text on a dark ground, the first one
    bright, wrapped where they are wider than so many pixels."""
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
    viewport's). Where GL cannot draw now, or a query of the app's would count it, nothing."""
    if shortcoming() or not possible() or counting():
        return
    if size is None:
        x, y, across, up = integers(GL_VIEWPORT, 4)
        size = x + across, y + up
    rows = np.ascontiguousarray(pixels[::-1])
    height, width = rows.shape[:2]
    with Guard():
        gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
        _plainly()
        gl.glWindowPos2i(MARGIN, size[1] - MARGIN - height)
        gl.glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.ctypes.data)


def _plainly() -> None:
    """Inside the guard: pixels that are drawn arrive as they are, blended."""
    plainly()
    gl.glDisable(GL_SCISSOR_TEST)
    gl.glUseProgram(0)
    for unit in range(integer(GL_MAX_TEXTURE_UNITS)):
        gl.glActiveTexture(GL_TEXTURE0 + unit)
        for target in _TEXTURES:
            gl.glDisable(target)
    for switch in (GL_FOG, GL_COLOR_SUM, GL_FRAGMENT_PROGRAM_ARB):
        gl.glDisable(switch)
    gl.glEnable(GL_BLEND)
    gl.glBlendEquation(GL_FUNC_ADD)
    gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA)
    gl.glPixelZoom(1.0, 1.0)
    transfer_plainly()
    unpack_plainly()
