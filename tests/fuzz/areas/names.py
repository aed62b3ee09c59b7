"""Names of objects: generated, created, chosen by the program, asked for, deleted one by one and by
the thousand."""

from __future__ import annotations

from dataclasses import dataclass

from tests.fuzz.writing import Writer, area

NOT_GENERATED = (7, 12, 40, 997, 2**20, 2**31)
"""Names that a program chooses itself."""


@dataclass(frozen=True)
class Kind:
    """Of objects; calls as templates of `Writer.fill` without ``GL.``."""

    plural: str
    singular: str
    bind: tuple[str, ...]
    """``{}`` for the name."""
    create: str = ""
    """What comes before the number."""
    bindings: tuple[str, ...] = ()


KINDS = {
    "texture": Kind(
        "Textures", "Texture",
        ("glBindTexture({TEXTURE_2D|TEXTURE_3D|TEXTURE_CUBE_MAP|TEXTURE_RECTANGLE}, {})",
         "glBindTextureUnit({0..3}, {})"),
        "{TEXTURE_2D|TEXTURE_3D|TEXTURE_2D_ARRAY|TEXTURE_1D}, ",
        ("TEXTURE_BINDING_2D", "TEXTURE_BINDING_3D"),
    ),
    "buffer": Kind(
        "Buffers", "Buffer",
        ("glBindBuffer({ARRAY_BUFFER|ELEMENT_ARRAY_BUFFER|COPY_READ_BUFFER}, {})",
         "glBindBufferBase({UNIFORM_BUFFER|TRANSFORM_FEEDBACK_BUFFER}, {0..1}, {})",
         "glBindVertexBuffer({0..3}, {}, 0, 16)"),
        bindings=("ARRAY_BUFFER_BINDING", "COPY_READ_BUFFER_BINDING", "UNIFORM_BUFFER_BINDING"),
    ),
    "framebuffer": Kind(
        "Framebuffers", "Framebuffer", ("glBindFramebuffer(GL.GL_READ_FRAMEBUFFER, {})",),
        bindings=("READ_FRAMEBUFFER_BINDING", "DRAW_FRAMEBUFFER_BINDING"),
    ),
    "renderbuffer": Kind(
        "Renderbuffers", "Renderbuffer", ("glBindRenderbuffer(GL.GL_RENDERBUFFER, {})",),
        bindings=("RENDERBUFFER_BINDING",),
    ),
    "sampler": Kind("Samplers", "Sampler", ("glBindSampler({0..3}, {})",)),
    "vertex array": Kind(
        "VertexArrays", "VertexArray", ("glBindVertexArray({})",),
        bindings=("VERTEX_ARRAY_BINDING",),
    ),
    "program pipeline": Kind("ProgramPipelines", "ProgramPipeline", ("glBindProgramPipeline({})",)),
    "transform feedback": Kind(
        "TransformFeedbacks", "TransformFeedback",
        ("glBindTransformFeedback(GL.GL_TRANSFORM_FEEDBACK, {})",),
    ),
    "query": Kind("Queries", "Query", ("glBeginQuery({SAMPLES_PASSED|PRIMITIVES_GENERATED}, {})",
                                       "glEndQuery({SAMPLES_PASSED|PRIMITIVES_GENERATED})")),
}  # fmt: skip
STAGES = {
    "VERTEX": "void main() { gl_Position = vec4(0.0, 0.0, 0.0, 1.0); }",
    "FRAGMENT": "uniform vec4 k; void main() { gl_FragColor = k; }",
}
PROGRAMS = (
    "glIsProgram({program})", "glIsShader({program})", "glIsProgram({shader})",
    "glIsShader({shader})", "glIsProgram({1..40})", "glDeleteProgram({program})",
    "glDeleteShader({shader})", "glGetProgramiv({program}, GL.GL_ATTACHED_SHADERS)",
    "glGetShaderiv({shader}, GL.GL_SHADER_TYPE)", "glGetAttachedShaders({program})",
    "glUseProgram({program})", "glUseProgram(0)", "glGetIntegerv(GL.GL_CURRENT_PROGRAM)",
    "glGetFloatv(GL.GL_CURRENT_PROGRAM)", "glGetUniformLocation({program}, 'k')",
    "glAttachShader({program}, {shader})", "glDetachShader({program}, {shader})",
    "glObjectLabel({PROGRAM|SHADER}, {program}, 4, b'mine')", "glCompileShader({shader})",
    "glGetProgramInfoLog({program})", "glLinkProgram({program})",
    "glGetProgramPipelineiv(1, {ACTIVE_PROGRAM|VERTEX_SHADER}, room('i'))",
    "glUseProgramStages(1, 1, {program})", "glGetShaderSource({shader})",
    "glGetObjectLabel({PROGRAM|SHADER}, {program}, 8, None, room('b'))",
)  # fmt: skip


@area(3)
def names(w: Writer) -> None:
    """Objects of some kind."""
    kind = w.pick(list(KINDS))
    for _ in range(w.whole(1, 5)):
        _object(w, kind)


@area(2)
def program_names(w: Writer) -> None:
    """Programs and shaders, which share names."""
    for _ in range(w.whole(1, 5)):
        if w.maybe(0.3):
            stage = w.pick(list(STAGES))
            made = w.make("shader", f"GL.glCreateShader(GL.GL_{stage}_SHADER)")
            w.say(f"GL.glShaderSource({made}, {STAGES[stage]!r})", f"GL.glCompileShader({made})")
        elif w.maybe(0.3):
            made = w.make("program", "GL.glCreateProgram()")
            for shader in w.names.get("shader", [])[-2:]:
                w.say(f"GL.glAttachShader({made}, {shader})")
                if w.maybe(0.3):
                    w.say(f"GL.glDeleteShader({shader})")
            w.say(f"GL.glLinkProgram({made})")
        else:
            w.say("GL." + w.row(PROGRAMS))
    if w.maybe(0.1):
        w.say("[GL.glIsProgram(n) or 2 * GL.glIsShader(n) for n in range(1, 60)]")


@area(1)
def list_names(w: Writer) -> None:
    """Display lists."""
    number = w.whole(1, 5)
    made = w.make("list", f"GL.glGenLists({number})")
    name = w.pick((made, f"{made} + {number - 1}", w.name("list"), str(w.pick(NOT_GENERATED))))
    w.say(f"GL.glNewList({name}, GL.GL_COMPILE)", "GL.glRectf(-0.5, -0.5, 0.25, 0.5)",
          "GL.glEndList()", f"GL.glCallList({name})", f"GL.glIsList({w.name('list')})")  # fmt: skip
    if w.maybe(0.3):
        w.say(w.pick((f"GL.glDeleteLists({made}, {number})", "GL.glDeleteLists(1, 10000)")))


def _object(w: Writer, kind: str) -> None:
    calls, number = KINDS[kind], w.pick((1, 1, 2, 3, 7))
    what = w.weighted({
        "generate": 5, "create": 2, "bind": 5, "choose": 2, "is": 3, "are": 1, "delete": 2,
        "range": 0.3, "bindings": 2,
    })  # fmt: skip
    if what == "generate":
        made = w.make(kind, f"GL.glGen{calls.plural}({number})")
        if number > 1:  # an array
            w.names[kind][-1:] = [f"int({made}[{k}])" for k in range(number)]
    elif what == "create":
        made = w.make(kind, f"(ctypes.c_uint * {number})()")
        before = w.fill(calls.create)
        w.say(f"GL.glCreate{calls.plural}({before}{number}, {made})", f"list({made})")
        w.names[kind][-1:] = [f"{made}[{k}]" for k in range(number)]
    elif what in ("bind", "choose"):
        name = w.name(kind) if what == "bind" else str(w.pick(NOT_GENERATED))
        w.say("GL." + w.fill(w.pick(calls.bind).replace("{}", name)))
    elif what == "is":
        w.say(f"GL.glIs{calls.singular}({w.name(kind)})")
    elif what == "are":
        w.say(f"[int(GL.glIs{calls.singular}(n)) for n in range(1, 40)]")
    elif what == "delete":
        some = [w.name(kind) for _ in range(w.whole(1, 3))]
        w.say(f"GL.glDelete{calls.plural}({len(some)}, [{', '.join(some)}])")
    elif what == "range":
        w.say(f"GL.glDelete{calls.plural}(999, list(range(1, 1000)))")
    else:
        for binding in calls.bindings:
            w.say(f"GL.glGetIntegerv(GL.GL_{binding})")
