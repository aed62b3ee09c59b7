"""Glass: solids that are blended over a layer without writing depth. They get outlines, and hide
nothing."""

from __future__ import annotations

from glshim.driver.ask import is_enabled
from glshim.sources.following.layers import LayerCollector
from glshim.sources.state import DrawState
from glshim.spec.constants import GL_BLEND, GL_LIGHTING, GL_TEXTURE_2D


def is_glass(state: DrawState, layer: LayerCollector) -> bool:
    """Whether polygons that do not write depth are lit and blended: flares, shadows and decals are
    not lit, or textured."""
    return (
        layer.pending
        and state.depth_tested
        and not state.depth_written
        and state.fill_faces
        and not state.flat
        and is_enabled(GL_BLEND)
        and is_enabled(GL_LIGHTING)
        and not is_enabled(GL_TEXTURE_2D)
    )
