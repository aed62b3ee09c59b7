"""Style ``technical``: an illustration as in a manual, with tones from cool to warm and fine lines.

A. Gooch, B. Gooch, P. Shirley, E. Cohen, "A Non-Photorealistic Lighting Model for Automatic
Technical Illustration", SIGGRAPH 1998. Its numbers, for pale paints, are the look ``gooch``;
programs have strong ones, and textures, which keep more of their own and their hues here: the
paper's yellow turns greys olive, its blue turns reds mauve.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar, cast

from glshim.styling.glsl import glsl
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names
from glshim.styling.values import Uniform

from ..shared import options
from ..shared.intersections import intersection_lines, is_dense
from ..shared.kinds import USUAL, FeatureLines, Look, former_names
from ..shared.shading import (
    NEAR_ENOUGH,
    UNLIT,
    UPPER_LEFT,
    Lit,
    by_light,
    by_tint,
    lamp_uniforms,
    lenses,
    lit_passes,
    paper_of,
    screen_shader,
)
from ..shared.strokes import inked, only
from ..shared.tones import tone_passes

_SHADER = screen_shader("gooch", glsl(__file__, "gooch.frag"), bent=NEAR_ENOUGH)
_WHITE: Colour = (1.0, 1.0, 1.0)
_OUTLINES = ("contour", "boundary")


@takes_old_names
@dataclass(frozen=True)
class Technical(FeatureLines):
    """Cool-to-warm tones, wide outlines, fine creases, dashed hidden lines (Gooch et al. 1998)."""

    name: ClassVar[str] = "technical"
    former: ClassVar[Mapping[str, Renamed]] = former_names(USUAL)

    blue: float = option(0.25, help="blue of the cool tone (the paper's b)", low=0.0, high=1.0)
    yellow: float = option(
        0.2, help="yellow of the warm tone (the paper's y)", low=0.0, high=1.0
    )
    alpha: float = option(
        0.35, help="surface colour mixed into the cool tone (the paper's alpha)", low=0.0, high=1.0
    )
    beta: float = option(
        0.75, help="surface colour mixed into the warm tone (the paper's beta)", low=0.0, high=1.0
    )
    hue: float = option(
        1.0, help="share of the surfaces' own hue that is kept; 0: tones of the paper's blue and "
        "yellow", low=0.0, high=1.0,
    )  # fmt: skip
    highlight: float = options.highlight(0.4)
    gloss: float = options.gloss(30.0)
    light: str = option(
        "fixed", help="direction of the warm tones: the viewer's upper left (fixed), or the "
        "program's first light (app)", choices=("fixed", "app"),
    )  # fmt: skip
    paint: str | Colour = options.paint()
    shade_unlit: str = options.shade_unlit()
    textures: str = options.textures()
    paper: str | Colour = options.paper(_WHITE)
    width: float = options.width(2.5, "outlines")
    inner: float = options.inner(0.4)
    ink: Colour = options.ink("#000000")
    texture: str = options.texture()
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    white_edges: bool = option(
        False, help="draw visible ridges in white, as edges that catch the light"
    )
    hidden: str = option(
        "auto", help="lines behind surfaces; auto: dashed, up to 20,000 polygons",
        choices=("auto", "none", "dashed", "dimmed", "solid"),
    )  # fmt: skip
    hidden_share: float = options.hidden_share(0.4)
    crease_angle: float = options.crease_angle(40.0)
    intersections: str = options.intersections()
    tolerance: float = options.tolerance()
    own_ink: str = options.own_ink()

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
            "beta": self.beta, "hue": self.hue, "highlight": self.highlight, "gloss": self.gloss,
        }  # fmt: skip
        app = layer.lighting.lights if self.light == "app" and layer.lighting else ()
        for some in lit if self.light == "app" else by_tint(lit):
            yield from self._toned(layer, some, look | {"tint": some.tint})
        plainly = self._plainly() if self.shade_unlit == "auto" else {}
        yield from self._toned(layer, Lit(app, unlit), look | {"tint": _WHITE} | plainly)
        yield from tone_passes("app", self.paper, self.ink, layer)
        yield from self._fine_lines(layer)
        looks = self.looks().items()
        yield from self._inked(layer, {kind: look for kind, look in looks if kind in _OUTLINES})
        yield from intersection_lines(self, self.intersections, layer)

    def _toned(
        self, layer: Layer, some: Lit, look: Mapping[str, Uniform]
    ) -> Iterable[Pass]:
        for lens in lenses(some.bodies):
            lamps = lamp_uniforms(some.lights[:1] or (UPPER_LEFT,), lens)
            yield from lit_passes(
                _SHADER, lens, {**look, **lamps}, self.tolerance, both_sides=some.both_sides,
                paper=paper_of(layer, self.paper),
            )  # fmt: skip

    def _plainly(self) -> dict[str, Uniform]:
        """The tones of a program without lights: its colours, and a little of the paper's form; as
        much of them as of hues."""
        paper, own = 1.0 - self.hue, self.hue
        return {
            "blue": paper * self.blue, "yellow": paper * self.yellow,
            "alpha": paper * self.alpha + own * UNLIT, "beta": paper * self.beta + own,
        }  # fmt: skip

    def share(self, kind: str) -> float:
        return 1.0 if kind in _OUTLINES else self.inner

    def usual(self, kind: str) -> Look:
        """Ridges may be white."""
        found = super().usual(kind)
        return replace(found, ink=_WHITE) if self.white_edges and kind == "ridge" else found

    def _fine_lines(self, layer: Layer) -> Iterable[Lines]:
        """Lines that go on where they are hidden: of outlines, too."""
        hidden = self.hidden
        if hidden == "auto":
            hidden = "none" if is_dense(layer) else "dashed"
        fine = self.width * self.inner
        looks = {
            kind: replace(look, width=fine) if kind in _OUTLINES else look
            for kind, look in self.looks().items()
            if kind != "contour" or hidden != "none"
        }
        return self._inked(layer, looks, hidden)

    def _inked(
        self, layer: Layer, looks: Mapping[str, Look], hidden: str = "none"
    ) -> Iterable[Lines]:
        wanted = only(self.features(self.crease_angle, tolerance=self.tolerance), looks)
        return inked(
            layer, wanted, looks, texture_length=self.texture_length, hidden=cast(Any, hidden),
            hidden_share=self.hidden_share,
        )  # fmt: skip
