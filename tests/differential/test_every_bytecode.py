"""A signal comes at one bytecode after the other, of the program's and of ours below it.

The program finds what it would find plain, had it come at that line of its own.
"""

from __future__ import annotations

import random
import signal
import sys
from collections.abc import Callable, Iterator
from types import FrameType
from typing import Any

import numpy as np
import pytest
from OpenGL import GL

from glshim.toolkits import frames
from tests import sweep

from .test_interrupts import Frames, Interrupt, alike, integers, matrices
from .world import styled, window

POINTS = 2500 if sweep.FULL else 45
OURS = ("glshim", "glshim_stylers")
Found = tuple[Any, ...]


class Bytecodes:
    """Counts the bytecodes of some work, and sends a signal at one of them."""

    def __init__(self, names: tuple[str, ...], at: int = -1) -> None:
        self.names, self.at, self.seen = names, at, 0

    def trace(self, frame: FrameType, event: str, arg: Any) -> Callable[..., Any] | None:
        module = str(frame.f_globals.get("__name__"))
        if module != __name__ and module.partition(".")[0] not in self.names:
            return None
        if frame.f_code is Bytecodes.during.__code__:
            return None
        if event == "opcode":
            self.seen += 1
            if self.seen == self.at:
                signal.raise_signal(signal.SIGUSR1)
        else:
            frame.f_trace_opcodes = True
        return self.trace

    def during(self, work: Callable[[], None]) -> BaseException | None:
        """What the work raised."""
        sys.settrace(self.trace)
        try:
            work()
        except Interrupt as raised:
            return raised
        finally:
            sys.settrace(None)
        return None


def handler(number: int, frame: FrameType | None) -> None:
    raise Interrupt


@pytest.fixture(autouse=True)
def _handled() -> Iterator[None]:
    before = signal.signal(signal.SIGUSR1, handler)
    yield
    signal.signal(signal.SIGUSR1, before)


class Program:
    """Draws in every way; each line makes one call."""

    def __init__(self, handle: Any) -> None:
        self.frames = Frames(handle)
        self.points = np.array([(-0.9, -0.9, 0), (0, -0.9, 0), (0, 0, 0)], np.float32)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, self.points)
        self.list = GL.glGenLists(1)

    def frame(self) -> None:
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glPushMatrix()
        GL.glTranslatef(0.1, 0.0, 0.0)
        GL.glBegin(GL.GL_TRIANGLE_STRIP)
        GL.glColor3f(0.2, 0.4, 0.8)
        GL.glVertex3f(-0.8, -0.5, 0.0)
        GL.glColor3ub(40, 50, 60)
        GL.glVertex3fv([0.8, -0.5, 0.0])
        GL.glVertex3fv(self.points[2])
        GL.glMaterialf(GL.GL_FRONT, GL.GL_SHININESS, 3.0)
        GL.glVertex3d(np.float64(0.8), 0.5, 0)
        GL.glEnd()
        GL.glNewList(self.list, GL.GL_COMPILE)
        GL.glBegin(GL.GL_TRIANGLES)
        GL.glVertex2f(-0.5, -0.5)
        GL.glVertex2f(0.5, -0.5)
        GL.glVertex2f(0.0, 0.5)
        GL.glEnd()
        GL.glEndList()
        GL.glCallList(self.list)
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3)
        GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
        GL.glRectf(-0.3, -0.3, 0.3, 0.3)
        GL.glPopMatrix()
        GL.glFlush()

    def left(self) -> Found:
        """What it finds after it was interrupted; all is as at the beginning then."""
        ends = []
        for end in (GL.glEnd, GL.glEndList):
            try:
                end()
                ends.append(0)
            except GL.GLError as error:
                ends.append(int(error.err))
        found = (*ends, tuple(map(str, integers())), matrices().tobytes(),
                 GL.glGetFloatv(GL.GL_CURRENT_COLOR).tobytes())  # fmt: skip
        while GL.glGetIntegerv(GL.GL_MODELVIEW_STACK_DEPTH) > 1:
            GL.glPopMatrix()
        GL.glLoadIdentity()
        GL.glColor3f(1.0, 1.0, 1.0)
        GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
        GL.glNewList(self.list, GL.GL_COMPILE)
        GL.glEndList()
        while GL.glGetError():
            pass
        return found


def line_of(error: BaseException) -> int:
    """Of `Program.frame`, where an exception came through."""
    trace = error.__traceback__
    while trace is not None:
        if trace.tb_frame.f_code is Program.frame.__code__:
            return trace.tb_lineno
        trace = trace.tb_next
    return 0


def total(program: Program, names: tuple[str, ...]) -> int:
    counted = Bytecodes(names)
    counted.during(program.frame)
    program.left()
    return counted.seen


def plain_lines() -> dict[int, set[Found]]:
    """By line of the program, what is found where it is interrupted there."""
    found: dict[int, set[Found]] = {}
    with styled(None), window() as handle:
        program = Program(handle)
        for _ in range(3):
            program.frame()
            program.left()
            program.frames.picture()
        for at in range(1, total(program, ()) + 1):
            raised = Bytecodes((), at).during(program.frame)
            assert raised is not None
            found.setdefault(line_of(raised), set()).add(program.left())
    return found


@pytest.fixture(scope="module")
def lines() -> dict[int, set[Found]]:
    signal.signal(signal.SIGUSR1, handler)
    return plain_lines()


@pytest.mark.parametrize("style", ["none", "raskar", "cartoon"])
def test_a_signal_at_any_bytecode(
    style: str, lines: dict[int, set[Found]], capfd: pytest.CaptureFixture[str]
) -> None:
    chance = random.Random(f"{sweep.SEED} {style}")
    with styled(style), window() as handle:
        program = Program(handle)
        for _ in range(3):
            program.frame()
            program.left()
            program.frames.picture()
        right = program.frames.picture()
        count = total(program, OURS)
        points = sorted(chance.sample(range(1, count + 1), min(POINTS, count)))
        for at in points:
            raised = Bytecodes(OURS, at).during(program.frame)
            left = program.left()
            if raised is not None:  # at the end of the frame, fewer bytecodes may be left
                line = line_of(raised)
                near = lines.get(line, set()) | lines.get(line + 1, set())
                assert left in near, f"bytecode {at} of {count}, line {line}: {left} {near}"
        program.frames.picture()
        assert alike(program.frames.picture(), right)
    assert [line for line in capfd.readouterr().err.splitlines() if "glshim" in line] == []


def test_a_frame_that_is_about_to_be_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    """Interrupted at any bytecode before that, it is not being shown any more."""
    monkeypatch.setattr(frames, "_context_is_current", lambda: True)
    listener = frames.listen(frames.Stage.DRAW, before=lambda: None)
    on = frames.Drawable(lambda: (3, 4))
    counted, swapped = Bytecodes(OURS), list[int]()
    try:
        counted.during(lambda: frames.present(lambda: swapped.append(counted.seen), on=on))
        for at in range(1, swapped[0]):
            Bytecodes(OURS, at).during(lambda: frames.present(lambda: None, on=on))
            assert (frames.drawable_size(), frames._showing) == (None, set()), at
    finally:
        listener.stop()
