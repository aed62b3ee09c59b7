"""One process that makes calls with odd arguments, plain or under a style.

``python worker.py JSON``; `tests.arguments.told` says what is in it.

It prints the number and name of a case before it, and what came of it after.
"""
# ruff: noqa: E402

from __future__ import annotations

import ctypes
import importlib
import json
import pkgutil
import random
import re
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import partial
from typing import Any

GIVEN = json.loads(sys.argv[1])
import OpenGL

for _flag, _value in GIVEN["flags"].items():
    setattr(OpenGL, _flag, _value)

from tests.arguments import others

if GIVEN["others"] == "first":
    import glfw

    others.first()
from OpenGL import GL
from OpenGL.arrays import ArrayDatatype
from OpenGL.arrays.lists import ListHandler

if GIVEN["libraries"]:
    from OpenGL import GLU, GLUT

    from tests.arguments import libraries
if GIVEN["others"] == "last":
    others.last()
import glfw
import numpy as np

from glshim.spec import naming
from glshim.spec.attributes import BY_NAME
from glshim.spec.roles import Role, role_of
from tests.arguments import kinds

PLACES = ("outside", "inside", "fed back", "list")
TOO_SHORT = frozenset((
    "short", "shorter", "empty", "empty tuple", "nothing", "0-d", "c shorter", "scalar", "none",
    "number", "bytes", "str", "bytearray", "c wrong", "object", "by reference", "of dtype i1",
    "of dtype u1", "of dtype ?", "of dtype f2", "of dtype i2", "buffer object", "backwards",
))  # fmt: skip
"""Kinds behind which a raw call, which looks at no size, would read what is not there."""
Case = tuple[str, str, Callable[..., Any], list[Any], dict[str, Any]]


def is_hooked(name: str) -> bool:
    """Whether any style stands around a call, or what gives the program names."""
    if role_of(name) is not Role.PASS or naming.row_of(name) or naming.row_of_names(name):
        return True
    asks = (naming.makes, naming.returns, naming.labels, naming.places_of)
    return name in naming.ANSWERS or any(ask(name) for ask in asks)


def functions() -> Iterator[tuple[str, Any]]:
    """What programs call, by every hooked name: as PyOpenGL wraps it, and raw."""
    for name in sorted(vars(GL)):
        if name.startswith("gl") and is_hooked(name):
            yield name, getattr(GL, name)
    import OpenGL.raw.GL as package

    seen = set()
    for module in sorted(
        m.name for m in pkgutil.walk_packages(package.__path__, package.__name__ + ".")
    ):
        if not GIVEN["everything"] and ".VERSION." not in module:
            continue
        with suppress(AttributeError):
            for name, found in sorted(vars(importlib.import_module(module)).items()):
                if name.startswith("gl") and hasattr(found, "argNames") and name not in seen:
                    seen.add(name)
                    if is_hooked(name):
                        yield name + " raw", found


def raw_of(found: Any) -> Any:
    """What has the names and types of its arguments."""
    for attribute in ("wrappedOperation", "baseFunction"):
        with suppress(AttributeError):
            return raw_of(getattr(found, attribute))
    return found


WORDS = {"mode": 4, "type": GL.GL_UNSIGNED_INT, "pname": GL.GL_SHININESS, "face": GL.GL_FRONT,
         "target": GL.GL_ARRAY_BUFFER, "mask": GL.GL_COLOR_BUFFER_BIT, "list": 5, "cap": GL.GL_FOG,
         "format": GL.GL_RGBA, "texture": GL.GL_TEXTURE0, "usage": GL.GL_STATIC_DRAW,
         "buffer": GL.GL_COLOR}  # fmt: skip


def element_of(kind: Any) -> np.dtype[Any] | None:
    """What lies behind a pointer; None for a scalar."""
    base = getattr(kind, "baseType", None)
    if base is not None and hasattr(kind, "asArray"):
        with suppress(Exception):
            return np.dtype(base if np.dtype(base).kind != "S" else np.uint8)
        return np.dtype(np.uint8)
    if kind is ctypes.c_void_p or hasattr(kind, "asArray"):
        return np.dtype(np.uint32)
    if isinstance(kind, type) and issubclass(kind, ctypes._Pointer):
        return np.dtype(np.uint32)
    return None


def count_of(name: str) -> int:
    """How many elements a vector form takes; 0 where that is not in its name."""
    found = re.search(r"(\d)(?:ub|us|ui|[bsifdh])v", name)
    return (
        int(found[1]) if found else int(name.startswith(("glEdgeFlagv", "glIndex", "glFogCoord")))
    )


def _array(count: int, element: np.dtype[Any]) -> np.ndarray[Any, Any]:
    """For each case its own: it may be written to, and behind its end."""
    found = np.zeros(_ROOM, element)[:count]
    found[:] = np.arange(count) % 3
    return found


_ROOM = 1 << 14
"""Elements."""


def valid(name: str, argument: str, kind: Any) -> Any:
    element = element_of(kind)
    if element is not None:
        return partial(_array, count_of(name) or 64, element)
    if kind in (ctypes.c_float, ctypes.c_double):
        return 0.5
    return WORDS.get(argument, 1)


def cases() -> Iterator[Case]:
    every = list(libraries.functions() if GIVEN["libraries"] else functions())
    chosen = [each for each in every if re.search(GIVEN["only"], each[0])]
    if GIVEN["functions"]:
        chosen = random.Random(GIVEN["seed"]).sample(chosen, min(GIVEN["functions"], len(chosen)))
    for name, call in chosen:
        raw = raw_of(call)
        names, types = (
            list(getattr(raw, "argNames", ())),
            list(getattr(raw, "argtypes", None) or ()),
        )
        if hasattr(call, "callbackType"):
            for word, args, named in libraries.registrations():
                yield f"{name} {word}", "outside", call, args, named
        elif len(names) == len(types):
            known = libraries.valid if GIVEN["libraries"] else valid
            base = [known(name, a, t) for a, t in zip(names, types, strict=True)]
            for place in libraries.places(name) if GIVEN["libraries"] else PLACES:
                for word, args, named in calls(name, names, types, base):
                    yield f"{name} {place} {word}", place, call, args, named


def calls(
    name: str, names: list[str], types: list[Any], base: list[Any]
) -> Iterator[tuple[str, list[Any], dict[str, Any]]]:
    """What is given, in words; positional, and named."""
    yield "valid", base, {}
    yield "keyword", base, {"odd": 1}
    yield "keywords", [], dict(zip(names, base, strict=True))
    yield "one keyword", base[:-1], dict(zip(names[-1:], base[-1:], strict=True))
    yield "none", [], {}
    yield "missing", base[:-1], {}
    for extra in (1, "1", 0.5, None, object()):
        yield f"extra {extra!s:.3}", [*base, extra], {}
    for at, kind in enumerate(types):
        element = element_of(kind)
        if GIVEN["libraries"] and names[at] in libraries.objects():
            made = libraries.pointers(base[at])
        elif element is None:
            made = kinds.SCALARS
        else:
            made = kinds.vectors(count_of(name) or 64, element)
            checked = "raw" not in name and name.rstrip("v") in BY_NAME
            if not (checked and OpenGL.ARRAY_SIZE_CHECKING):
                made = {word: make for word, make in made.items() if word not in TOO_SHORT}
        for word, make in made.items():
            yield f"{at} {word}", [*base[:at], make, *base[at + 1 :]], {}
    if len(types) > 1 and not any(element_of(t) for t in types):
        for word in ("raising", "number", "f4", "c_float", "bool", "lying"):
            make = kinds.SCALARS[word]
            yield f"all {word}", [make] * len(types), {}
            yield f"{word}, str", [make, "1", *base[2:]], {}


class Handler(ListHandler):
    """Of the program's own: lists are made ten times as large."""

    def asArray(self, value: Any, typeCode: Any = None) -> Any:
        kinds.CALLS.append("handler")
        return ListHandler.asArray([10 * v for v in value], typeCode)


def clean(text: str) -> str:
    text = re.sub(r"0x[0-9a-f]+|\b\d{7,}\b(?!\*)", "N", text)
    text = re.sub(r"<[\w.]+\.(\w+_Array_\d+)", r"<\1", text)  # who asks first for such a type
    return re.sub(r"c_void_p\(\w+\)|(<cparam '.').*?>", r"\1P", text)[:600]


def told(error: BaseException) -> list[str]:
    found = [type(error).__name__, clean(str(error))]
    for name in ("err", "result", "cArguments", "pyArgs", "cArgs"):
        if hasattr(error, name):
            found.append(f"{name} {clean(repr(getattr(error, name)))}")
    operation = getattr(error, "baseOperation", None)
    found.append(f"{type(operation).__name__} {getattr(operation, '__name__', '')}")
    found += [clean(repr(e)) for e in (error.__context__, error.__cause__)]
    return found


NAMES = (GL.GL_CURRENT_COLOR, GL.GL_CURRENT_NORMAL, GL.GL_CURRENT_TEXTURE_COORDS, GL.GL_EDGE_FLAG,
         GL.GL_MODELVIEW_STACK_DEPTH, GL.GL_ATTRIB_STACK_DEPTH, GL.GL_LIST_INDEX)  # fmt: skip


def errors() -> list[int]:
    found: list[int] = []
    with suppress(GL.GLError):
        while len(found) < 5 and (error := GL.glGetError()):
            found.append(int(error))
    return found


def run(case: Case) -> list[Any]:
    _, place, call, makes, named = case
    kinds.CALLS.clear()
    args = [make() if callable(make) else make for make in makes]
    named = {name: make() if callable(make) else make for name, make in named.items()}
    found: list[Any] = []
    # A matrix of chance may put points on the edge of what is clipped.
    for matrix in (GL.GL_TEXTURE, GL.GL_PROJECTION, GL.GL_MODELVIEW):
        told_of(GL.glMatrixMode, matrix)
        told_of(GL.glLoadIdentity)
    told_of(GL.glColor4f, 1, 1, 1, 1)
    told_of(GL.glNormal3f, 0, 0, 1)
    told_of(GL.glTexCoord2f, 0, 0)
    told_of(GL.glEdgeFlag, True)
    if place.startswith("fed back"):
        told_of(GL.glFeedbackBuffer, 2000, GL.GL_4D_COLOR_TEXTURE)
        told_of(GL.glRenderMode, GL.GL_FEEDBACK)
    if place == "list":
        told_of(GL.glNewList, 77, GL.GL_COMPILE)
    elif place == "surface":
        GLU.gluBeginSurface(libraries.objects()["nurb"])
    elif place in ("inside", "fed back"):
        told_of(GL.glBegin, GL.GL_POINTS if place == "fed back" else GL.GL_TRIANGLES)
        told_of(GL.glVertex3f, 0.1, 0.2, 0.3)
    try:
        returned = call(*args, **named)
        found.append(clean(repr(returned)))
        if hasattr(call, "callbackType") and callable(returned):
            returned(*[5] * len(type(returned)._argtypes_))
    except Exception as error:
        found += told(error)
    found.append(list(kinds.CALLS))
    if place in ("inside", "fed back"):
        found += [told_of(GL.glVertex3f, 0.3, 0.2, 0.1), told_of(GL.glEnd)]
    elif place == "surface":
        GLU.gluEndSurface(libraries.objects()["nurb"])
    elif place == "list":
        found += [told_of(GL.glEndList), told_of(GL.glCallList, 77)]
    for end in (GL.glEnd, GL.glEndList):
        found.append(told_of(end))
    if place.startswith("fed back"):
        try:
            points = [point for part in GL.glRenderMode(GL.GL_RENDER) for point in part[1:]]
            found.append(clean(repr([(v.vertex, v.color, v.texture) for v in points])))
        except Exception as error:  # PyOpenGL's own, with some flags
            found.append(type(error).__name__)
    found += errors()
    for name in NAMES:
        with suppress(GL.GLError):
            found.append(np.asarray(GL.glGetFloatv(name)).tolist())
    return found


def told_of(call: Callable[..., Any], *args: Any) -> str:
    try:
        call(*args)
    except Exception as error:
        return clean(str(told(error)))
    return ""


def window() -> Callable[[], object]:
    """Makes one, and gives what shows it."""
    if GIVEN["libraries"]:
        GLUT.glutInit(["arguments"])
        GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE | GLUT.GLUT_RGB | GLUT.GLUT_DEPTH)
        GLUT.glutInitWindowSize(64, 64)
        GLUT.glutCreateWindow(b"arguments")
        return GLUT.glutSwapBuffers  # type: ignore[no-any-return]
    if not glfw.init():
        sys.exit("no display")
    glfw.window_hint(glfw.VISIBLE, 0)
    made = glfw.create_window(64, 64, "arguments", None, None)
    glfw.make_context_current(made)
    return lambda: glfw.swap_buffers(made)


def _ignored(it: Any) -> None:
    """What a callback raises, and C gives to nobody."""
    kinds.CALLS.append(f"ignored {clean(repr(it.exc_value))}")


def main() -> None:
    sys.unraisablehook = _ignored
    show = window()
    GL.glEnable(GL.GL_DEPTH_TEST)
    if not GIVEN["libraries"]:
        WORDS["program"] = GL.glCreateProgram()
        WORDS["shader"] = GL.glCreateShader(GL.GL_VERTEX_SHADER)
    told_of(GL.glEnableClientState, GL.GL_VERTEX_ARRAY)
    points = np.random.RandomState(0).rand(4096, 3).astype("f")
    told_of(GL.glVertexPointer, 3, GL.GL_FLOAT, 0, points)
    told_of(GL.glNewList, 5, GL.GL_COMPILE)
    told_of(GL.glEndList)
    if GIVEN["handler"]:
        ArrayDatatype.getRegistry().register(Handler(), [list])
    every = list(cases())
    print("of", len(every))
    chosen = list(range(len(every)))
    if GIVEN["count"]:
        count = min(GIVEN["count"], len(chosen))
        chosen = sorted(random.Random(GIVEN["seed"]).sample(chosen, count))
    skipped = set(GIVEN["skipped"])
    for turn, at in enumerate(chosen):
        if at < GIVEN["first"]:
            continue
        if at in skipped:  # plain PyOpenGL ended here
            print("again", at + 1, flush=True)
            return
        print(f"> {at} {every[at][0]}", flush=True)
        print(f"< {at} {json.dumps(run(every[at]))}")
        if turn % 50 == 49:
            GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
            errors()
            if GIVEN["others"] != "last":  # else a program without a window
                show()
    print("alive", flush=True)


main()
