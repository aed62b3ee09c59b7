"""glfw, by its Python package of the same name."""

from __future__ import annotations

import ctypes
import functools
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, ClassVar

from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Part, Toolkit
from glshim.toolkits.frames import Size
from glshim.toolkits.moment import MOMENT, Moment

# From glfw3.h.
_KEYS = {
    **{289 + n: f"F{n}" for n in range(1, 13)},
    **{ord(letter): letter for letter in keyboard.NAMES if len(letter) == 1},
    260: "Insert", 266: "PageUp", 267: "PageDown", 268: "Home", 269: "End",
}  # fmt: skip
"""GLFW_KEY_F1 and so on."""
_MODIFIERS = {"shift": 1, "ctrl": 2, "alt": 4}
"""GLFW_MOD_SHIFT and so on."""
GLFW_RELEASE, GLFW_REPEAT = 0, 2


class Glfw(Toolkit):
    """It swaps any window, and wakes programs that wait for events by an empty one."""

    name = package = "glfw"
    hears_threads = True
    tested = "glfw 2.11 on X and Wayland, and without a display"
    displayless: ClassVar[Mapping[str, str] | None] = {}

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "glfw", self.hook_swaps, "glfw.swap_buffers")
        yield Hook(Part.KEYS, "glfw", self.hook_keys, "glfw.set_key_callback")
        yield Hook(Part.CLOCK, "glfw", self.hold_clock, "glfw.get_time")
        yield Hook(Part.DISPLAYLESS, "glfw", self.hook_windows, "glfw.create_window")

    def __init__(self, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self._library: Any = None
        self._has_shown = False
        self._callbacks: dict[int, Any] = {}
        """The app's key callbacks, by window."""
        self._ours: list[Any] = []
        """Callbacks that C holds, so they stay."""

    def size(self, window: Any) -> Size:
        width, height = ctypes.c_int(), ctypes.c_int()
        self._library.glfwGetFramebufferSize(window, ctypes.byref(width), ctypes.byref(height))
        return width.value, height.value

    def redraw(self) -> None:
        if self._callbacks or self._has_shown:  # else there may be no glfw yet, or no more
            self._library.glfwPostEmptyEvent()

    def hook_swaps(self, module: Any, changes: Changes) -> None:
        library = self._library = module._glfw
        plain = library.glfwSwapBuffers

        @functools.wraps(plain, assigned=("__name__", "__doc__"), updated=())
        def swap_buffers(window: Any) -> Any:
            if not frames.listening():
                return plain(window)
            self._has_shown = True
            with _current(library, window):
                return frames.present(plain, window, on=self.drawable(window))

        changes.set(library, "glfwSwapBuffers", swap_buffers)

    def hook_keys(self, module: Any, changes: Changes) -> None:
        """Every window has a callback of ours from its beginning, which calls the app's."""
        library = self._library = module._glfw
        create, set_callback = library.glfwCreateWindow, library.glfwSetKeyCallback
        callbacks = self._callbacks

        def on_key(window: Any, key: int, scancode: int, action: int, mods: int) -> None:
            name = _KEYS.get(key)
            if action == GLFW_RELEASE:
                ours = keyboard.released(name)
            else:
                held = keyboard.modifiers(mods, _MODIFIERS)
                ours = keyboard.pressed(name, held, again=action == GLFW_REPEAT)
            callback = callbacks.get(_address(window))
            if not ours and callback:
                callback(window, key, scancode, action, mods)

        hooked = module._GLFWkeyfun(on_key)
        self._ours.append(hooked)

        @functools.wraps(create, assigned=("__name__", "__doc__"), updated=())
        def create_window(*arguments: Any) -> Any:
            window = create(*arguments)
            if window:
                callbacks[_address(window)] = None
                set_callback(window, hooked)
            return window

        @functools.wraps(set_callback, assigned=("__name__", "__doc__"), updated=())
        def set_key_callback(window: Any, callback: Any) -> Any:
            previous = callbacks.get(_address(window))
            callbacks[_address(window)] = callback
            set_callback(window, hooked)
            return previous

        changes.set(library, "glfwCreateWindow", create_window)
        changes.set(library, "glfwSetKeyCallback", set_key_callback)

    def hook_windows(self, module: Any, changes: Changes) -> None:
        """Windows that nobody sees, with contexts of EGL."""
        from glshim.toolkits.glfw_displayless import Displayless

        Displayless(module._glfw, changes)

    def hold_clock(self, module: Any, changes: Changes) -> None:
        """`glfw.get_time` shows the moment."""
        changes.set(module, "get_time", lambda: self.moment.now)


@contextmanager
def _current(library: Any, window: Any) -> Iterator[None]:
    """glfw swaps any window; a frame ends in the context of the window that is swapped."""
    current = library.glfwGetCurrentContext()
    if not current or not window or _address(current) == _address(window):
        yield
        return
    library.glfwMakeContextCurrent(window)
    try:
        yield
    finally:
        library.glfwMakeContextCurrent(current)


def _address(pointer: Any) -> int:
    return ctypes.cast(pointer, ctypes.c_void_p).value or 0


TOOLKITS = (Glfw(),)
