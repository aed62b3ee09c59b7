"""A scene run in a window of its own: what the app saw, the picture, and every state it left.

The same scene is run plain and under a style in one process; nothing may differ.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import glfw
from OpenGL import GL
from OpenGL.raw.GL import _errors

import glshim
from glshim.checks.observe import App, Outcome
from glshim.checks.observe import observe as look_around
from glshim.styling.protocol import Styler

WIDTH, HEIGHT = 96, 72
Scene = Callable[[App], None]


@contextmanager
def window(
    width: int = WIDTH, height: int = HEIGHT, share: Any = None, **hints: int
) -> Iterator[Any]:
    """A hidden window with a current context of its own."""
    if not glfw.init():
        raise RuntimeError("glfw found no display")
    glfw.default_window_hints()
    for name, value in {"VISIBLE": 0, "STENCIL_BITS": 8, **hints}.items():
        glfw.window_hint(getattr(glfw, name), value)
    handle = glfw.create_window(width, height, "scene", None, share)
    if not handle:
        raise RuntimeError(f"no window with {hints}")
    glfw.make_context_current(handle)
    try:
        yield handle
    finally:
        glfw.destroy_window(handle)
        glfw.make_context_current(None)


@contextmanager
def styled(style: str | Styler | None) -> Iterator[None]:
    """glshim installed in a style, or not at all for None."""
    _errors._error_checker.onEnd()
    if style is not None:
        glshim.install(style)
    try:
        yield
    finally:
        glshim.uninstall()
        _errors._error_checker.onEnd()


def run(scene: Scene, style: str | Styler | None = None) -> Outcome:
    """The scene in a fresh window."""
    app = App()
    with styled(style), window() as handle:
        prepare()
        scene(app)
        outcome = observe(app)
        glfw.swap_buffers(handle)
    return outcome


def prepare() -> None:
    """A picture that shows differences: perspective, depth test, grey ground."""
    GL.glClearColor(0.5, 0.5, 0.5, 1.0)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT | GL.GL_STENCIL_BUFFER_BIT)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glFrustum(-1.0, 1.0, -0.75, 0.75, 2.0, 20.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glTranslatef(0.0, 0.0, -5.0)


def restart_at(index: int) -> None:
    """Primitives begin anew at an index, where this version (3.1) knows such a thing."""
    if GL.glGetString(GL.GL_VERSION)[:3] >= b"3.1":
        GL.glEnable(GL.GL_PRIMITIVE_RESTART)
        GL.glPrimitiveRestartIndex(index)


def observe(app: App) -> Outcome:
    """What there is to see at the end of a scene, errors fetched by the app's own means."""
    return look_around(app, WIDTH, HEIGHT)
