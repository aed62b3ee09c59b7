"""Styles brush and pencil: what they make of the program's own colours."""

from __future__ import annotations

import numpy as np
import pytest
from glshim_stylers.brush import Brush
from glshim_stylers.pencil import Pencil

from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look

SIZE = 400
RED, GREEN = (0.85, 0.2, 0.15), (0.2, 0.6, 0.25)


@pytest.fixture(scope="module")
def backend():
    with look.window(SIZE, SIZE):
        yield Backend.attach()


def drawn(backend, style, shade, layers=1, time=0.0):
    """A sphere of a colour, without and with the style; layers of one."""
    camera = Camera(look.look_at((3, 2, 2)), look.perspective(), (0, 0, SIZE, SIZE))
    ball = look.sphere(48, 24)
    look.clear((0.3, 0.4, 0.9))
    look.draw_base(ball, camera, shade)
    before = look.pixels()
    backend.render(style.draws(Layer(((ball, camera),), time=time)))
    for _ in range(layers - 1):  # over it, on the same depth: no paper again
        backend.render(style.draws(Layer(((ball, camera),), over=True, fresh=False, time=time)))
    return before, look.pixels().astype(int)


def inside(before):
    """Pixels well within the sphere."""
    mask = (before != before[0, 0]).any(axis=2)
    y, x = np.nonzero(mask)
    j, i = np.mgrid[:SIZE, :SIZE]
    return np.hypot(i - x.mean(), j - y.mean()) < 0.7 * np.sqrt(mask.sum() / np.pi)


@pytest.mark.parametrize("shade", [RED, GREEN])
def test_a_pencil_knows_greys_alone(backend, shade):
    before, after = drawn(backend, Pencil(paper="#ffffff", ink="#000000"), shade)
    assert np.ptp(after, axis=2).max() <= 2
    assert after[inside(before)].mean() < 235 < after[:20].mean()


@pytest.mark.parametrize("shade", [RED, GREEN])
@pytest.mark.parametrize("style", [Pencil(coloured=1.0), Brush()], ids=["pencil", "brush"])
def test_coloured_pencils_and_paint_are_of_the_programs_hue(backend, style, shade):
    before, after = drawn(backend, style, shade)
    within = after[inside(before)]
    most = int(np.argmax(shade))
    assert (within.argmax(axis=1) == most).mean() > 0.97
    others = np.delete(within.mean(axis=0), most)
    assert within.mean(axis=0)[most] - others.max() > 25


@pytest.mark.parametrize("shade", [(0.1, 0.1, 0.1), (0.6, 0.6, 0.6)])
def test_greys_stay_as_dark_among_coloured_pencils(backend, shade):
    means = []
    for coloured in (0.0, 1.0):
        before, after = drawn(backend, Pencil(coloured=coloured), shade)
        means.append(after[inside(before)].mean())
    assert means[1] == pytest.approx(means[0], abs=25)


def test_no_paint_is_bare_paper(backend):
    before, after = drawn(backend, Brush(tint=0.0, paper="#ffffff"), RED)
    within = after[inside(before)]
    assert within.min() > 235 and np.ptp(within, axis=1).max() <= 2


def test_paint_stays_where_surfaces_are_but_for_a_hair(backend):
    """Beyond the strokes along the outline there is paper alone."""
    before, after = drawn(backend, Brush(paper="#ffffff"), RED)
    solid = (before != before[0, 0]).any(axis=2)
    y, x = np.nonzero(solid)
    j, i = np.mgrid[:SIZE, :SIZE]
    far = np.hypot(i - x.mean(), j - y.mean()) > np.sqrt(solid.sum() / np.pi) + 14
    assert after[far].min() > 230


@pytest.mark.parametrize("style", [Pencil(), Brush()], ids=["pencil", "brush"])
def test_a_layer_on_the_same_depth_lays_no_paper_again(backend, style):
    before, once = drawn(backend, style, RED)
    _, twice = drawn(backend, style, RED, layers=2)
    paper = np.zeros((SIZE, SIZE), bool)
    paper[:20] = True
    assert np.array_equal(once[paper], twice[paper])
    assert (twice[inside(before)].mean() - once[inside(before)].mean()) <= 0.0


def test_paint_is_laid_anew_as_often_as_strokes_boil(backend):
    still = [drawn(backend, Brush(), RED, time=time)[1] for time in (0.0, 0.3)]
    assert np.array_equal(*still)
    style = Brush(boil=10.0)
    one, same, other = (drawn(backend, style, RED, time=time)[1] for time in (0.0, 0.09, 0.11))
    within = inside(drawn(backend, style, RED)[0])
    assert np.array_equal(one, same)
    assert (np.abs(one - other).max(axis=2)[within] > 4).mean() > 0.2
