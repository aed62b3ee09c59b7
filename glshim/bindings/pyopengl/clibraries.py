"""Hooks on the C libraries that draw by themselves: GLU, GLUT, GLE."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Hashable
from contextlib import nullcontext
from functools import partial
from types import ModuleType
from typing import Any

from numpy import generic, ndarray

from glshim.bindings.base import ShapeSink
from glshim.bindings.imports import after_import
from glshim.bindings.pyopengl.numeric import Numeric, letters
from glshim.bindings.pyopengl.raw import Call, hook_function, original_call
from glshim.bindings.pyopengl.recorder import RECORDER
from glshim.driver.functions import gl
from glshim.notices import say_fault, say_once
from glshim.spec.constants import GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_VIEWPORT
from glshim.spec.shapes import (
    GLU_AUTO_LOAD_MATRIX,
    GLU_OUTSIDE,
    LENGTHS,
    LINE_STYLES,
    ROWS,
    Shape,
    ShapeRole,
    shape_role,
)
from glshim.system.interrupts import Held, is_ours

_OF_QUADRICS = frozenset((
    ShapeRole.QUADRIC_STYLE, ShapeRole.QUADRIC_ORIENTATION, ShapeRole.QUADRIC_END,
))  # fmt: skip
"""They draw nothing."""
_OF_NUMBERS = _OF_QUADRICS | {ShapeRole.SOLID, ShapeRole.QUADRIC}
"""What their arguments arrive as is all that matters; where these are no arrays."""
Tell = Callable[[Shape | None], None]
Described = Callable[[tuple[Any, ...], Tell], Any]
"""Makes a call with these arguments, tells what it has drawn, and gives its result."""


class CLibraries:
    """The hooks on GLU, GLUT and GLE. One instance: :data:`C_LIBRARIES`."""

    def __init__(self) -> None:
        self._watcher: ShapeSink | None = None
        self._installed = False
        self._hooked: list[Any] = []
        self._settings: dict[int, dict[ShapeRole, int]] = {}
        """By quadric."""
        self._surface: list[tuple[Call, tuple[Any, ...]]] = []

    def install(self) -> None:
        """What is held back of an open primitive goes before what a library says to the driver, in
        libraries imported already or later."""
        self._installed = True
        for module in sorted({home for home, _, _ in ROWS}):
            after_import(module, self._hook_module)

    def uninstall(self) -> None:
        """Take the hooks away."""
        self.detach()
        self._installed = False
        for function in self._hooked:
            hook_function(function, None)
        self._hooked.clear()

    def attach(self, watcher: ShapeSink) -> None:
        """Tell a watcher about every shape."""
        self._watcher = watcher

    def detach(self) -> None:
        """Tell nobody any more."""
        self._watcher = None
        self._surface.clear()

    def _hook_module(self, module: ModuleType) -> None:
        if not self._installed:
            return
        for name, function in list(vars(module).items()):
            role = shape_role(module.__name__, name)
            if role is None or not hasattr(type(function), "_flags_"):
                continue
            hook_function(function, self._hook(name, role, function))
            self._hooked.append(function)

    def _hook(self, name: str, role: ShapeRole, function: Any) -> Call:
        call = original_call(function)
        if role in (ShapeRole.NURBS_OPEN, ShapeRole.NURBS_PART):
            return lambda *args: self._nurbs_part(role, call, args)
        described: Described = partial(self._others, name, role, call)
        if role in _OF_NUMBERS:
            types = letters(function)
            if types is not None:
                described = partial(self._numbers, name, role, Numeric(function, types))
        if role in _OF_QUADRICS:
            return lambda *args: (
                call(*args) if self._watcher is None else described(args, _to_nobody)
            )

        def hook(*args: Any) -> Any:
            watcher, record = self._watcher, RECORDER.record
            record.spill()
            if record.inside() and not record.list_open:
                # Its glBegin is refused, its vertices are the primitive's, and its glEnd ends it.
                result = call(*args)
                record.ended_unheard()
                return result
            if watcher is None or record.inside():
                return call(*args)
            watcher.before_shape(name)
            try:
                return described(args, watcher.after_shape)
            except BaseException:
                watcher.after_shape(None)
                raise

        return hook

    def _numbers(
        self, name: str, role: ShapeRole, numeric: Numeric, args: tuple[Any, ...], tell: Tell
    ) -> Any:
        if numeric.takes_others():
            result = numeric.usual(*args)
            tell(None)
            return result
        values = numeric.arrived(args)
        # What is known of a list is what is in it. Outside, a handler costs lines of one frame.
        with Held() if RECORDER.record.list_open else nullcontext():
            numeric(values)
            result = numeric.checked(args)
            tell(_contained(name, lambda: self._of_numbers(name, role, numeric, values)))
        return result

    def _of_numbers(
        self, name: str, role: ShapeRole, numeric: Numeric, values: tuple[Any, ...]
    ) -> Shape | None:
        if role is ShapeRole.QUADRIC_END:
            self._settings.pop(values[0], None)
        elif role in _OF_QUADRICS:
            self._settings.setdefault(values[0], {})[role] = values[1]
        elif role is ShapeRole.QUADRIC:
            settings = self._settings.get(values[0], {})
            if settings.get(ShapeRole.QUADRIC_STYLE) not in LINE_STYLES:
                turn = settings.get(ShapeRole.QUADRIC_ORIENTATION, GLU_OUTSIDE)
                unit, scale = _unit(name, values[1:])
                return Shape((name, turn, unit), lambda: _quadric(name, turn, unit), scale)
        else:
            unit, scale = _unit(name, values)
            return Shape((name, unit), lambda: numeric(unit), scale)
        return None

    def _others(
        self, name: str, role: ShapeRole, call: Call, args: tuple[Any, ...], tell: Tell
    ) -> Any:
        result = call(*args)
        tell(_contained(name, lambda: self._of_others(name, role, call, args)))
        return result

    def _of_others(
        self, name: str, role: ShapeRole, call: Call, args: tuple[Any, ...]
    ) -> Shape | None:
        if role is ShapeRole.NURBS_CLOSE:
            parts, self._surface = [*self._surface, (call, args)], []
            key = _content(name, [a for _, each in parts for a in each])
            return Shape(key, _nurbs(parts), camera_bound=True)
        if role is ShapeRole.EXTRUSION:
            return Shape(_content(name, args), lambda: call(*args))
        if role in _OF_NUMBERS:
            raise _Unknown("it takes an array")
        return None

    def _nurbs_part(self, role: ShapeRole, call: Call, args: tuple[Any, ...]) -> Any:
        result = call(*args)
        if self._watcher is not None:
            if role is ShapeRole.NURBS_OPEN:
                self._surface = []
            self._surface.append((call, args))
        return result


def _to_nobody(shape: Shape | None) -> None:
    """What draws nothing has nothing to tell."""


def _contained(name: str, describe: Callable[[], Shape | None]) -> Shape | None:
    try:
        return describe()
    except Exception as error:
        if not is_ours(error):
            raise
        if isinstance(error, _Unknown):
            say_once(f"unstyled: {name}, because {error}")
        else:
            say_fault(f"{name} stays unlined", error)
        return None


def _quadric(name: str, orientation: int, scalars: tuple[Any, ...]) -> None:
    """The same shape from a quadric of our own: the app may have deleted its."""
    from OpenGL.platform import PLATFORM

    library = PLATFORM.GLU
    library.gluNewQuadric.restype = ctypes.c_void_p
    quadric = ctypes.c_void_p(library.gluNewQuadric())
    library.gluQuadricOrientation(quadric, ctypes.c_uint(orientation))
    arguments = [ctypes.c_int(v) if type(v) is int else ctypes.c_double(v) for v in scalars]
    getattr(library, name)(quadric, *arguments)
    library.gluDeleteQuadric(quadric)


def _unit(name: str, values: tuple[Any, ...]) -> tuple[tuple[Any, ...], float]:
    """The arguments of the same shape with a greatest length of 1, and how much larger it is:
    a sphere that pulses is one shape."""
    lengths = LENGTHS.get(name, ())
    scale = max((abs(values[i]) for i in lengths), default=1.0)
    if not 0.0 < scale < float("inf"):
        return values, 1.0
    return tuple(v / scale if i in lengths else v for i, v in enumerate(values)), scale


class _Unknown(Exception):
    """An argument that cannot be looked into, in words."""


def _content(name: str, args: Any) -> Hashable | None:
    """A key from everything the arguments hold; None when one of them cannot be looked into. Raises
    _Unknown where code of the program's might run for it, or in the call that is made again."""
    parts: list[Hashable] = [name]
    for arg in args:
        kind = type(arg)
        if kind in _PLAIN:
            parts.append(arg)
        elif issubclass(kind, int) and kind.__module__ == _CONSTANTS:
            parts.append(int(arg))
        elif issubclass(kind, generic) and kind.__module__ == "numpy":
            parts.append(arg.item())
        elif issubclass(kind, ctypes._Pointer):
            parts.append(_address(arg))
        elif kind is ndarray or issubclass(kind, _OF_CTYPES):
            parts.append(bytes(memoryview(arg)))
        elif kind is _REFERENCE:
            return None
        else:
            raise _Unknown(f"nobody knows what a {kind.__name__} holds")
    return tuple(parts)


_PLAIN = frozenset((int, float, bool, bytes, type(None)))
_CONSTANTS = "OpenGL.constant"
"""Where PyOpenGL's own kinds of numbers live."""
_OF_CTYPES = (ctypes.Array, ctypes.Structure, ctypes._SimpleCData)
_REFERENCE = type(ctypes.byref(ctypes.c_int()))


def _address(pointer: Any) -> int:
    if issubclass(type(pointer), ctypes.Structure):
        return ctypes.addressof(pointer)
    return ctypes.cast(pointer, ctypes.c_void_p).value or 0


def _nurbs(parts: list[tuple[Call, tuple[Any, ...]]]) -> Callable[[], None]:
    """Draws a surface again, tessellated for the camera that is current now."""
    from OpenGL.platform import PLATFORM

    modelview, projection = (ctypes.c_float * 16)(), (ctypes.c_float * 16)()
    viewport = (ctypes.c_int * 4)()
    gl.glGetFloatv(GL_MODELVIEW_MATRIX, modelview)
    gl.glGetFloatv(GL_PROJECTION_MATRIX, projection)
    gl.glGetIntegerv(GL_VIEWPORT, viewport)
    renderer = ctypes.c_void_p(_address(parts[0][1][0]))
    set_property = PLATFORM.GLU.gluNurbsProperty
    load = PLATFORM.GLU.gluLoadSamplingMatrices
    get_property = PLATFORM.GLU.gluGetNurbsProperty

    def draw() -> None:
        automatic = ctypes.c_float()
        get_property(renderer, ctypes.c_uint(GLU_AUTO_LOAD_MATRIX), ctypes.byref(automatic))
        if automatic.value:
            set_property(renderer, ctypes.c_uint(GLU_AUTO_LOAD_MATRIX), ctypes.c_float(0.0))
            load(renderer, modelview, projection, viewport)
        try:
            for call, args in parts:
                call(*args)
        finally:
            if automatic.value:
                set_property(renderer, ctypes.c_uint(GLU_AUTO_LOAD_MATRIX), ctypes.c_float(1.0))

    return draw


C_LIBRARIES = CLibraries()
