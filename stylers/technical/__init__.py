"""Style ``technical``: an illustration as in a manual, with tones from cool to warm and fine lines.

A. Gooch, B. Gooch, P. Shirley, E. Cohen, "A Non-Photorealistic Lighting Model for Automatic
Technical Illustration", SIGGRAPH 1998. Its numbers, for pale paints, are the look ``gooch``;
programs have strong ones, which keep more of their own here.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, ClassVar, cast

from glshim.model.lights import Light
from glshim.styling.glsl import glsl
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, Styler, option
from glshim.styling.values import Uniform

from ..shared import options
from ..shared.features import feature_lines
from ..shared.intersections import intersection_lines, is_dense
from ..shared.shading import (
    NEAR_ENOUGH,
    UPPER_LEFT,
    by_light,
    lamp_uniforms,
    lenses,
    lit_passes,
    screen_shader,
)
from ..shared.tones import tone_passes

_SHADER = screen_shader("gooch", glsl(__file__, "gooch.frag"), bent=NEAR_ENOUGH)
_WHITE: Colour = (1.0, 1.0, 1.0)


@dataclass(frozen=True)
class Technical(Styler):
    """Cool-to-warm tones, wide outlines, fine creases, dashed hidden lines (Gooch et al. 1998)."""

    name: ClassVar[str] = "technical"

    blue: float = option(0.25, help="blue of the cool tone (the paper's b)", low=0.0, high=1.0)
    yellow: float = option(
        0.2, help="red and green of the warm tone (the paper's y)", low=0.0, high=1.0
    )
    alpha: float = option(0.35, help="share of the paint in the cool tone", low=0.0, high=1.0)
    beta: float = option(0.75, help="share of the paint in the warm tone", low=0.0, high=1.0)
    highlight: float = option(
        0.4, help="brightness of highlights, where surfaces of shiny materials are bent",
        low=0.0, high=1.0,
    )  # fmt: skip
    gloss: float = option(
        30.0, help="exponent of highlights: greater is smaller", low=1.0, high=1000.0
    )
    light: str = option(
        "fixed", help="where warm tones face: upper left of the viewer, or the app's first light",
        choices=("fixed", "app"),
    )  # fmt: skip
    paint: str | Colour = option(
        "app", help="what surfaces are painted with: the app's colours, or one",
        choices=("app",), colour=True,
    )  # fmt: skip
    shade_unlit: str = options.shade_unlit()
    textures: str = options.textures()
    paper: str | Colour = options.paper(_WHITE)
    outline_width: float = option(2.5, help="width of outlines", low=0.5, high=64.0, unit="px")
    line_width: float = option(1.0, help="width of the other lines", low=0.5, high=64.0, unit="px")
    ink: Colour = option("#000000", help="colour of the lines")
    white_edges: bool = option(
        False, help="ridges that are seen in white, as light catches them, not in ink"
    )
    hidden: str = option(
        "auto", help="lines behind surfaces; auto: dashed of what has at most 20,000 polygons",
        choices=("auto", "none", "dashed", "dimmed", "solid"),
    )  # fmt: skip
    hidden_share: float = option(
        0.4, help="share of the ink of hidden lines that are dashed or solid", low=0.0, high=1.0
    )
    crease_angle: float = options.crease_angle(40.0)
    intersections: str = options.intersections()
    tolerance: float = options.tolerance()

    @property
    def wants_normals(self) -> bool:
        """Tones go by them."""
        return True

    @property
    def wants_lights(self) -> bool:
        """What the app does not light may keep its own picture."""
        return True

    @property
    def surface(self) -> str | Colour:
        """The app's paints, which tones are mixed with."""
        return "paint" if self.textures == "app" else "colours"

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """Tones, paper and lines."""
        lit, unlit = by_light(layer, self.shade_unlit)
        paint = (0.0, 0.0, 0.0, 0.0) if isinstance(self.paint, str) else (*self.paint, 1.0)
        look: dict[str, Uniform] = {
            "paint": paint, "blue": self.blue, "yellow": self.yellow, "alpha": self.alpha,
            "beta": self.beta, "highlight": self.highlight, "gloss": self.gloss,
        }  # fmt: skip
        for lens in lenses(lit + unlit):
            lamps = lamp_uniforms((self._lamp(layer),), lens)
            yield from lit_passes(_SHADER, lens, look | lamps, self.tolerance)
        yield from tone_passes("app", self.paper, self.ink, layer)
        yield from self._fine_lines(layer)
        yield from feature_lines(
            layer, self.ink, outlines=self.outline_width, open_sides=self.outline_width,
            tolerance=self.tolerance,
        )  # fmt: skip
        yield from intersection_lines(self.intersections, layer, self.line_width, self.ink)

    def _lamp(self, layer: Layer) -> Light:
        given = layer.lighting.lights if layer.lighting is not None else ()
        return given[0] if given and self.light == "app" else UPPER_LEFT

    def _fine_lines(self, layer: Layer) -> Iterable[Lines]:
        """Lines that go on where they are hidden: of outlines, too."""
        hidden = self.hidden
        if hidden == "auto":
            hidden = "none" if is_dense(layer) else "dashed"
        width = self.line_width
        return feature_lines(
            layer, self.ink, outlines=width if hidden != "none" else None, open_sides=width,
            creases=width, crease_angle=self.crease_angle,
            ridge_colour=_WHITE if self.white_edges else None, hidden=cast(Any, hidden),
            hidden_share=self.hidden_share, tolerance=self.tolerance,
        )  # fmt: skip
