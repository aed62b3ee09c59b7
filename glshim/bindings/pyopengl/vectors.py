"""The hooks of recorded attributes in their vector forms, as PyOpenGL wraps them.

What a list, a tuple or an array holds becomes a record where it is known that it would arrive so at
the driver (see ``attributes.py``); PyOpenGL converts the rest.
"""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
from numpy import ndarray
from numpy.typing import NDArray

from glshim.bindings.pyopengl.attributes import MISSING, REALS
from glshim.bindings.pyopengl.conversions import ELEMENTS, INTEGERS, sequences
from glshim.bindings.pyopengl.raw import Call, Maker
from glshim.bindings.pyopengl.record import Record
from glshim.spec.attributes import Attribute
from glshim.system.interrupts import is_ours

_DOUBLES = np.dtype(np.float64)
_DTYPES = {letter: np.dtype(type_) for letter, type_ in ELEMENTS.items()}
"""Made now: numpy loads a module for it, which later it might not find."""
_HOME = "OpenGL.GL.VERSION.GL_1_0"
"""Where PyOpenGL wraps them."""


def vectors(state: Record, row: Attribute) -> Maker:
    """The wrapped vector form."""
    if row.type in INTEGERS or row.size == 1:
        return _any(state, row)
    return _floats(state, row)


def _any(state: Record, row: Attribute) -> Maker:
    tag, pack, name = row.tag, row.pack.pack, row.name + "v"
    convert = INTEGERS[row.type](row.size) if row.type in INTEGERS else None
    dtypes = (_DTYPES[row.type],)

    def make(base: Call) -> Call:
        own: Any = MISSING

        def record(this: Any, v: Any = MISSING, /, *more: Any, **named: Any) -> Any:
            nonlocal own
            write = state.held
            if write is not None and this is own and not more:
                kind = type(v)
                if kind in (state.sequences or sequences(state)) and not named:
                    try:
                        found = v if kind is not ndarray else _listed(v, dtypes)
                        found = convert(*found) if convert else _reals(found)
                        said = pack(*found, tag)
                    except Exception as error:  # too many, too large, of another type
                        if not is_ours(error):
                            raise
                    else:
                        write(said)
                        return None
            elif own is MISSING:
                own = _own(name)
            return base(this, *_given(v, more), **named)

        return record

    return make


def _floats(state: Record, row: Attribute) -> Maker:
    tag, pack, name = row.tag, row.pack.pack, row.name + "v"
    real_types, dtypes = REALS, (_DTYPES[row.type], _DOUBLES)

    def make2(base: Call) -> Call:
        own: Any = MISSING

        def record(this: Any, v: Any = MISSING, /, *more: Any, **named: Any) -> Any:
            nonlocal own
            write = state.held
            if write is not None and this is own and not more:
                kind = type(v)
                if kind in (state.sequences or sequences(state)) and not named:
                    try:
                        x, y = v if kind is not ndarray else _listed(v, dtypes)
                        said = (
                            pack(x, y, tag)
                            if ((t := type(x)) is float or t in real_types)
                            and ((t := type(y)) is float or t in real_types)
                            else b""
                        )
                    except Exception as error:  # too many, too large
                        if not is_ours(error):
                            raise
                    else:
                        if said:
                            write(said)
                            return None
            elif own is MISSING:
                own = _own(name)
            return base(this, *_given(v, more), **named)

        return record

    def make3(base: Call) -> Call:
        own: Any = MISSING

        def record(this: Any, v: Any = MISSING, /, *more: Any, **named: Any) -> Any:
            nonlocal own
            write = state.held
            if write is not None and this is own and not more:
                kind = type(v)
                if kind in (state.sequences or sequences(state)) and not named:
                    try:
                        x, y, z = v if kind is not ndarray else _listed(v, dtypes)
                        said = (
                            pack(x, y, z, tag)
                            if ((t := type(x)) is float or t in real_types)
                            and ((t := type(y)) is float or t in real_types)
                            and ((t := type(z)) is float or t in real_types)
                            else b""
                        )
                    except Exception as error:  # too many, too large
                        if not is_ours(error):
                            raise
                    else:
                        if said:
                            write(said)
                            return None
            elif own is MISSING:
                own = _own(name)
            return base(this, *_given(v, more), **named)

        return record

    def make4(base: Call) -> Call:
        own: Any = MISSING

        def record(this: Any, v: Any = MISSING, /, *more: Any, **named: Any) -> Any:
            nonlocal own
            write = state.held
            if write is not None and this is own and not more:
                kind = type(v)
                if kind in (state.sequences or sequences(state)) and not named:
                    try:
                        x, y, z, w = v if kind is not ndarray else _listed(v, dtypes)
                        said = (
                            pack(x, y, z, w, tag)
                            if ((t := type(x)) is float or t in real_types)
                            and ((t := type(y)) is float or t in real_types)
                            and ((t := type(z)) is float or t in real_types)
                            and ((t := type(w)) is float or t in real_types)
                            else b""
                        )
                    except Exception as error:  # too many, too large
                        if not is_ours(error):
                            raise
                    else:
                        if said:
                            write(said)
                            return None
            elif own is MISSING:
                own = _own(name)
            return base(this, *_given(v, more), **named)

        return record

    return (make2, make3, make4)[row.size - 2]


def _reals(numbers: Any) -> Any:
    """The same; raises TypeError where it is not known what arrives."""
    if REALS.issuperset(map(type, numbers)):
        return numbers
    raise TypeError


def _listed(array: NDArray[Any], dtypes: tuple[np.dtype[Any], ...]) -> Any:
    """What is in an array of one of these types; raises TypeError for others."""
    if array.dtype in dtypes and array.ndim == 1:
        return array.tolist()
    raise TypeError


def _own(name: str) -> Any:
    """PyOpenGL's wrapper of a name: one of the program's may convert otherwise."""
    return getattr(sys.modules.get(_HOME), name, None)


def _given(v: Any, more: tuple[Any, ...]) -> tuple[Any, ...]:
    return () if v is MISSING else (v, *more)
