"""The picture score on some of its views; `python -m tests.score` is the full table."""

from __future__ import annotations

import pytest

from glshim.outputs.gl.backend import Backend
from tests import look
from tests.score import meshes, subjects, views
from tests.score.__main__ import LIMIT

VIEWS = {"scan": (4, 9, 16)}
"""Of the 24 of the command, those that are drawn here; else `SOME`."""
SOME = (2, 5, 6, 11, 17, 20)


@pytest.fixture(scope="module")
def scored():
    """Tallies of each mesh, by kind of line alone and "all"."""
    batches = {name: make() for name, make in meshes.MESHES.items()}
    tallies: dict[str, dict[str, views.Tally]] = {name: {} for name in batches}
    with look.window(views.SIZE, views.SIZE):
        backend = Backend.attach()
        for name, batch in batches.items():
            for view in views.look_at_views(backend, batch, only=VIEWS.get(name, SOME)):
                for kind, verdict in view.verdicts.items():
                    tallies[name].setdefault(kind, views.Tally()).add(view.number, verdict)
    return tallies


@pytest.mark.parametrize("kind", [*subjects.KINDS, "all"])
@pytest.mark.parametrize("name", list(meshes.MESHES))
def test_ink_lies_where_lines_are_and_nowhere_else(scored, name, kind):
    """The target for the whole picture. Of one kind of line alone there may be too little for a
    share to say much, and where another kind's ink would hide it a speck may stay."""
    tally = scored[name][kind]
    limit = LIMIT if kind == "all" else 0.99
    if kind == "all" or tally.sure > 2000:
        assert tally.precision >= limit, (tally.precision, tally.worst_view)
        assert tally.recall >= limit, (tally.recall, tally.worst_view)
    assert len(tally.dots) <= (0 if kind == "all" else 8), tally.dots


def test_the_truth_is_not_empty(scored):
    """Every kind of line is there to be found, and little of it is left undecided."""
    sure = {name: {kind: t.sure for kind, t in of.items()} for name, of in scored.items()}
    for name in meshes.MESHES:
        assert sure[name]["silhouettes"] > 3000, name
    for name in ("teapot", "part"):
        assert sure[name]["intersections"] > 500, name
    for name in ("gear", "part", "terrain", "scan"):
        assert sure[name]["ridges"] > 500, name
    for name in ("gear", "terrain", "scan"):
        assert sure[name]["valleys"] > 500, name
    for name in ("torus", "gear", "part"):
        assert scored[name]["all"].unsure_share < 0.05, name
    for name in ("teapot", "terrain", "scan"):
        assert scored[name]["all"].unsure_share < 0.25, name
