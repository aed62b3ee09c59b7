"""Tk by tkinter: Togl widgets (PyOpenGL's `OpenGL.Tk`, programs with a Togl of their own) and
pyopengltk's frames.

Togl swaps inside C, at the Tcl command ``WIDGET swapbuffers``: a trace on the widget's command
tells before and after. Keys come by a bind tag before all others of a widget.
"""

from __future__ import annotations

import ctypes
import functools
import sys
import weakref
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from types import FrameType
from typing import Any

from glshim.system.interrupts import Held, raiser
from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Part, Toolkit
from glshim.toolkits.frames import Drawable, Size
from glshim.toolkits.moment import MOMENT, Alarm, Moment

SWAP, MAKE_CURRENT = "swapbuffers", "makecurrent"
TAG = "glshim"
"""The bind tag of our keys; Tcl commands of ours lie in a namespace of that name."""
RAISED: list[BaseException] = []
"""By signal handlers of the app's while a trace runs: it is to leave the app's own call of Togl,
once that is over."""
TRIES = 9
"""Signals of the app's that may come, one after another, as a trace begins."""
FOLLOW = f"""namespace eval {TAG} {{
    proc follow {{name args}} {{
        set tries {TRIES}
        while {{[incr tries -1] && [catch {{$name {{*}}$args}} left]}} {{catch caught}}
        if {{$left eq "late"}} late
    }}
}}"""
"""What a trace calls: a handler of the app's may raise before the first bytecode of ours."""
LOOK = 5
"""Milliseconds between two looks at a clock that stands still."""
_KEYS = {
    **{name: name for name in keyboard.NAMES}, **{name.lower(): name for name in keyboard.NAMES},
    "Prior": "PageUp", "Next": "PageDown",
}  # fmt: skip
"""By Tk's keysym."""
_MODIFIERS = {
    "x11": {"shift": 1, "ctrl": 4, "alt": 8},
    "win32": {"shift": 1, "ctrl": 4, "alt": 0x20000},
    "aqua": {"shift": 1, "ctrl": 4, "alt": 0x10},
}
"""Bits of an event's state, by windowing system."""


class Tk(Toolkit):
    """Togl's frames end inside a command of Tcl's, where an exception becomes an error of Tcl's."""

    name, package = "Tk", "tkinter"
    may_raise = False
    tested = "Togl 2.0, LinuxCNC's Togl and pyopengltk 0.0.4 on X"

    def __init__(self, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self._widgets: weakref.WeakSet[Any] = weakref.WeakSet()
        """Those that end frames."""
        self._tagged: weakref.WeakSet[Any] = weakref.WeakSet()
        """Those that have the tag of our keys."""
        self._bindtags: Callable[..., Any] | None = None
        """Tkinter's own, while ours is in its place."""
        self._togls: weakref.WeakKeyDictionary[Any, Togl] = weakref.WeakKeyDictionary()
        self.contexts: weakref.WeakKeyDictionary[Any, int] = weakref.WeakKeyDictionary()
        """The contexts of Togl widgets that were made current, by widget."""
        self._after: Callable[..., Any] | None = None
        """Tkinter's own, while ours is in its place."""
        self._looks = self._is_asked = False
        """For another frame, by another thread: what looks after that is there; it was."""

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "tkinter", self.hook_togl, "Togl's command swapbuffers")
        yield Hook(Part.FRAMES, "pyopengltk", self.hook_frame, "OpenGLFrame.tkSwapBuffers")
        yield Hook(Part.KEYS, "tkinter", self.hook_tags, "a bind tag")
        yield Hook(Part.CLOCK, "tkinter", self.hold_clock, "after")

    def size(self, widget: Any) -> Size:
        return widget.winfo_width(), widget.winfo_height()

    def redraw(self) -> None:
        """Expose the widgets, for which they bind a redraw."""
        for widget in tuple(self._widgets):
            with suppress(Exception):  # it may be gone
                widget.event_generate("<Expose>", when="tail")

    def leave(self) -> bool:
        """`mainloop` returns, where one of Python's runs."""
        tkinter: Any = sys.modules["tkinter"]
        loops = (tkinter.Misc.mainloop.__code__, tkinter.mainloop.__code__)
        frame: FrameType | None = sys._getframe()
        while frame is not None and frame.f_code not in loops:
            frame = frame.f_back
        widget = next(iter(self._widgets), None)
        if frame is None or widget is None:
            return False
        widget.quit()
        return True

    def drawable(self, widget: Any = None) -> Drawable:
        self._widgets.add(widget)
        if self._after is not None and not self._looks:
            self._looks = True
            self._look(widget)
        return super().drawable(widget)

    # -- frame ends ------------------------------------------------------------------------------

    def hook_togl(self, module: Any, changes: Changes) -> None:
        """Every class of widgets begins in this one."""
        plain = module.BaseWidget.__init__

        @functools.wraps(plain)
        def begin(widget: Any, *arguments: Any, **named: Any) -> None:
            plain(widget, *arguments, **named)
            if getattr(widget, "widgetName", None) == "togl":
                with Held(), suppress(module.TclError):
                    togl = self._togls[widget] = Togl(widget, self)
                    togl.follow()

        changes.set(module.BaseWidget, "__init__", begin)
        for togl in tuple(self._togls.values()):  # it was hooked before
            togl.follow()
        changes.add(self._leave_togls)

    def _leave_togls(self) -> None:
        for togl in tuple(self._togls.values()):
            togl.leave()

    def hook_frame(self, module: Any, changes: Changes) -> None:
        plain = module.OpenGLFrame.tkSwapBuffers

        @functools.wraps(plain)
        def swap_buffers(frame: Any) -> Any:
            if not frame.winfo_ismapped():  # then it shows nothing
                return plain(frame)
            on = replace(self.drawable(frame), may_raise=True)  # Python calls it
            return frames.present(plain, frame, on=on)

        changes.set(module.OpenGLFrame, "tkSwapBuffers", swap_buffers)

    # -- keys ------------------------------------------------------------------------------------

    def hook_tags(self, module: Any, changes: Changes) -> None:
        """Ask for the tags of a widget, or set them, without ours."""
        plain = self._bindtags = module.Misc.bindtags

        @functools.wraps(plain)
        def bindtags(widget: Any, tagList: Any = None) -> Any:
            if widget not in self._tagged:
                return plain(widget, tagList)
            if tagList is None:
                return tuple(tag for tag in plain(widget) if tag != TAG)
            return plain(widget, (TAG, *widget.tk.splitlist(tagList)))

        changes.set(module.Misc, "bindtags", bindtags)
        changes.add(self._untag)

    def window_is_there(self) -> None:
        for root in {widget._root() for widget in tuple(self._widgets)}:
            with suppress(Exception):  # it may be gone, or belong to another thread
                self._bind(root)
                for widget in _below(root):
                    if widget not in self._tagged:
                        self._tag(widget)

    def _bind(self, root: Any) -> None:
        """What the tag of our keys does."""
        if root in self._tagged:
            return
        modifiers = _MODIFIERS[root.tk.call("tk", "windowingsystem")]

        def is_ours(down: str, keysym: str, state: str) -> bool:
            name = _KEYS.get(keysym)
            if down == "0":
                return keyboard.released(name)
            return keyboard.pressed(name, keyboard.modifiers(int(state), modifiers))

        root.tk.eval(f"namespace eval {TAG} {{}}")
        root.tk.createcommand(f"::{TAG}::key", is_ours)
        for down, event in enumerate(("<KeyRelease>", "<KeyPress>")):
            root.tk.call("bind", TAG, event, f"if {{[::{TAG}::key {down} %K %s]}} break")

    def _tag(self, widget: Any) -> None:
        assert self._bindtags is not None
        self._bindtags(widget, (TAG, *self._bindtags(widget)))
        self._tagged.add(widget)

    def _untag(self) -> None:
        tagged, plain = tuple(self._tagged), self._bindtags
        self._tagged.clear()
        for widget in tagged:
            with suppress(Exception):  # it may be gone
                if plain is not None:
                    plain(widget, tuple(tag for tag in plain(widget) if tag != TAG))


    # -- clock -----------------------------------------------------------------------------------

    def hold_clock(self, module: Any, changes: Changes) -> None:
        """`after` by the moment: Tk looks often whether that is there."""
        moment, kind = self.moment, module.Misc
        plain, plain_cancel = self._after, _ = kind.after, kind.after_cancel
        waiting: dict[Any, list[Any]] = {}
        """By what the program was given for it: the alarm, and what Tk gave last."""

        @functools.wraps(plain)
        def after(widget: Any, ms: Any, func: Any = None, *arguments: Any, **named: Any) -> Any:
            if func is None:
                moment.pass_by(int(ms) / 1000)
                return None
            if ms == "idle" or (not int(ms) and not moment.frames):
                return plain(widget, ms, func, *arguments, **named)
            alarm = Alarm(moment, int(ms) / 1000)

            @functools.wraps(func, assigned=("__name__",), updated=())
            def look() -> None:
                if alarm.comes(again=False):
                    waiting.pop(given, None)
                    func(*arguments, **named)
                else:
                    waiting[given][1] = plain(widget, LOOK, look)

            given = plain(widget, LOOK, look)
            waiting[given] = [alarm, given]
            return given

        @functools.wraps(plain_cancel)
        def after_cancel(widget: Any, id: Any) -> Any:
            alarm, last = waiting.pop(id, (None, id))
            if alarm is not None:
                alarm.stop()
            return plain_cancel(widget, last)

        changes.set(kind, "after", after)
        changes.set(kind, "after_cancel", after_cancel)

    def redraw_from_a_thread(self) -> None:
        self._is_asked = True

    def _look(self, widget: Any) -> None:
        """Expose the widgets once another thread asks for that."""
        if self._is_asked:
            self._is_asked = False
            self.redraw()
        with suppress(Exception):  # it may be gone
            assert self._after is not None
            self._after(widget, LOOK, self._look, widget)


class Togl:
    """One Togl widget, whose command of Tcl's is followed."""

    def __init__(self, widget: Any, toolkit: Tk) -> None:
        """May raise TclError."""
        self._widget, self._toolkit = weakref.ref(widget), toolkit
        self._tk, self._path, self._name = widget.tk, str(widget), f"::{TAG}::{id(self)}"
        self._ending = frames.Ending()
        self._other: Any = None
        """The widget that is current while this one's picture is shown, if that is another."""
        self._tk.eval(FOLLOW)
        self._tk.createcommand(f"::{TAG}::caught", self._catch)
        self._tk.createcommand(self._name, self._traced)
        gone = f"rename {self._name} {{}} ;#"
        self._tk.call("trace", "add", "command", self._path, "delete", gone)

    def follow(self) -> None:
        """Hear of its commands."""
        with suppress(Exception):  # it may be gone
            self._call_trace("add")

    def leave(self) -> None:
        """Hear of them no more."""
        with suppress(Exception):  # it may be gone
            self._call_trace("remove")

    def _call_trace(self, what: str) -> None:
        self._tk.call("trace", what, "execution", self._path, "enter leave",
                      f"::{TAG}::follow {self._name}")

    def _traced(self, command: str, *how: str) -> str:
        """What is left to do: nothing, or to raise what a signal handler of the app's raised."""
        widget, words = self._widget(), self._tk.splitlist(command)
        if widget is None or len(words) < 2:
            return ""
        leaves, fails = how[-1] == "leave", how[0] not in ("0", "enter")
        # Togl takes the beginning of a word for the word.
        if MAKE_CURRENT.startswith(words[1]) and leaves and not fails:
            self._toolkit.contexts[widget] = _context()
        elif SWAP.startswith(words[1]):
            try:
                if leaves:
                    self._finish(RuntimeError(how[1]) if fails else None)
                else:
                    self._begin(widget)
            except BaseException as error:  # Tcl would make an error of its own of it
                RAISED.append(error)
            if leaves and RAISED:
                self._tk.createcommand(f"::{TAG}::late", raiser(RAISED[0]))
                RAISED.clear()
                return "late"
        return ""

    def _catch(self) -> None:
        """Take back what tkinter keeps for its main loop: a loop that ends at once raises it."""
        try:
            self._tk.mainloop(sys.maxsize >> 32)
        except BaseException as error:
            RAISED.append(error)

    def _begin(self, widget: Any) -> None:
        self._other = self._other_than(widget) if frames.listening() else None
        if self._other is not None:
            _be_current(widget)
        self._ending.begin(self._toolkit.drawable(widget))

    def _finish(self, error: Exception | None) -> None:
        try:
            self._ending.finish(error)
        finally:
            _be_current(self._other)

    def _other_than(self, widget: Any) -> Any:
        """What is current when it is not the widget that is to be shown: Togl shows any, and a
        frame ends in the context of its own widget."""
        contexts, current = self._toolkit.contexts, _context()
        if contexts.get(widget, current) == current:
            return None
        return next((each for each, context in contexts.items() if context == current), None)


def _context() -> int:
    """The address of the current context, 0 without one."""
    platform: Any = sys.modules.get("OpenGL.platform")
    current = platform and platform.PLATFORM.GetCurrentContext()
    return (ctypes.cast(current, ctypes.c_void_p).value if current else 0) or 0


def _be_current(widget: Any) -> None:
    if widget is not None:
        widget.tk.call(str(widget), MAKE_CURRENT)


def _below(widget: Any) -> Iterator[Any]:
    """A widget and all of its children's, as Python knows them."""
    yield widget
    for child in tuple(widget.children.values()):
        yield from _below(child)


TOOLKITS = (Tk(),)
