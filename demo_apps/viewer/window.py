"""The window: its keys, its mouse, what is dropped on it, and each frame."""

import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import glfw
from OpenGL import GL

from ..shapes import SHAPES
from .lists import Sent
from .loading import Loading
from .models import ModelError, load, up_of
from .overlay import Overlay
from .prepare import Ready, prepared
from .view import BACKGROUND, Colour, View, set_up

AT_ONCE = 0.5  # seconds that a model may take before the window says so
SENDING = 0.03  # seconds of each frame that go into sending a model, or one list
SMALL = 100_000  # triangles that are sent within a frame


@dataclass(frozen=True, slots=True)
class Key:
    """A key, by the names of glfw's keys without KEY_, what it does, and its line of help."""

    names: tuple[str, ...]
    shown: str
    help: str
    does: Callable[[], Any]


STYLE_KEYS = {"cycle": ("F9", "next style"), "back": ("shift+F9", "previous style"),
              "toggle": ("F10", "toggle styling"), "save": ("F11", "save picture"),
              "overlay": ("F12", "style info")}
"""What the restyling that the environment asks for takes up, and by which keys unless it says."""


def style_keys(asked: str) -> list[tuple[str, str]]:
    """Lines of help for the keys that are not the viewer's: GLSHIM_KEYS, ``on`` or
    ``action=key,action=key``."""
    if asked.strip().lower() in ("", "off", "no", "false", "0"):
        return []
    keys = dict(STYLE_KEYS)
    for assignment in asked.split(","):
        action, equals, key = (part.strip() for part in assignment.partition("="))
        if equals and action in keys:
            keys[action] = (key, keys[action][1])
    return [(key, does) for key, does in keys.values() if key.lower() != "off"]


class Window:
    """A glfw window with a model in it."""

    def __init__(self, title: str, up: str | None = None,
                 background: Colour = BACKGROUND) -> None:
        """up: the axis of models that points up, x, y or z; None: what their format says."""
        glfw.ERROR_REPORTING = "ignore"  # what goes wrong is told in one line below
        if not glfw.init():
            raise ModelError("cannot open a window: there is no display")
        self.view = View()
        self.handle = glfw.create_window(*self.view.size, title, None, None)
        if not self.handle:
            glfw.terminate()
            raise ModelError("cannot open a window with OpenGL")
        glfw.make_context_current(self.handle)
        glfw.swap_interval(1)
        self.view.size = glfw.get_framebuffer_size(self.handle)
        set_up(background)
        self.up = up
        self.overlay = Overlay()
        self.sent: Sent | None = None
        self.name = ""
        self.loading: Loading | None = None
        self.coming: tuple[str, Sent] | None = None
        self.message = ""
        self.wires = self.axes = self.helps = self.facts = False
        self._now = self._begun = time.perf_counter()
        self.keys = self._table()
        self._connect()

    # -- models ----------------------------------------------------------------------------------

    def open(self, name: str) -> None:
        """A shape or a file, in place of what is shown; what is wrong with it is said in the window
        and on the terminal, and what is shown stays."""
        self._forget_what_comes()
        self.message = ""
        try:
            if name in SHAPES:
                self.show(name, prepared(load(name)))
            else:
                self.loading, self._begun = Loading(name), time.perf_counter()
        except ModelError as fault:
            self._say(fault)

    def show(self, name: str, model: Ready) -> None:
        """Send a model: a small one now, a large one once the bar says so. It is shown when all of
        it is sent."""
        self.coming = name, Sent(model)
        if model.triangles <= SMALL:
            self.send_all()

    def drop(self, paths: "list[str]") -> None:
        """Files that were dropped on the window: the first."""
        if paths:
            self.open(paths[0])

    def step_shapes(self, steps: int) -> None:
        names = list(SHAPES)
        here = names.index(self.name) if self.name in names else -1 if steps > 0 else 0
        self.open(names[(here + steps) % len(names)])

    def _poll(self) -> None:
        if self.loading is not None:
            try:
                model = self.loading.poll()
            except ModelError as fault:
                self.loading = None
                self._say(fault)
                return
            if model is not None:
                name, self.loading = self.loading.name, None
                self.show(name, model)
        elif self.coming is not None:
            self._send(SENDING)

    def send_all(self) -> None:
        """All of what comes, before the next frame."""
        self._send(float("inf"))

    def _send(self, seconds: float) -> None:
        assert self.coming is not None
        name, sent = self.coming
        end = time.perf_counter() + seconds
        while sent.share < 1.0 and time.perf_counter() < end:
            sent.send()
        if sent.share >= 1.0:
            if self.sent is not None:
                self.sent.delete()
            self.coming, self.sent, self.name = None, sent, name
            self.view.up = self.up or up_of(name)
            glfw.set_window_title(self.handle, f"{Path(name).name} (h: help)")
            os.environ["GLSHIM_NAME"] = Path(name).stem  # for pictures that a key saves

    def _forget_what_comes(self) -> None:
        if self.loading is not None:
            self.loading.stop()
            self.loading = None
        if self.coming is not None:
            self.coming[1].delete()
            self.coming = None

    def _say(self, fault: ModelError) -> None:
        self.message = str(fault)
        if self.sent is None:
            raise fault
        print(f"viewer: {fault}", flush=True)

    # -- keys and mouse --------------------------------------------------------------------------

    def _table(self) -> tuple[Key, ...]:
        view = self.view
        return (
            Key(("H", "F1"), "h, F1", "help", lambda: self._turn("helps")),
            Key(("I",), "i", "model info", lambda: self._turn("facts")),
            Key(("W",), "w", "wireframe", lambda: self._turn("wires")),
            Key(("T", "SPACE"), "t, space", "turntable", lambda: self._turn("turns", view)),
            Key(("P",), "p", "perspective or parallel", lambda: self._turn("parallel", view)),
            Key(("A",), "a", "axes", lambda: self._turn("axes")),
            Key(("U",), "u", "next up axis", view.next_up),
            Key(("L",), "l", "next light", view.next_light),
            Key(("N", "PAGE_DOWN"), "n, page down", "next shape", lambda: self.step_shapes(1)),
            Key(("B", "PAGE_UP"), "b, page up", "previous shape", lambda: self.step_shapes(-1)),
            Key(("1",), "1, 2, 3", "front, right, top view", lambda: view.look_from("front")),
            Key(("2",), "", "", lambda: view.look_from("right")),
            Key(("3",), "", "", lambda: view.look_from("top")),
            Key(("LEFT",), "arrows", "orbit", lambda: view.orbit(-5.0, 0.0)),
            Key(("RIGHT",), "", "", lambda: view.orbit(5.0, 0.0)),
            Key(("UP",), "", "", lambda: view.orbit(0.0, -5.0)),
            Key(("DOWN",), "", "", lambda: view.orbit(0.0, 5.0)),
            Key(("EQUAL", "KP_ADD"), "+, -", "zoom in, out", lambda: view.zoom(1)),
            Key(("MINUS", "KP_SUBTRACT"), "", "", lambda: view.zoom(-1)),
            Key(("R",), "r", "reset view", view.reset),
            Key(("ESCAPE",), "ESC", "quit", lambda: glfw.set_window_should_close(self.handle, 1)),
        )

    def help(self) -> str:
        """The keys, a line each, and the mouse."""
        rows = [(key.shown, key.help) for key in self.keys if key.shown]
        rows += [("drag", "orbit"), ("right drag", "pan"), ("wheel", "zoom in, out"),
                 ("drop a file", "open it")]
        rows += style_keys(os.environ.get("GLSHIM_KEYS", ""))
        return "\n".join(f"{shown}\t{does}" for shown, does in rows)

    def about(self) -> str:
        """The facts."""
        if self.sent is None:
            return ""
        model = self.sent.model
        size = " x ".join(f"{side:.4g}" for side in model.size)
        projection = "parallel" if self.view.parallel else "perspective"
        return (f"{Path(self.name).name}\n{model.triangles:,} triangles\n{size}\n"
                f"{projection}, {self.view.up} up, light {self.view.light}")

    def _turn(self, switch: str, of: Any = None) -> None:
        owner = self if of is None else of
        setattr(owner, switch, not getattr(owner, switch))

    def _connect(self) -> None:
        codes = {getattr(glfw, f"KEY_{name}"): key.does for key in self.keys for name in key.names}

        def pressed(_window: object, key: int, _scan: int, action: int, mods: int) -> None:
            if action != glfw.RELEASE and key in codes and not mods & ~glfw.MOD_SHIFT:
                codes[key]()

        def button(window: object, which: int, action: int, mods: int) -> None:
            if action == glfw.RELEASE:
                self.view.grip = None
            else:
                pans = which != glfw.MOUSE_BUTTON_LEFT or bool(mods & glfw.MOD_SHIFT)
                self.view.take(*glfw.get_cursor_pos(window), pans)

        def resize(_window: object, width: int, height: int) -> None:
            self.view.size = (width, height)

        glfw.set_key_callback(self.handle, pressed)
        glfw.set_mouse_button_callback(self.handle, button)
        glfw.set_cursor_pos_callback(self.handle, lambda _window, x, y: self.view.drag(x, y))
        glfw.set_scroll_callback(self.handle, lambda _window, _x, y: self.view.zoom(y))
        glfw.set_framebuffer_size_callback(self.handle, resize)
        glfw.set_drop_callback(self.handle, lambda _window, paths: self.drop(paths))

    # -- frames ----------------------------------------------------------------------------------

    def frame(self) -> None:
        """Draw, present, and hear what the person does."""
        now = time.perf_counter()
        seconds, self._now = now - self._now, now
        self._poll()
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        self.view.apply(seconds)
        if self.sent is not None:
            GL.glPolygonMode(GL.GL_FRONT_AND_BACK, GL.GL_LINE if self.wires else GL.GL_FILL)
            self.sent.draw()
            GL.glPolygonMode(GL.GL_FRONT_AND_BACK, GL.GL_FILL)
        if self.helps or self.facts or self.axes or self.message or self._waits():
            self._draw_over()
        glfw.swap_buffers(self.handle)
        glfw.poll_events()

    def _waits(self) -> bool:
        late = time.perf_counter() - self._begun > AT_ONCE
        return late and (self.loading is not None or self.coming is not None)

    def _draw_over(self) -> None:
        modelview = GL.glGetDoublev(GL.GL_MODELVIEW_MATRIX).T
        with self.overlay.over(self.view.size):
            if self.helps:
                self.overlay.table(self.help())
            elif self.facts:
                self.overlay.panel(self.about())
            if self.axes:
                self.overlay.axes(modelview)
            if self._waits():
                self.overlay.bar(*self.progress())
            elif self.message:
                self.overlay.panel(self.message, top=False)

    def progress(self) -> tuple[str, float | None]:
        """What is coming, and how much of it is there."""
        seconds = time.perf_counter() - self._begun
        if self.loading is not None:
            name, phase = self.loading.name, self.loading.phase
            share = None if phase == "reading" else self.loading.share  # readers say nothing
        else:
            assert self.coming is not None
            name, phase, share = self.coming[0], "sending", self.coming[1].share
        number = "" if share is None else f" {share:.0%}"
        return f"{Path(name).name}: {phase}{number}, {seconds:.0f} s", share

    def run(self) -> None:
        """Until it is closed."""
        try:
            while not glfw.window_should_close(self.handle):
                self.frame()
        finally:
            self.close()

    def close(self) -> None:
        """The window and what was on its way to it."""
        self._forget_what_comes()
        glfw.terminate()
