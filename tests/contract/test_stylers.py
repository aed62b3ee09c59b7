"""What every installed styler keeps to."""

from __future__ import annotations

import dataclasses
import pickle

import numpy as np
import pytest
from PIL import Image

from glshim.errors import StyleError
from glshim.geometry.camera import Camera
from glshim.styling import registry
from glshim.styling.passes import Pass
from glshim.styling.protocol import BackFaces, Draw, Layer, Styler, options_of
from stylers.strokes import MADE
from tests import look


@pytest.fixture(params=registry.names())
def styler(request) -> type[Styler]:
    return registry.load(request.param)


def layer() -> Layer:
    camera = Camera(look.look_at((3, 2, 2)), look.perspective(), (0, 0, 400, 400))
    return Layer(((look.cube(), camera), (look.torus(), camera)))


def test_it_is_a_frozen_dataclass_under_its_own_name(styler):
    assert styler.name in registry.names()
    assert registry.load(styler.name) is styler
    assert dataclasses.is_dataclass(styler)
    with pytest.raises(dataclasses.FrozenInstanceError):
        styler().extra = 1
    assert styler() == styler() == pickle.loads(pickle.dumps(styler()))


def test_every_field_is_an_option_with_help_and_bounds_that_hold(styler):
    assert [f.name for f in dataclasses.fields(styler)] == [o.name for o in options_of(styler)]
    for described in options_of(styler):
        assert described.help
        assert described.check(described.default) == described.default
        assert getattr(styler(), described.name) == described.default
        if described.kind == "number":
            for edge in (described.low, described.high):
                assert getattr(styler(**{described.name: edge}), described.name) == edge
            with pytest.raises(StyleError):
                styler(**{described.name: described.high + 1})


def test_draws_are_pure_and_plain(styler):
    one = layer()
    before = [b.positions.copy() for b, _ in one.items]
    first, second = list(styler().draws(one)), list(styler().draws(one))
    assert first == second
    assert all((b.positions == c).all() for (b, _), c in zip(one.items, before, strict=True))
    for draw in first:
        assert isinstance(draw, (Draw, Pass, BackFaces))
        for value in getattr(draw, "uniforms", {}).values():
            assert np.isfinite(np.asarray(value, float)).all()
    named = ("app", "none", "paint", "colours")
    assert styler().surface in named or len(styler().surface) == 3


@pytest.mark.parametrize("texture", [*MADE, "a picture"])
def test_textured_draws_are_pure_too(texture, tmp_path):
    if texture == "a picture":
        texture = str(tmp_path / "line.png")
        Image.new("RGB", (8, 4), (200, 10, 10)).save(texture)
    one, make = layer(), registry.load("raskar")
    first, second = (list(make(texture=texture).draws(one)) for _ in range(2))
    assert first == second
    assert first[0].image is not None
    assert first[0].image is second[0].image is first[1].image


def test_a_styler_that_wants_no_polygons_draws_nothing(styler):
    if not styler.wants_polygons:
        assert list(styler().draws(layer())) == []
    else:
        assert list(styler().draws(layer()))
