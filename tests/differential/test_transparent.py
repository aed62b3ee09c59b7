"""Style ``none`` and styles that draw leave to the app what plain PyOpenGL gives it."""

from __future__ import annotations

from functools import cache

import pytest

from . import scenes_errors, scenes_immediate, scenes_lists, scenes_state
from .gathering import Gathering
from .registry import SCENES
from .world import Outcome, run

FILES = (scenes_errors, scenes_immediate, scenes_lists, scenes_state)


@cache
def plain(name: str) -> Outcome:
    return run(SCENES[name])


@pytest.mark.parametrize("name", SCENES)
def test_none_is_plain_to_the_byte(name: str) -> None:
    assert plain(name).differences(run(SCENES[name], "none")) == {}


STYLES = (
    "raskar", "edge_mesh:marked=on,smooth=on,suggestive=on,texture=pen,hidden=dashed",
    "edge_mesh:strokes=half,outer=on,hidden=dimmed", "shadow:light=fixed", "fur:layers=2",
    "fins", "fins:fill=cel,joints=overhang",
    "crease", "crease:texture=pen,hidden_by=back_faces,indicator=verifiers",
    "two_pass:fill=#ff8000",
)  # fmt: skip


@pytest.mark.parametrize("style", STYLES, ids=lambda style: style.partition(",")[0])
@pytest.mark.parametrize("name", SCENES)
def test_a_style_changes_nothing_but_the_picture(name: str, style: str) -> None:
    assert plain(name).differences(run(SCENES[name], style), pictures=False) == {}


@pytest.mark.parametrize("name", SCENES)
def test_a_style_that_asks_for_normals_changes_nothing(name: str) -> None:
    assert plain(name).differences(run(SCENES[name], Gathering(normals=True))) == {}
