"""Display lists as programs: what was compiled, and the polygons that a call of it draws.

A list is kept as the stream that was recorded while it was open. When it is called, nested lists
and matrix calls are resolved into polygons in the caller's object space; that is kept until a list
is redefined. Shapes that C code drew into it are asked for again then, through feedback mode (on
the function, not on the list: Mesa 22.3 crashes when some lists are called in feedback mode).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import count
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glshim.driver import arguments
from glshim.driver.arguments import address_of, number
from glshim.model.batch import POSITIONS, PolygonBatch, Wanted, join
from glshim.model.lights import Materials
from glshim.notices import say_once
from glshim.sources.fixed import normals
from glshim.sources.fixed.immediate import assemble_many, transformed
from glshim.sources.fixed.matrices import matrix_of
from glshim.sources.fixed.steps import (
    NOBODY_KNOWS,
    Change,
    Closing,
    LooseVertices,
    Opening,
    Step,
    is_drawn,
    is_no_polygon,
)
from glshim.sources.source import Call, Primitive
from glshim.spec.constants import (
    GL_2_BYTES,
    GL_3_BYTES,
    GL_4_BYTES,
    GL_BYTE,
    GL_COLOR_MATERIAL,
    GL_CURRENT_BIT,
    GL_DEPTH_TEST,
    GL_DIFFUSE,
    GL_FILL,
    GL_FLOAT,
    GL_INT,
    GL_MODELVIEW,
    GL_SHORT,
    GL_UNSIGNED_BYTE,
    GL_UNSIGNED_INT,
    GL_UNSIGNED_SHORT,
)
from glshim.spec.matrices import MATRIX_CALLS
from glshim.spec.roles import Role, role_of
from glshim.spec.shapes import Shape
from glshim.system import memory
from glshim.system.interrupts import is_ours

_NESTING = 64
_AGAIN = 1024
_NAMES = 0xFFFFFFFF
"""What names wrap at."""
_serial = count()
_ID_TYPES = {
    GL_BYTE: np.int8, GL_UNSIGNED_BYTE: np.uint8, GL_SHORT: np.int16, GL_UNSIGNED_SHORT: np.uint16,
    GL_INT: np.int32, GL_UNSIGNED_INT: np.uint32, GL_FLOAT: np.float32,
}  # fmt: skip
_BYTES = {GL_2_BYTES: 2, GL_3_BYTES: 3, GL_4_BYTES: 4}
"""Of a name that is spelled out, the greatest first."""


ShapePolygons = Callable[[Shape], PolygonBatch | None]
"""Polygons of a shape, found again by key or drawn in feedback mode."""


@dataclass(slots=True)
class ListProgram:
    """What one list holds."""

    items: list[Step] = field(default_factory=list)
    changed: set[int] = field(default_factory=set)
    """The parameters of materials that it changes inside primitives, or that it has follow the
    current colour; 0: those that do so when it is called."""


class Facts(NamedTuple):
    """What is known of calling a list."""

    draws_ink: bool
    """It draws lines, points or text, and no polygons."""
    materials: Materials
    """What they do while it draws."""
    reach: frozenset[int]
    """The list and all that it calls."""


@dataclass(frozen=True, slots=True)
class ListPolygons:
    """What calling a list draws."""

    relative: PolygonBatch | None
    """In the caller's object space."""
    absolute: tuple[tuple[PolygonBatch, NDArray[np.float64]], ...] = ()
    """Under a modelview matrix that the list loads by itself."""


class ListBook:
    """The lists of one share group."""

    def __init__(self, wanted: Wanted = POSITIONS) -> None:
        self.wanted = wanted
        """What batches shall come with; may change between calls of lists."""
        self._programs: dict[int, ListProgram] = {}
        self._resolved: dict[tuple[int, int, Wanted], tuple[ListPolygons, frozenset[int]]] = {}
        self._facts: dict[int, Facts] = {}
        """By list."""
        self.open: ListProgram | None = None
        """The program being compiled."""
        self._name = 0
        """Of the list that it will be."""

    def begin(self, name: int) -> None:
        """glNewList."""
        self._name, self.open = name, ListProgram()

    def end(self) -> int | None:
        """glEndList: the list takes effect. Its name."""
        if self.open is None:
            return None
        self.open.changed |= _following_colours(self.open.items)
        self._programs[self._name] = self.open
        self._changed({self._name})
        self.open = None
        return self._name

    def _changed(self, names: set[int]) -> None:
        """What was resolved through one of these lists no longer holds."""
        stale = [at for at, (_, used) in self._resolved.items() if not used.isdisjoint(names)]
        for at in stale:
            del self._resolved[at]
        for name in [n for n, each in self._facts.items() if not each.reach.isdisjoint(names)]:
            del self._facts[name]

    def facts(self, name: int) -> Facts:
        """Of a list and all that it calls."""
        found = self._facts.get(name)
        if found is None:
            reach = frozenset(self._reach(name))
            programs = [self._programs.get(each) for each in reach]
            known = [program for program in programs if program is not None]
            steps = [item for program in known for item in program.items if type(item) is not Call]
            ink = all(map(is_no_polygon, steps)) and any(map(is_drawn, steps))
            found = self._facts[name] = Facts(
                len(known) == len(programs) and ink,
                _changing({name for program in known for name in program.changed}),
                reach,
            )
        return found

    def _reach(self, name: int) -> set[int]:
        """The list and all that it calls, whether they exist or not."""
        reached: set[int] = set()
        waiting = [name]
        while waiting:
            each = waiting.pop()
            if each not in reached:
                reached.add(each)
                program = self._programs.get(each)
                for item in program.items if program is not None else ():
                    if isinstance(item, Call):
                        waiting += item.names
        return reached

    def redefined_elsewhere(self, name: int) -> None:
        """Another context, which may share lists with ours, compiled this list."""
        if name not in self._programs:
            self._changed({name})

    def items(self, name: int) -> Iterator[Step]:
        """What the list says, nested lists included."""
        return self._items(name, (), count())

    def _items(self, name: int, within: tuple[int, ...], again: Iterator[int]) -> Iterator[Step]:
        """within: the lists that call it; again: counts calls of lists by themselves, of which
        there are more than anyone waits for where each makes two."""
        program = self._programs.get(name)
        if program is None:  # perhaps one that we did not see: it may set the normal
            yield NOBODY_KNOWS
            return
        if len(within) > _NESTING or (name in within and next(again) > _AGAIN):
            return
        for item in program.items:
            if isinstance(item, Call):
                for called in item.names:
                    yield from self._items(called, (*within, name), again)
            else:
                yield item

    def leaves_open(self, name: int) -> bool:
        """Whether calling the list ends inside a primitive that it began."""
        found = False
        for item in self.items(name):
            found = isinstance(item, Opening) or (found and not isinstance(item, Closing))
        return found

    def knows(self, name: int) -> bool:
        """Whether the list was seen being compiled."""
        return name in self._programs

    def forget(self, first: int, count: int) -> None:
        """glDeleteLists."""
        if count > len(self._programs):
            gone = [n for n in self._programs if first <= n < first + count]
        else:
            gone = [n for n in range(first, first + count) if n in self._programs]
        for name in gone:
            del self._programs[name]
        self._changed(set(gone))

    def polygons(
        self, name: int, matrix_mode: int, shapes: ShapePolygons, context: int
    ) -> ListPolygons:
        """What calling this list draws, with keys so that caches find it again."""
        at = (name, matrix_mode, self.wanted)
        known = self._resolved.get(at)
        if known is None:
            found = self._resolve(name, matrix_mode, shapes, context)
            known = self._resolved[at] = (found, frozenset(self._reach(name)))
        return known[0]

    def _resolve(
        self, name: int, matrix_mode: int, shapes: ShapePolygons, context: int
    ) -> ListPolygons:
        key = ("list", context, name, next(_serial))
        walk = _Walk(matrix_mode, shapes, self.wanted)
        walk.run(self.items(name))
        relative = [b for b, _, loaded in walk.found if not loaded]
        absolute = tuple(
            (join([b], (*key, i)), m)
            for i, (b, m, loaded) in enumerate(walk.found)
            if loaded
        )
        if not relative:
            return ListPolygons(None, absolute)
        return ListPolygons(join(relative, key), absolute)


class _Walk:
    """Runs a list as the driver would, following matrices and the switches that matter."""

    def __init__(self, matrix_mode: int, shapes: ShapePolygons, wanted: Wanted) -> None:
        self._wanted = wanted
        self._normal = normals.UNKNOWN if wanted.normals else b""
        """The record of the normal that holds; the caller's is not known."""
        self.found: list[tuple[PolygonBatch, NDArray[np.float64], bool]] = []
        self._shapes = shapes
        self._mode = matrix_mode
        self._matrix = np.eye(4)
        self._loaded = False
        self._stack: list[tuple[NDArray[np.float64], bool]] = []
        self._switches: dict[str, bool] = {"depth": True, "fill": True, "write": True}
        self._attributes: list[tuple[dict[str, bool], bytes | None]] = []
        self._pending: list[tuple[int, bytes]] = []

    def run(self, items: Iterable[Step]) -> None:
        for item in items:
            if isinstance(item, Primitive):
                self._pending.append((item.mode, self._normal + item.stream))
                self._say(item.stream)
                continue
            self._emit()
            if isinstance(item, PolygonBatch):
                self._draw(item)
            elif isinstance(item, (LooseVertices, Opening)):
                self._say(item.stream)
            elif isinstance(item, Change):
                self._change(item)
            elif isinstance(item, Shape):
                batch = self._shapes(item)
                if batch is not None:
                    self._take(batch)
                self._forget()
        self._emit()

    def _say(self, stream: bytes) -> None:
        if self._wanted.normals:
            self._normal = normals.after(stream, self._normal)

    def _forget(self) -> None:
        """Something has set a normal that is not known."""
        if self._wanted.normals:
            self._normal = normals.UNKNOWN

    def _draw(self, batch: PolygonBatch) -> None:
        """Arrays: without normals of their own they have the one that holds; with some, that is
        undefined afterwards (OpenGL 2.1, section 2.8)."""
        if not self._wanted.normals:
            batch = replace(batch, normals=None)
        elif batch.normals is None:
            batch = normals.throughout(batch, self._normal)
        elif batch.normals is not None:
            self._forget()
        self._take(batch)

    def _emit(self) -> None:
        if self._pending:
            batch = assemble_many(self._pending, wanted=self._wanted)
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
        role, args = role_of(change.name), change.args
        if role is Role.MATRIX_MODE:
            self._mode = arguments.name(args, 0)
        elif role in _MATRIX_ROLES:
            if self._mode == GL_MODELVIEW:
                self._move(role, change)
        elif role is Role.ATTRIB_PUSH:
            kept = self._normal if arguments.name(args, 0) & GL_CURRENT_BIT else None
            self._attributes.append((dict(self._switches), kept))
        elif role is Role.ATTRIB_POP:
            if self._attributes:
                self._switches, kept = self._attributes.pop()
                self._normal = self._normal if kept is None else kept
        elif role is Role.ENABLE or role is Role.DISABLE:
            if arguments.name(args, 0) == GL_DEPTH_TEST:
                self._switches["depth"] = role is Role.ENABLE
        elif role is Role.DEPTH_MASK:
            self._switches["write"] = bool(number(args, 0))
        elif role is Role.POLYGON_MODE:
            self._switches["fill"] = arguments.name(args, 1) == GL_FILL

    def _move(self, role: Role, change: Change) -> None:
        if role is Role.MATRIX_PUSH:
            self._stack.append((self._matrix, self._loaded))
        elif role is Role.MATRIX_POP:
            if self._stack:
                self._matrix, self._loaded = self._stack.pop()
        elif change.name in MATRIX_CALLS:
            call = MATRIX_CALLS[change.name]
            try:
                matrix = matrix_of(call, change.args)
            except (ArithmeticError, TypeError, ValueError) as error:
                if not is_ours(error):
                    raise
                return  # GL makes an error of it, or we miss
            self._matrix = matrix if call.loads else self._matrix @ matrix
            self._loaded = self._loaded or call.loads


def _following_colours(items: Iterable[Step]) -> set[int]:
    """Parameters of materials that steps of a list have follow the current colour, see
    `ListProgram.changed`."""
    found, parameter = set(), 0
    for item in items:
        if not isinstance(item, Change):
            continue
        role = role_of(item.name)
        if role is Role.COLOUR_MATERIAL:
            parameter = arguments.name(item.args, 1)
        elif role is Role.ENABLE and arguments.name(item.args, 0) == GL_COLOR_MATERIAL:
            found.add(parameter)
    return found


def _changing(parameters: set[int]) -> Materials:
    """What materials of which these change do."""
    if GL_DIFFUSE in parameters:
        return Materials.SHADE
    return Materials.VARY if parameters else Materials.STAY


_MATRIX_ROLES = frozenset((Role.MATRIX, Role.MATRIX_PUSH, Role.MATRIX_POP))


def list_names(role: Role, args: Sequence[Any], base: int) -> tuple[int, ...]:
    """The lists that a call of LIST_CALLS runs; `base` is GL_LIST_BASE."""
    given = tuple(args)
    if role is Role.LIST_CALL:
        return (arguments.name(given, 0),)
    count, type_ = number(given, 0), arguments.name(given, 1)
    spelled = type_ in _BYTES
    dtype = np.dtype(np.uint8 if spelled else _ID_TYPES.get(type_, np.void))
    size = _BYTES.get(type_, dtype.itemsize)
    if not size or count <= 0:
        return ()
    try:
        raw = memory.read(address_of(given[2]), count * size)
    except TypeError as error:
        if not is_ours(error):
            raise
        raw = None
    if raw is None:
        say_once("unstyled: glCallLists, because the names of its lists cannot be read")
        return ()
    offsets = raw.view(dtype)
    if spelled:
        offsets = offsets.reshape(-1, size).astype(np.int64) @ 256 ** np.arange(size)[::-1]
    return tuple(int(i) + base & _NAMES for i in offsets[np.isfinite(offsets)])
