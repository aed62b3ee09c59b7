"""Materials that change inside a primitive."""

from __future__ import annotations

from glshim.bindings.base import PrimitiveStream
from glshim.driver.ask import is_enabled
from glshim.driver.functions import gl
from glshim.model.lights import Materials
from glshim.sources.following.scene import Scene
from glshim.sources.following.sink import LayerSink
from glshim.spec.constants import GL_COLOR_MATERIAL, GL_LIGHTING
from glshim.system.interrupts import Held


def cover_anew(sink: LayerSink, stream: PrimitiveStream, scene: Scene) -> None:
    """The open primitive is about to change a material: where it is covered by paints, and nothing
    of it has reached the driver, it is begun anew in a surface that follows its changes."""
    covered = sink.shows_paints and scene.drawing is not None and scene.drawing.depth_written
    if not covered or scene.fixed.lists.is_open or not stream.unsaid():
        return
    with Held():
        gl.glEnd()
        try:
            if is_enabled(GL_LIGHTING) and not is_enabled(GL_COLOR_MATERIAL):
                sink.uncover()
                sink.cover(Materials.SAID)
        finally:
            gl.glBegin(stream.mode)
