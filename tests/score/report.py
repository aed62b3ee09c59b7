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

Drawn ink is compared with the lines that should be visible according to the mesh: {count} views of
each mesh from all sides, alternately parallel and in perspective, at {SIZE} x {SIZE} pixels. The
style is `raskar` with its defaults unless the command says otherwise, with each kind of line alone
and with all together.
{missing}
* **precision**: the share of ink pixels (at least a tenth of the ink's colour) that lie within the
  line's width + 1 px of a line that is visible or may be.
* **recall**: the share of surely visible places, sampled every half pixel along the lines, that
  have ink within the line's width + 1 px; **within 1.5 px** is the same for that distance.
* **dots**: 8-connected ink of fewer than 6 pixels, unless the picture's border cuts it or the true
  line there is as short.
* **worst view**: the lower of precision and recall in the worst view.
* **unsure**: the share of visible places that lie within a pixel of an occlusion boundary, or
  nearer to what lies there than depth can resolve. **beside**: hidden places within a pixel of an
  occlusion boundary, divided by visible ones; it may exceed 100 % where a noisy surface turns away.
  There the score accepts ink and no ink.

The true lines come from `tests/score/truth.py` (edges of welded corners, intersections of every
pair of triangles) and `tests/score/sight.py` (rays in float64). They do not
depend on what draws. `--out DIR` writes pictures with the errors marked.

{table}
"""
