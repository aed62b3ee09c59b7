"""Pictures of textured silhouettes, measured along the outline and across it."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from glshim_stylers.raskar import Raskar
from PIL import Image

from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.texts import parse_style
from tests import look

SIZE = 400
PLAIN = {"ridges": False, "valleys": False, "intersections": False}


@pytest.fixture(scope="module")
def backend():
    with look.window(SIZE, SIZE):
        yield Backend.attach()


def camera_at(azimuth, elevation, distance=5.0, parallel=False):
    u, v = np.radians((azimuth, elevation))
    eye = distance * np.array((np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)))
    projection = look.orthographic() if parallel else look.perspective()
    return Camera(look.look_at(eye, up=(0, 0, 1)), projection, (0, 0, SIZE, SIZE))


def outline(before, outwards, count=4000):
    """(N, 2) evenly spaced places counter-clockwise around a round object, from its top, so many
    pixels outside; and the length of the whole."""
    solid = np.argwhere((before != 255).any(axis=2))[:, ::-1] + 0.5
    centre = (solid.min(axis=0) + solid.max(axis=0)) / 2
    ways = np.exp(0.5j * np.pi + 2j * np.pi * np.arange(720) / 720)
    rays = (centre @ (1, 1j)) + ways[:, None] * np.arange(0, 199, 0.05)
    x, y = (np.clip(part.astype(int), 0, SIZE - 1) for part in (rays.real, rays.imag))
    inside = (before != 255).any(axis=2)[y, x]
    radius = 0.05 * (inside.shape[1] - np.argmax(inside[:, ::-1], axis=1))
    waves = np.fft.fft(radius)
    waves[15:-14] = 0.0
    rim = np.fft.ifft(waves).real * ways
    heading = np.roll(rim, -1) - np.roll(rim, 1)
    rim = rim - 1j * heading / np.abs(heading) * outwards
    rim = np.r_[rim, rim[:1]]
    length = np.r_[0, np.cumsum(np.abs(np.diff(rim)))]
    at = length[-1] * np.arange(count) / count
    places = np.stack([np.interp(at, length, part) for part in (rim.real, rim.imag)], axis=1)
    return places + centre, float(length[-1])


def sampled(picture, places):
    """(N, 3) the picture at places, between pixel centres, 0..1."""
    x, y = (places - 0.5).T
    i, j = np.floor(x).astype(int), np.floor(y).astype(int)
    u, v = (x - i)[:, None], (y - j)[:, None]
    rows = picture.astype(float) / 255
    low = rows[j, i] * (1 - u) + rows[j, i + 1] * u
    high = rows[j + 1, i] * (1 - u) + rows[j + 1, i + 1] * u
    return low * (1 - v) + high * v


def runs(ink, length):
    """Lengths in pixels of the runs of ink and of the gaps around a loop."""
    dark = ink > 0.5
    dark = np.roll(dark, -np.flatnonzero(dark & ~np.roll(dark, 1))[0])
    edges = np.flatnonzero(np.diff(np.r_[~dark[:1], dark, ~dark[-1:]].astype(int)))
    sizes = np.diff(edges) * length / len(ink)
    return sizes[0::2], sizes[1::2]


@pytest.mark.parametrize("width", [4.0, 8.0, 16.0])
@pytest.mark.parametrize("view", [(20, 40), (75, 25), (200, 65)])
def test_dashes_have_even_lengths_all_along(backend, width, view):
    style = Raskar(silhouette_width=width, texture="dashed", **PLAIN)
    before, after, _ = look.styled(backend, style, (look.torus(), camera_at(*view)))
    places, length = outline(before, width / 2 - 0.5)
    dashes, gaps = runs(1 - sampled(after, places)[:, 0], length)
    assert abs(len(dashes) - length / (5 * width)) < 1
    assert len(dashes) == len(gaps)
    for sizes, share in ((dashes, 0.6), (gaps, 0.4)):
        wanted = share * length / len(dashes)
        assert np.abs(sizes / wanted - 1).max() < 0.15, sizes.round(1)


@pytest.mark.parametrize("width", [6.0, 10.0, 16.0])
def test_dots_are_round_and_evenly_spaced(backend, width):
    style = Raskar(silhouette_width=width, texture="dotted", **PLAIN)
    before, after, _ = look.styled(backend, style, (look.torus(), camera_at(20, 50)))
    places, length = outline(before, width / 2 - 0.5)
    dots = round(length / (2 * width))
    middles, _ = runs(1 - sampled(after, places)[:, 0], length)
    assert len(middles) == dots
    ink = 1 - sampled(after, places)[:, 0]
    first = np.flatnonzero((ink <= 0.5) & (np.roll(ink, -1) > 0.5))
    centres = []
    for start in first:
        middle = places[(start + round(middles.mean() / 2 / length * len(ink))) % len(ink)]
        x, y = np.meshgrid(*(np.arange(int(c - width), int(c + width) + 1) + 0.5 for c in middle))
        weight = (before.astype(float) - after)[np.int64(y), np.int64(x), 0]
        weight /= before[np.int64(y), np.int64(x), 0]
        weight[np.hypot(x - middle[0], y - middle[1]) > 0.8 * width] = 0.0
        area = weight.sum()
        centre = np.array([(weight * axis).sum() / area for axis in (x, y)])
        centres.append(centre)
        spread = np.cov(np.stack([x.ravel(), y.ravel()]), aweights=weight.ravel())
        short, long = np.sqrt(np.linalg.eigvalsh(spread))
        assert short / long > 0.85
        assert abs(area / (np.pi * width**2 / 4) - 1) < 0.15
    spacing = np.hypot(*(np.roll(centres, -1, 0) - centres).T)
    assert (np.abs(spacing / spacing.mean() - 1) < 0.1).all(), spacing


def write(path, pixels):
    Image.fromarray(np.asarray(pixels, np.uint8)).save(path)
    return str(path)


def test_a_picture_lies_with_its_foot_on_the_object_in_its_own_colours(backend, tmp_path):
    stripes = np.zeros((32, 8, 3), np.uint8)
    stripes[:16], stripes[16:] = (220, 30, 30), (30, 60, 220)
    path = write(tmp_path / "across.png", stripes)
    for kind in ("torus", "cube"):
        style = Raskar(silhouette_width=12, texture=path, ink="#00ff00", **PLAIN)
        before, after, _ = look.styled(backend, style, (look.MESHES[kind](), camera_at(20, 50)))
        for outwards, colour in ((2.0, (30, 60, 220)), (8.5, (220, 30, 30))):
            if kind == "torus":
                places, _ = outline(before, outwards)
                off = np.abs(sampled(after, places) * 255 - colour).max(axis=1)
                assert (off < 25).mean() > 0.97, off
            else:
                assert (np.abs(after.astype(int) - colour).max(axis=2) < 3).sum() > 1000


def test_a_picture_runs_along_the_outline_with_the_object_on_its_left(backend, tmp_path):
    """Dark to light, counter-clockwise; grey: darkness is ink in the colour of the lines."""
    ramp = np.tile(np.linspace(0, 255, 64), (16, 1))
    path = write(tmp_path / "along.png", ramp)
    style = Raskar(silhouette_width=8, texture=path, texture_length=60, ink="#0000ff", **PLAIN)
    before, after, _ = look.styled(backend, style, (look.torus(), camera_at(20, 50)))
    places, length = outline(before, 3.5)
    colours = sampled(after, places)
    assert colours[:, 2].min() > 0.97
    ink = 1 - colours[:, 0]
    assert ink.min() < 0.1 and ink.max() > 0.9
    fading = np.roll(ink, -40) - ink  # 10 px on
    assert (fading < 0).mean() > 0.75
    again = np.diff((ink > 0.5).astype(int)).clip(0).sum()
    assert abs(again - round(length / 60)) <= 1


def test_transparent_parts_of_a_picture_are_no_ink(backend, tmp_path):
    pixels = np.zeros((16, 32, 4), np.uint8)
    pixels[..., 0] = 200
    pixels[:, 16:, 3] = 255
    path = write(tmp_path / "half.png", pixels)
    style = Raskar(silhouette_width=8, texture=path, texture_length=40, **PLAIN)
    before, after, _ = look.styled(backend, style, (look.torus(), camera_at(20, 50)))
    places, _ = outline(before, 3.5)
    colours = sampled(after, places)
    red, paper = colours[:, 1] < 0.1, colours[:, 1] > 0.97
    assert abs(red.mean() - 0.5) < 0.06 and abs(paper.mean() - 0.5) < 0.08
    assert np.abs(colours[red, 0] - 200 / 255).max() < 0.05
    # No dark or bright seam where ink ends: white and red mix.
    assert np.abs(colours[:, 0] - (1 - (1 - colours[:, 1]) * (1 - 200 / 255))).max() < 0.03


def test_a_style_file_finds_its_picture_beside_it(backend, tmp_path, monkeypatch):
    (tmp_path / "brushes").mkdir()
    write(tmp_path / "brushes" / "solid.png", np.full((4, 4, 3), (255, 128, 0)))
    (tmp_path / "mine.toml").write_text('style = "raskar"\ntexture = "brushes/solid.png"\n')
    style = parse_style(str(tmp_path / "mine.toml"))
    monkeypatch.chdir("/")
    _, after, _ = look.styled(backend, style, (look.torus(), camera_at(20, 50)))
    assert ((after == (255, 128, 0)).all(axis=2)).sum() > 500


@pytest.mark.parametrize("on", ["silhouettes", "all"])
def test_creases_have_the_texture_only_if_asked(backend, on):
    style = Raskar(silhouette_width=6, ridge_width=6, texture="dashed", texture_on=on)
    plain = Raskar(silhouette_width=6, ridge_width=6, silhouettes=False)
    item = look.cube(), camera_at(30, 30)
    before, ridges, _ = look.styled(backend, plain, item)
    _, after, _ = look.styled(backend, style, item)
    ridge = (ridges == 0).all(axis=2) & (before == 204).all(axis=2)
    share = (after[ridge] < 100).all(axis=1).mean()
    assert share > 0.95 if on == "silhouettes" else 0.4 < share < 0.85


def test_charcoal_is_uneven_but_leaves_no_gap(backend):
    style = Raskar(silhouette_width=10, texture="charcoal", **PLAIN)
    before, after, _ = look.styled(backend, style, (look.torus(), camera_at(20, 50)))
    depths = [1 - sampled(after, outline(before, out)[0])[:, 0] for out in (1.5, 4.5, 9.3)]
    assert depths[0].mean() > 0.6 and depths[1].mean() > 0.7
    assert depths[2].mean() < 0.3  # a rim that frays outside
    assert 0.15 < depths[1].std() < 0.45  # tooth
    length = outline(before, 4.5)[1]
    window = int(12 / length * len(depths[1]))
    along = np.convolve(np.maximum(depths[0], depths[1]), np.ones(window) / window, "valid")
    assert along.min() > 0.35


def shift(one, other, length, most):
    """Pixels by which a pattern around a loop has moved, at most so many."""
    steps = np.arange(-int(most / length * len(one)), int(most / length * len(one)) + 1)
    fits = [np.dot(one - one.mean(), np.roll(other, -k)) for k in steps]
    return float(steps[np.argmax(fits)] * length / len(one))


def drift(backend, mesh, cameras, width=6.0):
    """(F,) pixels by which dashes on the outline move, measured from its top, frame to frame."""
    style = Raskar(silhouette_width=width, texture="dashed", **PLAIN)
    frames = []
    for camera in cameras:
        before, after, _ = look.styled(backend, style, (mesh, camera))
        places, length = outline(before, width / 2 - 0.5)
        frames.append((1 - sampled(after, places)[:, 0], length))
    most = 2.5 * width
    return np.array([shift(a, b, length, most) for (a, length), (b, _) in pairwise(frames)])


@pytest.mark.parametrize("name", ["torus", "sphere"])
def test_the_pattern_does_not_jump_in_a_slow_turn(backend, name):
    """Half a degree a frame, which is a pixel or so: it goes with the object."""
    cameras = [camera_at(20 + 0.5 * k, 35 + 0.25 * k) for k in range(60)]
    moved = np.abs(drift(backend, look.MESHES[name](), cameras))
    print(f"{name}: mean shift {moved.mean():.2f} px, median {np.median(moved):.2f}, "
          f"most {moved.max():.2f} of a period of 30")  # fmt: skip
    assert moved.mean() < 1.5
    assert moved.max() < 3.0


def test_intersections_have_the_texture_too(backend):
    camera = camera_at(30, 30)
    lone = {"silhouettes": False, "ridges": False, "valleys": False}
    lone |= {"intersections": True, "intersection_width": 6}
    items = (look.cube(0.7), camera), (look.torus(), camera)
    _, whole, _ = look.styled(backend, Raskar(**lone), *items)
    _, dashed, _ = look.styled(backend, Raskar(**lone, texture="dashed", texture_on="all"), *items)
    line = (whole == 0).all(axis=2)
    assert line.sum() > 500
    assert 0.4 < (dashed[line] < 100).all(axis=1).mean() < 0.85
