"""Style ``cartoon``: flat bands of the app's own light on its own paints and textures, and ink.

A. Lake, C. Marshall, M. Harris, M. Blackstein, "Stylized Rendering Techniques for Scalable
Real-Time 3D Animation", NPAR 2000.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from importlib.resources import files
from typing import ClassVar

from glshim.model.lights import Light
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, Styler, Uniform, option
from glshim.styling.values import Body
from stylers import options
from stylers.crossings import crossings
from stylers.edge_mesh import EdgeMesh
from stylers.shading import (
    NEAR_ENOUGH,
    UPPER_LEFT,
    by_light,
    lamp_uniforms,
    lenses,
    lit_passes,
    screen_shader,
)

_SHADER = screen_shader(
    "cartoon", (files(__package__) / "cartoon.frag.glsl").read_text("utf-8"), bent=NEAR_ENOUGH
)


@dataclass(frozen=True)
class Cartoon(Styler):
    """Cel bands and ink outlines."""

    name: ClassVar[str] = "cartoon"

    bands: float = option(3.0, help="flat shades of light", low=2.0, high=16.0)
    exposure: float = option(
        1.5, help="factor of the light before it is cut into bands", low=0.1, high=10.0
    )
    shadow: float = option(0.55, help="brightness of the darkest band", low=0.0, high=1.0)
    shadow_tint: Colour = option(  # noqa: RUF009
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
    posterise: float = option(
        0.0, help="levels of brightness of paints and textures; 0: as they are", low=0.0, high=64.0
    )
    outline_width: float = option(3.0, help="width of outlines", low=0.5, high=64.0, unit="px")
    line_width: float = option(
        1.5, help="width of lines within outlines; 0: none", low=0.0, high=64.0, unit="px"
    )
    crease_angle: float = options.crease_angle(60.0)
    intersections: str = options.intersections()
    ink: Colour = option("#101014", help="colour of the lines")  # noqa: RUF009
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
        yield from self._lines.draws(layer)
        if self.line_width > 0.0:
            yield from crossings(self.intersections, layer, self.line_width, self.ink)

    def _shaded(self, found: tuple[Body, ...], lights: tuple[Light, ...]) -> Iterable[Pass]:
        look: dict[str, Uniform] = {
            "bands": float(round(self.bands)), "exposure": self.exposure, "shadow": self.shadow,
            "shadow_tint": self.shadow_tint, "highlight": self.highlight, "gloss": self.gloss,
            "rim": self.rim, "saturation": self.saturation,
            "paints": float(round(self.posterise)),
        }  # fmt: skip
        for lens in lenses(found):
            yield from lit_passes(
                _SHADER, lens, look | lamp_uniforms(lights, lens), self.tolerance
            )

    @property
    def _lines(self) -> EdgeMesh:
        inner = self.line_width > 0.0
        width = max(self.line_width, 0.5)
        ridge, valley = options.folds(self.crease_angle)
        return EdgeMesh(
            ridges=inner, valleys=inner, ridge_angle=ridge, valley_angle=valley,
            contour_width=self.outline_width, boundary_width=self.outline_width,
            ridge_width=width, valley_width=width, contour_ink=self.ink, boundary_ink=self.ink,
            ridge_ink=self.ink, valley_ink=self.ink, tolerance=self.tolerance,
        )  # fmt: skip
