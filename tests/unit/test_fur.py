"""How long fur is in object units, which way is out, and what style fur says to draw."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from glshim_stylers.fur import Fur
from glshim_stylers.fur.scale import scale_of

from glshim.errors import StyleError
from glshim.geometry.recovery.mesh import mesh
from glshim.geometry.recovery.outward import outward
from glshim.model.camera import Camera
from glshim.styling.options import options_of
from glshim.styling.passes import Pass
from glshim.styling.protocol import Layer
from glshim.styling.values import Body
from tests import look

VIEW = look.look_at((0, -5, 0))


def camera(projection=None, modelview=VIEW) -> Camera:
    projection = look.orthographic(2.0) if projection is None else projection
    return Camera(modelview, projection, (0, 0, 400, 400))


def turned_in(batch):
    corners = np.concatenate([p[::-1] for p in look.polygons_of(batch)])
    return dataclasses.replace(batch, corners=corners)


@pytest.mark.parametrize("make", [look.cube, look.sphere, look.torus, look.bowl])
def test_out_is_found_whichever_way_an_app_winds(make):
    assert (outward(mesh(make())) == 1.0).all()
    assert (outward(mesh(turned_in(make()))) == -1.0).all()


def test_each_component_has_an_outside_of_its_own_and_a_sheet_has_none():
    one, other = look.cube(), turned_in(look.cube())
    points = np.concatenate([one.positions, other.positions + np.array((5, 0, 0))])
    both = look.batch(points, [*look.polygons_of(one), *(p + 8 for p in look.polygons_of(other))])
    found = mesh(both)
    assert (outward(found) == np.where(found.positions[:, 0] > 2.5, -1.0, 1.0)).all()
    sheet = look.batch([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [[0, 1, 2, 3]])
    assert (outward(mesh(sheet)) == 0.0).all()


def test_pixels_become_object_units_by_the_camera_and_the_scale_of_the_model():
    body = Body((look.sphere(radius=1.0),), camera())
    plain = scale_of(body, 10.0, 2.0)
    assert plain.length == pytest.approx(10.0 * 4.0 / 400.0)
    assert plain.pixels == pytest.approx(10.0)
    assert 0.8 < plain.spacing / (2.0 * 4.0 / 400.0) < 1.25
    small = Body(body.batches, camera(modelview=VIEW @ np.diag((0.5, 0.5, 0.5, 1.0))))
    assert scale_of(small, 10.0, 2.0).length == pytest.approx(2 * plain.length)
    deep = Body(body.batches, camera(look.perspective(90.0)))
    assert scale_of(deep, 10.0, 2.0).length == pytest.approx(10.0 * 5.0 / 200.0)


def test_fur_is_never_much_longer_than_its_object():
    body = Body((look.sphere(radius=0.02),), camera())
    assert scale_of(body, 100.0, 2.0).length <= 0.4 * 0.02 * 3**0.5 * 1.001


def test_spacing_keeps_while_an_object_comes_a_little_nearer():
    found = {
        scale_of(
            Body((look.sphere(),), camera(look.perspective(), look.look_at((0, -away, 0)))),
            20.0,
            3.0,
        ).spacing
        for away in np.linspace(5.0, 10.0, 40)
    }
    assert len(found) <= 4


@pytest.mark.parametrize(
    "points",
    [np.full((3, 3), np.nan), np.zeros((3, 3)), np.full((3, 3), np.inf), np.full((3, 3), 3e38)],
)
def test_what_is_nowhere_has_no_fur(points):
    layer = Layer(((look.batch(points, [[0, 1, 2]]), camera()),))
    assert list(Fur().draws(layer)) == []


def test_a_singular_model_and_an_empty_batch_have_no_fur():
    flat = camera(modelview=VIEW @ np.diag((0.0, 0.0, 0.0, 1.0)))
    empty = dataclasses.replace(
        look.cube(), positions=np.zeros((0, 3), np.float32), corners=np.zeros(0, np.int32),
        starts=np.zeros(1, np.int32), boundary=np.zeros(0, bool),
    )  # fmt: skip
    for one in ((look.cube(), flat), (empty, camera())):
        assert list(Fur().draws(Layer((one,)))) == []


def test_fins_come_before_the_shells_that_lie_over_them():
    layer = Layer(((look.cube(), camera()),), light=(1.0, 2.0, 3.0, 0.0))
    passes = list(Fur(layers=9).draws(layer))
    assert all(isinstance(one, Pass) for one in passes)
    assert [one.element for one in passes] == ["edges", "triangles"]
    assert passes[1].primitives.copies == passes[1].uniforms["shells"] == 9
    assert all(one.light == (1.0, 2.0, 3.0, 0.0) for one in passes)
    bare = list(Fur(fins=False).draws(Layer(((look.cube(), camera()),))))
    assert [one.element for one in bare] == ["triangles"]
    short = list(Fur(length=3, fins=False).draws(Layer(((look.cube(), camera()),))))
    assert short[0].primitives.copies == 3


def test_options_hold_their_ranges():
    for described in options_of(Fur):
        assert described.help
        if described.kind == "number":
            for value in (described.low - 0.01, described.high + 0.01):
                with pytest.raises(StyleError):
                    Fur(**{described.name: value})
    assert Fur(colour="#ff0000").colour == (1.0, 0.0, 0.0)
    assert Fur(fill="none").surface == "none"
    with pytest.raises(StyleError):
        Fur(colour="skin")
