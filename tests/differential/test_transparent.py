"""Style ``none`` and style ``raskar`` leave to the app what plain PyOpenGL gives it."""

from __future__ import annotations

from functools import cache

import pytest

from . import scenes_errors, scenes_immediate, scenes_lists, scenes_state
from .registry import SCENES
from .world import Outcome, run

FILES = (scenes_errors, scenes_immediate, scenes_lists, scenes_state)


@cache
def plain(name: str) -> Outcome:
    return run(SCENES[name])


@pytest.mark.parametrize("name", SCENES)
def test_none_is_plain_to_the_byte(name: str) -> None:
    assert plain(name).differences(run(SCENES[name], "none")) == {}


@pytest.mark.parametrize("name", SCENES)
def test_raskar_changes_nothing_but_the_picture(name: str) -> None:
    assert plain(name).differences(run(SCENES[name], "raskar"), pictures=False) == {}
