"""A head, one smooth closed surface of 29,520 triangles: an egg on a neck, with features as bumps.
"""

import importlib

import numpy as np
from numpy.typing import NDArray

from tests.figures.programs.stage import show

chess = importlib.import_module("demo_apps.06_chess")
ROWS, COLUMNS = 125, 120
Floats = NDArray[np.float64]

# From the crown down to the sole of the neck: height, half width, depth in front, depth behind.
KNOTS = (0.0, 0.08, 0.20, 0.34, 0.48, 0.60, 0.70, 0.78, 0.84, 0.92, 0.97, 1.0)
TABLE = (
    (1.22, 1.17, 0.98, 0.62, 0.18, -0.22, -0.58, -0.82, -0.95, -1.30, -1.52, -1.52),
    (0.00, 0.34, 0.62, 0.76, 0.75, 0.70, 0.58, 0.45, 0.41, 0.44, 0.50, 0.00),
    (0.00, 0.40, 0.72, 0.86, 0.85, 0.83, 0.78, 0.66, 0.36, 0.36, 0.42, 0.00),
    (0.00, 0.46, 0.84, 1.02, 1.00, 0.86, 0.62, 0.50, 0.46, 0.44, 0.48, 0.00),
)
# Sideways (also mirrored), height, their half sizes, and how far a bump stands out.
BUMPS = (
    (0.00, 0.10, 0.08, 0.24, 0.10), (0.00, -0.06, 0.09, 0.12, 0.20),  # bridge, tip of the nose
    (0.12, -0.12, 0.06, 0.06, 0.09), (0.00, -0.20, 0.05, 0.05, -0.05),  # its wings, and below it
    (0.30, 0.37, 0.20, 0.055, 0.07), (0.00, 0.34, 0.10, 0.08, 0.03),  # brows
    (0.30, 0.20, 0.17, 0.11, -0.13), (0.30, 0.18, 0.115, 0.07, 0.14),  # sockets, eyes
    (0.30, 0.16, 0.14, 0.028, -0.045),  # the slit between the lids
    (0.42, -0.06, 0.16, 0.14, 0.05), (0.34, -0.38, 0.10, 0.16, -0.04),  # cheeks
    (0.00, -0.34, 0.17, 0.05, 0.06), (0.00, -0.46, 0.15, 0.055, 0.065),  # lips
    (0.00, -0.40, 0.21, 0.036, -0.055), (0.00, -0.57, 0.14, 0.05, -0.05),  # mouth, below it
    (0.00, -0.72, 0.17, 0.10, 0.10),  # chin
    (1.62, 0.08, 0.12, 0.20, 0.17), (1.48, 0.04, 0.11, 0.12, -0.09),  # ears
    (1.50, -0.12, 0.10, 0.07, 0.05),
)  # fmt: skip


def worn(values: Floats) -> Floats:
    """A profile without the corners of its table; the ends stay."""
    for _ in range(50):
        values[1:-1] = (values[:-2] + 2 * values[1:-1] + values[2:]) / 4
    return values


def head() -> Floats:
    """(rows, COLUMNS + 1, 3) the surface from the sole up; it looks along -y, z is up."""
    way = np.linspace(1.0, 0.0, ROWS)
    level, wide, front, back = (
        worn(np.interp(way, KNOTS, row))[:, None] for row in map(np.array, TABLE)
    )
    turn = 2 * np.pi * (np.arange(COLUMNS + 1) % COLUMNS) / COLUMNS - np.pi
    # Features are where many columns are: more of them look forward.
    turn = turn - 0.45 * np.sin(turn)
    x, y = np.sin(turn), -np.cos(turn)
    out = np.zeros((ROWS, COLUMNS + 1))
    for aside, height, across, up, far in BUMPS:
        for side in {aside, -aside}:
            apart = (turn - side + np.pi) % (2 * np.pi) - np.pi
            out += far * np.exp(-((apart / across) ** 2) - ((level - height) / up) ** 2)
    deep = np.where(y < 0, front, back)
    points = np.stack([(wide + out) * x, (deep + out) * y, level + 0.0 * x], axis=2)
    points[[0, -1]] = points[[0, -1]].mean(axis=1, keepdims=True) * (0, 0, 1)
    return points


def draw() -> None:
    chess.material((0.84, 0.76, 0.66, 1.0), 0.15)
    points = head()
    chess.draw_grid(points, chess.smooth_normals(points))


if __name__ == "__main__":
    show(draw, (2.6, -5.0, 0.7), (0.0, 0.0, -0.14), 31.0)
