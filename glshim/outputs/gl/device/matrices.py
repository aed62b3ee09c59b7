"""Modelview and projection, changed for a moment."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager

from glshim.driver.functions import gl
from glshim.spec.constants import (
    GL_MODELVIEW,
    GL_MODELVIEW_MATRIX,
    GL_PROJECTION,
    GL_PROJECTION_MATRIX,
)

_MATRICES = ((GL_MODELVIEW, GL_MODELVIEW_MATRIX), (GL_PROJECTION, GL_PROJECTION_MATRIX))


@contextmanager
def matrices_kept() -> Iterator[None]:
    """Put both matrices back: they are in no attribute group, and their stacks may be full."""
    kept = []
    for mode, name in _MATRICES:
        matrix = (ctypes.c_double * 16)()
        gl.glGetDoublev(name, ctypes.addressof(matrix))
        kept.append((mode, matrix))
    try:
        yield
    finally:
        for mode, matrix in kept:
            gl.glMatrixMode(mode)
            gl.glLoadMatrixd(ctypes.addressof(matrix))
