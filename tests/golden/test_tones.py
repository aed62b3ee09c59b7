"""Tones lie on surfaces, paper behind them, and lines over both."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest
from glshim_stylers.edge_mesh import EdgeMesh
from glshim_stylers.shared.tones import TONES, tone_passes
from OpenGL import GL
from PIL import Image

from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.colours import parse_colour
from glshim.styling.protocol import Layer
from tests import look

CAMERA = Camera(look.look_at((3, 2, 2)), look.perspective(), (0, 0, 400, 400))
LINES = ("contours", "ridges", "valleys", "boundary")
BARE = dict.fromkeys(LINES, False)
BEHIND, SHADE = (0.2, 0.5, 0.9), (0.3, 0.25, 0.2)


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


def drawn(backend, *, mesh=None, shade=SHADE, **options):
    """The app's frame, the styled one, and where surfaces are."""
    mesh = look.torus() if mesh is None else mesh
    look.clear(BEHIND)
    look.draw_base(mesh, CAMERA, shade)
    before, there = look.pixels().astype(int), look.depths() < 1.0
    backend.render(EdgeMesh(**options).draws(Layer(((mesh, CAMERA),))))
    return before, look.pixels().astype(int), there


@pytest.mark.parametrize("tone", TONES)
@pytest.mark.parametrize("strokes", ["chained", "half"])
def test_a_tone_changes_surfaces_and_leaves_the_app_its_background(backend, tone, strokes):
    before, after, there = drawn(backend, tone=tone, strokes=strokes, **BARE)
    changed = (before != after).any(axis=2)
    assert changed[there].mean() > 0.9
    assert not changed[~there].any()


@pytest.mark.parametrize("tone", ["app", *TONES])
def test_paper_is_where_no_surface_is(backend, tone):
    paper = parse_colour("#e0d0b0")
    before, after, there = drawn(backend, tone=tone, paper="#e0d0b0", **BARE)
    off = np.abs(after[~there] - 255 * np.array(paper)).max(axis=1)
    if tone == "wash":  # it runs over outlines, by a few pixels
        off = np.sort(off)[: int(0.9 * len(off))]
    assert off.max() < 25
    if tone == "app":
        assert (before == after)[there].all()


@pytest.mark.parametrize("tone", TONES)
@pytest.mark.parametrize("strokes", ["chained", "thin", "quads", "half"])
def test_lines_lie_over_tones(backend, tone, strokes):
    ink = "#ff00ff"
    inks = {f"{kind}_ink": ink for kind in ("contour", "ridge", "valley", "boundary")}
    mesh = look.cube()
    _, alone, _ = drawn(backend, mesh=mesh, strokes=strokes, **inks)
    _, after, _ = drawn(backend, mesh=mesh, strokes=strokes, tone=tone, paper="#ffffff", **inks)
    inked = (alone == (255, 0, 255)).all(axis=2)
    assert inked.sum() > 300
    assert (after[inked] == (255, 0, 255)).all()


@pytest.mark.parametrize("tone", ["hatch", "grain"])
def test_what_is_darker_holds_more_ink(backend, tone):
    found = []
    for level in (0.9, 0.6, 0.3, 0.05):
        _, after, there = drawn(
            backend, shade=(level,) * 3, tone=tone, paper="#ffffff", **BARE
        )
        found.append(1.0 - after[there].mean() / 255)
    assert found == sorted(found)
    assert found[0] < 0.12
    assert found[-1] > 0.7


def test_bands_are_flat_and_a_wash_is_not(backend):
    _, cel, there = drawn(backend, tone="cel", **BARE)
    _, wash, _ = drawn(backend, tone="wash", **BARE)
    assert cel[there].std(axis=0).max() < 1.0
    assert wash[there].std(axis=0).min() > 5.0


@pytest.mark.parametrize("tone", TONES)
def test_a_still_picture_stands_still(backend, tone):
    first, second = (drawn(backend, tone=tone, paper="#ffffff")[1] for _ in range(2))
    assert (first == second).all()


@pytest.mark.parametrize("tone", TONES)
def test_greater_depths_may_win(backend, tone):
    """Where the app's far plane is at depth 0, surfaces are found all the same."""
    far_first = Camera(CAMERA.modelview, CAMERA.projection, CAMERA.viewport, depth_range=(1.0, 0.0))
    _, usual, _ = drawn(backend, tone=tone, paper="#ffffff", **BARE)
    GL.glClearDepth(0.0)
    GL.glDepthFunc(GL.GL_GREATER)
    try:
        look.clear(BEHIND)
        look.draw_base(look.torus(), far_first, SHADE)
        style = EdgeMesh(tone=tone, paper="#ffffff", **BARE)
        backend.render(style.draws(Layer(((look.torus(), far_first),))))
        turned = look.pixels().astype(int)
    finally:
        GL.glClearDepth(1.0)
        GL.glDepthFunc(GL.GL_LESS)
    assert (usual != turned).any(axis=2).mean() < 0.001


def test_layers_over_others_have_no_paper_and_are_toned_once():
    item = (look.torus(), Camera(look.look_at((3, 2, 2.5)), look.perspective(), (0, 0, 64, 64)))
    asked = ("wash", (1.0, 0.9, 0.8), (0.0, 0.0, 0.0))
    first, later, shared = (
        [one for one in tone_passes(*asked, Layer((item,), over=over, fresh=fresh))
         if one.element == "screen"]
        for over, fresh in ((False, True), (True, True), (True, False))
    )
    assert [one.uniforms["behind"] for one in first] == [1]
    assert [one.uniforms["behind"] for one in later] == [0]
    assert shared == []


def test_an_inset_leaves_the_picture_below_alone(tmp_path):
    """A program that clears depth for a small view in a corner: what shows behind that is the main
    view, and no sheet of paper."""
    program = tmp_path / "inset.py"
    program.write_text(INSET)
    style = {"GLSHIM_STYLE": "watercolour", "GLSHIM_FRAMES": "2",
             "GLSHIM_CAPTURE": str(tmp_path / "out%d.png")}  # fmt: skip
    subprocess.run([sys.executable, str(program)], env=os.environ | style, check=True, timeout=60)
    pixels = np.asarray(Image.open(tmp_path / "out2.png").convert("RGB")).astype(int)
    behind, main = pixels[-58:-52, -58:-4].mean(axis=(0, 1)), pixels[8:14, 8:68].mean(axis=(0, 1))
    # Red in both, as the program has it; a wash is uneven.
    assert min(behind[0] - behind[2], main[0] - main[2]) > 100


INSET = '''
import pygame
from OpenGL.GL import *
pygame.display.init()
pygame.display.set_mode((300, 200), pygame.OPENGL | pygame.DOUBLEBUF)
def square(size):
    glBegin(GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glVertex3f(size * x, size * y, 0)
    glEnd()
for _ in range(3):
    glViewport(0, 0, 300, 200)
    glClearColor(0.3, 0.4, 0.8, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glColor3f(0.8, 0.3, 0.2)
    square(2.0)
    glViewport(240, 0, 60, 60)
    glClear(GL_DEPTH_BUFFER_BIT)
    square(0.4)
    pygame.display.flip()
'''
