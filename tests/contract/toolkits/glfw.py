"""glfw's Python package."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.glfw import Glfw

from .rig import Rig, fill


class GlfwRig(Rig):
    def __init__(self) -> None:
        super().__init__(Glfw())
        self.callbacks: dict[int, Any] = {}
        self.asked = 0
        self.window = ctypes.c_void_p(77)

        def set_callback(window: Any, callback: Any) -> None:
            self.callbacks[window.value] = callback

        def wake() -> None:
            self.asked += 1

        self.library = SimpleNamespace(
            glfwSwapBuffers=self.shown, glfwGetCurrentContext=lambda: self.window,
            glfwGetFramebufferSize=lambda window, width, height: fill(width, height),
            glfwCreateWindow=lambda: self.window, glfwSetKeyCallback=set_callback,
            glfwPostEmptyEvent=wake,
        )  # fmt: skip
        self.modules = {"glfw": SimpleNamespace(
            _glfw=self.library, _GLFWkeyfun=lambda function: function, get_time=lambda: 99.0,
            swap_buffers=self.swap_buffers)}  # fmt: skip

    def swap_buffers(self, window: Any) -> Any:
        return self.library.glfwSwapBuffers(window)

    def take(self) -> None:
        self.swap, self.time = self.modules["glfw"].swap_buffers, self.modules["glfw"].get_time

    def open(self) -> None:
        self.library.glfwCreateWindow()

        def on_key(window: Any, key: int, scancode: int, action: int, mods: int) -> None:
            self.got.append((f"F{key - 289}" if key > 256 else chr(key), bool(action)))

        self.library.glfwSetKeyCallback(self.window, on_key)

    def present(self) -> Any:
        return self.swap(self.window)

    def key(self, name: str, down: bool) -> None:
        code = 289 + int(name[1:]) if len(name) > 1 else ord(name)
        self.callbacks[77](self.window, code, 0, int(down), 0)

    def redraws(self) -> int:
        return self.asked

    def seconds(self) -> float:
        return float(self.time())


RIGS: dict[str, Callable[[], Rig]] = {"glfw": GlfwRig}
