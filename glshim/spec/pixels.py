"""What each GL entry point has to do with pixels of the window, as data: what a shot, which draws
the window larger and in tiles, says to the driver in other numbers. Beside `spec.roles`."""

from __future__ import annotations

import re
from enum import Enum
from typing import NamedTuple

from glshim.spec.constants import (
    GL_BGRA_INTEGER,
    GL_DEPTH_COMPONENT,
    GL_DEPTH_STENCIL,
    GL_RED_INTEGER,
    GL_RG_INTEGER,
    GL_STENCIL_INDEX,
)

PICK_AREA = 64
"""Pixels. A readback of at most so many is an app looking for what lies under the pointer; a larger
one is a picture."""


class TextureImage(NamedTuple):
    """A level of a texture of two dimensions."""

    texture: int
    """Its name; 0: the one that is bound to the target."""
    target: int
    level: int


class ImageRead(NamedTuple):
    """How a `Role.READ_IMAGE` entry point says what it reads: first the texture or the target, then
    the level."""

    by_name: bool
    format: int
    """The position of the format among its arguments."""


IMAGE_READS = {
    "glGetTexImage": ImageRead(False, 2),
    "glGetnTexImage": ImageRead(False, 2),
    "glGetnTexImageARB": ImageRead(False, 2),
    "glGetTextureImage": ImageRead(True, 2),
    "glGetTextureSubImage": ImageRead(True, 8),
}
COLOURLESS = frozenset(
    (
        GL_DEPTH_COMPONENT, GL_DEPTH_STENCIL, GL_STENCIL_INDEX, GL_RG_INTEGER,
        *range(GL_RED_INTEGER, GL_BGRA_INTEGER + 1),
    )
)  # fmt: skip
"""Formats of what is read back that is no picture: depths, names of objects."""


class PixelRole(Enum):
    """What a call's numbers are."""

    RECTANGLE = "a rectangle: x, y, width, height"
    LINE_WIDTH = "a width of lines"
    POINT_SIZE = "a size of points"
    STIPPLE = "how often each bit of a line's pattern is repeated, and the pattern"
    ZOOM = "factors for pixels that are drawn"
    RASTER_PLACE = "a place (POSITIONS)"
    BITMAP = "a size, an origin and a move"
    FRAMEBUFFER = "a framebuffer that is bound"
    DRAW_BUFFER = "the buffer that is drawn to"
    READ_BUFFER = "the buffer that is read from"
    DRAW_BUFFERS = "several buffers that are drawn to"
    READBACK = "pixels that are read back"
    COPY = "a rectangle that is drawn again"
    BLIT = "corners of two rectangles"
    ACCUMULATION = "an operation on the accumulation buffer"
    FIRST = "no pixels, but it may be the first call of a frame"
    QUESTION = "an answer, which may be one of these (its type: ANSWERS)"


ROWS: tuple[tuple[PixelRole, str], ...] = (
    (PixelRole.RECTANGLE, r"glViewport|glScissor"),
    (PixelRole.LINE_WIDTH, r"glLineWidth"),
    (PixelRole.POINT_SIZE, r"glPointSize"),
    (PixelRole.STIPPLE, r"glLineStipple"),
    (PixelRole.ZOOM, r"glPixelZoom"),
    (PixelRole.RASTER_PLACE, r"glWindowPos[234][dfis]v?(ARB|MESA)?"),
    (PixelRole.BITMAP, r"glBitmap"),
    (PixelRole.FRAMEBUFFER, r"glBindFramebuffer(EXT)?"),
    (PixelRole.DRAW_BUFFER, r"glDrawBuffer"),
    (PixelRole.READ_BUFFER, r"glReadBuffer"),
    (PixelRole.DRAW_BUFFERS, r"glDrawBuffers(ARB)?"),
    (PixelRole.READBACK, r"glReadPixels|glCopyTexImage[12]D(EXT)?|glCopyTexSubImage[123]D(EXT)?"),
    (PixelRole.COPY, r"glCopyPixels"),
    (PixelRole.BLIT, r"glBlitFramebuffer(EXT)?"),
    (PixelRole.ACCUMULATION, r"glAccum"),
    (PixelRole.FIRST, r"glClear|glMatrixMode|glLoadIdentity"),
    (PixelRole.QUESTION, r"glGet(Integer|Float|Double|Boolean)v"),
)

ANSWERS = {"glGetIntegerv": "i", "glGetFloatv": "f", "glGetDoublev": "d", "glGetBooleanv": "b"}
"""Types of the answers to questions: i int, f float, d double, b unsigned byte."""


class Position(NamedTuple):
    """How a RASTER_PLACE entry point takes its place."""

    size: int
    """Coordinates."""
    vector: bool
    """The numbers lie behind a pointer."""


POSITIONS = {
    f"glWindowPos{size}{letter}{v}{suffix}": Position(size, bool(v))
    for size in (2, 3, 4)
    for letter in "dfis"
    for v in ("", "v")
    for suffix in ("", "ARB", "MESA")
}


def pixel_role(name: str) -> PixelRole | None:
    """The role of an entry point, None for one that has nothing to do with pixels."""
    for role, pattern in ROWS:
        if re.fullmatch(pattern, name):
            return role
    return None
