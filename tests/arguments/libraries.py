"""What programs call of GLU and GLUT, with arguments of every kind."""

from __future__ import annotations

import ctypes
import functools
import re
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from OpenGL import GLU, GLUT

from tests.arguments import kinds

_LEFT_OUT = re.compile(
    r"glu(Delete|New|Build|ScaleImage|CheckExtension)\w*"
    r"|glut\w*(Menu|MainLoop|Window|Screen|Overlay|Icon|GameMode|Video|Init|Warp|Color|Title"
    r"|Cursor|Sponge|Repeat|Layer|ProcAddress|Options?|ForceJoystickFunc|Destroy|TimerFunc"
    r"|ReportErrors|CheckLoop|ModeValues)\w*"
)  # fmt: skip
"""What makes windows, ends, waits or reads what is not there: nobody stands around these."""
_SURFACE = re.compile(r"gluNurbsSurface|glu(Begin|End)Trim|gluPwlCurve|gluNurbsCurve")
PLACES = ("outside", "inside", "fed back alone", "list")
_IDENTITY = np.eye(4).ravel()
_OBJECTS: dict[str, Any] = {}
"""By the names of arguments."""
Given = tuple[str, list[Any], dict[str, Any]]


def objects() -> dict[str, Any]:
    if not _OBJECTS:
        made = GLU.gluNewQuadric(), GLU.gluNewNurbsRenderer(), GLU.gluNewTess()
        _OBJECTS.update(zip(("quad", "nurb", "tess"), made, strict=True))
    return _OBJECTS


def functions() -> Iterator[tuple[str, Any]]:
    """What is called, by name."""
    for module, prefix in ((GLU, "glu"), (GLUT, "glut")):
        for name, found in sorted(vars(module).items()):
            if re.match(prefix + "[A-Z]", name) and not _LEFT_OUT.fullmatch(name) and found:
                yield name, found


def places(name: str) -> tuple[str, ...]:
    return ("surface",) if _SURFACE.fullmatch(name) else PLACES


def valid(name: str, argument: str, kind: Any) -> Any:
    """What may be given, of what ctypes would take."""
    if argument in objects():
        return objects()[argument]
    if argument == "font":
        return GLUT.GLUT_STROKE_ROMAN if "Stroke" in name else GLUT.GLUT_BITMAP_8_BY_13
    if argument == "string" or kind is ctypes.c_char_p:
        return b"ab" if kind is ctypes.c_char_p else np.frombuffer(b"ab\0", np.uint8)
    if argument in ("view", "viewport"):
        return np.array([0, 0, 64, 64], np.int32)
    if argument in ("model", "proj", "perspective"):
        return _IDENTITY.astype(getattr(kind, "baseType", np.float64))
    if argument == "extension":
        return b"GL_ARB_imaging"
    return _NUMBERS.get(argument, 0.5 if kind in (ctypes.c_double, ctypes.c_float) else 4)


_NUMBERS = {"which": GLU.GLU_TESS_TOLERANCE, "property": GLU.GLU_SAMPLING_TOLERANCE,
            "draw": GLU.GLU_FILL, "normal": GLU.GLU_SMOOTH, "orientation": GLU.GLU_OUTSIDE,
            "query": GLUT.GLUT_WINDOW_WIDTH, "error": 1280, "name": GLU.GLU_VERSION,
            "character": ord("a")}  # fmt: skip


def pointers(value: Any) -> dict[str, Callable[[], Any]]:
    """Kinds of what has the address of an object of the library's."""
    other = ctypes.pointer(ctypes.c_int(1))
    there = value.contents if isinstance(value, ctypes._Pointer) else value
    return {
        "by reference": lambda: ctypes.byref(there),
        "cast": lambda: ctypes.cast(ctypes.byref(there), ctypes.POINTER(type(there))),
        "parameter": lambda: kinds.Parameter(value),
        "asked parameter": lambda: Asked(value),
        "deep parameter": lambda: Asked(Asked(value)),
        "void": lambda: ctypes.cast(ctypes.byref(there), ctypes.c_void_p),
        "array": ctypes.POINTER(type(there)) * 64,
        "other": lambda: other,
        "number": lambda: 1,
        "str": lambda: "1",
        "object": object,
        "list": lambda: [value],
        "raising": kinds.Raising,
    }


class Asked:
    """Counts how often it is asked for what it stands for."""

    def __init__(self, value: Any) -> None:
        self._value = value

    @property
    def _as_parameter_(self) -> Any:
        kinds.CALLS.append("parameter")
        return self._value


class _Called:
    def __call__(self, *args: Any) -> None:
        kinds.CALLS.append(f"called {args}")

    def method(self, *args: Any) -> None:
        kinds.CALLS.append(f"method {args}")


CALLBACKS: dict[str, Callable[[], Any]] = {
    "none": lambda: None,
    "0": lambda: 0,
    "str": lambda: "1",
    "object": object,
    "function": lambda: _Called().method,
    "lambda": lambda: lambda *args: kinds.CALLS.append(f"lambda {args}"),
    "called": _Called,
    "partial": lambda: functools.partial(_Called(), 1),
    "takes none": lambda: lambda: kinds.CALLS.append("none"),
    "takes three": lambda: lambda a, b, c: kinds.CALLS.append(f"three {a} {b} {c}"),
    "class": lambda: _Called,
    "of C's": lambda: ctypes.CFUNCTYPE(None)(_Called()),
    "of C's, number": lambda: ctypes.CFUNCTYPE(None, ctypes.c_int)(_Called()),
    "builtin": lambda: len,
    "raising": kinds.Raising,
}


def registrations() -> Iterator[Given]:
    """What is given to what registers a callback."""
    for word, make in CALLBACKS.items():
        yield word, [make], {}
        yield f"{word}, named", [], {"function": make}
        yield f"{word}, extra", [make, 10], {}
    yield "nothing", [], {}
    yield "odd keyword", [CALLBACKS["lambda"]], {"odd": 1}
