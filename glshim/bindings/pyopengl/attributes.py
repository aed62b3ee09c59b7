"""The hooks of recorded attributes: from the arguments of a call to its record.

They run once a vertex, so each is one function over as few cells as can be. What does not pack is
the driver's to refuse; what a signal handler raises meanwhile is the program's, and comes before
the vertex is recorded or after it.
"""

from __future__ import annotations

from typing import Any

from numpy import ndarray

from glshim.bindings.pyopengl import forward
from glshim.bindings.pyopengl.conversions import INTEGERS, LISTED, as_c_takes
from glshim.bindings.pyopengl.raw import Call, Maker
from glshim.bindings.pyopengl.record import Record
from glshim.spec.attributes import Attribute
from glshim.system.interrupts import is_ours

_MISSING: Any = object()
_SEQUENCES = (list, tuple, ndarray)


def scalars(state: Record, row: Attribute) -> Maker:
    """The form with an argument for each component."""
    return _integers(state, row) if row.type in INTEGERS else _floats(state, row)


def _floats(state: Record, row: Attribute) -> Maker:
    tag, pack, size = row.tag, row.pack.pack, row.size
    taken = as_c_takes(row)

    def other(real: Call, args: tuple[Any, ...]) -> Any:
        """Straight through, or an argument that does not pack: the driver decides."""
        args = tuple(a for a in args if a is not _MISSING)
        state.spill()
        result = real(*args)
        if state.shadow:
            state.write(taken(args))
        return result

    def make1(real: Call) -> Call:
        def record(x: Any = _MISSING, /, *more: Any) -> Any:
            write = state.held
            if write is not None and not more:
                try:
                    said = pack(x, tag)
                except Exception as error:
                    if not is_ours(error):
                        raise
                else:
                    write(said)
                    return None
            return other(real, (x, *more))

        return record

    def make2(real: Call) -> Call:
        def record(x: Any = _MISSING, y: Any = _MISSING, /, *more: Any) -> Any:
            write = state.held
            if write is not None and not more:
                try:
                    said = pack(x, y, tag)
                except Exception as error:
                    if not is_ours(error):
                        raise
                else:
                    write(said)
                    return None
            return other(real, (x, y, *more))

        return record

    def make3(real: Call) -> Call:
        def record(x: Any = _MISSING, y: Any = _MISSING, z: Any = _MISSING, /, *more: Any) -> Any:
            write = state.held
            if write is not None and not more:
                try:
                    said = pack(x, y, z, tag)
                except Exception as error:
                    if not is_ours(error):
                        raise
                else:
                    write(said)
                    return None
            elif write is None and not state.shadow and z is not _MISSING:
                return real(x, y, z, *more)
            return other(real, (x, y, z, *more))

        return record

    def make4(real: Call) -> Call:
        def record(*args: Any) -> Any:
            write = state.held
            if write is not None:
                try:
                    said = pack(*args, tag)
                except Exception as error:
                    if not is_ours(error):
                        raise
                else:
                    write(said)
                    return None
            return other(real, args)

        return record

    return (make1, make2, make3, make4)[size - 1]


def _integers(state: Record, row: Attribute) -> Maker:
    tag, pack = row.tag, row.pack.pack
    convert = INTEGERS[row.type](row.size)
    taken = as_c_takes(row)

    def make(real: Call) -> Call:
        def record(*args: Any) -> Any:
            write = state.held
            if write is not None:
                try:
                    said = pack(*convert(*args), tag)
                except Exception as error:
                    if not is_ours(error):
                        raise
                    state.spill()
                else:
                    write(said)
                    return None
            result = real(*args)
            if state.shadow:
                state.write(taken(args))
            return result

        return record

    return make


def pointers(state: Record, row: Attribute) -> Maker:
    """The vector form on the raw layer: its argument is something with an address."""
    taken = as_c_takes(row)

    def make(real: Call) -> Call:
        def record(*args: Any) -> Any:
            if state.held is None and not state.shadow:
                return real(*args)
            try:
                values = forward.read(row, *args)
            except TypeError as error:
                if not is_ours(error):
                    raise
                state.spill()
                return real(*args)
            if state.shadow:
                result = real(*args)
                state.write(taken(values))
                return result
            state.write(taken(values))
            return None

        return record

    return make


def vectors(state: Record, row: Attribute) -> Maker:
    """The vector form as PyOpenGL wraps it: lists, tuples and arrays are unpacked here."""
    tag, pack = row.tag, row.pack.pack
    convert = LISTED[row.type](row.size) if row.type in LISTED else None

    def make(base: Call) -> Call:
        def record(this: Any, v: Any = _MISSING, /, *more: Any) -> Any:
            write = state.held
            if write is not None and type(v) in _SEQUENCES:
                try:
                    said = pack(*(convert(*v) if convert else v), tag)
                except Exception as error:
                    if not is_ours(error):
                        raise
                else:
                    write(said)
                    return None
            return base(this, *((v, *more) if v is not _MISSING else ()))

        return record

    return make
