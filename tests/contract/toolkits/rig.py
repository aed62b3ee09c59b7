"""What a rig is: it gives the modules to be hooked, opens one window, and acts as a program and its
user do."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

from glshim.toolkits import Toolkit

SIZE = (60, 40)
"""Pixels of every rig's window."""
Log = list[str]


class Rig:
    """One program under one toolkit."""

    takes_early = False
    """Whether names that were taken before the hooks are followed, too."""
    shows_by_itself = False
    """Whether the picture is there before the frame ends: nothing is presented by a call."""
    framebuffer = 0
    has_a_user = True
    """Whether keys can be pressed; else `tests/programs/test_live.py` has a hand at them."""

    def __init__(self, toolkit: Toolkit) -> None:
        self.toolkit = toolkit
        self.log: Log = []
        """What the toolkit and the program do."""
        self.got: list[Any] = []
        """Key events that reach the program, as (name, down)."""
        self.modules: dict[str, Any] = {}
        """By full name."""

    def take(self) -> None:
        """Take names as ``from toolkit import ...`` does."""
        raise NotImplementedError

    def open(self) -> None:
        """Make a window."""

    def present(self) -> Any:
        """Show a frame by the names taken; gives 7, what the toolkit's own call gives, where that
        gives anything."""
        raise NotImplementedError

    def key(self, name: str, down: bool) -> None:
        """The user presses or releases a key."""
        raise NotImplementedError

    def redraws(self) -> int:
        """How often another frame was asked for."""
        raise NotImplementedError

    def seconds(self) -> float:
        """What the toolkit's clock shows."""
        raise NotImplementedError

    def shown(self, *_: Any) -> int:
        """The toolkit's own present."""
        self.log.append("shown")
        return 7


def library_function(function: Callable[..., Any], *types: Any) -> Any:
    """One that ctypes made, as those of loaded libraries."""
    return ctypes.CFUNCTYPE(ctypes.c_int, *types)(function)


def fill(width: Any, height: Any) -> None:
    """Answer a question for a size through two pointers."""
    for pointer, value in zip((width, height), SIZE, strict=True):
        ctypes.cast(pointer, ctypes.POINTER(ctypes.c_int)).contents.value = value
