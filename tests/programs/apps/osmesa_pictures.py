"""Draws into memory by OSMesa: two pictures, each read from the program's own buffer."""

import os
import sys

os.environ["PYOPENGL_PLATFORM"] = "osmesa"

import numpy as np
import toolkit_scene
from OpenGL.GL import GL_UNSIGNED_BYTE, glFinish, glGetString
from OpenGL.osmesa import (
    OSMESA_RGBA,
    OSMesaCreateContextExt,
    OSMesaDestroyContext,
    OSMesaMakeCurrent,
)

WIDTH, HEIGHT = 300, 200
context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, None)
pixels = np.zeros((HEIGHT, WIDTH, 4), np.uint8)
assert OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, WIDTH, HEIGHT)
print("version", glGetString(0x1F02).decode().split()[0])
for number in range(int(sys.argv[1]) if len(sys.argv) > 1 else 2):
    toolkit_scene.draw(WIDTH, HEIGHT)
    glFinish()
    print("picture", number, int(pixels.sum()), flush=True)
OSMesaDestroyContext(context)
