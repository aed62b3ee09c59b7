"""A robot arm that stacks boxes: pygame, nested display lists, GLU quadrics, materials.

Each joint is a list that calls the lists of its parts; only the joints' angles change from frame
to frame. Arrow keys orbit, +/- zoom, space stops the arm, ESC leaves.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import pygame
from OpenGL import GL, GLU

SIZE = (640, 480)
ORANGE = (0.92, 0.45, 0.12, 1.0)
GRAPHITE = (0.26, 0.28, 0.31, 1.0)
ALUMINIUM = (0.75, 0.77, 0.80, 1.0)
WOOD = (0.76, 0.60, 0.40, 1.0)
FLOOR = (0.55, 0.60, 0.60, 1.0)

UPPER, FORE = 1.7, 1.5  # lengths of the two arms


@dataclass
class View:
    azimuth: float = -28.0
    elevation: float = 22.0
    distance: float = 9.0
    moving: bool = True
    frame: int = 0


def compiled(draw: Callable[[], None]) -> int:
    """A display list of what `draw` draws."""
    name = GL.glGenLists(1)
    GL.glNewList(name, GL.GL_COMPILE)
    draw()
    GL.glEndList()
    return int(name)


def material(colour: tuple[float, ...], shine: float = 30.0) -> None:
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT_AND_DIFFUSE, colour)
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_SPECULAR, (0.3, 0.3, 0.3, 1.0))
    GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, shine)


def box(x: float, y: float, z: float) -> None:
    """A box of the given half sizes around the origin."""
    faces = (
        ((1, 0, 0), ((1, -1, -1), (1, 1, -1), (1, 1, 1), (1, -1, 1))),
        ((-1, 0, 0), ((-1, -1, 1), (-1, 1, 1), (-1, 1, -1), (-1, -1, -1))),
        ((0, 1, 0), ((-1, 1, -1), (-1, 1, 1), (1, 1, 1), (1, 1, -1))),
        ((0, -1, 0), ((-1, -1, 1), (-1, -1, -1), (1, -1, -1), (1, -1, 1))),
        ((0, 0, 1), ((-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))),
        ((0, 0, -1), ((-1, 1, -1), (1, 1, -1), (1, -1, -1), (-1, -1, -1))),
    )
    GL.glBegin(GL.GL_QUADS)
    for normal, corners in faces:
        GL.glNormal3fv(normal)
        for cx, cy, cz in corners:
            GL.glVertex3f(cx * x, cy * y, cz * z)
    GL.glEnd()


def drum(radius: float, length: float) -> None:
    """A closed cylinder along y, centred."""
    quadric = GLU.gluNewQuadric()
    GL.glPushMatrix()
    GL.glRotatef(-90.0, 1.0, 0.0, 0.0)
    GL.glTranslatef(0.0, 0.0, -length / 2)
    GLU.gluCylinder(quadric, radius, radius, length, 32, 1)
    GL.glPushMatrix()
    GL.glRotatef(180.0, 1.0, 0.0, 0.0)
    GLU.gluDisk(quadric, 0.0, radius, 32, 1)
    GL.glPopMatrix()
    GL.glTranslatef(0.0, 0.0, length)
    GLU.gluDisk(quadric, 0.0, radius, 32, 1)
    GL.glPopMatrix()
    GLU.gluDeleteQuadric(quadric)


class Robot:
    """Lists made once: parts, then links that call the parts."""

    def __init__(self) -> None:
        joint = compiled(self.draw_joint)
        rod = compiled(lambda: drum(0.09, 1.0))
        self.foot = compiled(self.draw_foot)
        self.upper = compiled(lambda: self.draw_link(joint, rod, UPPER, 0.22))
        self.fore = compiled(lambda: self.draw_link(joint, rod, FORE, 0.17))
        self.hand = compiled(self.draw_hand)
        self.finger = compiled(self.draw_finger)
        self.crate = compiled(self.draw_crate)
        self.floor = compiled(self.draw_floor)

    @staticmethod
    def draw_joint() -> None:
        material(GRAPHITE)
        GL.glPushMatrix()
        GL.glRotatef(90.0, 1.0, 0.0, 0.0)
        drum(0.30, 0.62)
        GL.glPopMatrix()

    @staticmethod
    def draw_link(joint: int, rod: int, length: float, thick: float) -> None:
        """From the joint at the origin up along y."""
        GL.glCallList(joint)
        material(ORANGE)
        GL.glPushMatrix()
        GL.glTranslatef(0.0, length / 2, 0.0)
        box(thick, length / 2 - 0.1, thick)
        GL.glPopMatrix()
        material(ALUMINIUM, 80.0)
        GL.glPushMatrix()
        GL.glTranslatef(0.0, length / 2, thick + 0.08)
        GL.glScalef(1.0, length * 0.7, 1.0)
        GL.glCallList(rod)
        GL.glPopMatrix()

    @staticmethod
    def draw_foot() -> None:
        material(GRAPHITE)
        GL.glPushMatrix()
        GL.glTranslatef(0.0, 0.12, 0.0)
        drum(0.85, 0.24)
        material(ORANGE)
        GL.glTranslatef(0.0, 0.37, 0.0)
        drum(0.55, 0.5)
        GL.glPopMatrix()

    @staticmethod
    def draw_hand() -> None:
        material(GRAPHITE)
        quadric = GLU.gluNewQuadric()
        GLU.gluSphere(quadric, 0.24, 24, 16)
        GLU.gluDeleteQuadric(quadric)
        GL.glPushMatrix()
        GL.glTranslatef(0.0, 0.26, 0.0)
        box(0.34, 0.08, 0.16)
        GL.glPopMatrix()

    @staticmethod
    def draw_finger() -> None:
        material(ALUMINIUM, 80.0)
        GL.glPushMatrix()
        GL.glTranslatef(0.0, 0.52, 0.0)
        box(0.04, 0.22, 0.12)
        GL.glPopMatrix()

    @staticmethod
    def draw_crate() -> None:
        material(WOOD, 5.0)
        box(0.26, 0.26, 0.26)

    @staticmethod
    def draw_floor() -> None:
        material(FLOOR, 2.0)
        GL.glBegin(GL.GL_QUADS)
        GL.glNormal3f(0.0, 1.0, 0.0)
        for i in range(-6, 6):
            for k in range(-6, 6):
                for x, z in ((i, k), (i, k + 1), (i + 1, k + 1), (i + 1, k)):
                    GL.glVertex3f(x, 0.0, z)
        GL.glEnd()

    def draw(self, t: float) -> None:
        """The cell at time t, in radians of the arm's cycle."""
        GL.glCallList(self.floor)
        for x, y, z in ((2.3, 0.26, -0.9), (2.35, 0.26, 0.2), (2.3, 0.78, -0.3), (-1.9, 0.26, 1.4)):
            GL.glPushMatrix()
            GL.glTranslatef(x, y, z)
            GL.glRotatef(17.0 * z, 0.0, 1.0, 0.0)
            GL.glCallList(self.crate)
            GL.glPopMatrix()
        GL.glPushMatrix()
        GL.glRotatef(55.0 * math.sin(t), 0.0, 1.0, 0.0)
        GL.glCallList(self.foot)
        GL.glTranslatef(0.0, 0.8, 0.0)
        GL.glRotatef(-20.0 + 14.0 * math.cos(2 * t), 0.0, 0.0, 1.0)
        GL.glCallList(self.upper)
        GL.glTranslatef(0.0, UPPER, 0.0)
        GL.glRotatef(-78.0 + 18.0 * math.sin(2 * t), 0.0, 0.0, 1.0)
        GL.glCallList(self.fore)
        GL.glTranslatef(0.0, FORE, 0.0)
        GL.glRotatef(-70.0, 0.0, 0.0, 1.0)
        GL.glCallList(self.hand)
        grip = 0.14 + 0.12 * math.sin(t) ** 2
        for side in (-grip, grip):
            GL.glPushMatrix()
            GL.glTranslatef(side, 0.0, 0.0)
            GL.glCallList(self.finger)
            GL.glPopMatrix()
        GL.glPopMatrix()


def set_up() -> None:
    GL.glClearColor(0.86, 0.90, 0.93, 1.0)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glEnable(GL.GL_CULL_FACE)
    GL.glEnable(GL.GL_NORMALIZE)
    GL.glEnable(GL.GL_LIGHTING)
    GL.glEnable(GL.GL_LIGHT0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.85, 0.85, 0.82, 1.0))
    GL.glMatrixMode(GL.GL_PROJECTION)
    GLU.gluPerspective(38.0, SIZE[0] / SIZE[1], 0.5, 60.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)


def handle(event: pygame.event.Event, view: View) -> bool:
    """Whether the program goes on."""
    if event.type == pygame.QUIT:
        return False
    if event.type == pygame.KEYDOWN:
        if event.key == pygame.K_ESCAPE:
            return False
        if event.key == pygame.K_SPACE:
            view.moving = not view.moving
        view.azimuth += 5.0 * ((event.key == pygame.K_RIGHT) - (event.key == pygame.K_LEFT))
        view.elevation += 5.0 * ((event.key == pygame.K_UP) - (event.key == pygame.K_DOWN))
        if event.unicode in ("+", "="):
            view.distance *= 0.9
        elif event.unicode == "-":
            view.distance /= 0.9
    return True


def main() -> None:
    pygame.display.init()
    pygame.display.set_mode(SIZE, pygame.OPENGL | pygame.DOUBLEBUF)
    pygame.display.set_caption("Robot arm")
    set_up()
    robot, view, clock = Robot(), View(), pygame.time.Clock()
    while all([handle(event, view) for event in pygame.event.get()]):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glLoadIdentity()
        GL.glTranslatef(0.0, -1.2, -view.distance)
        GL.glRotatef(view.elevation, 1.0, 0.0, 0.0)
        GL.glRotatef(view.azimuth, 0.0, 1.0, 0.0)
        GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (4.0, 8.0, 6.0, 0.0))
        robot.draw(0.6 + view.frame * 0.02)
        pygame.display.flip()
        view.frame += view.moving
        clock.tick(60)
    pygame.quit()


if __name__ == "__main__":
    main()
