"""The style's background goes below what the program draws."""

from __future__ import annotations

from dataclasses import replace

from glshim.driver.ask import is_enabled, reals
from glshim.driver.context import is_complete
from glshim.driver.queries import counting
from glshim.sources.following.faults import styling
from glshim.sources.following.scene import Scene
from glshim.sources.following.sink import LayerSink
from glshim.sources.state import DrawState
from glshim.spec.constants import (
    GL_BLEND,
    GL_COLOR_CLEAR_VALUE,
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
    backing = scene.layer.backing
    places = scene.layer.unbacked(state, carries=carries, polygons=polygons)
    if places is None and backing.awaited and state.rendered:
        backing.came_early(state.framebuffer)
    if places is None or counting() or not is_complete(state.framebuffer):
        return
    own = colour_cleared_to()
    if backing.holds_early(state.framebuffer):
        places = replace(places, around=own)
    with styling(), Held(), scene.condition.lifted():
        if sink.lay_background(places):
            backing.own = own
            backing.add(state.framebuffer, places.boxes)


def colour_cleared_to() -> tuple[float, float, float]:
    """Which the program's own background has, as a rule."""
    red, green, blue, _ = reals(GL_COLOR_CLEAR_VALUE, 4)
    return red, green, blue
