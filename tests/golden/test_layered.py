"""Frames of several pictures: paper where the program has cleared, lines in their own view, panels
that keep their look (`layered`)."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import pygame
import pytest
from numpy.typing import NDArray

from tests.golden import layered, restyled
from tests.golden.layered import HEIGHT, INSET, PANEL, WIDTH
from tests.sweep import some

PAPERS = {
    "sketch": (247, 245, 239), "watercolour": (248, 245, 237), "blueprint": (0, 0, 140),
    "hiddenline": (252, 252, 252),
}  # fmt: skip
"""Styles with paper, and what that looks like on the whole."""
STYLES = ("raskar", "cartoon", *PAPERS)
Picture = NDArray[np.int_]


@pytest.fixture(scope="module", autouse=True)
def window() -> Iterator[None]:
    pygame.display.init()
    pygame.display.set_mode((WIDTH, HEIGHT), pygame.OPENGL | pygame.DOUBLEBUF)
    layered.prepare()
    yield
    pygame.display.quit()


def shown(scene: str | Callable[[], None], style: str = "", frames: int = 2) -> Picture:
    """See `restyled.shown`. scene: one of `layered.SCENES`, or what draws it."""
    draw = layered.SCENES[scene] if isinstance(scene, str) else scene
    return restyled.shown(draw, style, frames)


def of(box: tuple[int, int, int, int], picture: Picture) -> Picture:
    x, y, width, height = box
    return picture[y : y + height, x : x + width]


def main_view() -> None:
    layered.clear()
    layered.look(0, 0, WIDTH, HEIGHT)
    layered.level()


def inset_alone() -> None:
    layered.clear()
    layered.look(*INSET, (-5.0, 2.0, 3.0))
    layered.level()


CLEARED = ("menu", "split", "halves", "inset")


@pytest.mark.parametrize("scene", CLEARED)
@pytest.mark.parametrize("style", some(tuple(PAPERS), 2))
def test_paper_is_where_the_program_has_cleared(scene: str, style: str) -> None:
    plain = shown(scene)
    ground = np.zeros((HEIGHT, WIDTH), bool)
    for colour in (layered.SKY, layered.SAND):
        ground |= (abs(plain - np.rint(255 * np.array(colour))) <= 1).all(axis=2)
    assert ground.mean() > 0.3
    off = abs(shown(scene, style) - PAPERS[style]).max(axis=2)[ground]
    # Strokes go on, and paper has a grain.
    assert (off < 40).mean() > 0.8


@pytest.mark.parametrize("scene", ["inset_over", "weapon"])
@pytest.mark.parametrize("style", some(tuple(PAPERS), 2))
def test_what_has_depth_of_its_own_lies_over_the_picture(scene: str, style: str) -> None:
    alone, together = shown(main_view, style), shown(scene, style)
    left = together[:, : WIDTH // 3] == alone[:, : WIDTH // 3]
    assert left.all()
    assert (together != alone).any()


@pytest.mark.parametrize("style", some(STYLES, 2))
def test_a_view_has_its_own_lines(style: str) -> None:
    alone, together = shown(inset_alone, style), shown("inset", style)
    inner = INSET[0] + 4, INSET[1] + 4, INSET[2] - 8, INSET[3] - 8
    inside = of(inner, together) != of(inner, alone)
    if style in PAPERS:
        assert not inside.any()
    else:  # the ground is another one
        assert inside.any(axis=2).mean() < 0.8
    main = shown(main_view, style)
    assert (together[:, : INSET[0] - 8] == main[:, : INSET[0] - 8]).all()


@pytest.mark.parametrize("style", some(STYLES, 2))
def test_clears_that_clear_nothing_change_nothing(style: str) -> None:
    def once() -> None:
        layered.clear()
        layered.look(0, 0, WIDTH, HEIGHT)
        layered.box(0.0, 0.0, 0.0, 1.0, (0.8, 0.5, 0.3))
        layered.box(-2.2, -0.4, 0.5, 0.6, (0.4, 0.7, 0.4))

    assert (shown("masked", style) == shown(once, style)).all()


@pytest.mark.parametrize("scene", ["hud", "hud_tested", "hud_on_depth"])
@pytest.mark.parametrize("style", some(STYLES, 3))
def test_a_panel_in_front_keeps_its_look(scene: str, style: str) -> None:
    plain, styled = shown(scene), shown(scene, style, frames=1)
    assert (of(PANEL, styled) == of(PANEL, plain)).all()
    assert (styled != plain).any(axis=2).mean() > 0.01


@pytest.mark.parametrize("style", ["raskar", "cartoon", "hiddenline"])
def test_a_panel_that_is_drawn_first_keeps_its_look(style: str) -> None:
    """From the second frame on: until then nothing solid was seen behind it."""
    plain, styled = shown("hud_first"), shown("hud_first", style)
    assert (of(PANEL, styled) == of(PANEL, plain)).all()
