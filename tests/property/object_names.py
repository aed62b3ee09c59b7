"""Random calls that make, name, ask for and delete objects, between frames that are drawn."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from functools import partial
from typing import Any

import glfw
from OpenGL import GL
from OpenGL.GL.ARB import vertex_program

from glshim.checks.observe import App
from tests.differential.world import styled, window

Call = Callable[..., Any]
Step = tuple[str, ...] | tuple[Any, ...]

LARGE = (7, 12, 40, 997, 2**20, 2**31)
"""Names that nobody has generated."""


class Kind:
    """Calls of one kind of objects."""

    def __init__(
        self,
        plural: str,
        singular: str,
        bind: Call,
        *,
        create: Call | None = None,
        bindings: tuple[int, ...] = (),
        suffix: str = "",
        named: bool = False,
    ) -> None:
        home = vertex_program if suffix else GL
        self.generate = getattr(home, f"glGen{plural}{suffix}")
        self.delete = getattr(home, f"glDelete{plural}{suffix}")
        self.is_there = getattr(home, f"glIs{singular}{suffix}")
        self.bind, self.create, self.bindings = bind, create, bindings
        self.named = named
        """Whether programs may choose names."""


def _query(name: int) -> None:
    GL.glBeginQuery(GL.GL_SAMPLES_PASSED, name)
    GL.glEndQuery(GL.GL_SAMPLES_PASSED)


def _texture(target: int) -> Call:
    return lambda name: GL.glBindTexture(target, name)


SHARED: dict[str, Kind] = {
    "texture": Kind(
        "Textures", "Texture", _texture(GL.GL_TEXTURE_2D), named=True,
        create=partial(GL.glCreateTextures, GL.GL_TEXTURE_2D),
        bindings=(GL.GL_TEXTURE_BINDING_2D,),
    ),
    "texture of three": Kind(
        "Textures", "Texture", _texture(GL.GL_TEXTURE_3D), named=True,
        create=partial(GL.glCreateTextures, GL.GL_TEXTURE_3D),
        bindings=(GL.GL_TEXTURE_BINDING_3D,),
    ),
    "buffer": Kind(
        "Buffers", "Buffer", lambda n: GL.glBindBuffer(GL.GL_ARRAY_BUFFER, n), named=True,
        create=GL.glCreateBuffers, bindings=(GL.GL_ARRAY_BUFFER_BINDING,),
    ),
    "uniform buffer": Kind(
        "Buffers", "Buffer", lambda n: GL.glBindBufferBase(GL.GL_UNIFORM_BUFFER, 0, n),
        named=True, create=GL.glCreateBuffers, bindings=(GL.GL_UNIFORM_BUFFER_BINDING,),
    ),
    "framebuffer": Kind(
        "Framebuffers", "Framebuffer",
        lambda n: GL.glBindFramebuffer(GL.GL_READ_FRAMEBUFFER, n), named=True,
        create=GL.glCreateFramebuffers, bindings=(GL.GL_READ_FRAMEBUFFER_BINDING,),
    ),
    "renderbuffer": Kind(
        "Renderbuffers", "Renderbuffer",
        lambda n: GL.glBindRenderbuffer(GL.GL_RENDERBUFFER, n), named=True,
        create=GL.glCreateRenderbuffers, bindings=(GL.GL_RENDERBUFFER_BINDING,),
    ),
    "sampler": Kind(
        "Samplers", "Sampler", lambda n: GL.glBindSampler(3, n), create=GL.glCreateSamplers,
    ),
    "vertex array": Kind(
        "VertexArrays", "VertexArray", GL.glBindVertexArray, create=GL.glCreateVertexArrays,
        bindings=(GL.GL_VERTEX_ARRAY_BINDING,),
    ),
    "pipeline": Kind(
        "ProgramPipelines", "ProgramPipeline", GL.glBindProgramPipeline,
        create=GL.glCreateProgramPipelines, bindings=(GL.GL_PROGRAM_PIPELINE_BINDING,),
    ),
    "transform feedback": Kind(
        "TransformFeedbacks", "TransformFeedback",
        lambda n: GL.glBindTransformFeedback(GL.GL_TRANSFORM_FEEDBACK, n),
        create=GL.glCreateTransformFeedbacks, bindings=(GL.GL_TRANSFORM_FEEDBACK_BINDING,),
    ),
    "query": Kind("Queries", "Query", _query, named=True),
}  # fmt: skip
COMPATIBLE = SHARED | {
    "ARB program": Kind(
        "Programs", "Program",
        lambda n: vertex_program.glBindProgramARB(vertex_program.GL_VERTEX_PROGRAM_ARB, n),
        suffix="ARB", named=True,
    ),
}  # fmt: skip

VERTEX = "#version {} \nvoid main() {{ gl_Position = vec4(0.0, 0.0, 0.0, 1.0); }}"
FRAGMENT = "#version {} \nout vec4 c; uniform vec4 k; void main() {{ c = k; }}"


def steps(seed: int, *, core: bool, windows: int) -> list[Step]:
    """A program, drawn from a seed."""
    dice = random.Random(seed)
    kinds = sorted(SHARED if core else COMPATIBLE)
    favoured = dice.sample(kinds, 4)

    def one() -> Step:
        kind, number = dice.choice(favoured), dice.choice((1, 1, 1, 2, 3, 7))
        what = dice.choices(
            ("generate", "create", "bind", "bind a name", "is", "are", "delete", "delete some",
             "range", "bindings", "shader", "program", "link", "use", "lists", "call", "labels",
             "frame", "turn"),
            (5, 2, 5, 2, 3, 1, 3, 1, 0.3, 2, 3, 2, 1, 1, 3, 2, 1, 3, 1),
        )[0]  # fmt: skip
        return what, kind, number, dice.randrange(1 << 20)

    found = [one() for _ in range(dice.randrange(20, 60))]
    return [*found[: len(found) // 3], ("frame", "", 0, 0), *found[len(found) // 3 :]]


class Program:
    """Carries out steps; what it is answered is written down."""

    def __init__(self, app: App, *, core: bool, frame: Call, turn: Call) -> None:
        self._app, self._core, self._frame, self._turn = app, core, frame, turn
        self._kinds = SHARED if core else COMPATIBLE
        self._names: dict[str, list[int]] = {}
        self._version = 330

    def run(self, program: list[Step]) -> None:
        for what, kind, number, pick in program:
            self._app.saw.append(f"{what} {kind} {number} {pick}")
            self._step(str(what), str(kind), int(number), int(pick))

    def _step(self, what: str, kind: str, number: int, pick: int) -> None:
        app = self._app
        if what == "frame":
            app.tries(self._frame)
        elif what == "turn":
            self._turn(pick)
        elif what in ("shader", "program", "link", "use"):
            self._shading(what, pick)
        elif what in ("lists", "call"):
            if not self._core:
                self._lists(what, number, pick)
        elif what == "labels":
            name = self._one("program", pick)
            label = app.keeps((GL.GLchar * 8)())
            app.tries(GL.glGetObjectLabel, GL.GL_PROGRAM, name, 8, None, label)
        else:
            self._objects(what, self._kinds[kind], kind, number, pick)

    def _objects(self, what: str, calls: Kind, kind: str, number: int, pick: int) -> None:
        app = self._app
        if what == "generate":
            self._took(kind, app.tries(calls.generate, number))
        elif what == "create" and calls.create is not None:
            names = (GL.GLuint * number)()
            app.tries(calls.create, number, names)
            self._took(kind, list(names))
        elif what == "bind":
            app.tries(calls.bind, self._one(kind, pick))
        elif what == "bind a name":
            app.tries(calls.bind, LARGE[pick % len(LARGE)])
        elif what == "is":
            app.tries(calls.is_there, self._one(kind, pick))
        elif what == "are":
            app.saw.append(str([int(bool(calls.is_there(n))) for n in range(1, 40)]))
        elif what == "delete":
            app.tries(calls.delete, 1, [self._one(kind, pick)])
        elif what == "delete some":
            names = self._names.get(kind, [])[pick % 3 :: 2]
            app.tries(calls.delete, len(names), names)
        elif what == "range":
            app.tries(calls.delete, 999, list(range(1, 1000)))
        elif what == "bindings":
            for binding in calls.bindings:
                app.tries(GL.glGetIntegerv, binding)

    def _took(self, kind: str, given: Any) -> None:
        if given is not None:
            names = list(given) if hasattr(given, "__len__") else [given]
            self._app.saw.append(str([int(name) for name in names]))
            self._names.setdefault(kind, []).extend(int(name) for name in names)

    def _one(self, kind: str, pick: int) -> int:
        known = self._names.get(kind, [])
        return pick % 9 if not known or pick % 5 == 0 else known[pick % len(known)]

    def _shading(self, what: str, pick: int) -> None:
        app = self._app
        stages = ((GL.GL_VERTEX_SHADER, VERTEX), (GL.GL_FRAGMENT_SHADER, FRAGMENT))
        if what == "shader":
            self._took("shader", app.tries(GL.glCreateShader, stages[pick % 2][0]))
            name = self._one("shader", pick)
            app.tries(GL.glIsShader, name)
            app.tries(GL.glIsProgram, name)
            app.tries(GL.glGetShaderiv, name, GL.GL_SHADER_TYPE)
            if pick % 3 == 0:
                app.tries(GL.glDeleteShader, self._one("shader", pick // 3))
        elif what == "program":
            self._took("program", app.tries(GL.glCreateProgram))
            name = self._one("program", pick)
            app.tries(GL.glIsProgram, name)
            app.tries(GL.glGetProgramiv, name, GL.GL_ATTACHED_SHADERS)
            if pick % 3 == 0:
                app.tries(GL.glDeleteProgram, self._one("program", pick // 3))
            if pick % 17 == 0:
                for each in range(1, 60):
                    app.tries(GL.glIsProgram, each)
        elif what == "link":
            program = app.tries(GL.glCreateProgram)
            if not program:
                return
            for kind, text in stages:
                shader = app.tries(GL.glCreateShader, kind)
                GL.glShaderSource(shader, text.format(self._version))
                app.tries(GL.glCompileShader, shader)
                app.tries(GL.glAttachShader, program, shader)
                if pick % 2:
                    app.tries(GL.glDeleteShader, shader)
            app.tries(GL.glLinkProgram, program)
            app.tries(GL.glGetAttachedShaders, program)
            app.tries(GL.glGetUniformLocation, program, "k")
            self._took("program", program)
        elif what == "use":
            app.tries(GL.glUseProgram, self._one("program", pick) if pick % 3 else 0)
            app.tries(GL.glGetIntegerv, GL.GL_CURRENT_PROGRAM)
            app.tries(GL.glGetFloatv, GL.GL_CURRENT_PROGRAM)

    def _lists(self, what: str, number: int, pick: int) -> None:
        app = self._app
        if what == "call":
            app.tries(GL.glCallList, self._one("list", pick))
            app.tries(GL.glIsList, self._one("list", pick // 2))
            if pick % 4 == 0:
                app.tries(GL.glDeleteLists, self._one("list", pick), number)
            if pick % 40 == 0:
                app.tries(GL.glDeleteLists, 1, 10000)
            return
        first = app.tries(GL.glGenLists, number)
        if first is not None:
            self._took("list", list(range(int(first), int(first) + number)))
        name = self._one("list", pick)
        app.tries(GL.glNewList, name, GL.GL_COMPILE)
        if not app.saw[-1].startswith("GLError"):
            GL.glBegin(GL.GL_QUADS)
            for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
                GL.glVertex3f(x, y, 0.1)
            GL.glEnd()
            app.tries(GL.glEndList)


def _frame(handle: Any, *, core: bool, number: Iterator[int]) -> None:
    """Draw something that carries lines, and present it."""
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    if not core:
        used, array = (GL.glGetIntegerv(name) for name in
                       (GL.GL_CURRENT_PROGRAM, GL.GL_VERTEX_ARRAY_BINDING))  # fmt: skip
        GL.glUseProgram(0)
        turn = next(number)
        GL.glPushMatrix()
        GL.glRotatef(20.0 + 7.0 * turn, 1.0, 1.0, 0.0)
        GL.glEnable(GL.GL_DEPTH_TEST)
        for face in range(6):
            GL.glBegin(GL.GL_QUADS)
            for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                point = [0.0, 0.0, 0.0]
                axis, side = face // 2, 2 * (face % 2) - 1
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, x * side, y
                GL.glVertex3f(*(0.4 * p for p in point))
            GL.glEnd()
        GL.glPopMatrix()
        GL.glUseProgram(used)
        GL.glBindVertexArray(array)
    glfw.swap_buffers(handle)


def answers(
    seed: int, style: str | None, *, core: bool = False, windows: int = 1
) -> list[str]:
    """What a program is answered, plain (None) or under a style, in windows that share."""
    hints: dict[str, int] = {}
    if core:
        hints = {"CONTEXT_VERSION_MAJOR": 4, "CONTEXT_VERSION_MINOR": 5,
                 "OPENGL_PROFILE": glfw.OPENGL_CORE_PROFILE}  # fmt: skip
    app = App()
    with ExitStack() as stack:
        stack.enter_context(styled(style))
        handles: list[Any] = []
        for _ in range(windows):
            share = handles[0] if handles else None
            handles.append(stack.enter_context(window(share=share, **hints)))
        now = [handles[-1]]
        frames = iter(range(1 << 20))

        def turn(pick: int) -> None:
            now[0] = handles[pick % windows]
            glfw.make_context_current(now[0])

        program = Program(
            app, core=core, turn=turn,
            frame=lambda: _frame(now[0], core=core, number=frames),
        )  # fmt: skip
        program.run(steps(seed, core=core, windows=windows))
        app.error()
    return app.saw


def difference(
    seed: int, style: str, *, core: bool = False, windows: int = 1
) -> tuple[list[str], str | None] | None:
    """Where a program is first answered otherwise than plain: what it was answered until then, and
    what under the style; None: nowhere."""
    plain = answers(seed, None, core=core, windows=windows)
    styled = answers(seed, style, core=core, windows=windows)
    for at, (one, other) in enumerate(zip([*plain, None], [*styled, None], strict=False)):
        if one != other:
            return plain[max(at - 8, 0) : at + 1], other
    return None


def _gives_again() -> bool:
    """Whether this driver gives names again."""
    with window():
        first = int(GL.glGenTextures(1))
        GL.glDeleteTextures(1, [first])
        return int(GL.glGenTextures(1)) == first


def main(number: int, first: int) -> int:
    """Compare programs of so many seeds; exit status 1 where one is answered otherwise."""
    import sys

    from glshim.styling import registry

    styles = ("none", "raskar", *registry.names(), *registry.looks())
    found = 0
    for seed in range(first, first + number):
        style, windows = styles[seed % len(styles)], 1 + seed % 2
        core = seed % 7 == 0
        where = difference(seed, style, core=core, windows=windows)
        if where is not None:
            found += 1
            print(seed, style, where)
        if seed % 100 == 99:
            print(seed + 1 - first, "done", file=sys.stderr)
    again = "names are given again" if _gives_again() else "names are not given again"
    print(f"{number} programs, {found or 'no'} difference{'s' if found > 1 else ''}; {again}")
    return int(found > 0)


if __name__ == "__main__":
    import sys

    from glshim.running.headless import virtual_screen

    with ExitStack() as screen:
        import os

        if "DISPLAY" not in os.environ:
            os.environ.update(screen.enter_context(virtual_screen()))
        sys.exit(main(*map(int, [*sys.argv[1:], "0"][:2])))
