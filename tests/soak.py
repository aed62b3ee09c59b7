"""A program that runs for long, in contexts that come and go: `python -m tests.soak --help`.

Says how much memory the process holds as it goes, and ends with 1 where that grows by more than
2 MB after the first fifth.
"""

from __future__ import annotations

import argparse
import ctypes
import gc
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from typing import Any

import glfw
import numpy as np
from OpenGL import GL
from OpenGL.arrays import vbo
from OpenGL.GLU import gluDeleteQuadric, gluNewQuadric, gluSphere

import glshim
from glshim.running.headless import virtual_screen

SIDE = 64
"""Pixels of a window."""
MOST = 2 << 20
"""Bytes that memory may grow by."""
SAMPLES = 20


def window(share: Any = None) -> Any:
    """A hidden window, current."""
    glfw.default_window_hints()
    glfw.window_hint(glfw.VISIBLE, 0)
    made = glfw.create_window(SIDE, SIDE, "soak", None, share)
    if not made:
        raise RuntimeError("no window")
    glfw.make_context_current(made)
    glfw.swap_interval(0)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glClearColor(1.0, 1.0, 1.0, 1.0)
    return made


def cube(edge: float) -> list[tuple[float, float, float]]:
    """The corners of its six faces."""
    found = []
    for axis in range(3):
        for side in (-1, 1):
            for a, b in [(-1, -1), (1, -1), (1, 1), (-1, 1)][::side]:
                point = [0.0, 0.0, 0.0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, a, b
                found.append((edge * point[0], edge * point[1], edge * point[2]))
    return found


def immediate(edge: float) -> None:
    """A cube between glBegin and glEnd."""
    GL.glBegin(GL.GL_QUADS)
    for point in cube(edge):
        GL.glVertex3f(*point)
    GL.glEnd()


def compiled(name: int, edge: float) -> None:
    """A list of a cube."""
    GL.glNewList(name, GL.GL_COMPILE)
    immediate(edge)
    GL.glEndList()


def buffered(buffer: vbo.VBO) -> None:
    """A cube in a buffer."""
    with buffer:
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, buffer)
        GL.glDrawArrays(GL.GL_QUADS, 0, 24)
        GL.glDisableClientState(GL.GL_VERTEX_ARRAY)


class Still:
    """What a program makes once in a context, and draws in each frame."""

    def __init__(self) -> None:
        self._list = int(GL.glGenLists(1))
        compiled(self._list, 0.3)
        self._buffer = vbo.VBO(np.array(cube(0.2), np.float32))

    def draw(self, number: int) -> None:
        GL.glRotatef(number % 360, 1.0, 1.0, 0.0)
        immediate(0.5)
        GL.glCallList(self._list)
        buffered(self._buffer)

    def close(self) -> None:
        """Before its context goes."""
        GL.glDeleteLists(self._list, 1)
        self._buffer.delete()


class Fresh:
    """Made, drawn and deleted in each frame, another shape each time; a list is compiled again."""

    def __init__(self) -> None:
        self._again = int(GL.glGenLists(1))

    def draw(self, number: int) -> None:
        edge = 0.2 + number % 1009 / 2500
        GL.glRotatef(number % 360, 1.0, 1.0, 0.0)
        name = int(GL.glGenLists(1))
        compiled(name, edge)
        compiled(self._again, 0.9 * edge)
        GL.glCallLists([name, self._again])
        GL.glDeleteLists(name, 1)
        buffer = vbo.VBO(np.array(cube(0.8 * edge), np.float32))
        buffered(buffer)
        buffer.delete()
        texture = int(GL.glGenTextures(1))
        GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
        pixels = bytes(3 * 16 * 16)
        GL.glTexImage2D(
            GL.GL_TEXTURE_2D, 0, GL.GL_RGB, 16, 16, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, pixels
        )
        GL.glDeleteTextures([texture])
        quadric = gluNewQuadric()
        gluSphere(quadric, 0.5 * edge, 5 + number % 3, 4)
        gluDeleteQuadric(quadric)

    def close(self) -> None:
        GL.glDeleteLists(self._again, 1)


class Offscreen(Still):
    """Each frame is drawn into a framebuffer object of its own first, of another size."""

    def draw(self, number: int) -> None:
        width, height = 16 + number % 48, 16 + number * 7 % 48
        frame, colour, depth = (
            int(GL.glGenFramebuffers(1)), *map(int, GL.glGenRenderbuffers(2)),
        )  # fmt: skip
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, frame)
        for name, kind, place in (
            (colour, GL.GL_RGBA8, GL.GL_COLOR_ATTACHMENT0),
            (depth, GL.GL_DEPTH_COMPONENT24, GL.GL_DEPTH_ATTACHMENT),
        ):
            GL.glBindRenderbuffer(GL.GL_RENDERBUFFER, name)
            GL.glRenderbufferStorage(GL.GL_RENDERBUFFER, kind, width, height)
            GL.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, place, GL.GL_RENDERBUFFER, name)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glViewport(0, 0, width, height)
        super().draw(number)
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, 0)
        GL.glDeleteFramebuffers(1, [frame])
        GL.glDeleteRenderbuffers(2, [colour, depth])
        GL.glViewport(0, 0, SIDE, SIDE)
        super().draw(number)


SCENES: dict[str, Callable[[], Any]] = {"still": Still, "fresh": Fresh, "offscreen": Offscreen}


def frames(
    count: int, every: int, scene: str, *, share: bool = False, resize: bool = False
) -> Iterator[int]:
    """Frames by their numbers, each drawn and presented; with a new context after so many, which
    shares objects with one that stays."""
    root = window() if share else None
    current, drawn = window(root), SCENES[scene]()
    for number in range(count):
        if number and every and number % every == 0:
            drawn.close()
            glfw.destroy_window(current)
            current, drawn = window(root), SCENES[scene]()
        if resize and number % 8 == 0:
            width, height = 32 + number * 5 % 300, 32 + number * 3 % 200
            glfw.set_window_size(current, width, height)
            GL.glViewport(0, 0, width, height)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glLoadIdentity()
        drawn.draw(number)
        glfw.swap_buffers(current)
        glfw.poll_events()
        yield number
    for each in filter(None, (current, root)):
        glfw.destroy_window(each)


def resident() -> int:
    """Bytes of memory that this process holds, without what malloc keeps for later."""
    gc.collect()
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if trim is not None:
        trim(0)
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.soak", description=__doc__)
    parser.add_argument("--frames", type=int, default=20_000, metavar="N")
    parser.add_argument("--context-every", type=int, default=250, metavar="N",
                        help="frames in each context; 0: all in one")  # fmt: skip
    parser.add_argument("--style", default="raskar", help="or `plain`: without glshim")
    parser.add_argument("--scene", default="still", choices=SCENES)
    parser.add_argument("--share", action="store_true", help="contexts share with one that stays")
    parser.add_argument("--resize", action="store_true", help="the window has many sizes")
    given = parser.parse_args(arguments)
    held = []
    with ExitStack() as stack:
        if "DISPLAY" not in os.environ:
            os.environ.update(stack.enter_context(virtual_screen()))
        if not glfw.init():
            raise RuntimeError("glfw found no display")
        if given.style != "plain":
            glshim.install(given.style)
        step = max(given.frames // SAMPLES, 1)
        for number in frames(
            given.frames, given.context_every, given.scene,
            share=given.share, resize=given.resize,
        ):  # fmt: skip
            if (number + 1) % step == 0:
                held.append(resident())
                print(f"frame {number + 1:7}: {held[-1] / 2**20:7.2f} MB", flush=True)
        glshim.uninstall()
    grown = held[-1] - held[len(held) // 5]
    print(f"{given.style}, {given.scene}: grown by {grown / 2**20:.2f} MB after the warm-up")
    return int(grown > MOST)


if __name__ == "__main__":
    sys.exit(main())
