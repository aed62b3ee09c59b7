"""What belongs to one GL context: where its polygons come from, and its current layer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from glshim.bindings.base import PrimitiveStream
from glshim.driver import arguments, kinds
from glshim.driver.context import shortcoming
from glshim.driver.functions import current_context
from glshim.driver.lifetime import witness
from glshim.driver.objects import made
from glshim.model.batch import POSITIONS, Wanted
from glshim.notices import say_once
from glshim.sources.fixed.lettering import Lettering
from glshim.sources.fixed.shapes import Shapes
from glshim.sources.fixed.source import FixedFunction
from glshim.sources.following.condition import Condition
from glshim.sources.following.layers import LayerCollector
from glshim.sources.following.ownink import OwnInk
from glshim.sources.programs.source import Programs
from glshim.sources.source import Source
from glshim.sources.state import DrawState, StateReader
from glshim.spec.kinds import FRAMEBUFFER
from glshim.spec.roles import Role

_FRAMES_BETWEEN_LOOKS = 256
"""A look asks the window system once a context."""


class Scene:
    """The book-keeping of one context. Make it while that context is current."""

    def __init__(
        self, stream: PrimitiveStream, wanted: Wanted = POSITIONS, shapes: Shapes | None = None
    ) -> None:
        """wanted: what batches shall come with. shapes: that are known already."""
        self.refused = shortcoming()
        """Why nothing can be styled here; empty when it can."""
        self.unpainted = ""
        """Why the style that is on cannot be drawn here; empty when it can. Lists and buffers are
        followed all the same, for another one."""
        self.reader = StateReader(lighting=wanted.lights)
        self.layer = LayerCollector(wanted)
        self.fixed = FixedFunction(stream, wanted, shapes)
        self.sources: tuple[Source, ...] = (self.fixed, Programs())
        """In the order in which they are asked."""
        self.source: Source = self.fixed
        """Whose the last draw was."""
        self.drawing: DrawState | None = None
        """State of the draw that is under way, if its polygons carry lines."""
        self.condition = Condition()
        self.ink = OwnInk()
        self.lettering = Lettering()
        self._marker = 0
        self._is_there = witness()

    def restyle(self, wanted: Wanted) -> None:
        """Batches shall come with something else from now on, in a layer that begins anew. Lists,
        buffers and shapes stay known."""
        self.unpainted = ""
        self.reader = StateReader(lighting=wanted.lights)
        self.layer = LayerCollector(wanted)
        self.fixed.restyle(wanted)

    def obstacle(self, state: DrawState) -> str:
        """Why polygons drawn in a state cannot carry lines; empty when they can. Then, and when
        the source alone is in the way, :attr:`source` is the one that a draw is of."""
        if not state.rendered:
            return "selection or feedback"
        for source in self.sources:
            why = source.obstacle(state)
            if why is not None:
                self.source = source
                return why or state.obstacle
        return "no source knows their polygons"

    def mark(self) -> None:
        """Leave a mark in the context, so that :attr:`stale` can tell: an object of the one kind of
        ours that contexts need not share. When the first layer ends: until then nothing of ours is
        in it."""
        if not self._marker:
            self._marker = made(FRAMEBUFFER)

    @property
    def stale(self) -> bool:
        """Whether the current context is another one, at the address of the one that was."""
        if not self._is_there():
            return True
        return bool(self._marker) and not kinds.is_there(FRAMEBUFFER, self._marker)

    @property
    def gone(self) -> bool:
        """Whether the context, which is not current, was destroyed."""
        return not self._is_there()


class Scenes:
    """The scenes of this process by context."""

    def __init__(
        self,
        stream: PrimitiveStream,
        ended: Callable[[int], None] = lambda context: None,
        wanted: Wanted = POSITIONS,
    ) -> None:
        """ended: told the handle of a context that is gone. Calls no GL: another is current."""
        self._stream = stream
        self._ended = ended
        self._wanted = wanted
        self._by_context: dict[int, Scene] = {}
        self._shapes: Shapes | None = None
        """That a context left which is gone: the next one is likely to draw the same."""
        self._frames = 0
        self._conditions_in_lists = False

    def current(self) -> Scene | None:
        """The current context's scene; None without a context."""
        handle = current_context()
        if not handle:
            return None
        scene = self._by_context.get(handle)
        if scene is None:
            self._look_around(handle)
            scene = self._by_context[handle] = Scene(self._stream, self._wanted, self._shapes)
            self._shapes = None
            if self._conditions_in_lists:
                scene.condition.lose()
            if scene.refused:
                say_unstyled(scene.refused)
        return scene

    def frame_ends(self) -> None:
        """Of the current context."""
        self._frames += 1
        if self._frames % _FRAMES_BETWEEN_LOOKS == 0:
            self._look_around(current_context())

    def _look_around(self, here: int) -> None:
        """Toolkits destroy contexts unheard: forget those that are gone. Without it, a program that
        opens and closes windows would grow."""
        others = [(handle, scene) for handle, scene in self._by_context.items() if handle != here]
        for handle, scene in others:
            if scene.gone:
                self._forget(handle)

    def _forget(self, handle: int) -> None:
        self._shapes = self._by_context.pop(handle).fixed.shapes
        self._ended(handle)

    def condition_called(self, scene: Scene, role: Role, args: tuple[Any, ...]) -> None:
        """Conditional rendering begins or ends, or an open list has that now."""
        if scene.fixed.lists.is_open:
            self._conditions_in_lists = True
            for each in self._by_context.values():
                each.condition.lose()
        elif role is Role.CONDITION_OPEN:
            scene.condition.opened(arguments.name(args, 0), arguments.name(args, 1))
        else:
            scene.condition.closed()

    def restyle(self, wanted: Wanted) -> None:
        """`Scene.restyle`, of all."""
        self._wanted = wanted
        for scene in self._by_context.values():
            scene.restyle(wanted)

    def look_here(self) -> None:
        """Look whether the current context is new, at an old one's address; it gets a new scene
        then. Ask now and then, outside primitives: at a clear, before a list."""
        handle = current_context()
        scene = self._by_context.get(handle)
        if scene is not None and scene.stale:
            self._forget(handle)

    def close_list(self, scene: Scene) -> None:
        """glEndList. Other contexts may share the list that changed."""
        name = scene.fixed.lists.close()
        if name is not None:
            for other in self._by_context.values():
                if other is not scene:
                    other.fixed.lists.book.redefined_elsewhere(name)


def say_unstyled(why: str) -> None:
    """Once: nothing can be styled in a context."""
    say_once(f"unstyled: {why}; the program runs as it would without a style")
