"""Procedural deformation (Raskar 2001, 1.2): ridges and valleys of the moving demos come and go.

Only the demos' meshes at a time, no window: each is one mesh whose corners move, so an edge is the
same edge at every time.
"""

import numpy as np
import pytest
from numpy.typing import NDArray

from demo_apps import blob, flag
from glshim.geometry.edges.edges import edges
from glshim.model.batch import PolygonBatch
from tests import look

RIDGE, VALLEY = 120.0, 240.0  # degrees: sharper than the one, deeper than the other
STEP = 1 / 30  # seconds, two frames
SIGHT = 0.25  # degrees: float32 corners say no more

FLAG_QUADS = (
    np.arange(flag.ROWS)[:, None, None] * (flag.COLUMNS + 1)
    + np.arange(flag.COLUMNS)[:, None]
    + (0, flag.COLUMNS + 1, flag.COLUMNS + 2, 1)
).reshape(-1, 4)


def flag_at(time: float) -> PolygonBatch:
    return look.batch(flag.cloth(time).reshape(-1, 3), FLAG_QUADS)


def blob_at(time: float) -> PolygonBatch:
    return look.batch(blob.body(time), blob.QUADS)


MOVING = {
    "flag": (flag_at, np.arange(0.0, 14.0, STEP)),  # two gusts, two lulls
    "blob": (blob_at, np.arange(0.0, 3 * (blob.STAY + blob.CHANGE) + 1.0, STEP)),  # all shapes
}


@pytest.fixture(scope="module", params=MOVING)
def folds(request: pytest.FixtureRequest) -> NDArray[np.float64]:
    """(times, edges) in degrees; the edges in the order of their corners, alike at all times."""
    at, times = MOVING[request.param]
    rows = []
    for time in times:
        batch = at(float(time))
        found = edges(batch)
        parents = [found.parents[found.polygon[side]] for side in found.pairs]
        whole = parents[0] != parents[1]  # else the cut of a bent quad
        first, second = (side[whole] for side in found.pairs)
        corner = {row.tobytes(): k for k, row in enumerate(batch.positions)}
        ends = found.sides[first].reshape(-1, 2, 3)
        key = np.sort([[corner[end.tobytes()] for end in pair] for pair in ends], axis=1).T
        rows.append(np.degrees(found.fold(first, second))[np.lexsort(key)])
    assert len({len(row) for row in rows}) == 1, "an edge was lost on the way"
    return np.stack(rows)


def test_ridges_and_valleys_come_and_all_go(folds: NDArray[np.float64]) -> None:
    ridge, valley = folds < RIDGE, folds > VALLEY
    flat = (folds > RIDGE + SIGHT) & (folds < VALLEY - SIGHT)
    assert ridge.any(axis=0).sum() > 20
    assert valley.any(axis=0).sum() > 20
    sharp = (ridge | valley).any(axis=0)
    assert flat[:, sharp].any(axis=0).all(), "a fold that never goes"
    assert flat.all(axis=1).any(), "no moment without ridges and valleys"


def test_each_crossing_is_gradual(folds: NDArray[np.float64]) -> None:
    """A line appears because its edge bends through the threshold, not because the mesh jumps."""
    assert np.abs(np.diff(folds, axis=0)).max() < 30.0


def test_the_blob_is_closed_and_wound_counter_clockwise() -> None:
    for time in np.arange(0.0, 3 * (blob.STAY + blob.CHANGE), 0.4):
        batch = blob_at(float(time))
        found = edges(batch)
        assert not len(found.singles) and not len(found.crowds[0])
        first, second = found.pairs
        assert (found.forward[first] != found.forward[second]).all()
        a, b, c, d = batch.positions[blob.QUADS].astype(np.float64).transpose(1, 0, 2)
        volume = (np.cross(c - a, d - b) * (a + b + c + d)).sum() / 24
        assert volume > 1.0
