"""Objects of a program and ours: what it names itself stays its own, and it is given the names that
it would be given without us."""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
from typing import Any

import glfw
import numpy as np
import pytest
from OpenGL import GL

from glshim.driver.functions import gl
from glshim.styling import registry
from tests.sweep import SEED, some

from .test_contexts import cube
from .world import App, prepare, styled, window

STYLES = ("none", *registry.names(), *registry.looks())
NAMED = range(1, 9)


def frame(handle: Any) -> None:
    GL.glBindTexture(GL.GL_TEXTURE_2D, 0)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glPushMatrix()
    cube()
    GL.glPopMatrix()
    glfw.swap_buffers(handle)


def seen_with_own_names(style: str | None) -> list[str]:
    """Textures, buffers and others under names that were never generated, used after a frame."""
    app = App()
    with styled(style), window() as handle:
        prepare()
        frame(handle)
        red = np.full((16, 16, 3), (255, 0, 0), np.uint8)
        for name in NAMED:
            GL.glBindTexture(GL.GL_TEXTURE_2D, name)
            GL.glTexImage2D(
                GL.GL_TEXTURE_2D, 0, GL.GL_RGB, 16, 16, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, red
            )
            GL.glBindBuffer(GL.GL_ARRAY_BUFFER, name)
            GL.glBufferData(GL.GL_ARRAY_BUFFER, 16, red[0], GL.GL_STATIC_DRAW)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)
        for _ in range(3):
            frame(handle)
        for name in NAMED:
            GL.glBindTexture(GL.GL_TEXTURE_2D, name)
            pixels = GL.glGetTexImage(GL.GL_TEXTURE_2D, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
            app.saw.append(str(pixels == red.tobytes()))
            GL.glBindBuffer(GL.GL_ARRAY_BUFFER, name)
            data = (ctypes.c_ubyte * 16)()
            GL.glGetBufferSubData(GL.GL_ARRAY_BUFFER, 0, 16, data)
            app.saw.append(str(bytes(data) == red.tobytes()[:16]))
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)
        for is_there in (GL.glIsTexture, GL.glIsBuffer, GL.glIsFramebuffer, GL.glIsRenderbuffer,
                         GL.glIsVertexArray, GL.glIsQuery, GL.glIsSampler):  # fmt: skip
            app.saw.append(str([int(is_there(name)) for name in range(1, 2000)]))
        for generate in (GL.glGenTextures, GL.glGenBuffers, GL.glGenFramebuffers,
                         GL.glGenRenderbuffers, GL.glGenVertexArrays, GL.glGenQueries,
                         GL.glGenSamplers, GL.glGenLists):  # fmt: skip
            app.tries(generate, 3)
        for make, arguments in ((GL.glGenTextures, (2,)), (GL.glGenBuffers, (2,)),
                                (GL.glCreateShader, (GL.GL_VERTEX_SHADER,)),
                                (GL.glCreateProgram, ())):  # fmt: skip
            gl.glEnable(0xFFFF)  # an error that PyOpenGL finds after the call that makes it
            with pytest.raises(GL.GLError) as caught:
                make(*arguments)
            app.saw.append(f"{caught.value.err} {caught.value.result}")
            app.tries(make, *arguments)
        GL.glDeleteTextures(list(range(1, 1000)))
        GL.glDeleteLists(1, 10000)
        frame(handle)
        app.tries(GL.glGenTextures, 1)
        app.error()
    return app.saw


@pytest.mark.parametrize("style", some(STYLES, 6))
def test_objects_that_a_program_names_are_its_own(style: str) -> None:
    assert seen_with_own_names(None) == seen_with_own_names(style)


GREEDY = """
from tests.differential.test_object_names import *

def pictures(style, most):
    found = []
    with styled(style), window() as handle:
        prepare()
        for turn in range(4):
            GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
            GL.glPushMatrix()
            cube()
            GL.glPopMatrix()
            found.append(GL.glReadPixels(0, 0, 96, 72, GL.GL_RGB, GL.GL_UNSIGNED_BYTE))
            for name in range(1, most) if turn else ():
                if GL.glIsProgram(name):
                    GL.glDeleteProgram(name)
            glfw.swap_buffers(handle)
    return np.array([np.frombuffer(each, np.uint8) for each in found])

plain = pictures(None, 1)
for style in STYLES[TURN::16]:
    shown, greedy = (
        (pictures(style, most) != plain).sum(axis=1).tolist() for most in (1, 20000)
    )
    for some, others in zip(shown, greedy):  # hands of some styles shake
        assert 0.8 * some <= others <= 1.25 * some, (style, shown, greedy)
"""


@pytest.mark.programs
def test_a_program_that_deletes_ours_gets_its_style_all_the_same() -> None:
    """With a driver that gives names again they lie beyond 16,384 of the program's."""
    program = GREEDY.replace("TURN", str(SEED % 16))
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=300,
        env={**os.environ, "force_gl_names_reuse": "true"}, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stderr.count("has deleted objects of glshim's: they are made anew") == 1
    assert "Traceback" not in done.stderr


@pytest.mark.programs
@pytest.mark.parametrize("flag", ["FULL_LOGGING", "ERROR_LOGGING"])
def test_shaders_are_named_where_calls_are_logged(flag: str, display: str) -> None:
    """PyOpenGL's own shader source is a function apart, behind what logs it."""
    program = f"""
import OpenGL
OpenGL.{flag} = True
from tests.differential.test_object_names import *

with styled("raskar"), window() as handle:
    prepare()
    cube()
    glfw.swap_buffers(handle)
    shader = GL.glCreateShader(GL.GL_FRAGMENT_SHADER)
    GL.glShaderSource(shader, "void main() {{ gl_FragColor = vec4(1.0); }}")
    GL.glCompileShader(shader)
    assert GL.glGetShaderiv(shader, GL.GL_COMPILE_STATUS)
"""
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=300,
        env={**os.environ, "DISPLAY": display}, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
