"""When the program's own ink is gathered, and when it goes into the picture (`ownink`)."""

from __future__ import annotations

from glshim.driver import kinds
from glshim.driver.ask import integers, is_enabled
from glshim.driver.context import is_complete
from glshim.driver.queries import counting, counting_if_seen
from glshim.sources.following.faults import styling
from glshim.sources.following.layers import LayerCollector
from glshim.sources.following.ownink import Run
from glshim.sources.following.scene import Scene
from glshim.sources.following.sink import LayerSink
from glshim.sources.state import DrawState
from glshim.spec.constants import GL_ALPHA_TEST, GL_BLEND, GL_FILL, GL_POLYGON_MODE
from glshim.spec.kinds import FRAMEBUFFER
from glshim.system.interrupts import Held


def mind_ink(
    sink: LayerSink, scene: Scene, state: DrawState, ink: bool, *, carries: bool, listed: bool
) -> None:
    """Something is about to be drawn: what was gathered may have to lie below it, or this is
    gathered, too. ink: it is text or lines; carries: it is polygons of a layer; listed: a display
    list draws it."""
    own = scene.ink
    gathers = ink and not own.lost and not counting_if_seen() and is_complete(state.framebuffer)
    run = run_of(state, scene.layer) if gathers else None
    if not own.joins(run, carries, scene.layer):
        lay_ink(sink, scene)
    if run is not None:
        own.is_drawn = sink.gather_ink(state, scene, first=own.run is None, listed=listed)
        own.run = run if own.is_drawn else own.run


def lay_ink(sink: LayerSink, scene: Scene, *, plain: bool = False) -> None:
    """What was gathered goes into the picture; plain: in its own colours."""
    run = scene.ink.run
    if run is None or scene.fixed.lists.is_open or counting():
        return
    scene.ink.run = None
    if run.framebuffer and not kinds.is_there(FRAMEBUFFER, run.framebuffer):
        return  # deleted with its picture: to bind it would make another
    recoloured = not plain and scene.layer.has_pictures(run.framebuffer)
    with styling(), Held(), scene.condition.lifted():
        sink.lay_ink(run, scene, recoloured=recoloured)


def run_of(state: DrawState, layer: LayerCollector) -> Run:
    """The run that ink drawn in a state belongs to."""
    held = layer.pending or not layer.lies_over(state)
    return Run(state.framebuffer, held, held or state.depth_tested)


def is_wire(state: DrawState) -> bool:
    """Whether polygons drawn now are lines or points."""
    return not state.fill_faces and GL_FILL not in integers(GL_POLYGON_MODE, 2)


def is_let_through() -> bool:
    """Whether what lies below a picture may be seen through it: it is blended, or has holes."""
    return is_enabled(GL_BLEND) or is_enabled(GL_ALPHA_TEST)
