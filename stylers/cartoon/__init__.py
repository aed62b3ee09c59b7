"""Style ``cartoon``: flat bands of the app's own light on its own paints and textures, and ink.

A. Lake, C. Marshall, M. Harris, M. Blackstein, "Stylized Rendering Techniques for Scalable
Real-Time 3D Animation", NPAR 2000.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import ClassVar

from glshim.model.lights import Light
from glshim.styling.glsl import glsl
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names
from glshim.styling.values import Body, Uniform

from ..shared import options
from ..shared.intersections import intersection_lines
from ..shared.kinds import USUAL, FeatureLines, former_names
from ..shared.shading import (
    NEAR_ENOUGH,
    UNLIT,
    UPPER_LEFT,
    all_of,
    by_light,
    lamp_uniforms,
    lenses,
    lit_passes,
    screen_shader,
)
from ..shared.strokes import inked

_SHADER = screen_shader("cartoon", glsl(__file__, "cartoon.frag"), bent=NEAR_ENOUGH)


_PLAINLY: Mapping[str, Uniform] = {
    "shadow": UNLIT, "shadow_tint": (1.0, 1.0, 1.0), "saturation": 1.0,
}  # fmt: skip
"""What is drawn without any light keeps its colours."""
_OLD_WIDTH = Renamed(
    ("ridge_width", "valley_width", "intersection_width"),
    off=("ridges", "valleys", "intersections"),
)


@takes_old_names
@dataclass(frozen=True)
class Cartoon(FeatureLines):
    """Cel bands and ink outlines."""

    name: ClassVar[str] = "cartoon"
    former: ClassVar[Mapping[str, Renamed]] = former_names(USUAL, line_width=_OLD_WIDTH)

    bands: int = option(3, help="flat shades of light", low=2, high=16)
    exposure: float = option(
        1.5, help="brightness of the light before it is cut into bands", low=0.1, high=10.0
    )
    shadow: float = option(0.55, help="brightness of the darkest band", low=0.0, high=1.0)
    shadow_tint: Colour = option("#d6d0f0", help="tint of the darkest band")
    highlight: float = options.highlight(0.3)
    gloss: float = options.gloss(40.0)
    rim: float = option(
        0.0, help="brightness of rim light on curved surfaces", low=0.0, high=1.0
    )
    lights: str = option(
        "app", help="the program's own lights (app), or one behind the viewer's shoulder (head)",
        choices=("app", "head"),
    )  # fmt: skip
    shade_unlit: str = options.shade_unlit()
    textures: str = options.textures()
    saturation: float = option(
        1.2, help="saturation of colours; 1: unchanged, 0: grey", low=0.0, high=3.0
    )
    posterise: int = option(
        0, help="brightness levels of colours and textures; 0: unchanged", low=0, high=64
    )
    width: float = options.width(3.0, "outlines")
    inner: float = options.inner(0.5)
    ink: Colour = options.ink("#101014")
    texture: str = options.texture()
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    crease_angle: float = options.crease_angle(60.0)
    intersections: str = options.intersections()
    tolerance: float = options.tolerance()
    own_ink: str = options.own_ink()

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
        if self.lights == "app":
            for some in lit:
                yield from self._shaded(some.bodies, some.lights, some.both_sides)
        else:
            yield from self._shaded(all_of(lit), head)
        plainly = _PLAINLY if self.shade_unlit == "auto" else {}
        yield from self._shaded(unlit, head, look=plainly)
        yield from inked(
            layer, self.features(self.crease_angle, tolerance=self.tolerance), self.looks(),
            texture_length=self.texture_length,
        )  # fmt: skip
        yield from intersection_lines(self, self.intersections, layer)

    def share(self, kind: str) -> float:
        return 1.0 if kind in ("contour", "boundary") else self.inner

    def _shaded(
        self, found: tuple[Body, ...], lights: tuple[Light, ...], both_sides: bool = True,
        look: Mapping[str, Uniform] = MappingProxyType({}),
    ) -> Iterable[Pass]:
        usual: dict[str, Uniform] = {
            "bands": float(self.bands), "exposure": self.exposure, "shadow": self.shadow,
            "shadow_tint": self.shadow_tint, "highlight": self.highlight, "gloss": self.gloss,
            "rim": self.rim, "saturation": self.saturation,
            "paints": float(self.posterise),
        }  # fmt: skip
        for lens in lenses(found):
            yield from lit_passes(
                _SHADER, lens, {**usual, **look, **lamp_uniforms(lights, lens)}, self.tolerance,
                both_sides=both_sides,
            )  # fmt: skip
