"""Functions of C libraries that take numbers and addresses alone.

PyOpenGL converts the arguments of a call once, and what arrives is known; it can be said again
without any of the program's objects.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

from glshim.bindings.pyopengl import conversions
from glshim.bindings.pyopengl.raw import checked, original_call
from glshim.system.prototypes import function_type


class Numeric:
    """One of them, without a result. Called with numbers as they arrive it makes its call, past
    every hook and check."""

    def __init__(self, function: Any, letters: str) -> None:
        """letters: see `letters`."""
        self.usual = original_call(function)
        """As PyOpenGL makes it."""
        self._function, self._parameters = function, function.argtypes
        self._types = [conversions.ELEMENTS[letter] for letter in letters]
        self._letters = letters
        self._convert: Callable[..., tuple[Any, ...]] | None = None
        self._driver = function_type(None)(ctypes.cast(function, ctypes.c_void_p).value)

    def takes_others(self) -> bool:
        """The program has given it other parameters since."""
        return self._function.argtypes is not self._parameters

    def arrived(self, args: tuple[Any, ...]) -> tuple[Any, ...]:
        """What would arrive, an address as an integer. May run code of the program's, and raises
        what PyOpenGL raises."""
        if self._convert is None:
            self._convert = conversions.numbers(self._function, self._letters)
        return self._convert(*args)

    def __call__(self, values: tuple[Any, ...]) -> None:
        self._driver(*[kind(value) for kind, value in zip(self._types, values, strict=True)])

    def checked(self, args: tuple[Any, ...]) -> Any:
        """PyOpenGL's own check of a call with these arguments; gives the call's result."""
        return checked(self._function, None, args)


def letters(function: Any) -> str | None:
    """The types of its parameters, each one of `conversions.ELEMENTS`; None where there are others,
    such as arrays."""
    found = [_letter(kind) for kind in function.argtypes or ()]
    return "".join(found) if all(found) else None


def _letter(kind: Any) -> str:
    if isinstance(kind, type) and issubclass(kind, ctypes._Pointer):
        return "p"
    return _LETTERS.get(kind, "")


_LETTERS = {conversions.ELEMENTS[letter]: letter for letter in "fdisue"}
