"""GLUT by PyOpenGL: its swap, its callbacks and its main loop."""

from __future__ import annotations

import ctypes
import functools
from collections.abc import Callable, Iterable
from typing import Any

from glshim.bindings.pyopengl.raw import hook_function, original_call
from glshim.system.prototypes import function_type
from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Part, Toolkit
from glshim.toolkits.frames import Size
from glshim.toolkits.moment import MOMENT, STEP, Moment, real_clock, real_sleep

# From GLUT's header, where they are the stable ABI of every implementation.
GLUT_WINDOW_WIDTH, GLUT_WINDOW_HEIGHT, GLUT_WINDOW_DOUBLEBUFFER = 102, 103, 115
_SPECIAL = {
    **{n: f"F{n}" for n in range(1, 13)},
    104: "PageUp", 105: "PageDown", 106: "Home", 107: "End", 108: "Insert",
}  # fmt: skip
"""GLUT_KEY_F1 and so on."""
_MODIFIERS = {"shift": 1, "ctrl": 2, "alt": 4}
"""GLUT_ACTIVE_SHIFT and so on."""
SETTLE = 12
"""Rounds of GLUT's main loop before the first display: the window comes up."""
COMES_UP = 2.0
"""Real seconds that a program is given after that for its first picture."""
QUIET = 40
"""Rounds without a new picture after which a program stands still."""
HELD_QUIET = 3
"""Rounds without one, while a moment is held, after which a program draws in its idle function."""


_TIMER = function_type(None, ctypes.c_int)


class Glut(Toolkit):
    """It calls back from C: an exception would be printed there and the loop go on."""

    name, package, distribution = "GLUT", "OpenGL", "PyOpenGL"
    may_raise = False
    tested = "freeglut 3 on X"

    def __init__(self, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self._windows: set[int] = set()
        """Those that may be asked for another frame."""
        self._module: Any = None
        self._callbacks: dict[tuple[int, str], Any] = {}
        """Of ours, by window and kind: C holds them, so they stay."""
        self._timer: Any = None
        self._timers: list[Any] = []
        """C holds them."""
        self._pause = frames.RESTS
        self._starts: list[Callable[[], None]] = []
        """What gives a window callbacks of ours where the app asks for no keys."""

    def hooks(self) -> Iterable[Hook]:
        special = "OpenGL.GLUT.special"
        yield Hook(Part.FRAMES, "OpenGL.raw.GLUT", self.hook_swap, "glutSwapBuffers")
        yield Hook(
            Part.FRAMES, special, self.hook_display,
            "the return of the display callback (single-buffered)",
        )  # fmt: skip
        yield Hook(Part.KEYS, special, self.hook_keys, "glutKeyboardFunc, glutSpecialFunc")
        yield Hook(Part.CLOCK, "OpenGL.GLUT", self.hold_clock, "timers, the idle function")

    def size(self, window: Any) -> Size:
        get = _library().glutGet
        return get(GLUT_WINDOW_WIDTH), get(GLUT_WINDOW_HEIGHT)

    def redraw(self) -> None:
        for window in self._windows:
            _library().glutPostWindowRedisplay(window)

    def window_is_there(self) -> None:
        window = _library().glutGetWindow() if self._module.INITIALIZED else 0
        if window:
            self._windows.add(window)
            for start in self._starts:
                start()

    # -- frame ends ------------------------------------------------------------------------------

    def hook_swap(self, module: Any, changes: Changes) -> None:
        if not module.glutSwapBuffers:  # GLUT is not installed
            return
        function = _unlogged(module.glutSwapBuffers)
        swap = original_call(function)
        hook_function(function, functools.partial(frames.present, swap, on=self.drawable()))
        changes.add(lambda: hook_function(function, None))

    def hook_display(self, module: Any, changes: Changes) -> None:
        """Single-buffered windows: the frame ends when the display callback returns, unless it
        ended at a glFlush before."""
        register = module.glutDisplayFunc
        plain = register.wrappedOperation

        def wrapped_operation(callback: Any, *arguments: Any) -> None:
            if callable(callback):
                # A second callback around the app's: what PyOpenGL prints of an exception in the
                # app's own stays as it is. It lives exactly as long as the app's.
                callback.glshim_outer = type(callback)(functools.partial(self._display, callback))
                plain(callback.glshim_outer, *arguments)
            else:
                plain(callback, *arguments)

        changes.set(register, "wrappedOperation", wrapped_operation)

    def _display(self, callback: Callable[[], None]) -> None:
        before = frames.presented()
        with frames.drawing(self.drawable()):
            callback()
            if frames.presented() == before and not _library().glutGet(GLUT_WINDOW_DOUBLEBUFFER):
                frames.present(_shown_already)
        if frames.more_are_wanted():
            self._ask_later()

    def _ask_later(self) -> None:
        """Have the window drawn again, where it rests: GLUT cannot be asked from another thread."""
        library = _library()
        self._windows.add(library.glutGetWindow())
        if self._timer is None:
            shown = frames.presented()

            def due(_value: int) -> None:
                # One that shows frames by itself is left more time than one that waits to be asked.
                rested, self._timer = frames.presented() == shown, None
                self._pause = frames.ASKED_AGAIN if rested else frames.RESTS
                if rested:
                    self.redraw()

            self._timer = _TIMER(due)
            self._timers.append(self._timer)
            del self._timers[:-2]  # the one that runs now may be the last
            library.glutTimerFunc(round(self._pause * 1000), self._timer, 0)

    # -- keys ------------------------------------------------------------------------------------

    def hook_keys(self, module: Any, changes: Changes) -> None:
        if not hasattr(_library(), "glutGetModifiers"):  # nor where there is no GLUT
            return
        self._module = module
        self._starts = [
            self._hook_key(module, changes, "Special", _special_name),
            self._hook_key(module, changes, "Keyboard", _typed_name),
        ]
        self._hook_key(module, changes, "SpecialUp", _special_name, up=True)
        self._hook_key(module, changes, "KeyboardUp", _typed_name, up=True)

    def _hook_key(
        self, module: Any, changes: Changes, kind: str, name_of: Callable[[Any], str | None],
        *, up: bool = False,
    ) -> Callable[[], None]:  # fmt: skip
        """Put ours around the app's callbacks of one kind; gives what starts it in a window where
        the app asks for no keys."""
        library, callbacks = _library(), self._callbacks
        register = getattr(module, f"glut{kind}Func")
        plain = register.wrappedOperation

        def is_ours(key: Any) -> bool:
            name = name_of(key)
            if up:
                return keyboard.released(name)
            held = keyboard.modifiers(library.glutGetModifiers(), _MODIFIERS)
            return keyboard.pressed(name, held)

        def outer(callback: Any, key: Any, x: int, y: int) -> None:
            if not is_ours(key) and callback is not None:
                callback(key, x, y)

        def wrapped_operation(callback: Any, *arguments: Any) -> None:
            if callable(callback):
                # It lives as long as the app's own, inside which Python prints what that raises.
                callback.glshim_outer = type(callback)(functools.partial(outer, callback))
                plain(callback.glshim_outer, *arguments)
                callbacks[library.glutGetWindow(), kind] = None
            elif keyboard.listening():
                add(library.glutGetWindow())
            else:
                plain(callback, *arguments)

        def add(window: int) -> None:
            ours = register.callbackType(functools.partial(outer, None))
            callbacks[window, kind] = ours
            plain(ours)

        def start() -> None:
            window = library.glutGetWindow()
            if window and (window, kind) not in callbacks:
                add(window)

        changes.set(register, "wrappedOperation", wrapped_operation)
        return start

    # -- clock -----------------------------------------------------------------------------------

    def hold_clock(self, module: Any, changes: Changes) -> None:
        """The idle function, timers and GLUT_ELAPSED_TIME by the moment."""

        def draw_again() -> None:
            """A program that draws on demand: its picture is asked for once more."""
            loop.quiet = 0
            loop.redisplay()

        loop = GlutLoop(module, self.moment, draw_again)
        loop.serve(changes)


def _library() -> Any:
    from OpenGL.platform import PLATFORM

    return PLATFORM.GLUT


def _unlogged(function: Any) -> Any:
    """The ctypes object inside PyOpenGL's logging proxies, which keep it under no name."""
    while not hasattr(type(function), "_flags_"):
        function = getattr(function, "")
    return function


def _shown_already() -> None:
    """A single-buffered window shows what is drawn as it is drawn."""


def _special_name(key: int) -> str | None:
    return _SPECIAL.get(key)


def _typed_name(key: bytes) -> str | None:
    """Ctrl and a letter come as a control character."""
    code = key[0] + ord("a") - 1 if 1 <= key[0] <= 26 and key not in b"\b\t\r" else key[0]
    name = chr(code).upper()
    return name if name in keyboard.NAMES else None


class GlutLoop:
    """GLUT's idle function, timers and clock, served from one pump in a fixed order.

    freeglut calls idle functions and timers as often as real time allows, and displays when the
    window happens to be exposed. The pump waits until the window has settled, then serves one round
    after another: clock, due timers, the program's idle function, a redisplay if one was asked for.
    """

    def __init__(self, glut: Any, moment: Moment, quiet: Callable[[], None]) -> None:
        """quiet: called when the program has shown nothing new for `QUIET` rounds."""
        self.glut, self.moment, self.when_quiet = glut, moment, quiet
        self.round = 0
        self.quiet = 0
        self.shown = 0
        self.patient_until = 0.0
        self.idle: Callable[[], None] | None = None
        self.timers: list[tuple[float, int, Callable[[int], None], int]] = []
        self.windows: set[int] = set()
        """Those that were to be displayed."""
        names = ("glutDisplayFunc", "glutIdleFunc", "glutTimerFunc", "glutMainLoop", "glutGet",
                 "glutPostRedisplay", "glutSetWindow", "glutGetWindow",
                 "glutMainLoopEvent")  # fmt: skip
        self.real = {name: getattr(glut, name, None) for name in names}
        self.replacements: dict[str, Callable[..., Any]] = {
            "glutIdleFunc": self.set_idle, "glutTimerFunc": self.add_timer,
            "glutDisplayFunc": self.set_display, "glutMainLoop": self.main_loop,
            "glutGet": self.get, "glutMainLoopEvent": self.main_loop_event,
        }  # fmt: skip
        """What the program gets for GLUT's own."""
        self.elapsed = glut.GLUT_ELAPSED_TIME

    def serve(self, changes: Changes) -> None:
        """Stand in for GLUT's own functions."""
        for name, replacement in self.replacements.items():
            changes.set(self.glut, name, replacement)

    def set_idle(self, function: Callable[[], None] | None = None) -> None:
        """glutIdleFunc."""
        self.idle = function

    def add_timer(self, milliseconds: int, function: Callable[[int], None], value: int = 0) -> None:
        """glutTimerFunc."""
        due = self.moment.now + milliseconds / 1000
        self.timers.append((due, len(self.timers), function, value))

    def set_display(self, function: Callable[[], None]) -> None:
        """glutDisplayFunc."""

        def display() -> None:
            self.windows.add(self._call("glutGetWindow"))
            if self.round >= SETTLE:
                function()

        self._call("glutDisplayFunc", display)

    def get(self, what: Any) -> Any:
        """glutGet."""
        if what == self.elapsed:
            return int(self.moment.now * 1000)
        return self._call("glutGet", what)

    def main_loop(self) -> None:
        """glutMainLoop."""
        self._call("glutIdleFunc", self.pump)
        self._call("glutMainLoop")

    def main_loop_event(self) -> None:
        """glutMainLoopEvent: the program has a loop of its own."""
        self._call("glutMainLoopEvent")
        self.pump()

    def redisplay(self) -> None:
        """Have every window drawn again."""
        for window in sorted(self.windows):
            self._call("glutSetWindow", window)
            self._call("glutPostRedisplay")

    def pump(self) -> None:
        """One round."""
        self.round += 1
        if self.round < SETTLE:
            real_sleep(0.01)
            return
        if self.round == SETTLE:
            self.redisplay()
            self.patient_until = real_clock() + COMES_UP
            return
        if not self.moment.frames and real_clock() < self.patient_until:
            real_sleep(0.001)  # a busy machine shows a window late: no time passes until then
            return
        self.quiet = 0 if self.moment.frames != self.shown else self.quiet + 1
        if self.quiet == 0:
            self.shown = self.moment.frames
        else:
            self.moment.pass_by(STEP)  # nothing was shown: a frame's time passes all the same
            real_sleep(0.001)
        if self.quiet > QUIET:
            self.when_quiet()
        if self.moment.held and self.quiet <= HELD_QUIET:
            self.redisplay()  # the same picture: what timers and idle functions change waits
            return
        due = sorted(t for t in self.timers if t[0] <= self.moment.now + 1e-9)
        self.timers = [t for t in self.timers if t not in due]
        for _, _, function, value in due:
            function(value)
        if self.idle is not None:
            self.idle()

    def _call(self, name: str, *arguments: Any) -> Any:
        function = self.real[name]
        return function(*arguments) if function is not None else None


TOOLKITS = (Glut(),)
