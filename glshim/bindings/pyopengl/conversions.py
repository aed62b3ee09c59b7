"""How C and numpy convert the arguments of recorded calls, in plain Python."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import index
from struct import Struct
from typing import Any

from glshim.bindings.pyopengl.forward import ELEMENTS
from glshim.spec.attributes import Attribute
from glshim.system.interrupts import is_ours


def enum(value: Any) -> int:
    """An enum given as something that ctypes takes for an integer; -1 for anything else."""
    try:
        return index(getattr(value, "value", value))
    except TypeError as error:
        if not is_ours(error):
            raise
        return -1


def as_c_takes(row: Attribute) -> Callable[[Sequence[Any]], bytes]:
    """Makes the record of arguments that the driver took, converted as C does: integers wrap,
    large doubles become infinite. Empty when that cannot be told."""
    convert = INTEGERS[row.type](row.size) if row.type in INTEGERS else None
    element = ELEMENTS["f" if row.type == "d" else row.type]
    pack, tag, size = row.pack.pack, row.tag, row.size

    def taken(args: Sequence[Any]) -> bytes:
        try:
            values = [element(getattr(a, "value", a)).value for a in args[:size]]
            return pack(*(convert(*values) if convert else values), tag)
        except Exception as error:
            if not is_ours(error):
                raise
            return b""

    return taken


def _ranged(letter: str) -> Callable[[int], Callable[..., tuple[Any, ...]]]:
    def sized(size: int) -> Callable[..., tuple[Any, ...]]:
        check = Struct(f"={size}{letter}").pack

        def convert(*args: Any) -> tuple[Any, ...]:
            check(*args)  # floats, or integers that C would wrap: not recorded
            return args

        return convert

    return sized


def _bytes(size: int) -> Callable[..., tuple[Any, ...]]:
    """Unsigned bytes as C takes them (300 is 44), made 0..1 as GL does."""
    if size == 3:
        return lambda r, g, b: ((r & 255) / 255.0, (g & 255) / 255.0, (b & 255) / 255.0)
    return lambda r, g, b, a: (
        (r & 255) / 255.0, (g & 255) / 255.0, (b & 255) / 255.0, (a & 255) / 255.0
    )  # fmt: skip


def _strict_bytes(size: int) -> Callable[..., tuple[Any, ...]]:
    """Unsigned bytes from a list, which numpy converts and does not wrap."""
    check = Struct(f"={size}B").pack
    return lambda *args: tuple(value / 255.0 for value in check(*args))


def _switch(size: int) -> Callable[..., tuple[Any, ...]]:
    return lambda flag: (flag & 255,)  # Mesa answers glGet by its very value


def _strict_switch(size: int) -> Callable[..., tuple[Any, ...]]:
    check = Struct("=B").pack
    return lambda flag: tuple(check(flag))


_Converters = dict[str, Callable[[int], Callable[..., tuple[Any, ...]]]]
INTEGERS: _Converters = {"i": _ranged("i"), "s": _ranged("h"), "u": _bytes, "b": _switch}
"""By type letter: from an argument count to what turns C integers into the recorded floats."""
LISTED: _Converters = {**INTEGERS, "u": _strict_bytes, "b": _strict_switch}
"""The same for members of lists, tuples and arrays."""
