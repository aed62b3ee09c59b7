"""The toolkits whose keys are hooked: a row each in `KEYBOARDS`, beside their frame ends in
`glshim.toolkits.toolkits`, and by the same means."""

from __future__ import annotations

import ctypes
import functools
import sys
import threading
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from types import ModuleType
from typing import Any

from glshim.bindings.imports import after_import
from glshim.notices import say_fault
from glshim.toolkits import keyboard
from glshim.toolkits.qt import update_widgets
from glshim.toolkits.qt_keys import hook_filter


@dataclass(frozen=True, slots=True)
class Keyboard:
    """The keys of one toolkit."""

    name: str
    module: str
    """The module after whose import the hook is put."""
    hook: Callable[[ModuleType], None]
    how: str
    """What is hooked, for people."""


def _held(mask: int, bits: Mapping[str, int]) -> set[str]:
    """The modifiers whose bits are set."""
    return {modifier for modifier, bit in bits.items() if mask & bit}


# --- GLUT ---------------------------------------------------------------------------------------

_GLUT_SPECIAL = {
    **{n: f"F{n}" for n in range(1, 13)},
    104: "PageUp", 105: "PageDown", 106: "Home", 107: "End", 108: "Insert",
}  # fmt: skip
_GLUT_BITS = {"shift": 1, "ctrl": 2, "alt": 4}


def _glut_special(key: int) -> str | None:
    return _GLUT_SPECIAL.get(key)


def _glut_typed(key: bytes) -> str | None:
    """Ctrl and a letter come as a control character."""
    code = key[0] + 0x60 if 1 <= key[0] <= 26 and key not in b"\b\t\r" else key[0]
    name = chr(code).upper()
    return name if name in keyboard.NAMES else None


def _hook_glut(module: ModuleType) -> None:
    from OpenGL.platform import PLATFORM

    library: Any = PLATFORM.GLUT
    if not library or not hasattr(library, "glutGetModifiers"):
        return
    windows: set[int] = set()
    callbacks: dict[tuple[int, str], Any] = {}
    """Of ours, by window and kind."""

    def take(name_of: Callable[[Any], str | None], up: bool, key: Any) -> bool:
        name = name_of(key)
        if up:
            return keyboard.released(name)
        return keyboard.pressed(name, _held(library.glutGetModifiers(), _GLUT_BITS))

    def put(kind: str, name_of: Callable[[Any], str | None], up: bool) -> Callable[[], None]:
        register = getattr(module, f"glut{kind}Func")
        plain = register.wrappedOperation

        def outer(callback: Any, key: Any, x: int, y: int) -> None:
            if not take(name_of, up, key) and callback is not None:
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
            """A window where the app asks for no keys."""
            window = library.glutGetWindow()
            if window and (window, kind) not in callbacks:
                windows.add(window)
                add(window)

        register.wrappedOperation = wrapped_operation
        return start

    starts = [put("Special", _glut_special, False), put("Keyboard", _glut_typed, False)]
    put("SpecialUp", _glut_special, True)
    put("KeyboardUp", _glut_typed, True)

    def frame_ends() -> None:
        if module.INITIALIZED and library.glutGetWindow():
            windows.add(library.glutGetWindow())
            for start in starts:
                start()

    def redraw() -> None:
        for window in windows:
            library.glutPostWindowRedisplay(window)

    keyboard.at_frame_ends(frame_ends)
    keyboard.on_redraw(redraw)


# --- glfw ---------------------------------------------------------------------------------------

_GLFW_KEYS = {
    **{289 + n: f"F{n}" for n in range(1, 13)},
    **{ord(letter): letter for letter in keyboard.NAMES if len(letter) == 1},
    260: "Insert", 266: "PageUp", 267: "PageDown", 268: "Home", 269: "End",
}  # fmt: skip
_GLFW_BITS = {"shift": 1, "ctrl": 2, "alt": 4}
_RELEASED, _REPEATED = 0, 2


def _hook_glfw(module: ModuleType) -> None:
    """Every window has a callback of ours from its beginning, which calls the app's."""
    library = module._glfw
    create, set_callback = library.glfwCreateWindow, library.glfwSetKeyCallback
    apps: dict[int, Any] = {}
    """The app's callbacks by window."""

    def on_key(window: Any, key: int, scancode: int, action: int, mods: int) -> None:
        name = _GLFW_KEYS.get(key)
        if action == _RELEASED:
            ours = keyboard.released(name)
        else:
            ours = keyboard.pressed(name, _held(mods, _GLFW_BITS), again=action == _REPEATED)
        callback = apps.get(_address(window))
        if not ours and callback:
            callback(window, key, scancode, action, mods)

    hooked = module._GLFWkeyfun(on_key)

    @functools.wraps(create, assigned=("__name__", "__doc__"), updated=())
    def create_window(*arguments: Any) -> Any:
        window = create(*arguments)
        if window:
            apps[_address(window)] = None
            set_callback(window, hooked)
        return window

    @functools.wraps(set_callback, assigned=("__name__", "__doc__"), updated=())
    def set_key_callback(window: Any, callback: Any) -> Any:
        previous = apps.get(_address(window))
        apps[_address(window)] = callback
        set_callback(window, hooked)
        return previous

    def redraw() -> None:
        """Loops that wait for events go round once more."""
        if apps:
            library.glfwPostEmptyEvent()

    library.glfwCreateWindow, library.glfwSetKeyCallback = create_window, set_key_callback
    keyboard.on_redraw(redraw)


def _address(pointer: Any) -> int:
    return ctypes.cast(pointer, ctypes.c_void_p).value or 0


# --- pygame -------------------------------------------------------------------------------------

_PYGAME_BITS = {"shift": 0x3, "ctrl": 0xC0, "alt": 0x300}


def _hook_pygame(module: ModuleType) -> None:
    """The app gets its events without those of our keys. Another frame is asked for by a
    VIDEOEXPOSE, for programs that draw when there is an event."""
    constants: Any = sys.modules["pygame.constants"]
    names = {getattr(constants, f"K_{name}"): name for name in keyboard.NAMES[:12]}
    names |= {ord(name.lower()): name for name in keyboard.NAMES if len(name) == 1}
    names |= {getattr(constants, f"K_{name.upper()}"): name for name in keyboard.SPECIAL}
    post, event_of = module.post, module.Event

    def ours(event: Any) -> bool:
        if event.type == constants.KEYUP:
            return keyboard.released(names.get(event.key))
        if event.type != constants.KEYDOWN:
            return False
        held = _held(getattr(event, "mod", 0), _PYGAME_BITS)
        return keyboard.pressed(names.get(event.key), held)

    def redraw() -> None:
        with suppress(Exception):  # a full queue, no display
            post(event_of(constants.VIDEOEXPOSE))

    def many(plain: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(plain)
        def get(*arguments: Any, **named: Any) -> Any:
            events = plain(*arguments, **named)
            if not keyboard.listening():
                return events
            return [event for event in events if not ours(event)]

        return get

    def one(plain: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(plain)
        def next_event(*arguments: Any, **named: Any) -> Any:
            event = plain(*arguments, **named)
            while keyboard.listening() and ours(event):
                event = plain(*arguments, **named)
            return event

        return next_event

    module.get = many(module.get)  # type: ignore[attr-defined]
    for name in ("poll", "wait"):
        setattr(module, name, one(getattr(module, name)))
    keyboard.on_redraw(redraw)


# --- Qt -----------------------------------------------------------------------------------------


def _hook_qt(module: ModuleType) -> None:
    """A filter on the application's events, once there is one."""
    start = hook_filter(module)

    def frame_ends() -> None:
        if threading.current_thread() is threading.main_thread():
            start()

    keyboard.at_frame_ends(frame_ends)
    keyboard.on_redraw(update_widgets)


KEYBOARDS = (
    Keyboard("GLUT", "OpenGL.GLUT.special", _hook_glut, "glutKeyboardFunc, glutSpecialFunc"),
    Keyboard("glfw", "glfw", _hook_glfw, "glfw.set_key_callback"),
    Keyboard("pygame", "pygame.event", _hook_pygame, "pygame.event.get, poll, wait"),
    *(
        Keyboard(package, f"{package}.QtCore", _hook_qt, "an event filter")
        for package in ("PyQt5", "PySide2", "PyQt6", "PySide6")
    ),
)

_watching = False


def watch() -> None:
    """Hook every keyboard of the table that is imported, and the others when they are."""
    global _watching
    if not _watching:
        _watching = True
        for row in KEYBOARDS:
            after_import(row.module, _safely(row.hook))


def _safely(hook: Callable[[ModuleType], None]) -> Callable[[ModuleType], None]:
    def put(module: ModuleType) -> None:
        try:
            hook(module)
        except Exception as error:
            say_fault(f"the keys of {module.__name__} are not watched", error)

    return put
