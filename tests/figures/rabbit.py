"""A rabbit's head for figures: smooth, dense, and with the dents that suggestive contours need."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import trimesh

LUMPS = (  # direction, height, sharpness
    ((0.34, 0.92, -0.2), 1.25, 26.0), ((-0.34, 0.92, -0.2), 1.25, 26.0),  # ears
    ((0.40, 0.92, 0.06), -0.34, 40.0), ((-0.40, 0.92, 0.06), -0.34, 40.0),  # hollow in front
    ((0.0, -0.15, 1.0), 0.34, 7.0), ((0.0, 0.0, 1.0), 0.07, 120.0),  # snout and nose
    ((0.3, -0.3, 0.9), 0.15, 26.0), ((-0.3, -0.3, 0.9), 0.15, 26.0),  # cheeks
    ((0.0, -0.5, 0.9), -0.1, 60.0), ((0.0, -0.62, 0.8), 0.06, 40.0),  # mouth and chin
    ((0.5, 0.28, 0.8), -0.2, 40.0), ((-0.5, 0.28, 0.8), -0.2, 40.0),  # sockets of the eyes
    ((0.5, 0.27, 0.8), 0.16, 90.0), ((-0.5, 0.27, 0.8), 0.16, 90.0),  # eyes
    ((0.45, 0.5, 0.75), 0.06, 30.0), ((-0.45, 0.5, 0.75), 0.06, 30.0),  # brows
)  # fmt: skip
"""A sphere that grows along each direction, by Gaussians."""


def write_rabbit(path: Path, subdivisions: int = 5) -> Path:
    """The head as an OBJ or PLY file, of 20 x 4^subdivisions triangles."""
    ball = trimesh.creation.icosphere(subdivisions=subdivisions)
    ways = np.asarray(ball.vertices)
    radius = np.ones(len(ways))
    for direction, height, sharpness in LUMPS:
        middle = np.asarray(direction) / np.linalg.norm(direction)
        radius += height * np.exp(sharpness * (ways @ middle - 1.0))
    points = ways * radius[:, None] * (0.92, 1.0, 1.0)
    trimesh.Trimesh(points, ball.faces, process=False).export(path)
    return path
