"""The numbered demos: they are all there, each runs head-less either way, and their models hold."""

import importlib
import math
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

import demo_apps
from demo_apps import gcode, slicer
from demo_apps.level import CEILING, LEVEL, Level
from tests.sweep import some

from .catalog import OURS

FOLDER = Path(demo_apps.__file__).parent
NUMBERED = sorted(FOLDER.glob("[0-9]*.py"))
gears = importlib.import_module("demo_apps.01_gears")
molecule = importlib.import_module("demo_apps.04_molecule")
terrain = importlib.import_module("demo_apps.05_terrain")
room = importlib.import_module("demo_apps.10_textured_room")
Floats = NDArray[np.float64]


def test_there_are_ten_and_each_says_what_it_is_and_how_to_leave() -> None:
    assert [int(path.name[:2]) for path in NUMBERED] == list(range(1, len(NUMBERED) + 1))
    assert len(NUMBERED) >= 10
    for path in NUMBERED:
        said = " ".join((importlib.import_module(f"demo_apps.{path.stem}").__doc__ or "").split())
        assert "ESC leaves" in said or "ESC to leave" in said, path.name
    assert {f"demo_apps/{path.stem}" for path in NUMBERED} <= {p.name for p in OURS}


def test_they_use_three_toolkits_and_each_way_of_drawing() -> None:
    texts = {path.stem: path.read_text(encoding="utf-8") for path in NUMBERED}
    for toolkit in ("GLUT", "import glfw", "import pygame"):
        assert sum(toolkit in text for text in texts.values()) >= 2, toolkit
    together = "\n".join(texts.values())
    for call in ("glBegin", "glCallList", "glDrawArrays", "glDrawElements", "VBO", "gluSphere",
                 "gluCylinder", "glutSolid", "glutBitmapCharacter", "gluBuild2DMipmaps",
                 "glMultiTexCoord2f", "glOrtho", "GL_BLEND", "GL_LIGHT1", "GL_FOG"):  # fmt: skip
        assert re.search(rf"\b{call}", together), call


@pytest.mark.parametrize("path", some(NUMBERED, 4), ids=lambda path: path.stem)
def test_as_a_file_it_runs_and_shows_something(path: Path, tmp_path: Path) -> None:
    """As modules they run in test_programs; here as files, and from another folder."""
    picture = tmp_path / f"{path.stem}.png"
    environment = os.environ | {
        "PYTHONPATH": str(FOLDER.parent), "GLSHIM_FRAMES": "3", "GLSHIM_CAPTURE": str(picture)}
    done = subprocess.run([sys.executable, str(path)], cwd=tmp_path, env=environment,
                          capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr, done.stderr
    colours = np.asarray(Image.open(picture).convert("RGB").resize((160, 120)))
    assert len(np.unique(colours.reshape(-1, 3), axis=0)) > 50


def inside(points: Floats, border: Floats) -> NDArray[np.bool_]:
    """Which points (n, 2) lie within a border (m, 2), by the number of crossings of a ray."""
    (x, y), (ax, ay) = points.T[..., None], border.T
    bx, by = np.roll(border, -1, axis=0).T
    over = (ay > y) != (by > y)
    at = ax + (y - ay) / np.where(by == ay, 1.0, by - ay) * (bx - ax)
    return np.asarray((over & (x < at)).sum(axis=1) % 2 == 1)


def turned(points: Floats, degrees: float, shift: float = 0.0) -> Floats:
    a = math.radians(degrees)
    return points @ np.array([(math.cos(a), math.sin(a)), (-math.sin(a), math.cos(a))]) + (shift, 0)


@pytest.mark.parametrize("sun", np.linspace(0.0, 360.0 / gears.SUN, 9).tolist())
def test_teeth_roll_without_running_into_each_other(sun: float) -> None:
    """In the frame of the carrier, the first planet lies along x."""
    carrier, spins = gears.planet_turns(sun)
    reach = gears.MODULE * (gears.SUN + gears.PLANET) / 2
    first = turned(gears.gear_outline(gears.SUN), sun - carrier)
    planet = turned(gears.gear_outline(gears.PLANET), spins[0], reach)
    spaces = turned(gears.gear_outline(gears.RING, 1.15, 0.9, -gears.BACKLASH),
                    180.0 / gears.RING - carrier)  # fmt: skip
    assert not inside(first, planet).any() and not inside(planet, first).any()
    assert inside(planet, spaces).all()
    # They do mesh: the planet's tips reach into the sun's spaces and into the ring's.
    tips = np.hypot(*first.T).max()
    assert np.hypot(*planet.T).min() < tips - gears.MODULE
    assert np.hypot(*planet.T).max() > np.hypot(*spaces.T).min() + gears.MODULE


def test_the_planets_fit_all_three() -> None:
    assert gears.RING == gears.SUN + 2 * gears.PLANET
    assert (gears.SUN + gears.RING) % 3 == 0
    assert gears.SUN % 3 == 0 and gears.RING % 3 == 0  # then they stand alike


VALENCE = {"H": 1, "C": 4, "N": 3, "O": 2}


@pytest.mark.parametrize("make, formula", [
    (molecule.caffeine, "C8 H10 N4 O2"), (molecule.fullerene, "C60"), (molecule.benzene, "C6 H6"),
])
def test_every_atom_has_its_bonds(make: object, formula: str) -> None:
    found = make()  # type: ignore[operator]
    assert found.formula == formula
    bonds = [0] * len(found.symbols)
    for first, second, order in found.bonds:
        bonds[first] += order
        bonds[second] += order
    assert [VALENCE[s] for s in found.symbols] == bonds


def test_trees_stand_on_dry_ground_and_the_eye_stays_above_it() -> None:
    land = terrain.Land()
    trees = land.clearings()
    assert len(trees) == terrain.TREES
    assert all(y > terrain.WATER and abs(land.at(x, z) - y) < 0.1 for x, y, z, _ in trees)
    flight = terrain.Flight(land)
    for time in np.linspace(0.0, terrain.LAP, 200):
        assert flight.level(time) > max(land.at(*flight.course(time)), terrain.WATER) + 0.5


def test_the_course_keeps_clear_of_walls_pillars_and_crates() -> None:
    level = Level()
    walker = room.Walker(level)
    for metres in np.arange(0.0, walker.course.way[-1], 0.1):
        place = walker.course.at(metres)
        for aside in ((0, 0), (0.2, 0), (-0.2, 0), (0, 0.2), (0, -0.2)):
            assert walker.ground(place + np.array(aside)) < 1.1, (metres, place)


def test_no_patch_of_the_level_is_there_twice_and_light_has_shadows() -> None:
    level = Level()
    middles = np.array([patch.corners.mean(axis=0) for patch in level.patches])
    assert len(np.unique(middles.round(4), axis=0)) == len(middles)
    floor = sum(p.paint == "tiles" for p in level.patches)
    assert floor == sum(letter != "#" for row in LEVEL for letter in row)
    assert all(p.corners[:, 1].max() <= CEILING for p in level.patches)
    light = level.light()
    assert light.min() < 60 and light.max() == 255


def test_the_planter_is_what_the_slicer_makes() -> None:
    stored = (FOLDER / "models" / "planter.gcode").read_text(encoding="utf-8")
    assert stored == slicer.sliced()
    strands = gcode.parsed(stored)
    assert {s.kind for s in strands} == {"SKIRT", "SKIN", "WALL-INNER", "WALL-OUTER", "FILL"}
    widths = np.concatenate([s.widths for s in strands])
    assert np.allclose(widths, slicer.WIDTH, atol=0.02)


@pytest.mark.parametrize("text, points", [
    ("M83\nG1 X10 E1\nG1 X20 E1\nG1 E-2\nG1 X30\nG1 Y5 E1", [[0, 10, 20], [30, 30]]),
    ("G92 E5\nG1X10E6 (out)\nM117 nearly 1x done\nG91\nG1 X-4 E1 ; back", [[0, 10, 6]]),
])
def test_relative_and_absolute_moves_are_followed(text: str, points: list[list[float]]) -> None:
    assert [[p[0] for p in s.points] for s in gcode.parsed(text)] == points


@pytest.mark.parametrize("content, said", [
    (b"G1 X1 Y1.2.3 E4\n", "line 1"), (b"\xff\xfe\x00", "not text"), (b"G0 X1\n", "nothing"),
    (None, "No such file"),
])
def test_a_bad_file_is_refused_in_one_line(
        tmp_path: Path, content: bytes | None, said: str) -> None:
    path = tmp_path / "some.gcode"
    if content is not None:
        path.write_bytes(content)
    environment = os.environ | {"PYTHONPATH": str(FOLDER.parent)}
    done = subprocess.run([sys.executable, "-m", "demo_apps.09_gcode", str(path)], env=environment,
                          capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1 and str(path) in done.stderr and said in done.stderr
