"""The styles that are scored, a row each: which kinds of line they draw and how far from the true
line their ink may lie."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, fields
from itertools import chain
from typing import Any

from glshim_stylers.crease import Crease
from glshim_stylers.edge_mesh import EdgeMesh
from glshim_stylers.fins import Fins
from glshim_stylers.raskar import Raskar
from glshim_stylers.shared.kinds import LineStyle

from glshim.styling.protocol import Styler
from tests.score import truth
from tests.score.smooth import CREASE_ANGLE

_OPTIONS = frozenset(f.name for f in fields(Raskar))
_SWITCHES = {kind: "contours" if kind == "silhouettes" else kind for kind in truth.KINDS}
KINDS = tuple(kind for kind, switch in _SWITCHES.items() if switch in _OPTIONS)
"""The kinds of line that raskar draws."""
_ANGLES = {"ridge_angle": truth.RIDGE_ANGLE, "valley_angle": truth.VALLEY_ANGLE}
_WELDED = {"tolerance": 1e-5}
"""The teapot's corners come from GLUT in single precision, patch by patch."""


@dataclass(frozen=True)
class Subject:
    """A style that is scored."""

    styler: Callable[..., Styler]
    switches: Mapping[str, tuple[str, ...]]
    """Kinds of line (`truth.lines`), and the options that switch each on."""
    widths: Mapping[str, tuple[str, ...]]
    """The options of each kind's width in pixels; the first one counts."""
    reach: float = 1.0
    """Of that width, from the true line on: 1 where lines lie outside the object; 0.5 where they
    lie on both sides."""
    welds: bool = False
    """Whether corners are made equal for it, that has no tolerance."""
    fixed: Mapping[str, Any] = field(default_factory=dict)
    """Options that are not the defaults."""

    def style(self, kinds: Iterable[str], width: float | None = None) -> Styler:
        """It with lines of these kinds only; width: its option in pixels, of all of them."""
        wanted = frozenset(kinds)
        options: dict[str, Any] = dict(self.fixed)
        for kind, names in self.switches.items():
            options |= dict.fromkeys(names, kind in wanted)
        if width is not None:
            options |= dict.fromkeys(chain(*self.widths.values()), width)
        return self.styler(**options)

    def reaches(self, style: Styler, kind: str) -> float:
        """Pixels from a true line of a kind to where its ink ends."""
        assert isinstance(style, LineStyle)
        return self.reach * style.look(self.widths[kind][0].removesuffix("_width")).width


SUBJECTS: dict[str, Subject] = {
    "raskar": Subject(
        Raskar,
        {kind: (_SWITCHES[kind],) for kind in KINDS},
        {kind: (f"{_SWITCHES[kind].removesuffix('s')}_width",) for kind in KINDS},
        fixed={name: value for name, value in _ANGLES.items() if name in _OPTIONS},
    ),
    "edge_mesh": Subject(
        EdgeMesh,
        {"silhouettes": ("contours", "boundary"), "ridges": ("ridges",), "valleys": ("valleys",)},
        {
            "silhouettes": ("contour_width", "boundary_width"),
            "ridges": ("ridge_width",),
            "valleys": ("valley_width",),
        },
        fixed=_ANGLES | _WELDED,
    ),
    "crease": Subject(
        Crease,
        {"creases": ("ridges", "valleys", "boundary"), "smooth": ("contours",)},
        {
            "creases": ("ridge_width", "valley_width", "boundary_width"),
            "smooth": ("contour_width",),
        },
        reach=0.5,
        welds=True,
        fixed={"crease_angle": CREASE_ANGLE, "rule": "angle"},
    ),
    "fins": Subject(
        Fins, {"silhouettes": ()}, {"silhouettes": ("contour_width", "boundary_width")}, reach=0.5,
        fixed=_WELDED,
    ),
}
