"""Style ``cartoon``: flat bands of the app's own light on its own paints and textures, and ink.

A. Lake, C. Marshall, M. Harris, M. Blackstein, "Stylized Rendering Techniques for Scalable
Real-Time 3D Animation", NPAR 2000.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from glshim.model.lights import Light
from glshim.styling.glsl import glsl
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, Styler, option
from glshim.styling.values import Body, Uniform

from ..shared import options
from ..shared.features import feature_lines
from ..shared.intersections import intersection_lines
from ..shared.shading import (
    NEAR_ENOUGH,
    UPPER_LEFT,
    by_light,
    lamp_uniforms,
    lenses,
    lit_passes,
    screen_shader,
)

_SHADER = screen_shader("cartoon", glsl(__file__, "cartoon.frag"), bent=NEAR_ENOUGH)


@dataclass(frozen=True)
class Cartoon(Styler):
    """Cel bands and ink outlines."""

    name: ClassVar[str] = "cartoon"

    bands: int = option(3, help="flat shades of light", low=2, high=16)
    exposure: float = option(
        1.5, help="factor of the light before it is cut into bands", low=0.1, high=10.0
    )
    shadow: float = option(0.55, help="brightness of the darkest band", low=0.0, high=1.0)
    shadow_tint: Colour = option(
        "#d6d0f0", help="colour that the darkest band is tinted with"
    )
    highlight: float = option(
        0.3, help="brightness of highlights, where surfaces of shiny materials are bent",
        low=0.0, high=1.0,
    )  # fmt: skip
    gloss: float = option(
        40.0, help="exponent of highlights: greater is smaller", low=1.0, high=1000.0
    )
    rim: float = option(
        0.0, help="brightness of lit rims, where bent surfaces turn away", low=0.0, high=1.0
    )
    lights: str = option(
        "app", help="the app's own lights, or one behind the viewer's shoulder",
        choices=("app", "head"),
    )  # fmt: skip
    shade_unlit: str = options.shade_unlit()
    textures: str = options.textures()
    saturation: float = option(
        1.2, help="how pure colours are; 1: as the app has them, 0: grey", low=0.0, high=3.0
    )
    posterise: int = option(
        0, help="levels of brightness of paints and textures; 0: as they are", low=0, high=64
    )
    outline_width: float = option(3.0, help="width of outlines", low=0.5, high=64.0, unit="px")
    line_width: float = option(
        1.5, help="width of lines within outlines; 0: none", low=0.0, high=64.0, unit="px"
    )
    crease_angle: float = options.crease_angle(60.0)
    intersections: str = options.intersections()
    ink: Colour = option("#101014", help="colour of the lines")
    tolerance: float = options.tolerance()

    @property
    def wants_normals(self) -> bool:
        """Light falls by them."""
        return True

    @property
    def wants_lights(self) -> bool:
        """Bands are of them."""
        return True

    @property
    def surface(self) -> str | Colour:
        """The app's paints, which bands of light go over."""
        return "paint" if self.textures == "app" else "colours"

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """Bands, and ink over them."""
        lit, unlit = by_light(layer, self.shade_unlit)
        head = (UPPER_LEFT,)
        given = layer.lighting.lights if layer.lighting is not None else ()
        yield from self._shaded(lit, given if self.lights == "app" else head)
        yield from self._shaded(unlit, head)
        yield from feature_lines(
            layer, self.ink, outlines=self.outline_width, open_sides=self.outline_width,
            creases=max(self.line_width, 0.5) if self.line_width > 0.0 else None,
            crease_angle=self.crease_angle, tolerance=self.tolerance,
        )  # fmt: skip
        if self.line_width > 0.0:
            yield from intersection_lines(self.intersections, layer, self.line_width, self.ink)

    def _shaded(self, found: tuple[Body, ...], lights: tuple[Light, ...]) -> Iterable[Pass]:
        look: dict[str, Uniform] = {
            "bands": float(self.bands), "exposure": self.exposure, "shadow": self.shadow,
            "shadow_tint": self.shadow_tint, "highlight": self.highlight, "gloss": self.gloss,
            "rim": self.rim, "saturation": self.saturation,
            "paints": float(self.posterise),
        }  # fmt: skip
        for lens in lenses(found):
            yield from lit_passes(
                _SHADER, lens, look | lamp_uniforms(lights, lens), self.tolerance
            )
