"""Shaders of the program's own, queries, transform feedback, sync objects, debug output."""

from __future__ import annotations

from tests.fuzz.areas.immediate import primitive
from tests.fuzz.writing import Writer, area

VERTEX = (
    "void main() { gl_Position = ftransform(); gl_FrontColor = gl_Color; gl_TexCoord[0] = gl_MultiTexCoord0; }",  # noqa: E501
    "#version 130\\nin vec4 more; uniform vec4 tint; void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex + more * 0.01; gl_FrontColor = tint; gl_TexCoord[0] = more; }",  # noqa: E501
    "#version 330 compatibility\\nlayout(location = 0) in vec4 place; void main() { gl_Position = place; gl_FrontColor = gl_Color; gl_TexCoord[0] = vec4(0); }",  # noqa: E501
    "void main() { gl_Position = nothing; }",
)
FRAGMENT = (
    "void main() { gl_FragColor = gl_Color; }",
    "uniform sampler2D image; void main() { gl_FragColor = texture2D(image, gl_TexCoord[0].st); }",
    "#version 130\\nuniform vec4 tint; out vec4 colour; void main() { colour = gl_Color + tint; }",
    "#version 330\\nout vec4 colour; void main() { colour = vec4(1, 0.5, 0, 1); }",
)
_CALLS = (
    "glUseProgram({program})",
    "glUseProgram({program})",
    "glUseProgram(0)",
    "glUseProgram({1..9})",
    "glLinkProgram({program})",
    "glGetUniformLocation({program}, 'tint')",
    "glGetAttribLocation({program}, b'more')",
    "glGetProgramiv({program}, {@ProgramPropertyARB})",
    "glGetShaderiv({shader}, {@ShaderParameterName})",
    "glGetProgramInfoLog({program})",
    "glGetShaderInfoLog({shader})",
    "glIsProgram({program})",
    "glIsShader({shader})",
    "glIsProgram({1..6})",
    "glIsShader({1..6})",
    "glUniform4f({-1..2}, {4u})",
    "glUniform4fv({0..1}, 1, {v4fu})",
    "glUniform1i({0..1}, {0..2})",
    "glGetActiveUniform({program}, {0..2})",
    "glGetActiveAttrib({program}, {0..1})",
    "glGetAttachedShaders({program})",
    "glDeleteProgram({program})",
    "glDeleteShader({shader})",
    "glDetachShader({program}, {shader})",
    "glAttachShader({program}, {shader})",
    "glBindAttribLocation({program}, {0..4}, 'more')",
    "glValidateProgram({program})",
    "glGetIntegerv(GL.GL_CURRENT_PROGRAM)",
    "glCreateProgram()",
    "glCreateShader({@ShaderType})",
    "glGetShaderSource({shader})",
    "glUniformMatrix4fv({0..1}, 1, False, {matrix})",
    "glProgramUniform4f({program}, 0, {4u})",
    "glGetUniformfv({program}, 0, room('f'))",
    "glUseProgramStages({program pipeline}, 1, {program})",
    "glProgramParameteri({program}, GL.GL_PROGRAM_SEPARABLE, 1)",
    "glTransformFeedbackVaryings({program}, 1, (ctypes.POINTER(ctypes.c_char) * 1)(ctypes.create_string_buffer(b'gl_Position')), GL.GL_INTERLEAVED_ATTRIBS)",  # noqa: E501
)


@area(3)
def shaders(w: Writer) -> None:
    """A program, and what is asked and set."""
    for kind, texts in (("VERTEX", VERTEX), ("FRAGMENT", FRAGMENT)):
        if w.maybe(0.6):
            shader = w.make("shader", f"GL.glCreateShader(GL.GL_{kind}_SHADER)")
            w.say(
                f"GL.glShaderSource({shader}, '{w.pick(texts)}')", f"GL.glCompileShader({shader})"
            )
    if w.maybe(0.7):
        program = w.make("program", "GL.glCreateProgram()")
        for shader in w.names.get("shader", [])[-2:]:
            w.say(f"GL.glAttachShader({program}, {shader})")
        w.say(f"GL.glLinkProgram({program})")
        if w.maybe(0.7):
            w.say(f"GL.glUseProgram({program})")
            primitive(w)
    for _ in range(w.whole(1, 4)):
        w.say("GL." + w.row(_CALLS))
    if w.maybe(0.7):
        w.say("GL.glUseProgram(0)")


_QUERY_TARGETS = (
    "SAMPLES_PASSED",
    "SAMPLES_PASSED",
    "ANY_SAMPLES_PASSED",
    "PRIMITIVES_GENERATED",
    "ANY_SAMPLES_PASSED_CONSERVATIVE",
    "VERTICES_SUBMITTED",
    "PRIMITIVES_SUBMITTED",
    "TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN",
    "VERTEX_SHADER_INVOCATIONS",
    "CLIPPING_INPUT_PRIMITIVES",
)


@area(3)
def queries(w: Writer) -> None:
    """A query around draws, sometimes across a swap."""
    name = w.make(
        "query",
        w.pick(
            ("int(GL.glGenQueries(1)[0])", "GL.glGenQueries(2)[1]", "int(GL.glGenQueries(1)[0])")
        ),
    )
    target = w.pick(_QUERY_TARGETS)
    w.say(f"GL.glBeginQuery(GL.GL_{target}, {name})")
    if w.maybe(0.9):
        primitive(w)
    if w.maybe(0.3):
        w.say("swap()")
        primitive(w)
    if w.maybe(0.95):
        w.say(f"GL.glEndQuery(GL.GL_{target})")
    w.say(w.fill(f"GL.glGetQueryObjectuiv({name}, {{QUERY_RESULT|QUERY_RESULT}})"))
    if w.maybe(0.3):
        w.say(f"GL.glBeginConditionalRender({name}, GL.GL_QUERY_WAIT)")
        primitive(w)
        if w.maybe(0.3):
            w.say("swap()")
        w.say("GL.glEndConditionalRender()")
    w.say(
        "GL."
        + w.row(
            (
                "glIsQuery({query})",
                "glIsQuery({1..4})",
                "glDeleteQueries(1, [{query}])",
                "glGetQueryiv({SAMPLES_PASSED|PRIMITIVES_GENERATED}, GL.GL_CURRENT_QUERY)",
                "glGenQueries({1..2})",
            )
        )
    )


@area(1)
def transform_feedback(w: Writer) -> None:
    """Captured by the program itself, sometimes across a swap."""
    shader, program = (
        w.make("shader", "GL.glCreateShader(GL.GL_VERTEX_SHADER)"),
        w.make("program", "GL.glCreateProgram()"),
    )
    buffer = w.make("buffer", "GL.glGenBuffers(1)")
    w.say(
        f"GL.glShaderSource({shader}, '{VERTEX[0]}')",
        f"GL.glCompileShader({shader})",
        f"GL.glAttachShader({program}, {shader})",
        f"GL.glTransformFeedbackVaryings({program}, 1, (ctypes.POINTER(ctypes.c_char) * 1)(ctypes.create_string_buffer(b'gl_Position')), GL.GL_INTERLEAVED_ATTRIBS)",  # noqa: E501
        f"GL.glLinkProgram({program})",
        f"GL.glUseProgram({program})",
        f"GL.glBindBuffer(GL.GL_TRANSFORM_FEEDBACK_BUFFER, {buffer})",
        "GL.glBufferData(GL.GL_TRANSFORM_FEEDBACK_BUFFER, floats(3), GL.GL_STATIC_DRAW)",
        f"GL.glBindBufferBase(GL.GL_TRANSFORM_FEEDBACK_BUFFER, 0, {buffer})",
        "GL.glBeginTransformFeedback(GL.GL_TRIANGLES)",
        "GL.glBegin(GL.GL_TRIANGLES)",
        "[GL.glVertex3fv(p) for p in floats(1)[:6]]",
        "GL.glEnd()",
    )
    if w.maybe(0.3):
        w.say("GL.glPauseTransformFeedback()", "GL.glResumeTransformFeedback()")
    if w.maybe(0.3):
        w.say("swap()")
    w.say(
        "GL.glEndTransformFeedback()",
        "GL.glGetBufferSubData(GL.GL_TRANSFORM_FEEDBACK_BUFFER, 0, 96)",
        "GL.glUseProgram(0)",
    )


_SYNC = (
    "GL.glFlush()",
    "GL.glFinish()",
    "s = GL.glFenceSync(GL.GL_SYNC_GPU_COMMANDS_COMPLETE, 0)",
    "GL.glClientWaitSync(s, 1, 10**9) in (0x911A, 0x911C)",
    "GL.glIsSync(s)",
    "GL.glDeleteSync(s)",
    "GL.glWaitSync(s, 0, GL.GL_TIMEOUT_IGNORED)",
    "GL.glMemoryBarrier({@MemoryBarrierMask})",
    "GL.glTextureBarrier()",
    "GL.glGetGraphicsResetStatus()",
)
_DEBUG = (
    "GL.glDebugMessageCallback(keep(GL.GLDEBUGPROC(hear)), None)",
    "GL.glEnable(GL.GL_DEBUG_OUTPUT)",
    "GL.glEnable(GL.GL_DEBUG_OUTPUT_SYNCHRONOUS)",
    "GL.glDebugMessageInsert(GL.GL_DEBUG_SOURCE_APPLICATION, GL.GL_DEBUG_TYPE_OTHER, {0..9}, GL.GL_DEBUG_SEVERITY_LOW, 5, b'hello')",  # noqa: E501
    "heard()",
    "heard()",
    "GL.glPushDebugGroup(GL.GL_DEBUG_SOURCE_APPLICATION, {0..9}, -1, b'group')",
    "GL.glPopDebugGroup()",
    "GL.glEnable(0xFFFF)",
    "GL.glGetError()",
    "GL.glObjectLabel({BUFFER|TEXTURE|PROGRAM}, {0..3}, -1, b'label')",
)


@area(2)
def waits(w: Writer) -> None:
    """Flushes, fences, barriers."""
    w.say(*(w.row(_SYNC) for _ in range(w.whole(1, 3))))


@area(1)
def debug(w: Writer) -> None:
    """Messages that the program listens to, also across a swap."""
    w.say(_DEBUG[0], _DEBUG[1], _DEBUG[2])
    for _ in range(w.whole(1, 4)):
        w.say(w.row(_DEBUG))
    if w.maybe(0.5):
        primitive(w)
        w.say("swap()")
    w.say("heard()")
