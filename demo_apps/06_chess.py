"""The last position of the Immortal Game (Anderssen against Kieseritzky, 1851): GLUT, lists.

Pieces are turned on a lathe: runs of a profile are smooth, and where two meet there is a crease.
The rook's battlements, the queen's beads, the king's cross and the knight's head are built onto
them. Arrow keys orbit, +/- zoom, space stops the table, ESC leaves.
"""

import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from OpenGL import GL, GLU, GLUT

SIZE = (640, 480)
POSITION = "r1bk3r/p2pBpNp/n4n2/1p1NP2P/6P1/3P4/P1P1K3/q5b1"  # from the eighth rank down
SLICES = 48  # around an axis; a multiple of twice the battlements
BATTLEMENTS = 6
IVORY, EBONY = (0.88, 0.80, 0.64, 1.0), (0.30, 0.20, 0.17, 1.0)
LIGHT, DARK, FRAME = (0.86, 0.76, 0.58, 1.0), (0.52, 0.34, 0.22, 1.0), (0.40, 0.25, 0.16, 1.0)
Floats = NDArray[np.float64]
Point = tuple[float, float]  # of a profile: radius and height


def curve(*knots: Point, steps: int = 6) -> list[Point]:
    """A smooth run of a profile through knots (Catmull and Rom)."""
    points = np.array([knots[0], *knots, knots[-1]])
    t = np.linspace(0.0, 1.0, steps, endpoint=False)[:, None]
    found: list[Point] = []
    for a, b, c, d in zip(points, points[1:], points[2:], points[3:], strict=False):
        bend = 2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t**2
        row = (bend + (3 * b - a - 3 * c + d) * t**3) / 2
        found += [(float(radius), float(height)) for radius, height in row]
    return [*found, knots[-1]]


def ball(start: Point, middle: float, steps: int = 12) -> list[Point]:
    """A run from a point along a circle around `middle`, a height of the axis, up to its pole."""
    out, up = start[0], start[1] - middle
    radius = float(np.hypot(out, up))
    angles = np.linspace(np.arctan2(up, out), np.pi / 2, steps + 1)[1:-1]
    run = [(float(radius * np.cos(a)), float(middle + radius * np.sin(a))) for a in angles]
    return [start, *run, (0.0, middle + radius)]


def draw_grid(points: Floats, normals: Floats) -> None:
    """A smooth surface of points and normals, (rows, columns, 3), anticlockwise seen from outside
    when columns go right and rows go up. A row of one point is a pole."""
    for low, high, n_low, n_high in zip(points, points[1:], normals, normals[1:], strict=False):
        if (low == low[0]).all():
            ring = [(n_low[0], low[0]), *zip(n_high[::-1], high[::-1], strict=True)]
            mode = GL.GL_TRIANGLE_FAN
        elif (high == high[0]).all():
            ring = [(n_high[0], high[0]), *zip(n_low, low, strict=True)]
            mode = GL.GL_TRIANGLE_FAN
        else:
            both = zip(n_high, high, n_low, low, strict=True)
            ring = [pair for a, b, c, d in both for pair in ((a, b), (c, d))]
            mode = GL.GL_QUAD_STRIP
        GL.glBegin(mode)
        for normal, point in ring:
            GL.glNormal3fv(normal)
            GL.glVertex3fv(point)
        GL.glEnd()


def around(count: int = SLICES) -> tuple[Floats, Floats]:
    """Cosines and sines of a whole turn, the first again at the end."""
    angles = 2 * np.pi * (np.arange(count + 1) % count) / count
    return np.cos(angles), np.sin(angles)


def lathe(runs: Iterable[list[Point]]) -> None:
    """Turn runs of a profile, from the bottom to the top, about the z axis."""
    cosines, sines = around()
    ones = np.ones(len(sines))
    for run in runs:
        radius, height = np.array(run).T
        along = np.gradient(np.array(run), axis=0)
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        out, up = along[:, 1], -along[:, 0]
        out[radius == 0.0], up[radius == 0.0] = 0.0, np.sign(up[radius == 0.0])
        points, normals = (
            np.stack([np.outer(r, cosines), np.outer(r, sines), np.outer(z, ones)], axis=2)
            for r, z in ((radius, height), (out, up))
        )
        draw_grid(points, normals)


def faces(*quads: tuple[Iterable[float], ...]) -> None:
    """Flat quads, each with the normal of its plane."""
    GL.glBegin(GL.GL_QUADS)
    for quad in quads:
        a, b, c, d = np.array(quad)
        normal = np.cross(c - a, d - b)
        GL.glNormal3fv(normal / np.linalg.norm(normal))
        for corner in (a, b, c, d):
            GL.glVertex3fv(corner)
    GL.glEnd()


def foot(r: float, neck: float, height: float) -> list[list[Point]]:
    """The runs that all pieces begin with, up to a stem as thick as `neck` at a height."""
    waist = 0.26 + 0.35 * (height - 0.26)
    return [
        [(0.0, 0.0), (r, 0.0)],
        [(r, 0.0), (r, 0.06)],
        curve((r, 0.06), (0.96 * r, 0.13), (0.80 * r, 0.17)),
        [(0.80 * r, 0.17), (0.80 * r, 0.20)],
        curve((0.80 * r, 0.20), (0.62 * r, 0.26), (1.1 * neck, waist), (neck, height)),
    ]


def collar(r: float, neck: float, height: float, top: float) -> list[list[Point]]:
    """A sharp ring of radius r at a height, around a stem as thick as `neck`; the next run begins
    at radius `top`."""
    return [
        [(neck, height), (r, height + 0.03)],
        [(r, height + 0.03), (r, height + 0.06)],
        [(r, height + 0.06), (top, height + 0.10)],
    ]


def draw_pawn() -> None:
    lathe([*foot(0.29, 0.10, 0.50), *collar(0.19, 0.10, 0.50, 0.09), ball((0.09, 0.60), 0.72)])


def draw_bishop() -> None:
    mitre = curve((0.10, 0.84), (0.17, 0.95), (0.15, 1.08), (0.05, 1.24))
    knob = ball((0.05, 1.24), 1.28)
    lathe([*foot(0.32, 0.10, 0.74), *collar(0.20, 0.10, 0.74, 0.10), mitre, knob])


def draw_queen() -> None:
    bowl = curve((0.11, 1.02), (0.13, 1.16), (0.23, 1.36))
    inside = curve((0.19, 1.36), (0.14, 1.31), (0.05, 1.30))
    lathe([*foot(0.36, 0.12, 0.92), *collar(0.24, 0.12, 0.92, 0.11), bowl,
           [(0.23, 1.36), (0.19, 1.36)], inside, ball((0.05, 1.30), 1.35)])  # fmt: skip
    for k in range(8):
        GL.glPushMatrix()
        GL.glRotatef(45.0 * k, 0.0, 0.0, 1.0)
        GL.glTranslatef(0.21, 0.0, 0.0)
        lathe([ball((0.0, 1.345), 1.39, 8)])
        GL.glPopMatrix()


def draw_king() -> None:
    bowl = curve((0.12, 1.10), (0.14, 1.24), (0.22, 1.42))
    dome = curve((0.19, 1.45), (0.15, 1.52), (0.06, 1.56))
    lathe([*foot(0.37, 0.13, 1.00), *collar(0.25, 0.13, 1.00, 0.12), bowl,
           [(0.22, 1.42), (0.19, 1.45)], dome, [(0.06, 1.56), (0.06, 1.60)],
           [(0.06, 1.60), (0.0, 1.60)]])  # fmt: skip
    draw_cross(1.60, 0.035, 0.11, 0.03)


def draw_cross(bottom: float, half: float, arm: float, thick: float) -> None:
    """An upright cross: bars as wide as twice `half`, arms that reach out so far from the axis."""
    middle = bottom + 1.1 * arm + half
    xs, zs = (-arm, -half, half, arm), (bottom, middle - half, middle + half, middle + arm)
    cells = ((1, 0), (0, 1), (1, 1), (2, 1), (1, 2))  # of the grid that xs and zs make
    for i, k in cells:
        left, right, low, high = xs[i], xs[i + 1], zs[k], zs[k + 1]
        front = [(left, low), (right, low), (right, high), (left, high)]
        faces(tuple((x, -thick, z) for x, z in front),
              tuple((x, thick, z) for x, z in front[::-1]))  # fmt: skip
        for side, beside in enumerate(((i, k - 1), (i + 1, k), (i, k + 1), (i - 1, k))):
            if beside not in cells:
                (x, z), (u, w) = front[side], front[(side + 1) % 4]
                faces(((x, -thick, z), (x, thick, z), (u, thick, w), (u, -thick, w)))


def draw_rook() -> None:
    r, inner, floor, top = 0.25, 0.17, 0.92, 1.04
    lathe([*foot(0.34, 0.17, 0.74), *collar(0.22, 0.17, 0.74, 0.20),
           [(0.20, 0.84), (r, 0.88)], [(r, 0.88), (r, floor)]])  # fmt: skip
    lathe([[(inner, floor), (0.0, floor)]])
    cosines, sines = around()
    teeth = np.arange(SLICES) * 2 * BATTLEMENTS // SLICES % 2 == 0
    for k in range(SLICES):
        a, b = ((cosines[j], sines[j]) for j in (k, k + 1))

        def at(angle: Point, radius: float, height: float) -> tuple[float, ...]:
            return radius * angle[0], radius * angle[1], height

        level = top if teeth[k] else floor
        faces((at(a, r, level), at(b, r, level), at(b, inner, level), at(a, inner, level)))
        if teeth[k]:
            wall((a, b), r, (floor, top), 1.0)
            wall((b, a), inner, (floor, top), -1.0)
        if teeth[k] != teeth[k - 1]:
            side = (at(a, inner, floor), at(a, r, floor), at(a, r, top), at(a, inner, top))
            faces(side if teeth[k] else side[::-1])


def wall(angles: tuple[Point, Point], r: float, heights: Point, way: float) -> None:
    """One slice of a round wall, from angle to angle (cosine, sine), that looks out or in."""
    points = [[(r * c, r * s, height) for c, s in angles] for height in heights]
    draw_grid(np.array(points), np.array([[(way * c, way * s, 0.0) for c, s in angles]] * 2))


def draw_knight() -> None:
    """The head is a bent tube: along it the middle (x, z), half its depth and half its width."""
    lathe([*foot(0.34, 0.20, 0.36), [(0.20, 0.36), (0.0, 0.36)]])
    knots = np.array((
        (-0.02, 0.30, 0.17, 0.15), (-0.07, 0.45, 0.19, 0.14), (-0.11, 0.62, 0.19, 0.125),
        (-0.12, 0.80, 0.17, 0.115), (-0.06, 0.95, 0.15, 0.11), (0.05, 1.00, 0.15, 0.11),
        (0.15, 0.94, 0.15, 0.10), (0.24, 0.84, 0.12, 0.08), (0.31, 0.76, 0.10, 0.07),
        (0.35, 0.71, 0.08, 0.055),
    ))  # fmt: skip
    x, z, deep, wide = np.array([
        np.interp(np.linspace(0, len(knots) - 1, 37), np.arange(len(knots)), column)
        for column in knots.T
    ])  # fmt: skip
    middle = np.stack([x, z], axis=1)
    for _ in range(24):  # corners of the interpolation are worn off
        middle[1:-1] = (middle[:-2] + 2 * middle[1:-1] + middle[2:]) / 4
    along = np.gradient(middle, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    cosines, sines = around(24)
    depth = deep[:, None] * np.where(cosines < 0, cosines, 0.65 * cosines)  # the throat is flat
    points = np.stack([
        middle[:, :1] + along[:, 1:] * depth, wide[:, None] * sines,
        middle[:, 1:] - along[:, :1] * depth,
    ], axis=2)  # fmt: skip
    tip = (middle[-1, 0] + 0.02 * along[-1, 0], 0.0, middle[-1, 1] + 0.02 * along[-1, 1])
    ends = (np.broadcast_to(end, (1, 25, 3)) for end in ((*middle[:1, 0], 0.0, 0.26), tip))
    points = np.concatenate([next(ends), points, *ends])
    draw_grid(points, smooth_normals(points))
    for side in (-1.0, 1.0):
        GL.glPushMatrix()
        GL.glTranslatef(-0.07, 0.06 * side, 1.05)
        GL.glRotatef(-14.0 * side, 1.0, 0.0, 0.0)
        lathe([[(0.0, 0.0), (0.045, 0.0)], curve((0.045, 0.0), (0.045, 0.07), (0.012, 0.15)),
               ball((0.012, 0.15), 0.145, 4)])  # fmt: skip
        GL.glPopMatrix()


def smooth_normals(points: Floats) -> Floats:
    """The unit normals of a grid that is closed around its columns; a pole has one."""
    wrapped = np.concatenate([points[:, -2:-1], points, points[:, 1:2]], axis=1)
    across = wrapped[:, 2:] - wrapped[:, :-2]
    normals = np.cross(across, np.gradient(points, axis=0))
    for row in np.flatnonzero((points == points[:, :1]).all(axis=(1, 2))):
        normals[row] = points[row, 0] - points[row - 1 if row else 1, :-1].mean(axis=0)
    return np.asarray(normals / np.linalg.norm(normals, axis=2, keepdims=True))


PIECES: dict[str, Callable[[], None]] = {
    "p": draw_pawn, "n": draw_knight, "b": draw_bishop, "r": draw_rook, "q": draw_queen,
    "k": draw_king,
}  # fmt: skip


def material(colour: tuple[float, ...], shine: float = 0.35) -> None:
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT_AND_DIFFUSE, colour)
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_SPECULAR, (shine, shine, shine, 1.0))
    GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, 40.0)


def draw_board() -> None:
    """Squares of one unit around the origin, in a frame."""
    for colour, parity in ((LIGHT, 1), (DARK, 0)):
        material(colour, 0.1)
        faces(*(((x, y, 0.0), (x + 1, y, 0.0), (x + 1, y + 1, 0.0), (x, y + 1, 0.0))
                for x in range(-4, 4) for y in range(-4, 4) if (x + y) % 2 == parity))  # fmt: skip
    material(FRAME, 0.2)
    for k in range(4):
        GL.glPushMatrix()
        GL.glRotatef(90.0 * k, 0.0, 0.0, 1.0)
        faces(((-4, -4, 0), (-4.5, -4.5, 0), (4.5, -4.5, 0), (4, -4, 0)),
              ((-4.5, -4.5, -0.4), (4.5, -4.5, -0.4), (4.5, -4.5, 0), (-4.5, -4.5, 0)))  # fmt: skip
        GL.glPopMatrix()


def compiled(draw: Callable[[], None]) -> int:
    """A display list of what `draw` draws."""
    name = GL.glGenLists(1)
    GL.glNewList(name, GL.GL_COMPILE)
    draw()
    GL.glEndList()
    return int(name)


def standing() -> Iterable[tuple[str, float, float]]:
    """The pieces of the position, capitals for white ones, and the middles of their squares."""
    for rank, row in enumerate(POSITION.split("/")):
        column = 0
        for letter in row:
            if not letter.isdigit():
                yield letter, column - 3.5, 3.5 - rank
            column += int(letter) if letter.isdigit() else 1


@dataclass
class View:
    azimuth: float = 24.0
    elevation: float = 34.0
    distance: float = 17.5
    size: tuple[int, int] = SIZE
    moving: bool = True


view = View()


def display(lists: dict[str, int]) -> None:
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(34.0, view.size[0] / view.size[1], 1.0, 60.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.2, -view.distance)
    GL.glRotatef(view.elevation - 90.0, 1.0, 0.0, 0.0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (-4.0, -5.0, 9.0, 0.0))
    GL.glRotatef(view.azimuth, 0.0, 0.0, 1.0)
    GL.glCallList(lists["board"])
    for letter, x, y in standing():
        white = letter.isupper()
        material(IVORY if white else EBONY)
        GL.glPushMatrix()
        GL.glTranslatef(x, y, 0.0)
        GL.glRotatef(90.0 if white else -90.0, 0.0, 0.0, 1.0)
        GL.glCallList(lists[letter.lower()])
        GL.glPopMatrix()
    GLUT.glutSwapBuffers()


def advance(_value: int) -> None:
    view.azimuth += 0.2 * view.moving
    GLUT.glutPostRedisplay()
    GLUT.glutTimerFunc(16, advance, 0)


def reshape(width: int, height: int) -> None:
    view.size = (width, max(height, 1))
    GL.glViewport(0, 0, *view.size)


def keyboard(key: bytes, _x: int, _y: int) -> None:
    if key == b"\x1b":
        GLUT.glutLeaveMainLoop()
    elif key == b" ":
        view.moving = not view.moving
    elif key in (b"+", b"="):
        view.distance = max(view.distance * 0.9, 5.0)
    elif key == b"-":
        view.distance = min(view.distance / 0.9, 40.0)


def arrows(key: int, _x: int, _y: int) -> None:
    view.azimuth += 5.0 * ((key == GLUT.GLUT_KEY_RIGHT) - (key == GLUT.GLUT_KEY_LEFT))
    turn = 5.0 * ((key == GLUT.GLUT_KEY_UP) - (key == GLUT.GLUT_KEY_DOWN))
    view.elevation = min(max(view.elevation + turn, 5.0), 90.0)


def set_up() -> None:
    GL.glClearColor(0.90, 0.92, 0.93, 1.0)
    for switch in (GL.GL_DEPTH_TEST, GL.GL_CULL_FACE, GL.GL_NORMALIZE, GL.GL_LIGHTING,
                   GL.GL_LIGHT0):  # fmt: skip
        GL.glEnable(switch)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.80, 0.79, 0.76, 1.0))
    GL.glLightModelfv(GL.GL_LIGHT_MODEL_AMBIENT, (0.36, 0.36, 0.38, 1.0))


def main() -> None:
    GLUT.glutInit(sys.argv)
    GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE | GLUT.GLUT_RGB | GLUT.GLUT_DEPTH)
    GLUT.glutInitWindowSize(*SIZE)
    GLUT.glutCreateWindow(b"Chess")
    set_up()
    lists = {name: compiled(draw) for name, draw in {**PIECES, "board": draw_board}.items()}
    GLUT.glutDisplayFunc(lambda: display(lists))
    GLUT.glutReshapeFunc(reshape)
    GLUT.glutKeyboardFunc(keyboard)
    GLUT.glutSpecialFunc(arrows)
    GLUT.glutTimerFunc(16, advance, 0)
    GLUT.glutMainLoop()


if __name__ == "__main__":
    main()
