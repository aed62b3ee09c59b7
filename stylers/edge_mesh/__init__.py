"""Style ``edge_mesh``: feature edges from a mesh that is recovered from the stream.

M. McGuire, J. F. Hughes, "Hardware-Determined Feature Edges", NPAR 2004.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from math import degrees, radians
from typing import Any, ClassVar, cast

from glshim.errors import StyleError
from glshim.model.dihedral import crease_limits
from glshim.styling.passes import Pass
from glshim.styling.pictures import Image
from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names
from glshim.styling.textures import made
from glshim.styling.wishes import Features

from ..shared import options
from ..shared.intersections import intersection_lines
from ..shared.kinds import (
    Boundaries,
    Contours,
    Intersections,
    Look,
    MarkedEdges,
    Ridges,
    SuggestiveContours,
    Valleys,
    former_names,
)
from ..shared.strokes import inked
from ..shared.tones import BY_LIGHT, TONES, tone_passes
from .paper import PaperLook, paper_passes

_PAPER_KINDS = ("contour", "ridge", "valley", "marked", "boundary")
"""In the order of what `PaperLook` says of each."""
_FINE = 0.6
"""Width of suggestive contours, of one of other lines."""


@takes_old_names
@dataclass(frozen=True)
class EdgeMesh(
    SuggestiveContours, MarkedEdges, Intersections, Valleys, Ridges, Boundaries, Contours
):
    """Ink on the feature edges of recovered meshes (McGuire & Hughes 2004)."""

    name: ClassVar[str] = "edge_mesh"
    former: ClassVar[Mapping[str, Renamed]] = former_names(
        ("contour", "ridge", "valley", "intersection", "marked", "boundary", "suggestive")
    )

    marked: bool = option(False, help="draw edges where polygons of different colours meet")
    suggestive: bool = option(
        False, help="draw suggestive contours: where contours would appear from nearby viewpoints"
    )
    width: float = options.width(2.5)
    ink: Colour = options.ink("#000000", "all lines, and of the strokes of a tone")
    texture: str = options.texture()
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    crease_angle: float = options.crease_angle(60.0)
    ridge_angle: float | None = options.ridge_angle()
    valley_angle: float | None = options.valley_angle()
    intersections: str = options.intersections("off")
    smooth: bool = option(
        False, help="draw contours of smooth surfaces through polygons, not along their edges"
    )
    tolerance: float = options.tolerance(0.0)
    strokes: str = option(
        "chained",
        help="how edges become strokes: joined into chains (chained), or each by itself on the "
        "GPU, as in the paper: lines of one pixel, quads, or quads outside of contours (half)",
        choices=("chained", "thin", "quads", "half"),
    )
    caps: str = option(
        "round", help="ends of quads: round, the paper's two triangles, or none",
        choices=("round", "paper", "none"),
    )  # fmt: skip
    outer: bool = option(
        False, help="draw contours only where an object ends, not inside it (by the stencil buffer)"
    )
    hidden: str = options.hidden("solid")
    hidden_share: float = options.hidden_share(1.0, " (strokes=chained)")
    parameters: str = option(
        "screen",
        help="texture coordinates of strokes that are not chained: cut out of the screen, or from "
        "each edge's own number (object)",
        choices=("screen", "object"),
    )
    tone: str = option(
        "app",
        help="surfaces: as the program draws them (app), plain paper, pen hatching, charcoal "
        "grain, flat bands (cel), or a watercolour wash",
        choices=("app", *TONES),
    )
    paper: str | Colour = options.paper("app")
    fill: str | Colour = options.fill()
    own_ink: str = options.own_ink()

    @property
    def wants_colours(self) -> bool:
        """Marked edges part them."""
        return self.marked

    @property
    def wants_lights(self) -> bool:
        """Hatching goes by them."""
        return self.tone in BY_LIGHT

    def __post_init__(self) -> None:
        super().__post_init__()
        ridge, valley = self._angles()
        if self.strokes != "chained" and not ridge <= 180.0 <= valley:
            raise StyleError(
                f"edge_mesh: strokes={self.strokes} takes a ridge_angle of at most 180 and a "
                "valley_angle of at least 180 degrees; strokes=chained takes any"
            )

    def share(self, kind: str) -> float:
        return _FINE if kind == "suggestive" else 1.0

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """Tones, and over them strokes of the chains of all batches, or passes over them. Batches
        that share a camera are one mesh."""
        yield from tone_passes(self.tone, self.paper, self.ink, layer, self.tolerance)
        if self.strokes != "chained":
            yield from paper_passes(self._look(), layer)
        else:
            yield from self._chained(layer)
            if self.outer and self.contours:
                yield from paper_passes(self._silhouettes(), layer)
        yield from intersection_lines(self, self.intersections, layer)

    def _angles(self) -> tuple[float, float]:
        """Of ridges and of valleys, degrees."""
        turn = self.crease_angle
        return (
            180.0 - turn if self.ridge_angle is None else self.ridge_angle,
            180.0 + turn if self.valley_angle is None else self.valley_angle,
        )

    def _chained(self, layer: Layer) -> Iterable[Lines]:
        ridge, valley = self._angles()
        wanted = Features(
            contours=self.contours and not self.outer,
            ridge_angle=radians(ridge) if self.ridges else None,
            valley_angle=radians(valley) if self.valleys else None,
            marked=self.marked,
            boundary=self.boundary,
            smooth=self.smooth,
            suggestive=self.suggestive,
            tolerance=self.tolerance,
        )
        return inked(
            layer, wanted, self.looks(), texture_length=self.texture_length,
            hidden=cast(Any, self.hidden), hidden_share=self.hidden_share,
        )  # fmt: skip

    def _look(self) -> PaperLook:
        """The options as the paper's passes have them."""
        looks = [self.look(kind) for kind in _PAPER_KINDS]
        pictures = [self._picture(look, looks[0].width) for look in looks]
        limits = crease_limits(*map(radians, self._angles()))
        return PaperLook(
            strokes=cast(Any, self.strokes),
            caps=cast(Any, self.caps),
            drawn=tuple(self.is_on(kind) for kind in _PAPER_KINDS),
            widths=tuple(look.width for look in looks),
            inks=tuple(look.ink for look in looks),
            ridge_angle=degrees(limits[0]),
            valley_angle=degrees(limits[1]),
            hidden=cast(Any, self.hidden),
            outer=self.outer,
            images=tuple(image for image, _ in pictures),
            lengths=tuple(length for _, length in pictures),
            parameters=cast(Any, self.parameters),
        )

    def _picture(self, look: Look, width: float) -> tuple[Image | None, float]:
        """What strokes of a look are drawn with, and the pixels after which it repeats."""
        if self.strokes == "thin":
            return None, look.dash
        if look.stroke is None:
            return None, 0.0
        measure = look.width if look.dash > 0.0 else width
        image, length, _ = made(look.texture, measure, self.texture_length, look.dash)
        return image, length

    def _silhouettes(self) -> PaperLook:
        """Contours against what is not the object itself, alone."""
        drawn = (True, False, False, False, False)
        return replace(self._look(), strokes="half", caps="round", drawn=drawn, hidden="none")
