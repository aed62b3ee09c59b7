"""Functions of GLU, GLUT and GLE that draw in C, as data."""

from __future__ import annotations

import re
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from enum import Enum
from functools import cache
from typing import Any


class ShapeRole(Enum):
    """What a C library's function means to us."""

    SOLID = "draws polygons that its arguments alone decide"
    QUADRIC = "draws polygons that its arguments and the quadric's settings decide"
    QUADRIC_STYLE = "says whether a quadric has polygons (LINE_STYLES)"
    QUADRIC_ORIENTATION = "says which side of a quadric is its front"
    QUADRIC_END = "gives a quadric back"
    EXTRUSION = "draws polygons from arrays and GLE's settings"
    NURBS_OPEN = "opens a NURBS surface"
    NURBS_PART = "adds to it"
    NURBS_CLOSE = "closes it: now it is drawn"
    DRAWING = "draws lines, points or text"


ROWS: tuple[tuple[str, ShapeRole, str], ...] = (
    ("OpenGL.raw.GLUT", ShapeRole.SOLID, r"glutSolid\w+"),
    ("OpenGL.raw.GLUT", ShapeRole.DRAWING, r"glut(Wire|Bitmap(Char|Str)|Stroke(Char|Str))\w+"),
    ("OpenGL.raw.GLU", ShapeRole.QUADRIC, r"glu(Sphere|Cylinder|Disk|PartialDisk)"),
    ("OpenGL.raw.GLU", ShapeRole.QUADRIC_STYLE, r"gluQuadricDrawStyle"),
    ("OpenGL.raw.GLU", ShapeRole.QUADRIC_ORIENTATION, r"gluQuadricOrientation"),
    ("OpenGL.raw.GLU", ShapeRole.QUADRIC_END, r"gluDeleteQuadric"),
    ("OpenGL.raw.GLU", ShapeRole.NURBS_OPEN, r"gluBeginSurface"),
    ("OpenGL.raw.GLU", ShapeRole.NURBS_PART,
     r"gluNurbsSurface|glu(Begin|End)Trim|gluPwlCurve|gluNurbsCurve"),
    ("OpenGL.raw.GLU", ShapeRole.NURBS_CLOSE, r"gluEndSurface"),
    ("OpenGL.raw.GLE", ShapeRole.EXTRUSION,
     r"gle(Extrusion|Helicoid|Lathe|PolyCone|PolyCylinder|Screw|Spiral|SuperExtrusion|Toroid"
     r"|TwistExtrusion)"),
)  # fmt: skip

GLU_POINT, GLU_LINE, GLU_SILHOUETTE = 100010, 100011, 100013
GLU_OUTSIDE = 100020
GLU_AUTO_LOAD_MATRIX = 100200
LINE_STYLES = (GLU_POINT, GLU_LINE, GLU_SILHOUETTE)
"""Of quadrics that are drawn without polygons."""

LENGTHS: dict[str, tuple[int, ...]] = {
    "gluSphere": (0,), "gluCylinder": (0, 1, 2), "gluDisk": (0, 1), "gluPartialDisk": (0, 1),
    "glutSolidSphere": (0,), "glutSolidCube": (0,), "glutSolidCone": (0, 1),
    "glutSolidTorus": (0, 1), "glutSolidTeapot": (0,), "glutSolidTeacup": (0,),
    "glutSolidTeaspoon": (0,), "glutSolidCylinder": (0, 1),
}  # fmt: skip
"""Which arguments (after a quadric) are lengths: a shape with all of them doubled is twice as
large and else the same."""


@dataclass(frozen=True, slots=True)
class Shape:
    """Something that C code drew."""

    key: Hashable | None
    """Equal keys, equal polygons; None when that cannot be told."""
    draw: Callable[[], Any]
    """Draws it again, ``1 / scale`` times as large."""
    scale: float = 1.0
    """How many times larger than the keyed shape this one is."""
    camera_bound: bool = False
    """Tessellated for the camera: another view, other polygons."""


def shape_role(module: str, name: str) -> ShapeRole | None:
    """The role of a C library's function, None when it draws nothing."""
    for home, role, pattern in ROWS:
        if home == module and re.fullmatch(pattern, name):
            return role
    return None


@cache
def draws_no_polygons(name: str) -> bool:
    """Whether a C library's function draws lines, points or text, whatever its arguments."""
    return any(
        role is ShapeRole.DRAWING and re.fullmatch(pattern, name) for _, role, pattern in ROWS
    )
