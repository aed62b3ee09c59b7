"""How pixels go between the driver and memory: tightly, one after the other, as they are.

Whoever calls this puts the client's pixel state, and the transfer's, back: inside the state guard
that is done, and between glPushAttrib(GL_PIXEL_MODE_BIT) with
glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT) and both pops.
"""

from __future__ import annotations

from glshim.driver.context import number_of_any_api
from glshim.driver.functions import gl
from glshim.spec.constants import (
    GL_ALPHA_BIAS,
    GL_ALPHA_SCALE,
    GL_BLUE_BIAS,
    GL_BLUE_SCALE,
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
    GL_PIXEL_UNPACK_BUFFER,
    GL_RED_BIAS,
    GL_RED_SCALE,
    GL_UNPACK_ALIGNMENT,
    GL_UNPACK_LSB_FIRST,
    GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_SKIP_PIXELS,
    GL_UNPACK_SKIP_ROWS,
    GL_UNPACK_SWAP_BYTES,
)

PACKING = (
    (GL_PACK_SWAP_BYTES, 0), (GL_PACK_LSB_FIRST, 0), (GL_PACK_ROW_LENGTH, 0),
    (GL_PACK_SKIP_ROWS, 0), (GL_PACK_SKIP_PIXELS, 0), (GL_PACK_ALIGNMENT, 1),
)  # fmt: skip
"""Of what is read, by glPixelStorei."""
UNPACKING = (
    (GL_UNPACK_SWAP_BYTES, 0), (GL_UNPACK_LSB_FIRST, 0), (GL_UNPACK_ROW_LENGTH, 0),
    (GL_UNPACK_SKIP_ROWS, 0), (GL_UNPACK_SKIP_PIXELS, 0), (GL_UNPACK_ALIGNMENT, 1),
)  # fmt: skip
"""Of what is written."""
TRANSFER = (
    (GL_MAP_COLOR, 0.0), (GL_RED_SCALE, 1.0), (GL_GREEN_SCALE, 1.0), (GL_BLUE_SCALE, 1.0),
    (GL_ALPHA_SCALE, 1.0), (GL_RED_BIAS, 0.0), (GL_GREEN_BIAS, 0.0), (GL_BLUE_BIAS, 0.0),
    (GL_ALPHA_BIAS, 0.0),
)  # fmt: skip
"""Of colours on their way, by glPixelTransferf: the fixed function alone has it."""
BUFFERS = (2, 1)
"""The version from which buffer objects may take the place of memory."""


def pack_plainly() -> None:
    """What is read from now on."""
    if number_of_any_api() >= BUFFERS:
        gl.glBindBuffer(GL_PIXEL_PACK_BUFFER, 0)
    for setting in PACKING:
        gl.glPixelStorei(*setting)


def unpack_plainly() -> None:
    """What is written from now on."""
    if number_of_any_api() >= BUFFERS:
        gl.glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0)
    for setting in UNPACKING:
        gl.glPixelStorei(*setting)


def transfer_plainly() -> None:
    """Colours are not changed on their way. In a context of the fixed function."""
    for setting in TRANSFER:
        gl.glPixelTransferf(*setting)
