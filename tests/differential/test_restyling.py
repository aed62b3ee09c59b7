"""``with glshim.style(...) as s: s.image()`` in a context of the program's own."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import glfw
import numpy as np
import pytest
from numpy.typing import NDArray
from OpenGL import GL
from PIL import Image

import glshim
from glshim import Layer, Lines, RenderError, StyleError, Styler, UnknownNameError, pipeline
from glshim.checks.observe import App, observe
from tests.differential.world import HEIGHT, WIDTH, window

Picture = NDArray[np.uint8]
RED, BLUE = "#ff0000", "#0000ff"


def square(x: float = 0.0) -> None:
    """A grey square on white, right of the middle by x."""
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glColor3f(0.5, 0.5, 0.5)
    GL.glBegin(GL.GL_QUADS)
    for corner in ((-0.3, -0.5), (0.3, -0.5), (0.3, 0.5), (-0.3, 0.5)):
        GL.glVertex3f(corner[0] + x, corner[1], 0.0)
    GL.glEnd()


def clear() -> None:
    GL.glClearColor(1.0, 1.0, 1.0, 1.0)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)


def shown() -> Picture:
    """(H, W, 3), the first row on top."""
    pixels = GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    return np.frombuffer(pixels, np.uint8).reshape(HEIGHT, WIDTH, 3)[::-1]


def has(picture: Picture, colour: str) -> bool:
    ink = [int(colour[k : k + 2], 16) for k in (1, 3, 5)]
    return bool((np.abs(picture.astype(int) - ink).max(axis=2) < 8).sum() > 20)


@pytest.fixture
def handle() -> Iterator[Any]:
    with window() as made:
        GL.glViewport(0, 0, WIDTH, HEIGHT)
        clear()
        yield made
        assert not pipeline.BINDING.installed
        assert pipeline.current() is None


def test_the_picture_is_the_one_that_the_program_then_sees(handle: Any) -> None:
    with glshim.style("raskar", ink=RED, silhouette_width="4") as s:
        square()
        picture = s.image()
        assert picture.dtype == np.uint8
        assert picture.shape == (HEIGHT, WIDTH, 3)
        assert picture.flags.c_contiguous
        assert picture.flags.writeable
        assert has(picture, RED)
        assert (picture == shown()).all()
    square(0.6)
    after = shown()
    assert (after[:, : WIDTH // 2] == picture[:, : WIDTH // 2]).all()
    assert not has(after[:, WIDTH * 4 // 5 :], RED)


def test_the_first_row_is_on_top(handle: Any) -> None:
    GL.glScissor(0, HEIGHT // 2, WIDTH, HEIGHT)
    GL.glEnable(GL.GL_SCISSOR_TEST)
    GL.glClearColor(0.0, 0.0, 1.0, 1.0)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT)
    with glshim.style("none") as s:
        picture = s.image()
    assert (picture[: HEIGHT // 2] == (0, 0, 255)).all()
    assert (picture[HEIGHT // 2 :] == 255).all()


def test_a_block_without_a_picture_draws_its_lines_too(handle: Any) -> None:
    with glshim.style("raskar", ink=RED):
        square()
    assert has(shown(), RED)


def test_blocks_nest_and_put_back_what_was(handle: Any) -> None:
    with glshim.style("raskar", ink=RED) as outer:
        square(-0.6)
        with glshim.style("raskar", ink=BLUE) as inner:
            square()
            middle = inner.image()
        assert pipeline.current() is outer.styler
        square(0.6)
        whole = outer.image()
    left, centre, right = (slice(0, 30), slice(34, 62), slice(66, 96))
    assert has(middle[:, left], RED)
    assert has(middle[:, centre], BLUE)
    assert not has(middle[:, centre], RED)
    assert has(whole[:, right], RED)
    assert not has(whole[:, right], BLUE)


@pytest.mark.parametrize("style", ["none", "raskar"])
@pytest.mark.parametrize("live", [False, True])
def test_an_installed_style_is_in_force_again(handle: Any, style: str, live: bool) -> None:
    glshim.install(style, live=live)
    try:
        before, following = pipeline.current(), pipeline.census()
        with glshim.style("raskar", ink=RED) as s:
            square()
            assert has(s.image(), RED)
        assert pipeline.current() is before
        assert pipeline.census() is following
        clear()
        square()
        assert (np.abs(shown().astype(int) - (0, 0, 0)).max(axis=2) < 8).any() == (style != "none")
        assert not has(shown(), RED)
    finally:
        glshim.uninstall()


def test_none_inside_a_style_draws_nothing(handle: Any) -> None:
    with glshim.style("raskar", ink=RED) as outer:
        with glshim.style("none") as s:
            square()
            assert not has(s.image(), RED)
        square(0.6)
        assert has(outer.image(), RED)


def test_what_is_drawn_after_a_picture_lies_over_it(handle: Any) -> None:
    """It is one frame still: paper is laid once."""
    with glshim.style("sketch") as s:
        square(-0.6)
        first = s.image()
        square(0.6)
        second = s.image()
        assert (second == s.image()).all()
    assert (first[:, :40] == second[:, :40]).all()
    assert (first[:, 60:] != second[:, 60:]).any()


def test_the_viewport_or_a_size_says_how_much(handle: Any) -> None:
    with glshim.style("raskar", ink=RED) as s:
        GL.glViewport(32, 10, 40, 50)
        square()
        assert s.image().shape == (50, 40, 3)
        assert has(s.image(), RED)
        assert s.image((WIDTH, HEIGHT)).shape == (HEIGHT, WIDTH, 3)
        assert (s.image((WIDTH, HEIGHT))[-60:-10, 32:72] == s.image()).all()


def test_a_framebuffer_of_the_programs_own(handle: Any) -> None:
    made = GL.glGenFramebuffers(1)
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, made)
    for format_, place in ((GL.GL_RGB8, GL.GL_COLOR_ATTACHMENT0),
                           (GL.GL_DEPTH_COMPONENT24, GL.GL_DEPTH_ATTACHMENT)):  # fmt: skip
        name = GL.glGenRenderbuffers(1)
        GL.glBindRenderbuffer(GL.GL_RENDERBUFFER, name)
        GL.glRenderbufferStorage(GL.GL_RENDERBUFFER, format_, 40, 30)
        GL.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, place, GL.GL_RENDERBUFFER, name)
    GL.glViewport(0, 0, 40, 30)
    with glshim.style("raskar", ink=RED) as s:
        clear()
        square()
        picture = s.image()
    assert picture.shape == (30, 40, 3)
    assert has(picture, RED)


@pytest.mark.parametrize("style", ["raskar", "sketch", "technical", "edge_mesh"])
def test_the_program_notices_nothing_else(handle: Any, style: str) -> None:
    def outcome(*, restyled: bool) -> Any:
        app = App()
        clear()
        GL.glMatrixMode(GL.GL_MODELVIEW)  # which `observe` changes
        GL.glPixelStorei(GL.GL_PACK_ALIGNMENT, 8)
        GL.glReadBuffer(GL.GL_BACK)
        if restyled:
            with glshim.style(style) as s:
                square()
                s.image()
        else:
            square()
        return observe(app, WIDTH, HEIGHT)

    plain, styled = outcome(restyled=False), outcome(restyled=True)
    assert plain.differences(styled, pictures=False) == {}


def test_options_come_as_values_texts_and_features(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text('style = "raskar"\nink = "#00ff00"\n')
    made: Any = glshim.style(tmp_path / "mine.toml", ridges="off", ridge={"width": 3}).styler
    assert (made.ink, made.ridges, made.ridge_width) == ((0.0, 1.0, 0.0), False, 3.0)
    again: Any = glshim.style(made, ink=(1, 0, 0)).styler
    assert (again.ink, again.ridge_width) == ((1.0, 0.0, 0.0), 3.0)
    assert glshim.style(made).styler is made


def test_what_is_not_valid_is_refused_at_once() -> None:
    with pytest.raises(UnknownNameError, match="did you mean raskar"):
        glshim.style("rasker")
    with pytest.raises(UnknownNameError, match="did you mean ridge_width"):
        glshim.style("raskar", ridge_widht=4)
    with pytest.raises(StyleError, match=r"ridge_width=400"):
        glshim.style("raskar", ridge_width=400)
    assert not pipeline.BINDING.installed


@dataclass(frozen=True)
class Failing(Styler):
    """Raises."""

    name: ClassVar[str] = "failing"

    def draws(self, layer: Layer) -> list[Lines]:
        raise ValueError("of the style's own")


def test_a_style_that_fails_gives_no_picture_and_the_one_around_it_stays(
    handle: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    with glshim.style("raskar", ink=RED) as outer:
        with glshim.style(Failing()) as s:
            square()
            with pytest.raises(RenderError, match="style 'failing' has failed"):
                s.image()
        square(0.6)
        assert has(outer.image(), RED)
    assert "of the style's own" in capsys.readouterr().err


def test_a_picture_is_asked_for_where_there_can_be_one(handle: Any) -> None:
    block = glshim.style("raskar")
    with pytest.raises(RenderError, match="inside the block"):
        block.image()
    with block as s:
        with pytest.raises(RenderError, match="is open already"), block:
            pass
        GL.glBegin(GL.GL_QUADS)
        with pytest.raises(RenderError, match="call it after glEnd"):
            s.image()
        GL.glEnd()
        glfw.make_context_current(None)
        with pytest.raises(RenderError, match="no OpenGL context is current"):
            s.image()
        glfw.make_context_current(handle)
    with block as s:  # once more
        square()
        assert s.image().any()


def test_what_the_block_raises_arrives_and_the_hooks_go(handle: Any) -> None:
    with pytest.raises(ZeroDivisionError), glshim.style("raskar"):
        square()
        1 / 0  # noqa: B018
    assert not pipeline.BINDING.installed


def test_pillow_takes_the_picture(handle: Any, tmp_path: Path) -> None:
    with glshim.style("raskar", ink=RED) as s:
        square()
        Image.fromarray(s.image()).save(tmp_path / "shot.png")
    with Image.open(tmp_path / "shot.png") as saved:
        assert (saved.mode, saved.size) == ("RGB", (WIDTH, HEIGHT))
