"""`glshim shot`: the program's frame, larger. `python -m tests.shots` takes the large ones."""

import ast
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.programs.harness import HERE, ROOT
from tests.programs.sources import LIBRARIES, SourceMissing, fetched
from tests.sweep import some

BOARD = str(HERE / "apps" / "drawing_board.py")


def glshim(*arguments, cwd=None):
    paths = os.pathsep.join(filter(None, (str(ROOT), os.environ.get("PYTHONPATH"))))
    done = subprocess.run(
        [sys.executable, "-m", "glshim", *map(str, arguments)], text=True, capture_output=True,
        timeout=300, check=False, cwd=cwd, env={**os.environ, "PYTHONPATH": paths})
    assert "Traceback" not in done.stderr, done.stderr
    return done


def pixels(path):
    return np.asarray(Image.open(path).convert("RGB")).astype(int)


def captured(folder, style, *program):
    """A frame as the program's own window has it, at the same moment."""
    done = glshim("gallery", *program, "--styles", style, "-o", folder / "captured.html")
    assert done.returncode == 0, done.stderr
    (picture,) = (folder / "captured_files").glob("*.png")
    return pixels(picture)


def shot(folder, style, *arguments):
    out = folder / "shot.png"
    out.unlink(missing_ok=True)
    done = glshim("shot", *arguments, "--style", style, "-o", out)
    assert done.returncode == 0, done.stderr
    return pixels(out), done.stderr


def unlike(a, b, by=24):
    """Share of pixels that differ by more than some levels."""
    return float((np.abs(a - b).max(axis=2) > by).mean())


def boxed(picture, k):
    """Each k by k pixels as one."""
    height, width, _ = picture.shape
    return picture.reshape(height // k, k, width // k, k, 3).mean(axis=(1, 3))


def test_at_scale_1_it_is_the_captured_frame(tmp_path: Path) -> None:
    program = (BOARD, "320", "240", "1")
    plain = captured(tmp_path, "raskar", *program)
    assert (shot(tmp_path, "raskar", *program, "--scale", "1")[0] == plain).all()
    # In tiles it is drawn into a surface of ours: ties of the rasteriser aside, the same.
    tiled, said = shot(tmp_path, "raskar", *program, "--scale", "1", "--tile", "150")
    assert said == "" and unlike(tiled, plain, by=0) < 0.002


@pytest.mark.parametrize("style", some(["raskar", "edge_mesh:texture=dashed", "watercolour"], 1))
def test_larger_it_is_the_frame_of_a_larger_window(tmp_path: Path, style: str) -> None:
    program = (BOARD, "320", "240", "1")
    larger, said = shot(tmp_path, style, *program, "--scale", "3")
    assert said == "" and larger.shape == (720, 960, 3)
    near = boxed(larger, 3) - captured(tmp_path, style, *program)
    assert np.abs(near).mean() < 4.0
    # Drawn in tiles it is the same picture: no seam, no dash that goes on elsewhere.
    tiled, said = shot(tmp_path, style, *program, "--scale", "3", "--tile", "400")
    assert said == "" and unlike(tiled, larger) < 0.0003


def test_it_is_what_a_window_of_that_size_shows(tmp_path: Path) -> None:
    # Text apart, which the program leaves out where it draws wider lines by itself.
    style = "raskar:{0}silhouette_width={1},ridge_width={1},valley_width={1}"
    larger, _ = shot(tmp_path, style.format("", "2"), BOARD, "320", "240", "1", "--scale", "3")
    window = captured(tmp_path, style.format("", "6"), BOARD, "960", "720", "3")
    larger[600:700, 280:460] = window[600:700, 280:460] = 0
    assert unlike(larger, window) < 0.0005


def test_lines_points_text_and_dashes_are_as_much_wider(tmp_path: Path) -> None:
    plain = captured(tmp_path, "none", BOARD, "320", "240", "1")
    larger, _ = shot(tmp_path, "none", BOARD, "320", "240", "1", "--scale", "3")
    assert np.abs(boxed(larger, 3) - plain).mean() < 1.0
    red = (np.abs(larger - (178, 25, 25)).max(axis=2) < 4)
    # The dashed line near the top is 9 pixels wide, its dashes 24; points are 18 a side.
    line = red[:120]
    assert line.any(axis=1).sum() == 9
    dashes = np.diff(np.flatnonzero(np.diff(line.any(axis=0).astype(int))))
    assert set(dashes[:-1].tolist()) == {24}
    points = red[600:]
    assert points.any(axis=1).sum() == 18
    text = (larger[600:700, 290:440] < 40).all(axis=2)
    same = (plain[200:233, 97:146] < 40).all(axis=2)
    assert text.sum() == pytest.approx(9 * same.sum(), rel=0.15) and same.sum() > 60


def test_the_program_sees_its_own_window(tmp_path: Path) -> None:
    plain = run_board(tmp_path)
    shot_of_it = run_board(tmp_path, GLSHIM_SHOT=plan(tmp_path / "seen.png"))
    assert plain[0] == [[0, 0, 320, 240], [240, 0, 80, 80], 3.0, 6.0, 0, 0x405, True, 2, 0]
    assert len(shot_of_it) == 3 and shot_of_it == plain[:3]
    assert Image.open(tmp_path / "seen.png").size == (800, 600)


def plan(path):
    from glshim.running.shots.plan import Plan

    return Plan(str(path), 3, None, 2.5).as_text()


def run_board(folder, **variables):
    """What drawing_board.py says about GL's state, frame by frame."""
    from glshim.running.subjects import surroundings

    done = subprocess.run(
        [sys.executable, BOARD, "320", "240", "1"], cwd=folder, text=True, timeout=60,
        capture_output=True, check=True,
        env={**surroundings(os.environ), "PYTHONPATH": str(ROOT), "GLSHIM_STYLE": "raskar",
             "GLSHIM_FRAMES": "4", **variables})
    states = [line for line in done.stderr.splitlines() if line.startswith("state ")]
    return [ast.literal_eval(line.removeprefix("state ")) for line in states]


def test_a_program_that_counts_frames_is_whole_in_one_tile_and_told_of_in_many(
    tmp_path: Path,
) -> None:
    program = (BOARD, "320", "240", "1", "counting")
    plain = captured(tmp_path, "none", *program)
    whole, said = shot(tmp_path, "none", *program, "--scale", "2")
    assert said == "" and np.abs(boxed(whole, 2) - plain).mean() < 1.0
    torn, said = shot(tmp_path, "none", *program, "--scale", "2", "--tile", "300")
    assert "tiles do not match" in said and torn.shape == whole.shape


MOMENTS = [("glut",), ("qt", 30), ("glfw", 7), ("tk", 30), ("pygame",), ("qt",), ("pygame", 30),
           ("tk",), ("pyglet", 30)]
SOURCES = {"qt": ("PyQt5", "dxf2gcode"), "tk": ("pyopengltk",), "pyglet": ("pyglet",)}
TICKS = {("glut",): 2, ("glut", 100): 2, ("qt", 30): 1, ("tk", 30): 2, ("pyglet", 30): 1}
"""How often a timer comes before the third frame, with a widget's first paints."""


@pytest.mark.parametrize("program", [("glut", 100), *some(MOMENTS, 1)], ids=str)
def test_every_way_shows_the_same_moment(
    tmp_path: Path, program: tuple[object, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever the scale, the style and the number of tiles, and in galleries: timers, idle
    functions, clocks, and widgets that paint on demand."""
    find_modules(SOURCES.get(str(program[0]), ()), monkeypatch)
    app = (HERE / "apps" / "moments.py", *program)
    gallery = captured(tmp_path, "none", *app)[45, 60]
    ticks, clock, _ = gallery.tolist()
    assert ticks == 8 * TICKS.get(program, 0) and clock
    for style, *way in (("raskar", "2"), ("none", "2", "--tile", "150")):
        picture, said = shot(tmp_path, style, *app, "--scale", *way)
        assert "tiles do not match" not in said
        assert picture[45, 60].tolist() == picture[-1, -1].tolist() == gallery.tolist(), way


def find_modules(sources, monkeypatch):
    """Have programs find what these sources bring."""
    try:
        folders = {source: fetched(source) for source in sources}
    except SourceMissing as reason:
        pytest.skip(str(reason))
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(map(str, folders.values())))
    libraries = [str(folders[source] / LIBRARIES[source])
                 for source in sources if source in LIBRARIES]
    if libraries:
        monkeypatch.setenv("LD_LIBRARY_PATH", os.pathsep.join(libraries))


def test_a_size_of_another_shape_is_filled(tmp_path: Path) -> None:
    square, said = shot(tmp_path, "none", BOARD, "320", "240", "1", "--size", "500x500")
    assert square.shape == (500, 500, 3) and "differ in shape" in said
    sheet, _ = shot(tmp_path, "none", BOARD, "320", "240", "1", "--size", "500x375")
    assert (square[62:437] == sheet).all() and (square[:62] == square[0, 0]).all()


def test_no_picture_is_told(tmp_path: Path) -> None:
    done = glshim("shot", BOARD, "320", "240", "1", "--size", "99999x75000", "-o", "x.png",
                  cwd=tmp_path)
    assert done.returncode == 1 and "more than this driver can draw" in done.stderr
    assert not (tmp_path / "x.png").exists()
    for arguments, says in ((["--size", "5"], "is not a valid size"),
                            (["--scale", "no"], "is not a valid scale"),
                            (["-o", "x.jpg"], "must end in .png"),
                            (["--tile", "3"], "at least 64")):
        done = glshim("shot", BOARD, *arguments, cwd=tmp_path)
        assert done.returncode == 2 and says in done.stderr
