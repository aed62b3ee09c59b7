"""Pixels drawn, copied and read; selection and feedback; evaluators; accumulation."""

from __future__ import annotations

from tests.fuzz.areas.immediate import RECTANGLES, primitive
from tests.fuzz.writing import Writer, area

_PIXELS = (
    "glRasterPos3f({2r}, 0.0)",
    "glRasterPos2i({-1..1}, 0)",
    "glWindowPos2i({0..40}, {0..30})",
    "glRasterPos4fv({v4f})",
    "glWindowPos3f(3, 4, {u})",
    "glDrawPixels(4, 4, {RGB|RGBA|LUMINANCE|DEPTH_COMPONENT|STENCIL_INDEX}, {UNSIGNED_BYTE|UNSIGNED_SHORT}, octets(1))",  # noqa: E501
    "glDrawPixels(2, 2, GL.GL_RGB, GL.GL_FLOAT, floats(1))",
    "glCopyPixels({0..20}, {0..20}, {0..20}, 10, {COLOR|DEPTH|STENCIL})",
    "glBitmap(8, 8, {r}, 0, 10, 0, octets(2))",
    "glBitmap({0..8}, 4, 0, 0, 5, 5, octets(3).tobytes())",
    "glPixelZoom({r 1 2 -1 0.5}, {r 1 2 -1})",
    "glPixelTransferf({RED_SCALE|GREEN_BIAS|DEPTH_SCALE|ALPHA_BIAS}, {r 0 0.5 1})",
    "glPixelTransferi({MAP_COLOR|INDEX_SHIFT}, {0..1})",
    "glPixelStorei({UNPACK_ALIGNMENT|PACK_ALIGNMENT}, {1..8})",
    "glPixelStorei({PACK_ROW_LENGTH|UNPACK_ROW_LENGTH|PACK_SKIP_ROWS|UNPACK_SKIP_PIXELS}, {0..3})",
    "glPixelStorei({PACK_SWAP_BYTES|UNPACK_LSB_FIRST}, {0..1})",
    "glPixelMapfv({PIXEL_MAP_R_TO_R|PIXEL_MAP_I_TO_R}, {v4fu})",
    "glReadPixels({0..50}, {0..40}, {1..8}, {1..8}, {RGB|RGBA|BGRA|RED|LUMINANCE}, {UNSIGNED_BYTE|FLOAT|UNSIGNED_SHORT})",  # noqa: E501
    "glReadPixels(0, 0, {1..64}, {1..48}, GL.GL_DEPTH_COMPONENT, GL.GL_FLOAT)",
    "glReadPixels({0..9}, 0, 4, 4, {STENCIL_INDEX|DEPTH_STENCIL|COLOR_INDEX}, {UNSIGNED_BYTE|UNSIGNED_INT_24_8})",  # noqa: E501
    "glReadPixelsub(0, 0, 8, 8, GL.GL_RGB)",
    "glReadPixelsf(0, 0, 3, 3, GL.GL_RGBA)",
    "glReadPixels(0, 0, 64, 48, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)",
    "glReadPixels(0, 0, {-1..3}, 2, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)",
    "glReadPixels(0, 0, 2, 2, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, room())",
    "glAccum({@AccumOp}, {u})",
    "glClear(GL.GL_ACCUM_BUFFER_BIT)",
    "glReadBuffer({FRONT|BACK})",
    "glGetPixelMapfv(GL.GL_PIXEL_MAP_R_TO_R)",
    "glGetFloatv(GL.GL_CURRENT_RASTER_POSITION)",
    "glPixelStoref(GL.GL_PACK_ALIGNMENT, 1.0)",
    "glGetPolygonStipple()",
    "glBindBuffer({PIXEL_PACK_BUFFER|PIXEL_UNPACK_BUFFER}, 0)",
)


@area(4)
def pixels(w: Writer) -> None:
    """Some of them."""
    w.say(*("GL." + w.row(_PIXELS) for _ in range(w.whole(1, 4))))


@area(2)
def render_mode(w: Writer) -> None:
    """Selection or feedback, and back."""
    if w.maybe(0.5):
        w.say(
            w.pick(
                ("GL.glSelectBuffer(512)", "GL.glSelectBuffer(64)", "GL.glSelectBuffer(room('I'))")
            ),
            "GL.glRenderMode(GL.GL_SELECT)",
            "GL.glInitNames()",
            f"GL.glPushName({w.whole(0, 9)})",
        )
        primitive(w)
        w.say(
            w.pick(("GL.glLoadName(4)", "GL.glPopName()", "GL.glPushName(3)", "GL.glInitNames()"))
        )
    else:
        w.say(
            f"GL.glFeedbackBuffer({w.pick((20, 100, 4000))}, GL.GL_{w.pick(('2D', '3D', '3D_COLOR', '4D_COLOR_TEXTURE'))})",  # noqa: E501
            "GL.glRenderMode(GL.GL_FEEDBACK)",
        )
        w.say(w.pick(("GL.glPassThrough(3.5)", "None")))
    for _ in range(w.whole(1, 2)):
        primitive(w)
    if w.maybe(0.3):
        w.say(w.row(RECTANGLES))
    if w.maybe(0.2):
        w.say("swap()")
    w.say("GL.glRenderMode(GL.GL_RENDER)")


_EVALUATORS = (
    "glMap1f({MAP1_VERTEX_3|MAP1_COLOR_4|MAP1_NORMAL}, 0, 1, [[-1, 0, 0, 1], [0, {r}, 0, 1], [1, 0, 0.5, 1]])",  # noqa: E501
    "glMap1d(GL.GL_MAP1_VERTEX_3, 0, 1, [[-1, -1, 0], [0, {r}, 0], [1, -1, 0]])",
    "glMap2f(GL.GL_MAP2_VERTEX_3, 0, 1, 0, 1, floats(2)[:16].reshape(4, 4, 3))",
    "glMap2f(GL.GL_MAP2_VERTEX_3, 0, 1, 0, 1, [[[-1, -1, 0], [1, -1, 0]], [[-1, 1, {r}], [1, 1, 0]]])",  # noqa: E501
    "glMap2d({MAP2_NORMAL|MAP2_VERTEX_3}, 0, 1, 0, 1, doubles(1)[:12].reshape(2, 2, 3))",
    "glEnable({MAP1_VERTEX_3|MAP2_VERTEX_3|MAP1_COLOR_4|MAP2_NORMAL|AUTO_NORMAL})",
    "glDisable(GL.GL_MAP2_VERTEX_3)",
    "glMapGrid1f({1..6}, 0, 1)",
    "glMapGrid2f({1..6}, 0, 1, 4, 0, 1)",
    "glMapGrid2d(3, 0, 1, {0..4}, 0, 1)",
    "glEvalMesh1({LINE|POINT|FILL}, 0, {0..6})",
    "glEvalMesh2({@MeshMode2}, 0, {0..6}, 0, {0..4})",
    "glEvalMesh2({FILL|LINE|POINT|TRIANGLES}, 0, 3, 0, 3)",
    "glGetMapfv(GL.GL_MAP2_VERTEX_3, {ORDER|DOMAIN|COEFF})",
    "glGetMapiv(GL.GL_MAP1_VERTEX_3, GL.GL_ORDER)",
    "glEvalCoord2f({2u})",
)


@area(2)
def evaluators(w: Writer) -> None:
    """Maps, grids and meshes."""
    w.say(*("GL." + w.row(_EVALUATORS) for _ in range(w.whole(2, 5))))
    if w.maybe(0.3):
        w.say(
            "GL.glBegin(GL.GL_TRIANGLE_STRIP)",
            *(w.fill("GL.glEvalCoord2f({2u})") for _ in range(5)),
            "GL.glEvalPoint2(1, 1)",
            "GL.glEnd()",
        )
