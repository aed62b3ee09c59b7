"""What a program may hear of us by errors, debug output, queries, conditional rendering, transform
feedback and feedback mode: random programs, plain and under styles, with one transcript each.

    python -m tests.unnoticed --programs 200 --seed 1 --context legacy --unchecked

`CONTEXTS` are the kinds of context; unchecked: without PyOpenGL's error checking, so that errors
wait. Says each difference with its program; exit status 1 where there is any.
"""

from __future__ import annotations

import argparse
import ctypes
import os
import random
import subprocess
import sys
from collections.abc import Callable
from contextlib import ExitStack, suppress
from typing import Any

CONTEXTS: dict[str, tuple[dict[str, Any], dict[str, str]]] = {
    "compatibility": ({}, {}),
    "legacy": ({}, {"MESA_GL_VERSION_OVERRIDE": "2.1", "MESA_GLSL_VERSION_OVERRIDE": "120"}),
    "core": ({"CONTEXT_VERSION_MAJOR": 4, "CONTEXT_VERSION_MINOR": 5,
              "OPENGL_PROFILE": 0x00032001}, {}),
}  # fmt: skip
"""Hints of glfw's, and the environment."""
STYLES = ("none", "raskar", "technical", "sketch", "watercolour")
_UNCHECKED = "UNCHECKED"
SIZE = 64
QUERY, CONDITION, CAPTURE = "query", "condition", "capture"


def main() -> int:
    """Start the worker in its environment, or be it."""
    parser = argparse.ArgumentParser(prog="python -m tests.unnoticed", description=__doc__)
    parser.add_argument("--programs", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--steps", type=int, default=40)
    parser.add_argument("--context", choices=CONTEXTS, default="compatibility")
    parser.add_argument("--styles", default=",".join(STYLES))
    parser.add_argument("--unchecked", action="store_true")
    parser.add_argument("--checked", dest="unchecked", action="store_false")
    options = parser.parse_args()
    if "DISPLAY" not in os.environ:
        from glshim.running.headless import virtual_screen

        with virtual_screen() as environment:
            return subprocess.run(
                [sys.executable, "-m", "tests.unnoticed", *sys.argv[1:]], check=False,
                env={**environment, **CONTEXTS[options.context][1]},
            ).returncode  # fmt: skip
    os.environ.update(CONTEXTS[options.context][1])
    if options.unchecked:
        import OpenGL

        OpenGL.ERROR_CHECKING = False
    styles = options.styles.split(",")
    different = ran = 0
    for seed in range(options.seed, options.seed + options.programs):
        different += not _alike(seed, options.steps, options.context, styles)
        ran += len(styles)
    print(f"{options.programs} programs, {ran} runs under styles: {different} programs differ")
    return bool(different)


def _alike(seed: int, steps: int, context: str, styles: list[str]) -> bool:
    plain = transcript(seed, steps, context, None)
    again = transcript(seed, steps, context, None)
    if again != plain:  # PyOpenGL asks the driver when it first loads a function
        plain = again
        if plain != transcript(seed, steps, context, None):
            print(f"seed {seed}: two plain runs differ")
            return True
    for style in styles:
        found = transcript(seed, steps, context, style)
        if style != "none":
            plain_lines, lines = (_without_pictures(each) for each in (plain, found))
        else:
            plain_lines, lines = plain, found
        if lines != plain_lines:
            at = next(
                (i for i, pair in enumerate(zip(plain_lines, lines, strict=False))
                 if pair[0] != pair[1]), min(len(plain_lines), len(lines)),
            )  # fmt: skip
            print(f"seed {seed}, {context}, {style}: step {at}")
            for line in plain_lines[max(0, at - 12) : at]:
                print("      ", line)
            print("plain  ", plain_lines[at : at + 2], "\nstyled ", lines[at : at + 2])
            return False
    return True


def _without_pictures(lines: list[str]) -> list[str]:
    return [line for line in lines if not line.startswith("picture")]


def transcript(seed: int, steps: int, context: str, style: str | None) -> list[str]:
    """What a program of a seed does, and what it is told."""
    import glfw

    import glshim

    if style is not None:
        glshim.install(style)
    try:
        glfw.init()
        with ExitStack() as windows:
            program = Program(random.Random(seed), context, windows)
            for _ in range(steps):
                program.step()
            program.finish()
            return program.said
    finally:
        glshim.uninstall()


class Program:
    """A random program."""

    def __init__(self, chance: random.Random, context: str, windows: ExitStack) -> None:
        import glfw
        from OpenGL import GL

        self.GL, self.glfw = GL, glfw
        self.said: list[str] = []
        self._chance = chance
        self._core = context == "core"
        hints = {"VISIBLE": 0, "OPENGL_DEBUG_CONTEXT": 1, **CONTEXTS[context][0]}
        self._windows = []
        for _ in range(chance.choice((1, 1, 2))):
            glfw.default_window_hints()
            for name, value in hints.items():
                glfw.window_hint(getattr(glfw, name), value)
            handle = glfw.create_window(SIZE, SIZE, "unnoticed", None, None)
            windows.callback(glfw.destroy_window, handle)
            self._windows.append(World(self, handle, chance.choice((None, "callback", "log"))))
        windows.callback(glfw.make_context_current, None)
        self._now = self._windows[0]
        self._now.turn_to()

    def step(self) -> None:
        """Something, by chance."""
        if len(self._windows) > 1 and self._chance.random() < 0.1:
            self._now = self._chance.choice(self._windows)
            self._now.turn_to()
        self._now.step(self._chance)

    def finish(self) -> None:
        """Close all that is open."""
        for world in self._windows:
            world.turn_to()
            world.finish()


VERTEX = """#version {version}
{input} vec4 place; {output} vec4 seen;
void main() {{ seen = place.wzyx; gl_Position = vec4(place.xyz, 1.0); }}
"""
FRAGMENT = """#version {version}
{declared} void main() {{ {colour} = vec4(0.2, 0.5, 0.7, 1.0); }}
"""


class World:
    """A window of the program's, with what is open in its context."""

    def __init__(self, program: Program, handle: Any, messages: str | None) -> None:
        self._program, self._handle, self._messages = program, handle, messages
        self.GL = GL = program.GL
        self._core = program._core
        self._ready = False
        self._queries: dict[tuple[int, int], int] = {}
        self._done: list[int] = []
        self._condition = self._capturing = False
        self._paused = False
        self._lists = 0
        kinds = [
            "SAMPLES_PASSED", "ANY_SAMPLES_PASSED", "ANY_SAMPLES_PASSED_CONSERVATIVE",
            "PRIMITIVES_GENERATED", "TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN", "TIME_ELAPSED",
            "VERTICES_SUBMITTED", "PRIMITIVES_SUBMITTED", "VERTEX_SHADER_INVOCATIONS",
            "GEOMETRY_SHADER_INVOCATIONS", "GEOMETRY_SHADER_PRIMITIVES_EMITTED",
            "FRAGMENT_SHADER_INVOCATIONS", "CLIPPING_INPUT_PRIMITIVES",
            "CLIPPING_OUTPUT_PRIMITIVES", "COMPUTE_SHADER_INVOCATIONS",
            "TESS_CONTROL_SHADER_PATCHES", "TESS_EVALUATION_SHADER_INVOCATIONS",
            "TRANSFORM_FEEDBACK_OVERFLOW", "TRANSFORM_FEEDBACK_STREAM_OVERFLOW",
        ]  # fmt: skip
        self._targets = [getattr(GL, f"GL_{kind}") for kind in kinds if hasattr(GL, f"GL_{kind}")]

    # -- what is told ----------------------------------------------------------------------------

    def say(self, *words: Any) -> None:
        """Into the transcript."""
        self._program.said.append(" ".join(map(str, words)))

    def tries(self, name: str, *args: Any) -> Any:
        """A call, whatever becomes of it."""
        try:
            return getattr(self.GL, name)(*args)
        except self.GL.GLError as error:
            self.say(name, "GLError", int(error.err))
        except Exception as error:
            self.say(name, type(error).__name__)
        return None

    # -- beginning and end -----------------------------------------------------------------------

    def turn_to(self) -> None:
        self._program.glfw.make_context_current(self._handle)
        if not self._ready:
            self._ready = True
            self._set_up()

    def _set_up(self) -> None:
        GL = self.GL
        if self._messages == "callback" and GL.glDebugMessageCallback:
            def heard(*told: Any) -> None:
                source, kind, _, severity, length, text, _ = told
                self.say("heard", source, kind, severity, ctypes.string_at(text, length))

            self._heard = GL.GLDEBUGPROC(heard)
            self.tries("glEnable", GL.GL_DEBUG_OUTPUT)
            self.tries("glEnable", GL.GL_DEBUG_OUTPUT_SYNCHRONOUS)
            self.tries("glDebugMessageCallback", self._heard, None)
        elif self._messages is None:
            self.tries("glDisable", GL.GL_DEBUG_OUTPUT)
        self.tries("glEnable", GL.GL_DEPTH_TEST)
        self._shaders = None
        with suppress(Exception):
            self._shaders = self._linked()
        if self._core:
            GL.glBindVertexArray(GL.glGenVertexArrays(1))
            self._points(GL.GL_ARRAY_BUFFER, 400)
            GL.glEnableVertexAttribArray(0)
            GL.glVertexAttribPointer(0, 4, GL.GL_FLOAT, False, 0, None)
            GL.glUseProgram(self._shaders)
        while GL.glGetError():
            pass

    def _points(self, target: int, count: int) -> None:
        import numpy as np

        points = np.zeros((count, 4), "f")
        points[:, 0] = np.linspace(-1.1, 1.0, count)
        points[:, 1] = np.arange(count) % 2 - 0.4
        points[:, 2] = np.linspace(-0.5, 0.9, count)
        points[:, 3] = 1.0
        self.GL.glBindBuffer(target, self.GL.glGenBuffers(1))
        self.GL.glBufferData(target, points.nbytes, points, self.GL.GL_STATIC_DRAW)

    def _linked(self) -> int:
        GL = self.GL
        new = self._core
        name = int(GL.glCreateProgram())
        words = {
            "version": 150 if new else 120, "input": "in" if new else "attribute",
            "output": "out" if new else "varying", "colour": "shown" if new else "gl_FragColor",
            "declared": "out vec4 shown;" if new else "",
        }  # fmt: skip
        for kind, text in ((GL.GL_VERTEX_SHADER, VERTEX), (GL.GL_FRAGMENT_SHADER, FRAGMENT)):
            shader = GL.glCreateShader(kind)
            GL.glShaderSource(shader, text.format(**words))
            GL.glCompileShader(shader)
            GL.glAttachShader(name, shader)
        GL.glBindAttribLocation(name, 0, "place")
        varying = (ctypes.c_char_p * 1)(b"seen")
        varyings = ctypes.cast(varying, ctypes.POINTER(ctypes.POINTER(ctypes.c_char)))
        with suppress(Exception):
            GL.glTransformFeedbackVaryings(name, 1, varyings, GL.GL_INTERLEAVED_ATTRIBS)
        GL.glLinkProgram(name)
        return name

    def finish(self) -> None:
        self._end_condition()
        self._end_capture()
        for key in list(self._queries):
            self._end_query(*key)
        self._errors()
        self._log()
        self._results()
        self._picture()

    # -- steps -----------------------------------------------------------------------------------

    def step(self, chance: random.Random) -> None:
        """One of many."""
        weights: list[tuple[int, Callable[[random.Random], None]]] = [
            (8, self._draw), (3, self._clear), (3, self._swap), (6, self._begin_or_end_query),
            (2, self._condition_step), (2, self._capture_step), (3, self._error), (2, self._fetch),
            (1, lambda _: self._log()), (2, self._read), (2, self._message), (1, self._ask),
        ]  # fmt: skip
        if not self._core:
            weights += [
                (3, self._flat_draw), (2, self._list), (1, self._feedback), (2, self._quadric),
                (1, self._switch),
            ]  # fmt: skip
        steps = [each for count, each in weights for _ in range(count)]
        chance.choice(steps)(chance)

    def _draw(self, chance: random.Random) -> None:
        GL = self.GL
        count = chance.choice((3, 4, 7, 30, 140, 260))
        mode = chance.choice((4, 5, 5, 6, 1, 3, 0) if self._core else (4, 5, 5, 6, 7, 8, 9, 1, 3))
        self.say("draw", mode, count)
        if self._core or (self._capturing and self._shaders is not None):
            self._draw_arrays(self._kind if self._capturing and not self._paused else mode, count)
            return
        shift = chance.choice((0.0, 0.2, -0.4))
        self.tries("glBegin", mode)
        for i in range(count):
            if i % 3 == 0:
                GL.glColor4f(0.8, i / count, 0.3, i % 2)
            GL.glVertex3f(2.2 * i / count - 1.1 + shift, i % 2 - 0.4, i / count - shift)
        self.tries("glEnd")

    def _draw_arrays(self, mode: int, count: int) -> None:
        if self._core:
            self.tries("glDrawArrays", mode, 0, count)
            return
        self.tries("glBegin", mode)
        for i in range(count):
            self.GL.glVertexAttrib4f(0, 2.2 * i / count - 1.1, i % 2 - 0.4, i / count, 1.0)
        self.tries("glEnd")

    def _flat_draw(self, chance: random.Random) -> None:
        """What ends a layer: no depth test."""
        if self._capturing:
            return
        self.tries("glDisable", self.GL.GL_DEPTH_TEST)
        self._draw(chance)
        self.tries("glEnable", self.GL.GL_DEPTH_TEST)

    def _quadric(self, chance: random.Random) -> None:
        if self._capturing:
            return
        from OpenGL import GLU

        self.say("sphere")
        with suppress(self.GL.GLError):
            GLU.gluSphere(GLU.gluNewQuadric(), chance.choice((0.3, 0.6)), 8, 5)

    def _clear(self, chance: random.Random) -> None:
        mask = chance.choice((0x4100, 0x4000, 0x100, 0x4500))
        self.say("clear", mask)
        self.tries("glClear", mask)

    def _swap(self, chance: random.Random) -> None:
        self.say("swap")
        self._program.glfw.swap_buffers(self._handle)

    def _read(self, chance: random.Random) -> None:
        if chance.random() < 0.3:
            self.tries("glReadPixels", 0, 0, 4, 4, self.GL.GL_RGB, self.GL.GL_UNSIGNED_BYTE)
        else:
            self._picture()

    def _picture(self) -> None:
        import numpy as np

        pixels = self.tries("glReadPixels", 0, 0, SIZE, SIZE, self.GL.GL_RGB,
                            self.GL.GL_UNSIGNED_BYTE)  # fmt: skip
        if pixels is not None:
            self.say("picture", hash(np.asarray(pixels).tobytes()))

    def _switch(self, chance: random.Random) -> None:
        GL = self.GL
        name = chance.choice((GL.GL_ALPHA_TEST, GL.GL_LINE_STIPPLE, GL.GL_BLEND, GL.GL_LIGHTING,
                              GL.GL_CULL_FACE, GL.GL_LIGHT0))  # fmt: skip
        on = chance.random() < 0.6
        self.say("switch", name, on)
        self.tries("glEnable" if on else "glDisable", name)
        self.tries("glLineStipple", 1, 0xF0C1)
        self.tries("glAlphaFunc", GL.GL_GREATER, chance.choice((0.0, 0.5)))
        self.tries("glPolygonMode", GL.GL_FRONT_AND_BACK,
                   chance.choice((GL.GL_FILL, GL.GL_FILL, GL.GL_LINE)))  # fmt: skip

    # -- queries ---------------------------------------------------------------------------------

    def _begin_or_end_query(self, chance: random.Random) -> None:
        if self._queries and chance.random() < 0.5:
            self._end_query(*chance.choice(list(self._queries)))
            return
        self._begin_query(chance)

    def _begin_query(self, chance: random.Random) -> None:
        GL = self.GL
        target = chance.choice(self._targets)
        index = chance.choice((0, 0, 0, 1)) if "PRIMITIVES_GENERATED" in str(target) else 0
        name = self._made("glGenQueries")
        before = self._waiting()
        if index:
            self.tries("glBeginQueryIndexed", target, index, name)
        else:
            self.tries("glBeginQuery", target, name)
        open_now = ctypes.c_int()
        with suppress(GL.GLError):
            self._bare("glGetQueryIndexediv" if index else "glGetQueryiv")(
                *((int(target), index) if index else (int(target),)), GL.GL_CURRENT_QUERY,
                ctypes.byref(open_now),
            )  # fmt: skip
        self._forget_errors(before)
        self.say("query", target, index, open_now.value == name)
        if open_now.value == name:
            self._queries[int(target), index] = name

    def _end_query(self, target: int, index: int) -> None:
        name = self._queries.pop((target, index))
        if index:
            self.tries("glEndQueryIndexed", target, index)
        else:
            self.tries("glEndQuery", target)
        self.say("end query", target, index)
        self._done.append(name)
        if target != int(self.GL.GL_TIME_ELAPSED):
            self._result(name)

    def _result(self, name: int) -> None:
        value = ctypes.c_uint()
        self._bare("glGetQueryObjectuiv")(name, int(self.GL.GL_QUERY_RESULT), ctypes.byref(value))
        self.say("result", value.value)

    def _results(self) -> None:
        self.say(len(self._done), "queries")

    def _made(self, name: str) -> int:
        """The name of a new object."""
        made = ctypes.c_uint()
        self._bare(name)(1, ctypes.byref(made))
        return made.value

    def _bare(self, name: str) -> Any:
        """The driver's own function."""
        from OpenGL.platform import PLATFORM

        result = {"glRenderMode": ctypes.c_int, "glGetDebugMessageLog": ctypes.c_uint}.get(name)
        call = ctypes.CFUNCTYPE(result)(PLATFORM.getExtensionProcedure(name.encode()))
        return lambda *args: call(*(int(a) if hasattr(a, "__int__") else a for a in args))

    # -- conditional rendering -------------------------------------------------------------------

    def _condition_step(self, chance: random.Random) -> None:
        if self._condition:
            self._end_condition()
        elif self._done:
            mode = chance.choice(("WAIT", "NO_WAIT", "BY_REGION_WAIT", "WAIT_INVERTED"))
            name = self._done[-1] if chance.random() < 0.8 else 999
            self.say("condition", mode)
            before = self._waiting()
            self.tries("glFinish")
            self.tries("glBeginConditionalRender", name, getattr(self.GL, f"GL_QUERY_{mode}"))
            failed = bool(self._forget_errors(before))
            self._condition = not failed and not self.said_last("glBeginConditionalRender")
            self.say("begun", self._condition)

    def said_last(self, name: str) -> bool:
        return bool(self._program.said) and self._program.said[-1].startswith(name)

    def _end_condition(self) -> None:
        if self._condition:
            self.say("end condition")
            self.tries("glEndConditionalRender")
            self._condition = False

    # -- transform feedback ----------------------------------------------------------------------

    def _capture_step(self, chance: random.Random) -> None:
        GL = self.GL
        if self._capturing:
            if chance.random() < 0.4:
                self._paused = not self._paused
                self.say("paused", self._paused)
                self.tries("glPauseTransformFeedback" if self._paused
                           else "glResumeTransformFeedback")  # fmt: skip
            else:
                self._end_capture()
            return
        if self._shaders is None or not GL.glBeginTransformFeedback:
            return
        self._kind = chance.choice((GL.GL_TRIANGLES, GL.GL_POINTS))
        self.say("capture", self._kind)
        self.tries("glUseProgram", self._shaders)
        if not hasattr(self, "_room"):
            self._room = self._made("glGenBuffers")
            self.tries("glBindBuffer", GL.GL_TRANSFORM_FEEDBACK_BUFFER, self._room)
            self.tries("glBufferData", GL.GL_TRANSFORM_FEEDBACK_BUFFER, 1 << 16, None,
                       GL.GL_STATIC_DRAW)
        self.tries("glBindBufferBase", GL.GL_TRANSFORM_FEEDBACK_BUFFER, 0, self._room)
        self.tries("glBeginTransformFeedback", self._kind)
        self._capturing, self._paused = True, False

    def _end_capture(self) -> None:
        if not self._capturing:
            return
        GL = self.GL
        if self._paused:
            self.tries("glResumeTransformFeedback")
        self.tries("glEndTransformFeedback")
        self._capturing = self._paused = False
        if not self._core:
            self.tries("glUseProgram", 0)
        held = (ctypes.c_ubyte * (1 << 16))()
        self._bare("glGetBufferSubData")(
            int(GL.GL_TRANSFORM_FEEDBACK_BUFFER), ctypes.c_ssize_t(0), ctypes.c_ssize_t(1 << 16),
            held,
        )  # fmt: skip
        self.say("captured", hash(bytes(held)))

    # -- errors and messages ---------------------------------------------------------------------

    def _waiting(self) -> list[int]:
        """Errors that wait, which are told and wait no more."""
        found: list[int] = []
        error = self._bare_error()
        while error:
            found.append(error)
            error = self._bare_error()
        self.say("errors", found)
        return found

    _errors = _waiting

    def _forget_errors(self, _: Any) -> list[int]:
        return self._waiting()

    def _bare_error(self) -> int:
        from OpenGL.platform import PLATFORM

        return int(ctypes.CFUNCTYPE(ctypes.c_uint)(
            PLATFORM.getExtensionProcedure(b"glGetError"))())  # fmt: skip

    def _fetch(self, chance: random.Random) -> None:
        if chance.random() < 0.5:
            self._waiting()
        else:
            self.say("error", int(self.GL.glGetError()))

    def _error(self, chance: random.Random) -> None:
        GL = self.GL
        kind = chance.choice(("enum", "value", "operation", "over", "under", "framebuffer",
                              "memory"))  # fmt: skip
        bare = chance.random() < 0.4  # as C code does it: PyOpenGL checks nothing
        self.say("provokes", kind, bare)
        call = (lambda name, *args: self._bare(name)(*args)) if bare else self.tries
        if kind == "enum":
            call("glEnable", 0xFFFF)
        elif kind == "value":
            call("glClear", 0x800000)
        elif kind == "operation":
            call("glUseProgram", 0x7FFFFF)
        elif kind == "over" and not self._core:
            for _ in range(40):
                call("glPushMatrix")
        elif kind == "under" and not self._core:
            for _ in range(41):
                call("glPopMatrix")
        elif kind == "over":
            for _ in range(70):
                self._bare("glPushDebugGroup")(int(GL.GL_DEBUG_SOURCE_APPLICATION), 1, 1, b"x")
        elif kind == "under":
            for _ in range(70):
                self._bare("glPopDebugGroup")()
        elif kind == "memory":
            call("glBindBuffer", GL.GL_ARRAY_BUFFER, self._made("glGenBuffers"))
            self._bare("glBufferData")(
                int(GL.GL_ARRAY_BUFFER), ctypes.c_ssize_t((1 << 62) - 1), None,
                int(GL.GL_STATIC_DRAW),
            )  # fmt: skip
            call("glBindBuffer", GL.GL_ARRAY_BUFFER, 0)
        elif GL.glBindFramebuffer:
            made = self._made("glGenFramebuffers")
            call("glBindFramebuffer", GL.GL_FRAMEBUFFER, made)
            call("glClear", 0x4000)
            call("glBindFramebuffer", GL.GL_FRAMEBUFFER, 0)

    def _message(self, chance: random.Random) -> None:
        GL = self.GL
        if not GL.glDebugMessageInsert:
            return
        kind = chance.choice(("insert", "push", "pop"))
        self.say("message", kind)
        if kind == "insert":
            self.tries("glDebugMessageInsert", GL.GL_DEBUG_SOURCE_APPLICATION,
                       GL.GL_DEBUG_TYPE_OTHER, 7, GL.GL_DEBUG_SEVERITY_LOW, 2, b"hi")  # fmt: skip
        elif kind == "push":
            self.tries("glPushDebugGroup", GL.GL_DEBUG_SOURCE_APPLICATION, 3, 5, b"group")
        else:
            self.tries("glPopDebugGroup")

    def _log(self) -> None:
        get = self._bare("glGetDebugMessageLog")
        text, length = ctypes.create_string_buffer(4096), ctypes.c_int()
        kind, severity = ctypes.c_uint(), ctypes.c_uint()
        for _ in range(50):
            if not get(1, 4096, None, ctypes.byref(kind), None, ctypes.byref(severity),
                       ctypes.byref(length), text):  # fmt: skip
                break
            self.say("logged", kind.value, severity.value, text.raw[: length.value])

    def _ask(self, chance: random.Random) -> None:
        GL = self.GL
        for name in ("GL_DEBUG_OUTPUT", "GL_DEBUG_OUTPUT_SYNCHRONOUS",
                     "GL_DEBUG_GROUP_STACK_DEPTH", "GL_DEBUG_LOGGED_MESSAGES",
                     "GL_CURRENT_PROGRAM", "GL_TRANSFORM_FEEDBACK_ACTIVE",
                     "GL_TRANSFORM_FEEDBACK_PAUSED", "GL_VERTEX_ARRAY_BINDING"):  # fmt: skip
            value = ctypes.c_int(-1)
            self._bare("glGetIntegerv")(int(getattr(GL, name)), ctypes.byref(value))
            self.say(name, value.value if name != "GL_CURRENT_PROGRAM" else bool(value.value))

    # -- lists and feedback mode -----------------------------------------------------------------

    def _list(self, chance: random.Random) -> None:
        if self._capturing:
            return
        GL = self.GL
        if self._lists and chance.random() < 0.6:
            self.say("calls a list")
            self.tries("glCallList", chance.randint(1, self._lists))
            return
        self._lists += 1
        mode = chance.choice((GL.GL_COMPILE, GL.GL_COMPILE_AND_EXECUTE))
        self.say("list", mode)
        self.tries("glNewList", self._lists, mode)
        for _ in range(chance.randint(1, 4)):
            kind = chance.choice(("draw", "draw", "clear", "query", "condition"))
            if kind == "draw":
                self._draw(chance)
            elif kind == "clear":
                self._clear(chance)
            elif kind == "query" and self._done:
                target = chance.choice((GL.GL_SAMPLES_PASSED, GL.GL_PRIMITIVES_GENERATED))
                self.tries("glBeginQuery", target, self._done[0])
                self._draw(chance)
                if chance.random() < 0.7:
                    self.tries("glEndQuery", target)
            elif kind == "condition" and self._done:
                self.tries("glBeginConditionalRender", self._done[-1], GL.GL_QUERY_WAIT)
                self._draw(chance)
                self.tries("glEndConditionalRender")
        self.tries("glEndList")

    def _feedback(self, chance: random.Random) -> None:
        if self._capturing:
            return
        GL = self.GL
        chosen = chance.choice((GL.GL_FEEDBACK, GL.GL_SELECT))
        room = (ctypes.c_float * 8192)()
        names = (ctypes.c_uint * 64)()
        bare = {name: self._bare(name) for name in (
            "glFeedbackBuffer", "glSelectBuffer", "glInitNames", "glPushName", "glPopName",
        )}  # fmt: skip
        turn = self._bare("glRenderMode")
        bare["glFeedbackBuffer"](8192, int(GL.GL_3D), room)
        bare["glSelectBuffer"](64, names)
        turn(int(chosen))
        bare["glInitNames"]()
        bare["glPushName"](5)
        self._draw(chance)
        self._draw(chance)
        found = turn(int(GL.GL_RENDER))
        held = bytes(room)[: 4 * max(found, 0)] if chosen == GL.GL_FEEDBACK else bytes(names)
        self.say("tokens", int(chosen), found, hash(held))


if __name__ == "__main__":
    sys.exit(main())
