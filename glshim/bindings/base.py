"""What a binding gives: the app's calls by role, whatever it speaks OpenGL through.

A binding hooks one way of calling OpenGL from Python. It tells one :class:`Watcher` what the app
does, and lets it work on the record of the primitive that is open through a
:class:`PrimitiveStream`. ``glshim.bindings.pyopengl`` is one; another is another folder here.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from glshim.spec.roles import Role
from glshim.spec.shapes import Shape


class PrimitiveSink(Protocol):
    """Who wants to know about primitives between glBegin and glEnd.

    They come as streams of 20-byte records (`glshim.spec.attributes`)."""

    def begin(self, mode: int) -> None:
        """Before the driver's glBegin."""

    def refused(self) -> None:
        """Instead of what comes after a draw: the arguments were refused, nothing was called."""

    def end(self, mode: int, stream: bytes) -> None:
        """After the driver has drawn it (or a list has taken it)."""

    def loose(self, stream: bytes) -> None:
        """Vertices and attributes that a list being compiled has outside any primitive (often
        none)."""

    def stray_end(self) -> None:
        """A list being compiled has a glEnd without its glBegin."""

    def unfinished(self, mode: int, stream: bytes) -> None:
        """A list ends inside the primitive that it began."""

    def listed(self) -> int:
        """How many things the list being compiled is known to hold; 0 without one."""


class ShapeSink(Protocol):
    """Who wants to know about shapes that C libraries draw."""

    def before_shape(self, name: str) -> None:
        """Before the library draws."""

    def after_shape(self, shape: Shape | None) -> None:
        """After it drew a shape, or (None) no polygons."""


class Watcher(PrimitiveSink, ShapeSink, Protocol):
    """Who wants to know about all that draws. Its faults must never reach the app."""

    def before(self, role: Role, name: str, args: tuple[Any, ...]) -> None:
        """Before the driver's call, outside primitives."""

    def after(
        self, role: Role, name: str, args: tuple[Any, ...], call: Callable[..., Any]
    ) -> None:
        """After it; ``call(*args)`` would make it again, past every hook."""

    def failed(
        self, role: Role, name: str, args: tuple[Any, ...], call: Callable[..., Any]
    ) -> None:
        """Instead of :meth:`after`: a GL error was found, which may be an older one."""

    def material_changes(self) -> None:
        """Before a call of MATERIAL inside a primitive."""

    def inside(
        self, role: Role, name: str, args: tuple[Any, ...], call: Callable[..., Any]
    ) -> None:
        """After any watched call inside a primitive, and one of `roles.INSIDE` anywhere in an open
        list; ``call(*args)`` would make it again."""


class PrimitiveStream(Protocol):
    """The record of the primitive that is open, and of what an open list has outside primitives.

    All that a watcher may do to what it hears."""

    mode: int
    """Of the primitive that is open."""

    def unsaid(self) -> bool:
        """Whether nothing of the open primitive has reached the driver but its beginning."""

    def inside(self) -> bool:
        """Whether this thread has a recorded glBegin open."""

    def position(self) -> int:
        """Bytes recorded so far of the open primitive."""

    def extend(self, records: bytes) -> None:
        """Add records of vertices that reached the driver another way (glArrayElement)."""

    def settle(self) -> None:
        """Have the sink told now what an open list has said outside primitives so far."""

    def resume(self, mode: int, records: bytes) -> None:
        """A list that was called left a primitive open, with these records in it."""

    def finish(self) -> tuple[int, bytes] | None:
        """A list that was called has closed the primitive: its mode and records."""

    def replay(self, records: bytes) -> None:
        """Say records to the driver, call by call, past every hook."""


class Binding(Protocol):
    """One way of calling OpenGL."""

    @property
    def installed(self) -> bool:
        """Whether its calls are hooked."""

    @property
    def stream(self) -> PrimitiveStream:
        """The record; of this installation."""

    def install(self) -> None:
        """Hook what the record of primitives needs, in modules imported already or later."""

    def uninstall(self) -> None:
        """Leave everything as it was found."""

    def attach(self, watcher: Watcher) -> None:
        """Tell a watcher from now on."""

    def detach(self) -> None:
        """Tell nobody any more."""
