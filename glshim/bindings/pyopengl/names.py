"""The names that a program is given, where its driver counts upwards: with objects of ours among
them it would go on from those, so names are given here as it would have without us
(`glshim.spec.objects`).

With drivers that give the least name that is free, nothing is hooked.
"""

from __future__ import annotations

import ctypes
from operator import index
from typing import Any

import numpy as np

from glshim.bindings.pyopengl.raw import RAW, Call, Maker
from glshim.spec import objects
from glshim.spec.naming import BINDINGS, Naming, Row, row_of
from glshim.spec.objects import Kind
from glshim.system.interrupts import Held, is_ours


class Names:
    """The hooks. One instance: :data:`NAMES`."""

    def __init__(self) -> None:
        self._kinds: set[Kind] = set()

    def install(self) -> None:
        """Be ready: nothing is hooked until an object of ours is made."""
        if self._hear not in objects.heard:
            objects.heard.append(self._hear)

    def _hear(self, kind: Kind) -> None:
        """Names of a kind are to be given here. For good: the program has them then."""
        if kind not in self._kinds:
            self._kinds.add(kind)
            RAW.hook_below(lambda name: _maker(kind, name))


def _maker(kind: Kind, name: str) -> Maker | None:
    row = row_of(name)
    if row is None or row.kind is not kind:
        return None
    return _meeting(row) if row.naming is Naming.MEETS else _giving(row)


def _meeting(row: Row) -> Maker:
    kind, position, floors = row.kind, row.position, objects.floors

    def maker(real: Call) -> Call:
        def hook(*args: Any, **named: Any) -> Any:
            result = real(*args, **named)
            name = _number(args, position)
            if name > floors[kind]:
                space = objects.space()
                if space is not None and kind in space.last:
                    space.met(kind, name)
            return result

        return hook

    return maker


def _giving(row: Row) -> Maker:
    def maker(real: Call) -> Call:
        def hook(*args: Any, **named: Any) -> Any:
            space = objects.space()
            if space is None or row.kind not in space.last:
                return real(*args, **named)
            with Held():
                result = real(*args, **named)
                _rename(row, args, space)
            return result

        return hook

    return maker


def _rename(row: Row, args: tuple[Any, ...], space: objects.Space) -> None:
    """Have the program given its own names, in place of those that the driver has given."""
    kind, number = row.kind, _number(args, row.position)
    address = _address(args[row.position + 1]) if 0 < number < 1 << 31 else 0
    if not address:
        return
    memory = (ctypes.c_uint * number).from_address(address)
    if not objects.is_late(memory[0]):  # an error: none were given
        return
    kind.delete(memory)
    names = space.given(kind, number)
    if row.naming is Naming.CREATES:
        target = _number(args, 0) if row.position else 0
        for name in names:
            kind.create(name, target, BINDINGS.get(target, 0))
    for k, name in enumerate(names):
        memory[k] = name


def _number(args: tuple[Any, ...], position: int) -> int:
    """A GLuint or GLsizei among arguments that the driver took, 0 for none."""
    try:
        value = args[position]
        return index(getattr(value, "value", value)) & 0xFFFFFFFF
    except (IndexError, TypeError) as error:
        if not is_ours(error):
            raise
        return 0


def _address(value: Any) -> int:
    """Of memory that the program sees, 0 for none: PyOpenGL copies lists."""
    if isinstance(value, np.ndarray):
        return int(value.__array_interface__["data"][0])
    try:
        return int(ctypes.cast(value, ctypes.c_void_p).value or 0)
    except (TypeError, ctypes.ArgumentError) as error:
        if not is_ours(error):
            raise
        return 0


NAMES = Names()
