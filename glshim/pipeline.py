"""The composition root, read from top to bottom:

    program -> bindings -> sources -> layer -> styler -> linework -> outputs

A binding hears the program's calls, the follower turns them into layers of polygons, the styler
says what to draw of a layer, and the output finds its lines and draws them.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from glshim import toolkits
from glshim.bindings.base import Binding
from glshim.bindings.pyopengl.binding import PYOPENGL
from glshim.errors import RenderError
from glshim.model.batch import Wanted
from glshim.notices import say_fault
from glshim.outputs.gl.backend import Backend
from glshim.outputs.gl.fixed import FixedPen
from glshim.outputs.gl.frame.cover import Cover
from glshim.outputs.gl.frame.sheet import SHEET
from glshim.sources.fixed.lights import light
from glshim.sources.following.follower import Follower
from glshim.sources.following.layers import FinishedLayer
from glshim.sources.following.scene import Scene, say_unstyled
from glshim.spec.ask import integer
from glshim.spec.constants import GL_DOUBLEBUFFER
from glshim.spec.driver import current_context
from glshim.styling.protocol import BackFaces, Layer, Lines, Pass, Styler
from glshim.toolkits import Part, frames

BINDING: Binding = PYOPENGL
"""How the program speaks OpenGL."""


@dataclass(slots=True)
class Counted:
    """What one frame was made of."""

    polygons: int = 0
    """Of the app's, that carry lines."""
    draws: int = 0
    """Of the styler's."""


class Pipeline:
    """From the program's calls to what a styler adds at the end of each layer: a
    `glshim.sources.following.follower.LayerSink`.

    Following outlives a style: display lists and buffers that were made under one, or under none,
    are known to the next.
    """

    def __init__(self) -> None:
        self.styler: Styler | None = None
        """Whose draws are added; None: nobody's, and every frame is the app's own."""
        self.live = False
        """Whether another style may come: a fault ends the one that it befell, not the following.
        """
        self.counted = Counted()
        """The frame so far; whole when the listeners of later stages are called."""
        self._cover = Cover()
        self._follower = Follower(BINDING.stream, self)
        self._broken = False
        self._listener: frames.Listener | None = None
        self._next: tuple[Styler | None] | None = None

    # -- program, bindings, sources --------------------------------------------------------------

    def start(self) -> None:
        """Follow the program from now on."""
        BINDING.attach(self._follower)
        self._listener = frames.listen(
            frames.Stage.DRAW, before=self._follower.finish_frame, after=self._frame_over
        )
        toolkits.watch(Part.FRAMES)

    def use_style(self, styler: Styler | None) -> None:
        """Draw in this style from now on; what is pending is dropped."""
        self._next = None
        if styler is not None and not styler.wants_polygons:
            styler = None
        self.styler = styler
        self._cover.set_surface(styler.surface if styler is not None else "app")
        self._follower.restyle(_wanted(styler) if styler is not None else None)

    def use_style_next(self, styler: Styler | None) -> None:
        """From the next frame on. Calls no GL: any thread may say so at any time."""
        self._next = (styler,)

    # -- layer, styler, outputs: what the follower hands on --------------------------------------

    def cover(self) -> None:
        """Before the app draws polygons that carry lines: the styler's surface."""
        self._cover.cover()

    def uncover(self) -> None:
        """After it."""
        self._cover.uncover()

    def layer_ends(self, finished: FinishedLayer, scene: Scene) -> None:
        """A layer's depth is final: the styler says what to add, the output adds it."""
        if self.styler is None:
            return
        layer = Layer(
            finished.items, light(), finished.over, finished.fresh, time.monotonic(),
            finished.lighting, SHEET.scale,
        )  # fmt: skip
        try:
            self._put_out(list(self.styler.draws(layer)), layer, scene)
        except Exception as error:
            if not self.live:
                raise
            say_fault(f"style {self._name!r} fails and is switched off: {error!r}", error)
            self.use_style(None)

    def _put_out(
        self, draws: list[Lines | Pass | BackFaces], layer: Layer, scene: Scene
    ) -> None:
        self.counted.polygons += sum(batch.polygon_count for batch, _ in layer.items)
        self.counted.draws += sum(map(_count, draws))
        fixed = [draw for draw in draws if isinstance(draw, BackFaces)]
        others = [draw for draw in draws if not isinstance(draw, BackFaces)]
        try:
            if fixed:
                scene.mark()
                _FIXED.render(fixed)
            if others:
                _backend(scene).render(others)
        except RenderError as error:
            scene.unpainted = str(error)
            say_unstyled(str(error))

    def flush(self, call: Callable[[], Any]) -> Any:
        """glFlush and glFinish end the frame of a single-buffered or off-screen context."""
        return call() if _is_double_buffered() else frames.present(call)

    def _frame_over(self) -> None:
        """A frame was presented."""
        self.counted = Counted()
        if self._next is not None:
            self.use_style(*self._next)

    # -- its end ---------------------------------------------------------------------------------

    @property
    def broken(self) -> bool:
        """Following has ended, by a fault."""
        return self._broken

    def context_renewed(self) -> None:
        """A context that is gone left its address to a new one."""
        self._cover.forget()

    def give_up(self, error: BaseException) -> None:
        """A fault in the shim or in a styler: said once with its traceback, styling ends."""
        if not self._broken:
            self._broken = True
            say_fault(f"style {self._name!r} is switched off, the program runs on", error)
            self.stop()

    def stop(self) -> None:
        """Follow no more; what is pending is dropped."""
        if self._listener is not None:
            self._listener.stop()
        BINDING.detach()
        self._cover.uncover()

    def release(self) -> None:
        """Give back what the current context holds for this style alone."""
        self._cover.release()

    @property
    def _name(self) -> str:
        return self.styler.name if self.styler is not None else "none"


def _wanted(styler: Styler) -> Wanted:
    """What its polygons shall come with."""
    return Wanted(
        colours=styler.wants_colours, normals=styler.wants_normals, lights=styler.wants_lights
    )


def _count(draw: Lines | Pass | BackFaces) -> int:
    """Of a pass one, of lines one a batch."""
    return 1 if isinstance(draw, Pass) else sum(len(body.batches) for body in draw.bodies)


def _is_double_buffered() -> bool:
    """Whether the window that is drawn to is."""
    return bool(integer(GL_DOUBLEBUFFER)) if _told_double is None else _told_double


def tell_double_buffered(double: bool) -> None:
    """Whether the window is, in the driver's place: a shot draws elsewhere, and knows."""
    global _told_double
    _told_double = double


_told_double: bool | None = None
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


def install(style: str | Styler, *, live: bool = False) -> None:
    """Restyle this process's OpenGL from now on, in a style given as text or as a styler.

    May be called before or after the app has imported PyOpenGL, and again with another style, which
    knows the display lists and buffers that the first one saw made. live: they are followed even
    while the style draws nothing, for one that comes later, by `switch` or by another call.
    Raises StyleError for a text that names no style; nothing is installed then.
    """
    global _current
    if isinstance(style, str):
        from glshim.styling.texts import parse_style

        style = parse_style(style)
    if not BINDING.installed:
        BINDING.install()
    if _current is None or _current.broken:
        if not style.wants_polygons and not live:
            return
        _current = Pipeline()
        _current.start()
    _current.live = _current.live or live
    _current.use_style(style)


def switch(styler: Styler | None) -> None:
    """Draw in another style from the next frame on, or (None) leave the app's picture as it is.

    Any thread may call it at any time; the last call before a frame ends counts. What lists and
    buffers hold is known from :func:`install` with ``live=True`` on, which comes first: without it,
    or after a fault that ended the following, nothing happens.
    """
    if _current is not None:
        _current.use_style_next(styler)


def current() -> Styler | None:
    """The style that draws now, None where none does."""
    return _current.styler if _current is not None and not _current.broken else None


def counted() -> Counted:
    """What the frame that ends now is made of: for who listens to frame ends after `Stage.DRAW`."""
    return _current.counted if _current is not None else Counted()


def revise(change: Callable[[Styler], Styler]) -> None:
    """Draw from now on as a styler of the same class that is made of the current one."""
    if _current is not None and _current.styler is not None:
        _current.styler = change(_current.styler)


def uninstall() -> None:
    """Leave PyOpenGL and the toolkits as they were found."""
    global _current
    if _current is not None:
        _current.stop()
        _current.release()
        _current = None
    if BINDING.installed:
        BINDING.uninstall()
    toolkits.release()
