"""Creases of meshes that move: recomputed or flagged, as fresh ones have it."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.geometry.crease.creases import creases
from glshim.geometry.recovery.mesh import Mesh, mesh
from tests import look
from tests.odd_meshes import MESHES, sent_by


def _swollen(m: Mesh, by: float) -> Mesh:
    moved = m.moved((m.positions * (1.0, 1.0 + by, 1.0 - by / 2))[m.weld].astype(np.float32))
    assert moved is not None
    return moved


@pytest.mark.parametrize("rule", ["normals", "angle", "either"])
@pytest.mark.parametrize("name", MESHES)
def test_moved_is_like_fresh(name: str, rule: str) -> None:
    m = MESHES[name]
    sent = sent_by(m, 0.3, 5)
    was = creases(m, sent, rule=rule)
    assert was.adjacency.shape == (len(m.triangles), 6)
    other = _swollen(m, 0.5)
    found, fresh = was.moved(other, sent), creases(other, sent, rule=rule)
    for part in ("sides", "open", "triangles", "vertices", "adjacency", "differences", "normals"):
        assert np.array_equal(getattr(found, part), getattr(fresh, part)), part
    if rule == "normals" and was.criterion.least == 0.0:
        assert found.triangles is was.triangles
    assert was.moved(other).normals.shape == (len(was.moved(other).vertices), 3)


def book(degrees: float) -> np.ndarray:
    """Two pages that turn by so much at their back, along the y axis."""
    turn = np.radians(degrees)
    far = (np.cos(turn), np.sin(turn))
    return np.array([(-1, 0, 0), (-1, 1, 0), (0, 0, 0), (0, 1, 0),
                     (far[0], 0, far[1]), (far[0], 1, far[1])], np.float32)  # fmt: skip


def test_creases_by_angle_come_and_go_at_the_angle_and_those_by_normals_stay() -> None:
    first = mesh(look.batch(book(0.0), [[0, 2, 3, 1], [2, 4, 5, 3]]))
    parted = np.repeat(first.normals[:, None], 3, axis=1).astype(np.float32)
    parted[2:] += (0.5, 0.0, 0.0)  # the second page has normals of its own
    held = {
        "angle": creases(first, angle=np.radians(40.0)),
        "normals": creases(first, parted, rule="normals", least=0.0),
    }
    for degrees in (10.0, 39.9, 40.1, 80.0, 40.1, 39.9, 0.0, 60.0):
        m = first.moved(book(degrees)[first.weld])
        assert m is not None
        held = {rule: one.moved(m, parted if rule == "normals" else None)
                for rule, one in held.items()}  # fmt: skip
        inner = {rule: int((one.sides & ~one.open).sum()) for rule, one in held.items()}
        assert inner == {"angle": 2 if degrees > 40.0 else 0, "normals": 2}
        fresh = creases(m, angle=np.radians(40.0))
        assert np.array_equal(held["angle"].sides, fresh.sides)
        assert np.allclose(held["angle"].differences[held["angle"].triangles],
                           fresh.differences[fresh.triangles])  # fmt: skip


def test_moved_keeps_what_can_be_kept() -> None:
    m = MESHES["torus"]
    was = creases(m)
    found = was.moved(_swollen(m, 1e-3))
    assert found.triangles is was.triangles
    with pytest.raises(ValueError, match="connectivity"):
        was.moved(MESHES["cube"])
