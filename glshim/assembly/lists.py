"""Display lists as programs: what was compiled, and the polygons that a call of it draws.

A list is kept as the stream that was recorded while it was open. When it is called, nested lists
and matrix calls are resolved into polygons in the caller's object space; that is kept until a list
is redefined. A list that holds anything that C code drew is *opaque*: its polygons come from
feedback mode at its first call.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..geometry.transforms import MATRIX_CALLS
from .batch import PolygonBatch
from .immediate import assemble_many, concatenate, transformed

_DEPTH_TEST, _MODELVIEW = 0x0B71, 0x1700
_FILL = 0x1B02
_ID_TYPES = {
    0x1400: np.int8, 0x1401: np.uint8, 0x1402: np.int16, 0x1403: np.uint16, 0x1404: np.int32,
    0x1405: np.uint32, 0x1406: np.float32,
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Primitive:
    """A recorded glBegin/glEnd pair."""

    mode: int
    stream: bytes


@dataclass(frozen=True, slots=True)
class Call:
    """Lists called from a list."""

    names: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Change:
    """A matrix call or a switch, by its name and arguments."""

    name: str
    args: tuple[Any, ...]

    @classmethod
    def of(cls, name: str, args: tuple[Any, ...]) -> Change:
        """With matrices copied: the app may change its array."""
        if "Matrix" in name and len(args) == 1 and name != "glMatrixMode":
            args = (_matrix(name, args[0]),)
        return cls(name, args)


Item = Primitive | Call | Change | PolygonBatch


@dataclass(slots=True)
class Program:
    """What one list holds."""

    items: list[Item] = field(default_factory=list)
    opaque: bool = False
    """Holds something whose polygons only feedback mode can tell."""
    begins: bool = False
    """Ends inside a primitive that it began."""
    ends: bool = False
    """Ends a primitive that it did not begin."""


@dataclass(frozen=True, slots=True)
class ListPolygons:
    """What calling a list draws."""

    relative: PolygonBatch | None
    """In the caller's object space."""
    absolute: tuple[tuple[PolygonBatch, NDArray[np.float64]], ...] = ()
    """Under a modelview matrix that the list loads by itself."""


_NOTHING = ListPolygons(None)


class ListBook:
    """The lists of one share group."""

    def __init__(self) -> None:
        self._programs: dict[int, Program] = {}
        self._resolved: dict[tuple[int, int], ListPolygons] = {}
        self._open: tuple[int, Program] | None = None

    @property
    def open(self) -> Program | None:
        """The program being compiled."""
        return self._open[1] if self._open else None

    def begin(self, name: int) -> None:
        """glNewList."""
        self._open = (name, Program())

    def end(self) -> int | None:
        """glEndList: the list takes effect. Its name."""
        if self._open is None:
            return None
        name, program = self._open
        self._programs[name] = program
        self._resolved.clear()
        self._open = None
        return name

    def redefined_elsewhere(self, name: int) -> None:
        """Another context, which may share lists with ours, compiled this list."""
        if name not in self._programs:
            self._resolved.clear()

    def begins(self, name: int) -> bool:
        """Whether the list leaves a primitive open."""
        return name in self._programs and self._programs[name].begins

    def ends(self, name: int) -> bool:
        """Whether the list ends a primitive that another began."""
        return name in self._programs and self._programs[name].ends

    def forget(self, first: int, count: int) -> None:
        """glDeleteLists."""
        if count > len(self._programs):
            gone = [n for n in self._programs if first <= n < first + count]
        else:
            gone = [n for n in range(first, first + count) if n in self._programs]
        for name in gone:
            del self._programs[name]
        self._resolved.clear()

    def polygons(
        self,
        name: int,
        matrix_mode: int,
        feedback: Callable[[int], PolygonBatch | None],
        context: int,
    ) -> ListPolygons:
        """What calling this list draws, with keys so that caches find it again.

        ``feedback`` gives the polygons of a list that is opaque, or was compiled unseen.
        """
        at = (name, matrix_mode)
        if at not in self._resolved:
            self._resolved[at] = self._resolve(name, matrix_mode, feedback, context)
        return self._resolved[at]

    def _resolve(
        self,
        name: int,
        matrix_mode: int,
        feedback: Callable[[int], PolygonBatch | None],
        context: int,
    ) -> ListPolygons:
        key = ("list", context, name, object())
        if self._is_opaque(name, 0):
            found = feedback(name)
            return ListPolygons(concatenate([found], key)) if found is not None else _NOTHING
        walk = _Walk(self._programs, matrix_mode)
        walk.run(name, 0)
        relative = [b for b, _, loaded in walk.found if not loaded]
        absolute = tuple(
            (concatenate([b], (*key, i)), m)
            for i, (b, m, loaded) in enumerate(walk.found)
            if loaded
        )
        if not relative:
            return ListPolygons(None, absolute)
        return ListPolygons(concatenate(relative, key), absolute)

    def _is_opaque(self, name: int, depth: int) -> bool:
        program = self._programs.get(name)
        if program is None or depth > 64:
            return depth == 0  # compiled before us, or by C code
        if program.opaque:
            return True
        called = (n for item in program.items if isinstance(item, Call) for n in item.names)
        return any(n in self._programs and self._is_opaque(n, depth + 1) for n in called)


class _Walk:
    """Runs a list as the driver would, following matrices and the switches that matter."""

    def __init__(self, programs: dict[int, Program], matrix_mode: int) -> None:
        self.found: list[tuple[PolygonBatch, NDArray[np.float64], bool]] = []
        self._programs = programs
        self._mode = matrix_mode
        self._matrix = np.eye(4)
        self._loaded = False
        self._stack: list[tuple[NDArray[np.float64], bool]] = []
        self._switches: dict[str, bool] = {"depth": True, "fill": True, "write": True}
        self._attributes: list[dict[str, bool]] = []
        self._pending: list[tuple[int, bytes]] = []

    def run(self, name: int, depth: int) -> None:
        program = self._programs.get(name)
        if program is None or depth > 64:
            return
        for item in program.items:
            if isinstance(item, Primitive):
                self._pending.append((item.mode, item.stream))
            elif isinstance(item, Call):
                for called in item.names:
                    self.run(called, depth + 1)
            elif isinstance(item, PolygonBatch):
                self._emit()
                self._take(item)
            else:
                self._emit()
                self._change(item)
        if depth == 0:
            self._emit()

    def _emit(self) -> None:
        if self._pending:
            batch = assemble_many(self._pending)
            self._pending = []
            self._take(batch)

    def _take(self, batch: PolygonBatch) -> None:
        on = self._switches
        if not (on["depth"] and on["fill"] and on["write"]) or not len(batch.corners):
            return
        if not self._loaded:
            batch = transformed(batch, self._matrix)
        self.found.append((batch, self._matrix, self._loaded))

    def _change(self, change: Change) -> None:
        name, args = change.name, change.args
        if name == "glMatrixMode":
            self._mode = int(args[0])
        elif name in MATRIX_CALLS or name in ("glPushMatrix", "glPopMatrix"):
            if self._mode == _MODELVIEW:
                self._move(name, args)
        elif name == "glPushAttrib":
            self._attributes.append(dict(self._switches))
        elif name == "glPopAttrib":
            if self._attributes:
                self._switches = self._attributes.pop()
        elif name in ("glEnable", "glDisable"):
            if int(args[0]) == _DEPTH_TEST:
                self._switches["depth"] = name == "glEnable"
        elif name == "glDepthMask":
            self._switches["write"] = bool(args[0])
        elif name == "glPolygonMode":
            self._switches["fill"] = int(args[1]) == _FILL

    def _move(self, name: str, args: tuple[Any, ...]) -> None:
        if name == "glPushMatrix":
            self._stack.append((self._matrix, self._loaded))
        elif name == "glPopMatrix":
            if self._stack:
                self._matrix, self._loaded = self._stack.pop()
        else:
            matrix, loads = MATRIX_CALLS[name](*args)
            self._matrix = matrix if loads else self._matrix @ matrix
            self._loaded = self._loaded or loads


def _matrix(name: str, value: Any) -> list[float]:
    from OpenGL import arrays

    double = name.endswith("d")
    kind = arrays.GLdoubleArray if double else arrays.GLfloatArray
    element = ctypes.c_double if double else ctypes.c_float
    return list((element * 16).from_address(int(kind.dataPointer(value))))


def list_names(name: str, args: Sequence[Any], base: int) -> tuple[int, ...]:
    """The lists that a LIST_CALL entry point calls; `base` is GL_LIST_BASE."""
    if name == "glCallList":
        return (int(args[0]),)
    count, type_, pointer = int(args[0]), int(args[1]), args[2]
    dtype = _ID_TYPES.get(type_)
    if dtype is None or count <= 0:
        return ()
    from OpenGL.arrays import ArrayDatatype

    address = (
        pointer.value
        if isinstance(pointer, ctypes.c_void_p)
        else ArrayDatatype.voidDataPointer(pointer).value
    )
    raw = ctypes.string_at(int(address or 0), count * np.dtype(dtype).itemsize)
    return tuple(int(i) + base for i in np.frombuffer(raw, dtype))
