"""Primitives between glBegin and glEnd, legal and not."""

from __future__ import annotations

from tests.fuzz.writing import Writer, area

MODES = ("POINTS", "LINES", "LINE_LOOP", "LINE_STRIP", "TRIANGLES", "TRIANGLE_STRIP",
         "TRIANGLE_FAN", "QUADS", "QUAD_STRIP", "POLYGON")  # fmt: skip
_ODD_MODES = ("14", "77", "-1", "2**32 + 4", "Number.FOUR", "Valued.FOUR", "None", "'x'", "4.0",
              "GL.GL_PATCHES", "GL.GL_TRIANGLES_ADJACENCY", "ctypes.c_uint(4)", "True",
              "Holding(GL.GL_QUADS)", "np.int32(4)")  # fmt: skip
COUNTS = (0, 1, 2, 3, 3, 4, 4, 5, 6, 8, 12)
_VERTEX = (
    "glVertex2f({2r})", "glVertex2d({2r})", "glVertex2i({-1..1}, {-1..1})", "glVertex2fv({v2f})",
    "glVertex3f({2r}, {r -0.5 0.0 0.25 0.5})", "glVertex3f({3r})", "glVertex3f({3r})",
    "glVertex3d({3r})", "glVertex3fv({v3f})", "glVertex3fv({v3f})", "glVertex3dv({v3d})",
    "glVertex4f({3r}, 1.0)", "glVertex4f({4r})", "glVertex4dv({v4d})", "glVertex4fv({v4f})",
    "glVertex3i({-1..1}, {-1..1}, 0)", "glVertex3s(1, {-1..1}, 0)", "glVertex3iv({v3i})",
    "glVertex2sv({v2h})", "glVertex({v3f})", "glVertex({v2f})", "glVertex3fv(floats(1)[5])",
    "glVertexAttrib3f(0, {3r})", "glVertexAttrib4fv(0, {v4f})",
)  # fmt: skip
_COLOUR = (
    "glColor3f({3u})", "glColor3f({3u})", "glColor4f({4u})", "glColor3fv({v3fu})",
    "glColor4fv({v4fu})", "glColor3d({3u})", "glColor3dv({v3du})", "glColor4dv({v4du})",
    "glColor3ub({-3..300}, {0..255}, {0..255})", "glColor4ub({0..255}, 20, {0..255}, 128)",
    "glColor3ubv({v3B})", "glColor4ubv(octets(2)[9:13])", "glColor3b({-128..127}, 5, 100)",
    "glColor3us(60000, {0..70000}, 4)", "glColor4ui(2**31, 7, {0..99}, 2**32 - 1)",
    "glColor3i({-9..9}, 2**30, 0)", "glColor3s(3000, {-9..9}, 9)", "glColor3iv({v3i})",
    "glColor4usv({v4H})", "glColor({v3fu})",
    "glColorP3ui(GL.GL_UNSIGNED_INT_2_10_10_10_REV, {0..999999})",
)  # fmt: skip
_NORMAL = (
    "glNormal3f({3r})", "glNormal3f({3r})", "glNormal3d({3r})", "glNormal3fv({v3f})",
    "glNormal3dv({v3d})", "glNormal({v3f})", "glNormal3b({-128..127}, 5, 5)", "glNormal3s(1, 2, 3)",
    "glNormal3i({-2..2}, 0, 1)", "glNormal3bv({v3b})",
)  # fmt: skip
_TEXTURE = (
    "glTexCoord2f({2u})", "glTexCoord2f({2u})", "glTexCoord2fv({v2fu})", "glTexCoord1f({u})",
    "glTexCoord3f({3u})", "glTexCoord4f({3u}, 1.0)", "glTexCoord2d({2u})", "glTexCoord2dv({v2du})",
    "glTexCoord4fv({v4f})", "glTexCoord2i({0..2}, 1)", "glTexCoord2s(1, 0)", "glTexCoord1d({u})",
    "glMultiTexCoord2f(GL.GL_TEXTURE0 + {0..3}, {2u})",
    "glMultiTexCoord4fv(GL.GL_TEXTURE0 + {0..9}, {v4f})",
)  # fmt: skip
_RARE = (
    "glEdgeFlag({flag})", "glEdgeFlag({flag})", "glEdgeFlag(2)", "glEdgeFlag(np.bool_(True))",
    "glEdgeFlagv([True])", "glEdgeFlagv([0])", "glEdgeFlagv(np.array([1], np.uint8))",
    "glSecondaryColor3f({3u})", "glFogCoordf({u})", "glVertexAttrib4f({0..9}, {4r})",
    "glIndexf({r})", "glVertexAttribI4i(3, 1, 2, 3, {-4..4})",
    "glMaterialfv({@TriangleFace}, {DIFFUSE|AMBIENT|EMISSION}, {v4fu})",
    "glMaterialf(GL.GL_FRONT, GL.GL_SHININESS, {r 0.0 5.0 200.0})",
    "glVertexAttribP4ui(2, GL.GL_INT_2_10_10_10_REV, True, {0..99999})",
)  # fmt: skip
ATTRIBUTES = (_COLOUR, _COLOUR, _NORMAL, _TEXTURE, _RARE)
ILLEGAL = (
    "GL.glTranslatef(1, 0, 0)", "GL.glEnable(GL.GL_LIGHTING)", "GL.glEnable(0xFFFF)",
    "GL.glClear(GL.GL_COLOR_BUFFER_BIT)", "GL.glGetFloatv(GL.GL_CURRENT_COLOR)",
    "GL.glGetError()", "GL.glGetError()", "GL.glGetIntegerv(GL.GL_VIEWPORT)", "GL.glPopAttrib()",
    "GL.glIsEnabled(GL.GL_LIGHTING)", "GL.glBegin(GL.GL_QUADS)", "GL.glFlush()", "GL.glFinish()",
    "GL.glNewList(5, GL.GL_COMPILE)", "GL.glEndList()", "GL.glGenLists(1)",
    "GL.glDeleteLists(1, 1)", "GL.glPushAttrib(GL.GL_CURRENT_BIT)", "GL.glRectf(-1, -1, 1, 1)",
    "GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3)", "GL.glBindTexture(GL.GL_TEXTURE_2D, 0)",
    "GL.glMatrixMode(GL.GL_PROJECTION)", "GL.glGenTextures(1)", "GL.glUseProgram(0)",
    "GL.glReadPixels(0, 0, 3, 3, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)", "GL.glIsList(1)",
    "GL.glPolygonMode(GL.GL_FRONT, GL.GL_LINE)", "GL.glGetString(GL.GL_VERSION)",
    "GL.glRenderMode(GL.GL_FEEDBACK)", "GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)",
    "GL.glVertexPointer(3, GL.GL_FLOAT, 0, floats())",
    "GL.glEnableClientState(GL.GL_VERTEX_ARRAY)", "GL.glGetDoublev(GL.GL_MODELVIEW_MATRIX)",
    "GL.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1)",
)  # fmt: skip
_BETWEEN = (
    "strike()", "1 / 0", "GL.glCallList({list})", "GL.glArrayElement({0..30})",
    "GL.glEvalCoord1f({u})", "GL.glEvalCoord2f({2u})", "GL.glEvalPoint2(1, 1)",
    "GL.glVertex3f('x', 0, 0)", "GL.glVertex3fv([1.0, 2.0])", "GL.glVertex3f(Striking(1.0), 0, 0)",
    "GL.glVertex3fv([Striking(1.0), 0, 0])", "GL.glVertex3f(1, 2)", "GL.glColor3f()",
    "GL.glVertex3f(x=1, y=0, z=0)", "GL.glVertex3fv(v=[0.5, 0.5, 0])",
    "GL.glVertex3f(Striking(1.0, Refusal), 0, 0)", "GL.glColor3fv([Striking(1.0, Refusal), 0, 0])",
)  # fmt: skip


def mode(w: Writer) -> str:
    """A mode of primitives; polygons more often."""
    if w.maybe(0.04):
        return w.pick(_ODD_MODES)
    return w.enum("GL_" + w.pick(MODES if w.maybe(0.4) else MODES[4:]))


def vertex(w: Writer) -> str:
    """One of the many ways to say a vertex."""
    return "GL." + w.row(_VERTEX)


def attribute(w: Writer) -> str:
    """One of the many ways to say a colour, a normal, texture coordinates and the others."""
    return "GL." + w.row(*ATTRIBUTES)


def between(w: Writer) -> str:
    """What may or may not stand between glBegin and glEnd, beside vertices and attributes."""
    step = w.row(ILLEGAL, _BETWEEN)
    return "1 / 0" if "CallList" in step and w.compiles else step  # Mesa 22.3 crashes on it


@area(10)
def primitive(w: Writer) -> None:
    """A small one, step by step."""
    w.say(f"GL.glBegin({mode(w)})")
    body(w)
    if w.compiles or not w.maybe(0.02):
        w.say("GL.glEnd()")


def body(w: Writer) -> None:
    """Vertices, attributes before some of them, and now and then something else."""
    each = [attribute(w) for _ in range(w.whole(0, 2))]
    strange = w.maybe(0.2)
    for _ in range(w.pick(COUNTS)):
        if w.maybe(0.7):
            w.say(*each)
        elif w.maybe(0.3):
            w.say(attribute(w))
        if strange and w.maybe(0.25):
            w.say(between(w))
        w.say(vertex(w))
    if w.maybe(0.15):
        w.say(attribute(w))


_EACH = (
    "GL.glVertex3f(*p)", "GL.glVertex3fv(p)", "GL.glVertex3d(*p)", "GL.glVertex2f(*p[:2])",
    "(GL.glColor3f(*abs(p)), GL.glVertex3f(*p))", "(GL.glColor3fv(abs(p)), GL.glVertex3fv(p))",
    "(GL.glNormal3f(*p), GL.glVertex3fv(p))", "(GL.glTexCoord2f(*p[:2]), GL.glVertex3fv(p))",
    "(GL.glColor3f(*abs(p)), GL.glNormal3f(*p), GL.glTexCoord2f(*p[1:]), GL.glVertex3f(*p))",
    "(GL.glEdgeFlag(p[0] > 0), GL.glVertex3f(*p))", "(GL.glVertex3f(*p), GL.glColor4f(*p, 1))",
    "(GL.glEdgeFlag(bool(p[0] > 0)), GL.glVertex3f(*p))",
    "GL.glVertex3f(float(p[0]), float(p[1]), 0.25)", "GL.glVertex3fv(p.tolist())",
    "(GL.glColor3ub(*(p * 100).astype(int).tolist()), GL.glVertex3fv(p.tolist()))",
    "GL.glArrayElement(abs(int(p[0] * 20)))", "(GL.glFogCoordf(p[0]), GL.glVertex3fv(p))",
    "(GL.glMaterialfv(GL.GL_FRONT, GL.GL_DIFFUSE, (*p, 1)), GL.glVertex3fv(p))",
    "(GL.glColor3f(*p) if p[0] > 0 else GL.glColor4f(*p, 0.5), GL.glVertex3fv(p))",
)  # fmt: skip


@area(5)
def many(w: Writer) -> None:
    """A larger one, in one step: from some hundred records on they go another way."""
    count = w.pick((3, 12, 40, 100, 127, 128, 129, 130, 200, 300, 683))
    w.say(f"GL.glBegin({mode(w)})")
    if w.maybe(0.3):
        w.say(attribute(w))
    w.say(f"[{w.pick(_EACH)} for p in floats({w.whole(1, 3)})[:{count}]]")
    if w.maybe(0.1):
        w.say(between(w), f"[{w.pick(_EACH)} for p in floats(1)[:{w.pick((3, 150))}]]")
    if w.maybe(0.2):
        w.say(attribute(w))
    w.say("GL.glEnd()")


@area(3)
def current(w: Writer) -> None:
    """Attributes outside a primitive, and what is current then."""
    for _ in range(w.whole(1, 3)):
        w.say(attribute(w))
    if w.maybe(0.5):
        w.say(w.fill("GL.glGetFloatv({CURRENT_COLOR|CURRENT_NORMAL|CURRENT_TEXTURE_COORDS"
                     "|CURRENT_SECONDARY_COLOR|CURRENT_FOG_COORD|EDGE_FLAG})"))  # fmt: skip


RECTANGLES = (
    "GL.glRectf({4r})", "GL.glRectd({4r})", "GL.glRecti({-1..1}, -1, 1, {-1..1})",
    "GL.glRects(0, {-1..1}, 1, 1)", "GL.glRectfv({v2f}, {v2f})", "GL.glRectdv({v2d}, {v2d})",
    "GL.glRectiv({v2i}, {v2i})", "GL.glRectsv({v2h}, {v2h})",
)  # fmt: skip


@area(2)
def rectangle(w: Writer) -> None:
    """glRect in its forms."""
    w.say(w.row(RECTANGLES))
