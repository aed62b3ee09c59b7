"""Style ``edge_mesh``: feature edges from a mesh that is recovered from the stream.

M. McGuire, J. F. Hughes, "Hardware-Determined Feature Edges", NPAR 2004.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import degrees, radians
from typing import Any, ClassVar, cast

from glshim.errors import StyleError
from glshim.model.dihedral import crease_limits
from glshim.styling.media.ink import ink
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, Styler, option
from glshim.styling.textures import made
from glshim.styling.wishes import Features

from ..shared import options
from ..shared.tones import TONES, tone_passes
from .paper import PaperLook, paper_passes

_KINDS = {
    "contours": "contour", "ridges": "ridge", "valleys": "valley", "marked": "marked",
    "boundary": "boundary", "suggestive": "suggestive",
}  # fmt: skip
"""What options of a kind of lines begin with."""


def _width(what: str) -> float:
    width: float = option(2.5, help=f"width of {what}", low=0.5, high=64.0, unit="px")
    return width


@dataclass(frozen=True)
class EdgeMesh(Styler):
    """Ink on the feature edges of recovered meshes (McGuire & Hughes 2004)."""

    name: ClassVar[str] = "edge_mesh"

    contours: bool = option(True, help="ink where the surface turns away from the viewer")
    ridges: bool = option(True, help="ink where the dihedral angle is at most ridge_angle")
    valleys: bool = option(True, help="ink where the dihedral angle is more than valley_angle")
    marked: bool = option(False, help="ink where polygons of different colours meet")
    boundary: bool = option(True, help="ink on edges that have one polygon only")
    contour_width: float = _width("contours, outside the object")
    ridge_width: float = _width("ridges")
    valley_width: float = _width("valleys")
    marked_width: float = _width("marked edges")
    boundary_width: float = _width("boundary edges")
    contour_ink: Colour = options.colour("contours")
    ridge_ink: Colour = options.colour("ridges")
    valley_ink: Colour = options.colour("valleys")
    marked_ink: Colour = options.colour("marked edges")
    boundary_ink: Colour = options.colour("boundary edges")
    ridge_angle: float = option(
        120.0, help="greatest dihedral angle of a ridge", low=0.0, high=360.0, unit="degrees"
    )
    valley_angle: float = option(
        240.0, help="a valley has a greater dihedral angle", low=0.0, high=360.0, unit="degrees"
    )
    smooth: bool = option(
        False, help="contours of smooth surfaces run through polygons, not along their edges"
    )
    suggestive: bool = option(False, help="ink where contours would appear for near viewpoints")
    suggestive_width: float = option(
        1.5, help="width of suggestive contours", low=0.5, high=64.0, unit="px"
    )
    suggestive_ink: Colour = options.colour("suggestive contours")
    tolerance: float = options.tolerance(0.0)
    strokes: str = option(
        "chained",
        help="chained: joined along chains of edges; the others edge by edge on the GPU, as in the "
        "paper: lines of a pixel, quads, or quads on the outside of contours",
        choices=("chained", "thin", "quads", "half"),
    )
    caps: str = option(
        "round", help="ends of quads: round, the paper's two triangles, or none",
        choices=("round", "paper", "none"),
    )  # fmt: skip
    outer: bool = option(
        False, help="contours only against what is not the object itself (the stencil decides)"
    )
    hidden: str = option(
        "none", help="lines behind surfaces", choices=("none", "dashed", "dimmed", "solid")
    )
    hidden_share: float = option(
        1.0, help="share of the ink of hidden lines that are dashed or solid (strokes=chained)",
        low=0.0, high=1.0,
    )  # fmt: skip
    texture: str = options.texture("strokes")
    texture_length: float = options.texture_length("a stroke")
    parameters: str = option(
        "screen",
        help="how a texture lies along strokes that are not chained: from each edge's own number, "
        "or cut out of the screen",
        choices=("screen", "object"),
    )
    tone: str = option(
        "app",
        help="how surfaces are laid in, by the app's own colours: plain paper, hatched with a pen, "
        "charcoal on the paper's grain, flat bands, a watercolour wash",
        choices=("app", *TONES),
    )
    paper: str | Colour = option(
        "app", help="what is behind the surfaces: as the app drew it, or paper of a colour",
        choices=("app",), colour=True,
    )  # fmt: skip
    fill: str | Colour = options.fill()

    @property
    def wants_colours(self) -> bool:
        """Marked edges part them."""
        return self.marked

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.strokes != "chained" and not self.ridge_angle <= 180.0 <= self.valley_angle:
            raise StyleError(
                f"edge_mesh: strokes={self.strokes} takes a ridge_angle of at most 180 and a "
                "valley_angle of at least 180 degrees; strokes=chained takes any"
            )

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """Tones, and over them strokes of the chains of all batches, or passes over them. Batches
        that share a camera are one mesh."""
        yield from tone_passes(self.tone, self.paper, self.contour_ink, layer)
        if self.strokes != "chained":
            yield from paper_passes(self._look(), layer)
            return
        yield from self._chained(layer)
        if self.outer and self.contours:
            yield from paper_passes(self._silhouettes(), layer)

    def _chained(self, layer: Layer) -> Iterable[Lines]:
        wanted = Features(
            contours=self.contours and not self.outer,
            ridge_angle=radians(self.ridge_angle) if self.ridges else None,
            valley_angle=radians(self.valley_angle) if self.valleys else None,
            marked=self.marked,
            boundary=self.boundary,
            smooth=self.smooth,
            suggestive=self.suggestive,
            tolerance=self.tolerance,
        )
        medium = ink(
            widths={kind: getattr(self, f"{name}_width") for kind, name in _KINDS.items()},
            colours={kind: getattr(self, f"{name}_ink") for kind, name in _KINDS.items()},
            texture=self.texture,
            texture_length=self.texture_length,
            hidden=cast(Any, self.hidden),
            hidden_share=self.hidden_share,
        )
        yield Lines(layer.bodies, wanted, medium)

    def _look(self) -> PaperLook:
        """The options as the paper's passes have them."""
        image, length = None, 0.0
        if self.texture != "none":
            image, length, _ = made(
                self.texture, self.contour_width, self.texture_length
            )
        limits = crease_limits(radians(self.ridge_angle), radians(self.valley_angle))
        return PaperLook(
            strokes=cast(Any, self.strokes),
            caps=cast(Any, self.caps),
            drawn=(self.contours, self.ridges, self.valleys, self.marked, self.boundary),
            widths=(
                self.contour_width, self.ridge_width, self.valley_width, self.marked_width,
                self.boundary_width,
            ),
            inks=(
                self.contour_ink, self.ridge_ink, self.valley_ink, self.marked_ink,
                self.boundary_ink,
            ),
            ridge_angle=degrees(limits[0]),
            valley_angle=degrees(limits[1]),
            hidden=cast(Any, self.hidden),
            outer=self.outer,
            image=image,
            length=length,
            parameters=cast(Any, self.parameters),
        )  # fmt: skip

    def _silhouettes(self) -> PaperLook:
        """Contours against what is not the object itself, alone."""
        drawn = (True, False, False, False, False)
        return replace(self._look(), strokes="half", caps="round", drawn=drawn, hidden="none")
