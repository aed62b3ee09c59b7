"""The score as a table: on the terminal and as a page of the docs."""

from __future__ import annotations

from dataclasses import dataclass

from tests.score.subjects import KINDS
from tests.score.views import SIZE, Tally

_COLUMNS = (
    "mesh", "polygons", "lines", "precision", "recall", "within 1.5 px", "dots", "worst view",
    "unsure", "beside",
)  # fmt: skip
HEAD = f"| {' | '.join(_COLUMNS)} |\n|---|--:|---|--:|--:|--:|--:|---|--:|--:|"


@dataclass(frozen=True)
class Row:
    """One mesh with one kind of line alone, or all together."""

    mesh: str
    polygons: int
    lines: str
    tally: Tally


def line(row: Row) -> str:
    tally = row.tally
    if not tally.ink and not tally.sure:
        shown = ["none there", "", "", str(len(tally.dots)), "", "", ""]
    else:
        shown = [
            _share(tally.precision),
            _share(tally.recall),
            _share(tally.close_recall),
            str(len(tally.dots)),
            f"{_share(tally.worst)} (view {tally.worst_view})",
            f"{100 * tally.unsure_share:.1f} %",
            f"{100 * tally.beside_share:.1f} %",
        ]
    return f"| {' | '.join([row.mesh, f'{row.polygons:,}', row.lines, *shown])} |"


def _share(value: float) -> str:
    """Rounded down, so that nothing looks better than it is."""
    return f"{int(value * 1e4) / 1e4:.4f}"


def complaint(row: Row, limit: float) -> str:
    tally = row.tally
    said = [
        f"{name} {value:.5f} < {limit}"
        for name, value in (("precision", tally.precision), ("recall", tally.recall))
        if value < limit
    ]
    if tally.dots:
        places = ", ".join(f"view {v} ({x}, {y})" for v, x, y in tally.dots[:8])
        said.append(f"{len(tally.dots)} dots: {places}")
    return f"{row.mesh}, {row.lines}: {'; '.join(said)}"


def page(rows: list[Row], command: str, count: int) -> str:
    table = "\n".join([HEAD, *map(line, rows)])
    missing = "" if len(KINDS) == 4 else f"\nThe style draws {' and '.join(KINDS)} only, so far.\n"
    return f"""# Picture score

    {command}

Drawn ink against the lines that connectivity says are seen: {count} views a mesh from all sides, in
turns parallel and in perspective, {SIZE} x {SIZE} pixels, style `raskar` at its defaults unless the
command says otherwise, each kind of line alone and all together.
{missing}
* **precision**: of the ink pixels (at least a tenth of the ink's colour), those within the line's
  width + 1 px of a line that is seen, or that may be.
* **recall**: of the places that are surely seen, every half pixel along the lines, those with ink
  within the line's width + 1 px; **within 1.5 px** asks for it closer, whatever the width.
* **dots**: 8-connected ink of fewer than 6 pixels, unless the picture's border cuts it or the true
  line there is as short.
* **worst view**: the lesser of precision and recall in the worst of the views.
* **unsure**: of the places that are seen, those within a pixel of an occlusion boundary or nearer
  to what lies there than depth resolves. **beside**: places that are hidden, but within a pixel of
  an occlusion boundary, over those that are seen. Ink may be on either or not; the second may
  exceed 100 % where a noisy surface turns away.

Truth: `tests/score/truth.py` (edges by welded corners, crossings by triangle against triangle) and
`tests/score/sight.py` (rays in float64), independent of what draws. `--out DIR` writes pictures
with the errors marked.

{table}
"""
