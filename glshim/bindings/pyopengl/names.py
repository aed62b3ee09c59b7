"""The names that a program is given, where its driver counts upwards: with objects of ours among
them it would go on from those, so names are given here as it would have without us
(`glshim.driver.objects`).

With drivers that give the least name that is free, nothing is hooked.
"""

from __future__ import annotations

import ctypes
from functools import partial
from types import ModuleType
from typing import Any

from glshim.bindings.imports import after_import
from glshim.bindings.pyopengl import programs
from glshim.bindings.pyopengl.raw import RAW, Call, Maker, hook_function_below
from glshim.driver import kinds, objects
from glshim.driver.arguments import name as name_among
from glshim.driver.arguments import place_of
from glshim.spec.kinds import PROGRAM, Kind
from glshim.spec.naming import BINDINGS, PLAIN, Naming, Row, row_of
from glshim.system.interrupts import Held


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
            if kind is PROGRAM:
                RAW.hook_below(programs.maker_of)
                for module, name in PLAIN:
                    after_import(module, partial(_hook_plain, name))
            else:
                RAW.hook_below(lambda name: _maker(kind, name))


def _hook_plain(name: str, module: ModuleType) -> None:
    """Hook a call that PyOpenGL has as a function of ctypes', in a wrapper, and in what logs calls
    where a flag asks for it (`OpenGL.logs`: what is called lies under an empty name)."""
    function: Any = getattr(module, name, None)
    while function is not None and not hasattr(type(function), "_flags_"):
        logged = vars(function).get("") if hasattr(function, "__dict__") else None
        function = logged or getattr(function, "wrappedOperation", None)
    maker = programs.maker_of(name)
    if function is not None and maker is not None:
        hook_function_below(function, maker)


def _maker(kind: Kind, name: str) -> Maker | None:
    row = row_of(name)
    if row is None or row.kind is not kind:
        return None
    return _meeting(row) if row.naming is Naming.MEETS else _giving(row)


def _meeting(row: Row) -> Maker:
    kind, position, floors = row.kind, row.position, objects.floors

    def maker(real: Call) -> Call:
        def meet(args: tuple[Any, ...]) -> None:
            name = name_among(args, position)
            if name > floors[kind]:
                space = programs.space()
                if space is not None and kind in space.last and programs.may_ask():
                    space.met(kind, name)

        from OpenGL.error import GLError  # not before the program has set its flags

        def hook(*args: Any, **named: Any) -> Any:  # `programs.made`, for calls that are made often
            try:
                result = real(*args, **named)
            except GLError:
                meet(args)
                raise
            meet(args)
            return result

        return hook

    return maker


def _giving(row: Row) -> Maker:
    def maker(real: Call) -> Call:
        def hook(*args: Any, **named: Any) -> Any:
            space = programs.space()
            if space is None or row.kind not in space.last:
                return real(*args, **named)
            with Held():
                return programs.made(
                    lambda: real(*args, **named), lambda: _rename(row, args, space))

        return hook

    return maker


def _rename(row: Row, args: tuple[Any, ...], space: objects.Space) -> None:
    """Have the program given its own names, in place of those that the driver has given."""
    kind, count = row.kind, name_among(args, row.position)
    address = place_of(args[row.position + 1]) if 0 < count < 1 << 31 else 0
    if not address:
        return
    memory = (ctypes.c_uint * count).from_address(address)
    if not objects.is_late(memory[0]):  # an error: none were given
        return
    ask = programs.may_ask()
    kinds.delete(kind, memory)
    names = space.given(kind, count, ask=ask)
    if row.naming is Naming.CREATES and (ask or kind in kinds.ASKED):
        target = name_among(args, 0) if row.position else 0
        for name in names:
            kinds.create(kind, name, target, BINDINGS.get(target, 0))
    for k, name in enumerate(names):
        memory[k] = name


NAMES = Names()
