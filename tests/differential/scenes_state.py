"""Scenes of state: lighting, textures, fog, clip planes, arrays of the app's own, full stacks."""

from __future__ import annotations

import ctypes
from collections.abc import Callable

import numpy as np
from OpenGL import GL, GLU

from glshim.driver.functions import gl

from .registry import each, scene
from .scenes_immediate import MODES, shade, spiral
from .world import App, restart_at


def mesh(count: int, colours: bool = True) -> None:
    """A strip with everything set at each vertex."""
    GL.glBegin(GL.GL_TRIANGLE_STRIP)
    for i, (x, y, z) in enumerate(spiral(count)):
        if colours:
            GL.glColor4f(*shade(i), 0.6)
        GL.glNormal3f(x, -y, 0.4)
        GL.glTexCoord2f(x, y)
        GL.glVertex3f(x, y, z)
    GL.glEnd()


def _light() -> None:
    GL.glEnable(GL.GL_LIGHTING)
    GL.glEnable(GL.GL_LIGHT0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (1, 2, 3, 0))
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_SPECULAR, (1, 1, 1, 1))
    GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, 20)


def _two_sides() -> None:
    _light()
    GL.glLightModeli(GL.GL_LIGHT_MODEL_TWO_SIDE, 1)
    GL.glMaterialfv(GL.GL_BACK, GL.GL_DIFFUSE, (1, 0, 0, 1))


def _colour_material() -> None:
    _light()
    GL.glColorMaterial(GL.GL_FRONT, GL.GL_AMBIENT_AND_DIFFUSE)
    GL.glEnable(GL.GL_COLOR_MATERIAL)


def _texture() -> None:
    image = (np.arange(8 * 8 * 3) * 7 % 256).astype(np.uint8)
    GL.glBindTexture(GL.GL_TEXTURE_2D, GL.glGenTextures(1))
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST)
    GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, 3, 8, 8, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, image)
    GL.glEnable(GL.GL_TEXTURE_2D)


def _texgen() -> None:
    _texture()
    for coordinate, switch in ((GL.GL_S, GL.GL_TEXTURE_GEN_S), (GL.GL_T, GL.GL_TEXTURE_GEN_T)):
        GL.glTexGeni(coordinate, GL.GL_TEXTURE_GEN_MODE, GL.GL_SPHERE_MAP)
        GL.glEnable(switch)


def _fog() -> None:
    GL.glEnable(GL.GL_FOG)
    GL.glFogi(GL.GL_FOG_MODE, GL.GL_LINEAR)
    GL.glFogf(GL.GL_FOG_START, 4.5)
    GL.glFogf(GL.GL_FOG_END, 5.5)


def _clip() -> None:
    GL.glClipPlane(GL.GL_CLIP_PLANE0, (1, 0.5, 0, 0.1))
    GL.glEnable(GL.GL_CLIP_PLANE0)


def _stipple() -> None:
    GL.glEnable(GL.GL_POLYGON_STIPPLE)
    GL.glPolygonStipple(np.tile(np.array([0xCC, 0x33], np.uint8), 64))
    GL.glEnable(GL.GL_LINE_STIPPLE)
    GL.glLineStipple(2, 0xF0A5)


def _blend() -> None:
    GL.glEnable(GL.GL_BLEND)
    GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
    GL.glEnable(GL.GL_ALPHA_TEST)
    GL.glAlphaFunc(GL.GL_GREATER, 0.3)


def _other_unit() -> None:
    _texture()
    GL.glTexCoord4f(0.5, 0.25, 0.0, 1.0)
    GL.glActiveTexture(GL.GL_TEXTURE1)
    GL.glMultiTexCoord4f(GL.GL_TEXTURE1, 3.0, 3.0, 3.0, 1.0)


def _unit_without_coordinates() -> None:
    GL.glActiveTexture(GL.GL_TEXTURE0 + 20)


def _culling() -> None:
    GL.glEnable(GL.GL_CULL_FACE)
    GL.glFrontFace(GL.GL_CW)
    GL.glPolygonMode(GL.GL_FRONT, GL.GL_LINE)


def _stencil() -> None:
    GL.glEnable(GL.GL_STENCIL_TEST)
    GL.glStencilFunc(GL.GL_ALWAYS, 3, 255)
    GL.glStencilOp(GL.GL_KEEP, GL.GL_KEEP, GL.GL_INCR)
    GL.glColorMask(True, False, True, True)
    GL.glScissor(20, 20, 50, 30)
    GL.glEnable(GL.GL_SCISSOR_TEST)


def _app_arrays() -> None:
    points = np.full((400, 4), 0.3, np.float32)
    _app_arrays.kept = points  # type: ignore[attr-defined]
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(4, GL.GL_FLOAT, 0, points)
    GL.glEnableClientState(GL.GL_COLOR_ARRAY)
    GL.glColorPointer(4, GL.GL_FLOAT, 16, points)
    GL.glEnableClientState(GL.GL_SECONDARY_COLOR_ARRAY)
    GL.glSecondaryColorPointer(3, GL.GL_FLOAT, 16, points)
    GL.glEnableClientState(GL.GL_FOG_COORD_ARRAY)
    GL.glFogCoordPointer(GL.GL_FLOAT, 16, points)
    GL.glEnableClientState(GL.GL_EDGE_FLAG_ARRAY)
    GL.glEdgeFlagPointer(16, points)
    for unit in (1, 3):
        GL.glClientActiveTexture(GL.GL_TEXTURE0 + unit)
        GL.glEnableClientState(GL.GL_TEXTURE_COORD_ARRAY)
        GL.glTexCoordPointer(2, GL.GL_FLOAT, 0, points)


def _generic_arrays() -> None:
    points = np.full((400, 4), 0.3, np.float32)
    _generic_arrays.kept = points  # type: ignore[attr-defined]
    for index in (0, 3, 8):
        GL.glEnableVertexAttribArray(index)
        GL.glVertexAttribPointer(index, 4, GL.GL_FLOAT, False, 0, points)


def _buffer() -> None:
    buffers = GL.glGenBuffers(2)
    data = np.full(4000, 0.3, np.float32)
    GL.glBindBuffer(GL.GL_ARRAY_BUFFER, buffers[0])
    GL.glBufferData(GL.GL_ARRAY_BUFFER, data, GL.GL_STATIC_DRAW)
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, ctypes.c_void_p(48))
    GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, buffers[1])
    GL.glBufferData(GL.GL_ELEMENT_ARRAY_BUFFER, data, GL.GL_STATIC_DRAW)


def _vertex_array_object() -> None:
    GL.glBindVertexArray(GL.glGenVertexArrays(1))
    _buffer()


def _program() -> None:
    def shader(kind: int, text: str) -> int:
        made = GL.glCreateShader(kind)
        GL.glShaderSource(made, text)
        GL.glCompileShader(made)
        return int(made)

    program = GL.glCreateProgram()
    GL.glAttachShader(
        program,
        shader(
            GL.GL_VERTEX_SHADER,
            """#version 130
        void main() { gl_Position = ftransform();
                      gl_FrontColor = vec4(float(gl_VertexID) / 300.0, 1, 0, 1); }""",
        ),
    )
    GL.glAttachShader(program, shader(GL.GL_FRAGMENT_SHADER, """#version 130
        void main() { gl_FragColor = gl_Color; }"""))  # fmt: skip
    GL.glLinkProgram(program)
    GL.glUseProgram(program)


def _client_stack_full() -> None:
    for _ in range(int(GL.glGetIntegerv(GL.GL_MAX_CLIENT_ATTRIB_STACK_DEPTH))):
        GL.glPushClientAttrib(GL.GL_CLIENT_VERTEX_ARRAY_BIT)


def _stack_full() -> None:
    for _ in range(int(GL.glGetIntegerv(GL.GL_MAX_ATTRIB_STACK_DEPTH))):
        GL.glPushAttrib(GL.GL_CURRENT_BIT)
    GL.glLineWidth(2.5)


def _matrix_stack_full() -> None:
    for mode in (GL.GL_PROJECTION, GL.GL_MODELVIEW):
        GL.glMatrixMode(mode)
        for _ in range(31):
            GL.glPushMatrix()
            GL.glScalef(0.99, 0.98, 0.97)


def _texture_matrix() -> None:
    _texture()
    GL.glMatrixMode(GL.GL_TEXTURE)
    GL.glScalef(2, 3, 1)
    GL.glPushMatrix()
    GL.glRotatef(30, 0, 0, 1)


def _smooth() -> None:
    for name in (GL.GL_LINE_SMOOTH, GL.GL_POINT_SMOOTH, GL.GL_POLYGON_SMOOTH, GL.GL_DITHER,
                 GL.GL_NORMALIZE, GL.GL_COLOR_SUM, GL.GL_MULTISAMPLE,
                 GL.GL_TEXTURE_CUBE_MAP_SEAMLESS, GL.GL_PROGRAM_POINT_SIZE,
                 GL.GL_DEPTH_CLAMP):  # fmt: skip
        GL.glEnable(name)
    restart_at(2)


SETTINGS: dict[str, Callable[[], None]] = {
    f.__name__.strip("_"): f
    for f in (_light, _two_sides, _colour_material, _texture, _texgen, _fog, _clip, _stipple,
              _blend, _other_unit, _unit_without_coordinates, _culling, _stencil, _app_arrays,
              _generic_arrays, _buffer, _vertex_array_object, _program, _client_stack_full,
              _stack_full, _matrix_stack_full, _texture_matrix, _smooth)
}  # fmt: skip


@each(SETTINGS)
def everything_under(app: App, setting: Callable[[], None]) -> None:
    """Small and large primitives, with attributes late or never, rectangles and shapes in C."""
    setting()
    for count in (12, 200):
        mesh(count)
        GL.glTranslatef(0.05, 0.05, 0.1)
        mesh(count, colours=False)
        for mode in MODES.values():
            GL.glBegin(mode)
            for i, point in enumerate(spiral(count)):
                if i == count // 3:
                    GL.glTexCoord4f(0.2, 0.3, 0.1, 1.0)
                    GL.glNormal3f(0.0, 1.0, 0.0)
                if i == count // 2:
                    GL.glColor4f(0.9, 0.3, 0.1, 0.7)
                GL.glVertex3fv(point)
            app.tries(GL.glEnd)
        app.tries(GL.glRectf, -1.0, -0.7, -0.6, -0.4)
        app.tries(GL.glRecti, -1, 1, 0, 0)
        app.tries(GL.glRectsv, [0, -1], [1, 0])
    app.asks(GL.GL_CURRENT_COLOR, GL.GL_CURRENT_NORMAL)
    quadric = GLU.gluNewQuadric()
    app.tries(GLU.gluSphere, quadric, 0.4, 8, 6)
    app.tries(GL.glColor3f, 0.0, 1.0, 1.0)
    app.tries(GLU.gluCylinder, quadric, 0.4, 0.1, 0.5, 8, 2)


@scene
def material_and_array_element_inside(app: App) -> None:
    _light()
    points = app.keeps(np.array(spiral(40), np.float32))
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, points)
    GL.glBegin(GL.GL_TRIANGLE_STRIP)
    for i in range(40):
        GL.glNormal3f(0, 0.1 * i, 1)
        GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_DIFFUSE, (*shade(i), 1))
        if i % 2:
            GL.glArrayElement(i)
        else:
            GL.glVertex3fv(points[i])
    app.tries(GL.glEnd)
    app.error()


@scene
def evaluators(app: App) -> None:
    rows = [[[x - 1.5, y - 1.5, (x * y) % 3 / 3] for x in range(4)] for y in range(4)]
    grid = np.array(rows, np.float32)
    GL.glMap2f(GL.GL_MAP2_VERTEX_3, 0, 1, 0, 1, grid)
    GL.glEnable(GL.GL_MAP2_VERTEX_3)
    GL.glEnable(GL.GL_AUTO_NORMAL)
    GL.glMapGrid2f(6, 0, 1, 6, 0, 1)
    for kind in (GL.GL_FILL, GL.GL_LINE, GL.GL_POINT):
        app.tries(GL.glEvalMesh2, kind, 0, 6, 0, 6)
    GL.glBegin(GL.GL_QUAD_STRIP)
    for i in range(7):
        GL.glColor3f(*shade(i))
        GL.glEvalCoord2f(i / 6, 0.2)
        GL.glEvalCoord2fv([i / 6, 0.6])
        GL.glEvalPoint2(i, 2)
        GL.glEvalCoord2d(i / 6, 0.9)
    app.tries(GL.glEnd)
    app.error()


@each({"colours": (0.1, 0.2, 0.3, 0.4), "black": (0, 0, 0, 0)})
def picks_beside_what_is_drawn(app: App, background: tuple[float, ...]) -> None:
    GL.glClearColor(*background)
    for turn in range(2):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glColor3ub(10, 200, 30 + turn)
        GL.glRectf(-0.5, -0.5, 0.1, 0.1)
        mesh(12)
        for place in ((1, 1), (2, 9)):
            app.tries(GL.glReadPixels, *place, 1, 1, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
        app.tries(GL.glReadPixels, 0, 0, 8, 8, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE)
        app.tries(GL.glReadPixels, 0, 0, 4, 4, 77, GL.GL_UNSIGNED_BYTE)
    app.asks(GL.GL_COLOR_CLEAR_VALUE, GL.GL_SCISSOR_BOX, GL.GL_PACK_ALIGNMENT)


@each({"select": GL.GL_SELECT, "feedback": GL.GL_FEEDBACK})
def other_render_modes(app: App, mode: int) -> None:
    if mode == GL.GL_SELECT:
        GL.glSelectBuffer(512)
    else:
        GL.glFeedbackBuffer(60000, GL.GL_3D_COLOR)
    app.tries(GL.glRenderMode, mode)
    GL.glInitNames()
    GL.glPushName(7)
    for name, count in ((1, 12), (2, 200)):
        GL.glLoadName(name)
        mesh(count)
    GL.glRectf(-1, -1, 0, 0)
    GLU.gluSphere(GLU.gluNewQuadric(), 0.5, 6, 6)
    found = GL.glRenderMode(GL.GL_RENDER)
    app.saw.append(repr([
        [(hit.near, hit.far, list(hit.names)) for hit in found] if mode == GL.GL_SELECT
        else [(t[0], [(v.vertex, v.color) for v in t[1:]]) for t in found]
    ]).replace("array", ""))  # fmt: skip
    mesh(12)
    app.tries(GL.glRenderMode, GL.GL_RENDER)


@scene
def feedback_buffer_of_the_app_stays(app: App) -> None:
    buffer = app.keeps(np.zeros(100, np.float32))
    GL.glFeedbackBuffer(100, GL.GL_3D, buffer)
    GLU.gluSphere(GLU.gluNewQuadric(), 0.5, 6, 6)
    GL.glRectf(-1, -1, 0, 0)


@scene
def feedback_is_looked_at_inside_a_primitive(app: App) -> None:
    buffer = app.keeps(np.zeros(400, np.float32))
    gl.glFeedbackBuffer(400, GL.GL_3D_COLOR, buffer.ctypes.data)
    GL.glRenderMode(GL.GL_FEEDBACK)
    GL.glBegin(GL.GL_POINTS)
    for attribute in (GL.glColor3d, GL.glNormal3d, GL.glTexCoord3d):  # drivers flush what they hold
        GL.glVertex2i(0, 0)
        attribute(0.0, 0.5, 1.0)
        app.saw.append(buffer.tolist())
    GL.glEnd()
    gl.glRenderMode(GL.GL_RENDER)


@each({str(left): left for left in range(5)})
def little_room_for_glu_on_the_attribute_stack(app: App, left: int) -> None:
    depth = int(GL.glGetIntegerv(GL.GL_MAX_ATTRIB_STACK_DEPTH))
    for _ in range(depth - left):
        GL.glPushAttrib(GL.GL_ALL_ATTRIB_BITS)
    nurbs, knots = GLU.gluNewNurbsRenderer(), [0, 0, 0, 1, 1, 1]
    points = np.random.default_rng(3).uniform(-1, 1, (3, 3, 3)).astype(np.float32)
    for _ in range(2):
        app.tries(GLU.gluBeginSurface, nurbs)
        app.tries(GLU.gluNurbsSurface, nurbs, knots, knots, points, GL.GL_MAP2_VERTEX_3)
        app.tries(GLU.gluEndSurface, nurbs)
    for _ in range(10):
        gl.glGetError()
    app.saw.append(int(GL.glGetIntegerv(GL.GL_ATTRIB_STACK_DEPTH)))


@scene
def unknown_lists_in_a_primitive_with_evaluated_vertices(app: App) -> None:
    GL.glNormal3f(0, 1, 0)
    GL.glBegin(GL.GL_TRIANGLE_FAN)
    app.tries(GL.glEvalMesh1, GL.GL_POINT, 0, 4)  # an error, and nothing else
    GL.glCallLists([1000, 2])
    app.tries(GL.glEnd)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    app.saw.append(GL.glGetFloatv(GL.GL_CURRENT_NORMAL).tolist())


@scene
def readback_and_copies(app: App) -> None:
    mesh(20)
    app.tries(GL.glReadPixels, 0, 0, 2, 2, GL.GL_DEPTH_COMPONENT, GL.GL_FLOAT)
    GL.glRasterPos3f(-0.5, 0.2, 0.1)
    app.tries(GL.glCopyPixels, 10, 10, 20, 20, GL.GL_COLOR)
    app.tries(GL.glBitmap, 8, 8, 0, 0, 10, 0, bytes(range(8)))
    app.tries(GL.glDrawPixels, 2, 2, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, bytes(range(12)) + bytes(4))
    app.tries(GL.glFlush)
    app.tries(GL.glFinish)
    mesh(12)
    app.asks(GL.GL_CURRENT_RASTER_POSITION, GL.GL_CURRENT_COLOR)


@scene
def framebuffer_object(app: App) -> None:
    mesh(12)
    framebuffer, texture = GL.glGenFramebuffers(1), GL.glGenTextures(1)
    depth = GL.glGenRenderbuffers(1)
    GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGBA8, 64, 64, 0, GL.GL_RGBA, GL.GL_FLOAT, None)
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST)
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffer)
    app.tries(GL.glBegin, GL.GL_TRIANGLES)  # the framebuffer is not complete yet
    GL.glVertex3f(0, 0, 0)
    app.tries(GL.glEnd)
    GL.glFramebufferTexture2D(GL.GL_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D,
                              texture, 0)  # fmt: skip
    GL.glBindRenderbuffer(GL.GL_RENDERBUFFER, depth)
    GL.glRenderbufferStorage(GL.GL_RENDERBUFFER, GL.GL_DEPTH_COMPONENT24, 64, 64)
    GL.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, GL.GL_DEPTH_ATTACHMENT, GL.GL_RENDERBUFFER,
                                 depth)  # fmt: skip
    GL.glViewport(0, 0, 64, 64)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    mesh(200)
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, 0)
    GL.glEnable(GL.GL_TEXTURE_2D)
    mesh(30)
