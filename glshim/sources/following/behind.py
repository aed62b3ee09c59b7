"""The style's background goes below what the program draws."""

from __future__ import annotations

from glshim.sources.following.faults import styling
from glshim.sources.following.scene import Scene
from glshim.sources.following.sink import LayerSink
from glshim.sources.state import DrawState
from glshim.system.interrupts import Held


def lay_behind(
    sink: LayerSink, scene: Scene, state: DrawState, *, carries: bool, polygons: bool
) -> None:
    """Something is about to be drawn: lay the background, where it is not there yet. carries: it is
    polygons of a layer; polygons: any."""
    if scene.condition.discards or state.program:
        return
    places = scene.layer.unbacked(state, carries=carries, polygons=polygons)
    if places is None:
        return
    with styling(), Held(), scene.condition.lifted():
        if sink.lay_background(places):
            scene.layer.backing.add(state.framebuffer, places.boxes)
