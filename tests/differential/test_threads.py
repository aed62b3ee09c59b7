"""Programs with threads beside the one that draws. Two that draw: tests/programs/aimed."""

from __future__ import annotations

import os
import subprocess
import sys
import threading

import pytest

from glshim.bindings.pyopengl.record import Record
from glshim.toolkits import frames

LISTED_FIRST = """
import threading
import glfw
import numpy as np
from OpenGL import GL
threading.Thread(target=threading.Event().wait, daemon=True).start()
glfw.init()
glfw.window_hint(glfw.VISIBLE, 0)
glfw.make_context_current(glfw.create_window(64, 48, "", None, None))
GL.glNewList(1, GL.GL_COMPILE)
GL.glBegin(GL.GL_TRIANGLES)
for corner in ((-0.5, -0.5), (0.5, -0.5), (0.0, 0.5)):
    GL.glVertex2f(*corner)
GL.glEnd()
GL.glEndList()
GL.glEnable(GL.GL_DEPTH_TEST)
GL.glClearColor(1, 1, 1, 1)
GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
GL.glCallList(1)
pixels = GL.glReadPixels(0, 0, 64, 48, GL.GL_RED, GL.GL_UNSIGNED_BYTE)
print((np.frombuffer(pixels, np.uint8) < 60).sum())
"""


@pytest.mark.usefixtures("display")
def test_a_list_is_the_first_that_is_drawn() -> None:
    environ = {**os.environ, "GLSHIM_STYLE": "raskar"}
    done = subprocess.run(
        [sys.executable, "-c", LISTED_FIRST],
        env=environ, capture_output=True, text=True, timeout=120, check=True,
    )  # fmt: skip
    assert int(done.stdout) > 60, done.stderr


def test_each_thread_has_a_primitive_of_its_own() -> None:
    record = Record()
    record.list_open, record.mode, record.aside = True, 7, True
    found: list[object] = []
    other = threading.Thread(
        target=lambda: found.extend((record.list_open, record.mode, record.held, record.aside)))
    other.start()
    other.join()
    assert found == [False, 0, None, True]
    assert (record.list_open, record.mode) == (True, 7)


def test_each_thread_presents_a_drawable_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(frames, "_context_is_current", lambda: True)
    both = threading.Barrier(2, timeout=10)
    found: dict[int, list[frames.Size | None]] = {}

    def look() -> None:
        found.setdefault(threading.get_ident(), []).append(frames.drawable_size())
        both.wait()

    def show(size: frames.Size) -> None:
        frames.present(both.wait, on=frames.Drawable(lambda: size))
        found[threading.get_ident()].append(size)

    listener = frames.listen(frames.Stage.DRAW, before=look, after=look)
    try:
        threads = [threading.Thread(target=show, args=((n, n),)) for n in (1, 2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    finally:
        listener.stop()
    assert sorted(found.values()) == [[(1, 1)] * 3, [(2, 2)] * 3]
