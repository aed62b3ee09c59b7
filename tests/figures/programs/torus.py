"""The torus of Rideout's steps: smooth, in triangles."""

import importlib

import numpy as np
from OpenGL import GL

from tests.figures.programs.stage import show

chess = importlib.import_module("demo_apps.06_chess")

AROUND, ACROSS = 48, 20  # pieces of the ring and of the tube


def draw() -> None:
    chess.material((0.42, 0.58, 0.72, 1.0), 0.3)
    a = 2 * np.pi * (np.arange(AROUND + 1) % AROUND)[:, None] / AROUND
    b = 2 * np.pi * (np.arange(ACROSS + 1) % ACROSS) / ACROSS
    normals = np.stack(np.broadcast_arrays(np.cos(a) * np.cos(b), np.sin(a) * np.cos(b),
                                           np.sin(b)), axis=2)  # fmt: skip
    ring = np.stack(np.broadcast_arrays(np.cos(a), np.sin(a), 0 * b), axis=2)
    points = ring + 0.42 * normals
    GL.glBegin(GL.GL_TRIANGLES)
    for i in range(AROUND):
        for k in range(ACROSS):
            square = ((i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1))
            for corner in (0, 1, 2, 0, 2, 3):
                GL.glNormal3fv(normals[square[corner]])
                GL.glVertex3fv(points[square[corner]])
    GL.glEnd()


if __name__ == "__main__":
    show(draw, (1.0, -4.2, 2.7), (0.0, 0.0, -0.05), 36.0)
