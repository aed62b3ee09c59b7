"""Hooks on the C libraries that draw by themselves: GLU, GLUT, GLE."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Hashable
from types import ModuleType
from typing import Any

from glshim.bindings.base import ShapeSink
from glshim.bindings.imports import after_import
from glshim.bindings.pyopengl.raw import hook_function, original_call
from glshim.bindings.pyopengl.recorder import RECORDER
from glshim.driver.functions import gl
from glshim.notices import say_fault, say_once
from glshim.spec.constants import GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_VIEWPORT
from glshim.spec.shapes import (
    COUNTS,
    GLU_AUTO_LOAD_MATRIX,
    GLU_OUTSIDE,
    LENGTHS,
    LINE_STYLES,
    ROWS,
    Shape,
    ShapeRole,
    shape_role,
)
from glshim.system.interrupts import is_ours

_SETTINGS = frozenset((ShapeRole.QUADRIC_STYLE, ShapeRole.QUADRIC_ORIENTATION))


class CLibraries:
    """The hooks on GLU, GLUT and GLE. One instance: :data:`C_LIBRARIES`."""

    def __init__(self) -> None:
        self._watcher: ShapeSink | None = None
        self._hooked: list[Any] = []
        self._settings: dict[int, dict[ShapeRole, int]] = {}
        """By quadric."""
        self._surface: list[tuple[Callable[..., Any], tuple[Any, ...]]] = []

    def attach(self, watcher: ShapeSink) -> None:
        """Tell a watcher about every shape, in libraries imported already or later."""
        self._watcher = watcher
        for module in sorted({home for home, _, _ in ROWS}):
            after_import(module, self._hook_module)

    def detach(self) -> None:
        """Take the hooks away."""
        self._watcher = None
        for function in self._hooked:
            hook_function(function, None)
        self._hooked.clear()
        self._surface.clear()

    def _hook_module(self, module: ModuleType) -> None:
        if self._watcher is None:
            return
        for name, function in list(vars(module).items()):
            role = shape_role(module.__name__, name)
            if role is None or not hasattr(type(function), "_flags_"):
                continue
            call = original_call(function)
            hook_function(function, self._hook(name, role, call))
            self._hooked.append(function)

    def _hook(self, name: str, role: ShapeRole, call: Callable[..., Any]) -> Callable[..., Any]:
        if role in _SETTINGS:
            return lambda *args: self._set_quadric(role, call, args)
        if role in (ShapeRole.NURBS_OPEN, ShapeRole.NURBS_PART):
            return lambda *args: self._nurbs_part(role, call, args)

        def hook(*args: Any) -> Any:
            watcher = self._watcher
            if watcher is None:
                return call(*args)
            RECORDER.record.spill()
            watcher.before_shape(name)
            try:
                result = call(*args)
                shape = self._described(name, role, call, args)
            except BaseException:
                watcher.after_shape(None)
                raise
            watcher.after_shape(shape)
            return result

        return hook

    def _described(
        self, name: str, role: ShapeRole, call: Callable[..., Any], args: tuple[Any, ...]
    ) -> Shape | None:
        try:
            return self._describe(name, role, call, args)
        except Exception as error:
            if not is_ours(error):
                raise
            if isinstance(error, _Unknown):
                say_once(f"unstyled: {name}, because {error}")
            else:
                say_fault(f"{name} stays unlined", error)
            return None

    def _describe(
        self, name: str, role: ShapeRole, call: Callable[..., Any], args: tuple[Any, ...]
    ) -> Shape | None:
        if role is ShapeRole.DRAWING:
            return None
        if role is ShapeRole.NURBS_CLOSE:
            parts = [*self._surface, (call, args)]
            self._surface = []
            key = _content(name, [a for _, each in parts for a in each])
            return Shape(key, _nurbs(parts), camera_bound=True)
        if role is ShapeRole.QUADRIC:
            settings = self._settings.get(_address(args[0]), {})
            if settings.get(ShapeRole.QUADRIC_STYLE) in LINE_STYLES:
                return None
            turn = settings.get(ShapeRole.QUADRIC_ORIENTATION, GLU_OUTSIDE)
            unit, scale = _unit(name, args[1:])
            return Shape((name, turn, unit), lambda: _quadric(name, turn, unit), scale)
        if role is ShapeRole.EXTRUSION:
            return Shape(_content(name, args), lambda: call(*args))
        unit, scale = _unit(name, args)
        if scale == 1.0:
            return Shape((name, unit), lambda: call(*args))
        count = len(LENGTHS[name])
        return Shape((name, unit), lambda: call(*unit[:count], *args[count:]), scale)

    def _set_quadric(
        self, role: ShapeRole, call: Callable[..., Any], args: tuple[Any, ...]
    ) -> Any:
        result = call(*args)
        try:
            self._settings.setdefault(_address(args[0]), {})[role] = int(_number(args[1]))
        except Exception as error:  # what C has taken, and we cannot read
            if not is_ours(error):
                raise
        return result

    def _nurbs_part(self, role: ShapeRole, call: Callable[..., Any], args: tuple[Any, ...]) -> Any:
        if self._watcher is not None:
            if role is ShapeRole.NURBS_OPEN:
                self._surface = []
            self._surface.append((call, args))
        return call(*args)


def _quadric(name: str, orientation: int, scalars: tuple[float, ...]) -> None:
    """The same shape from a quadric of our own: the app may have deleted its."""
    from OpenGL.platform import PLATFORM

    library = PLATFORM.GLU
    library.gluNewQuadric.restype = ctypes.c_void_p
    quadric = ctypes.c_void_p(library.gluNewQuadric())
    library.gluQuadricOrientation(quadric, ctypes.c_uint(orientation))
    counts = COUNTS[name]
    arguments = [
        ctypes.c_int(int(v)) if i in counts else ctypes.c_double(v) for i, v in enumerate(scalars)
    ]
    getattr(library, name)(quadric, *arguments)
    library.gluDeleteQuadric(quadric)


def _unit(name: str, args: tuple[Any, ...]) -> tuple[tuple[float, ...], float]:
    """The arguments of the same shape with a greatest length of 1, and how much larger it is:
    a sphere that pulses is one shape."""
    scalars = tuple(float(_number(a)) for a in args)
    lengths = LENGTHS.get(name, ())
    scale = max((abs(scalars[i]) for i in lengths), default=1.0)
    if not 0.0 < scale < float("inf"):
        return scalars, 1.0
    return tuple(v / scale if i in lengths else v for i, v in enumerate(scalars)), scale


class _Unknown(Exception):
    """An argument that is not plainly a number, in words."""


def _number(value: Any) -> Any:
    """A number that C has taken, without any code of the program's. Raises _Unknown for others."""
    kind = type(value)
    if kind in (int, float, bool):
        return value
    if issubclass(kind, int):
        return int.__index__(value)
    if kind.__module__ in ("ctypes", "numpy"):
        return value.value if kind.__module__ == "ctypes" else value.item()
    raise _Unknown(f"a {kind.__name__} is not a number that can be known")


def _content(name: str, args: Any) -> Hashable | None:
    """A key from everything the arguments hold; None when one of them cannot be looked into."""
    parts: list[Hashable] = [name]
    for arg in args:
        if isinstance(arg, (int, float)):
            parts.append(arg)
        elif arg is None:
            parts.append(None)
        elif isinstance(arg, ctypes._Pointer):
            parts.append(_address(arg))
        else:
            try:
                parts.append(bytes(memoryview(arg)))
            except TypeError:
                return None
    return tuple(parts)


def _address(pointer: Any) -> int:
    return ctypes.cast(pointer, ctypes.c_void_p).value or 0


def _nurbs(parts: list[tuple[Callable[..., Any], tuple[Any, ...]]]) -> Callable[[], None]:
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
