"""Records what is said between glBegin and glEnd, and hands it on at glEnd.

The driver's glBegin is issued at once, so whatever is illegal inside a primitive fails there as it
would without us. Vertices and attributes are packed into 20-byte records instead of being sent; at
glEnd they go to the driver in one piece (``forward.py``). Anything that may look at or depend on
them before that makes the recorder *spill*: what was recorded is replayed call by call, and the
rest of the primitive goes straight through, recorded as well.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from io import BytesIO
from threading import get_ident
from typing import Any, Protocol

from numpy import ndarray

from glshim.bindings.pyopengl import forward
from glshim.bindings.pyopengl.conversions import INTEGERS, LISTED, as_c_takes, enum
from glshim.bindings.pyopengl.raw import RAW, Call, Maker
from glshim.spec.attributes import ATTRIBUTES, Attribute
from glshim.spec.driver import quick

_MISSING: Any = object()
_SEQUENCES = (list, tuple, ndarray)
_LOOK_OUT = 64
"""Primitives after a large one that may be large, too."""
_LAST_MODE = 13
"""GL_TRIANGLE_STRIP_ADJACENCY: greater modes are errors inside glBegin."""


class PrimitiveSink(Protocol):
    """Who wants to know about primitives."""

    def begin(self, mode: int) -> None:
        """Before the driver's glBegin."""

    def end(self, mode: int, stream: bytes) -> None:
        """After the driver has drawn it (or a list has taken it)."""

    def bare(self, stream: bytes) -> None:
        """Vertices that a list being compiled has outside any primitive (often none)."""

    def stray_end(self) -> None:
        """A list being compiled has a glEnd without its glBegin."""

    def unfinished(self, mode: int, stream: bytes) -> None:
        """A list ends inside the primitive that it began."""


class Recorder:
    """The recording hooks and the state they share. One instance: :data:`RECORDER`."""

    def __init__(self) -> None:
        self.sink: PrimitiveSink | None = None
        self.list_open = False
        self._set: list[tuple[Callable[[str, Maker | None], None], str]] = []
        self.spill: Callable[[], None] = lambda: None
        """Send what is recorded so far, call by call; the rest of the primitive follows at once."""
        self.extend: Callable[[bytes], None] = lambda records: None
        """Add records of vertices that reached the driver another way (glArrayElement)."""
        self.inside: Callable[[], bool] = lambda: False
        """Whether this thread has a recorded glBegin open."""
        self.position: Callable[[], int] = lambda: 0
        """Bytes recorded so far of the open primitive."""
        self.open_list: Callable[[bool], None] = lambda capturing: None
        """A display list begins; when capturing, vertices outside glBegin are recorded too."""
        self.close_list: Callable[[], None] = lambda: None
        """It ends: what is recorded goes into it, also of a primitive that it leaves open."""
        self.resume: Callable[[int, bytes], None] = lambda mode, records: None
        """A list that was called left a primitive open, with these records in it."""
        self.settle: Callable[[], None] = lambda: None
        """Tell the sink what an open list has said outside primitives so far."""
        self.finish: Callable[[], tuple[int, bytes] | None] = lambda: None
        """A list that was called has closed the primitive: its mode and records."""

    def install(self) -> None:
        """Hook glBegin, glEnd and every recorded attribute."""
        from OpenGL import _configflags

        # A log of every call, or a check of the context at each: nothing may be held back then.
        debugging = ("FULL_LOGGING", "ERROR_LOGGING", "CONTEXT_CHECKING")
        careful = any(getattr(_configflags, flag) for flag in debugging)
        raw, wrappers = self._make(_configflags.ERROR_CHECKING and not careful, careful)
        for name, maker in raw.items():
            RAW.hook(name, maker)
            self._set.append((RAW.hook, name))
        # ERROR_ON_COPY promises an error for every list: leave the wrappers to raise it.
        if not _configflags.ERROR_ON_COPY:
            for name, maker in wrappers.items():
                RAW.hook_wrapper(name, maker)
                self._set.append((RAW.hook_wrapper, name))

    def uninstall(self) -> None:
        """Send what is still recorded and take the hooks away."""
        self.spill()
        for place, name in self._set:
            place(name, None)
        self._set.clear()

    def _make(self, quick_begin: bool, careful: bool) -> tuple[dict[str, Maker], dict[str, Maker]]:
        """Makers by name for the raw layer and for the wrappers.

        They are closures over shared cells: the fastest state that pure Python offers. When
        ``careful``, everything goes straight through and is recorded beside that.
        """
        deferred = False  # inside a primitive whose vertices are held back
        shadow = False  # what goes straight through is recorded as well
        bare = False  # inside a display list, outside any primitive of it
        mode = home = 0  # home: the thread that opened the primitive
        expected = 0  # so many more primitives may be large: ask beforehand whether arrays do
        able = False  # they do for the open primitive, should it turn out large
        stream = BytesIO()
        write: Callable[[bytes], int] = stream.write

        def spill() -> None:
            nonlocal deferred, shadow
            if deferred:
                deferred, shadow = False, True
                forward.replay(stream.getvalue())

        def extend(records: bytes) -> None:
            if shadow:
                write(records)

        def open_list(capturing: bool) -> None:
            nonlocal bare, shadow
            spill()
            self.list_open = True
            if capturing and not shadow:
                restart()
                bare = shadow = True

        def close_list() -> None:
            nonlocal bare, shadow
            spill()
            settle()
            if self.sink is not None and shadow and not bare:
                self.sink.unfinished(mode, stream.getvalue())
            bare = shadow = False
            self.list_open = False

        def settle() -> None:
            if bare:
                records = stream.getvalue()
                restart()
                if self.sink is not None:
                    self.sink.bare(records)

        def restart() -> None:
            nonlocal stream, write
            stream = BytesIO()
            write = stream.write

        def resume(new_mode: int, records: bytes) -> None:
            nonlocal shadow, mode, home
            restart()
            write(records)
            mode, home = new_mode, get_ident()
            shadow = True

        def finish() -> tuple[int, bytes] | None:
            nonlocal shadow, deferred
            if not shadow and not deferred:
                return None
            spill()
            shadow = False
            return mode, stream.getvalue()

        self.spill, self.extend = spill, extend
        self.open_list, self.close_list = open_list, close_list
        self.resume, self.finish, self.settle = resume, finish, settle
        self.position = lambda: stream.tell()  # noqa: PLW0108 - the stream changes
        self.inside = lambda: (deferred or shadow) and not bare and get_ident() == home

        def make_begin(real: Call, checked: bool = True) -> Call:
            driver_begin = quick("glBegin")

            def begin(*args: Any) -> Any:
                nonlocal deferred, mode, stream, write, shadow, bare, expected, able, home
                if bare:
                    settle()
                    bare = shadow = False
                new_mode = args[0] if len(args) == 1 else None
                if not isinstance(new_mode, int):
                    new_mode = enum(new_mode)
                if deferred or shadow or not 0 <= new_mode <= _LAST_MODE:
                    return real(*args)
                if self.sink is not None:
                    self.sink.begin(new_mode)
                if expected:
                    expected -= 1
                    able = forward.able(new_mode)
                elif able:
                    able = False
                if careful:
                    real(*args)
                else:
                    driver_begin(new_mode)
                stream = BytesIO()
                write = stream.write
                mode, home = new_mode, get_ident()
                deferred, shadow = not careful, careful
                return forward.check(real) if checked and not careful else None

            return begin

        def make_end(real: Call) -> Call:
            def end(*args: Any) -> Any:
                nonlocal deferred, shadow, bare, expected
                if not deferred and not shadow:
                    return real(*args)
                if bare:
                    settle()
                    if self.sink is not None:
                        self.sink.stray_end()
                    return real(*args)
                records = stream.getvalue()
                held, deferred, shadow = deferred, False, False
                try:
                    if held and len(records) >= forward.SMALL:
                        expected = _LOOK_OUT
                        if able and not self.list_open and forward.draw(mode, records):
                            return forward.check(real)
                    if held:
                        forward.replay(records)
                    return real(*args)
                finally:
                    if self.sink is not None:
                        self.sink.end(mode, records)
                        if self.list_open:
                            restart()
                            bare = shadow = True

            return end

        def floats(row: Attribute) -> Maker:
            tag, pack, size = row.tag, row.pack.pack, row.size
            taken = as_c_takes(row)

            def other(real: Call, args: tuple[Any, ...]) -> Any:
                """Straight through, or an argument that does not pack: the driver decides."""
                args = tuple(a for a in args if a is not _MISSING)
                spill()
                result = real(*args)
                if shadow:
                    write(taken(args))
                return result

            def make1(real: Call) -> Call:
                def record(x: Any = _MISSING, /, *more: Any) -> Any:
                    if deferred and not more:
                        try:
                            write(pack(x, tag))
                            return None
                        except Exception:
                            pass
                    return other(real, (x, *more))

                return record

            def make2(real: Call) -> Call:
                def record(x: Any = _MISSING, y: Any = _MISSING, /, *more: Any) -> Any:
                    if deferred and not more:
                        try:
                            write(pack(x, y, tag))
                            return None
                        except Exception:
                            pass
                    return other(real, (x, y, *more))

                return record

            def make3(real: Call) -> Call:
                def record(
                    x: Any = _MISSING, y: Any = _MISSING, z: Any = _MISSING, /, *more: Any
                ) -> Any:
                    if deferred and not more:
                        try:
                            write(pack(x, y, z, tag))
                            return None
                        except Exception:
                            pass
                    elif not shadow and not deferred and z is not _MISSING:
                        return real(x, y, z, *more)
                    return other(real, (x, y, z, *more))

                return record

            def make4(real: Call) -> Call:
                def record(*args: Any) -> Any:
                    if deferred:
                        try:
                            write(pack(*args, tag))
                            return None
                        except Exception:
                            pass
                    return other(real, args)

                return record

            return (make1, make2, make3, make4)[size - 1]

        def integers(row: Attribute) -> Maker:
            tag, pack = row.tag, row.pack.pack
            convert = INTEGERS[row.type](row.size)
            taken = as_c_takes(row)

            def make(real: Call) -> Call:
                def record(*args: Any) -> Any:
                    if deferred:
                        try:
                            write(pack(*convert(*args), tag))
                            return None
                        except Exception:
                            spill()
                    result = real(*args)
                    if shadow:
                        write(taken(args))
                    return result

                return record

            return make

        def pointers(row: Attribute) -> Maker:
            """The vector form on the raw layer: its argument is something with an address."""
            taken = as_c_takes(row)

            def make(real: Call) -> Call:
                def record(*args: Any) -> Any:
                    if not deferred and not shadow:
                        return real(*args)
                    try:
                        values = forward.read(row, *args)
                    except TypeError:
                        spill()
                        return real(*args)
                    if shadow:
                        result = real(*args)
                        write(taken(values))
                        return result
                    write(taken(values))
                    return None

                return record

            return make

        def vectors(row: Attribute) -> Maker:
            """The vector form as PyOpenGL wraps it: lists, tuples and arrays are unpacked here."""
            tag, pack = row.tag, row.pack.pack
            convert = LISTED[row.type](row.size) if row.type in LISTED else None

            def make(base: Call) -> Call:
                def record(this: Any, v: Any = _MISSING, /, *more: Any) -> Any:
                    if deferred and type(v) in _SEQUENCES:
                        try:
                            write(pack(*(convert(*v) if convert else v), tag))
                            return None
                        except Exception:
                            pass
                    return base(this, *((v, *more) if v is not _MISSING else ()))

                return record

            return make

        raw: dict[str, Maker] = {"glBegin": make_begin, "glEnd": make_end}
        wrappers: dict[str, Maker] = {}
        if quick_begin:
            unchecked = partial(make_begin, checked=False)
            wrappers["glBegin"] = _quick("glBegin", unchecked, "onBegin", 1)
            wrappers["glEnd"] = _quick("glEnd", make_end, "onEnd", 0)
        for row in ATTRIBUTES:
            scalars = integers(row) if row.type in INTEGERS else floats(row)
            raw[row.name] = _named(row.name, scalars)
            raw[row.name + "v"] = _named(row.name + "v", pointers(row))
            wrappers[row.name + "v"] = _named(row.name + "v", vectors(row))
        return raw, wrappers


def _named(name: str, make: Maker) -> Maker:
    """Hooks that go by the name of what they stand for in Python's own messages."""

    def maker(call: Call) -> Call:
        hook = make(call)
        hook.__qualname__ = name
        return hook

    return maker


def _quick(name: str, make: Maker, bookkeeping: str, count: int) -> Maker:
    """What PyOpenGL's lazy wrapper does, less two Python calls: its bookkeeping, then the hook."""

    def make_wrapper(base: Call) -> Call:
        hook: Call | None = None
        before: Call = type(None)  # does nothing

        def wrapper(this: Any, *args: Any, **named: Any) -> Any:
            nonlocal hook, before
            if hook is None or named or len(args) != count:
                real = RAW.original(name)
                if real is None or named or len(args) != count:
                    return base(this, *args, **named)  # the long way loads it, or raises
                hook = make(real)
                before = getattr(forward.error_checker(), bookkeeping)
            before()
            return hook(*args)

        return wrapper

    return make_wrapper


RECORDER = Recorder()
