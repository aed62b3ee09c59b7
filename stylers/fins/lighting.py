"""Surfaces lit from the G-buffer, in the hues of the app's own picture.

P. Rideout, "Silhouette Extraction", 2010, "The Spine Test", and the dragon.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite

from glshim.styling.glsl import glsl
from glshim.styling.passes import Pass
from glshim.styling.values import Body, Colour, Place, Uniform

from ..shared.shading import lenses, lit_passes, screen_shader

_AMBIENT = 0.35
SURFACE = screen_shader(
    "fins surface", glsl(__file__, "surface.frag"), lamps=False
)


@dataclass(frozen=True, slots=True)
class Lighting:
    """How surfaces are lit."""

    paint: str | Colour
    """``app``: the hue and saturation of the app's own picture."""
    shine: float
    """Brightness of highlights, 0..1."""
    bands: int
    """Flat shades of light; 0: smooth."""


def relit(
    found: tuple[Body, ...], light: Place, look: Lighting, tolerance: float,
    ambient: float = _AMBIENT,
) -> Iterator[Pass]:
    """For bodies that are seen through one lens after the other, the G-buffer and the light on
    it. light: in eye space, homogeneous; tolerance: object units at which corners are one;
    ambient: brightness where no light falls."""
    paint = (0.0, 0.0, 0.0, 0.0) if isinstance(look.paint, str) else (*look.paint, 1.0)
    for lens in lenses(found):
        first = lens[0].camera
        whole = first.affine() is first and any(light) and all(map(isfinite, light))
        uniforms: dict[str, Uniform] = {
            "lamp": light if whole else (0.0, 0.0, 0.0, 0.0),
            "paint": paint, "shine": look.shine, "bands": float(look.bands),
            "ambient": ambient,
        }  # fmt: skip
        yield from lit_passes(SURFACE, lens, uniforms, tolerance)
