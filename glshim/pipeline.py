"""The composition root: app call -> capture -> assembly -> styler -> render -> frame."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from .assembly.batch import Wanted
from .capture import frames
from .capture.clibraries import C_LIBRARIES
from .capture.raw import RAW
from .capture.recorder import RECORDER
from .capture.state import light
from .capture.watch import WATCH
from .errors import RenderError
from .following.follower import Follower
from .following.scene import Scene, integer, say_unstyled
from .notices import say_fault
from .render.backend import Backend
from .render.fixed import FixedPen
from .render.surface import Surface
from .spec.driver import current_context
from .styling.protocol import BackFaces, Layer, Styler

_DOUBLE_BUFFER = 0x0C32


class Pipeline:
    """Follows the app's draws and adds a styler's at the end of each layer."""

    def __init__(self, styler: Styler) -> None:
        self.styler = styler
        self._surface = Surface(styler.surface)
        wanted = Wanted(colours=styler.wants_colours, normals=styler.wants_normals,
                        lights=styler.wants_lights)  # fmt: skip
        self._follower = Follower(self, wanted)
        self._broken = False

    # -- life ------------------------------------------------------------------------------------

    def start(self) -> None:
        """Follow from now on."""
        WATCH.attach(self._follower)
        C_LIBRARIES.attach(self._follower)
        frames.install(self._follower.finish_frame)

    def stop(self) -> None:
        """Follow no more; what is pending is dropped."""
        frames.uninstall(self._follower.finish_frame)
        C_LIBRARIES.detach()
        WATCH.detach()
        self._surface.uncover()

    def release(self) -> None:
        """Give back what the current context holds for this style alone."""
        self._surface.release()

    def give_up(self, error: BaseException) -> None:
        """A fault in the shim or in a styler: said once with its traceback, styling ends."""
        if not self._broken:
            self._broken = True
            say_fault(f"style {self.styler.name!r} is switched off, the program runs on", error)
            self.stop()

    # -- flow: what the follower hands on --------------------------------------------------------

    def cover(self) -> None:
        """Before the app draws polygons that carry lines: the styler's surface."""
        if self._surface.changes:
            self._surface.cover()

    def uncover(self) -> None:
        """After it."""
        if self._surface.changes:
            self._surface.uncover()

    def context_renewed(self) -> None:
        """A context that is gone left its address to a new one."""
        self._surface.forget()

    def layer_ends(self, scene: Scene) -> None:
        """A layer's depth is final: the styler says what to add, the backend adds it."""
        over, fresh, lighting = scene.layer.over, scene.layer.fresh, scene.layer.lighting
        items = scene.layer.take()
        if not items:
            return
        now = time.monotonic()
        draws = list(self.styler.draws(Layer(items, light(), over, fresh, now, lighting)))
        if not draws:
            return
        try:
            fixed = [draw for draw in draws if isinstance(draw, BackFaces)]
            others = [draw for draw in draws if not isinstance(draw, BackFaces)]
            if fixed:
                scene.mark()
                _FIXED.render(fixed)
            if others:
                _backend(scene).render(others)
        except RenderError as error:
            scene.refused = str(error)
            say_unstyled(str(error))

    def flush(self, call: Callable[[], Any], scene: Scene | None) -> Any:
        """glFlush and glFinish end the frame of a single-buffered or off-screen context."""
        if scene is None or scene.refused or integer(_DOUBLE_BUFFER):
            return call()
        return frames.present(call)


_FIXED = FixedPen()
_current: Pipeline | None = None
_backends: dict[int, tuple[Scene, Backend]] = {}
"""By context, with the scene that each was made for, which knows when its context is gone. They
outlive a style: switching styles makes no new buffers and programs."""


def _backend(scene: Scene) -> Backend:
    """The current context's backend."""
    handle = current_context()
    # Asked before the new scene leaves its mark: in another context that may have the same name.
    owner, backend = _backends.get(handle, (scene, None))
    if backend is None or owner.stale:
        backend = Backend.attach()
        _backends[handle] = scene, backend
    scene.mark()
    return backend


def install(style: str | Styler) -> None:
    """Restyle this process's OpenGL from now on, in a style given as text or as a styler.

    May be called before or after the app has imported PyOpenGL, and again with another style.
    Raises StyleError for a text that names no style; nothing is installed then.
    """
    global _current
    if isinstance(style, str):
        from .options import parse_style

        style = parse_style(style)
    if _current is not None:
        _current.stop()
        _current.release()
        _current = None
    if not RAW.installed:
        RAW.install()
        RECORDER.install()
        WATCH.install()
    if style.wants_polygons:
        _current = Pipeline(style)
        _current.start()


def uninstall() -> None:
    """Leave PyOpenGL and the toolkits as they were found."""
    global _current
    if _current is not None:
        _current.stop()
        _current.release()
        _current = None
    if RAW.installed:
        WATCH.uninstall()
        RECORDER.uninstall()
        RAW.uninstall()
