"""The chessmen of the demo: closed skins, wound anticlockwise, with normals that fit them."""

import importlib
from collections import Counter

import numpy as np
import pytest
from OpenGL import GL

chess = importlib.import_module("demo_apps.06_chess")


class Recorder:
    """Takes what a draw sends in place of GL; a transform moves a part as a whole, and tells
    nothing of whether it is closed."""

    def __init__(self) -> None:
        self.triangles: list[list[tuple[np.ndarray, np.ndarray]]] = []

    def __getattr__(self, name: str):
        return getattr(GL, name) if name.startswith("GL_") else lambda *args: None

    def glBegin(self, mode: int) -> None:
        self.mode, self.sent = mode, []

    def glNormal3fv(self, normal: np.ndarray) -> None:
        self.normal = np.array(normal, float)

    def glVertex3fv(self, point: np.ndarray) -> None:
        self.sent.append((np.array(point, float), self.normal))

    def glEnd(self) -> None:
        sent, count = self.sent, len(self.sent)
        if self.mode == GL.GL_TRIANGLE_FAN:
            self.triangles += [[sent[0], sent[k], sent[k + 1]] for k in range(1, count - 1)]
        else:
            step = 2 if self.mode == GL.GL_QUAD_STRIP else 4
            for k in range(0, count - 3, step):
                a, b, c, d = sent[k : k + 4]
                if step == 2:
                    c, d = d, c
                self.triangles += [[a, b, c], [a, c, d]]


@pytest.fixture(params=chess.PIECES)
def piece(request, monkeypatch):
    recorder = Recorder()
    monkeypatch.setattr(chess, "GL", recorder)
    chess.PIECES[request.param]()
    found = np.array(recorder.triangles)  # (T, 3, point or normal, 3)
    return found[:, :, 0], found[:, :, 1]


def test_each_side_has_one_neighbour_that_runs_the_other_way(piece):
    corners, _ = piece
    names = np.round(corners * 1e6).astype(int)
    sides = Counter()
    for triangle in names.tolist():
        ring = [tuple(corner) for corner in triangle]
        sides.update(zip(ring, ring[1:] + ring[:1], strict=True))
    # Parts that are drawn in several places (beads, ears) count as often as they are drawn.
    assert all(sides[b, a] == count for (a, b), count in sides.items())
    assert len(sides) > 3000


def test_it_is_seen_from_outside_and_lit_from_there(piece):
    corners, normals = piece
    a, b, c = corners.transpose(1, 0, 2)
    area = np.cross(b - a, c - a)
    assert (a * np.cross(b, c)).sum() > 0
    assert np.allclose(np.linalg.norm(normals, axis=2), 1.0)
    length = np.linalg.norm(area, axis=1)
    assert length.min() > 1e-9
    cosine = np.einsum("ti,tki->tk", area / length[:, None], normals)
    assert cosine.min() > 0.3
    assert np.median(cosine) > 0.99


def test_the_position_has_the_men_of_the_game():
    men = Counter(letter for letter, _, _ in chess.standing())
    assert men["K"] == men["k"] == 1
    assert sum(map(str.isupper, men.elements())) == 10
    squares = {(x, y) for _, x, y in chess.standing()}
    assert len(squares) == sum(men.values())
    assert all(abs(v) <= 3.5 and v % 1 == 0.5 for square in squares for v in square)
