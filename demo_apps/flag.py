"""A flag that waves in the wind: glfw, client arrays sent anew each frame, two-sided lighting.

In a gust the soft waves tighten into pleats at every fourth column, in a lull they smooth out
again, so its sharp folds come and go. Drag to orbit, wheel or +/- to zoom, up and down for more
and less wind, space holds the wind, ESC leaves.
"""

import sys
from dataclasses import dataclass, field

import glfw
import numpy as np
from numpy.typing import NDArray
from OpenGL import GL, GLU

SIZE = (640, 480)
ROWS, COLUMNS = 18, 32
LENGTH, HEIGHT = 3.8, 2.2
PLEAT = 4  # columns from one pleat to the next
TURN = 2.0  # the wave's phase from one pleat to the next, radians
POLE, THICK = 4.1, 0.065  # height and radius of the pole
TOP = POLE - 0.12  # where the flag hangs
GREEN, CREAM, RED = (0.08, 0.42, 0.40), (1.0, 0.96, 0.84), (0.90, 0.28, 0.16)
Floats = NDArray[np.float64]


def gust(time: float, along: Floats | float) -> Floats:
    """How hard it blows, 0 to 1, at that part of the flag's length: gusts run out from the pole."""
    swell = np.clip(0.5 + 0.9 * np.sin(0.9 * time - 1.6 * np.asarray(along) + 1.6), 0.0, 1.0)
    return np.asarray(swell * swell * (3.0 - 2.0 * swell))


def cloth(time: float, wind: float = 1.0) -> Floats:
    """Corners of the flag's squares, (ROWS + 1, COLUMNS + 1, 3), from the top of the pole.

    Each strip between two columns keeps its width and takes a direction: that of a wave that runs
    out from the pole, which in a gust is the same for all the strips of a pleat.
    """
    strip = np.arange(COLUMNS) + 0.5
    middle = (strip // PLEAT + 0.5) * PLEAT
    down = np.linspace(0.0, 1.0, ROWS + 1)[:, None]
    blow = wind * gust(time, strip / COLUMNS)
    soft, hard = (
        np.sin(TURN * place / PLEAT - 3.2 * time + 0.5 * down + 0.6 * np.sin(0.7 * time) * down)
        for place in (strip, middle)
    )
    yaw = (0.42 + 0.52 * blow) * ((1.0 - blow) * soft + blow * hard)
    yaw += 0.18 * np.sin(0.45 * time)
    across = np.stack([np.cos(yaw), np.zeros_like(yaw), np.sin(yaw)], axis=2) * LENGTH / COLUMNS
    points = np.zeros((ROWS + 1, COLUMNS + 1, 3))
    points[:, 1:] = np.cumsum(across, axis=1)
    part = np.linspace(0.0, 1.0, COLUMNS + 1)
    sag = 0.55 - 0.45 * wind * gust(time, 0.5)
    points[..., 1] = -HEIGHT * down - sag * part**1.6 + 0.05 * part * np.sin(2.1 * time - 3 * part)
    return points


def squares(grid: Floats) -> tuple[Floats, Floats]:
    """Corners and normals of the grid's squares, (rows, columns, 4, 3), counter-clockwise.

    The normals are smooth over bends, and each square's own at a sharp fold.
    """
    corners = ((0, 0), (1, 0), (1, 1), (0, 1))
    rows, columns = grid.shape[0] - 1, grid.shape[1] - 1
    points = np.stack([grid[i : i + rows, k : k + columns] for i, k in corners], axis=2)
    flat = np.cross(points[:, :, 2] - points[:, :, 0], points[:, :, 3] - points[:, :, 1])
    flat /= np.linalg.norm(flat, axis=2, keepdims=True)
    around = np.pad(flat, ((1, 1), (1, 1), (0, 0)), mode="edge")
    normals = np.zeros_like(points)
    for corner, (i, k) in enumerate(corners):
        for a, b in corners:
            other = around[i + a : i + a + rows, k + b : k + b + columns]
            alike = (flat * other).sum(axis=2, keepdims=True)
            normals[:, :, corner] += other * np.clip((alike - 0.7) / 0.2, 0.0, 1.0)
    return points, normals / np.linalg.norm(normals, axis=3, keepdims=True)


def dyes() -> list[tuple[tuple[float, float, float], NDArray[np.uint32]]]:
    """The colours of the flag, and of each the indices of its squares' corners."""
    row, column = np.indices((ROWS, COLUMNS))
    row, column = np.abs(2 * row - ROWS + 1), np.abs(2 * column - 21)
    away = np.minimum(row, column)  # from the middle of the cross, in half squares
    corners = np.arange(ROWS * COLUMNS * 4, dtype=np.uint32).reshape(ROWS, COLUMNS, 4)
    parts = ((GREEN, away > 5), (CREAM, (away > 2) & (away < 6)), (RED, away < 2))
    return [(colour, corners[chosen].ravel()) for colour, chosen in parts]


@dataclass
class View:
    azimuth: float = -32.0
    elevation: float = 14.0
    distance: float = 7.0
    size: tuple[int, int] = SIZE
    wind: float = 1.0
    moving: bool = True
    frame: int = 0
    grip: tuple[float, float] | None = field(default=None)

    def drag(self, x: float, y: float) -> None:
        if self.grip is not None:
            self.azimuth += 0.4 * (x - self.grip[0])
            self.elevation = min(max(self.elevation + 0.4 * (y - self.grip[1]), 1.0), 80.0)
            self.grip = (x, y)

    def zoom(self, steps: float) -> None:
        self.distance = min(max(self.distance * 0.9**steps, 4.0), 20.0)


def drum(quadric: object, radius: float, top: float, height: float) -> None:
    """A cylinder that stands where the drawing is, with its lid; then goes up on top of it."""
    GLU.gluCylinder(quadric, radius, top, height, 32, 1)
    GL.glTranslatef(0.0, 0.0, height)
    GLU.gluDisk(quadric, 0.0, top, 32, 1)


class Scene:
    def __init__(self) -> None:
        self.quadric = GLU.gluNewQuadric()
        self.dyes = dyes()

    def draw_pole(self) -> None:
        GL.glPushMatrix()
        GL.glRotatef(-90.0, 1.0, 0.0, 0.0)
        GL.glColor3f(0.52, 0.68, 0.38)
        GLU.gluDisk(self.quadric, 0.0, 9.0, 64, 6)
        GL.glColor3f(0.66, 0.63, 0.59)
        drum(self.quadric, 0.75, 0.72, 0.22)
        drum(self.quadric, 0.45, 0.36, 0.30)
        GL.glColor3f(0.88, 0.88, 0.86)
        drum(self.quadric, THICK, THICK * 0.8, POLE - 0.52)
        GL.glColor3f(0.90, 0.68, 0.20)
        GL.glTranslatef(0.0, 0.0, 0.10)
        GLU.gluSphere(self.quadric, 0.15, 24, 16)
        GL.glPopMatrix()

    def draw_flag(self, time: float, wind: float) -> None:
        points, normals = (array.astype(np.float32) for array in squares(cloth(time, wind)))
        GL.glPushMatrix()
        GL.glTranslatef(2 * THICK, TOP, 0.0)
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, points)
        GL.glNormalPointer(GL.GL_FLOAT, 0, normals)
        for colour, corners in self.dyes:
            GL.glColor3f(*colour)
            GL.glDrawElements(GL.GL_QUADS, corners.size, GL.GL_UNSIGNED_INT, corners)
        GL.glDisableClientState(GL.GL_NORMAL_ARRAY)
        GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
        GL.glPopMatrix()


def set_up() -> None:
    GL.glClearColor(0.74, 0.86, 0.95, 1.0)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glEnable(GL.GL_LIGHTING)
    GL.glEnable(GL.GL_LIGHT0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.80, 0.78, 0.72, 1.0))
    GL.glLightModelfv(GL.GL_LIGHT_MODEL_AMBIENT, (0.36, 0.38, 0.42, 1.0))
    GL.glLightModeli(GL.GL_LIGHT_MODEL_TWO_SIDE, GL.GL_TRUE)
    GL.glEnable(GL.GL_COLOR_MATERIAL)
    GL.glColorMaterial(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT_AND_DIFFUSE)


def look(view: View) -> None:
    GL.glViewport(0, 0, *view.size)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(36.0, view.size[0] / max(view.size[1], 1), 1.0, 40.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.0, -view.distance)
    GL.glRotatef(view.elevation, 1.0, 0.0, 0.0)
    GL.glRotatef(view.azimuth, 0.0, 1.0, 0.0)
    GL.glTranslatef(-1.4, -2.45, 0.0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (-3.0, 4.0, 4.5, 0.0))


def connect(window: object, view: View) -> None:
    def key(window: object, key: int, _scan: int, action: int, _mods: int) -> None:
        if action == glfw.RELEASE:
            return
        if key == glfw.KEY_ESCAPE:
            glfw.set_window_should_close(window, True)
        elif key == glfw.KEY_SPACE:
            view.moving = not view.moving
        elif key in (glfw.KEY_UP, glfw.KEY_DOWN):
            step = 0.1 if key == glfw.KEY_UP else -0.1
            view.wind = min(max(view.wind + step, 0.0), 1.0)
        elif key in (glfw.KEY_EQUAL, glfw.KEY_KP_ADD):
            view.zoom(1)
        elif key in (glfw.KEY_MINUS, glfw.KEY_KP_SUBTRACT):
            view.zoom(-1)

    def button(window: object, button: int, action: int, _mods: int) -> None:
        if button == glfw.MOUSE_BUTTON_LEFT:
            view.grip = glfw.get_cursor_pos(window) if action == glfw.PRESS else None

    def resized(_window: object, width: int, height: int) -> None:
        view.size = (width, height)

    glfw.set_key_callback(window, key)
    glfw.set_mouse_button_callback(window, button)
    glfw.set_cursor_pos_callback(window, lambda _window, x, y: view.drag(x, y))
    glfw.set_scroll_callback(window, lambda _window, _x, y: view.zoom(y))
    glfw.set_framebuffer_size_callback(window, resized)


def main() -> int:
    glfw.ERROR_REPORTING = "ignore"
    if not glfw.init():
        print("flag: no display to open a window on", file=sys.stderr)
        return 1
    window = glfw.create_window(*SIZE, "Flag", None, None)
    glfw.make_context_current(window)
    glfw.swap_interval(1)
    view, scene = View(), Scene()
    connect(window, view)
    set_up()
    while not glfw.window_should_close(window):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        look(view)
        scene.draw_pole()
        scene.draw_flag(view.frame / 60, view.wind)
        glfw.swap_buffers(window)
        view.frame += view.moving
        glfw.poll_events()
    glfw.terminate()
    return 0


if __name__ == "__main__":
    sys.exit(main())
