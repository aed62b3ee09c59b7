"""Several windows, whose contexts share or not, end in the middle, or are a second thread's; and
exceptions, signals and errors that wait."""

from __future__ import annotations

from tests.fuzz.areas.immediate import RECTANGLES, between, mode, primitive
from tests.fuzz.areas.state import CLEARS, QUESTIONS, SETTINGS
from tests.fuzz.writing import Writer, area


@area(1.5)
def windows(w: Writer) -> None:
    """Another window, drawn in, presented, perhaps destroyed."""
    mine = w.pick(w.names["window"])
    name = w.make("window", f"window({mine if w.maybe(0.5) else ''})")
    for _ in range(w.whole(1, 2)):
        primitive(w)
        w.say(w.row(CLEARS, QUESTIONS, tuple("GL." + row for row in SETTINGS)))
    if w.maybe(0.6):
        w.say("swap()")
    if w.maybe(0.4):
        w.say(f"destroy({name})")
    w.say(f"use({mine})")


@area(1)
def turns(w: Writer) -> None:
    """Another context is made current, sometimes in the middle of something."""
    name = w.pick(w.names["window"])
    if w.maybe(0.2):
        w.compiles = True
        w.say(f"GL.glNewList({w.whole(1, 4)}, GL.GL_COMPILE)")
    w.say(w.pick((f"use({name})", f"use({name})", "use(None)")))
    if w.maybe(0.5):
        primitive(w)
    if w.maybe(0.3):
        w.say("swap()")
    w.say("use(a)")


@area(1)
def threads(w: Writer) -> None:
    """A second thread with a context of its own."""
    name = w.make("window", f"window({'a' if w.maybe(0.5) else ''})")
    w.say("use(a)", f"other(lambda: use({name}))")
    for _ in range(w.whole(1, 4)):
        before = len(w.steps)
        primitive(w) if w.maybe(0.5) else w.say(w.row(CLEARS, QUESTIONS, RECTANGLES))
        w.steps[before:] = [f"other(lambda: {step})" for step in w.steps[before:]]
        if w.maybe(0.3):
            primitive(w)
    if w.maybe(0.6):
        w.say("other(lambda: swap())")
    if w.maybe(0.9):
        w.say("other(lambda: use(None))")


_WAITING = (
    "GL.glEnable.__class__",
    "bare.glEnable(0xFFFF)",
    "bare.glLineWidth(-1.0)",
    "bare.glEnd()",
    "bare.glPopMatrix()",
    "bare.glBindFramebuffer(0x8D41, 777)",
    "[bare.glPushMatrix() for _ in range(40)]",
    "bare.glColor3ub({0..255}, 9, 9)",
    "bare.glFrontFace(0x900)",
    "bare.glMatrixMode(0x1701)",
    "bare.glDisable(GL.GL_DEPTH_TEST)",
    "bare.glTranslatef(0.25, 0.0, 0.0)",
)


@area(2)
def errors(w: Writer) -> None:
    """Errors that nobody has fetched yet, made past PyOpenGL."""
    w.say(w.row(_WAITING))
    if w.maybe(0.5):
        w.say(w.pick(("swap(False)", "swap()")))
    w.say(
        w.pick(
            (
                "GL.glGetError()",
                "GL.glFlush()",
                "GL.glRectf(0, 0, 1, 1)",
                f"GL.glBegin({mode(w)})",
                "GL.glGetError()",
                "GL.glClear(0x100)",
            )
        )
    )


_INTERRUPTED = (
    "strike()",
    "1 / 0",
    "[GL.glVertex3f(Striking(0.5), 0, 0)]",
    "GL.glColor3fv([Striking(0.5), 0, 0])",
    "GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, [Striking(1.0), 0, 0, 0])",
    "GL.glDrawArrays(Striking(4), 0, 3)",
    "GL.glCallList(Striking(1))",
    "GL.glRectf(Striking(0.0), 0, 1, 1)",
    "GL.glTranslatef(Striking(0.0, Refusal), 0, 0)",
    "GL.glBegin(Striking(4))",
    "GL.glClear(Striking(0x100))",
    "GL.glNewList(Striking(2), GL.GL_COMPILE)",
    "GL.glVertex3f(Striking(0.5, KeyboardInterrupt), 0, 0)",
    "GL.glDrawElements(GL.GL_TRIANGLES, 3, GL.GL_UNSIGNED_INT, [Striking(0), 1, 2])",
    "GL.glCallLists([Striking(1), 2])",
    "(GL.glBegin(GL.GL_TRIANGLES), GL.glVertex3f(0, 0, 0), 1 / 0)",
    "(GL.glNewList(3, GL.GL_COMPILE), GL.glRectf(0, 0, 1, 1), strike())",
    "GL.glMultMatrixf([Striking(1.0)] * 16)",
    "GL.glGenTextures(Striking(1))",
    "GL.glDepthMask(Striking(1))",
)


@area(2)
def interrupted(w: Writer) -> None:
    """Signals and exceptions of the program's own, anywhere."""
    opened = w.maybe(0.4)
    if opened:
        w.say(
            f"GL.glBegin({mode(w)})",
            *(f"GL.glVertex3f({w.reals(3)})" for _ in range(w.whole(0, 4))),
        )
    w.say(w.pick(_INTERRUPTED))
    if w.maybe(0.3):
        w.say(between(w))
    if opened:
        w.say(*(f"GL.glVertex3f({w.reals(3)})" for _ in range(w.whole(0, 4))), "GL.glEnd()")
