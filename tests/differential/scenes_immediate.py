"""Scenes of immediate mode: modes, entry points, arguments, sizes, attributes around vertices."""

from __future__ import annotations

import ctypes
import math
from typing import Any

import numpy as np
from OpenGL import GL, GLU
from OpenGL.raw.GL.VERSION import GL_1_0 as raw

from .registry import each, scene
from .world import App

MODES = {
    "points": 0, "lines": 1, "line-loop": 2, "line-strip": 3, "triangles": 4,
    "triangle-strip": 5, "triangle-fan": 6, "quads": 7, "quad-strip": 8, "polygon": 9,
}  # fmt: skip
ADJACENT = {"lines-adjacency": 10, "triangles-adjacency": 12}
SIZES = (0, 1, 2, 3, 4, 5, 7, 30, 43, 63, 64, 65, 127, 128, 129, 300, 1001)
"""Vertices: left-overs, and either side of what is drawn from arrays."""


def spiral(count: int) -> list[tuple[float, float, float]]:
    """Vertices of a picture in which the order matters."""
    return [
        (math.cos(i * 0.7) * (0.2 + i / (count + 1)), math.sin(i * 0.7) * (0.2 + i / (count + 1)),
         0.3 * math.sin(i * 0.3))
        for i in range(count)
    ]  # fmt: skip


def shade(i: int) -> tuple[float, float, float]:
    """A colour that differs from the neighbours'."""
    return (i * 37 % 100 / 99.0, i * 61 % 100 / 99.0, i * 13 % 100 / 99.0)


@each(MODES | ADJACENT)
def every_mode(app: App, mode: int) -> None:
    GL.glPointSize(3.0)
    for tile, size in enumerate(SIZES):
        GL.glViewport(tile % 6 * 16, tile // 6 * 24, 16, 24)
        app.tries(GL.glBegin, mode)
        for i, (x, y, z) in enumerate(spiral(size)):
            GL.glColor3f(*shade(i))
            GL.glNormal3f(x, y, 1.0)
            GL.glVertex3f(x, y, z)
        app.tries(GL.glEnd)
        app.error()


@each(MODES)
def flat_shading_and_polygon_mode_line(app: App, mode: int) -> None:
    GL.glShadeModel(GL.GL_FLAT)
    for provoking, count in ((0x8E4E, 40), (0x8E4D, 200)):
        GL.glProvokingVertex(provoking)
        GL.glPolygonMode(GL.GL_FRONT, GL.GL_LINE)
        GL.glPolygonMode(GL.GL_BACK, GL.GL_POINT)
        GL.glBegin(mode)
        for i, point in enumerate(spiral(count)):
            GL.glColor3f(*shade(i))
            GL.glEdgeFlag(i % 3 != 0)
            GL.glVertex3fv(point)
        GL.glEnd()
        GL.glTranslatef(0.5, 0.0, 0.0)


def forms(letter: str, size: int) -> dict[str, Any]:
    """Arguments of a vector entry point in every form that an app may give them."""
    values = {1: [1], 2: [1, 0], 3: [1, 0, 1], 4: [1, 0, 1, 1]}[size]
    element = {"f": ctypes.c_float, "d": ctypes.c_double, "i": ctypes.c_int, "s": ctypes.c_short,
               "ub": ctypes.c_ubyte, "": ctypes.c_ubyte}[letter]  # fmt: skip
    dtype = {"f": "f4", "d": "f8", "i": "i4", "s": "i2", "ub": "u1", "": "u1"}[letter]
    return {
        "list": values,
        "tuple": tuple(values),
        "floats": [float(v) for v in values],
        "array": np.array(values, dtype),
        "double": np.array(values, "f8"),
        "integers": np.array(values, "i8"),
        "strided": np.array([[v, 9] for v in values], dtype)[:, 0],
        "reversed": np.array(values, dtype)[::-1],
        "row": np.array([values], dtype),
        "column": np.array([[v] for v in values], dtype),
        "ctypes": (element * size)(*values),
        "scalars": [np.float32(v) for v in values],
        "bytes": bytes(np.array(values, dtype)),
        "large": [300.5, -1, *values][:size],
        "wraps": [300, -1, 2, 70000][:size],
        "huge": [1e300, 2**40, -(2**70), 1][:size],
        "long": [*values, 1],
        "short": values[:-1],
        "text": "abc"[:size],
        "texts": ["1"] * size,
        "nested": [values],
        "None": None,
        "complex": [1j] * size,
        "number": 1.0,
    }


FUNCTIONS = {
    "glVertex": ((2, 3, 4), ("f", "d", "i", "s")),
    "glNormal": ((3,), ("f", "d")),
    "glColor": ((3, 4), ("f", "d", "ub")),
    "glTexCoord": ((1, 2, 3, 4), ("f", "d", "i", "s")),
}
VARIANTS = {f"{stem}{size}{letter}": (size, letter) for stem, (sizes, letters) in FUNCTIONS.items()
            for size in sizes for letter in letters} | {"glEdgeFlag": (1, "")}  # fmt: skip


def _recorded() -> None:
    """A triangle, so that what was set is seen."""
    GL.glVertex2f(-1, -1)
    GL.glVertex2f(1, -1)
    GL.glVertex2f(0, 1)


_CHECKED = ("list", "tuple", "array", "double", "integers", "row", "column", "ctypes")
"""Forms for which the raw layer reads no memory but the argument's own."""


@each(VARIANTS)
def vector_forms(app: App, which: tuple[int, str]) -> None:
    size, letter = which
    name = next(n for n, v in VARIANTS.items() if v is which)
    for module in (GL, raw):
        call = getattr(module, name + "v")
        for form, value in forms(letter, size).items():
            if form == "None" or (module is raw and form not in _CHECKED):
                continue  # plain PyOpenGL reads at an address of no meaning
            GL.glBegin(GL.GL_TRIANGLES)
            app.tries(call, value)
            _recorded()
            app.tries(call, value)
            app.tries(GL.glEnd)
            app.asks(GL.GL_CURRENT_COLOR, GL.GL_CURRENT_NORMAL, GL.GL_CURRENT_TEXTURE_COORDS)
            app.tries(GL.glGetBooleanv, GL.GL_EDGE_FLAG)
        app.tries(call)
        app.tries(call, forms(letter, size)["list"], 1)


def scalars(size: int) -> list[tuple[Any, ...]]:
    """Arguments of a scalar entry point: good, odd and wrong."""
    one, alike = (0.75, 0.25, 1.0, 1.0), (0, 1, 2, 3)
    return [
        one[:size], alike[:size], tuple(np.float32(v) for v in one[:size]),
        tuple(np.float64(v) for v in one[:size]), tuple(np.int64(v) for v in alike[:size]),
        tuple(np.uint8(v) for v in (200, 100, 50, 1))[:size],
        tuple(np.int8(v) for v in (-1, 100, -50, 1))[:size],
        tuple(np.array(v) for v in alike[:size]), tuple(np.array([v]) for v in one[:size]),
        (True, False, True, True)[:size], (300, -1, 2, 511)[:size],
        (1e300, -1e300, 1e-60, 2)[:size],
        (2**31, -(2**31) - 1, 2**40, 2**63)[:size], (2**64, -(2**70), 2**200, 10**400)[:size],
        (math.inf, math.nan, -0.0, 1)[:size], ("1",) * size, (None,) * size, (1j,) * size,
        ([1],) * size, (b"a",) * size, (ctypes.c_float(0.5),) * size, (ctypes.c_int(1),) * size,
        (ctypes.c_ubyte(1),) * size, (ctypes.c_double(0.5),) * size, (),
        one[: size - 1], (*one[:size], 1.0), (alike[:size],), ([*alike[:size]],),
    ]  # fmt: skip


@each(VARIANTS)
def scalar_arguments(app: App, which: tuple[int, str]) -> None:
    size, _ = which
    name = next(n for n, v in VARIANTS.items() if v is which)
    for module in (GL, raw):
        call = getattr(module, name)
        for args in scalars(size):
            for spilled in (False, True):
                GL.glBegin(GL.GL_TRIANGLES)
                if spilled:
                    GL.glMaterialf(GL.GL_FRONT, GL.GL_SHININESS, 2.0)
                app.tries(call, *args)
                _recorded()
                app.tries(call, *args)
                app.tries(GL.glEnd)
                app.asks(GL.GL_CURRENT_COLOR, GL.GL_CURRENT_NORMAL, GL.GL_CURRENT_TEXTURE_COORDS)
                app.tries(GL.glGetBooleanv, GL.GL_EDGE_FLAG)
            app.tries(call, *args)
        GL.glBegin(GL.GL_TRIANGLES)
        try:
            call(x=1)
        except TypeError as error:
            app.saw.append("TypeError")
            assert "ecord" not in str(error)
        app.tries(GL.glEnd)


@scene
def every_unsigned_byte(app: App) -> None:
    for value in range(256):
        GL.glBegin(GL.GL_POINTS)
        GL.glColor4ub(value, 255 - value, value, 255)
        GL.glVertex3f(value / 128.0 - 1.0, 0.0, 0.0)
        GL.glColor3ubv([value, 255 - value, value])
        GL.glVertex3f(value / 128.0 - 1.0, 0.5, 0.0)
        GL.glColor3ub(300 + value, -value, value - 1000)
        GL.glVertex3f(value / 128.0 - 1.0, -0.5, 0.0)
        GL.glEnd()
        app.asks(GL.GL_CURRENT_COLOR)


@scene
def aliases_and_raw_names(app: App) -> None:
    for begin, end in ((GL.glBegin, GL.glEnd), (raw.glBegin, raw.glEnd)):
        app.tries(begin, GL.GL_TRIANGLES)
        app.tries(GL.glColor, 1.0, 0.0, 0.0)
        app.tries(GL.glNormal, 0.0, 1.0, 0.0)
        app.tries(GL.glVertex, -1, 0, 0)
        app.tries(GL.glVertex, (1, 0, 0))
        app.tries(raw.glColor3f, 0.0, 1.0, 0.0)
        app.tries(raw.glVertex3fv, np.array([0, 1, 0], "f"))
        app.tries(GL.glTexCoord, (1, 2))
        app.tries(end)
        app.error()


@each({"small": 10, "large": 300})
def changed_after_the_call(app: App, count: int) -> None:
    point, colour = np.zeros(3, "f"), [0.0, 0.0, 0.0]
    pointer = (ctypes.c_float * 3)()
    GL.glBegin(GL.GL_TRIANGLE_STRIP)
    for i, (x, y, z) in enumerate(spiral(count)):
        point[:] = x, y, z
        pointer[:] = x, y, z
        colour[:] = shade(i)
        GL.glColor3fv(colour)
        (GL.glVertex3fv if i % 2 else raw.glVertex3fv)(pointer if i % 3 else point)
    point[:] = 9.0
    colour[:] = [0.0] * 3
    GL.glEnd()


@each({"small": 6, "threshold": 32, "large": 200})
def attributes_around_vertices(app: App, count: int) -> None:
    """Set before, between, only after; never; before the first but not at it."""
    GL.glColor4f(0.1, 0.9, 0.2, 0.5)
    GL.glTexCoord4f(0.1, 0.2, 0.3, 2.0)
    GL.glNormal3f(0.0, 1.0, 0.0)
    colours: dict[str, set[int]] = {
        "never": set(), "first": {0}, "second": {1}, "middle": {count // 2}, "some": {1, 2, 5},
        "last": {count - 1}, "after": {count}, "first-and-after": {0, count},
    }  # fmt: skip
    for k, places in enumerate(colours.values()):
        GL.glBegin(GL.GL_TRIANGLES)
        for i, (x, y, z) in enumerate([*spiral(count), (0, 0, 0)]):
            if i in places:
                GL.glColor3f(*shade(i + k))
                GL.glTexCoord2f(i, k)
                GL.glNormal3f(0, 0, i)
            if i < count:
                GL.glVertex3f(x, y, z)
        GL.glEnd()
        app.asks(GL.GL_CURRENT_COLOR, GL.GL_CURRENT_NORMAL, GL.GL_CURRENT_TEXTURE_COORDS)
        GL.glTranslatef(0.1, 0.1, 0.2)


@each({"small": 12, "large": 240})
def mixed_sizes(app: App, count: int) -> None:
    GL.glBegin(GL.GL_TRIANGLES)
    for i, (x, y, z) in enumerate(spiral(count)):
        colour, point = shade(i), (x * 2, y * 2, z * 2, 2)
        if i % 4 < 3:
            (GL.glColor3f, GL.glColor4f, GL.glColor3d)[i % 4](*colour, *[0.5][: i % 4 == 1])
        if i % 5 == 0:
            GL.glColor3ub(i % 256, 3, 200)
        (GL.glTexCoord1f, GL.glTexCoord4fv, GL.glTexCoord2s)[i % 3](
            *((i,), ((i, 1, 2, 3),), (i, 2))[i % 3]
        )
        (GL.glVertex2f, GL.glVertex3d, GL.glVertex4f)[i % 3](*point[: 2 + i % 3])
    GL.glEnd()
    app.asks(GL.GL_CURRENT_COLOR, GL.GL_CURRENT_TEXTURE_COORDS)


@scene
def vertices_outside_a_primitive(app: App) -> None:
    app.tries(GL.glVertex3f, 1, 2, 3)
    app.tries(GL.glColor3f, 1, 0, 0)
    app.tries(GL.glVertex3fv, [1, 2, 3])
    app.error()
    app.asks(GL.GL_CURRENT_COLOR)


@scene
def a_shape_inside_a_primitive(app: App) -> None:
    """GLU's own glBegin is refused, its vertices are the primitive's, and its glEnd ends it."""
    quadric = GLU.gluNewQuadric()
    for x in (-0.5, 0.2):
        GL.glBegin(GL.GL_QUAD_STRIP)
        GL.glColor3f(0.9, 0.5, 0.2)
        GL.glVertex3f(x, -0.75, 0.0)
        app.tries(GLU.gluDisk, quadric, 0.0, 0.6, 8, 2)
        app.tries(GL.glVertex3f, x, 0.5, 0.0)
        app.tries(GL.glEnd)
        app.error()
    GLU.gluDeleteQuadric(quadric)
    app.asks(GL.GL_CURRENT_COLOR)
