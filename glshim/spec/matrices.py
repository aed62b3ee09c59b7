"""What each call that changes a matrix does to it, as data (OpenGL 2.1, section 2.11.2)."""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple


class Operation(Enum):
    """Which matrix a call's arguments stand for."""

    IDENTITY = "the identity"
    TRANSLATE = "a translation"
    SCALE = "a scaling"
    ROTATE = "a rotation by degrees around an axis"
    ORTHO = "a parallel projection"
    FRUSTUM = "a perspective projection"
    COLUMNS = "sixteen numbers in columns, behind a pointer"
    ROWS = "sixteen numbers in rows, behind a pointer"


class MatrixCall(NamedTuple):
    """One entry point."""

    operation: Operation
    loads: bool = False
    """The matrix takes the current one's place; else the current one is multiplied by it."""
    element: str = ""
    """f or d: the type of the numbers behind a pointer."""


def _rows() -> dict[str, MatrixCall]:
    table = {
        "glLoadIdentity": MatrixCall(Operation.IDENTITY, loads=True),
        "glOrtho": MatrixCall(Operation.ORTHO),
        "glFrustum": MatrixCall(Operation.FRUSTUM),
    }
    for letter in "df":
        table |= {
            f"glTranslate{letter}": MatrixCall(Operation.TRANSLATE),
            f"glScale{letter}": MatrixCall(Operation.SCALE),
            f"glRotate{letter}": MatrixCall(Operation.ROTATE),
            f"glMultMatrix{letter}": MatrixCall(Operation.COLUMNS, False, letter),
            f"glLoadMatrix{letter}": MatrixCall(Operation.COLUMNS, True, letter),
            f"glMultTransposeMatrix{letter}": MatrixCall(Operation.ROWS, False, letter),
            f"glLoadTransposeMatrix{letter}": MatrixCall(Operation.ROWS, True, letter),
        }
    return table


MATRIX_CALLS = _rows()
"""By entry point. What extensions add to these is not followed in display lists."""
