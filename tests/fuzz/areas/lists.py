"""Display lists: nested, executed as they are compiled, with halves of primitives inside."""

from __future__ import annotations

from tests.fuzz.areas.immediate import RECTANGLES, attribute, body, mode, primitive
from tests.fuzz.areas.state import CLEARS, QUESTIONS, SETTINGS, TRANSFORMATIONS
from tests.fuzz.writing import Writer, area

_CALLS = (
    "GL.glCallList({list})",
    "GL.glCallList({list})",
    "GL.glCallList({1..4})",
    "GL.glCallLists([{list}, {list}])",
    "GL.glCallLists([1, 2, 3])",
    "GL.glCallLists('abc')",
    "GL.glCallLists(np.array([1, 2, {1..9}], np.{dtype}))",
    "GL.glCallLists(b'\\x01\\x02')",
    "GL.glCallLists(3, GL.GL_UNSIGNED_BYTE, np.array([1, 2, 3], np.uint8))",
    "GL.glDeleteLists({list}, {-1..2})",
    "GL.glIsList({list})",
    "GL.glListBase({0..2})",
    "GL.glIsList({1..5})",
    "GL.glGenLists({0..3})",
    "GL.glGetIntegerv({LIST_INDEX|LIST_MODE|LIST_BASE})",
)
_STATE = (
    "GL.glPushMatrix()",
    "GL.glPopMatrix()",
    "GL.glPushAttrib({@AttribMask})",
    "GL.glPopAttrib()",
    "GL.glMatrixMode({MODELVIEW|PROJECTION})",
    "GL.glEnable({LIGHTING|CULL_FACE|BLEND|FOG})",
    "GL.glDisable({LIGHTING|DEPTH_TEST|TEXTURE_2D})",
    "GL.glFrontFace({CW|CCW})",
    "GL.glBindTexture(GL.GL_TEXTURE_2D, {texture})",
    "GL.glUseProgram({program})",
    "GL.glEnd()",
)


def call(w: Writer) -> str:
    """One call of lists."""
    return w.row(_CALLS).replace(
        "{dtype}", w.pick(("uint8", "int16", "uint32", "float32", "int64"))
    )


@area(6)
def compiled(w: Writer) -> None:
    """A list, and calls of it."""
    if w.maybe(0.4):
        w.make("list", "GL.glGenLists(1)")
    elif w.maybe(0.6):
        w.names.setdefault("list", []).append(str(w.whole(1, 4)))
    name = w.name("list", 0.02)
    w.say(f"GL.glNewList({name}, {w.enums('COMPILE', 'COMPILE', 'COMPILE_AND_EXECUTE')})")
    opened, w.compiles = False, True
    for _ in range(w.whole(0, 5)):
        opened = _inner(w, opened)
    if not w.maybe(0.03):
        w.compiles = False
        w.say("GL.glEndList()")
    for _ in range(w.whole(0, 2)):
        w.say(w.fill(f"GL.glCallList({name})"))


def _inner(w: Writer, opened: bool) -> bool:
    """opened: a primitive may be open. Mesa 22.3 crashes on a call of a list there."""
    kind = w.weighted(
        {"primitive": 4, "state": 3, "many": 1, "call": 2, "attribute": 2, "half": 0.7, "rare": 1}
    )
    if kind == "primitive":
        primitive(w)
    elif kind == "state":
        w.say(w.row(_STATE, tuple("GL." + row for row in SETTINGS), TRANSFORMATIONS))
    elif kind == "many":
        w.say(
            f"GL.glBegin({mode(w)})",
            f"[GL.glVertex3fv(p) for p in floats({w.whole(1, 3)})[:{w.pick((12, 150))}]]",
            "GL.glEnd()",
        )
    elif kind == "call" and not opened:
        w.say(call(w))
    elif kind == "attribute":
        w.say(attribute(w))
    elif kind == "half":
        w.say(f"GL.glBegin({mode(w)})") if w.maybe(0.5) else body(w)
    else:
        w.say(w.row(CLEARS, QUESTIONS, RECTANGLES))
    return opened or kind == "half"


@area(4)
def calls(w: Writer) -> None:
    """Lists called, deleted, asked for."""
    for _ in range(0 if w.compiles else w.whole(1, 3)):
        w.say(call(w))
    if w.maybe(0.15) and not w.compiles:
        w.say(f"GL.glBegin({mode(w)})", call(w), "GL.glEnd()")
