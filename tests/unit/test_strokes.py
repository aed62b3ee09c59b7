"""Textures that strokes are drawn with, as pictures: rows outside to inside, tiling along."""

from __future__ import annotations

import runpy
import sys
from itertools import combinations, pairwise
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from glshim.styling import textures as strokes
from glshim.styling.pictures import read_image
from glshim.styling.textures import MADE, made

WIDTHS = (0.5, 1.0, 2.5, 6.0, 12.0, 20.0, 33.3, 64.0)
DRAWN = ("pen", "charcoal", "watercolour", "cartoon_fur")
"""Those of figure 6: irregular."""


def ink(name: str, width: float, length: float = 0.0) -> np.ndarray:
    """(rows, columns) share of ink, 0..1."""
    return made(name, width, length)[0].pixels[..., 3] / 255.0


def steps(picture: np.ndarray) -> np.ndarray:
    """(columns,) the mean change from each column to the next, the last being over the seam."""
    return np.abs(np.roll(picture, -1, axis=1) - picture).mean(axis=0)


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("name", MADE)
def test_it_is_white_paint_with_ink_in_its_alpha(name: str, width: float) -> None:
    image, length, coloured = made(name, width, 0.0)
    assert image.pixels.dtype == np.uint8 and image.pixels.shape[2] == 4
    assert max(image.pixels.shape) <= 4096
    assert (image.pixels[..., :3] == 255).all() and not coloured
    assert length >= width
    cover = ink(name, width)
    assert 0.15 < cover.mean() < 0.85
    assert cover.max() > 0.5
    assert width < 2.0 or cover.min() < 0.05


@pytest.mark.parametrize("length", [1e-3, 0.7, 5.0, 37.0, 1000.0, 4096.0])
@pytest.mark.parametrize("width", [0.5, 2.5, 16.0, 64.0])
@pytest.mark.parametrize("name", MADE)
def test_a_length_that_is_asked_for_is_kept(name: str, width: float, length: float) -> None:
    image, kept, _ = made(name, width, length)
    assert kept == length
    assert max(image.pixels.shape) <= 4096
    assert image.pixels[..., 3].any() or length < 0.1  # a dot smaller than a texel


@pytest.mark.parametrize("name", MADE)
def test_it_tiles_without_a_seam(name: str) -> None:
    """The change over the seam is one like any other: on the average as many are greater as are
    less. In a texture that is cut short nearly all are less."""

    def rank(picture: np.ndarray) -> float:
        jumps = steps(picture)
        return float((jumps < jumps[-1]).mean())

    sizes = [(width, length) for width in (2.5, 6.0, 10.0, 16.0, 25.0, 40.0) for length in (0, 100)]
    made_so = [ink(name, width, length) for width, length in sizes]
    for picture in made_so:
        assert steps(picture)[-1] <= steps(picture)[:-1].max() + 1e-9
    assert np.mean([rank(picture) for picture in made_so]) < 0.7
    if name in DRAWN:
        cut = [picture[:, : int(0.7 * picture.shape[1])] for picture in made_so]
        assert np.mean([rank(picture) for picture in cut]) > 0.85


@pytest.mark.parametrize("name", DRAWN)
def test_the_same_is_made_every_time_and_kept(name: str) -> None:
    first = made(name, 12.0, 0.0)[0]
    assert made(name, 12.0, 0.0)[0] is first
    strokes._image.cache_clear()
    again = made(name, 12.0, 0.0)[0]
    assert again is not first
    assert (again.pixels == first.pixels).all()


@pytest.mark.parametrize("name", DRAWN)
def test_nothing_in_it_repeats(name: str) -> None:
    """No shift along, but by nearly nothing, brings a drawn stroke over itself."""
    picture = ink(name, 12.0)
    rest = np.fft.rfft(picture - picture.mean(axis=1, keepdims=True), axis=1)
    fits = np.fft.irfft((np.abs(rest) ** 2).sum(axis=0), picture.shape[1])
    near = max(picture.shape[1] // 6, 1)
    assert fits[near:-near].max() < 0.6 * fits[0]


def test_each_name_is_another_texture() -> None:
    def looks(name: str) -> np.ndarray:
        """How much ink lies at each depth, and how that changes along."""
        picture = ink(name, 16.0)
        rows = np.array([part.mean() for part in np.array_split(picture, 8)])
        return np.r_[rows, picture.std(), steps(picture).mean() * 16]

    for one, other in combinations(MADE, 2):
        assert np.abs(looks(one) - looks(other)).max() > 0.08, (one, other)


@pytest.mark.parametrize("width", [2.5, 6.0, 20.0, 50.0])
def test_a_pen_stroke_is_solid_and_swells(width: float) -> None:
    picture = ink("pen", width)
    rows = len(picture)
    assert (picture[int(0.4 * rows) : int(0.88 * rows)] == 1.0).all()
    assert ((picture > 0.02) & (picture < 0.98)).mean() < 0.08  # crisp
    thick = picture.mean(axis=0)
    assert 0.03 < thick.std() < 0.15
    assert thick.min() > 0.55 and thick.max() < 1.0
    outer, inner = (side.mean(axis=0).std() for side in np.array_split(picture, 2))
    assert outer > inner > 0.002  # on the object it lies close


@pytest.mark.parametrize("width", [12.0, 24.0, 48.0])
def test_a_wash_is_thin_within_and_darker_at_both_rims(width: float) -> None:
    picture = ink("watercolour", width)
    rows = len(picture)
    middle = picture[int(0.45 * rows) : int(0.7 * rows)]
    assert 0.25 < middle.mean() < 0.7
    assert middle.max() < 0.95
    assert (middle > 0.05).all()  # nowhere dry
    rims = [half.max(axis=0) for half in (picture[: rows // 2], picture[int(0.8 * rows) :])]
    for rim in rims:
        assert (rim > middle.mean(axis=0) + 0.05).mean() > 0.9
    waves = np.abs(np.fft.rfft(middle.mean(axis=0) - middle.mean())) ** 2
    slow = round(made("watercolour", width, 0.0)[1] / (2.0 * width))
    assert waves[1 : slow + 1].sum() > 0.6 * waves.sum()  # it varies along, and slowly
    assert 0.01 < np.abs(np.diff(middle, axis=1)).mean() < 0.1  # the paper's grain


@pytest.mark.parametrize("width", [12.0, 16.0, 24.0, 64.0])
def test_fur_is_a_line_inside_and_grows_thin_outside(width: float) -> None:
    picture = ink("cartoon_fur", width)
    rows = len(picture)
    assert (picture[-max(rows // 16, 1) :] > 0.95).all()
    parts = [part.mean() for part in np.array_split(picture[: int(0.9 * rows)], 5)]
    assert all(out < within for out, within in pairwise(parts)), parts
    assert parts[0] < 0.06
    assert (picture[0] == 0.0).all()
    tops = rows - np.argmax(picture > 0.5, axis=0)
    assert tops.std() > 0.1 * rows  # of varying length


def test_tufts_lean_along_the_stroke() -> None:
    """What is outside lies further along than what it grows from."""
    picture = ink("cartoon_fur", 24.0)
    down, along = np.gradient(picture[: int(0.85 * len(picture))])
    assert (down * along).mean() > 0.4 * np.sqrt((down**2).mean() * (along**2).mean())


def test_the_command_writes_them_black_on_white(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "argv", ["strokes", str(tmp_path / "out"), "20"])
    runpy.run_module("glshim.styling.textures", run_name="__main__")
    for name in MADE:
        path = tmp_path / "out" / f"{name}.png"
        picture = read_image(str(path))  # as the option `texture` would take it
        assert (picture.pixels == made(name, 20.0, 0.0)[0].pixels).all()
    with Image.open(tmp_path / "out" / "sheet.png") as sheet:
        assert sheet.size[0] == 1024 and sheet.getextrema() == (0, 255)
