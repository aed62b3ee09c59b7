"""Text and lines that a program draws itself can be read on the paper of every style."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import pygame
import pytest
from numpy.typing import NDArray
from OpenGL import GL, GLU

import glshim
from glshim.styling.registry import names
from glshim.styling.texts import parse_style
from tests.sweep import some

WIDTH, HEIGHT = 320, 240
STYLES = ("sketch", "pencil", "brush", "blueprint", "hiddenline", "technical", "chalkboard", "neon")
Picture = NDArray[np.float64]
Colour = tuple[float, float, float]
RED, GREEN, BLUE = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
WHITE, BLACK, YELLOW = (1.0, 1.0, 1.0), (0.0, 0.0, 0.0), (1.0, 1.0, 0.0)


@pytest.fixture(scope="module", autouse=True)
def window() -> Iterator[None]:
    pygame.display.init()
    pygame.display.set_mode((WIDTH, HEIGHT), pygame.OPENGL | pygame.DOUBLEBUF)
    yield
    pygame.display.quit()


def shown(draw: Callable[[], None], style: str = "", frames: int = 2) -> Picture:
    """(HEIGHT, WIDTH, 3) of 0..1, from below upwards: the last frame."""
    if style:
        glshim.install(style)
    try:
        for _ in range(frames):
            draw()
            pixels = GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
            pygame.display.flip()
    finally:
        glshim.uninstall()
    return np.frombuffer(pixels, np.uint8).reshape(HEIGHT, WIDTH, 3) / 255.0


def luminance(picture: Picture) -> Picture:
    return np.asarray(picture**2.2 @ (0.2126, 0.7152, 0.0722))


def contrast(a: Picture, b: Picture) -> Picture:
    """Of the Web Content Accessibility Guidelines."""
    first, second = luminance(a) + 0.05, luminance(b) + 0.05
    return np.maximum(first, second) / np.minimum(first, second)


def deep(ground: Colour = BLACK) -> None:
    """A frame begins, with a camera that looks along z."""
    GL.glClearColor(*ground, 1.0)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glEnable(GL.GL_DEPTH_TEST)
    for switch in (GL.GL_BLEND, GL.GL_TEXTURE_2D, GL.GL_LIGHTING, GL.GL_LINE_SMOOTH):
        GL.glDisable(switch)
    GL.glDepthMask(True)
    GL.glLineWidth(1.0)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(45.0, WIDTH / HEIGHT, 0.5, 20.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.0, -5.0)


def flat() -> None:
    """Pixels, as HUDs have them."""
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GL.glOrtho(0, WIDTH, 0, HEIGHT, -1, 1)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glDisable(GL.GL_DEPTH_TEST)


def box(size: float = 0.8) -> None:
    """Some faces turned to the viewer, so that the frame has a layer."""
    GL.glColor3f(0.7, 0.4, 0.2)
    GL.glBegin(GL.GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        GL.glVertex3f(size * x, size * y, 0.2 * x)
    GL.glEnd()


def bar(colour: Colour, x: int, y: int) -> None:
    """Ten rows of ones: a thick letter."""
    GL.glColor3f(*colour)
    GL.glRasterPos2f(x, y)
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
    GL.glBitmap(16, 6, 0, 0, 0, 0, b"\xff\xff" * 6)


def line(colour: Colour, *ends: tuple[float, ...]) -> None:
    GL.glColor3f(*colour)
    GL.glBegin(GL.GL_LINES)
    for end in ends:
        GL.glVertex(*end)
    GL.glEnd()


COLOURS = (WHITE, BLACK, YELLOW, RED, GREEN, BLUE)


def hud(ground: Colour) -> Callable[[], None]:
    def draw() -> None:
        deep(ground)
        box()
        flat()
        for k, colour in enumerate(COLOURS):
            bar(colour, 10, 10 + 20 * k)

    return draw


@pytest.mark.parametrize("style", some(STYLES, 4))
@pytest.mark.parametrize("ground", [BLACK, WHITE], ids=["on black", "on white"])
def test_text_of_every_colour_can_be_read(style: str, ground: Colour) -> None:
    found = shown(hud(ground), style)
    for k, _ in enumerate(COLOURS):
        y = 10 + 20 * k
        letter, paper = found[y + 1 : y + 5, 12:24], found[y + 7 : y + 12, 12:24]
        assert contrast(letter, paper.mean(axis=(0, 1))).min() > 3.5, COLOURS[k]


@pytest.mark.parametrize("style", ["sketch", "blueprint"])
def test_hues_stay(style: str) -> None:
    found = shown(hud(BLACK), style)
    for k, colour in enumerate(COLOURS[2:], 2):
        letter = found[12 + 20 * k, 18]
        most = np.asarray(colour) == 1.0
        assert letter[most].min() >= letter[~most].max() - 1e-6, (colour, letter)


def axes() -> None:
    """Before and after what they pass through."""
    deep()
    line(RED, (-2.0, 0.0, 0.0), (2.0, 0.0, 0.0))
    box()
    line(WHITE, (-1.9, -1.2, 0.0), (1.9, -1.2, 0.0))
    line(WHITE, (-1.9, 0.3, -1.0), (1.9, 0.3, -1.0))


@pytest.mark.parametrize("style", some(STYLES, 4))
def test_lines_in_a_scene_can_be_seen_where_the_program_shows_them(style: str) -> None:
    plain, found, bare = shown(axes), shown(axes, style), shown(lambda: (deep(), box()), style)
    ink = (plain != 0.0).any(axis=2) & ~(abs(plain - (0.7, 0.4, 0.2)) < 0.01).all(axis=2)
    assert ink.sum() > 400
    assert np.quantile(contrast(found, bare)[ink], 0.1) > 2.5
    hidden = (abs(plain - (0.7, 0.4, 0.2)) < 0.01).all(axis=2)
    assert np.quantile(abs(found - bare)[hidden].max(axis=1), 0.99) < 0.02  # behind it, nothing


def panel() -> None:
    deep()
    box()
    flat()
    GL.glColor3f(0.05, 0.05, 0.2)
    GL.glRectf(4, 4, 100, 40)
    bar(WHITE, 10, 10)


@pytest.mark.parametrize("style", ["sketch", "hiddenline"])
def test_text_on_a_panel_of_its_own_stays(style: str) -> None:
    plain, found = shown(panel), shown(panel, style)
    assert abs(plain - found)[6:38, 6:98].max() < 0.01


def smooth() -> None:
    deep(WHITE)
    box()
    flat()
    GL.glEnable(GL.GL_BLEND)
    GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
    GL.glEnable(GL.GL_LINE_SMOOTH)
    GL.glLineWidth(1.5)
    line(BLACK, (10.0, 10.0), (110.0, 41.0))


def test_smooth_edges_stay_smooth() -> None:
    plain, found = shown(smooth), shown(smooth, "hiddenline:paper=#ffffff")
    grey = (plain[5:50, 5:115] > 0.1) & (plain[5:50, 5:115] < 0.9)
    assert grey.sum() > 300
    assert abs(plain - found)[5:50, 5:115][grey].max() < 0.05


def test_an_option_turns_it_off_and_on() -> None:
    off, on = (shown(hud(BLACK), f"sketch:own_ink={word}") for word in ("off", "on"))
    assert np.allclose(off[12, 18], 1.0)
    assert luminance(on[12, 18]) < 0.1
    assert np.allclose(shown(hud(BLACK), "raskar")[12, 18], 1.0)


def test_ink_that_is_gathered_and_needs_no_other_colour_is_the_program_s_own() -> None:
    plain = shown(axes)
    found = shown(axes, "raskar:own_ink=on,contours=off,ridges=off,valleys=off")
    differ = (abs(plain - found) > 0.02).any(axis=2)
    assert differ.mean() < 0.001


def test_letters_in_lists_and_pixels_read_one_by_one() -> None:
    letters = GL.glGenLists(1)
    picked = []

    def draw() -> None:
        GL.glNewList(letters, GL.GL_COMPILE)
        GL.glBitmap(16, 6, 0, 0, 0, 0, b"\xff\xff" * 6)
        GL.glEndList()
        deep()
        box()
        flat()
        GL.glColor3f(*WHITE)
        GL.glRasterPos2f(10, 10)
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
        GL.glCallLists(1, GL.GL_UNSIGNED_INT, np.array([letters], np.uint32))

    def pick() -> None:
        draw()
        picked.append(GL.glReadPixels(12, 12, 1, 1, GL.GL_RGB, GL.GL_UNSIGNED_BYTE))

    try:
        assert luminance(shown(draw, "sketch")[12, 12]) < 0.1
        shown(pick, "sketch")
    finally:
        GL.glDeleteLists(letters, 1)
    assert [bytes(pixel) for pixel in picked] == [b"\xff\xff\xff"] * 2


def test_depth_is_what_it_is_without_a_style() -> None:
    depths = []

    def draw() -> None:
        axes()
        read = GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_DEPTH_COMPONENT, GL.GL_FLOAT)
        depths.append(np.array(read).ravel())

    shown(draw, frames=1)
    shown(draw, "sketch", frames=1)
    assert abs(depths[0] - depths[1]).max() < 1e-6


def test_the_option_has_one_name_in_all_styles() -> None:
    styles = [name for name in names() if name != "none"]
    assert len(styles) > 12
    for name in styles:
        assert vars(parse_style(name))["own_ink"] == "auto", name


def atlas(kind: str) -> NDArray[np.uint8]:
    """(32, 64, 4) what is in the texture: letters, a wall, a pane, a tree."""
    y, x = np.mgrid[0:32, 0:64]
    texels = np.zeros((32, 64, 4), np.uint8)
    texels[..., :3] = 255
    if kind == "letters":
        texels[..., 3] = 255 * ((x // 4 % 3 == 0) & (y > 6) & (y < 26))
    elif kind == "wall":
        texels[..., 0], texels[..., 3] = 40 * (x // 8 % 2) + 120, 255
    elif kind == "pane":
        texels[..., 3] = 100
    else:
        crown = (x - 32) ** 2 + 4 * (y - 18) ** 2 < 700
        texels[...] = np.where(crown[..., None], (30, 140, 40, 255), (110, 70, 30, 0))
        texels[(abs(x - 32) < 4) & (y < 12)] = 110, 70, 30, 255
    return texels


FORMATS = {
    "alpha": (GL.GL_ALPHA, (3,)), "luminance alpha": (GL.GL_LUMINANCE_ALPHA, (0, 3)),
    "rgba": (GL.GL_RGBA, (0, 1, 2, 3)),
}  # fmt: skip


def quads(kind: str, layout: str, *, tall: bool = False) -> Callable[[], None]:
    """A frame of one textured, blended quad, flat and with a depth test, or (tall) in a scene."""
    name, channels = FORMATS[layout]
    texels = np.ascontiguousarray(atlas(kind)[..., channels])

    def draw() -> None:
        deep()
        if not tall:
            flat()
            GL.glEnable(GL.GL_DEPTH_TEST)
        texture = GL.glGenTextures(1)
        GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
        for filtering in (GL.GL_TEXTURE_MIN_FILTER, GL.GL_TEXTURE_MAG_FILTER):
            GL.glTexParameteri(GL.GL_TEXTURE_2D, filtering, GL.GL_NEAREST)
        GL.glTexImage2D(
            GL.GL_TEXTURE_2D, 0, name, 64, 32, 0, name, GL.GL_UNSIGNED_BYTE, texels
        )  # fmt: skip
        GL.glEnable(GL.GL_TEXTURE_2D)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
        GL.glColor3f(1.0, 1.0, 1.0)
        GL.glBegin(GL.GL_QUADS)
        for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
            GL.glTexCoord2f(u, v)
            if tall:
                GL.glVertex3f(2.0 * u - 1.0, v - 0.5, 0.0)
            else:
                GL.glVertex2f(96 + 128 * u, 88 + 64 * v)
        GL.glEnd()
        GL.glDisable(GL.GL_TEXTURE_2D)
        GL.glDisable(GL.GL_BLEND)
        if not tall:  # something solid, so that there is paper
            GL.glColor3f(0.5, 0.5, 0.5)
            GL.glRectf(270, 200, 300, 220)
        GL.glDeleteTextures([texture])

    return draw


LETTERS = np.repeat(np.repeat(atlas("letters")[..., 3] > 0, 2, axis=0), 2, axis=1)
"""(64, 128) where letters are on the quad."""


@pytest.mark.parametrize("layout", FORMATS)
@pytest.mark.parametrize("style", some(STYLES, 3))
def test_text_on_textured_quads_is_text(style: str, layout: str) -> None:
    found = shown(quads("letters", layout), style)
    own, about = found[88:152, 96:224], found[80:160, 88:232]
    paper = np.median(found[20:60, 20:60], axis=(0, 1))
    assert contrast(own, paper)[LETTERS].min() > 3.5
    rim = np.ones(about.shape[:2], bool)  # neither boxed nor filled
    rim[8:-8, 8:-8] = ~LETTERS
    assert np.quantile(contrast(about, paper)[rim], 0.97) < 1.6


def test_text_has_no_outline_where_the_style_brings_no_paper() -> None:
    plain, found = (shown(quads("letters", "rgba"), style) for style in ("", "raskar"))
    assert abs(plain - found)[60:180, 80:240].max() < 0.01


@pytest.mark.parametrize("kind", ["wall", "pane"])
def test_a_wall_and_a_pane_are_surfaces(kind: str) -> None:
    plain, found = (shown(quads(kind, "rgba"), style) for style in ("", "raskar:ink=red"))
    assert (abs(plain - found)[84:92, 96:224].max(axis=2) > 0.3).sum() > 100  # the lower edge


@pytest.mark.parametrize("kind", ["tree", "letters", "pane"])
def test_what_stands_in_a_scene_is_of_the_scene(kind: str) -> None:
    draw = quads(kind, "rgba", tall=True)
    plain, found = (shown(draw, style) for style in ("", "raskar:ink=red"))
    assert (abs(plain - found).max(axis=2) > 0.3).sum() > 200
