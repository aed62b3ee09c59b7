"""Fur grows where there is skin, no farther than its length, in the app's colours, and is hidden by
what stands before it."""

from __future__ import annotations

import ctypes
import dataclasses
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from glshim_stylers.fur import Fur
from OpenGL import GL

from glshim.geometry.recovery.mesh import mesh
from glshim.linework.objects import Objects
from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.guard import Guard
from glshim.outputs.gl.passes.meshes import Residents
from glshim.styling.protocol import Layer
from tests import look
from tests.golden.test_lines_state import _hostile, _ordinary, _queries, _state

ROOT = Path(__file__).parents[2]
VIEW = look.look_at((3, 2, 2))
FLAT = Camera(VIEW, look.orthographic(), (0, 0, 400, 400))
DEEP = Camera(VIEW, look.perspective(), (0, 0, 400, 400))
FUR = Fur(length=20)
MESHES = {"sphere": look.sphere, "torus": look.torus, "cube": look.cube, "bowl": look.bowl}


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


def furry(backend, style, *items, shade=(0.8, 0.8, 0.8)):
    """Frame without fur, frame with fur, where the mesh is (all but the background)."""
    look.clear()
    for batch, camera in items:
        look.draw_base(batch, camera, shade)
    before, depth = look.pixels(), look.depths()
    backend.render(style.draws(Layer(tuple(items))))
    return before, look.pixels(), depth < 1.0


def widened(mask, by):
    """Pixels no farther than so many pixels from a mask."""
    rows, columns = np.mgrid[-by : by + 1, -by : by + 1]
    out = np.zeros_like(mask)
    high, wide = mask.shape
    padded = np.pad(mask, by)
    for dy, dx in zip(rows.ravel(), columns.ravel(), strict=True):
        if dy * dy + dx * dx <= by * by:
            out |= padded[by + dy : by + dy + high, by + dx : by + dx + wide]
    return out


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("droop", [0, 2])
def test_fur_stands_out_of_the_silhouette_and_no_farther_than_its_length(backend, name, droop):
    style = dataclasses.replace(FUR, droop=droop)
    before, after, there = furry(backend, style, (MESHES[name](), FLAT))
    changed = (before != after).any(axis=2)
    outside = changed & ~there
    ring = widened(there, 8) & ~there
    assert (changed & there).sum() > 0.9 * there.sum()
    assert outside.sum() > 0.4 * ring.sum()
    assert not (changed & ~widened(there, 22)).any()


def test_length_is_what_it_says(backend):
    reaches = []
    for length in (8, 16, 32):
        before, after, there = furry(backend, Fur(length=length, droop=0), (look.sphere(), FLAT))
        reach = 0
        changed = (before != after).any(axis=2)
        while (changed & ~widened(there, reach + 1)).any():
            reach += 1
        reaches.append(reach)
    for length, reach in zip((8, 16, 32), reaches, strict=True):
        assert 0.6 * length <= reach <= length + 1


def test_nothing_of_the_background_changes(backend):
    before, after, there = furry(backend, FUR, (look.torus(), FLAT))
    far = ~widened(there, 24)
    assert far.sum() > 1000
    assert (after[far] == before[far]).all()


def test_an_equal_frame_is_the_same_to_the_byte(backend):
    frames = [furry(backend, FUR, (look.torus(), DEEP))[1] for _ in range(3)]
    assert (frames[0] == frames[1]).all()
    assert (frames[0] == frames[2]).all()


def test_hairs_have_the_colour_of_the_skin(backend):
    shade = (0.8, 0.3, 0.1)
    for style, hue in ((Fur(sheen=0), shade), (Fur(sheen=0, colour="#1a4dcc"), (0.1, 0.3, 0.8))):
        before, after, _ = furry(backend, style, (look.torus(), DEEP), shade=shade)
        changed = (before != after).any(axis=2)
        # A hair is the hue, darker or lighter, over the white of the background: a mixture.
        wanted = np.array(hue) / max(hue)
        found = after[changed] / 255.0
        share = 1.0 - found.min(axis=1, keepdims=True)
        off = np.abs(found / found.max(axis=1, keepdims=True) - wanted).max(axis=1)
        opaque = off < 0.12
        assert opaque.mean() > 0.85
        assert (share > 0.05).all()


def test_no_hair_takes_the_colour_of_what_is_behind(backend):
    """A green wall behind a red torus: fur is red wherever it covers, or a mixture."""
    wall = look.batch([(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)], [[0, 1, 2, 3]])
    behind = Camera(np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -9], [0, 0, 0, 1]]),
                    look.perspective(), (0, 0, 400, 400))  # fmt: skip
    look.clear()
    look.draw_base(wall, behind, (0.0, 0.8, 0.0))
    look.draw_base(look.torus(), DEEP, (0.8, 0.0, 0.0))
    before = look.pixels()
    backend.render(Fur(sheen=0).draws(Layer(((look.torus(), DEEP),))))
    after = look.pixels()
    changed = (before != after).any(axis=2)
    outside = changed & (before[..., 1] > 100)
    assert outside.sum() > 1000
    # Green hairs would be a darker or a lighter green with no red.
    assert (after[outside][:, 0] > 20).mean() > 0.99


def test_a_wall_in_front_hides_fur_and_keeps_its_own_pixels(backend):
    ahead = Camera(np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -1], [0, 0, 0, 1]]),
                   look.perspective(), (0, 0, 400, 400))  # fmt: skip
    wall = look.batch([(-2, -2, 0), (0, -2, 0), (0, 2, 0), (-2, 2, 0)], [[0, 1, 2, 3]])
    look.clear()
    look.draw_base(look.torus(), DEEP)
    look.draw_base(wall, ahead, (0.2, 0.2, 0.9))
    before = look.pixels()
    backend.render(FUR.draws(Layer(((look.torus(), DEEP),))))
    after = look.pixels()
    assert (after[:, :199] == before[:, :199]).all()
    assert (after[:, 201:] != before[:, 201:]).any(axis=2).sum() > 5000


def test_fur_of_the_nearer_object_covers_that_of_the_farther_in_either_order(backend):
    def at(x):
        return Camera(look.look_at((3 + x, 2, 2), (x, 0, 0)), DEEP.projection, DEEP.viewport)

    near, far = (look.sphere(radius=0.5), at(-1.6)), (look.sphere(radius=1.2), at(0.6))
    one, other = (furry(backend, FUR, *items)[1] for items in ((near, far), (far, near)))
    # Rims are blended: they may differ where the two meet.
    assert (one != other).any(axis=2).mean() < 0.01


def test_shells_do_not_open_at_sharp_edges(backend):
    """Before a white background a dark cube's fur has no gap along its edges."""
    style = Fur(length=30, thickness=1.5, colour="#000000")
    _, after, there = furry(backend, style, (look.cube(), FLAT), shade=(0.0, 0.0, 0.0))
    assert (after[widened(there, 3)].max(axis=1) < 200).mean() > 0.98
    assert (after[there].max(axis=1) < 40).all()


def test_hairs_keep_to_a_mesh_that_moves(backend):
    """The pattern is taken from where the mesh was first seen."""
    still = mesh(look.torus())
    moved = still.moved((look.torus().positions * (1.0, 1.0, 1.5)).astype(np.float32))
    assert moved is not None
    assert moved.triangles is still.triangles
    with Guard():
        residents = Residents(ModernDevice(), Objects(1 << 24), 1 << 24)
    asked = []
    for one in (still, moved):
        residents.bind_rest(one)
        rows = (ctypes.c_float * (2048 * 4))()
        GL.glGetTexImage(GL.GL_TEXTURE_2D, 0, GL.GL_RGBA, GL.GL_FLOAT, rows)
        asked.append(np.array(rows).reshape(-1, 4)[: len(still.positions)])
    GL.glActiveTexture(GL.GL_TEXTURE0)
    assert (asked[0] == asked[1]).all()
    assert (asked[0][:, :3] == still.positions).all()


def test_an_animated_mesh_has_fur_in_each_frame(backend):
    for step in range(4):
        batch = look.torus(small=0.3 + 0.05 * step)
        before, after, there = furry(backend, FUR, (batch, DEEP))
        assert ((before != after).any(axis=2) & there).sum() > 0.9 * there.sum()


def test_bad_meshes_draw_nothing_or_what_is_sound(backend):
    nan, inf = np.nan, np.inf
    bad = look.batch(
        [(0, 0, 0), (1, 0, 0), (nan, 1, 0), (inf, 0, 1), (0, 0, 0), (2, 0, 0)],
        [[0, 1, 2], [0, 1, 3], [0, 1, 4], [0, 1, 5]],
    )
    before, after, _ = furry(backend, FUR, (bad, DEEP))
    assert (after == before).all()
    whole = furry(backend, FUR, (look.cube(), DEEP))[1]
    assert (furry(backend, FUR, (bad, FLAT), (look.cube(), DEEP))[1] == whole).all()
    behind = Camera(look.look_at((3, 2, 2), (6, 4, 4)), DEEP.projection, DEEP.viewport)
    assert (furry(backend, FUR, (look.cube(), behind))[1] == 255).all()


def test_the_eye_may_be_inside_of_the_mesh(backend):
    inside = Camera(look.look_at((0.1, 0.1, 0.1), (1, 0, 0)), DEEP.projection, DEEP.viewport)
    furry(backend, FUR, (look.cube(), inside))
    assert GL.glGetError() == 0


def test_reversed_depth_is_the_same_picture(backend):
    plain = furry(backend, FUR, (look.torus(), DEEP))[1]
    GL.glClearDepth(0.0)
    GL.glDepthFunc(GL.GL_GREATER)
    back = dataclasses.replace(DEEP, depth_range=(1.0, 0.0))
    turned = furry(backend, FUR, (look.torus(), back))[1]
    GL.glClearDepth(1.0)
    GL.glDepthFunc(GL.GL_LESS)
    assert (np.abs(turned.astype(int) - plain).max(axis=2) > 8).mean() < 0.01


def test_a_window_of_several_samples_has_fur_in_its_own_colours(backend):
    with look.multisampled():
        own = Backend.attach()
        before, after, there = furry(own, Fur(sheen=0), (look.torus(), DEEP), shade=(0.8, 0.3, 0.1))
        changed = (before != after).any(axis=2)
        assert changed[there].mean() > 0.9
        inner = after[there & changed].astype(float)
        assert (inner[:, 0] > 1.5 * inner[:, 1]).mean() > 0.9


@pytest.mark.parametrize("app", [_ordinary, _hostile])
def test_no_state_changes_and_all_fur_arrives(backend, app):
    batch = look.torus()
    draws = list(FUR.draws(Layer(((batch, DEEP),))))
    _, wanted, _ = furry(backend, FUR, (batch, DEEP))
    look.clear()
    look.draw_base(batch, DEEP)
    depth = look.depths()
    queries = _queries()
    GL.glPushAttrib(GL.GL_ALL_ATTRIB_BITS)
    GL.glPushClientAttrib(GL.GL_CLIENT_ALL_ATTRIB_BITS)
    app()
    before = _state(queries)
    backend.render(draws)
    after = _state(queries)
    if app is _hostile:
        GL.glPopAttrib()
        GL.glPopMatrix()
    GL.glPopClientAttrib()
    GL.glPopAttrib()
    GL.glDisable(GL.GL_RASTERIZER_DISCARD)
    GL.glActiveTexture(GL.GL_TEXTURE0)
    GL.glClientActiveTexture(GL.GL_TEXTURE0)
    assert {n: (before[n], after[n]) for n in before if before[n] != after[n]} == {}
    assert (look.pixels() == wanted).all()
    assert (look.depths() == depth).all()


LEGACY = """
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look
from tests.golden.test_fur import DEEP, FUR
with look.window():
    own = Backend.attach()
    look.clear()
    for _ in range(3):
        own.render(FUR.draws(Layer(((look.cube(), DEEP),))))
    assert (look.pixels() == 255).all()
"""


def test_before_opengl_3_3_it_says_so_once_and_draws_nothing():
    environment = os.environ | {
        "PYTHONPATH": str(ROOT), "MESA_GL_VERSION_OVERRIDE": "2.1",
        "MESA_GLSL_VERSION_OVERRIDE": "120",
    }  # fmt: skip
    done = subprocess.run([sys.executable, "-c", LEGACY], cwd=ROOT, env=environment,
                          capture_output=True, text=True, check=False)  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stderr.count("OpenGL 3.3") == 1
