"""Errors that wait, queries that are open, messages that are heard: as plain under every style."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import partial

import glfw
import pytest
from OpenGL import GL
from OpenGL.GL.ARB.pipeline_statistics_query import GL_VERTICES_SUBMITTED_ARB

from glshim.driver import errorflag
from glshim.driver.functions import gl
from glshim.driver.unnoticed import Unnoticed
from glshim.styling import registry
from glshim.toolkits import frames

from .test_contexts import VISIBLE, cube, inked
from .world import App, prepare, run, styled, window


def _too_large() -> None:
    name = ctypes.c_uint()
    gl.glGenBuffers(1, ctypes.byref(name))
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, name)
    gl.glBufferData(GL.GL_ARRAY_BUFFER, 1 << 61, None, GL.GL_STATIC_DRAW)
    gl.glDeleteBuffers(1, ctypes.byref(name))


def _incomplete() -> None:
    name = ctypes.c_uint()
    gl.glGenFramebuffers(1, ctypes.byref(name))
    gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, name)
    gl.glClear(GL.GL_COLOR_BUFFER_BIT)
    gl.glDeleteFramebuffers(1, ctypes.byref(name))


CORE = {"CONTEXT_VERSION_MAJOR": 4, "CONTEXT_VERSION_MINOR": 5,
        "OPENGL_PROFILE": glfw.OPENGL_CORE_PROFILE}  # fmt: skip
PROVOKED: dict[int, Callable[[], object]] = {
    GL.GL_INVALID_ENUM: lambda: gl.glEnable(0xFFFF),
    GL.GL_INVALID_VALUE: lambda: gl.glClear(1 << 30),
    GL.GL_INVALID_OPERATION: lambda: [gl.glEnd()],
    GL.GL_STACK_OVERFLOW: lambda: [
        gl.glPushDebugGroup(GL.GL_DEBUG_SOURCE_APPLICATION, 1, 1, b"x") for _ in range(99)
    ],
    GL.GL_STACK_UNDERFLOW: lambda: [gl.glPopDebugGroup() for _ in range(99)],
    GL.GL_OUT_OF_MEMORY: _too_large,
    GL.GL_INVALID_FRAMEBUFFER_OPERATION: _incomplete,
}
STATE = (GL.GL_DEBUG_LOGGED_MESSAGES, GL.GL_DEBUG_GROUP_STACK_DEPTH, GL.GL_DEBUG_OUTPUT,
         GL.GL_ARRAY_BUFFER_BINDING, GL.GL_DRAW_FRAMEBUFFER_BINDING)  # fmt: skip


def _state() -> list[int]:
    values = (ctypes.c_int * 1)()
    found = []
    for name in STATE:
        gl.glGetIntegerv(name, values)
        found.append(values[0])
    return found


@pytest.mark.parametrize("hints", [{}, CORE], ids=["compatibility", "core"])
def test_an_error_that_waits_goes_on_waiting(hints: dict[str, int]) -> None:
    with window(OPENGL_DEBUG_CONTEXT=1, **hints):
        for error, provoke in PROVOKED.items():
            errorflag.drain()
            provoke()
            before = _state()
            with Unnoticed():
                gl.glEnable(0)
                gl.glEnd()
            assert _state() == before
            assert (errorflag.taken(), error) == ([error], error)
            with Unnoticed():
                gl.glEnable(0)
            assert errorflag.taken() == []


# -- queries ---------------------------------------------------------------------------------------


def counted(target: int, draw: Callable[[], None]) -> int:
    """What a query of a target finds."""
    name, found = ctypes.c_uint(), ctypes.c_uint()
    gl.glGenQueries(1, ctypes.byref(name))
    GL.glBeginQuery(target, name.value)
    draw()
    GL.glEndQuery(target)
    gl.glGetQueryObjectuiv(name, GL.GL_QUERY_RESULT, ctypes.byref(found))
    return found.value


def hud() -> None:
    """Without depth test: the layer ends."""
    GL.glDisable(GL.GL_DEPTH_TEST)
    GL.glRectf(-1.5, -1.2, -1.4, -1.1)
    GL.glEnable(GL.GL_DEPTH_TEST)


def cube_and_hud() -> None:
    cube()
    hud()


@pytest.mark.parametrize("target", [GL.GL_SAMPLES_PASSED, GL.GL_PRIMITIVES_GENERATED,
                                    GL_VERTICES_SUBMITTED_ARB])  # fmt: skip
def test_a_layer_that_ends_under_a_query_is_drawn_after_it(target: int) -> None:
    def scene(app: App) -> None:
        app.saw.append(str(counted(int(target), cube_and_hud)))

    outcome = run(scene, VISIBLE)
    assert run(scene).differences(outcome, pictures=False) == {}
    assert inked(outcome) == inked(run(lambda app: cube_and_hud(), VISIBLE)) > 100


def test_lines_that_would_be_counted_are_left_out(capfd: pytest.CaptureFixture[str],
                                                  monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("glshim.notices._said", set())

    def scene(app: App) -> None:
        def frame() -> None:
            cube()
            GL.glClear(GL.GL_DEPTH_BUFFER_BIT)
            cube()
            glfw.swap_buffers(glfw.get_current_context())

        app.saw.append(str(counted(int(GL.GL_SAMPLES_PASSED), frame)))
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        cube()

    plain = run(scene)
    capfd.readouterr()
    outcome = run(scene, VISIBLE)
    assert plain.differences(outcome, pictures=False) == {}
    assert capfd.readouterr().err.count("while a query of the program's counts") == 1
    assert inked(outcome) > 100  # the frame after


def test_times_count_nothing_of_ours() -> None:
    def scene(app: App) -> None:
        counted(int(GL.GL_TIME_ELAPSED), cube_and_hud)

    assert inked(run(scene, VISIBLE)) > 100


def test_large_primitives_are_not_shared_out() -> None:
    """Which way a quad is cut depends on what else is drawn with it, and counts on how often."""

    def fence(mode: int) -> None:
        GL.glLoadIdentity()
        GL.glTranslatef(0.0, 0.0, -5.0)
        GL.glBegin(mode)
        for i in range(260):
            GL.glColor3f(0.8, i / 260, 0.3)
            GL.glVertex3f(5.6 * i / 260 - 2.3, i % 2 - 0.4, i / 260)
        GL.glEnd()

    def scene(app: App) -> None:
        GL.glLineStipple(1, 0xF0C1)
        for stippled in (GL.glDisable, GL.glEnable):
            stippled(GL.GL_LINE_STIPPLE)
            for mode in range(10):
                GL.glClear(GL.GL_COLOR_BUFFER_BIT)
                fence(mode)
                app.saw.append(str(GL.glReadPixels(0, 0, 96, 72, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)))
        for mode in range(10):
            app.saw.append(str(counted(GL_VERTICES_SUBMITTED_ARB, partial(fence, mode))))

    plain, outcome = run(scene), run(scene, "none")
    assert plain.differences(outcome) == {}


# -- conditional rendering, transform feedback -----------------------------------------------------


def counted_of(draw: Callable[[], None]) -> int:
    """A query of the samples of a draw."""
    name = ctypes.c_uint()
    gl.glGenQueries(1, ctypes.byref(name))
    GL.glBeginQuery(GL.GL_SAMPLES_PASSED, name.value)
    draw()
    GL.glEndQuery(GL.GL_SAMPLES_PASSED)
    return name.value


@pytest.mark.parametrize("swaps", [False, True])
def test_conditional_rendering_holds_for_the_program_alone(swaps: bool) -> None:
    def conditional(app: App) -> None:
        cube()
        GL.glBeginConditionalRender(counted_of(lambda: None), GL.GL_QUERY_WAIT)
        GL.glColor3f(1.0, 0.0, 0.0)
        GL.glRectf(-2.0, -2.0, 2.0, 2.0)  # is not drawn
        if swaps:
            GL.glReadPixels(0, 0, 96, 72, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
        hud()
        GL.glEndConditionalRender()
        app.error()

    def alone(app: App) -> None:
        cube()
        GL.glColor3f(1.0, 0.0, 0.0)

    outcome, expected = run(conditional, VISIBLE), run(alone, VISIBLE)
    assert run(conditional).differences(outcome, pictures=False) == {}
    assert inked(outcome) > 100
    assert (outcome.picture == expected.picture).all()


def test_a_list_may_end_it_and_begin_another_unseen() -> None:
    def scene(app: App) -> None:
        nothing, something = counted_of(lambda: None), counted_of(cube)
        GL.glNewList(1, GL.GL_COMPILE)
        GL.glEndConditionalRender()
        GL.glBeginConditionalRender(something, GL.GL_QUERY_WAIT)
        GL.glEndList()
        cube()
        GL.glBeginConditionalRender(nothing, GL.GL_QUERY_WAIT)
        GL.glCallList(1)
        cube()
        hud()
        GL.glDisable(GL.GL_DEPTH_TEST)
        GL.glRotatef(-90.0, 1.0, 1.0, 0.0)
        app.saw.append(str(counted(int(GL.GL_SAMPLES_PASSED), lambda: GL.glRectf(-1, -1, 1, 1))))
        assert app.saw[-1] != "0"  # by the second
        GL.glEndConditionalRender()
        app.error()

    outcome = run(scene, VISIBLE)
    assert run(scene).differences(outcome, pictures=False) == {}
    assert inked(outcome) > 100


# -- what is in use when a layer ends --------------------------------------------------------------

GREEN = "void main() { gl_FragColor = vec4(0.0, 1.0, 0.0, 1.0); }"
MOVED = "varying vec4 seen; void main() { seen = gl_Position = ftransform() + vec4(0.3); }"


def _program(*texts: tuple[int, str], varyings: bytes = b"") -> int:
    name = int(GL.glCreateProgram())
    GL.glProgramParameteri(name, GL.GL_PROGRAM_SEPARABLE, GL.GL_TRUE)
    for kind, text in texts:
        shader = GL.glCreateShader(kind)
        GL.glShaderSource(shader, "#version 120\n" + text)
        GL.glCompileShader(shader)
        GL.glAttachShader(name, shader)
    if varyings:
        names = (ctypes.c_char_p * 1)(varyings)
        pointers = ctypes.cast(names, ctypes.POINTER(ctypes.POINTER(ctypes.c_char)))
        GL.glTransformFeedbackVaryings(name, 1, pointers, GL.GL_INTERLEAVED_ATTRIBS)
    GL.glLinkProgram(name)
    assert GL.glGetProgramiv(name, GL.GL_LINK_STATUS)
    return name


def _pipeline(app: App) -> None:
    pipeline = GL.glGenProgramPipelines(1)
    GL.glUseProgramStages(pipeline, GL.GL_FRAGMENT_SHADER_BIT,
                          _program((GL.GL_FRAGMENT_SHADER, GREEN)))  # fmt: skip
    GL.glBindProgramPipeline(pipeline)


def _deleted(app: App) -> None:
    program = _program((GL.GL_FRAGMENT_SHADER, GREEN))
    GL.glUseProgram(program)
    GL.glDeleteProgram(program)


def _capture(app: App) -> None:
    GL.glUseProgram(_program((GL.GL_VERTEX_SHADER, MOVED), varyings=b"seen"))
    room = GL.glGenBuffers(1)
    GL.glBindBuffer(GL.GL_TRANSFORM_FEEDBACK_BUFFER, room)
    GL.glBufferData(GL.GL_TRANSFORM_FEEDBACK_BUFFER, 4096, bytes(4096), GL.GL_STATIC_DRAW)
    GL.glBindBufferBase(GL.GL_TRANSFORM_FEEDBACK_BUFFER, 0, room)
    GL.glBeginTransformFeedback(GL.GL_TRIANGLES)


@pytest.mark.parametrize("style", [VISIBLE, "two_pass:ink=#e8641b"])
@pytest.mark.parametrize("use", [_pipeline, _capture, _deleted])
def test_what_is_in_use_when_a_layer_ends_stays_so(use: Callable[[App], None], style: str) -> None:
    def scene(app: App) -> None:
        cube()
        use(app)
        GL.glReadPixels(0, 0, 96, 72, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
        GL.glBegin(GL.GL_TRIANGLES)
        for point in ((-2, -1, 0), (-1.5, -1, 0), (-1.8, 0, 0)):
            GL.glVertex3f(*point)
        GL.glEnd()
        if use is _capture:
            GL.glEndTransformFeedback()
            held = (ctypes.c_ubyte * 4096)()
            gl.glGetBufferSubData(GL.GL_TRANSFORM_FEEDBACK_BUFFER, 0, 4096, held)
            app.saw.append(str(bytes(held)))
            assert any(held)
        app.asks(GL.GL_CURRENT_PROGRAM)
        app.error()
        GL.glUseProgram(0)
        GL.glBindProgramPipeline(0)

    outcome = run(scene, style)
    assert run(scene).differences(outcome, pictures=False) == {}
    if use is not _deleted:
        assert inked(outcome) > 60


def test_a_swap_that_is_refused_inside_a_primitive() -> None:
    """Nothing was called, and GL finds no error."""
    app = App()
    with styled("raskar"), window():
        prepare()
        GL.glRectf(-0.5, -0.5, 0.5, 0.5)
        GL.glBegin(GL.GL_TRIANGLES)
        app.tries(frames.present, lambda: int("refused"))
        app.tries(GL.glEnd)
    assert app.saw[-1] == "None"


@pytest.mark.parametrize("style", [name for name in registry.names() if name != "none"])
def test_materials_that_follow_the_colour(style: str) -> None:
    def materials(style: str | None) -> list[object]:
        with styled(style), window() as handle:
            prepare()
            GL.glEnable(GL.GL_COLOR_MATERIAL)
            GL.glRectf(-0.5, -0.5, 0.25, 0.5)
            glfw.swap_buffers(handle)
            return [
                GL.glGetMaterialfv(face, name).tolist()
                for face in (GL.GL_FRONT, GL.GL_BACK)
                for name in (GL.GL_AMBIENT, GL.GL_DIFFUSE)
            ]

    assert materials(style) == materials(None)
