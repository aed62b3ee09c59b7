"""Style two_pass: lines where silhouettes are, by fixed-function calls alone, in any context."""

from __future__ import annotations

import dataclasses
from itertools import pairwise

import glfw
import numpy as np
import pytest
from glshim_stylers.two_pass import TwoPass
from OpenGL import GL

from glshim.driver.functions import gl
from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.outputs.gl.device.triangles import flagged_triangles
from glshim.outputs.gl.fixed import FixedPen
from glshim.styling.protocol import Layer
from tests import look, oracle
from tests.differential.test_contexts import cube
from tests.differential.world import run
from tests.golden.test_legacy import LEGACY, child
from tests.golden.test_lines_state import _hostile, _ordinary, _queries, _state

PORT = (0, 0, 400, 400)
CAMERA = Camera(look.look_at((3, 2, 2)), look.perspective(), PORT)
VIEWS = look.directions(6)
PURPLE = (0x60, 0x20, 0x80)

BARE = """
from glshim.driver.functions import gl
from glshim.outputs.gl import fixed
from tests.differential.test_contexts import cube
from tests.differential.world import run
from tests.golden.test_two_pass import inked
from glshim_stylers.two_pass import TwoPass

def missing(*args):
    raise AssertionError("no fixed-function call")

for name in ("glCreateShader", "glCreateProgram", "glCompileShader", "glLinkProgram",
             "glGenFramebuffers", "glGenRenderbuffers", "glGenBuffers", "glGenTextures",
             "glGenVertexArrays"):
    if FORBIDDEN:
        setattr(gl, name, missing)
plain = run(lambda app: cube())
for style in (TwoPass(ink="#602080"), TwoPass(ink="#602080", fill="#ffffff", smooth=False)):
    lines = run(lambda app: cube(), style)
    assert inked(lines.picture) > 60, inked(lines.picture)
    assert plain.differences(lines, pictures=False) == {}, plain.differences(lines)
"""
"""A program under the style, from its calls to its picture."""

OLDEST = """
from glshim.driver.functions import gl
from tests import look
from tests.golden.test_two_pass import CAMERA, ink_of
from glshim_stylers.two_pass import TwoPass

def missing(*args):
    raise AssertionError("1.1 has no such function")

for name in ("glUseProgram", "glActiveTexture", "glClientActiveTexture", "glBindBuffer",
             "glBindFramebuffer", "glBindRenderbuffer", "glBindVertexArray",
             "glDisableVertexAttribArray"):
    setattr(gl, name, missing)
with look.window():
    mesh = look.torus()
    for style in (TwoPass(), TwoPass(fill="#ff0000", smooth=False)):
        before, after = ink_of(style, (mesh, CAMERA))
        assert (before != after).sum() > 1000
        assert gl.glGetError() == 0
"""

CORE = """
import glfw
from OpenGL import GL
from glshim.errors import RenderError
from glshim.outputs.gl.fixed import FixedPen
from glshim_stylers.two_pass import TwoPass
from glshim.styling.protocol import Layer
from tests import look
from tests.differential.world import styled, window
from tests.golden.test_two_pass import CAMERA

hints = dict(CONTEXT_VERSION_MAJOR=3, CONTEXT_VERSION_MINOR=3,
             OPENGL_PROFILE=glfw.OPENGL_CORE_PROFILE)
with styled(TwoPass()), window(**hints):
    GL.glBindVertexArray(GL.glGenVertexArrays(1))
    for _ in range(3):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT)
        GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3)
        GL.glFlush()
    assert GL.glGetError() == 0
with window(**hints):
    try:
        FixedPen().render(TwoPass().draws(Layer(((look.cube(), CAMERA),))))
    except RenderError:
        assert GL.glGetError() == 0
    else:
        raise AssertionError("drawn in a core profile")
"""


def inked(picture):
    return int((picture[..., :3] == PURPLE).all(axis=2).sum())


def ink_of(style, *items, base=True):
    """The picture without and with the style."""
    look.clear()
    for item in items if base else ():
        look.draw_base(*item)
    before = look.pixels()
    FixedPen().render(style.draws(Layer(tuple(items))))
    return before, look.pixels()


@pytest.fixture(scope="module")
def own_window():
    with look.window():
        yield glfw.get_current_context()


@pytest.fixture(autouse=True)
def context(own_window):
    """Current again, after tests in windows of others."""
    glfw.make_context_current(own_window)


@pytest.mark.parametrize("smooth", [True, False])
@pytest.mark.parametrize("k", range(len(VIEWS)))
@pytest.mark.parametrize("name", ["torus", "sphere"])
def test_lines_lie_along_silhouettes_and_nowhere_else(name, k, smooth):
    mesh = look.MESHES[name](48, 24)
    lens = look.orthographic() if k % 2 else look.perspective()
    camera = Camera(look.look_at(5 * VIEWS[k]), lens, PORT)
    width = 6.0
    before, after = ink_of(TwoPass(width=width, smooth=smooth), (mesh, camera))
    depth = look.depths()
    ink = look.ink(before, after) > 0.5
    known = oracle.truth(look.polygons_of(mesh), mesh.positions, camera)
    points, _ = oracle.samples(known.outlines)
    seen = points[oracle.visible(points, depth, 1e-5, reach=1)]
    inside = ((seen[:, :2] > 2) & (seen[:, :2] < 398)).all(axis=1)
    seen = seen[inside]
    assert len(seen) > 500
    # What the style inks is a band outside each silhouette...
    rows, columns = np.nonzero(ink)
    inked_at = np.stack([columns + 0.5, rows + 0.5], axis=1)
    missed = ~oracle.near(inked_at, ink.shape, 1.6)[
        seen[:, 1].astype(int), seen[:, 0].astype(int)]  # fmt: skip
    assert missed.mean() < 0.02
    # ...half as wide as the line, and front faces have none: nothing is far from a silhouette.
    every, _ = oracle.samples(known.silhouettes)
    assert (ink & ~oracle.near(every, ink.shape, width / 2 + 1.0)).sum() == 0
    on_the_object = depth < 1.0
    solid = on_the_object & ~oracle.near(every, ink.shape, 1.5)
    # A contour before the object inks what lies behind it: only the torus has such.
    behind = (ink & solid).sum()
    assert behind == 0 if name == "sphere" else behind < 0.4 * ink.sum()
    share = ink.sum() / max((ink | oracle.near(seen, ink.shape, width / 2)).sum(), 1)
    assert 0.3 < share < 0.75  # half of a band of the whole width


@pytest.mark.parametrize("sizes", [(2.0, 6.0, 16.0)])
def test_wider_lines_are_wider_and_cover_narrower_ones(sizes):
    mesh = look.sphere()
    inks = [np.ptp(ink_of(TwoPass(width=w, smooth=False), (mesh, CAMERA)), axis=0).any(axis=2)
            for w in sizes]  # fmt: skip
    for (thin, thick), (a, b) in zip(pairwise(inks), pairwise(sizes), strict=True):
        assert 0.6 * b / a < thick.sum() / thin.sum() < 1.7 * b / a
        assert (thin & ~thick).sum() < 0.06 * thin.sum()


def test_front_faces_are_filled_before_lines_in_any_order_of_batches():
    near = Camera(look.look_at((3, 2, 2), (0, 0.7, 0)), look.perspective(), PORT)
    items = ((look.sphere(), CAMERA), (look.cube(0.7), near))
    style = TwoPass(fill="#00c000", ink="#602080", smooth=False)
    pictures = [ink_of(style, *order)[1] for order in (items, items[::-1])]
    assert (pictures[0] == pictures[1]).all()
    colours = np.unique(pictures[0].reshape(-1, 3), axis=0).tolist()
    assert colours == [[0, 192, 0], list(PURPLE), [255, 255, 255]]
    for _ in range(2):  # Mesa keeps the fill's colour for the lines unless it is told
        assert (ink_of(style, *items)[1] == pictures[0]).all()
    untouched = ink_of(dataclasses.replace(style, fill="app"), *items)
    assert (untouched[1] != untouched[0]).any()
    assert ((untouched[1] == (204, 204, 204)).all(axis=2)
            == (pictures[0] == (0, 192, 0)).all(axis=2)).mean() > 0.999  # fmt: skip
    assert (style.surface, TwoPass().surface, TwoPass(fill="none").surface) == (
        "none", "app", "none")  # fmt: skip


def test_diagonals_have_no_lines():
    """A square from behind, as a quad, as two triangles with edge flags, and without them."""
    corners = [(-1, -1, 0), (-1, 1, 0), (1, 1, 0), (1, -1, 0)]
    camera = Camera(look.look_at((0, 0, 5), up=(0, 1, 0)), look.perspective(), PORT)
    quad = look.batch(corners, [[0, 1, 2, 3]])
    halves = look.batch(corners, [[0, 1, 2], [0, 2, 3]])
    flagged = dataclasses.replace(halves, boundary=np.array([1, 1, 0, 0, 1, 1], bool))
    drawn = [look.ink(*ink_of(TwoPass(smooth=False), (b, camera), base=False)) > 0.5
             for b in (quad, flagged, halves)]  # fmt: skip
    assert drawn[0].sum() > 1000
    assert (drawn[0] == drawn[1]).all()
    assert drawn[2].sum() > 1.2 * drawn[0].sum()
    assert not drawn[0][150:250, 150:250].any()


def test_fans_of_polygons_that_are_not_quite_polygons():
    bad = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (np.nan, 0, 0), (1, 0, 0)]
    mesh = look.batch(bad, [[0, 1, 1, 2, 3], [0, 1, 4], [0, 5, 1], [0, 1, 2, 2], [3, 3, 3]])
    points, flags = flagged_triangles(mesh)
    assert points.shape == (3, 3, 3) and np.isfinite(points).all()
    assert flags.tolist() == [[1, 1, 0], [0, 1, 1], [1, 1, 1]]
    empty = PolygonBatch(np.zeros((0, 3), np.float32), np.zeros(0, np.int32),
                         np.zeros(1, np.int32), np.zeros(0, bool))  # fmt: skip
    assert ink_of(TwoPass(), (empty, CAMERA), base=False)[1].min() == 255


def test_fronts_are_what_is_out_however_a_surface_winds():
    """Inside out, under the other front face or not as GLUT's teapot, and mirrored: the same lines.
    Of a sheet, which has no outside, fronts are what the app says."""
    mesh = look.torus()
    plain = ink_of(TwoPass(), (mesh, CAMERA))[1]
    turned = [p[::-1] for p in look.polygons_of(mesh)]
    inside_out = look.batch(mesh.positions, turned)
    camera = dataclasses.replace(CAMERA, front_ccw=False)
    assert (ink_of(TwoPass(), (inside_out, camera))[1] == plain).mean() > 0.995
    mirror = np.diag((-1.0, 1.0, 1.0, 1.0))
    points = mesh.positions * np.float32((-1, 1, 1))
    mirrored = look.batch(points, look.polygons_of(mesh))
    camera = dataclasses.replace(CAMERA, modelview=CAMERA.modelview @ mirror)
    assert camera.mirrored != CAMERA.mirrored
    assert (ink_of(TwoPass(), (look.batch(points, turned), camera))[1] == plain).mean() > 0.995
    assert (ink_of(TwoPass(), (mirrored, camera))[1] == plain).mean() > 0.995
    assert (ink_of(TwoPass(), (inside_out, CAMERA))[1] == plain).mean() > 0.995
    sheet = look.batch([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [[0, 1, 2, 3]])
    cameras = [dataclasses.replace(CAMERA, front_ccw=ccw) for ccw in (True, False)]
    changed = [np.not_equal(*ink_of(TwoPass(), (sheet, camera))).sum() for camera in cameras]
    assert min(changed) == 0 < max(changed)


def test_a_depth_test_turned_round():
    mesh = look.torus()
    styles = (TwoPass(), TwoPass(fill="#ff0000"))
    plain = [ink_of(style, (mesh, CAMERA))[1] for style in styles]
    GL.glClearDepth(0.0)
    GL.glDepthFunc(GL.GL_GREATER)
    try:
        back = dataclasses.replace(CAMERA, depth_range=(1.0, 0.0))
        turned = [ink_of(style, (mesh, back))[1] for style in styles]
    finally:
        GL.glClearDepth(1.0)
        GL.glDepthFunc(GL.GL_LESS)
    for one, other in zip(plain, turned, strict=True):
        assert (one == other).mean() > 0.999


def test_scissor_stencil_and_clip_planes_are_the_cameras():
    mesh = look.torus()
    bare, plain = ink_of(TwoPass(), (mesh, CAMERA))
    cut = dataclasses.replace(CAMERA, scissor=(0, 0, 400, 150))
    found = ink_of(TwoPass(), (mesh, cut))[1]
    assert (found[:150] == plain[:150]).all() and (found[150:] == bare[150:]).all()
    never = dataclasses.replace(CAMERA, stencil=(GL.GL_NEVER, 0, 255))
    assert (ink_of(TwoPass(), (mesh, never))[1] == bare).all()
    axis = CAMERA.modelview[:3, :3] @ (0.0, 0.0, 1.0)
    half = dataclasses.replace(
        CAMERA, clip_planes=((*axis, float(-axis @ CAMERA.modelview[:3, 3])),)
    )
    share = [(ink_of(TwoPass(), (mesh, c), base=False)[1] != 255).sum() for c in (half, CAMERA)]
    assert 0.2 < share[0] / share[1] < 0.8
    small = dataclasses.replace(CAMERA, viewport=(50, 60, 200, 200))
    rows, columns = np.nonzero((ink_of(TwoPass(), (mesh, small), base=False)[1] != 255).any(axis=2))
    assert rows.min() >= 60 and rows.max() < 260 and columns.min() >= 50 and columns.max() < 250


@pytest.mark.parametrize("fill", ["app", "#ff8000"])
@pytest.mark.parametrize("app", [_ordinary, _hostile])
def test_no_state_changes_and_all_ink_arrives(app, fill):
    mesh, style = look.torus(), TwoPass(fill=fill)
    wanted = ink_of(style, (mesh, CAMERA))[1]
    look.clear()
    look.draw_base(mesh, CAMERA)
    queries = _queries()
    GL.glPushAttrib(GL.GL_ALL_ATTRIB_BITS)
    GL.glPushClientAttrib(GL.GL_CLIENT_ALL_ATTRIB_BITS)
    app()
    if app is _hostile:
        GL.glEdgeFlag(False)
        GL.glLineWidth(3.0)
        GL.glEnable(GL.GL_LINE_STIPPLE)
        GL.glEnable(GL.GL_LIGHTING)
        GL.glEnable(GL.GL_TEXTURE_2D)
        GL.glEnable(GL.GL_POLYGON_OFFSET_LINE)
    before = _state(queries)
    FixedPen().render(style.draws(Layer(((mesh, CAMERA),))))
    after = _state(queries)
    assert {n: (before[n], after[n]) for n in before if before[n] != after[n]} == {}
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


def test_depth_and_error_are_the_apps():
    mesh = look.torus()
    look.clear()
    look.draw_base(mesh, CAMERA)
    depth = look.depths()
    gl.glEnable(0xFFFF)
    FixedPen().render(TwoPass(fill="#ff0000").draws(Layer(((mesh, CAMERA),))))
    assert gl.glGetError() == GL.GL_INVALID_ENUM and gl.glGetError() == 0
    assert (look.depths() == depth).all()


def test_full_matrix_stacks_and_lists_that_are_compiled():
    GL.glMatrixMode(GL.GL_PROJECTION)
    most = GL.glGetIntegerv(GL.GL_MAX_PROJECTION_STACK_DEPTH)
    for _ in range(most - 1):
        GL.glPushMatrix()
    before, after = ink_of(TwoPass(), (look.cube(), CAMERA))
    GL.glMatrixMode(GL.GL_PROJECTION)
    for _ in range(most - 1):
        GL.glPopMatrix()
    assert (before != after).any() and gl.glGetError() == 0
    name = GL.glGenLists(1)
    GL.glNewList(name, GL.GL_COMPILE)
    FixedPen().render(TwoPass().draws(Layer(((look.cube(), CAMERA),))))
    GL.glEndList()
    look.clear()
    GL.glCallList(name)
    assert (look.pixels() == 255).all()


def test_an_app_is_restyled_and_sees_nothing_of_it():
    plain = run(lambda app: cube())
    for _ in range(2):
        lines = run(lambda app: cube(), TwoPass(ink="#602080"))
        assert plain.differences(lines, pictures=False) == {}
        assert inked(lines.picture) > 60 and inked(plain.picture) == 0


@pytest.mark.parametrize("variables", [{}, LEGACY], ids=["modern", "2.1"])
def test_no_shader_no_framebuffer_object_and_no_buffer_object(variables):
    # The mark by which glshim knows a context again is a name of one of these, in any style.
    text = "from glshim.sources.following import scene\nscene.Scene.mark = lambda self: None\n"
    done = child("-c", f"{text}FORBIDDEN = True\n{BARE}", **variables)
    assert done.returncode == 0, done.stderr
    assert "glshim:" not in done.stderr


def test_these_tests_hold_in_2_1():
    done = child("-m", "pytest", "-q", "-p", "no:cacheprovider", "tests/golden/test_two_pass.py",
                 "-k", "not hold_in and not core and not oldest", **LEGACY)  # fmt: skip
    assert done.returncode == 0, done.stdout[-4000:]


@pytest.mark.parametrize("version", ["1.1", "1.4"])
def test_the_oldest_contexts_have_all_that_is_called(version):
    names = OLDEST
    if version == "1.4":
        names = names.replace('"glActiveTexture", "glClientActiveTexture", ', "")
    extensions = "-GL_ARB_framebuffer_object -GL_ARB_vertex_array_object"
    done = child("-c", names, MESA_GL_VERSION_OVERRIDE=version, MESA_EXTENSION_OVERRIDE=extensions)
    assert done.returncode == 0, done.stderr


def test_a_core_profile_is_said_once_and_passes():
    done = child("-c", CORE)
    assert done.returncode == 0, done.stderr
    assert done.stderr.count("no fixed-function") == 1
    assert "Traceback" not in done.stderr


def test_a_width_past_the_drivers_is_said_once(capsys, monkeypatch):
    from glshim import notices
    from glshim.outputs.gl import fixed

    monkeypatch.setattr(notices, "_said", set())
    real = gl.glGetFloatv

    def narrow(name, at):
        real(name, at)
        if name in (0x846E, 0x0B22):
            (fixed.ctypes.c_float * 2).from_address(at)[:] = (1.0, 7.0)

    monkeypatch.setattr(gl, "glGetFloatv", narrow, raising=False)
    mesh = look.cube()
    wide = [ink_of(TwoPass(width=w), (mesh, CAMERA))[1] for w in (7.0, 40.0, 40.0)]
    assert (wide[0] == wide[1]).all()
    assert capsys.readouterr().err.count("lines of 1 to 7 pixels, not of 40") == 1


def test_a_window_without_depth_gets_no_lines(capsys, monkeypatch):
    from glshim import notices
    from glshim.outputs.gl import fixed

    monkeypatch.setattr(notices, "_said", set())
    real = fixed.integer
    monkeypatch.setattr(fixed, "integer", lambda n: 0 if n == 0x0D56 else real(n))
    before, after = ink_of(TwoPass(), (look.cube(), CAMERA))
    assert (before == after).all()
    assert "no depth buffer" in capsys.readouterr().err
