"""What stays open while other things are done: queries of every kind, conditional rendering, errors
that nobody has fetched, and modes in which nothing is drawn."""

from __future__ import annotations

from tests.fuzz.areas.immediate import many, primitive
from tests.fuzz.writing import Writer, area

TARGETS = (
    "SAMPLES_PASSED", "ANY_SAMPLES_PASSED", "ANY_SAMPLES_PASSED_CONSERVATIVE",
    "PRIMITIVES_GENERATED", "TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN", "TIME_ELAPSED",
    "VERTICES_SUBMITTED", "PRIMITIVES_SUBMITTED", "VERTEX_SHADER_INVOCATIONS",
    "GEOMETRY_SHADER_INVOCATIONS", "GEOMETRY_SHADER_PRIMITIVES_EMITTED",
    "FRAGMENT_SHADER_INVOCATIONS", "CLIPPING_INPUT_PRIMITIVES", "CLIPPING_OUTPUT_PRIMITIVES",
    "COMPUTE_SHADER_INVOCATIONS", "TESS_CONTROL_SHADER_PATCHES",
    "TESS_EVALUATION_SHADER_INVOCATIONS", "TRANSFORM_FEEDBACK_OVERFLOW",
    "TRANSFORM_FEEDBACK_STREAM_OVERFLOW",
)  # fmt: skip
_MODES = ("WAIT", "BY_REGION_WAIT", "WAIT_INVERTED", "BY_REGION_WAIT_INVERTED", "NO_WAIT")
_OPEN, _DONE, _CONDITION = "open query", "finished query", "open condition"
"""What `Writer.names` holds beside names."""


@area(5)
def query(w: Writer) -> None:
    """One begins, or one that began before ends: what lies between is anything."""
    waiting = w.names.setdefault(_OPEN, [])
    if waiting and w.maybe(0.6):
        end(w, waiting.pop(w.whole(0, len(waiting) - 1)))
        return
    target = w.pick(TARGETS)
    name = w.make("query", "int(GL.glGenQueries(2)[0])")
    if target == "PRIMITIVES_GENERATED" and w.maybe(0.4):
        index = w.whole(0, 3)
        w.say(f"GL.glBeginQueryIndexed(GL.GL_{target}, {index}, {name})")
        waiting.append(f"{target} {name} {index}")
    else:
        w.say(f"GL.glBeginQuery(GL.GL_{target}, {name})")
        waiting.append(f"{target} {name}")
    if w.maybe(0.5):
        (many if w.maybe(0.5) else primitive)(w)


def end(w: Writer, waiting: str) -> None:
    """What the query has counted, but for times."""
    target, name, *index = waiting.split()
    if index:
        w.say(f"GL.glEndQueryIndexed(GL.GL_{target}, {index[0]})")
    else:
        w.say(f"GL.glEndQuery(GL.GL_{target})")
    if target != "TIME_ELAPSED":
        w.say(f"GL.glGetQueryObjectuiv({name}, GL.GL_QUERY_RESULT)")
        w.names.setdefault(_DONE, []).append(name)


@area(2)
def condition(w: Writer) -> None:
    """What is drawn depends on a query from here to another place."""
    if w.names.get(_CONDITION):
        w.names[_CONDITION].pop()
        w.call("glEndConditionalRender")
    elif w.names.get(_DONE) or w.maybe(0.1):
        w.call("glFinish")
        w.say(f"GL.glBeginConditionalRender({w.name(_DONE)}, GL.GL_QUERY_{w.pick(_MODES)})")
        w.names.setdefault(_CONDITION, []).append("yes")


_BARE = "ctypes.CDLL('libGL.so.1')."


def bare(call: str) -> str:
    """A call past PyOpenGL, whose result is nothing: to ctypes it is an int of any value."""
    return f"({_BARE}{call}, None)[1]"


_ERRORS = (
    "glEnable(0xFFFF)", "glClear(1 << 30)", "glEnd()", "glMatrixMode(77)", "glListBase(1)",
    "glPopAttrib()", "glLineWidth(ctypes.c_float(-1))", "glBindBuffer(7, 0)",
)  # fmt: skip
_STACKS = tuple(
    f"len([{_BARE}{call} for _ in range({times})])" for call, times in (
        ("glPushMatrix()", 33), ("glPopMatrix()", 34), ("glPopMatrix()", 33),
        ("glPushAttrib(1)", 17), ("glPopAttrib()", 17), ("glPopClientAttrib()", 2),
        ("glPushClientAttrib(1)", 17),
    )
)  # fmt: skip


@area(4)
def error(w: Writer) -> None:
    """As C code makes it, so that PyOpenGL knows nothing of it."""
    chance = w.chance.random()
    if chance < 0.5:
        w.say(bare(w.pick(_ERRORS)))
    elif chance < 0.75:
        w.say(w.pick(_STACKS))
    elif chance < 0.9:
        name = w.make("framebuffer", "int(GL.glGenFramebuffers(1))")
        w.call("glBindFramebuffer", "GL.GL_FRAMEBUFFER", name)
        w.say(bare("glClear(0x4100)"))
        w.call("glBindFramebuffer", "GL.GL_FRAMEBUFFER", 0)
    else:
        name = w.make("buffer", "int(GL.glGenBuffers(1))")
        w.call("glBindBuffer", "GL.GL_ARRAY_BUFFER", name)
        w.say(bare("glBufferData(0x8892, ctypes.c_ssize_t(2**62), None, 0x88E4)"))
        w.call("glBindBuffer", "GL.GL_ARRAY_BUFFER", 0)
    if w.maybe(0.4):
        w.say("swap()")
    w.say(w.pick(("GL.glGetError()", f"{_BARE}glGetError()", f"{_BARE}glGetError()")))


@area(1)
def unrendered(w: Writer) -> None:
    """Feedback and selection: what is drawn is told."""
    kind, room = w.weighted({("FEEDBACK", "f"): 2, ("SELECT", "I"): 1}), w.fresh("r")
    w.say(f"{room} = room('{kind[1]}')")
    if kind[0] == "FEEDBACK":
        form = w.pick(("2D", "3D", "3D_COLOR", "3D_COLOR_TEXTURE"))
        w.say(bare(f"glFeedbackBuffer(2000, GL.GL_{form}, {room}.ctypes)"))
    else:
        w.say(bare(f"glSelectBuffer(2000, {room}.ctypes)"))
    w.say(f"{_BARE}glRenderMode(GL.GL_{kind[0]})", "GL.glInitNames()", "GL.glPushName(5)")
    for _ in range(w.whole(1, 3)):
        (many if w.maybe(0.5) else primitive)(w)
        if w.maybe(0.3):
            w.say("swap()")
    w.say(f"{_BARE}glRenderMode(GL.GL_RENDER)", f"{room}[:]")
