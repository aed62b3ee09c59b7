"""Interrupted anywhere, a program finds what it would find without us: the exception, once; every
stack, binding and switch; and a next frame that is right."""

from __future__ import annotations

import random
import signal
from collections.abc import Callable, Iterator
from contextlib import suppress
from types import FrameType
from typing import Any

import glfw
import numpy as np
import pytest
from numpy.typing import NDArray
from OpenGL import GL
from OpenGL.GLU import gluNewQuadric, gluSphere

from tests import sweep

from .world import HEIGHT, WIDTH, styled, window

INTERRUPTS = 3000 if sweep.FULL else 100
STYLES = (None, "none", "raskar", "technical", "cartoon", "two_pass", "shadow")
INTEGERS = (
    GL.GL_ATTRIB_STACK_DEPTH, GL.GL_CLIENT_ATTRIB_STACK_DEPTH, GL.GL_MODELVIEW_STACK_DEPTH,
    GL.GL_PROJECTION_STACK_DEPTH, GL.GL_MATRIX_MODE, GL.GL_DRAW_FRAMEBUFFER_BINDING,
    GL.GL_READ_FRAMEBUFFER_BINDING, GL.GL_RENDERBUFFER_BINDING, GL.GL_CURRENT_PROGRAM,
    GL.GL_VERTEX_ARRAY_BINDING, GL.GL_ARRAY_BUFFER_BINDING, GL.GL_TEXTURE_BINDING_2D,
    GL.GL_ACTIVE_TEXTURE, GL.GL_CLIENT_ACTIVE_TEXTURE, GL.GL_RENDER_MODE, GL.GL_DEPTH_FUNC,
    GL.GL_LIST_INDEX, GL.GL_VIEWPORT, GL.GL_COLOR_WRITEMASK, GL.GL_DEPTH_WRITEMASK,
    GL.GL_PACK_ALIGNMENT, GL.GL_PIXEL_PACK_BUFFER_BINDING, GL.GL_READ_BUFFER,
    GL.GL_DEPTH_TEST, GL.GL_BLEND, GL.GL_LIGHTING, GL.GL_CULL_FACE, GL.GL_STENCIL_TEST,
    GL.GL_SCISSOR_TEST, GL.GL_VERTEX_ARRAY, GL.GL_NORMAL_ARRAY, GL.GL_VERTEX_PROGRAM_TWO_SIDE,
)  # fmt: skip


class Interrupt(Exception):
    """Of the program's handler: no more than any other exception to those that catch all."""


class Interrupts:
    """How many were raised, and how many have come through."""

    def __init__(self, kind: type[BaseException]) -> None:
        self.raised = self.caught = 0
        self.kind = kind

    def handler(self, number: int, frame: FrameType | None) -> None:
        self.raised += 1
        raise self.kind

    def after(self, seconds: float, work: Callable[[], None]) -> None:
        """Work that is interrupted then; it must take longer."""
        try:
            signal.setitimer(signal.ITIMER_REAL, seconds)
            work()
        except self.kind:
            self.caught += 1
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)


@pytest.fixture(params=[Interrupt, KeyboardInterrupt, TypeError])
def interrupts(request: pytest.FixtureRequest) -> Iterator[Interrupts]:
    found = Interrupts(request.param)
    before = signal.signal(signal.SIGALRM, found.handler)
    yield found
    signal.setitimer(signal.ITIMER_REAL, 0)
    signal.signal(signal.SIGALRM, before)


def integers() -> list[Any]:
    return [np.asarray(GL.glGetIntegerv(name)).tolist() for name in INTEGERS]


def matrices() -> NDArray[np.float32]:
    names = (GL.GL_MODELVIEW_MATRIX, GL.GL_PROJECTION_MATRIX)
    return np.array([GL.glGetFloatv(name) for name in names])


class Frames:
    """Small frames of all that is followed: immediate mode, lists, arrays, shapes of GLU."""

    def __init__(self, handle: Any) -> None:
        self._handle = handle
        self._quadric = gluNewQuadric()
        self._points = np.array([(-0.9, -0.9, 0), (0, -0.9, 0), (0, 0, 0)], np.float32)
        self._list = GL.glGenLists(1)
        GL.glNewList(self._list, GL.GL_COMPILE)
        self._strip(12, 0.4)
        GL.glEndList()
        # Once: PyOpenGL makes ArgumentErrors of what comes while it looks at an array.
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, self._points)
        GL.glEnable(GL.GL_DEPTH_TEST)
        GL.glClearColor(1, 1, 1, 1)

    def _strip(self, count: int, depth: float) -> None:
        GL.glBegin(GL.GL_TRIANGLE_STRIP)
        for i in range(count):
            GL.glColor3f(0.2, 0.4, 0.8)
            GL.glVertex3f(1.6 * i / count - 0.8, i % 2 - 0.5, depth)
        GL.glEnd()

    def draw(self, turn: int = 0) -> None:
        GL.glNormal3f(0.0, 0.0, 1.0)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        self._strip(150, 0.0)
        self._strip(8, -0.3)
        GL.glCallList(self._list)
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3)
        GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
        gluSphere(self._quadric, 0.3 + turn % 7 * 0.01, 6, 4)

    def many(self) -> None:
        for turn in range(1000):
            self.draw(turn)
            self.present()

    def present(self) -> None:
        glfw.swap_buffers(self._handle)

    def picture(self) -> bytes:
        self.draw()
        found = GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
        self.present()
        return bytes(found)


def alike(found: bytes, right: bytes) -> bool:
    """But for a rounding: what is known of a sphere depends on how large it was first."""
    shades = np.frombuffer(found + right, np.uint8).reshape(2, -1).astype(int)
    return int(np.abs(shades[0] - shades[1]).max()) <= 2


def recover() -> None:
    """What a program does that was interrupted anywhere in its frame."""
    with suppress(GL.GLError):
        GL.glEnd()
    GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
    while GL.glGetError():
        pass


@pytest.mark.parametrize("interrupts", [Interrupt, KeyboardInterrupt], indirect=True)
@pytest.mark.parametrize("style", STYLES)
def test_a_frame_interrupted_anywhere(
    style: str | None, interrupts: Interrupts, capfd: pytest.CaptureFixture[str]
) -> None:
    chance = random.Random(f"{sweep.SEED} {style}")
    with styled(style), window() as handle:
        frames = Frames(handle)
        for _ in range(3):
            frames.picture()
        right, state, places = frames.picture(), integers(), matrices()
        for turn in range(INTERRUPTS):
            interrupts.after(chance.uniform(2e-5, 6e-3), frames.many)
            recover()
            assert integers() == state
            assert (matrices() == places).all()
            if turn % 25 == 24:
                frames.picture()
                assert alike(frames.picture(), right)
        assert alike(frames.picture(), right)
    assert interrupts.raised == interrupts.caught == INTERRUPTS
    assert "glshim" not in capfd.readouterr().err


PIXELS = 100


def _count_in_pixels() -> None:
    """What is drawn from 0 to 1 adds to one row of them."""
    texture = GL.glGenTextures(1)
    GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    GL.glTexImage2D(
        GL.GL_TEXTURE_2D, 0, GL.GL_RGBA32F, PIXELS, 1, 0, GL.GL_RGBA, GL.GL_FLOAT, None
    )
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, GL.glGenFramebuffers(1))
    GL.glFramebufferTexture2D(
        GL.GL_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D, texture, 0
    )
    GL.glBindTexture(GL.GL_TEXTURE_2D, 0)
    GL.glViewport(-PIXELS, 0, 2 * PIXELS, 1)
    GL.glEnable(GL.GL_BLEND)
    GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)


@pytest.mark.parametrize("style", ["none", "raskar"])
@pytest.mark.parametrize("size", [1, 2, 3, 4])
def test_each_vertex_comes_once(style: str, size: int, interrupts: Interrupts) -> None:
    """Each adds one to a pixel of its own: counted are those that an exception came before, or
    after. (In feedback mode nothing is held back.)"""
    calls: dict[int, Callable[[float], None]] = {
        1: lambda x: GL.glVertex2fv((x, 0.0)), 2: lambda x: GL.glVertex2f(x, 0.0),
        3: lambda x: GL.glVertex3f(x, 0.0, 0.0), 4: lambda x: GL.glVertex4f(x, 0.0, 0.0, 1.0),
    }  # fmt: skip
    vertex = calls[size]
    chance = random.Random(f"{sweep.SEED} {size}")
    with styled(style), window():
        _count_in_pixels()
        # The first call makes PyOpenGL's wrapper, and goes through ctypes: what a handler raises
        # while that reads an array is an ArgumentError, as it is in plain.
        GL.glBegin(GL.GL_POINTS)
        vertex(0.0)
        GL.glEnd()
        for _ in range(INTERRUPTS // 2):
            GL.glClear(GL.GL_COLOR_BUFFER_BIT)
            GL.glBegin(GL.GL_POINTS)
            said = 0

            def many() -> None:
                nonlocal said
                while said < 100_000:
                    vertex((said % PIXELS + 0.5) / PIXELS)
                    said += 1

            interrupts.after(chance.uniform(1e-5, 2e-3), many)
            GL.glEnd()
            found = np.asarray(GL.glReadPixels(0, 0, PIXELS, 1, GL.GL_RED, GL.GL_FLOAT)).ravel()
            count = int(found.sum())
            assert count - said in (0, 1)  # the last may be there, and not yet counted
            assert found.tolist() == [(count + PIXELS - 1 - x) // PIXELS for x in range(PIXELS)]
    assert interrupts.raised == interrupts.caught == INTERRUPTS // 2
