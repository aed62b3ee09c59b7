"""The style's background goes below what the program draws."""

from __future__ import annotations

from typing import Any

from glshim.driver.arguments import number
from glshim.driver.ask import integer, is_enabled, reals
from glshim.driver.context import has_framebuffers, is_complete
from glshim.driver.queries import counting
from glshim.model.boxes import Unbacked
from glshim.sources.following.faults import styling
from glshim.sources.following.scene import Scene
from glshim.sources.following.sink import LayerSink
from glshim.sources.state import DrawState
from glshim.spec.constants import (
    GL_BLEND,
    GL_COLOR_CLEAR_VALUE,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_READ_FRAMEBUFFER_BINDING,
    GL_TEXTURE_2D,
)
from glshim.system.interrupts import Held


def _is_pictured() -> bool:
    """Whether polygons show a picture: not text, which is blended, and no plain colours."""
    return is_enabled(GL_TEXTURE_2D) and not is_enabled(GL_BLEND)


def lay_behind(
    sink: LayerSink, scene: Scene, state: DrawState, *, carries: bool, polygons: bool
) -> None:
    """Something is about to be drawn: lay the background, where it is not there yet. carries: it is
    polygons of a layer; polygons: any."""
    if scene.condition.discards or state.program:
        return
    backdrop = state.flat and not carries
    if backdrop and not (polygons and scene.layer.backing.awaited and _is_pictured()):
        return
    if counting() or not is_complete(state.framebuffer):
        return
    places = scene.layer.unbacked(state, carries=carries, polygons=polygons)
    if places is None:
        return
    with styling(), Held(), scene.condition.lifted():
        if sink.lay_background(places):
            scene.layer.backing.own = colour_cleared_to()
            scene.layer.backing.add(state.framebuffer, places.boxes)


def colour_cleared_to() -> tuple[float, float, float]:
    """Which the program's own background has, as a rule."""
    red, green, blue, _ = reals(GL_COLOR_CLEAR_VALUE, 4)
    return red, green, blue


def lift(sink: LayerSink, scene: Scene, args: tuple[Any, ...]) -> None:
    """The program is about to read a few pixels, for picking: it finds its own colours, also where
    nothing lies on the background. `put_down` must follow. args: of glReadPixels. While a list is
    open nothing can be done: it would have that."""
    if scene.fixed.lists.is_open or not has_framebuffers():
        return
    box = number(args, 0), number(args, 1), number(args, 2), number(args, 3)
    backing, at = scene.layer.backing, integer(GL_READ_FRAMEBUFFER_BINDING)
    if at == integer(GL_DRAW_FRAMEBUFFER_BINDING) and backing.lies_in(at) and min(box[2:]) > 0:
        with styling(), Held(), scene.condition.lifted():
            backing.lifted = sink.lift_background(box, backing.own)


def put_down(sink: LayerSink, scene: Scene) -> None:
    """It has read them, or was refused."""
    backing = scene.layer.backing
    if backing.lifted:
        pixels, backing.lifted = backing.lifted, ()
        with styling(), Held(), scene.condition.lifted():
            sink.lay_background(Unbacked(pixels, free_depth=False))
