"""The figures of Rideout 2010 and Hajagos 2012: their programs show what they should, the same each
time, and a figure whose style is unknown says so."""

from __future__ import annotations

import importlib
from collections import Counter
from itertools import combinations

import numpy as np
import pytest

from tests.figures import hajagos, rideout
from tests.figures.programs import head
from tests.figures.shots import shot
from tests.figures.table import Figure
from tests.sweep import some

chess = importlib.import_module("demo_apps.06_chess")

FIGURES = {figure.name: figure for figure in (*rideout.FIGURES, *hajagos.FIGURES)}
PROGRAMS = {" ".join(figure.program[1:]): figure.program for figure in FIGURES.values()}


@pytest.mark.parametrize("name", some(tuple(PROGRAMS), 3))
def test_a_program_shows_the_same_each_time(name):
    one, other = (np.asarray(take("none", *PROGRAMS[name])) for take in (shot, shot.__wrapped__))
    assert one.shape == (480, 640, 3)
    assert (np.abs(one.astype(int) - one[2, 2]).max(axis=2) > 40).mean() > 0.04
    if "figure" not in name.rpartition(".")[2]:  # which walks as real time goes by
        assert (one == other).all()


def test_the_head_is_one_closed_smooth_skin():
    points = head.head()
    rows, columns = points.shape[0] - 2, points.shape[1] - 1
    assert 2 * columns * rows == 29520  # triangles: two a quad, and one a side of the poles' fans
    assert np.isfinite(points).all() and (points[:, 0] == points[:, -1]).all()
    normals = chess.smooth_normals(points)
    assert np.allclose(np.linalg.norm(normals, axis=2), 1.0)
    for axis in (0, 1):  # nowhere is it folded
        one, other = (np.delete(normals, k, axis=axis) for k in (0, -1))
        assert np.einsum("rci,rci->rc", one, other)[1:-1].min() > 0.1
    assert points[..., 1].min() < -0.9 and points[..., 1].max() < 1.1  # the nose is in front


@pytest.mark.parametrize("name", some(tuple(FIGURES), 5))
def test_a_figure_is_drawn(name, tmp_path):
    figure = FIGURES[name]
    plain = np.asarray(shot("none", *figure.program, frames=figure.frames).crop(
        figure.crop or (0, 0, 640, 480)), int)  # fmt: skip
    tiles = [np.asarray(tile, int) for tile in figure.tiles()]
    for tile in tiles:
        assert (np.abs(tile - plain).max(axis=2) > 60).mean() > 0.004
    for one, other in combinations(tiles, 2):
        assert (np.abs(one - other).max(axis=2) > 30).sum() > 50
    assert figure.write(tmp_path).stat().st_size > 2000


def test_a_figure_of_an_unknown_style_is_an_error_and_no_picture(tmp_path):
    figure = Figure("odd", rideout.TORUS, ("none", "no_such_style:width=3"))
    with pytest.raises(RuntimeError, match="no style is called 'no_such_style'"):
        figure.write(tmp_path)
    assert not list(tmp_path.iterdir())


def test_figures_have_names_of_their_own():
    assert Counter(figure.name for figure in (*rideout.FIGURES, *hajagos.FIGURES)).most_common(1)[
        0][1] == 1  # fmt: skip
