"""A program reads a few pixels, to learn what lies under the pointer: it finds its own colours,
also of its text, and where nothing lies on the background."""

from __future__ import annotations

from typing import Any

from glshim.driver.arguments import number
from glshim.driver.ask import integer
from glshim.driver.context import has_framebuffers
from glshim.model.boxes import Box, Unbacked
from glshim.sources.following.faults import styling
from glshim.sources.following.gathering import lay_ink
from glshim.sources.following.scene import Scene
from glshim.sources.following.sink import LayerSink
from glshim.spec.constants import GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING
from glshim.spec.pixels import PICK_AREA
from glshim.system.interrupts import Held


def pick_begins(sink: LayerSink, scene: Scene, args: tuple[Any, ...]) -> bool:
    """The program is about to read pixels: whether those are a few, for picking. `pick_ends` must
    follow. args: of glReadPixels."""
    box = number(args, 0), number(args, 1), number(args, 2), number(args, 3)
    if box[2] * box[3] > PICK_AREA:
        return False
    lay_ink(sink, scene, plain=True)
    # While a list is open nothing more can be done: the list would have it.
    if not scene.fixed.lists.is_open and has_framebuffers():
        _lift(sink, scene, box)
    return True


def _lift(sink: LayerSink, scene: Scene, box: Box) -> None:
    backing, at = scene.layer.backing, integer(GL_READ_FRAMEBUFFER_BINDING)
    if at == integer(GL_DRAW_FRAMEBUFFER_BINDING) and backing.lies_in(at) and min(box[2:]) > 0:
        with styling(), Held(), scene.condition.lifted():
            backing.lifted = sink.lift_background(box, backing.own)


def pick_ends(sink: LayerSink, scene: Scene) -> None:
    """It has read them, or was refused."""
    backing = scene.layer.backing
    if backing.lifted:
        pixels, backing.lifted = backing.lifted, ()
        with styling(), Held(), scene.condition.lifted():
            sink.lay_background(Unbacked(pixels, free_depth=False))
