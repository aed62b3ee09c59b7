"""Whose key is it: whether a program's own code names a function key."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path
from types import CodeType, ModuleType

from glshim.control.keys import KEYS

_INSTALLED = ("site-packages", "dist-packages")
_OURS = ("glshim", "glshim_stylers")


@cache
def user_of(key: str) -> str | None:
    """The file of the program's own whose code names a key (``F9``, ``GLUT_KEY_F9``, ``K_F9``,
    ``Qt.Key_F9``, ``"<F9>"``), None where none does. Asked once, when the key is first pressed: by
    then the program is loaded. What it compares by number it does not name."""
    word = re.compile(rf"(?<![0-9A-Za-z#%]){re.escape(key)}(?![0-9A-Za-z])")
    for module in _own_modules():
        code = _code(module)
        words = set() if code is None else set(_words(code))
        # Who reads the variable speaks of our keys.
        if any(map(word.search, words)) and KEYS not in words:
            return str(module.__file__)
    return None


def _own_modules() -> Iterator[ModuleType]:
    """The program that was started, and what lies beside it or below."""
    main = sys.modules.get("__main__")
    file = getattr(main, "__file__", None)
    if main is None or file is None:
        return
    home = Path(file).resolve().parent
    for name, module in list(sys.modules.items()):
        found = getattr(module, "__file__", None)
        if not isinstance(found, str) or name.partition(".")[0] in _OURS:
            continue
        path = Path(found).resolve()
        if home in path.parents and not any(part in _INSTALLED for part in path.parts):
            yield module


def _code(module: ModuleType) -> CodeType | None:
    name = module.__spec__.name if module.__spec__ is not None else module.__name__
    with suppress(Exception):  # a loader without code, a file that is gone
        code: CodeType | None = module.__loader__.get_code(name)  # type: ignore[union-attr]
        return code
    return None


def _words(code: CodeType) -> Iterator[str]:
    """The names and texts of a code and of all that it holds; comments are none."""
    yield from code.co_names
    yield from _texts(code.co_consts)


def _texts(constants: Iterable[object]) -> Iterator[str]:
    for constant in constants:
        if isinstance(constant, str):
            yield constant
        elif isinstance(constant, CodeType):
            yield from _words(constant)
        elif isinstance(constant, (tuple, frozenset)):
            yield from _texts(constant)
