"""An island with a lighthouse: glfw, buffer objects with indices, client vertex arrays.

The terrain lies in vertex buffers and is drawn by glDrawElements; the lighthouse and the boats come
from client arrays. Drag to orbit, wheel or +/- to zoom, space stops the waves, ESC leaves.
"""

import ctypes
import sys
from dataclasses import dataclass, field

import glfw
import numpy as np
from numpy.typing import NDArray
from OpenGL import GL, GLU
from OpenGL.arrays import vbo

SIZE = (640, 480)
CELLS = 72  # terrain squares along one side
HALF = 5.0  # half the side of the terrain
Floats = NDArray[np.float32]


def normals_of(points: Floats) -> Floats:
    """Unit normals of a grid of points, (rows, columns, 3)."""
    along, across = np.gradient(points, axis=(0, 1))
    normals = np.cross(along, across)
    return (normals / np.linalg.norm(normals, axis=2, keepdims=True)).astype(np.float32)


def terrain() -> tuple[Floats, Floats, Floats]:
    """Points, normals and colours of the island, each (rows, columns, 3)."""
    axis = np.linspace(-HALF, HALF, CELLS + 1)
    x, z = np.meshgrid(axis, axis)
    r = np.hypot(x * 0.9, z * 1.1)
    y = 1.9 * np.exp(-((x + 1.0) ** 2 + (z + 0.4) ** 2) / 2.2) + 1.1 * np.exp(-(r / 2.9) ** 4)
    y += 0.16 * np.sin(2.6 * x + 0.7) * np.cos(2.1 * z) * np.exp(-(r / 3.4) ** 4) - 0.45
    points = np.stack([x, y, z], axis=2).astype(np.float32)
    bands = np.array([[0.35, 0.42, 0.45], [0.87, 0.80, 0.60], [0.45, 0.62, 0.32],
                      [0.52, 0.50, 0.45], [0.95, 0.96, 0.97]], np.float32)
    levels = np.array([0.0, 0.18, 1.25, 1.75])
    return points, normals_of(points), bands[np.searchsorted(levels, y)]


def grid_quads(rows: int, columns: int) -> NDArray[np.uint32]:
    """Indices of the grid's squares, counter-clockwise from above."""
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    quads = np.stack([corner, corner + columns + 1, corner + columns + 2, corner + 1], axis=1)
    return quads.astype(np.uint32)


def lathe(profile: list[tuple[float, float]], sides: int) -> tuple[Floats, Floats]:
    """Quads (n, 3) and their flat normals of a polyline of (radius, y) turned about y."""
    turn = 2 * np.pi * np.arange(sides + 1) / sides
    r, y = np.array(profile).T
    ring = np.stack([np.outer(r, np.cos(turn)), np.repeat(y[:, None], sides + 1, 1),
                     -np.outer(r, np.sin(turn))], axis=2)
    quads = np.stack([ring[:-1, :-1], ring[:-1, 1:], ring[1:, 1:], ring[1:, :-1]], axis=2)
    quads = quads.reshape(-1, 4, 3)
    normals = np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return quads.reshape(-1, 3).astype(np.float32), np.repeat(normals, 4, 0).astype(np.float32)


@dataclass
class View:
    azimuth: float = 30.0
    elevation: float = 28.0
    distance: float = 12.0
    size: tuple[int, int] = SIZE
    moving: bool = True
    frame: int = 0
    grip: tuple[float, float] | None = field(default=None)

    def drag(self, x: float, y: float) -> None:
        if self.grip is not None:
            self.azimuth += 0.4 * (x - self.grip[0])
            self.elevation = min(max(self.elevation + 0.4 * (y - self.grip[1]), 3.0), 89.0)
            self.grip = (x, y)

    def zoom(self, steps: float) -> None:
        self.distance = min(max(self.distance * 0.9**steps, 5.0), 30.0)


class Island:
    """The terrain's buffers and the arrays of what stands on it."""

    def __init__(self) -> None:
        points, normals, colours = terrain()
        stream = np.concatenate([points, normals, colours], axis=2).reshape(-1, 9)
        self.vertices = vbo.VBO(np.ascontiguousarray(stream, np.float32))
        self.quads = vbo.VBO(grid_quads(CELLS, CELLS).ravel(), target=GL.GL_ELEMENT_ARRAY_BUFFER)
        self.tower = lathe([(0.36, 0.0), (0.22, 1.3), (0.34, 1.32), (0.34, 1.4), (0.17, 1.4),
                            (0.17, 1.66), (0.26, 1.66), (0.001, 1.95)], 12)
        self.boat = self.hull()
        axis = np.linspace(-9.0, 9.0, 41)
        self.sea_x, self.sea_z = np.meshgrid(axis, axis)
        self.sea_quads = grid_quads(40, 40)

    @staticmethod
    def hull() -> tuple[Floats, Floats]:
        keel = [(-0.6, 0.0), (0.0, -0.22), (0.75, 0.0)]
        edge = np.array([[-0.6, 0.2, 0.22], [0.1, 0.2, 0.28], [0.75, 0.28, 0.02]])
        low = np.array([[x, y, 0.02] for x, y in keel])
        right = [[low[i], low[i + 1], edge[i + 1], edge[i]] for i in range(2)]
        flip = np.array([1.0, 1.0, -1.0])
        left = [[edge[i] * flip, edge[i + 1] * flip, low[i + 1] * flip, low[i] * flip]
                for i in range(2)]
        deck = [[edge[i], edge[i + 1], edge[i + 1] * flip, edge[i] * flip] for i in range(2)]
        stern = [[low[0], edge[0], edge[0] * flip, low[0] * flip]]
        quads = np.array([*right, *left, *deck, *stern])
        normals = np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        return quads.reshape(-1, 3).astype(np.float32), np.repeat(normals, 4, 0).astype(np.float32)

    def draw_terrain(self) -> None:
        with self.vertices, self.quads:
            stride = 9 * 4
            GL.glEnableClientState(GL.GL_COLOR_ARRAY)
            GL.glVertexPointer(3, GL.GL_FLOAT, stride, ctypes.c_void_p(0))
            GL.glNormalPointer(GL.GL_FLOAT, stride, ctypes.c_void_p(12))
            GL.glColorPointer(3, GL.GL_FLOAT, stride, ctypes.c_void_p(24))
            GL.glDrawElements(GL.GL_QUADS, CELLS * CELLS * 4, GL.GL_UNSIGNED_INT, None)
            GL.glDisableClientState(GL.GL_COLOR_ARRAY)

    def draw_sea(self, time: float) -> None:
        height = 0.05 * np.sin(1.6 * self.sea_x + time) + 0.04 * np.sin(2.3 * self.sea_z - time)
        points = np.stack([self.sea_x, height, self.sea_z], axis=2).astype(np.float32)
        GL.glColor3f(0.30, 0.52, 0.66)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, points)
        GL.glNormalPointer(GL.GL_FLOAT, 0, normals_of(points))
        GL.glDrawElements(GL.GL_QUADS, self.sea_quads.size, GL.GL_UNSIGNED_INT, self.sea_quads)

    @staticmethod
    def draw_quads(shape: tuple[Floats, Floats]) -> None:
        GL.glVertexPointerf(shape[0])
        GL.glNormalPointerf(shape[1])
        GL.glDrawArrays(GL.GL_QUADS, 0, len(shape[0]))

    def draw(self, time: float) -> None:
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
        self.draw_terrain()
        self.draw_sea(time)
        GL.glPushMatrix()
        GL.glTranslatef(1.3, 0.5, 1.0)
        GL.glColor3f(0.88, 0.30, 0.24)
        self.draw_quads(self.tower)
        GL.glPopMatrix()
        GL.glColor3f(0.55, 0.36, 0.22)
        for turn, radius in ((40.0, 4.3), (155.0, 4.8), (290.0, 4.5)):
            GL.glPushMatrix()
            GL.glRotatef(turn + 4.0 * time, 0.0, 1.0, 0.0)
            GL.glTranslatef(0.0, 0.04 * float(np.sin(time + turn)), radius)
            self.draw_quads(self.boat)
            GL.glPopMatrix()
        GL.glDisableClientState(GL.GL_NORMAL_ARRAY)
        GL.glDisableClientState(GL.GL_VERTEX_ARRAY)


def set_up() -> None:
    GL.glClearColor(0.80, 0.89, 0.95, 1.0)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glEnable(GL.GL_LIGHTING)
    GL.glEnable(GL.GL_LIGHT0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.95, 0.93, 0.86, 1.0))
    GL.glEnable(GL.GL_COLOR_MATERIAL)
    GL.glColorMaterial(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT_AND_DIFFUSE)


def look(view: View) -> None:
    GL.glViewport(0, 0, *view.size)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(38.0, view.size[0] / max(view.size[1], 1), 1.0, 60.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, -0.2, -view.distance)
    GL.glRotatef(view.elevation, 1.0, 0.0, 0.0)
    GL.glRotatef(view.azimuth, 0.0, 1.0, 0.0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (5.0, 7.0, 4.0, 0.0))


def connect(window: object, view: View) -> None:
    def key(window: object, key: int, _scan: int, action: int, _mods: int) -> None:
        if action == glfw.RELEASE:
            return
        if key == glfw.KEY_ESCAPE:
            glfw.set_window_should_close(window, True)
        elif key == glfw.KEY_SPACE:
            view.moving = not view.moving
        elif key in (glfw.KEY_EQUAL, glfw.KEY_KP_ADD):
            view.zoom(1)
        elif key in (glfw.KEY_MINUS, glfw.KEY_KP_SUBTRACT):
            view.zoom(-1)

    def button(window: object, button: int, action: int, _mods: int) -> None:
        if button == glfw.MOUSE_BUTTON_LEFT:
            view.grip = glfw.get_cursor_pos(window) if action == glfw.PRESS else None

    glfw.set_key_callback(window, key)
    glfw.set_mouse_button_callback(window, button)
    glfw.set_cursor_pos_callback(window, lambda _window, x, y: view.drag(x, y))
    glfw.set_scroll_callback(window, lambda _window, _x, y: view.zoom(y))
    glfw.set_framebuffer_size_callback(
        window, lambda _window, width, height: setattr(view, "size", (width, height)))


def main() -> int:
    glfw.ERROR_REPORTING = "ignore"
    if not glfw.init():
        print("island: no display to open a window on", file=sys.stderr)
        return 1
    window = glfw.create_window(*SIZE, "Island", None, None)
    glfw.make_context_current(window)
    glfw.swap_interval(1)
    view, island = View(), Island()
    connect(window, view)
    set_up()
    while not glfw.window_should_close(window):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        look(view)
        island.draw(0.05 * view.frame)
        glfw.swap_buffers(window)
        view.frame += view.moving
        glfw.poll_events()
    glfw.terminate()
    return 0


if __name__ == "__main__":
    sys.exit(main())
