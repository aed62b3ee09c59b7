"""Glass: solids that are blended over a layer without writing depth. They get outlines, and hide
nothing."""

from __future__ import annotations

from glshim.driver.ask import is_enabled, reals
from glshim.model.lights import Shade
from glshim.sources.following.layers import LayerCollector
from glshim.sources.state import DrawState
from glshim.spec.constants import GL_BLEND, GL_CURRENT_COLOR, GL_LIGHTING, GL_TEXTURE_2D

_ALIKE = 0.2
"""Of a channel: what is blended with paper of such a colour is not seen there."""


def is_glass(state: DrawState, layer: LayerCollector, background: Shade | None) -> bool:
    """Whether polygons that do not write depth are lit and blended: flares, shadows and decals are
    not lit, or textured. What is not lit is glass where nothing else of it could be seen: it has
    the colour of the style's background."""
    return (
        layer.pending
        and state.depth_tested
        and not state.depth_written
        and state.fill_faces
        and not state.flat
        and is_enabled(GL_BLEND)
        and not is_enabled(GL_TEXTURE_2D)
        and (is_enabled(GL_LIGHTING) or _vanishes(background))
    )


def _vanishes(background: Shade | None) -> bool:
    """Whether the colour that holds is that of the background."""
    if background is None:
        return False
    own = reals(GL_CURRENT_COLOR, 4)[:3]
    return max(abs(a - b) for a, b in zip(own, background, strict=True)) < _ALIKE
