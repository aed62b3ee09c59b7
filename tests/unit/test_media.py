"""Media that stylers borrow: values that know their shader, uniforms and image."""

from __future__ import annotations

from dataclasses import replace
from math import cos, sin

import pytest

from glshim import Choice, Features, Lines, StyleError, brush, dashes, hand, ink, pencil
from glshim.checks.layers import usual
from glshim.linework.groups import grouped
from glshim.model.lines import BOUNDARY, GROUPS
from glshim.styling.media.hand import reseeded
from glshim.styling.media.kinds import GROUP_OF

BLACK, RED = (0.0, 0.0, 0.0), (1.0, 0.0, 0.0)


def test_plain_ink_is_equal_to_itself():
    assert ink(3.0, RED) == ink(3.0, "#ff0000") != ink(3.0)
    plain = ink(3.0)
    assert plain.uniforms["widths"] == GROUPS * (3.0,)
    assert plain.uniforms["inks"] == GROUPS * (BLACK,)
    assert (plain.image, plain.pattern, plain.uniforms["hidden_share"]) == (None, None, 0.0)


def test_widths_and_colours_by_kind():
    medium = ink(1.0, widths={"contours": 4.0, "boundary": 2.0}, colours={"ridges": RED})
    widths = medium.uniforms["widths"]
    assert (widths[0], widths[1], widths[BOUNDARY]) == (4.0, 1.0, 2.0)
    assert [colour == RED for colour in medium.uniforms["inks"]].index(True) == GROUP_OF["ridges"]
    with pytest.raises(StyleError, match="no lines are called 'ridge': did you mean ridges"):
        ink(widths={"ridge": 3.0})
    with pytest.raises(StyleError, match="'redd' is not a colour"):
        ink(colour="redd")


def test_a_texture_repeats_sooner_on_narrower_lines_that_have_it():
    medium = ink(4.0, widths={"ridges": 2.0}, texture="dashed", texture_length=20.0)
    assert medium.pattern is not None and medium.image is not None
    assert medium.pattern.lengths[:3] == (20.0, 10.0, 20.0)
    some = ink(4.0, texture="dashed", texture_length=20.0, textured=("ridges",))
    assert some.pattern is not None
    assert some.pattern.lengths == (0.0, 20.0) + (GROUPS - 2) * (0.0,)
    assert dashes(4.0, length=20.0) == ink(4.0, texture="dashed", texture_length=20.0)


def test_what_is_hidden():
    assert ink(hidden="dimmed", hidden_share=0.7).uniforms["hidden_share"] == 0.3
    dashed = ink(hidden="dashed", hidden_share=0.7)
    assert (dashed.uniforms["hidden_share"], dashed.uniforms["dashes"]) == (0.7, 1.0)
    assert dashed.pattern is not None and dashed.image is None
    textured = ink(texture="pen", texture_length=60.0, hidden="dashed")
    assert textured.uniforms["dashes"] == 5.0


@pytest.mark.parametrize("make", [hand, pencil, brush])
def test_a_seed_changes_the_motions_alone(make):
    first, second = make(), make(seed=3)
    assert first != second
    assert {**first.uniforms, "jitter_seed": 0.0} == {**second.uniforms, "jitter_seed": 0.0}
    assert reseeded(second, 0) == first
    assert first.image is second.image
    assert (first.image is None) == (make is hand)


def test_a_pencil_has_a_grain_and_outlines_of_its_width():
    medium = pencil(3.0, inner=0.5)
    assert medium.image is not None
    assert [medium.uniforms["widths"][k] for k in (0, 1, BOUNDARY)] == [6.0, 3.0, 6.0]


def test_lines_have_the_pattern_of_their_medium_and_its_shader_the_angles_of_what_is_wanted():
    layer, medium = usual(), pencil()
    wanted = Features(contours=True, ridge_angle=2.0, valley_angle=4.0)
    (group,) = grouped([Lines(layer.bodies, wanted, medium)])
    assert group.wanted == replace(wanted, pattern=medium.pattern)
    assert group.uniforms == {
        **medium.uniforms, "ridge_turn": (cos(2.0), sin(2.0)), "valley_turn": (cos(4.0), sin(4.0)),
    }  # fmt: skip
    plain = Choice(silhouettes=True, pattern=medium.pattern)
    (group,) = grouped([Lines(layer.bodies, plain, ink())])
    assert group.wanted == plain
