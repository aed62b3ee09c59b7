"""The composition root, read from top to bottom:

    program -> bindings -> sources -> layer -> styler -> linework -> outputs

A binding hears the program's calls, the follower turns them into layers of polygons, the styler
says what to draw of a layer, and the output finds its lines and draws them.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial

from glshim import toolkits
from glshim.bindings.base import Binding, Watcher
from glshim.bindings.pyopengl.binding import PYOPENGL
from glshim.model.boxes import Box, Unbacked
from glshim.model.lights import MaterialChange, Materials
from glshim.notices import say_fault
from glshim.outputs.gl.picture import Picture
from glshim.outputs.output import WINDOW, Destination, Given, Ink, Output
from glshim.outputs.several import Refused, Several
from glshim.sources.following.census import Census
from glshim.sources.following.follower import Follower
from glshim.sources.following.layers import FinishedLayer
from glshim.sources.following.ownink import Run
from glshim.sources.following.scene import Scene, say_unstyled
from glshim.sources.following.silence import Silence
from glshim.sources.lights import light
from glshim.sources.state import DrawState
from glshim.spec.roles import Role
from glshim.styling.asking import inks_of, wanted
from glshim.styling.enlarging import enlarged
from glshim.styling.protocol import PAINTED, Layer, Pass, Styler
from glshim.styling.values import Colour
from glshim.system import modules
from glshim.system.ending import at_end
from glshim.system.interrupts import Held
from glshim.toolkits import Part, frames

BINDING: Binding = PYOPENGL
"""How the program speaks OpenGL."""
OUTPUTS: tuple[Output, ...] = (Picture(),)
"""Where what stylers give goes."""


@dataclass(slots=True)
class Counted:
    """What one frame was made of."""

    polygons: int = 0
    """Of the app's, that carry lines."""
    draws: int = 0
    """Of the styler's."""


class Pipeline:
    """From the program's calls to what a styler adds at the end of each layer: a
    `glshim.sources.following.sink.LayerSink`.

    Following outlives a style: display lists and buffers that were made under one, or under none,
    are known to the next.
    """

    def __init__(self, outputs: Sequence[Output] = OUTPUTS) -> None:
        self._output = Several(outputs)
        self._destination = WINDOW
        self._enlarged: Styler | None = None
        """The styler, for the scale of the destination."""
        self.styler: Styler | None = None
        """Whose draws are added; None: nobody's, and every frame is the app's own."""
        self._covers = False
        """Whether its surface is another than the app's."""
        self.shows_paints = False
        """Whether that shows the app's paints."""
        self.gathers_ink = False
        """Whether it keeps the program's own ink."""
        self.live = False
        """Whether another style may come: a fault ends the one that it befell, not the following.
        """
        self.counted = Counted()
        """The frame so far; whole when the listeners of later stages are called."""
        self._follower = Follower(BINDING.stream, self)
        self._silence = Silence(self._follower.census)
        self._broken = False
        self._listener: frames.Listener | None = None
        self._next: tuple[Styler | None] | None = None

    # -- program, bindings, sources --------------------------------------------------------------

    def start(self) -> None:
        """Follow the program from now on."""
        BINDING.attach(_first(self._follower))
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
        self._enlarge()
        surface = styler.surface if styler is not None else "app"
        self._covers, self.shows_paints = surface != "app", surface in PAINTED
        self.gathers_ink = styler is not None and styler.gathers_ink
        self._output.set_styler(styler)
        self._follower.restyle(wanted(styler) if styler is not None else None)

    def use_style_next(self, styler: Styler | None) -> None:
        """From the next frame on. Calls no GL: any thread may say so at any time."""
        self._next = (styler,)

    def draw_into(self, destination: Destination) -> None:
        """What the program draws into from now on."""
        frames.buffering(destination.double_buffered)
        scale, self._destination = self._destination.scale, destination
        if scale != destination.scale:
            self._enlarge()

    def _enlarge(self) -> None:
        scale = self._destination.scale
        self._enlarged = enlarged(self.styler, scale) if self.styler is not None else None

    # -- layer, styler, outputs: what the follower hands on --------------------------------------

    @property
    def background(self) -> Colour | None:
        """The styler's, which goes below what the app draws."""
        return self.styler.background if self.styler is not None else None

    def lay_background(self, places: Unbacked) -> bool:
        """Before the app draws in places of its framebuffer."""
        return self._output.lay_background(places)

    def lift_background(self, box: Box, own: Colour) -> tuple[Box, ...]:
        """Before the app looks at some pixels."""
        return self._output.lift_background(box, own)

    def cover(self, materials: Materials = Materials.STAY) -> None:
        """Before the app draws polygons that carry lines: the styler's surface."""
        if self._covers:
            self._output.cover(materials)

    def material(self, change: MaterialChange) -> None:
        """Inside a primitive that is covered."""
        if self._covers:
            self._output.material(change)

    def uncover(self) -> None:
        """After it."""
        if self._covers:
            self._output.uncover()

    def gather_ink(self, state: DrawState, scene: Scene, *, first: bool, listed: bool) -> bool:
        """The app is about to draw text or lines of its own."""
        place, tested, written = state.framebuffer, state.depth_tested, state.depth_written
        ink = Ink(place, state.camera.viewport, tested, written, listed)
        return self._output.gather_ink(ink, scene, first=first)

    def ink_gathered(self) -> None:
        """It has drawn them."""
        self._output.ink_gathered()

    def lay_ink(self, run: Run, scene: Scene, *, recoloured: bool) -> None:
        """What was gathered goes into the picture."""
        place, onto = run.framebuffer, self._destination
        self._output.lay_ink(place, onto, tested=run.tested, recoloured=recoloured)

    def layer_ends(self, finished: FinishedLayer, scene: Scene) -> None:
        """A layer's depth is final: the styler says what to add, the outputs add it."""
        if self._enlarged is None:
            return
        self._silence.layer_ends()
        layer = Layer(
            finished.items, light(), finished.over, finished.fresh, time.monotonic(),
            finished.lighting, self._destination.scale, finished.bare, finished.glass,
            finished.backed, finished.own_background,
        )  # fmt: skip
        try:
            self._put_out(list(self._enlarged.draws(layer)), layer, scene)
        except Exception as error:
            if not self.live:
                raise
            say_fault(f"style {self._name!r} fails and is switched off: {error!r}", error)
            self.use_style(None)
        finally:
            modules.hide()

    def _put_out(self, given: list[Given], layer: Layer, scene: Scene) -> None:
        self.counted.polygons += sum(batch.polygon_count for batch, _ in layer.items)
        self.counted.draws += sum(map(_count, given))
        if not given:
            return
        is_clear = not layer.over and self._destination is WINDOW
        if self.styler is not None and self._silence.wants_colours and is_clear:
            behind = partial(self._output.brightness_behind, layer)
            self._silence.look_at(self.styler.name, inks_of(self.styler), behind)
        try:
            self._output.add(given, layer, self._destination, scene)
        except Refused as refused:
            for reason in refused.reasons:
                say_unstyled(reason)
            if refused.all_of_them:
                scene.unpainted = str(refused)

    def _frame_over(self) -> None:
        """A frame was presented."""
        if self.styler is not None:
            self._silence.frame_ends(self.counted.draws)
        self.counted = Counted()
        self._output.frame_ends()
        if self._next is not None:
            self.use_style(*self._next)

    # -- its end ---------------------------------------------------------------------------------

    @property
    def census(self) -> Census:
        """What the program has drawn so far."""
        return self._follower.census

    def silent_because(self) -> str:
        """Why no line is drawn, if none was, with what to do."""
        return self._silence.because()

    def program_ends(self) -> None:
        """Calls no GL: contexts may be gone."""
        if self.styler is not None and not self._broken:
            self._silence.program_ends()

    @property
    def broken(self) -> bool:
        """Following has ended, by a fault."""
        return self._broken

    def context_ended(self, handle: int) -> None:
        """A context is gone, and perhaps left its handle to a new one."""
        self._output.forget(handle)

    def give_up(self, error: BaseException) -> None:
        """A fault in the shim or in a styler: said once with its traceback, styling ends."""
        if not self._broken:
            self._broken = True
            say_fault(f"style {self._name!r} is switched off, the program runs on", error)
            self.stop()

    def finish(self) -> None:
        """The picture so far is looked at: what was drawn gets its lines now."""
        with Held():
            self._follower.before(Role.READBACK, "", ())

    def stop(self) -> None:
        """Follow no more; what is pending is dropped."""
        if self._listener is not None:
            self._listener.stop()
        BINDING.detach()
        self._output.uncover()

    def release(self) -> None:
        """Give back what the current context holds for this style alone."""
        self._output.release()

    @property
    def _name(self) -> str:
        return self.styler.name if self.styler is not None else "none"


def _count(draw: Given) -> int:
    """Of a pass one, of lines one a batch."""
    return 1 if isinstance(draw, Pass) else sum(len(body.batches) for body in draw.bodies)


_current: Pipeline | None = None
_watches_end = False
_first: Callable[[Watcher], Watcher] = lambda watcher: watcher  # noqa: E731
"""Who hears what the binding tells, before the follower does."""


def install(style: str | Styler, *, live: bool = False) -> None:
    """Restyle this process's OpenGL from now on, in a style given as text or as a styler.

    It may be called before or after the program has imported PyOpenGL, and again with another
    style, to which the display lists and buffers recorded so far are available. live: record them
    even while the style draws nothing, for a style that comes later, by `switch` or by another
    call.
    Raises StyleError if the text is not a valid style; then nothing is installed.
    """
    global _current, _watches_end
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
    if not _watches_end:
        _watches_end = True
        at_end(_program_ends)
    _current.live = _current.live or live
    _current.use_style(style)


def _program_ends() -> None:
    if _current is not None:
        _current.program_ends()


def census() -> Census | None:
    """What the program has drawn so far, None where nothing is followed."""
    return _current.census if _current is not None else None


def hear_first(maker: Callable[[Watcher], Watcher]) -> None:
    """Put a watcher before the follower of the next pipeline; it is given that one, and tells it
    everything."""
    global _first
    _first = maker


def silent_because() -> str:
    """Why no line is drawn, if none was, with what to do; empty where there is nothing to say."""
    return _current.silent_because() if _current is not None else ""


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


def finish() -> None:
    """What was drawn so far gets its lines now, in the current context's picture."""
    if _current is not None and not _current.broken:
        _current.finish()


@contextmanager
def styled(styler: Styler) -> Iterator[None]:
    """What is drawn inside is drawn in a style, what was drawn before in that of then. Afterwards
    everything is as it was: the style, or that nothing is installed."""
    was_installed, before = BINDING.installed, current()
    was_followed = _current is not None and not _current.broken
    was_live = _current is not None and _current.live
    finish()
    install(styler, live=True)
    if _current is not None and not styler.wants_polygons:
        _current.use_style(None)
    try:
        yield
    finally:
        finish()
        if not was_installed:
            uninstall()
        elif not was_followed:
            _end()
        else:
            install(before or styler, live=True)
            assert _current is not None
            _current.use_style(before)
            _current.live = was_live


def counted() -> Counted:
    """What the frame that ends now is made of: for who listens to frame ends after `Stage.DRAW`."""
    return _current.counted if _current is not None else Counted()


def draw_into(destination: Destination) -> None:
    """The program draws into something else from now on: a shot, into tiles of a large picture in
    place of its window. What the style draws is enlarged as the picture is."""
    if _current is not None:
        _current.draw_into(destination)


def _end() -> None:
    """Follow the program no more."""
    global _current
    if _current is not None:
        _current.stop()
        _current.release()
        _current = None


def uninstall() -> None:
    """Leave PyOpenGL and the toolkits as they were found."""
    _end()
    if BINDING.installed:
        BINDING.uninstall()
    toolkits.release()
