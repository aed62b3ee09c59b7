"""The hooks of recorded attributes: from the arguments of a call to its record.

They run once a vertex, so each is one function over as few cells as can be. Here only arguments of
kinds are taken that are known to arrive at the driver as they are: to look at them runs no code of
the program's. All others PyOpenGL converts (``conversions.py``). What a signal handler raises
meanwhile is the program's, and comes before the vertex is recorded or after it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import numpy as np

from glshim.bindings.pyopengl import conversions, forward
from glshim.bindings.pyopengl.conversions import INTEGERS
from glshim.bindings.pyopengl.raw import Call, Maker
from glshim.bindings.pyopengl.record import Record
from glshim.spec.attributes import Attribute
from glshim.system.interrupts import at_once, is_ours

MISSING: Any = object()
REALS = frozenset((
    float, int, bool, np.float16, np.float32, np.float64, np.int8, np.int16, np.int32, np.int64,
    np.uint8, np.uint16, np.uint32, np.uint64,
))  # fmt: skip
"""Exact types of numbers that are made C's floats without any code of the program's."""


def scalars(state: Record, row: Attribute) -> Maker:
    """The form with an argument for each component."""
    return _integers(state, row) if row.type in INTEGERS else _floats(state, row)


def _floats(state: Record, row: Attribute) -> Maker:
    tag, pack, size = row.tag, row.pack.pack, row.size
    real_types = REALS

    def make1(real: Call) -> Call:
        other = _others(state, row, real)

        def record(x: Any = MISSING, /, *more: Any, **named: Any) -> Any:
            write = state.held
            if write is not None and type(x) in real_types and not more:
                try:
                    said = pack(x, tag)
                except Exception as error:  # too large
                    if not is_ours(error):
                        raise
                else:
                    write(said)
                    return None
            return other((x, *more), named)

        return record

    def make2(real: Call) -> Call:
        other = _others(state, row, real)

        def record(x: Any = MISSING, y: Any = MISSING, /, *more: Any, **named: Any) -> Any:
            write = state.held
            if (
                write is not None
                and ((t := type(x)) is float or t is int or t in real_types)
                and ((t := type(y)) is float or t is int or t in real_types)
                and not more
            ):
                try:
                    said = pack(x, y, tag)
                except Exception as error:
                    if not is_ours(error):
                        raise
                else:
                    write(said)
                    return None
            return other((x, y, *more), named)

        return record

    def make3(real: Call) -> Call:
        other = _others(state, row, real)

        def record(
            x: Any = MISSING, y: Any = MISSING, z: Any = MISSING, /, *more: Any, **named: Any
        ) -> Any:
            write = state.held
            if (
                write is not None
                and ((t := type(x)) is float or t is int or t in real_types)
                and ((t := type(y)) is float or t is int or t in real_types)
                and ((t := type(z)) is float or t is int or t in real_types)
                and not more
            ):
                try:
                    said = pack(x, y, z, tag)
                except Exception as error:
                    if not is_ours(error):
                        raise
                else:
                    write(said)
                    return None
            elif write is None and not state.shadow and z is not MISSING:
                return real(x, y, z, *more, **named)
            return other((x, y, z, *more), named)

        return record

    def make4(real: Call) -> Call:
        other = _others(state, row, real)

        def record(
            x: Any = MISSING,
            y: Any = MISSING,
            z: Any = MISSING,
            w: Any = MISSING,
            /,
            *more: Any,
            **named: Any,
        ) -> Any:
            write = state.held
            if (
                write is not None
                and ((t := type(x)) is float or t is int or t in real_types)
                and ((t := type(y)) is float or t is int or t in real_types)
                and ((t := type(z)) is float or t is int or t in real_types)
                and ((t := type(w)) is float or t is int or t in real_types)
                and not more
            ):
                try:
                    said = pack(x, y, z, w, tag)
                except Exception as error:
                    if not is_ours(error):
                        raise
                else:
                    write(said)
                    return None
            return other((x, y, z, w, *more), named)

        return record

    return (make1, make2, make3, make4)[size - 1]


def _integers(state: Record, row: Attribute) -> Maker:
    tag, pack = row.tag, row.pack.pack
    convert = INTEGERS[row.type](row.size)

    def make(real: Call) -> Call:
        other = _others(state, row, real)

        def record(*args: Any, **named: Any) -> Any:
            write = state.held
            if write is not None:
                try:
                    said = pack(*convert(*args), tag)
                except Exception as error:
                    if not is_ours(error):
                        raise
                else:
                    write(said)
                    return None
            return other(args, named)

        return record

    return make


def _others(
    state: Record, row: Attribute, real: Call
) -> Callable[[tuple[Any, ...], dict[str, Any]], Any]:
    """What is called outside primitives, what is not held back, and arguments of any other kind."""
    said, arrives = conversions.recorded(row), conversions.ELEMENTS[row.type]
    known = frozenset((int,)) if row.type in INTEGERS else REALS
    converted: _Converted | None = None

    def other(args: tuple[Any, ...], named: dict[str, Any]) -> Any:
        nonlocal converted
        args = tuple([a for a in args if a is not MISSING])
        if state.held is None and not state.shadow:
            return real(*args, **named)
        if converted is None:
            function = conversions.function_of(real)
            if function is None:  # only PyOpenGL makes the call: it logs it
                state.spill()
                result = real(*args, **named)
                if state.shadow and len(args) == row.size and known.issuperset(map(type, args)):
                    state.write(said([arrives(value).value for value in args]))
                return result
            converted = _Converted(state, row, real, function, vector=False)
        return converted(args, named)

    return other


class _Converted:
    """A call whose arguments PyOpenGL converts: what arrives is recorded."""

    def __init__(
        self, state: Record, row: Attribute, real: Call, function: Any, *, vector: bool
    ) -> None:
        self._state, self._real = state, real
        self._said = conversions.recorded(row)
        self._driver = conversions.driver_of(function)
        if vector:
            self._convert = conversions.behind(function, row.type, row.size)
            pack = conversions.layout(row.type, row.size).pack
            self._given: Callable[..., Iterable[Any]] = lambda values: (pack(*values),)
        else:
            self._convert = conversions.numbers(function, row.type * row.size)
            self._given = partial(map, conversions.ELEMENTS[row.type])

    def __call__(self, args: tuple[Any, ...], named: dict[str, Any]) -> Any:
        values = self._convert(*args, **named)  # may run code of the program's
        state = self._state
        if state.held is not None:
            state.held(self._said(values))
        elif state.shadow:
            said = self._said(values)
            at_once((partial(self._driver, *self._given(values)), partial(state.write, said)))
        else:
            self._driver(*self._given(values))
        return forward.check(self._real, args)


def pointers(state: Record, row: Attribute) -> Maker:
    """The vector form on the raw layer: its argument is something with an address."""

    def make(real: Call) -> Call:
        converted: _Converted | None = None

        def record(*args: Any, **named: Any) -> Any:
            nonlocal converted
            if state.held is None and not state.shadow:
                return real(*args, **named)
            function = conversions.function_of(real)
            if function is None or len(args) != 1:
                state.spill()
                return real(*args, **named)
            if converted is None:
                converted = _Converted(state, row, real, function, vector=True)
            return converted(args, named)

        return record

    return make
