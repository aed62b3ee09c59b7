"""Crease differences: what can be read from them, and what cannot."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.geometry.crease.creases import creases, decoded
from tests.odd_meshes import MESHES, beam, sent_by, zigzag


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("cut", [0.05, 0.3, 1.0])
def test_the_differences_of_crooked_creases_decode(name: str, cut: float) -> None:
    m = MESHES[name]
    for seed in range(4):
        found = creases(m, sent_by(m, cut, seed), rule="normals", least=0.0)
        assert np.array_equal(decoded(found, m.positions), found.sides)


def test_differences_cannot_tell_what_lies_between_straight_creases() -> None:
    """Where a crease goes straight on its difference is zero, and every direction fits: the
    verifier is the x of the cross product alone. So the rungs of a beam are taken for creases,
    by the whole cross product too, and `sides` is what draws them right."""
    count = 12
    m = beam(count, 0.0)
    found = creases(m, rule="angle", angle=1.0)
    assert found.sides.sum() == 4 * 2 * count + 2 * 4  # four edges with two halves, and the ends
    flags = decoded(found, m.positions)
    assert not (found.sides & ~flags).any()
    wrong = (flags & ~found.sides).sum()
    # Rungs and diagonals (four each, two halves) between the vertices that are no corners.
    assert wrong == 4 * 2 * (count - 1) + 4 * 2 * (count - 2)
    bent = beam(count, 0.1)
    found = creases(bent, rule="angle", angle=1.0)
    assert np.array_equal(decoded(found, bent.positions), found.sides)


def test_one_element_of_the_cross_product_is_too_little() -> None:
    """Differences along the x axis: every direction as steep as the crease's has the verifier 0,
    and the whole cross product would tell them apart."""
    m = zigzag(8)
    found = creases(m, rule="angle", angle=np.pi)  # the rims alone
    flags = decoded(found, m.positions)
    wrong = flags & ~found.sides
    assert not (found.sides & ~flags).any()
    assert wrong.sum() == 2 * 6  # every other rung, both halves, but for the corners' two
    for t, k in np.argwhere(wrong):
        a, b = found.triangles[t, k], found.triangles[t, (k + 1) % 3]
        e = np.diff(m.positions[found.vertices[[a, b]]].astype(float), axis=0)[0]
        e /= np.linalg.norm(e)
        corners = m.triangles.ravel()
        h = found.strips.outgoing[a]
        true = m.positions[corners[h - h % 3 + (h + 1) % 3]] - m.positions[corners[h]]
        true = true / np.linalg.norm(true)
        delta = found.differences[a, :3].astype(float)
        assert np.linalg.norm(delta) > 0.1
        assert np.linalg.norm(np.cross(e, delta) - np.cross(true, delta)) > 0.1
