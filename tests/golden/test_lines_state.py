"""Rendering leaves no trace in GL, whatever state the app is in, and the app's state does not
spoil the lines."""

from __future__ import annotations

import ctypes

import numpy as np
import pytest
from glshim_stylers.raskar import Raskar
from OpenGL import GL

from glshim.driver.functions import gl
from glshim.errors import RenderError
from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.outputs.gl.device.devices import LegacyDevice, attach
from glshim.outputs.gl.lines.pen import Pen
from glshim.styling.protocol import Layer
from tests import look

STYLE = Raskar(silhouette_width=4, ridge_width=4)
CAMERA = Camera(look.look_at((3, 2, 2)), look.perspective(), (0, 0, 400, 400))
_SKIPPED = ("_TOKEN", "NUM_EXTENSIONS", "PERFMON", "NVX", "MEMORY_INFO", "TIMESTAMP")


def _queries():
    """Every constant that glGetDoublev answers in this context, found once by asking."""
    values = {}
    out = (ctypes.c_double * 64)()
    for name in dir(GL):
        token = getattr(GL, name)
        if not name.startswith("GL_") or not isinstance(token, int) or not 0 < token < 0x10000:
            continue
        if any(part in name for part in _SKIPPED):
            continue
        gl.glGetDoublev(int(token), ctypes.addressof(out))
        if gl.glGetError() == 0:
            values[int(token)] = name
    return values


def _state(queries):
    out = (ctypes.c_double * 64)()
    found = {}
    for token, name in queries.items():
        ctypes.memset(out, 0, ctypes.sizeof(out))
        gl.glGetDoublev(token, ctypes.addressof(out))
        found[name] = tuple(out)
    while gl.glGetError():
        pass
    return found


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


def _ordinary():
    GL.glEnable(GL.GL_DEPTH_TEST)


def _hostile():
    """States that some app leaves behind at the end of a layer, each of which drops or changes
    ink when it is not undone."""
    GL.glEnable(GL.GL_CULL_FACE)
    GL.glCullFace(GL.GL_FRONT_AND_BACK)
    GL.glPolygonMode(GL.GL_FRONT_AND_BACK, GL.GL_LINE)
    GL.glEnable(GL.GL_STENCIL_TEST)
    GL.glStencilFunc(GL.GL_NEVER, 1, 0xFF)
    GL.glStencilOp(GL.GL_INCR, GL.GL_INCR, GL.GL_INCR)
    GL.glColorMask(False, True, False, True)
    GL.glEnable(GL.GL_COLOR_LOGIC_OP)
    GL.glLogicOp(GL.GL_INVERT)
    GL.glEnable(GL.GL_ALPHA_TEST)
    GL.glAlphaFunc(GL.GL_NEVER, 0.5)
    GL.glEnable(GL.GL_FOG)
    GL.glFogfv(GL.GL_FOG_COLOR, (1, 1, 1, 1))
    GL.glEnable(GL.GL_BLEND)
    GL.glBlendFunc(GL.GL_ZERO, GL.GL_ONE)
    GL.glEnable(GL.GL_POLYGON_STIPPLE)
    GL.glPolygonStipple(np.zeros(128, np.uint8))
    GL.glEnable(GL.GL_POLYGON_OFFSET_FILL)
    GL.glPolygonOffset(100, 100)
    GL.glEnable(GL.GL_SCISSOR_TEST)
    GL.glScissor(0, 0, 3, 3)
    GL.glEnable(GL.GL_CLIP_PLANE0)
    GL.glClipPlane(GL.GL_CLIP_PLANE0, (0, 0, 0, -1))
    GL.glEnable(GL.GL_RASTERIZER_DISCARD)
    GL.glEnable(GL.GL_DEPTH_CLAMP)
    GL.glViewport(3, 4, 5, 6)
    GL.glDepthRange(0.2, 0.3)
    GL.glDepthMask(False)
    GL.glMatrixMode(GL.GL_TEXTURE)
    GL.glActiveTexture(GL.GL_TEXTURE3)
    GL.glClientActiveTexture(GL.GL_TEXTURE2)
    GL.glBindTexture(GL.GL_TEXTURE_2D, GL.glGenTextures(1))
    GL.glBindBuffer(GL.GL_ARRAY_BUFFER, GL.glGenBuffers(1))
    GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, GL.glGenBuffers(1))
    GL.glBindBuffer(GL.GL_UNIFORM_BUFFER, GL.glGenBuffers(1))
    GL.glVertexAttribPointer(0, 2, GL.GL_FLOAT, False, 0, ctypes.c_void_p(4))
    GL.glEnableVertexAttribArray(1)
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
    GL.glColor4f(0.1, 0.2, 0.3, 0.4)
    GL.glPushMatrix()
    GL.glPushAttrib(GL.GL_CURRENT_BIT)


@pytest.mark.parametrize("app", [_ordinary, _hostile])
def test_no_state_changes_and_all_ink_arrives(backend, app):
    mesh = look.torus()
    draws = list(STYLE.draws(Layer(((mesh, CAMERA),))))
    _, wanted, _ = look.styled(backend, STYLE, (mesh, CAMERA))
    look.clear()
    look.draw_base(mesh, CAMERA)
    queries = _queries()
    assert len(queries) > 300
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


def test_attaching_changes_no_state(backend):
    queries = _queries()
    GL.glDisable(GL.GL_TEXTURE_CUBE_MAP_SEAMLESS)  # moderngl enables it in a new context
    before = _state(queries)
    Backend.attach()
    after = _state(queries)
    assert {n: (before[n], after[n]) for n in before if before[n] != after[n]} == {}


def test_a_full_attribute_stack_gets_the_device_that_needs_none(backend):
    depth = int(GL.glGetIntegerv(GL.GL_MAX_ATTRIB_STACK_DEPTH))
    for _ in range(depth):
        GL.glPushAttrib(GL.GL_CURRENT_BIT)
    device = attach()
    for _ in range(depth):
        GL.glPopAttrib()
    assert not device.modern
    assert attach().modern == isinstance(backend.pen, Pen)
    assert gl.glGetError() == 0


@pytest.mark.parametrize("make", [attach, LegacyDevice])
def test_a_shader_that_does_not_compile_is_one_error_with_the_drivers_words(backend, make):
    device = make()
    queries = _queries()
    before = _state(queries)
    with pytest.raises(RenderError, match=r"^shader 'mine' does not compile: .*nonsense"):
        device.program("mine", "#version 120\nvoid main() { gl_Position = nonsense; }")
    assert _state(queries) == before


@pytest.mark.parametrize("error", [0, GL.GL_INVALID_ENUM, GL.GL_INVALID_VALUE, 0x0502])
def test_the_apps_error_waits_for_the_app(backend, error):
    provoke = {
        0: lambda: None,
        GL.GL_INVALID_ENUM: lambda: gl.glEnable(0xFFFF),
        GL.GL_INVALID_VALUE: lambda: gl.glViewport(0, 0, -1, -1),
        0x0502: lambda: gl.glUseProgram(0xFFFF00),
    }[error]
    look.clear()
    provoke()
    expected = error if error != 0x0502 else None
    backend.render(STYLE.draws(Layer(((look.cube(), CAMERA),))))
    found = gl.glGetError()
    assert found == expected or (expected is None and found in (0x0501, 0x0502))
    assert gl.glGetError() == 0


def test_the_depth_buffer_keeps_its_content(backend):
    mesh = look.torus()
    look.clear()
    look.draw_base(mesh, CAMERA)
    depth = look.depths()
    backend.render(STYLE.draws(Layer(((mesh, CAMERA),))))
    assert (look.depths() == depth).all()


def test_scissor_stencil_depth_range_and_clip_planes_are_the_cameras(backend):
    mesh = look.cube()
    plain = look.styled(backend, STYLE, (mesh, CAMERA))[1]
    cut = Camera(CAMERA.modelview, CAMERA.projection, CAMERA.viewport, scissor=(0, 0, 400, 150))
    look.clear()
    look.draw_base(mesh, CAMERA)
    bare = look.pixels()
    backend.render(STYLE.draws(Layer(((mesh, cut),))))
    found = look.pixels()
    assert (found[:150] == plain[:150]).all()
    assert (found[150:] == bare[150:]).all()
    assert (found != bare).any()

    never = Camera(CAMERA.modelview, CAMERA.projection, CAMERA.viewport,
                   stencil=(GL.GL_NEVER, 0, 255))  # fmt: skip
    look.clear()
    backend.render(STYLE.draws(Layer(((mesh, never),))))
    assert (look.pixels() == 255).all()

    near = Camera(CAMERA.modelview, CAMERA.projection, CAMERA.viewport, depth_range=(0.1, 0.4))
    assert (look.styled(backend, STYLE, (mesh, near))[1] == plain).mean() > 0.999

    axis = CAMERA.modelview[:3, :3] @ (0.0, 0.0, 1.0)
    plane = (*axis, float(-axis @ CAMERA.modelview[:3, 3]))
    half = Camera(CAMERA.modelview, CAMERA.projection, CAMERA.viewport, clip_planes=(plane,))
    look.clear()
    backend.render(STYLE.draws(Layer(((mesh, half),))))
    upper = (look.pixels() != 255).any(axis=2)
    look.clear()
    backend.render(STYLE.draws(Layer(((mesh, CAMERA),))))
    every = (look.pixels() != 255).any(axis=2)
    assert 0.2 < upper.sum() / every.sum() < 0.8
    lowest = [np.nonzero(ink.any(axis=1))[0][0] for ink in (every, upper)]
    assert lowest[1] > lowest[0] + 30


def test_reversed_depth_and_no_depth(backend):
    mesh = look.torus()
    plain = look.styled(backend, STYLE, (mesh, CAMERA))[1]
    GL.glClearDepth(0.0)
    GL.glDepthFunc(GL.GL_GREATER)
    back = Camera(CAMERA.modelview, CAMERA.projection, CAMERA.viewport, depth_range=(1.0, 0.0))
    turned = look.styled(backend, STYLE, (mesh, back))[1]
    GL.glClearDepth(1.0)
    GL.glDepthFunc(GL.GL_LESS)
    assert (turned == plain).mean() > 0.999


def test_nothing_is_drawn_while_a_list_is_compiled_or_the_stack_is_full(backend):
    look.clear()
    draws = list(STYLE.draws(Layer(((look.cube(), CAMERA),))))
    name = GL.glGenLists(1)
    GL.glNewList(name, GL.GL_COMPILE)
    backend.render(draws)
    GL.glEndList()
    depth = GL.glGetIntegerv(GL.GL_MAX_ATTRIB_STACK_DEPTH)
    for _ in range(depth):
        GL.glPushAttrib(GL.GL_CURRENT_BIT)
    backend.render(draws)
    for _ in range(depth):
        GL.glPopAttrib()
    assert (look.pixels() == 255).all()
    assert gl.glGetError() == 0


def test_no_context_is_a_render_error(monkeypatch):
    monkeypatch.setattr("glshim.driver.functions.gl.glGetString", lambda name: None, raising=False)
    with pytest.raises(RenderError, match="no GL context"):
        Backend.attach()
