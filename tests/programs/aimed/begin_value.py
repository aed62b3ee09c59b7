"""glBegin of what has a `.value`: an Enum member and a ctypes number are refused by ctypes."""

import ctypes
import enum

from OpenGL import GL
from window import tried


class Mode(enum.Enum):
    TRIANGLES = 4


for value in (Mode.TRIANGLES, ctypes.c_int(4), ctypes.c_uint(4), True, 4.0, "4", None):
    tried(f"glBegin of {type(value).__name__}", lambda: GL.glBegin(value))  # noqa: B023
    tried("glEnd", GL.glEnd)
