"""A walk through a level: pygame, multitexture, a light map over tiling textures.

The level, painted and lit in `level.py`, has brick, tiles, planks and crates that tile by place; a
second texture unit multiplies them by light that was traced from the lamps, with its shadows. The
walk follows a course until an arrow key takes over (up and down go, left and right turn); space
goes back to the course, l shows the light alone, ESC leaves.
"""

import math
from dataclasses import dataclass, field

import numpy as np
import pygame
from numpy.typing import NDArray
from OpenGL import GL, GLU

try:
    from .level import FINE, LEVEL, TEXTURES, WATER, Level
except ImportError:  # started as a file: its folder is on the path
    from level import FINE, LEVEL, TEXTURES, WATER, Level

SIZE = (640, 480)
COURSE = ((7.6, 7.5), (4.8, 6.9), (3.2, 5.2), (3.1, 3.1), (4.8, 1.9), (6.5, 3.0), (7.2, 4.3),
          (9.5, 4.5), (12.0, 4.4), (15.3, 4.9), (14.4, 6.8), (13.5, 8.0), (13.4, 8.9),
          (12.6, 10.1), (9.0, 10.3), (5.5, 10.6), (2.9, 10.9), (2.3, 9.9), (5.4, 9.7), (7.8, 9.8),
          (8.5, 8.6))
PACE = 1.5  # metres a second
Floats = NDArray[np.float64]
Picture = NDArray[np.uint8]


def texture(picture: Picture, repeats: bool = True) -> int:
    """A texture, with mipmaps if it tiles."""
    rows, columns, _ = picture.shape
    name = GL.glGenTextures(1)
    GL.glBindTexture(GL.GL_TEXTURE_2D, name)
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
    wrap = GL.GL_REPEAT if repeats else GL.GL_CLAMP_TO_EDGE
    least = GL.GL_LINEAR_MIPMAP_LINEAR if repeats else GL.GL_LINEAR
    for what, value in ((GL.GL_TEXTURE_WRAP_S, wrap), (GL.GL_TEXTURE_WRAP_T, wrap),
                        (GL.GL_TEXTURE_MIN_FILTER, least),
                        (GL.GL_TEXTURE_MAG_FILTER, GL.GL_LINEAR)):  # fmt: skip
        GL.glTexParameteri(GL.GL_TEXTURE_2D, what, value)
    arguments = (GL.GL_RGB, GL.GL_UNSIGNED_BYTE, picture)
    if repeats:
        GLU.gluBuild2DMipmaps(GL.GL_TEXTURE_2D, GL.GL_RGB, columns, rows, *arguments)
    else:
        GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGB, columns, rows, 0, *arguments)
    return int(name)


class Course:
    """A smooth closed way through the course's points, by metres."""

    def __init__(self) -> None:
        p = np.array(COURSE)
        a, b, c, d = (np.roll(p, k, axis=0)[:, None] for k in (1, 0, -1, -2))
        t = np.linspace(0.0, 1.0, 24, endpoint=False)[:, None]
        bend = (2 * a - 5 * b + 4 * c - d) * t**2 + (3 * b - a - 3 * c + d) * t**3
        points = ((2 * b + (c - a) * t + bend) / 2).reshape(-1, 2)
        self.points = np.concatenate([points, points[:1]])
        steps = np.linalg.norm(np.diff(self.points, axis=0), axis=1)
        self.way = np.concatenate([[0.0], np.cumsum(steps)])

    def at(self, metres: float) -> Floats:
        here = metres % self.way[-1]
        return np.array([np.interp(here, self.way, self.points[:, k]) for k in (0, 1)])


@dataclass
class Walker:
    """Place on the ground, heading in degrees (0 looks along -z) and height of the eye."""

    level: Level
    course: Course = field(default_factory=Course)
    place: Floats = field(default_factory=lambda: np.zeros(2))
    heading: float = 0.0
    eye: float = 1.6
    walked: float = 0.0
    guided: bool = True

    def ground(self, place: Floats) -> float:
        x, z = (place * FINE).astype(int)
        return float(self.level.low[z, x])

    def follow(self, seconds: float) -> None:
        self.walked += PACE * seconds
        self.place = self.course.at(self.walked)
        ahead = self.course.at(self.walked + 1.6) - self.place
        self.heading = math.degrees(math.atan2(ahead[0], -ahead[1]))

    def steer(self, keys: pygame.key.ScancodeWrapper, seconds: float) -> None:
        self.heading += 110.0 * seconds * (int(keys[pygame.K_RIGHT]) - int(keys[pygame.K_LEFT]))
        a = math.radians(self.heading)
        step = 2.2 * seconds * (int(keys[pygame.K_UP]) - int(keys[pygame.K_DOWN]))
        for move in ((step * math.sin(a), 0.0), (0.0, -step * math.cos(a))):  # slide along walls
            there = self.place + move
            touched = [self.ground(there + 0.28 * np.array(d))
                       for d in ((1, 0), (-1, 0), (0, 1), (0, -1))]  # fmt: skip
            if max(touched) - self.ground(self.place) < 0.6:
                self.place = there

    def look(self, seconds: float) -> None:
        wanted = self.ground(self.place) + 1.6
        self.eye += (wanted - self.eye) * min(6.0 * seconds, 1.0)
        GL.glRotatef(4.0, 1.0, 0.0, 0.0)
        GL.glRotatef(self.heading, 0.0, 1.0, 0.0)
        GL.glTranslatef(-self.place[0], -self.eye, -self.place[1])


class Scene:
    """The level as one display list for each texture, and the water over its pool."""

    def __init__(self, level: Level) -> None:
        self.light = texture(level.light(), repeats=False)
        self.paints = {name: texture(paint()) for name, paint in TEXTURES.items()}
        self.lists = {name: GL.glGenLists(1) for name in {p.paint for p in level.patches}}
        for name, number in self.lists.items():
            GL.glNewList(number, GL.GL_COMPILE)
            GL.glBegin(GL.GL_QUADS)
            for k, patch in enumerate(level.patches):
                if patch.paint == name:
                    GL.glNormal3fv(patch.normal)
                    for corner, place, lumel in zip(patch.corners, patch.places, level.lumels(k),
                                                    strict=True):  # fmt: skip
                        GL.glMultiTexCoord2f(GL.GL_TEXTURE0, *place)
                        GL.glMultiTexCoord2f(GL.GL_TEXTURE1, *lumel)
                        GL.glVertex3fv(corner)
            GL.glEnd()
            GL.glEndList()
        self.light_alone = False

    def draw(self, seconds: float) -> None:
        GL.glActiveTexture(GL.GL_TEXTURE1)
        GL.glEnable(GL.GL_TEXTURE_2D)
        GL.glBindTexture(GL.GL_TEXTURE_2D, self.light)
        GL.glActiveTexture(GL.GL_TEXTURE0)
        (GL.glDisable if self.light_alone else GL.glEnable)(GL.GL_TEXTURE_2D)
        GL.glColor3f(1.0, 1.0, 1.0)
        for name, number in self.lists.items():
            GL.glBindTexture(GL.GL_TEXTURE_2D, self.paints[name])
            GL.glCallList(number)
        GL.glActiveTexture(GL.GL_TEXTURE1)
        GL.glDisable(GL.GL_TEXTURE_2D)
        GL.glActiveTexture(GL.GL_TEXTURE0)
        GL.glEnable(GL.GL_TEXTURE_2D)
        self.draw_water(seconds)

    def draw_water(self, seconds: float) -> None:
        """Blended over the pool; its texture drifts."""
        GL.glEnable(GL.GL_BLEND)
        GL.glBindTexture(GL.GL_TEXTURE_2D, self.paints["ripples"])
        GL.glMatrixMode(GL.GL_TEXTURE)
        GL.glTranslatef(0.05 * seconds, 0.03 * seconds, 0.0)
        GL.glMatrixMode(GL.GL_MODELVIEW)
        GL.glColor4f(0.7, 0.9, 0.95, 0.55)
        GL.glBegin(GL.GL_QUADS)
        for z, row in enumerate(LEVEL):
            for x, letter in enumerate(row):
                if letter == "w":
                    for dx, dz in ((0, 0), (0, 1), (1, 1), (1, 0)):
                        GL.glTexCoord2f((x + dx) / 2, (z + dz) / 2)
                        GL.glVertex3f(x + dx, WATER, z + dz)
        GL.glEnd()
        GL.glMatrixMode(GL.GL_TEXTURE)
        GL.glLoadIdentity()
        GL.glMatrixMode(GL.GL_MODELVIEW)
        GL.glDisable(GL.GL_BLEND)


ARROWS = (pygame.K_UP, pygame.K_DOWN, pygame.K_LEFT, pygame.K_RIGHT)


def handle(event: pygame.event.Event, walker: Walker, scene: Scene) -> bool:
    """Whether the program goes on."""
    if event.type == pygame.QUIT:
        return False
    if event.type == pygame.KEYDOWN:
        if event.key == pygame.K_ESCAPE:
            return False
        scene.light_alone ^= event.key == pygame.K_l
        if event.key in ARROWS:
            walker.guided = False
        elif event.key == pygame.K_SPACE:
            walker.guided = True
    return True


def main() -> None:
    pygame.display.init()
    pygame.display.set_mode(SIZE, pygame.OPENGL | pygame.DOUBLEBUF)
    pygame.display.set_caption("Textured room")
    for switch in (GL.GL_DEPTH_TEST, GL.GL_CULL_FACE):
        GL.glEnable(switch)
    GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GLU.gluPerspective(64.0, SIZE[0] / SIZE[1], 0.08, 60.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    level = Level()
    scene, walker, clock = Scene(level), Walker(level), pygame.time.Clock()
    walker.follow(0.0)
    last = pygame.time.get_ticks()
    while all([handle(event, walker, scene) for event in pygame.event.get()]):
        now = pygame.time.get_ticks()
        seconds, last = min((now - last) / 1000, 0.1), now
        if walker.guided:
            walker.follow(seconds)
        else:
            walker.steer(pygame.key.get_pressed(), seconds)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glLoadIdentity()
        walker.look(seconds)
        scene.draw(now / 1000)
        pygame.display.flip()
        clock.tick(60)
    pygame.quit()


if __name__ == "__main__":
    main()
