"""The matrices of GL's fixed function in numpy (OpenGL 2.1, section 2.11.2)."""

from __future__ import annotations

from typing import Any

import numpy as np

from glshim.model.arrays import Matrix


def translation(x: float, y: float, z: float) -> Matrix:
    """(4, 4) translation."""
    m = np.eye(4)
    m[:3, 3] = x, y, z
    return m


def scaling(x: float, y: float, z: float) -> Matrix:
    """(4, 4) scaling."""
    return np.diag([x, y, z, 1.0]).astype(np.float64)


def rotation(angle: float, x: float, y: float, z: float) -> Matrix:
    """(4, 4) rotation by degrees around an axis; the identity for a zero axis."""
    axis = np.array([x, y, z], np.float64)
    length = float(np.linalg.norm(axis))
    m = np.eye(4)
    if length == 0.0:
        return m
    x, y, z = axis / length
    s, c = np.sin(np.radians(angle)), np.cos(np.radians(angle))
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    outer = np.outer((x, y, z), (x, y, z))
    m[:3, :3] = outer + c * (np.eye(3) - outer) + s * cross
    return m


def orthographic(*box: float) -> Matrix:
    """(4, 4) parallel projection: left, right, bottom, top, near, far (glOrtho)."""
    l, r, b, t, n, f = box  # noqa: E741
    m = np.diag([2 / (r - l), 2 / (t - b), -2 / (f - n), 1.0])
    m[:3, 3] = -(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n)
    return m


def frustum(*box: float) -> Matrix:
    """(4, 4) perspective projection: left, right, bottom, top, near, far (glFrustum)."""
    l, r, b, t, n, f = box  # noqa: E741
    return np.array(
        [
            [2 * n / (r - l), 0, (r + l) / (r - l), 0],
            [0, 2 * n / (t - b), (t + b) / (t - b), 0],
            [0, 0, -(f + n) / (f - n), -2 * f * n / (f - n)],
            [0, 0, -1, 0],
        ]
    )


def column_major(values: Any) -> Matrix:
    """(4, 4) from GL's sixteen numbers in columns."""
    return np.array(values, np.float64).reshape(4, 4).T
