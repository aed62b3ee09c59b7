"""Kinds of lines, and the options that each has: width, ink, texture and dash, which are those of
all lines of the style until they are set."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from math import radians
from types import MappingProxyType
from typing import Any

from glshim.styling.protocol import Colour, Styler, option
from glshim.styling.renamed import Renamed
from glshim.styling.textures import TEXTURES
from glshim.styling.wishes import Features

from .options import folds

SWITCHES = {
    "contour": "contours", "boundary": "boundary", "ridge": "ridges", "valley": "valleys",
    "intersection": "intersections", "marked": "marked", "suggestive": "suggestive",
}  # fmt: skip
"""The option that switches a kind, which is also what wishes and media call it."""
USUAL = ("contour", "boundary", "ridge", "valley", "intersection")
"""The kinds of `FeatureLines`."""
_PARTS = ("width", "ink", "texture", "dash")
"""What each kind has."""


@dataclass(frozen=True, slots=True)
class Look:
    """What lines of one kind look like."""

    width: float
    """Pixels."""
    ink: Colour
    texture: str = "none"
    dash: float = 0.0
    """Pixels of a dash with the gap after it; 0: none."""

    @property
    def stroke(self) -> tuple[str, float, float] | None:
        """What lines must have in common to be drawn with one picture; None: they need none."""
        if self.texture == "none" and self.dash <= 0.0:
            return None
        return self.texture, self.dash, self.width if self.dash > 0.0 else 0.0


class LineStyle(Styler):
    """A style of lines of several kinds, each of a class below. The options of all lines are fields
    of the style itself, with its own defaults."""

    width: float
    ink: Colour
    texture: str
    texture_length: float
    dash: float

    @classmethod
    @cache
    def kinds(cls) -> tuple[str, ...]:
        """Those that it may draw."""
        return tuple(kind for kind in SWITCHES if hasattr(cls, f"{kind}_width"))

    def looks(self) -> dict[str, Look]:
        """Of every kind that is switched on."""
        return dict(self._looks)

    @cached_property
    def _looks(self) -> dict[str, Look]:
        return {kind: self.look(kind) for kind in self.kinds() if self.is_on(kind)}

    def is_on(self, kind: str) -> bool:
        """Whether lines of a kind are drawn."""
        return kind in self.kinds() and getattr(self, SWITCHES[kind]) not in (False, "off")

    def look(self, kind: str) -> Look:
        """Of a kind: its own options, and those of all lines where these are not set."""
        usual = self.usual(kind)
        own = (getattr(self, f"{kind}_{part}", None) for part in _PARTS)
        return Look(*(getattr(usual, part) if value is None else value
                      for part, value in zip(_PARTS, own, strict=True)))  # fmt: skip

    def usual(self, kind: str) -> Look:
        """Of a kind whose own options are not set."""
        return Look(self.width * self.share(kind), self.ink, self.texture, self.dash)

    def share(self, kind: str) -> float:
        """Of the width of all lines, for a kind whose own is not set."""
        return 1.0

    def features(self, crease_angle: float, **more: Any) -> Features:
        """The lines of meshes that it draws; crease_angle: degrees, see `folds`."""
        ridge, valley = map(radians, folds(crease_angle))
        return Features(
            contours=self.is_on("contour"),
            ridge_angle=ridge if self.is_on("ridge") else None,
            valley_angle=valley if self.is_on("valley") else None,
            boundary=self.is_on("boundary"),
            **more,
        )


def width_of(lines: str) -> Any:
    return option(
        2.5, follows="width", help=f"width of {lines}", low=0.5, high=64.0, unit="px"
    )


def ink_of(lines: str) -> Any:
    return option("#000000", follows="ink", help=f"colour of {lines}")


def texture_of(lines: str) -> Any:
    return option(
        "none", follows="texture", help=f"texture of {lines}", choices=("none", *TEXTURES),
        picture=True,
    )  # fmt: skip


def dash_of(lines: str) -> Any:
    return option(
        0.0, follows="dash", help=f"dash length of {lines}", low=0.0, high=256.0, unit="px"
    )


@dataclass(frozen=True)
class Contours(LineStyle):
    """Where a surface turns away from the viewer."""

    contours: bool = option(True, help="draw contours: where a surface turns away from the viewer")
    contour_width: float | None = width_of("contours")
    contour_ink: Colour | None = ink_of("contours")
    contour_texture: str | None = texture_of("contours")
    contour_dash: float | None = dash_of("contours")


@dataclass(frozen=True)
class Boundaries(LineStyle):
    """Edges of one polygon."""

    boundary: bool = option(True, help="draw boundary edges: those of one polygon only")
    boundary_width: float | None = width_of("boundary edges")
    boundary_ink: Colour | None = ink_of("boundary edges")
    boundary_texture: str | None = texture_of("boundary edges")
    boundary_dash: float | None = dash_of("boundary edges")


@dataclass(frozen=True)
class Ridges(LineStyle):
    """Creases that stand out."""

    ridges: bool = option(True, help="draw ridges: creases that stand out")
    ridge_width: float | None = width_of("ridges")
    ridge_ink: Colour | None = ink_of("ridges")
    ridge_texture: str | None = texture_of("ridges")
    ridge_dash: float | None = dash_of("ridges")


@dataclass(frozen=True)
class Valleys(LineStyle):
    """Creases that lie in."""

    valleys: bool = option(True, help="draw valleys: creases that lie in")
    valley_width: float | None = width_of("valleys")
    valley_ink: Colour | None = ink_of("valleys")
    valley_texture: str | None = texture_of("valleys")
    valley_dash: float | None = dash_of("valleys")


@dataclass(frozen=True)
class Intersections(LineStyle):
    """Where polygons pass through each other. The style has the option ``intersections``."""

    intersection_width: float | None = width_of("intersections")
    intersection_ink: Colour | None = ink_of("intersections")
    intersection_texture: str | None = texture_of("intersections")
    intersection_dash: float | None = dash_of("intersections")


@dataclass(frozen=True)
class MarkedEdges(LineStyle):
    """Where colours meet. The style has the option ``marked``."""

    marked_width: float | None = width_of("marked edges")
    marked_ink: Colour | None = ink_of("marked edges")
    marked_texture: str | None = texture_of("marked edges")
    marked_dash: float | None = dash_of("marked edges")


@dataclass(frozen=True)
class SuggestiveContours(LineStyle):
    """Where contours would appear nearby. The style has the option ``suggestive``."""

    suggestive_width: float | None = width_of("suggestive contours")
    suggestive_ink: Colour | None = ink_of("suggestive contours")
    suggestive_texture: str | None = texture_of("suggestive contours")
    suggestive_dash: float | None = dash_of("suggestive contours")


@dataclass(frozen=True)
class FeatureLines(Intersections, Valleys, Ridges, Boundaries, Contours):
    """The kinds that most styles draw."""


_GROUPS = {
    "silhouette": ("contour",),
    "outline": ("contour", "boundary"),
    "crease": ("ridge", "valley"),
    "border": ("boundary",),
    "line": ("ridge", "valley", "intersection"),
}
"""Other words for kinds, and for several at once."""


def former_names(kinds: Iterable[str], **more: Renamed) -> Mapping[str, Renamed]:
    """What options of kinds may be called, too: ``silhouette_width``, ``crease_ink``, ``creases``.
    more: old names of other options."""
    found: dict[str, Renamed] = {}
    for word, group in _GROUPS.items():
        meant = [kind for kind in group if kind in kinds]
        if not meant:
            continue
        for part in _PARTS:
            found[f"{word}_{part}"] = Renamed(tuple(f"{kind}_{part}" for kind in meant))
        switches = tuple(SWITCHES[kind] for kind in meant if kind != "intersection")
        if word != "line" and switches:
            found[f"{word}s"] = Renamed(switches)
    return MappingProxyType({**found, **more})
