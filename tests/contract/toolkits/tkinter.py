"""Tk by tkinter: Togl, and pyopengltk's frames, on an interpreter that knows what they need."""

from __future__ import annotations

import functools
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.tkinter import FOLLOW, TAG, Tk

from .rig import SIZE, Rig

PATH = ".togl"


class Interpreter:
    """Tcl with Togl widgets, whose commands it traces."""

    def __init__(self, swap: Callable[[], int]) -> None:
        self.swap = swap
        self.current: dict[str, Callable[[], None]] = {}
        """What makes a widget current."""
        self.commands: dict[str, Callable[..., Any]] = {}
        self.traces: list[tuple[str, str]] = []
        """Of a widget, and the command that hears of its."""
        self.bindings: dict[str, str] = {}

    def eval(self, script: str) -> None:
        assert script in (FOLLOW, f"namespace eval {TAG} {{}}")

    def createcommand(self, name: str, function: Callable[..., Any]) -> None:
        self.commands[name] = function

    def splitlist(self, words: Any) -> tuple[str, ...]:
        return tuple(words.split()) if isinstance(words, str) else tuple(words)

    def call(self, *words: str) -> Any:
        if words == ("tk", "windowingsystem"):
            return "x11"
        if words[0] == "bind":
            self.bindings[words[2]] = words[3]
        elif words[:3] == ("trace", "add", "execution"):
            self.traces.append((words[3], words[-1].split()[-1]))
        elif words[:3] == ("trace", "remove", "execution"):
            self.traces.remove((words[3], words[-1].split()[-1]))
        elif words[1] == "swapbuffers":
            return self.traced("swapbuffers", self.swap, words[0])
        elif words[1] == "makecurrent":
            return self.traced("makecurrent", self.current[words[0]], words[0])
        return None

    def traced(self, command: str, work: Callable[[], Any], path: str = PATH) -> Any:
        """A widget's command."""
        names = [name for traced, name in self.traces if traced == path]
        for name in reversed(names):
            self.commands[name](f"{path} {command}", "enter")
        result, error = None, None
        try:
            result = work()
        except RuntimeError as failed:
            error = failed
        for name in names:
            code = "0" if error is None else "1"
            self.commands[name](f"{path} {command}", code, str(error or result), "leave")
        if error is not None:
            raise error
        return result

    def event(self, kind: str, keysym: str) -> bool:
        """Whether a binding of our tag keeps the event from the others."""
        script = self.bindings[kind].replace("%K", keysym).replace("%s", "0")
        name, *arguments = script[script.index("[") + 1 : script.index("]")].split()
        return bool(self.commands[name](*arguments))


class TkRig(Rig):
    takes_early = True

    def __init__(self, widget: str) -> None:
        super().__init__(Tk())
        self.widget_name, self.asked = widget, 0
        self.calls: list[Any] = []
        """What Tk is to call as soon as it can."""
        self.heard: list[float] = []
        self.tk = tk = Interpreter(self.shown)
        rig = self

        class Misc:
            tags: tuple[str, ...] = ("Togl", ".", "all")

            def bindtags(self, tagList: Any = None) -> Any:
                if tagList is None:
                    return self.tags
                self.tags = tuple(tagList)
                return None

            def after(self, ms: int, func: Any, *arguments: Any) -> Any:
                rig.calls.append(lambda: func(*arguments))
                return rig.calls[-1]

            def after_cancel(self, id: Any) -> None:
                rig.calls.remove(id)

        class BaseWidget(Misc):
            def __init__(self, widget_name: str, path: str = PATH) -> None:
                self.tk, self.widgetName, self.path, self.children = tk, widget_name, path, {}

            def __str__(self) -> str:
                return self.path

            def _root(self) -> Any:
                return self

            def winfo_width(self) -> int:
                return SIZE[0]

            def winfo_height(self) -> int:
                return SIZE[1]

            def winfo_ismapped(self) -> bool:
                return True

            def event_generate(self, event: str, when: str) -> None:
                assert (event, when) == ("<Expose>", "tail")
                rig.asked += 1

        class OpenGLFrame(BaseWidget):
            def tkSwapBuffers(self) -> int:
                return rig.shown()

        self.modules = {
            "tkinter": SimpleNamespace(Misc=Misc, BaseWidget=BaseWidget, TclError=RuntimeError),
            "pyopengltk": SimpleNamespace(OpenGLFrame=OpenGLFrame),
        }

    def take(self) -> None:
        togl = self.widget_name == "togl"
        self.kind = (
            self.modules["tkinter"].BaseWidget if togl else self.modules["pyopengltk"].OpenGLFrame
        )

    def open(self) -> None:
        self.window = self.kind(self.widget_name)

    def another(self) -> Any:
        """A second widget."""
        return self.kind(self.widget_name, f"{PATH}2")

    def present(self) -> Any:
        if self.widget_name == "togl":
            return self.tk.call(PATH, "swapbuffers")
        return self.window.tkSwapBuffers()

    def key(self, name: str, down: bool) -> None:
        assert TAG not in self.window.bindtags()
        tagged = TAG in self.window.tags
        keysym = name if len(name) > 1 else name.lower()
        if not (tagged and self.tk.event("<KeyPress>" if down else "<KeyRelease>", keysym)):
            self.got.append((name, down))

    def redraws(self) -> int:
        return self.asked

    def seconds(self) -> float:
        """The latest of timers for 0.02 s, 0.04 s and so on that has come."""
        if not self.heard:
            self.heard.append(0.0)
            for number in range(1, 100):
                self.modules["tkinter"].Misc().after(20 * number, self.heard.append, number / 50)
        calls, self.calls[:] = list(self.calls), []
        for call in calls:
            call()
        return max(self.heard)


RIGS: dict[str, Callable[[], Rig]] = {
    "Tk, Togl": functools.partial(TkRig, "togl"),
    "Tk, pyopengltk": functools.partial(TkRig, "frame"),
}
