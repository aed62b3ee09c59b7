"""Clay that turns from a ball into a head into a gear and back: pygame, immediate mode.

One mesh of 1536 quads, each corner sent by glNormal3fv and glVertex3fv. The change runs down the
body; brow, nose and teeth fold up out of the round and vanish into it again. Arrow keys orbit,
+/- zoom, n jumps to the next shape, space stops time, ESC leaves.
"""

import ctypes
from dataclasses import dataclass

import numpy as np
import pygame
from numpy.typing import NDArray
from OpenGL import GL, GLU

SIZE = (640, 480)
HALF = 8  # squares along half an edge of the cube that all the shapes are made of
STAY, CHANGE = 1.6, 2.4  # seconds in one shape, and on the way to the next
CLAYS = np.array([[0.30, 0.56, 0.70], [0.82, 0.52, 0.36], [0.62, 0.64, 0.68]])
Floats = NDArray[np.float64]
Indices = NDArray[np.intp]

# Half of the face, from forehead to chin: each digit is a corner of the mesh, the leftmost
# in the middle of the face; 3 is the skin, higher stands out.
FACE = """
    333333333
    333333333
    333333333
    444444333
    455666543
    541111233
    641344433
    741455433
    852222333
    963333343
    A75444443
    333333333
    555443333
    122233333
    555443333
    333333333
    555443333
"""


def around(quads: Indices) -> Indices:
    """The quads that meet in each corner, (V, 4); -1 where there are only three."""
    order = np.argsort(quads, axis=None, kind="stable")
    corner = quads.ravel()[order]
    first = np.searchsorted(corner, corner)
    found = np.full((corner[-1] + 1, 4), -1)
    found[corner, np.arange(len(corner)) - first] = order // 4
    return found


def lattice() -> tuple[Indices, Indices]:
    """Corners of a cube cut into squares, whole numbers (V, 3) from -HALF to HALF, and its squares
    (F, 4), counter-clockwise from outside."""
    k = np.arange(-HALF, HALF)
    u, v = (a.ravel() for a in np.meshgrid(k, k))
    sides = []
    for axis in range(3):
        for end in (-HALF, HALF):
            ring = [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)]
            corners = np.empty((len(u), 4, 3), np.intp)
            for at, (a, b) in enumerate(ring if end > 0 else ring[::-1]):
                corners[:, at, axis] = end
                corners[:, at, (axis + 1) % 3], corners[:, at, (axis + 2) % 3] = a, b
            sides.append(corners)
    every = np.concatenate(sides)
    points, number = np.unique(every.reshape(-1, 3), axis=0, return_inverse=True)
    return points, number.reshape(-1, 4)


POINTS, QUADS = lattice()
AROUND = around(QUADS)
CUBE = POINTS / HALF


def turned(x: Floats, y: Floats, z: Floats) -> tuple[Floats, Floats, Floats]:
    """The cube as a lathe sees it, about z: the turn from x to y, how far out from the axis (0 to
    1), and the way from the middle of the bottom (-2) over its rim (-1, 1) to that of the top (2).
    """
    out = np.maximum(np.abs(x), np.abs(y))
    part = np.divide(np.where(np.abs(x) >= np.abs(y), y, -x), np.maximum(out, 1e-9)) * np.pi / 4
    part = np.where(np.abs(x) >= np.abs(y), part * np.sign(x), part * np.sign(y) + np.pi / 2)
    part += np.where(np.where(np.abs(x) >= np.abs(y), x, y) < 0, np.pi, 0.0)
    return part, out, np.where(np.abs(z) < 1.0, z, np.sign(z) * (2.0 - out))


def ball() -> Floats:
    spread = np.tan(CUBE * np.pi / 4)
    return spread / np.linalg.norm(spread, axis=1, keepdims=True)


def head() -> Floats:
    """Lathed about y from tables of its half width, front and back, then carved."""
    x, y, z = CUBE.T
    turn, _, way = turned(z, x, y)
    knots = (-2.0, -1.5, -1.375, -1.0, -0.6, -0.2, 0.3, 0.7, 1.0, 1.25, 1.5, 1.75, 2.0)
    table = (
        (-1.40, -1.36, -1.00, -0.98, -0.70, -0.32, 0.16, 0.55, 0.82, 0.98, 1.09, 1.15, 1.17),
        (0.00, 0.40, 0.34, 0.44, 0.60, 0.70, 0.75, 0.74, 0.66, 0.54, 0.38, 0.20, 0.00),
        (0.00, 0.30, 0.30, 0.72, 0.76, 0.80, 0.82, 0.82, 0.72, 0.58, 0.41, 0.21, 0.00),
        (0.00, 0.44, 0.38, 0.48, 0.62, 0.80, 0.92, 0.92, 0.80, 0.66, 0.46, 0.24, 0.00),
    )
    level, wide, front, back = (np.interp(way, knots, row) for row in table)
    deep = np.where(np.cos(turn) > 0, front, back)
    points = np.stack([wide * np.sin(turn), level, deep * np.cos(turn)], axis=1)
    relief = np.array([[int(digit, 16) for digit in row] for row in FACE.split()])
    column, row, side = POINTS.T
    face = side == HALF
    points[face, 2] += 0.05 * (relief[HALF - row[face], np.abs(column[face])] - 3)
    ear = (np.abs(column) == HALF) & (np.abs(side + 1) <= 1) & (np.abs(row) <= 2)
    points[ear] += np.stack([0.16 * np.sign(x), 0.0 * x, -0.06 + 0.0 * x], axis=1)[ear]
    return points


def gear() -> Floats:
    """Lathed about z: eight teeth, a rim, a deep web and a hub with a bore."""
    turn, out, way = turned(*CUBE.T)
    ring = np.rint(out * HALF).astype(np.intp)
    radius = np.array([0.0, 0.13, 0.17, 0.36, 0.40, 0.62, 0.66, 0.84, 0.90])[ring]
    tooth = (np.rint(turn / (2 * np.pi) * 8 * HALF) + 1) % 8 < 4
    radius = np.where((ring == HALF) & tooth, 1.18, radius)
    relief = np.array([0.10, 0.10, 0.50, 0.46, 0.16, 0.16, 0.36, 0.36, 0.36])[ring]
    level = np.where(np.abs(way) < 1.0, 0.36 * way, np.sign(way) * relief)
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), level], axis=1)


SHAPES = np.stack([ball(), head(), gear()])


def weights(time: float) -> Floats:
    """(3, V) how much of each shape is in each corner: the change runs from the top down."""
    at, gone = divmod(time, STAY + CHANGE)
    late = 0.45 * (1.0 - ball()[:, 1]) / 2.0
    part = np.clip(((gone - STAY) / CHANGE - late) / 0.55, 0.0, 1.0)
    part = part * part * (3.0 - 2.0 * part)
    mix = np.zeros((3, len(CUBE)))
    mix[int(at) % 3] = 1.0 - part
    mix[(int(at) + 1) % 3] = part
    return mix


def body(time: float) -> Floats:
    """The corners of the mesh, (V, 3), whose squares are QUADS."""
    mix = weights(time)
    wobble = np.sin(3.0 * SHAPES[0] + (2.6 * time, 1.9 * time, 2.2 * time)).sum(axis=1)
    points = np.einsum("sv,svi->vi", mix, SHAPES)
    return np.asarray(points * (1.0 + 0.05 * wobble * mix[0])[:, None])


def normals_of(points: Floats) -> Floats:
    """Normals at the corners of the quads, (F, 4, 3): smooth over bends, not over sharp folds."""
    a, b, c, d = points[QUADS].transpose(1, 0, 2)
    flat = np.cross(c - a, d - b)
    flat /= np.maximum(np.linalg.norm(flat, axis=1, keepdims=True), 1e-12)
    near = np.append(flat, [[0.0, 0.0, 0.0]], axis=0)[AROUND[QUADS]]
    alike = np.einsum("fi,fcni->fcn", flat, near)
    normals = np.einsum("fcn,fcni->fci", np.clip((alike - 0.7) / 0.2, 0.0, 1.0), near)
    return np.asarray(normals / np.linalg.norm(normals, axis=2, keepdims=True))


@dataclass
class View:
    azimuth: float = 0.0
    elevation: float = 10.0
    distance: float = 4.8
    moving: bool = True
    time: float = STAY + 0.9 * CHANGE


def rows(array: Floats) -> list[ctypes.Array[ctypes.c_float]]:
    """An array's triples in C's own form, which the calls ending in fv take as they are."""
    data = np.ascontiguousarray(array, np.float32).reshape(-1, 3)
    return list((ctypes.c_float * 3 * len(data)).from_buffer(data))


def draw_body(time: float) -> None:
    points = body(time)
    GL.glColor3fv(weights(time).mean(axis=1) @ CLAYS)
    GL.glBegin(GL.GL_QUADS)
    for normal, point in zip(rows(normals_of(points)), rows(points[QUADS]), strict=True):
        GL.glNormal3fv(normal)
        GL.glVertex3fv(point)
    GL.glEnd()


def set_up() -> None:
    GL.glClearColor(0.90, 0.89, 0.86, 1.0)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glEnable(GL.GL_CULL_FACE)
    GL.glEnable(GL.GL_LIGHTING)
    GL.glEnable(GL.GL_COLOR_MATERIAL)
    GL.glMaterialfv(GL.GL_FRONT, GL.GL_SPECULAR, (0.22, 0.22, 0.22, 1.0))
    GL.glMaterialf(GL.GL_FRONT, GL.GL_SHININESS, 24.0)
    lights = (
        (GL.GL_LIGHT0, (-3.0, 4.0, 4.0, 0.0), (0.80, 0.78, 0.74, 1.0)),
        (GL.GL_LIGHT1, (4.0, -1.0, 2.0, 0.0), (0.20, 0.22, 0.28, 1.0)),
    )
    for light, place, colour in lights:
        GL.glEnable(light)
        GL.glLightfv(light, GL.GL_POSITION, place)
        GL.glLightfv(light, GL.GL_DIFFUSE, colour)


def look(view: View) -> None:
    width, height = pygame.display.get_window_size()
    GL.glViewport(0, 0, width, height)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(36.0, width / max(height, 1), 1.0, 30.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.0, -view.distance)
    GL.glRotatef(view.elevation, 1.0, 0.0, 0.0)
    GL.glRotatef(view.azimuth + 32.0 * np.sin(0.5 * view.time), 0.0, 1.0, 0.0)


def handle(event: pygame.event.Event, view: View) -> bool:
    """Whether the program goes on."""
    if event.type == pygame.QUIT:
        return False
    if event.type == pygame.KEYDOWN:
        if event.key == pygame.K_ESCAPE:
            return False
        if event.key == pygame.K_SPACE:
            view.moving = not view.moving
        elif event.key == pygame.K_n:
            view.time = (view.time // (STAY + CHANGE) + 1.0) * (STAY + CHANGE)
        view.azimuth += 5.0 * ((event.key == pygame.K_RIGHT) - (event.key == pygame.K_LEFT))
        view.elevation += 5.0 * ((event.key == pygame.K_UP) - (event.key == pygame.K_DOWN))
        if event.unicode in ("+", "="):
            view.distance = max(view.distance * 0.9, 3.0)
        elif event.unicode == "-":
            view.distance = min(view.distance / 0.9, 20.0)
    return True


def main() -> None:
    pygame.display.init()
    pygame.display.set_mode(SIZE, pygame.OPENGL | pygame.DOUBLEBUF | pygame.RESIZABLE)
    pygame.display.set_caption("Blob")
    set_up()
    view, clock = View(), pygame.time.Clock()
    while all([handle(event, view) for event in pygame.event.get()]):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        look(view)
        draw_body(view.time)
        pygame.display.flip()
        view.time += view.moving / 60
        clock.tick(60)
    pygame.quit()


if __name__ == "__main__":
    main()
