"""Counting of outcomes, and the table of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from glshim.outputs.gl.backend import Backend
from tests.decision.folds import DIRECTIONS, Kind, Variant, views
from tests.decision.sweep import BROKEN, NONE, WHOLE, WIDTH, Distance, Outcome, outcomes
from tests.styles import only

COUNTS = ("missing", "extra", "broken", "band_broken")
"""What must be 0 in every row."""
_CLOSE = (-0.9, -0.5, -0.2, -0.1, -0.05, -0.02, 0.02, 0.05, 0.1, 0.2, 0.5, 0.9)
"""Degrees from the threshold of further folds, within the band."""


@dataclass
class Row:
    """Pictures of one threshold, way of sending and distance."""

    kind: Kind
    threshold: float
    variant: Variant
    distance: Distance
    pictures: int = 0
    lines: int = 0
    """Pictures in which a line belongs."""
    missing: int = 0
    """None drawn where one belongs, outside the band."""
    extra: int = 0
    """A whole one drawn where none belongs, outside the band."""
    broken: int = 0
    """Drawn in part, outside the band."""
    band: int = 0
    """Pictures within the band."""
    band_drawn: int = 0
    band_broken: int = 0
    faults: list[Outcome] = field(default_factory=list)

    def count(self, outcome: Outcome) -> None:
        """Take one picture in."""
        found, belongs = outcome.found, outcome.view.drawn(self.kind, self.threshold)
        self.pictures += 1
        self.lines += belongs
        if outcome.view.in_band(self.threshold):
            self.band += 1
            self.band_drawn += found == WHOLE
            self.band_broken += found == BROKEN
        else:
            self.broken += found == BROKEN
            self.missing += belongs and found == NONE
            self.extra += not belongs and found == WHOLE
            if found == (WHOLE if belongs else NONE):
                return
            self.faults.append(outcome)
            return
        if found == BROKEN:
            self.faults.append(outcome)


def all_angles(threshold: float) -> list[float]:
    """1 to 359 degrees in steps of 1, and folds within the band seen from either side."""
    return [float(a) for a in range(1, 360)] + _close(threshold, _CLOSE)


def quick_angles(threshold: float) -> list[float]:
    """The ends, nearly closed ones, both sides of the threshold, and a few drawn by a seed."""
    seeded = np.random.default_rng(round(10 * threshold)).integers(2, 359, 6).tolist()
    beside = [threshold - 1, threshold + 1, 359 - threshold, 361 - threshold]
    return [1.0, 5.0, 355.0, 359.0, *map(float, beside + seeded), *_close(threshold, (-0.02, 0.05))]


def _close(threshold: float, steps: Sequence[float]) -> list[float]:
    return [a for step in steps for a in (threshold + step, 360 - threshold - step) if 0 < a < 360]


def row(  # noqa: PLR0917
    backend: Backend,
    kind: Kind,
    threshold: float,
    variant: Variant,
    distance: Distance,
    angles: Sequence[float],
    count: int = DIRECTIONS,
    **options: Any,
) -> Row:
    """Render folds of angles (degrees) in the current window from count directions each; options
    are further ones of the style."""
    made = Row(kind, threshold, variant, distance)
    options = {f"{kind}_angle": threshold, f"{kind}_width": WIDTH} | options
    style = only(f"{kind}s", **options)
    seen = [view for angle in angles for view in views(angle, count)]
    for outcome in outcomes(backend, style, seen, distance, variant):
        made.count(outcome)
    return made


_HEAD = """\
| line | fold sent as | distance | pictures | with a line | missing | extra | in part \
| within the band | drawn | in part |
|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|"""


def markdown(rows: Sequence[Row], *, header: bool = False) -> str:
    """Rows as lines of a Markdown table."""
    lines = [_HEAD] if header else []
    for r in rows:
        sign = "≤" if r.kind == "ridge" else ">"
        cells = (
            f"{r.kind} {sign} {r.threshold:g}°", r.variant,
            f"{r.distance.away:g} ({r.distance.pixels:.0f} px)", f"{r.pictures:,}", f"{r.lines:,}",
            r.missing, r.extra, r.broken, r.band, r.band_drawn, r.band_broken,
        )  # fmt: skip
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines)


def document(rows: Sequence[Row], arguments: str) -> str:
    """docs/measurements/decision.md."""
    faults = sum(getattr(r, name) for r in rows for name in COUNTS)
    pictures = sum(r.pictures for r in rows)
    return f"""\
# Which folds are ridges and which valleys

Two quads meet at a fold of 1 to 359 degrees, in steps of 1. They are rendered small, from
{DIRECTIONS} directions and at three distances, through the fixed function and style `raskar` with
one kind of line on. A ridge is expected where the angle that the viewer sees is at most the
threshold, a valley where it is greater. Where both faces show their front, the viewer sees the
angle of the solid; where both show their back (the inside of a sheet), 360 degrees minus that
angle; where one of each shows, a silhouette, which is neither. The directions follow the
fold: from 22 of 50 both fronts are visible, from 22 both backs (both faces of a fold of 1 degree
are visible only from a wedge 1 degree wide), and from 6 one of each.

A fold counts as drawn if ink lies within 1 px along at least 99 % of it (and, if both faces
are at least 3 px wide in the picture, on 99 % of all pixels within 1 px; lines are
{WIDTH:g} px wide), as not drawn if no pixel carries ink, and as *in part* otherwise.
*Missing* and *extra* are wrong decisions outside a band of 1 degree around the threshold. Within
the band either decision is right, but never a part; besides whole degrees, folds are tested
{", ".join(f"{s:g}" for s in _CLOSE if s > 0)} degrees on either side.

The fold is sent as one batch of two quads, as two objects (each with a batch and a modelview: the
fold is computed twice), and as one batch cut into four pieces. A fold is 0.9 units long; the
pixels given are its length on the screen, seen face on.

    python -m tests.decision {arguments}

{markdown(rows, header=True)}

{pictures:,} pictures, {faults} faults.
"""
