"""A signal comes while a display list compiles, at one bytecode of ours after the other at which
Python looks for signals: what the driver has in the list, we have."""

from __future__ import annotations

import dis
import os
import random
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from types import CodeType, FrameType
from typing import Any

import glfw
import numpy as np
from OpenGL import GL
from OpenGL.GLU import gluNewQuadric, gluSphere

from tests import sweep
from tests.differential.test_every_bytecode import OURS, Bytecodes, handler
from tests.differential.world import styled, window

POINTS = 2500 if sweep.FULL else 30
CELLS, SIDE = 6, 24
"""Shapes beside each other, and the pixels of each."""
TRIANGLE = np.array([(0.2, 0.2, 0), (0.8, 0.2, 0), (0.5, 0.8, 0)], np.float32)


@cache
def heard_at(code: CodeType) -> frozenset[int]:
    """Offsets at which Python looks for signals, from 3.11 on nowhere else: behind calls, where
    loops begin anew, and where a function begins."""
    found, behind = set(), True
    for each in dis.get_instructions(code):
        if behind and each.opname not in ("CACHE", "RESUME"):
            found.add(each.offset)
            behind = False
        if each.opname.startswith("CALL") or each.opname == "RESUME":
            behind = True
        elif each.opname.startswith("JUMP") and each.argval <= each.offset:
            found.add(each.argval)
    return frozenset(found)


class Heard(Bytecodes):
    """Counts those bytecodes alone."""

    def trace(self, frame: FrameType, event: str, arg: Any) -> Callable[..., Any] | None:
        if event == "opcode" and frame.f_lasti not in heard_at(frame.f_code):
            return self.trace
        return super().trace(frame, event, arg)


def step() -> None:
    GL.glTranslatef(1.0, 0.0, 0.0)


def spoken() -> None:
    GL.glBegin(GL.GL_TRIANGLES)
    for x, y, z in TRIANGLE.tolist():
        GL.glVertex3f(x, y, z)
    GL.glEnd()


class Program:
    """Compiles shapes one beside the other, in every way that a list has."""

    def __init__(self) -> None:
        self._quadric = gluNewQuadric()
        GL.glClearColor(1, 1, 1, 1)
        GL.glEnable(GL.GL_DEPTH_TEST)
        GL.glMatrixMode(GL.GL_PROJECTION)
        GL.glOrtho(0, CELLS, 0, 1, -5, 5)
        GL.glMatrixMode(GL.GL_MODELVIEW)
        GL.glColor3f(0.4, 0.9, 0.6)
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, TRIANGLE)
        self._inner, self._list = (GL.glGenLists(1) for _ in range(2))
        GL.glNewList(self._inner, GL.GL_COMPILE)
        spoken()
        GL.glEndList()

    def shapes(self) -> list[Callable[[], None]]:
        return [
            spoken, lambda: GL.glRectf(0.2, 0.2, 0.8, 0.8),
            lambda: GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3), lambda: GL.glCallList(self._inner),
            self._ball, spoken,
        ]  # fmt: skip

    def _ball(self) -> None:
        GL.glTranslatef(0.5, 0.5, 0.0)
        gluSphere(self._quadric, 0.3, 6, 4)
        GL.glTranslatef(-0.5, -0.5, 0.0)

    def compile(self) -> None:
        GL.glNewList(self._list, GL.GL_COMPILE)
        for shape in self.shapes():
            shape()
            step()
        GL.glEndList()

    def recover(self) -> None:
        """After an interrupt, anywhere."""
        for end in (GL.glEnd, GL.glEndList):
            with suppress(GL.GLError):
                end()

    def half_lined(self, show: Callable[[], None]) -> list[int]:
        """Cells whose shape is there without lines."""
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glPushMatrix()
        with suppress(GL.GLError):  # a glEnd too many, as `recover` says it
            GL.glCallList(self._list)
        self.recover()
        GL.glPopMatrix()
        size = CELLS * SIDE, SIDE
        pixels = GL.glReadPixels(0, 0, *size, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
        shades = np.frombuffer(pixels, np.uint8).reshape(SIDE, CELLS, SIDE, 3).astype(int)
        show()
        green = (abs(shades - (102, 230, 153)).max(3) < 6).sum((0, 2))
        ink = (shades.max(3) < 60).sum((0, 2))
        return [int(cell) for cell in range(CELLS) if green[cell] > 20 and ink[cell] < 20]


def main() -> None:
    """Print at which bytecodes a signal loses lines, and of which cells."""
    signal.signal(signal.SIGUSR1, handler)
    chance = random.Random(f"{sweep.SEED} lists")
    with styled("raskar"), window(CELLS * SIDE, SIDE) as handle:
        program = Program()

        def show() -> None:
            glfw.swap_buffers(handle)

        counted = Heard(OURS)
        for _ in range(2):
            program.compile()
            assert program.half_lined(show) == []
        counted.during(program.compile)
        lost: dict[int, list[int]] = {}
        for at in sorted(chance.sample(range(1, counted.seen + 1), min(POINTS, counted.seen))):
            raised = Heard(OURS, at).during(program.compile)
            if raised is not None:
                program.recover()
            found = program.half_lined(show)
            if found:
                lost[at] = found
        print(f"{lost} of {counted.seen}")


def test_what_is_in_a_list_is_known(display: str) -> None:
    # In a process of its own: others leave functions hooked, or not, that are counted here.
    done = subprocess.run(
        [sys.executable, "-m", "tests.differential.test_interrupted_lists"],
        env={**os.environ, "DISPLAY": display}, capture_output=True, text=True, timeout=600,
        check=True,
    )  # fmt: skip
    assert done.stdout.startswith("{} of "), done.stdout
    assert "glshim" not in done.stderr


if __name__ == "__main__":
    main()
