"""Vertex arrays of the client and of buffers, and every draw from them. Indices stay below 64, and
every pointer has 8 KiB behind it: plain reads nothing that is not there."""

from __future__ import annotations

from tests.fuzz.areas.immediate import mode
from tests.fuzz.writing import Writer, area

_POINTERS = (
    "glVertexPointer({2..4}, GL.GL_FLOAT, {stride}, {points})",
    "glVertexPointer(3, GL.GL_FLOAT, 0, {points})",
    "glVertexPointer(3, GL.GL_DOUBLE, 0, doubles(2))",
    "glVertexPointer(2, GL.GL_SHORT, 0, octets(3))",
    "glVertexPointerf(floats(2)[:{3..90}])",
    "glColorPointer({3..4}, GL.GL_FLOAT, {stride}, {points})",
    "glColorPointer(4, GL.GL_UNSIGNED_BYTE, {stride}, octets(4))",
    "glColorPointer(3, {UNSIGNED_SHORT|INT|BYTE}, 0, octets(5))",
    "glNormalPointer(GL.GL_FLOAT, {stride}, {points})",
    "glNormalPointer(GL.GL_BYTE, 0, octets(1))",
    "glTexCoordPointer({1..4}, GL.GL_FLOAT, {stride}, {points})",
    "glIndexPointer(GL.GL_FLOAT, 0, {points})",
    "glEdgeFlagPointer(0, octets(6))",
    "glFogCoordPointer(GL.GL_FLOAT, {stride}, {points})",
    "glSecondaryColorPointer(3, GL.GL_FLOAT, {stride}, {points})",
    "glVertexAttribPointer({0..5}, {1..4}, GL.GL_FLOAT, {flag}, {stride}, {points})",
    "glVertexAttribIPointer({1..5}, {1..4}, GL.GL_INT, {stride}, {points})",
    "glInterleavedArrays({@InterleavedArrayFormat}, {stride}, {points})",
    "glClientActiveTexture(GL.GL_TEXTURE0 + {0..2})",
    "glVertexAttribDivisor({1..5}, {0..2})",
)
_SWITCHES = (
    "glEnableClientState(GL.GL_VERTEX_ARRAY)",
    "glEnableClientState(GL.GL_VERTEX_ARRAY)",
    "glDisableClientState({@EnableCap})",
    "glDisableVertexAttribArray({0..5})",
    "glDisableClientState({VERTEX_ARRAY|COLOR_ARRAY|NORMAL_ARRAY|TEXTURE_COORD_ARRAY})",
)
_DRAWS = (
    "glDrawArrays({mode}, {0..20}, {0..60})",
    "glDrawArrays({mode}, {0..3}, {3..40})",
    "glDrawArrays({mode}, {-1..2}, {-1..5})",
    "glDrawElements({mode}, {0..40}, GL.GL_UNSIGNED_INT, indices({0..3}))",
    "glDrawElements({mode}, {0..40}, {UNSIGNED_BYTE|UNSIGNED_SHORT}, indices(1))",
    "glDrawElementsui({mode}, [0, 1, 2, {0..40}])",
    "glDrawElementsub({mode}, [3, 2, 1, {0..40}])",
    "glDrawElementsus({mode}, np.array([3, 2, 1, 0, 4, 5], np.uint16))",
    "glDrawElements({mode}, 3, GL.GL_UNSIGNED_INT, [0, 1, 2])",
    "glDrawElements({mode}, 3, GL.GL_FLOAT, indices())",
    "glDrawRangeElements({mode}, {0..9}, {5..60}, {0..30}, GL.GL_UNSIGNED_INT, indices(2))",
    "glDrawElementsBaseVertex({mode}, {0..20}, GL.GL_UNSIGNED_INT, indices(), {0..9})",
    "glDrawRangeElementsBaseVertex({mode}, 0, 50, {0..20}, GL.GL_UNSIGNED_INT, indices(), {0..5})",
    "glMultiDrawArrays({mode}, np.array([0, 3], 'i'), np.array([3, {0..20}], 'i'), 2)",
    "glMultiDrawElements({mode}, np.array([3, 4], 'i'), GL.GL_UNSIGNED_INT, (ctypes.c_void_p * 2)("
    "indices(1).ctypes.data, indices(2).ctypes.data), 2)",
    "glDrawArraysInstanced({mode}, {0..5}, {0..30}, {0..3})",
    "glDrawElementsInstanced({mode}, {0..30}, GL.GL_UNSIGNED_INT, indices(3), {0..3})",
    "glDrawArraysInstancedBaseInstance({mode}, 0, {0..20}, 2, {0..2})",
    "glDrawElementsInstancedBaseVertexBaseInstance({mode}, 6, GL.GL_UNSIGNED_INT, indices(), 2, 1, 1)",  # noqa: E501
    "glArrayElement({0..40})",
    "glDrawArrays(c_mode({mode}), 0, 3)",
    "glDrawArrays({mode}, 0, ctypes.c_int(3))",
    "glDrawElements({mode}, 3, GL.GL_UNSIGNED_INT, ctypes.byref((ctypes.c_uint * 3)(0, 1, 2)))",
)
_STRIDES = ("0", "0", "0", "12", "16", "24", "4")
_BUFFER_CALLS = (
    "glBindBuffer({ARRAY_BUFFER|ARRAY_BUFFER|ELEMENT_ARRAY_BUFFER|COPY_READ_BUFFER}, {buffer})",
    "glBindBuffer({ARRAY_BUFFER|ELEMENT_ARRAY_BUFFER}, 0)",
    "glIsBuffer({buffer})",
    "glIsBuffer({1..5})",
    "glBufferSubData(GL.GL_ARRAY_BUFFER, {0..64}, floats(3)[:4])",
    "glGetBufferSubData(GL.GL_ARRAY_BUFFER, {0..64}, 16)",
    "glGetBufferParameteriv(GL.GL_ARRAY_BUFFER, {BUFFER_SIZE|BUFFER_USAGE|BUFFER_MAPPED})",
    "glCopyBufferSubData(GL.GL_COPY_READ_BUFFER, GL.GL_ARRAY_BUFFER, 0, {0..64}, 16)",
    "glClearBufferData(GL.GL_ARRAY_BUFFER, GL.GL_R32F, GL.GL_RED, GL.GL_FLOAT, {v1f})",
    "glDeleteBuffers(1, [{buffer}])",
    "glInvalidateBufferData({buffer})",
    "glNamedBufferSubData({buffer}, 0, 16, floats(2))",
    "glGetNamedBufferParameteriv({buffer}, GL.GL_BUFFER_SIZE, room('i'))",
    "glBindBufferBase({UNIFORM_BUFFER|TRANSFORM_FEEDBACK_BUFFER}, {0..2}, {buffer})",
    "glBindVertexBuffer({0..3}, {buffer}, {0..16}, {0..16})",
    "glVertexAttribFormat({1..5}, {1..4}, GL.GL_FLOAT, False, {0..8})",
    "glVertexAttribBinding({1..5}, {0..3})",
    "glVertexBindingDivisor({0..3}, {0..1})",
)


def _places(w: Writer, text: str, points: str) -> str:
    while "{mode}" in text:
        text = text.replace("{mode}", mode(w), 1)
    text = text.replace("c_mode(", "ctypes.c_uint(")
    text = text.replace("{stride}", w.pick(_STRIDES)).replace("{points}", points)
    return "GL." + w.fill(text)


def _points(w: Writer) -> str:
    return w.pick((f"floats({w.whole(1, 3)})", f"floats({w.whole(1, 3)})[{w.whole(0, 9)}:]"))


def draw(w: Writer) -> str:
    """One draw, of client memory or of the buffer that is bound."""
    return _places(w, w.pick(_DRAWS), "")


def _arrays(w: Writer, points: str, most: int) -> None:
    used = [_places(w, row, points) for row in w.some(_POINTERS, most)]
    for step in used:
        w.say(step)
        for call, state in (
            ("glVertexPointer", "VERTEX"),
            ("glColorPointer", "COLOR"),
            ("glNormalPointer", "NORMAL"),
            ("glTexCoordPointer", "TEXTURE_COORD"),
            ("glEdgeFlagPointer", "EDGE_FLAG"),
            ("glFogCoordPointer", "FOG_COORD"),
            ("glSecondaryColorPointer", "SECONDARY_COLOR"),
        ):
            if step.startswith(f"GL.{call}") and w.maybe(0.9):
                w.say(f"GL.glEnableClientState(GL.GL_{state}_ARRAY)")
        if "glVertexAttrib" in step and "Pointer" in step and w.maybe(0.7):
            w.say(f"GL.glEnableVertexAttribArray({step.partition('(')[2].partition(',')[0]})")


@area(6)
def client(w: Writer) -> None:
    """Arrays in client memory, and draws from them."""
    if w.maybe(0.7):
        w.say(
            "GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)",
            "GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, 0)",
        )
    w.say(
        "GL.glVertexPointer(3, GL.GL_FLOAT, 0, floats(1))",
        "GL.glEnableClientState(GL.GL_VERTEX_ARRAY)",
    )
    _arrays(w, _points(w), 3)
    for _ in range(w.whole(1, 3)):
        w.say(draw(w))
    if w.maybe(0.5):
        w.say("GL." + w.row(_SWITCHES))
    if w.maybe(0.15):
        w.say(f"GL.glBegin({mode(w)})", "[GL.glArrayElement(i) for i in range(12)]", "GL.glEnd()")


@area(4)
def buffers(w: Writer) -> None:
    """The same from buffer objects, in vertex array objects now and then."""
    if w.maybe(0.4):
        array = w.make("vertex array", "GL.glGenVertexArrays(1)")
        w.say(f"GL.glBindVertexArray({array})")
    name = w.make("buffer", "GL.glGenBuffers(1)") if w.maybe(0.8) else w.name("buffer")
    w.say(
        f"GL.glBindBuffer(GL.GL_ARRAY_BUFFER, {name})",
        f"GL.glBufferData(GL.GL_ARRAY_BUFFER, floats({w.whole(1, 3)}), {w.enums('STATIC_DRAW', 'STREAM_DRAW')})",  # noqa: E501
    )
    w.say(
        "GL.glVertexPointer(3, GL.GL_FLOAT, 0, ctypes.c_void_p(0))",
        "GL.glEnableClientState(GL.GL_VERTEX_ARRAY)",
    )
    _arrays(w, w.pick(("ctypes.c_void_p(0)", "ctypes.c_void_p(12)", "None")), 2)
    if w.maybe(0.4):
        indices = w.make("buffer", "GL.glGenBuffers(1)")
        w.say(
            f"GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, {indices})",
            "GL.glBufferData(GL.GL_ELEMENT_ARRAY_BUFFER, indices(1), GL.GL_STATIC_DRAW)",
            w.fill(
                f"GL.glDrawElements({mode(w)}, {{0..40}}, GL.GL_UNSIGNED_INT, ctypes.c_void_p({{0..8}}))"  # noqa: E501
            ),
            w.fill(f"GL.glDrawElements({mode(w)}, {{0..40}}, GL.GL_UNSIGNED_INT, None)"),
        )
    for _ in range(w.whole(1, 2)):
        w.say(w.fill(f"GL.glDrawArrays({mode(w)}, {{0..20}}, {{0..60}})"))
    for _ in range(w.whole(0, 3)):
        w.say("GL." + w.row(_BUFFER_CALLS))
    if w.maybe(0.3):
        w.say(
            w.fill("m = GL.glMapBuffer(GL.GL_ARRAY_BUFFER, {READ_ONLY|WRITE_ONLY|READ_WRITE})"),
            "GL.glUnmapBuffer(GL.GL_ARRAY_BUFFER)",
        )
    w.say(
        "GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)", "GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, 0)"
    )
    if w.maybe(0.6):
        w.say("GL.glBindVertexArray(0)")
    w.say(
        "GL.glVertexPointer(3, GL.GL_FLOAT, 0, floats(1))",
        "GL.glDisableClientState(GL.GL_VERTEX_ARRAY)",
    )
