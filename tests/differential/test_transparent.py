"""Style ``none`` and styles that draw leave to the app what plain PyOpenGL gives it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from glshim.styling.texts import parse_style
from tests.sweep import some

from . import scenes_errors, scenes_immediate, scenes_lists, scenes_state
from .gathering import Gathering
from .registry import SCENES, plain
from .world import run

FILES = (scenes_errors, scenes_immediate, scenes_lists, scenes_state)


@pytest.mark.parametrize("name", SCENES)
def test_none_is_plain_to_the_byte(name: str) -> None:
    assert plain(name).differences(run(SCENES[name], "none")) == {}


STYLES = (
    "edge_mesh:marked=on,smooth=on,suggestive=on,texture=pen,hidden=dashed",
    "edge_mesh:strokes=half,outer=on,hidden=dimmed", "fins", "crease", "two_pass:fill=#ff8000",
    "shadow:light=fixed", "fur:layers=2", "fins:fill=cel,joints=overhang",
    "crease:texture=pen,hidden_by=back_faces,indicator=verifiers", "sketch:boil=8",
    "blueprint:dimensions=1",
    "cartoon", "technical", "hiddenline:edges=all,hidden=dashed",
    "cartoon:textures=off,shade_unlit=head", "two_pass:dash=12,ridges=on", "fins:dash=9",
    "shadow+crease:contour.dash=9", "hiddenline+pencil:dash=12",
)  # fmt: skip
"""Beside raskar, which every scene meets in every run. The same guard stands around all of them and
the same recorder below: some in turn."""


def styled_scenes() -> Iterator[object]:
    """Pairs of a scene and a style."""
    for turn, name in enumerate(SCENES):
        for style in ("raskar", *some(STYLES, 1, turn)):
            yield pytest.param(name, style, id=f"{name}-{style.partition(',')[0]}")


@pytest.mark.parametrize(("name", "style"), list(styled_scenes()))
def test_a_style_changes_nothing_but_the_picture(name: str, style: str) -> None:
    found = plain(name).differences(run(SCENES[name], style), pictures=False)
    if style.startswith(("cartoon", "technical", "hiddenline")):  # ours came before
        assert all(min(numbers) > 0 for numbers in found.pop("GL_CURRENT_PROGRAM", ()))
    if style.startswith(("cartoon:textures=off", "hiddenline")) and "clip" in name:
        # Mesa clips the fixed function's polygons in clip space, those of a program in eye space:
        # a rounding apart.
        assert found.pop("depth", 0) < 16
    if parse_style(style).gathers_ink and name.startswith("everything_under"):
        # Lines are drawn into a framebuffer of ours. In Mesa the pattern of stippled ones runs on
        # from one draw to the next, unless a framebuffer comes between; and where two cross, the
        # nearer one may be a rounding apart.
        assert found.pop("depth", 0) < (600 if "stipple" in name else 16)
    if parse_style(style).background is not None and name.startswith("errors_while_compiling"):
        found.pop("saw", None)  # a pixel read while a list is open: all that we said were in it
    assert found == {}


@pytest.mark.parametrize("name", some(tuple(SCENES), len(SCENES) // 3))
def test_a_style_that_asks_for_normals_changes_nothing(name: str) -> None:
    assert plain(name).differences(run(SCENES[name], Gathering(normals=True))) == {}
