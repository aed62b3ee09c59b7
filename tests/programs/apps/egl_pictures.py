"""Draws without a window by EGL: into a pbuffer, or (surfaceless) into a framebuffer object."""

import ctypes
import os
import sys

os.environ["PYOPENGL_PLATFORM"] = "egl"
os.environ["EGL_PLATFORM"] = "surfaceless"  # no screen is needed

import numpy as np
import toolkit_scene
from OpenGL.EGL import *  # noqa: F403
from OpenGL.GL import *  # noqa: F403

# ruff: noqa: F405
WIDTH, HEIGHT = 300, 200
surfaceless = "surfaceless" in sys.argv
display = eglGetDisplay(EGL_DEFAULT_DISPLAY)
major, minor = ctypes.c_long(), ctypes.c_long()
assert eglInitialize(display, major, minor)
kind = 0 if surfaceless else EGL_PBUFFER_BIT
wanted = (EGLint * 11)(
    EGL_SURFACE_TYPE, kind, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8,
    EGL_DEPTH_SIZE, 24, EGL_CONFORMANT, EGL_OPENGL_BIT, EGL_NONE)  # fmt: skip
configs, count = (EGLConfig * 1)(), ctypes.c_long()
assert eglChooseConfig(display, wanted, configs, 1, count) and count.value
assert eglBindAPI(EGL_OPENGL_API)
context = eglCreateContext(display, configs[0], EGL_NO_CONTEXT, None)
surface = EGL_NO_SURFACE
if not surfaceless:
    size = (EGLint * 5)(EGL_WIDTH, WIDTH, EGL_HEIGHT, HEIGHT, EGL_NONE)
    surface = eglCreatePbufferSurface(display, configs[0], size)
assert eglMakeCurrent(display, surface, surface, context)
print("version", glGetString(GL_VERSION).decode().split()[0])
if surfaceless:
    glBindFramebuffer(GL_FRAMEBUFFER, glGenFramebuffers(1))
    for attachment, form in ((GL_COLOR_ATTACHMENT0, GL_RGBA8),
                             (GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24)):  # fmt: skip
        glBindRenderbuffer(GL_RENDERBUFFER, glGenRenderbuffers(1))
        glRenderbufferStorage(GL_RENDERBUFFER, form, WIDTH, HEIGHT)
        glFramebufferRenderbuffer(
            GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, glGetIntegerv(GL_RENDERBUFFER_BINDING)
        )
    assert glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE
numbers = [each for each in sys.argv[1:] if each.isdigit()]
for number in range(int(numbers[0]) if numbers else 2):
    toolkit_scene.draw(WIDTH, HEIGHT)
    pixels = glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGB, GL_UNSIGNED_BYTE)
    depth = glReadPixels(0, 0, WIDTH, HEIGHT, GL_DEPTH_COMPONENT, GL_FLOAT)
    print("picture", number, int(np.frombuffer(pixels, np.uint8).sum()), flush=True)
eglTerminate(display)
