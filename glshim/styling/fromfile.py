"""Stylers from Python files that are installed nowhere: ``path/my_style.py:MyStyle``."""

from __future__ import annotations

import dataclasses
import inspect
import linecache
import os
import sys
import traceback
from pathlib import Path
from types import ModuleType

from glshim.errors import StyleError, nearest
from glshim.styling.former import advice
from glshim.styling.options import Option, options_of
from glshim.styling.protocol import Styler
from glshim.system.modules import OURS_ALONE, STYLE_FILE
from glshim.system.reading import has_elevated_rights, read_small

SUFFIX = ".py"


def is_named_in(text: str) -> bool:
    """Whether a style text begins with the path of a Python file."""
    return split(text)[0].endswith(SUFFIX)


def split(text: str) -> tuple[str, str, str]:
    """Path, class and assignments of a style text, those that it lacks empty."""
    drive, rest = os.path.splitdrive(text)
    path, _, rest = rest.partition(":")
    name, _, assignments = rest.partition(":")
    return drive + path, name.strip(), assignments


def watched(path: Path) -> list[Path]:
    """The file, and the shaders beside it, which it reads when it is loaded."""
    try:
        return [path, *sorted(path.parent.glob("*.glsl"))]
    except (OSError, ValueError):  # not a path
        return [path]


def load(path: Path, name: str) -> type[Styler]:
    """Run the file and take the class of that name from it, afresh at each call.

    Raises `StyleError` with one line: the file, the line where there is one, and what is wrong.
    """
    if not name:
        raise StyleError(f"{path} names no class: write {path.name}:MyStyle")
    module = _run(path)
    found = getattr(module, name, None)
    if found is None:
        classes = [key for key, value in vars(module).items() if _is_own(value, module)]
        near = nearest(name, classes) or classes
        hint = f": did you mean {' or '.join(near)}?" if near else ", and no styler at all"
        raise StyleError(f"{path}: there is no class {name!r}{hint}")
    fault = shortcoming(found)
    if fault:
        raise StyleError(f"{_place(path, module, found)}: {name} {fault}")
    styler: type[Styler] = found
    try:
        styler()
    except Exception as error:  # whatever its constructor does
        raise StyleError(_told(path, error, f"{name}() raises ")) from error
    return styler


def shortcoming(found: object) -> str:
    """What keeps a class from being a styler, with what to do; nothing where it is one."""
    if not (isinstance(found, type) and issubclass(found, Styler)):
        return "is not a styler: derive it from glshim.Styler"
    if "__dataclass_fields__" not in vars(found):
        return "is not a dataclass: write @dataclass(frozen=True) over it"
    if not isinstance(found.name, str) or not found.name.isidentifier():
        return 'has no name: write name: ClassVar[str] = "my_style"'
    if found.draws is Styler.draws:
        return "has no method draws(self, layer)"
    described = {option.name for option in options_of(found)}
    for each in dataclasses.fields(found):
        if each.name not in described:
            return f"has a field {each.name!r} that is not an option: give it option(..., help=...)"
    for option in options_of(found):
        fault = _bad(option)
        if fault:
            return f"has an option {option.name!r} {fault}"
    return ""


def _bad(option: Option) -> str:
    """What is wrong with how an option is described."""
    try:
        option.check(option.default)
    except StyleError as error:
        return f"whose default is not allowed: {error}"
    return ""


def _run(path: Path) -> ModuleType:
    if has_elevated_rights():
        raise StyleError(f"{path}: Python files are not run in a setuid or setgid program")
    try:
        source = read_small(path)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise StyleError(f"cannot read style file {str(path)!r}: {reason}") from error
    module = ModuleType(STYLE_FILE + path.stem)
    module.__file__ = str(path)
    # Dataclasses and pickle look a class's module up here. Compiled anew each time: a cache on the
    # disk takes two saves in one second for the same file.
    sys.modules[module.__name__] = module
    try:
        with OURS_ALONE:
            exec(compile(source, str(path), "exec"), vars(module))
    except SyntaxError as error:
        line = error.lineno if error.filename == str(path) else None
        raise StyleError(f"{path}:{line or 1}: {error.msg}") from error
    except (Exception, SystemExit) as error:  # whatever somebody's file does when it is run
        raise StyleError(_told(path, error)) from error
    return module


def _is_own(value: object, module: ModuleType) -> bool:
    return (
        isinstance(value, type)
        and issubclass(value, Styler)
        and value.__module__ == module.__name__
    )


def _told(path: Path, error: BaseException, what: str = "") -> str:
    """One line: where in the file an exception came from, and what it says."""
    lines = [f.lineno for f in traceback.extract_tb(error.__traceback__) if f.filename == str(path)]
    place = f":{lines[-1]}" if lines else ""
    reason = " ".join(str(error).splitlines()) + advice(error)
    kind = type(error).__name__
    return f"{path}{place}: {what}{kind}{': ' if reason else ''}{reason}"


def _place(path: Path, module: ModuleType, found: object) -> str:
    """The file, and the line where a class of its own begins."""
    linecache.checkcache(str(path))
    try:
        if isinstance(found, type) and found.__module__ == module.__name__:
            return f"{path}:{inspect.getsourcelines(found)[1]}"
    except (OSError, TypeError):
        pass
    return str(path)
