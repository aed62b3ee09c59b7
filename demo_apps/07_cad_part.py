# ruff: noqa: F403, F405
"""A bearing flange on a turntable: GLUT, immediate mode, a text overlay.

Everything is sent again with glBegin/glEnd in every frame, as many CAD programs do.
Drag to orbit, wheel or +/- to zoom, space to stop the turntable, ESC to leave.
"""

import math
import sys
from collections.abc import Iterable, Sequence
from itertools import pairwise

from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

Point = tuple[float, float]

HOLES = 6  # bolt holes, one in each sector of the flange
ARC = 10  # points along one sector's arc
BORE, BOSS, PITCH, RIM = 0.55, 0.95, 1.55, 2.1  # radii: bore, boss, bolt circle, rim
BOLT = 0.24  # radius of a bolt hole
THICK, TALL = 0.36, 1.5  # height of the flange and of the boss
BEVEL = 0.07

STEEL = (0.62, 0.66, 0.72, 1.0)
BRASS = (0.80, 0.62, 0.28, 1.0)
WIDTH, HEIGHT = 640, 480

frame = 0
turning = True
azimuth, elevation, distance = 25.0, 38.0, 7.2
grip: tuple[int, int] | None = None
size = (WIDTH, HEIGHT)


def polar(radius: float, angle: float) -> Point:
    return radius * math.cos(angle), radius * math.sin(angle)


def sector_outline(middle: float) -> list[Point]:
    """The border of one sector of the flange, counter-clockwise, closed."""
    half = math.pi / HOLES
    angles = [middle - half + 2 * half * i / ARC for i in range(ARC + 1)]
    radii = [BOSS + (RIM - BEVEL - BOSS) * i / 6 for i in range(7)]
    outer = [polar(RIM - BEVEL, a) for a in angles]
    inner = [polar(BOSS, a) for a in reversed(angles)]
    right = [polar(r, angles[0]) for r in radii[1:-1]]
    left = [polar(r, angles[-1]) for r in reversed(radii[1:-1])]
    return [*outer, *left, *inner, *right, outer[0]]


def sectors() -> Iterable[tuple[list[Point], list[Point], list[Point]]]:
    """Outline, hole and the hole's outward directions, point for point, of every sector."""
    for k in range(HOLES):
        middle = 2 * math.pi * k / HOLES
        cx, cy = polar(PITCH, middle)
        outline = sector_outline(middle)
        rays = []
        for x, y in outline:
            length = math.hypot(x - cx, y - cy)
            rays.append(((x - cx) / length, (y - cy) / length))
        yield outline, [(cx + BOLT * x, cy + BOLT * y) for x, y in rays], rays


SECTORS = list(sectors())


def face(z: float, up: float) -> None:
    """The perforated top (up = 1) or bottom (up = -1) of the flange."""
    glNormal3f(0.0, 0.0, up)
    for outline, hole, _ in SECTORS:
        glBegin(GL_QUAD_STRIP)
        for (ox, oy), (hx, hy) in zip(outline, hole, strict=True):
            first, second = ((hx, hy), (ox, oy)) if up > 0 else ((ox, oy), (hx, hy))
            glVertex3f(*first, z)
            glVertex3f(*second, z)
        glEnd()


def hole_walls(low: float, high: float) -> None:
    for _, hole, rays in SECTORS:
        glBegin(GL_QUAD_STRIP)
        for (x, y), (nx, ny) in zip(hole, rays, strict=True):
            glNormal3f(-nx, -ny, 0.0)
            glVertex3f(x, y, low)
            glVertex3f(x, y, high)
        glEnd()


def lathe(profile: Sequence[Point]) -> None:
    """Turn a polyline of (radius, z) about the z axis; the part lies left of the polyline."""
    steps = HOLES * ARC
    turn = [2 * math.pi * (i / steps - 0.5 / HOLES) for i in range(steps + 1)]
    for (r0, z0), (r1, z1) in pairwise(profile):
        length = math.hypot(r1 - r0, z1 - z0)
        nr, nz = (z1 - z0) / length, (r0 - r1) / length
        glBegin(GL_QUAD_STRIP)
        for a in turn:
            c, s = math.cos(a), math.sin(a)
            glNormal3f(nr * c, nr * s, nz)
            glVertex3f(r1 * c, r1 * s, z1)
            glVertex3f(r0 * c, r0 * s, z0)
        glEnd()


def rib(angle: float) -> None:
    """A gusset between the boss and the flange."""
    near, far, low, high, w = BOSS - 0.1, RIM - 0.2, THICK - 0.05, TALL - 0.25, 0.08
    slope = math.hypot(far - near, high - low)
    glPushMatrix()
    glRotatef(math.degrees(angle), 0.0, 0.0, 1.0)
    glBegin(GL_TRIANGLES)
    for side, order in ((w, (0, 2, 1)), (-w, (0, 1, 2))):
        corners = ((near, low), (far, low), (near, high))
        glNormal3f(0.0, math.copysign(1.0, side), 0.0)
        for i in order:
            glVertex3f(corners[i][0], side, corners[i][1])
    glEnd()
    glBegin(GL_QUADS)
    glNormal3f((high - low) / slope, 0.0, (far - near) / slope)
    glVertex3f(far, -w, low)
    glVertex3f(far, w, low)
    glVertex3f(near, w, high)
    glVertex3f(near, -w, high)
    glEnd()
    glPopMatrix()


def bolt(x: float, y: float) -> None:
    """A hexagon head resting on the flange."""
    low, high, radius = THICK, THICK + 0.2, BOLT * 1.3
    corners = [polar(radius, math.pi * i / 3) for i in range(7)]
    glPushMatrix()
    glTranslatef(x, y, 0.0)
    glBegin(GL_POLYGON)
    glNormal3f(0.0, 0.0, 1.0)
    for cx, cy in corners[:6]:
        glVertex3f(cx, cy, high)
    glEnd()
    glBegin(GL_QUADS)
    for i in range(6):
        (ax, ay), (bx, by) = corners[i], corners[i + 1]
        glNormal3f(*polar(1.0, math.pi * (2 * i + 1) / 6), 0.0)
        glVertex3f(ax, ay, low)
        glVertex3f(bx, by, low)
        glVertex3f(bx, by, high)
        glVertex3f(ax, ay, high)
    glEnd()
    glPopMatrix()


def draw_part() -> None:
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, STEEL)
    face(THICK, 1.0)
    face(0.0, -1.0)
    hole_walls(0.0, THICK)
    lathe([(RIM - BEVEL, 0.0), (RIM, BEVEL), (RIM, THICK - BEVEL), (RIM - BEVEL, THICK)])
    lathe([(BOSS, THICK), (BOSS, TALL - BEVEL), (BOSS - BEVEL, TALL), (BORE, TALL), (BORE, 0.0),
           (BOSS, 0.0)])
    for k in range(HOLES):
        rib(2 * math.pi * (k + 0.5) / HOLES)
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, BRASS)
    for k in range(0, HOLES, 2):
        bolt(*polar(PITCH, 2 * math.pi * k / HOLES))


def flat_view() -> None:
    """Switch to window coordinates for the backdrop and the text."""
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glOrtho(0, size[0], 0, size[1], -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glDisable(GL_DEPTH_TEST)
    glDisable(GL_LIGHTING)


def draw_backdrop() -> None:
    flat_view()
    w, h = size
    glBegin(GL_QUADS)
    glColor3f(0.93, 0.94, 0.95)
    glVertex2f(0, 0)
    glVertex2f(w, 0)
    glColor3f(0.72, 0.78, 0.86)
    glVertex2f(w, h)
    glVertex2f(0, h)
    glEnd()


def write(x: float, y: float, text: str) -> None:
    glRasterPos2f(x, y)
    for letter in text:
        glutBitmapCharacter(GLUT_BITMAP_HELVETICA_12, ord(letter))


def draw_overlay() -> None:
    flat_view()
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
    glColor4f(1.0, 1.0, 1.0, 0.75)
    glRectf(10, 10, 236, 68)
    glDisable(GL_BLEND)
    glColor3f(0.12, 0.16, 0.24)
    write(20, 50, "FLANGE BEARING  6 x M48")
    write(20, 34, f"bore {BORE * 200:.0f} mm   rim {RIM * 200:.0f} mm")
    write(20, 18, f"view {(azimuth + frame * 0.6) % 360:5.1f} deg   ESC leaves")


def display() -> None:
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    draw_backdrop()
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(40.0, size[0] / size[1], 1.0, 40.0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glLightfv(GL_LIGHT0, GL_POSITION, (3.0, 5.0, 6.0, 0.0))
    glLightfv(GL_LIGHT1, GL_POSITION, (-6.0, 1.0, 2.0, 0.0))
    glTranslatef(0.0, 0.0, -distance)
    glRotatef(elevation - 90.0, 1.0, 0.0, 0.0)
    glRotatef(azimuth + frame * 0.6, 0.0, 0.0, 1.0)
    glTranslatef(0.0, 0.0, -0.6)
    draw_part()
    draw_overlay()
    glutSwapBuffers()


def tick(_value: int) -> None:
    global frame
    frame += turning
    glutPostRedisplay()
    glutTimerFunc(16, tick, 0)


def reshape(width: int, height: int) -> None:
    global size
    size = (width, max(height, 1))
    glViewport(0, 0, *size)


def keyboard(key: bytes, _x: int, _y: int) -> None:
    global turning
    if key == b"\x1b":
        glutLeaveMainLoop()
    elif key == b" ":
        turning = not turning
    elif key in b"+=":
        zoom(0.9)
    elif key == b"-":
        zoom(1 / 0.9)


def zoom(factor: float) -> None:
    global distance
    distance = min(max(distance * factor, 4.0), 25.0)
    glutPostRedisplay()


def mouse(button: int, state: int, x: int, y: int) -> None:
    global grip
    if button == GLUT_LEFT_BUTTON:
        grip = (x, y) if state == GLUT_DOWN else None
    elif button in (3, 4) and state == GLUT_DOWN:  # the wheel
        zoom(0.9 if button == 3 else 1 / 0.9)


def motion(x: int, y: int) -> None:
    global azimuth, elevation, grip
    if grip is not None:
        azimuth += 0.5 * (x - grip[0])
        elevation = min(max(elevation + 0.5 * (y - grip[1]), -89.0), 89.0)
        grip = (x, y)
        glutPostRedisplay()


def light() -> None:
    glEnable(GL_LIGHT0)
    glLightfv(GL_LIGHT0, GL_DIFFUSE, (0.85, 0.84, 0.80, 1.0))
    glLightfv(GL_LIGHT0, GL_SPECULAR, (0.5, 0.5, 0.5, 1.0))
    glEnable(GL_LIGHT1)
    glLightfv(GL_LIGHT1, GL_DIFFUSE, (0.25, 0.30, 0.38, 1.0))
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (0.4, 0.4, 0.4, 1.0))
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40.0)


def main() -> None:
    glutInit(sys.argv)
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
    glutInitWindowSize(WIDTH, HEIGHT)
    glutCreateWindow(b"Flange bearing")
    light()
    glutDisplayFunc(display)
    glutReshapeFunc(reshape)
    glutKeyboardFunc(keyboard)
    glutMouseFunc(mouse)
    glutMotionFunc(motion)
    glutTimerFunc(16, tick, 0)
    glutMainLoop()


if __name__ == "__main__":
    main()
