"""Shapes and helpers of GLU, whose C code draws unseen, and callbacks that raise."""

from __future__ import annotations

from tests.fuzz.writing import Writer, area

_QUADRICS = (
    "gluSphere({quadric}, {r 0.2 0.5 1}, {2..9}, {2..6})",
    "gluCylinder({quadric}, 0.4, {r 0 0.2 0.4}, 0.7, {2..9}, {1..3})",
    "gluDisk({quadric}, {r 0 0.2}, 0.6, {2..9}, {1..2})",
    "gluPartialDisk({quadric}, 0.1, 0.6, 7, 2, {r 0 90}, {r 90 200})",
    "gluSphere({quadric}, 0.5, 8, 6)",
    "gluSphere({quadric}, {r -1 0}, 0, {-1..3})",
    "gluQuadricDrawStyle({quadric}, GLU.GLU_{style})",
    "gluQuadricNormals({quadric}, GLU.GLU_{normals})",
    "gluQuadricTexture({quadric}, {flag})",
    "gluQuadricOrientation({quadric}, GLU.GLU_{side})",
    "gluSphere({quadric}, 'x', 4, 4)",
    "gluSphere({quadric}, 0.5, ctypes.c_int(6), np.int32(4))",
)
_HELPERS = (
    "gluProject({3r})",
    "gluUnProject(3, 4, {u})",
    "gluErrorString({1280..1286})",
    "gluGetString(GLU.GLU_VERSION)",
    "gluBuild2DMipmaps(GL.GL_TEXTURE_2D, GL.GL_RGB, 8, 8, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, octets(1))",  # noqa: E501
    "gluScaleImage(GL.GL_RGB, 2, 2, GL.GL_UNSIGNED_BYTE, octets(1), 4, 4, GL.GL_UNSIGNED_BYTE)",
    "gluCheckExtension(b'GLU_EXT_nurbs_tessellator', b'GLU_EXT_nurbs_tessellator')",
)
_POLYGONS = (
    "[(-0.8, -0.8, 0), (0.8, -0.8, 0), (0.8, 0.8, 0), (0, -0.2, 0), (-0.8, 0.8, 0)]",
    "[(-0.5, -0.5, 0), (0.5, 0.5, 0), (0.5, -0.5, 0), (-0.5, 0.5, 0)]",
    "[(-1, -1, 0), (1, -1, 0), (0, 1, 0.25)]",
)


@area(3)
def shapes(w: Writer) -> None:
    """Quadrics and helpers."""
    if "quadric" not in w.names or w.maybe(0.2):
        w.make("quadric", "GLU.gluNewQuadric()")
    for _ in range(w.whole(1, 3)):
        row = w.pick(_QUADRICS if w.maybe(0.8) else _HELPERS).replace(
            "{quadric}", w.pick(w.names["quadric"])
        )
        row = row.replace("{style}", w.pick(("FILL", "LINE", "POINT", "SILHOUETTE")))
        row = row.replace("{normals}", w.pick(("SMOOTH", "FLAT", "NONE"))).replace(
            "{side}", w.pick(("INSIDE", "OUTSIDE"))
        )
        w.say("GLU." + w.fill(row))


@area(1)
def tessellation(w: Writer) -> None:
    """A polygon of any shape, whose callbacks are the program's and may raise."""
    name = w.make("tessellator", "GLU.gluNewTess()")
    vertex = w.pick(
        (
            "GL.glVertex3fv",
            "GL.glVertex3dv",
            "GL.glVertex3fv",
            "lambda v: 1 / 0",
            "lambda v: GL.glVertex3fv(v)",
            "lambda v: strike()",
        )
    )
    w.say(
        f"GLU.gluTessCallback({name}, GLU.GLU_TESS_BEGIN, GL.glBegin)",
        f"GLU.gluTessCallback({name}, GLU.GLU_TESS_END, GL.glEnd)",
        f"GLU.gluTessCallback({name}, GLU.GLU_TESS_VERTEX, {vertex})",
        f"GLU.gluTessCallback({name}, GLU.GLU_TESS_COMBINE, lambda c, v, w: c)",
    )
    if w.maybe(0.3):
        w.say(f"GLU.gluTessCallback({name}, GLU.GLU_TESS_EDGE_FLAG, GL.glEdgeFlag)")
    w.say(
        f"GLU.gluTessBeginPolygon({name}, None)",
        f"GLU.gluTessBeginContour({name})",
        f"[GLU.gluTessVertex({name}, p, p) for p in {w.pick(_POLYGONS)}]",
        f"GLU.gluTessEndContour({name})",
        f"GLU.gluTessEndPolygon({name})",
    )


@area(0.7)
def nurbs(w: Writer) -> None:
    """A curved surface."""
    name = w.make("nurbs", "GLU.gluNewNurbsRenderer()")
    w.say(
        f"GLU.gluNurbsProperty({name}, GLU.GLU_SAMPLING_TOLERANCE, {w.real(25.0, 60.0)})",
        f"GLU.gluNurbsProperty({name}, GLU.GLU_DISPLAY_MODE, GLU.{w.pick(('GLU_FILL', 'GLU_OUTLINE_POLYGON'))})",  # noqa: E501
        f"GLU.gluBeginSurface({name})",
        f"GLU.gluNurbsSurface({name}, [0, 0, 0, 1, 1, 1], [0, 0, 0, 1, 1, 1], floats({w.whole(1, 3)})[:9].reshape(3, 3, 3), GL.GL_MAP2_VERTEX_3)",  # noqa: E501
        f"GLU.gluEndSurface({name})",
    )
