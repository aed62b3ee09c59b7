"""Meshes, real fixed-function windows, and pictures of mesh plus lines, for tests and for eyes.

``python -m tests.look OUT [WIDTH]`` writes PNGs to look at.
"""

from __future__ import annotations

import contextlib
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import glfw
import numpy as np
import pytest
from glshim_stylers.raskar import Raskar
from OpenGL import GL

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer


def batch(points, polygons, key=None) -> PolygonBatch:
    """A PolygonBatch from points and lists of corner indices."""
    sizes = [len(p) for p in polygons]
    corners = np.concatenate([np.asarray(p) for p in polygons]).astype(np.int32)
    starts = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int32)
    points = np.asarray(points, np.float32)
    return PolygonBatch(points, corners, starts, np.ones(len(corners), bool), key)


def polygons_of(b: PolygonBatch) -> list[np.ndarray]:
    return [b.corners[i:j] for i, j in zip(b.starts[:-1], b.starts[1:], strict=True)]


def _grid(point, m, n, close_m, close_n):
    """A quad grid over point(u, v); outward when du x dv points outward."""
    us = np.arange(m if close_m else m + 1) / m
    vs = np.arange(n if close_n else n + 1) / n
    points = [point(u, v) for u in us for v in vs]
    rows, columns = len(us), len(vs)
    quads = [
        [
            i * columns + j,
            (i + 1) % rows * columns + j,
            (i + 1) % rows * columns + (j + 1) % columns,
            i * columns + (j + 1) % columns,
        ]
        for i in range(m)
        for j in range(n)
    ]
    return batch(points, quads)


def torus(m=36, n=18, big=1.0, small=0.4) -> PolygonBatch:
    def at(u, v):
        a, b = 2 * np.pi * u, 2 * np.pi * v
        r = big + small * np.cos(b)
        return r * np.cos(a), r * np.sin(a), small * np.sin(b)

    return _grid(at, m, n, True, True)


def sphere(m=24, n=14, radius=1.2, low=0.0, high=1.0) -> PolygonBatch:
    """Poles are quads with a repeated point."""

    def at(u, v):
        a, b = 2 * np.pi * u, np.pi * (low + (high - low) * v) - np.pi / 2
        z = 0.0 if v in (0.0, 1.0) and abs(abs(b) - np.pi / 2) < 1e-9 else np.cos(b)
        return radius * z * np.cos(a), radius * z * np.sin(a), radius * np.sin(b)

    return _grid(at, m, n, True, False)


def bowl(m=24, n=9) -> PolygonBatch:
    return sphere(m, n, high=0.55)


def cube(half=0.9) -> PolygonBatch:
    points = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return batch(points, faces)


def cylinder(n=24, radius=0.7, half=1.0) -> PolygonBatch:
    ring = [(radius * np.cos(a), radius * np.sin(a)) for a in 2 * np.pi * np.arange(n) / n]
    points = [(x, y, -half) for x, y in ring] + [(x, y, half) for x, y in ring]
    sides = [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
    return batch(points, [*sides, list(range(n))[::-1], list(range(n, 2 * n))])


def teapot() -> PolygonBatch:
    """GLUT's own teapot through feedback mode, wound as GLUT sends it (clockwise)."""
    # In a process of its own: GLUT and glfw in one process disagree about the end of it.
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "teapot.npy"
        subprocess.run([sys.executable, "-m", "tests.look", "--teapot", str(path)], check=True)
        triangles = np.load(path)
    return batch(triangles.reshape(-1, 3), np.arange(len(triangles) * 3).reshape(-1, 3))


def _capture_teapot(path: str) -> None:
    from OpenGL import GLUT

    GLUT.glutInit(["teapot"])
    GLUT.glutInitDisplayMode(GLUT.GLUT_RGB | GLUT.GLUT_DEPTH)
    GLUT.glutCreateWindow(b"teapot")
    GL.glViewport(0, 0, 4096, 4096)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GL.glOrtho(-2, 2, -2, 2, 2, -2)
    GL.glFeedbackBuffer(1 << 20, GL.GL_3D)
    GL.glRenderMode(GL.GL_FEEDBACK)
    GLUT.glutSolidTeapot(1.0)
    tokens = GL.glRenderMode(GL.GL_RENDER)
    window = np.array([[list(corner.vertex)[:3] for corner in token[1:]] for token in tokens])
    np.save(path, window * (1 / 1024, 1 / 1024, 4) - 2)


def perspective(fov=40.0, aspect=1.0, near=0.1, far=50.0) -> np.ndarray:
    f = 1 / np.tan(np.radians(fov) / 2)
    return np.array(
        [
            [f / aspect, 0, 0, 0],
            [0, f, 0, 0],
            [0, 0, (far + near) / (near - far), 2 * far * near / (near - far)],
            [0, 0, -1, 0],
        ]
    )


def orthographic(half=2.0, aspect=1.0, near=0.1, far=50.0) -> np.ndarray:
    return np.array(
        [
            [1 / (half * aspect), 0, 0, 0],
            [0, 1 / half, 0, 0],
            [0, 0, -2 / (far - near), -(far + near) / (far - near)],
            [0, 0, 0, 1.0],
        ]
    )


def look_at(eye, target=(0, 0, 0), up=(0.1, 0.2, 1)) -> np.ndarray:
    eye, target = np.asarray(eye, float), np.asarray(target, float)
    z = (eye - target) / np.linalg.norm(eye - target)
    x = np.cross(up, z)
    x /= np.linalg.norm(x)
    m = np.eye(4)
    m[:3, :3] = [x, np.cross(z, x), z]
    m[:3, 3] = -m[:3, :3] @ eye
    return m


def directions(count=24) -> np.ndarray:
    """(count, 3) view directions spread over the sphere (Fibonacci), none special."""
    i = np.arange(count) + 0.5
    z = 1 - 2 * i / count
    a = np.pi * (1 + 5**0.5) * i + 0.3
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(a), r * np.sin(a), z], axis=1)


@contextlib.contextmanager
def window(width=400, height=400, samples=0) -> Iterator[None]:
    """A hidden window with a current compatibility context."""
    if not glfw.init():
        raise RuntimeError("glfw found no display")
    glfw.default_window_hints()
    glfw.window_hint(glfw.VISIBLE, False)
    glfw.window_hint(glfw.STENCIL_BITS, 8)
    glfw.window_hint(glfw.SAMPLES, samples)
    handle = glfw.create_window(width, height, "look", None, None)
    glfw.make_context_current(handle)
    try:
        yield
    finally:
        glfw.destroy_window(handle)
        glfw.terminate()


@contextlib.contextmanager
def multisampled(width=400, height=400, samples=4) -> Iterator[None]:
    """A second window with several samples a pixel, current; skips where there is none."""
    kept = glfw.get_current_context()
    glfw.window_hint(glfw.SAMPLES, samples)
    handle = glfw.create_window(width, height, "samples", None, None)
    glfw.make_context_current(handle)
    try:
        if GL.glGetIntegerv(GL.GL_SAMPLES) < 2:
            pytest.skip("no multisampled window here")
        yield
    finally:
        glfw.make_context_current(kept)
        glfw.destroy_window(handle)
        glfw.window_hint(glfw.SAMPLES, 0)


def clear(shade=(1.0, 1.0, 1.0)) -> None:
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glClearColor(*shade, 1.0)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT | GL.GL_STENCIL_BUFFER_BIT)


def draw_base(b: PolygonBatch, camera: Camera, shade=(0.8, 0.8, 0.8)) -> None:
    """Polygons through the real fixed function."""
    GL.glViewport(*camera.viewport)
    GL.glDepthRange(*camera.depth_range)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadMatrixd(np.ascontiguousarray(camera.projection.T))
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadMatrixd(np.ascontiguousarray(camera.modelview.T))
    GL.glColor3f(*shade)
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    positions = np.ascontiguousarray(b.positions)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, positions)
    sizes = np.diff(b.starts)
    for size in np.unique(sizes):
        at = np.concatenate([p for p in polygons_of(b) if len(p) == size]).astype(np.uint32)
        if size in (3, 4):
            mode = GL.GL_TRIANGLES if size == 3 else GL.GL_QUADS
            GL.glDrawElements(mode, len(at), GL.GL_UNSIGNED_INT, at)
        else:
            for one in at.reshape(-1, size):
                GL.glDrawElements(GL.GL_POLYGON, size, GL.GL_UNSIGNED_INT, one)
    GL.glDisableClientState(GL.GL_VERTEX_ARRAY)


def pixels(width=400, height=400) -> np.ndarray:
    """(height, width, 3) uint8, row 0 at the bottom."""
    GL.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1)
    raw = GL.glReadPixels(0, 0, width, height, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    return np.frombuffer(raw, np.uint8).reshape(height, width, 3)


def depths(width=400, height=400) -> np.ndarray:
    """(height, width) float32 window depth, row 0 at the bottom."""
    raw = GL.glReadPixels(0, 0, width, height, GL.GL_DEPTH_COMPONENT, GL.GL_FLOAT)
    return np.asarray(raw, np.float32).reshape(height, width)


def styled(backend: Backend, style: Raskar, *items: tuple[PolygonBatch, Camera]):
    """Frame without lines, frame with lines, depth. Items drawn in order."""
    clear()
    for b, camera in items:
        draw_base(b, camera)
    before, depth = pixels(), depths()
    backend.render(style.draws(Layer(tuple(items))))
    return before, pixels(), depth


def ink(before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """(H, W) share of each pixel that black ink covers, from pictures without and with it."""
    return 1.0 - after.max(axis=2) / np.maximum(before.max(axis=2).astype(float), 1.0)


MESHES = {"torus": torus, "sphere": sphere, "bowl": bowl, "cube": cube, "cylinder": cylinder}


def main(folder: str, width: float) -> None:
    from PIL import Image

    out = Path(folder)
    out.mkdir(parents=True, exist_ok=True)
    pot = teapot()
    with window():
        backend = Backend.attach()
        for name, make in {**MESHES, "teapot": lambda: pot}.items():
            mesh = make()
            tiles = []
            for k, d in enumerate(directions(8)):
                projection = perspective() if k % 2 else orthographic()
                camera = Camera(look_at(5 * d), projection, (0, 0, 400, 400))
                style = Raskar(silhouette_width=width, ridge_width=width)
                tiles.append(styled(backend, style, (mesh, camera))[1][::-1])
            sheet = np.concatenate([np.concatenate(tiles[r : r + 4], 1) for r in (0, 4)], 0)
            Image.fromarray(sheet).save(out / f"{name}_{width:g}.png")


if __name__ == "__main__" and sys.argv[1] == "--teapot":
    _capture_teapot(sys.argv[2])
elif __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 3.0)
