"""On OpenGL 2.1 the lines are those of 3.3, drawn from the numpy reference, and leave no state."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.golden import pictures
from tests.sweep import some

ROOT = Path(__file__).parents[2]
LEGACY = {"MESA_GL_VERSION_OVERRIDE": "2.1", "MESA_GLSL_VERSION_OVERRIDE": "120"}
INK = np.array((0xE8, 0x64, 0x1B))
DEMOS = ("island", "03_robot_arm", "07_cad_part", "viewer_knot")
STATE_SCENES = "array_draws-client or everything_under or lists or element_buffer"


BARE = """
from glshim.outputs.gl.device import guard
from glshim.driver.functions import gl
from tests.differential.test_contexts import VISIBLE, cube, inked
from tests.differential.world import run
from tests.sweep import some

def missing(*args):
    raise AssertionError("2.1 has no such function")

guard.has_vertex_arrays = lambda: False
for name in ("glBindVertexArray", "glVertexAttribDivisor", "glDrawArraysInstanced",
             "glGetStringi"):
    setattr(gl, name, missing)
plain = run(lambda app: cube())
for _ in range(3):
    lines = run(lambda app: cube(), VISIBLE)
    assert plain.differences(lines, pictures=False) == {}, plain.differences(lines)
    assert inked(lines) > 100
"""
"""What Mesa cannot take away: functions that came after 2.1, but for framebuffer objects."""


def child(*command: str, **variables: str) -> subprocess.CompletedProcess[str]:
    """A process of its own that imports this checkout."""
    environment = os.environ | {"PYTHONPATH": str(ROOT)} | variables
    return subprocess.run(
        [sys.executable, *command], cwd=ROOT, env=environment, capture_output=True,
        text=True, check=False, timeout=600,
    )  # fmt: skip


@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """The scenes of `legacy_scenes` by the context that drew them."""
    found = []
    for name, variables in (("3.3", {}), ("2.1", LEGACY)):
        out = tmp_path_factory.mktemp("legacy") / f"{name}.npz"
        done = child("-m", "tests.golden.legacy_scenes", str(out), **variables)
        assert done.returncode == 0, done.stderr
        with np.load(out) as saved:
            found.append(dict(saved))
        if variables:
            line = "intersections need OpenGL 3.3; the other lines are drawn"
            assert done.stderr.count(line) == 1
    return found


def alpha(before, after, ink):
    """How much ink lies on each pixel."""
    towards = ink - before.astype(float)
    share = ((after.astype(float) - before) * towards).sum(axis=2)
    return share / np.maximum((towards**2).sum(axis=2), 1.0)


def widened(mask):
    padded = np.pad(mask, 1)
    height, width = mask.shape
    return np.any(
        [padded[i : i + height, j : j + width] for i in range(3) for j in range(3)], axis=0
    )


def assert_alike(one, other, name, least=100):
    """Ink within a pixel of ink, both ways; and in fact the same to a few grey levels."""
    inked = [share > 0.5 for share in (one, other)]
    assert inked[0].sum() > least, name
    # Whether a line is seen may hang on the last bit of where it lies: the teapot's flaps, folds
    # thinner than a pixel, end a pixel sooner here and there.
    allowed = 2 if name.startswith("teapot") else 0
    for ink, known in (inked, inked[::-1]):
        assert (ink & ~widened(known)).sum() <= allowed, name
    off = np.abs(one - other)
    assert (off > 3 / 255).mean() < 2e-4, (name, (off > 3 / 255).sum())


def test_lines_are_those_of_the_gpu_within_a_pixel(both):
    modern, legacy = both
    assert (modern.pop("pen"), legacy.pop("pen")) == ("Pen", "LegacyPen")
    assert modern.keys() == legacy.keys() and len(modern) > 60
    for key in modern:
        name, _, which = key.partition("|")
        if which == "before":
            assert (modern[key] == legacy[key]).all()
            continue
        before = modern[f"{name}|before"]
        assert_alike(*(alpha(before, found[key], np.zeros(3)) for found in both), name)


@pytest.mark.parametrize("name", some(DEMOS, 2))
def test_demo_programs_look_alike(name, display, monkeypatch):
    program = pictures.programs()[name]
    style = f"{pictures.STYLE},intersections=off"
    before = pictures.plain(program, display)
    modern = pictures.painted(program, display, style)
    for variable, value in LEGACY.items():
        monkeypatch.setenv(variable, value)
    legacy = pictures.painted(program, display, style)
    shares = [alpha(before, after, INK) for after in (modern, legacy)]
    assert_alike(*shares, name)


def test_a_2_1_context_is_left_as_it_was():
    """The tests of state under 3.3, run there: hostile states, arrays, lists, errors. The app's
    programs in them may be of a later GLSL than ours."""
    done = child(
        "-m", "pytest", "-q", "-p", "no:cacheprovider", "tests/golden/test_lines_state.py", **LEGACY
    )
    assert done.returncode == 0, done.stdout[-4000:]
    done = child(
        "-m", "pytest", "-q", "-p", "no:cacheprovider", "tests/differential/test_transparent.py",
        "-k", f"raskar and ({STATE_SCENES})", MESA_GL_VERSION_OVERRIDE="2.1",
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-4000:]


def test_nothing_is_called_that_2_1_lacks():
    done = child("-c", BARE, **LEGACY)
    assert done.returncode == 0, done.stderr
    assert "switched off" not in done.stderr


def test_doctor_names_the_way_and_what_is_unavailable():
    said = {}
    for name, variables in (("3.3", {}), ("2.1", LEGACY),
                            ("1.4", {"MESA_GL_VERSION_OVERRIDE": "1.4"})):  # fmt: skip
        said[name] = child("-m", "glshim", "doctor", **variables).stdout
    assert "expanded by the GPU (OpenGL 3.3)" in said["3.3"]
    assert "unavailable" not in said["3.3"]
    assert "expanded by the CPU (OpenGL 2.1)" in said["2.1"]
    assert "unavailable            intersections need OpenGL 3.3" in said["2.1"]
    assert "no: OpenGL 1.4 is older than 2.1" in said["1.4"]


def test_2_1_without_framebuffer_objects_is_named():
    variables = LEGACY | {"MESA_EXTENSION_OVERRIDE": "-GL_ARB_framebuffer_object"}
    said = child("-m", "glshim", "doctor", **variables).stdout
    assert "no: OpenGL 2.1 without GL_ARB_framebuffer_object" in said
