"""Which lines a style wants, as plain values: linework finds them."""

from __future__ import annotations

from dataclasses import dataclass

from glshim.styling.former import accept, by_order


@dataclass(frozen=True, slots=True)
class Pattern:
    """What repeats along strokes."""

    lengths: tuple[float, ...]
    """Pixels after which it repeats on silhouettes, ridges, valleys and intersections; 0: lines
    of that kind have none."""
    middle: float = 0.0
    """Pixels outside an outline's sides at which its length is measured: what counts at corners."""
    corner: float | None = None
    """Radians; where a stroke turns by more, a hand lifts the pen, and strokes begin anywhere in
    the pattern. None: nobody asks (`glshim.linework.hand`)."""
    straight: bool = False
    """Nothing goes on beyond ends that a stroke does not run into straight on."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Choice:
    """Which lines a style wants, decided polygon by polygon."""

    silhouettes: bool = False
    ridge_angle: float | None = None
    """Greatest dihedral angle of a ridge (`glshim.model.dihedral`), radians; None for no ridges."""
    valley_angle: float | None = None
    """A valley has a greater dihedral angle, radians; None for no valleys."""
    intersections: bool = False
    connectivity: bool = True
    """Whether neighbouring polygons are looked for. False: depth alone decides, as in the paper."""
    pattern: Pattern | None = None
    """What repeats along strokes (the last floats of a record), or None for plain lines."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Features:
    """Which feature edges a style wants, of the meshes that polygons make."""

    contours: bool = False
    ridge_angle: float | None = None
    """Greatest dihedral angle of a ridge (`glshim.model.dihedral`), radians; None for no ridges."""
    valley_angle: float | None = None
    """A valley has a greater dihedral angle, radians; None for no valleys."""
    marked: bool = False
    boundary: bool = False
    smooth: bool = False
    """Whether contours on smooth surfaces run through polygons, where interpolated normals are
    perpendicular to the view, rather than along edges."""
    suggestive: bool = False
    """Suggestive contours."""
    tolerance: float = 0.0
    """Distance in object units at which positions count as one vertex."""
    pattern: Pattern | None = None
    """What repeats along strokes, or None."""


accept(
    Choice,
    by_order(
        "silhouettes", "ridge_angle", "valley_angle", "intersections", "connectivity", "pattern"
    ),
    "Choice(silhouettes=..., ridge_angle=..., ...), by name",
)
accept(
    Features,
    by_order(
        "contours", "ridge_angle", "valley_angle", "marked", "boundary", "smooth", "suggestive",
        "tolerance", "pattern",
    ),
    "Features(contours=..., ridge_angle=..., ...), by name",
)  # fmt: skip
