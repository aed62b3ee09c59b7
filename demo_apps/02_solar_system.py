"""The solar system, not to scale: GLUT, textured GLU quadrics, labels, a light in the sun.

The planets' maps are noise laid out in bands, with mipmaps by GLU; Saturn's rings are blended. Each
year has its true length against the others'. Drag to orbit, wheel or +/- to zoom, l turns the
labels on and off, up and down change the speed, space stops time, ESC leaves.
"""

import math
import sys
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from OpenGL import GL, GLU, GLUT

SIZE = (640, 480)
SPEED = 0.05  # years of the Earth in a second
MAP = (128, 256)  # rows and columns of a planet's map
Floats = NDArray[np.float64]
Colour = tuple[float, float, float]


@dataclass(frozen=True)
class Planet:
    """Radius and orbit are for the eye; `year` is in years, `day` and `tilt` in days and degrees.

    `colours` are the bands of its map, from the poles to the equator.
    """

    name: str
    radius: float
    orbit: float
    year: float
    day: float
    tilt: float
    start: float  # degrees along its orbit
    colours: tuple[Colour, ...]
    rough: float  # how much noise mixes the bands
    moons: tuple[tuple[float, float, float], ...] = ()  # radius, distance, months


GREY, OCHRE = (0.62, 0.58, 0.54), (0.86, 0.70, 0.44)
PLANETS = (
    Planet("Mercury", 0.19, 1.55, 0.241, 58.6, 0.0, 200.0,
           (GREY, (0.46, 0.42, 0.40), (0.72, 0.68, 0.62)), 1.6),
    Planet("Venus", 0.32, 2.2, 0.615, -243.0, 3.0, 140.0,
           ((0.94, 0.88, 0.72), (0.90, 0.76, 0.50), (0.97, 0.86, 0.62)), 0.5),
    Planet("Earth", 0.36, 3.0, 1.0, 1.0, 23.4, 305.0,
           ((0.96, 0.97, 0.98), (0.20, 0.50, 0.26), (0.14, 0.36, 0.66), (0.16, 0.40, 0.72),
            (0.62, 0.58, 0.32), (0.14, 0.38, 0.70)), 2.2, ((0.10, 0.60, 1.0),)),
    Planet("Mars", 0.27, 3.8, 1.88, 1.03, 25.2, 20.0,
           ((0.95, 0.92, 0.90), (0.76, 0.38, 0.22), (0.60, 0.28, 0.18), (0.84, 0.50, 0.30)), 1.8),
    Planet("Jupiter", 0.8, 5.6, 11.86, 0.41, 3.1, 322.0,
           ((0.62, 0.54, 0.50), (0.86, 0.76, 0.62), (0.70, 0.46, 0.32), (0.94, 0.88, 0.78),
            (0.80, 0.58, 0.40), (0.96, 0.92, 0.84), (0.66, 0.42, 0.30)), 0.35,
           ((0.07, 0.98, 0.15), (0.09, 1.2, 0.4))),
    Planet("Saturn", 0.62, 7.3, 29.46, 0.45, 26.7, 236.0,
           ((0.66, 0.60, 0.48), OCHRE, (0.93, 0.84, 0.64), (0.82, 0.68, 0.46), (0.95, 0.88, 0.70)),
           0.2, ((0.08, 1.75, 0.5),)),
    Planet("Uranus", 0.5, 8.9, 84.0, -0.72, 97.8, 70.0,
           ((0.74, 0.90, 0.92), (0.58, 0.82, 0.88)), 0.1),
    Planet("Neptune", 0.48, 9.9, 164.8, 0.67, 28.3, 125.0,
           ((0.22, 0.36, 0.72), (0.30, 0.50, 0.88), (0.20, 0.34, 0.76)), 0.4),
)  # fmt: skip
SUN_COLOURS = ((1.0, 0.72, 0.20), (1.0, 0.86, 0.36), (1.0, 0.94, 0.60))


def noise(seed: int, shape: tuple[int, int] = MAP) -> Floats:
    """Smooth noise of several octaves on a map that closes around its columns, about 0."""
    generator = np.random.default_rng(seed)
    rows, columns = shape
    total = np.zeros(shape)
    for octave in range(2, 7):
        down, across = 2**octave, 2 ** (octave + 1)
        grid = generator.normal(size=(down + 1, across))
        y, x = np.linspace(0, down, rows, endpoint=False), np.linspace(0, across, columns + 1)[:-1]
        i, k = y.astype(int), x.astype(int)
        v, u = (3 * t**2 - 2 * t**3 for t in ((y - i)[:, None], x - k))
        after = (k + 1) % across
        top = grid[i][:, k] * (1 - u) + grid[i][:, after] * u
        low = grid[i + 1][:, k] * (1 - u) + grid[i + 1][:, after] * u
        total += (top * (1 - v) + low * v) / 2**octave
    return total * 2


def planet_map(colours: tuple[Colour, ...], rough: float, seed: int) -> NDArray[np.uint8]:
    """Bands from pole to pole, moved about by noise, (rows, columns, 3)."""
    bands = np.array([*colours, *colours[-2::-1]])
    rows, _ = MAP
    height = np.linspace(0, len(bands) - 1, rows)[:, None]
    place = np.clip(height + rough * noise(seed) * 2, 0, len(bands) - 1)
    low = np.minimum(place.astype(int), len(bands) - 2)
    part = np.clip((place - low - 0.5) * 3 + 0.5, 0, 1)[..., None]  # bands with soft borders
    picture = bands[low] * (1 - part) + bands[low + 1] * part
    return (np.clip(picture + 0.05 * noise(seed + 50)[..., None], 0, 1) * 255).astype(np.uint8)


def texture(picture: NDArray[np.uint8]) -> int:
    """A texture with mipmaps of an RGB or RGBA picture."""
    rows, columns, channels = picture.shape
    kind = GL.GL_RGBA if channels == 4 else GL.GL_RGB
    name = GL.glGenTextures(1)
    GL.glBindTexture(GL.GL_TEXTURE_2D, name)
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_LINEAR_MIPMAP_LINEAR)
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MAG_FILTER, GL.GL_LINEAR)
    GLU.gluBuild2DMipmaps(GL.GL_TEXTURE_2D, channels, columns, rows, kind, GL.GL_UNSIGNED_BYTE,
                          picture)  # fmt: skip
    return int(name)


def ring_map() -> NDArray[np.uint8]:
    """Saturn's rings from the inside to the outside, (4, 256, 4), with Cassini's division."""
    along = np.linspace(0, 1, 256)
    dense = 0.55 + 0.4 * np.sin(9 * along) * np.sin(31 * along + 1) + 0.1 * np.sin(140 * along)
    dense *= np.clip(along * 8, 0, 1) * np.clip((1 - along) * 20, 0, 1)
    dense[(along > 0.66) & (along < 0.73)] = 0.04
    row = np.concatenate([np.tile((0.90, 0.80, 0.62), (256, 1)) * (0.75 + 0.25 * dense[:, None]),
                          np.clip(dense, 0, 0.95)[:, None]], axis=1)  # fmt: skip
    return (np.tile(row, (4, 1, 1)) * 255).astype(np.uint8)


class System:
    """Textures, one quadric, and where everything is at a time."""

    def __init__(self) -> None:
        self.sun = texture(planet_map(SUN_COLOURS, 2.5, 1))
        self.moon = texture(planet_map((GREY, (0.78, 0.76, 0.72)), 2.0, 2))
        self.maps = [texture(planet_map(p.colours, p.rough, 10 + k))
                     for k, p in enumerate(PLANETS)]  # fmt: skip
        self.rings = texture(ring_map())
        self.quadric = GLU.gluNewQuadric()
        GLU.gluQuadricTexture(self.quadric, GL.GL_TRUE)
        generator = np.random.default_rng(7)
        stars = generator.normal(size=(1400, 3))
        self.stars = 50 * stars / np.linalg.norm(stars, axis=1, keepdims=True)
        self.bright = generator.uniform(0.35, 1.0, 1400)
        self.rocks = [(generator.normal(4.55, 0.1), generator.uniform(0, 360),
                       generator.normal(0, 0.07), generator.uniform(0.025, 0.06))
                      for _ in range(110)]  # fmt: skip

    def ball(self, radius: float, picture: int, slices: int = 36) -> None:
        GL.glBindTexture(GL.GL_TEXTURE_2D, picture)
        GLU.gluSphere(self.quadric, radius, slices, slices * 2 // 3)

    def draw(self, years: float) -> None:
        GL.glEnable(GL.GL_TEXTURE_2D)
        GL.glDisable(GL.GL_LIGHTING)
        GL.glColor3f(1.0, 1.0, 1.0)
        self.ball(0.95, self.sun, 48)
        GL.glEnable(GL.GL_LIGHTING)
        for planet, picture in zip(PLANETS, self.maps, strict=True):
            GL.glPushMatrix()
            GL.glTranslatef(*place(planet, years))
            for radius, distance, months in planet.moons:
                GL.glPushMatrix()
                GL.glRotatef(360 * 12 * years / months * 0.3, 0.0, 0.0, 1.0)
                GL.glTranslatef(distance, 0.0, 0.0)
                self.ball(radius, self.moon, 16)
                GL.glPopMatrix()
            GL.glRotatef(planet.tilt, 1.0, 0.0, 0.0)
            GL.glPushMatrix()
            GL.glRotatef(years * 600.0 / planet.day % 360.0, 0.0, 0.0, 1.0)
            self.ball(planet.radius, picture)
            GL.glPopMatrix()
            GL.glPopMatrix()
        GL.glDisable(GL.GL_TEXTURE_2D)
        self.draw_belt(years)
        saturn = PLANETS[5]
        GL.glPushMatrix()
        GL.glTranslatef(*place(saturn, years))
        GL.glRotatef(saturn.tilt, 1.0, 0.0, 0.0)
        self.draw_rings(1.3 * saturn.radius, 2.35 * saturn.radius)
        GL.glPopMatrix()

    def draw_belt(self, years: float) -> None:
        """Rocks between Mars and Jupiter."""
        GL.glColor3f(0.66, 0.60, 0.54)
        for orbit, start, height, size in self.rocks:
            GL.glPushMatrix()
            GL.glRotatef(start + 360 * years / orbit**1.5 * 2, 0.0, 0.0, 1.0)
            GL.glTranslatef(orbit, 0.0, height)
            GL.glRotatef(start * 7, 1.0, 1.0, 0.0)
            GL.glScalef(size, size * 0.8, size)
            GLUT.glutSolidIcosahedron()
            GL.glPopMatrix()

    def draw_rings(self, inner: float, outer: float, steps: int = 96) -> None:
        """One sheet, seen from both sides, blended over what is behind it."""
        for switch in (GL.GL_TEXTURE_2D, GL.GL_BLEND):
            GL.glEnable(switch)
        for switch in (GL.GL_LIGHTING, GL.GL_CULL_FACE):
            GL.glDisable(switch)
        GL.glBindTexture(GL.GL_TEXTURE_2D, self.rings)
        GL.glColor4f(1.0, 1.0, 1.0, 1.0)
        GL.glBegin(GL.GL_QUAD_STRIP)
        GL.glNormal3f(0.0, 0.0, 1.0)
        for k in range(steps + 1):
            a = 2 * math.pi * (k % steps) / steps
            for radius, along in ((outer, 1.0), (inner, 0.0)):
                GL.glTexCoord2f(along, 0.5)
                GL.glVertex3f(radius * math.cos(a), radius * math.sin(a), 0.0)
        GL.glEnd()
        for switch in (GL.GL_TEXTURE_2D, GL.GL_BLEND):
            GL.glDisable(switch)
        GL.glEnable(GL.GL_CULL_FACE)

    def draw_lines(self) -> None:
        """Stars and orbits, unlit."""
        GL.glDisable(GL.GL_LIGHTING)
        GL.glPointSize(1.5)
        GL.glBegin(GL.GL_POINTS)
        for star, bright in zip(self.stars, self.bright, strict=True):
            GL.glColor3f(bright, bright, bright)
            GL.glVertex3fv(star)
        GL.glEnd()
        GL.glColor3f(0.36, 0.44, 0.60)
        for planet in PLANETS:
            GL.glBegin(GL.GL_LINE_LOOP)
            for k in range(180):
                a = 2 * math.pi * k / 180
                GL.glVertex3f(planet.orbit * math.cos(a), planet.orbit * math.sin(a), 0.0)
            GL.glEnd()


def place(planet: Planet, years: float) -> tuple[float, float, float]:
    a = math.radians(planet.start) + 2 * math.pi * years / planet.year
    return planet.orbit * math.cos(a), planet.orbit * math.sin(a), 0.0


@dataclass
class View:
    azimuth: float = 0.0
    elevation: float = 33.0
    distance: float = 17.5
    size: tuple[int, int] = SIZE
    years: float = 0.0
    speed: float = 1.0
    moving: bool = True
    labels: bool = True
    grip: tuple[int, int] | None = None
    seen: float = 0.0  # the time of the last picture, seconds


view = View()


def write(text: str, font: object = GLUT.GLUT_BITMAP_HELVETICA_12) -> None:
    for letter in text:
        GLUT.glutBitmapCharacter(font, ord(letter))


def draw_labels() -> None:
    """Each planet's name above it, and the year in a corner."""
    matrices = [GL.glGetDoublev(m) for m in (GL.GL_MODELVIEW_MATRIX, GL.GL_PROJECTION_MATRIX)]
    port = GL.glGetIntegerv(GL.GL_VIEWPORT)
    spots = []
    for planet in PLANETS:
        x, y, z = place(planet, view.years)
        above = GLU.gluProject(x, y, z + planet.radius * 1.25 + 0.08, *matrices, port)
        spots.append((above[0], above[1], planet.name))
    GL.glDisable(GL.GL_DEPTH_TEST)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GL.glOrtho(0, view.size[0], 0, view.size[1], -1, 1)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glColor3f(0.92, 0.94, 1.0)
    for x, y, name in spots:
        GL.glRasterPos2f(max(x - 3.0 * len(name), 0.0), max(y, 0.0))
        write(name)
    GL.glColor3f(0.70, 0.78, 0.92)
    GL.glRasterPos2f(12, 14)
    write(f"year {view.years:.2f}   speed x{view.speed:.2g}   l labels", GLUT.GLUT_BITMAP_8_BY_13)
    GL.glEnable(GL.GL_DEPTH_TEST)


def display(system: System) -> None:
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(42.0, view.size[0] / view.size[1], 1.0, 120.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.0, -view.distance)
    GL.glRotatef(view.elevation - 90.0, 1.0, 0.0, 0.0)
    GL.glRotatef(view.azimuth, 0.0, 0.0, 1.0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (0.0, 0.0, 0.0, 1.0))
    system.draw_lines()
    system.draw(view.years)
    if view.labels:
        draw_labels()
    GLUT.glutSwapBuffers()


def advance(_value: int) -> None:
    now = GLUT.glutGet(GLUT.GLUT_ELAPSED_TIME) / 1000
    view.years += view.moving * view.speed * SPEED * (now - view.seen)
    view.seen = now
    GLUT.glutPostRedisplay()
    GLUT.glutTimerFunc(16, advance, 0)


def reshape(width: int, height: int) -> None:
    view.size = (width, max(height, 1))
    GL.glViewport(0, 0, *view.size)


def zoom(factor: float) -> None:
    view.distance = min(max(view.distance * factor, 4.0), 40.0)


def keyboard(key: bytes, _x: int, _y: int) -> None:
    if key == b"\x1b":
        GLUT.glutLeaveMainLoop()
    elif key == b" ":
        view.moving = not view.moving
    elif key == b"l":
        view.labels = not view.labels
    elif key in b"+=-":
        zoom(1 / 0.9 if key == b"-" else 0.9)


def arrows(key: int, _x: int, _y: int) -> None:
    if key in (GLUT.GLUT_KEY_UP, GLUT.GLUT_KEY_DOWN):
        view.speed *= 1.25 if key == GLUT.GLUT_KEY_UP else 0.8


def mouse(button: int, state: int, x: int, y: int) -> None:
    if button == GLUT.GLUT_LEFT_BUTTON:
        view.grip = (x, y) if state == GLUT.GLUT_DOWN else None
    elif button in (3, 4) and state == GLUT.GLUT_DOWN:  # the wheel
        zoom(0.9 if button == 3 else 1 / 0.9)


def motion(x: int, y: int) -> None:
    if view.grip is not None:
        view.azimuth += 0.4 * (x - view.grip[0])
        view.elevation = min(max(view.elevation + 0.4 * (y - view.grip[1]), -89.0), 89.0)
        view.grip = (x, y)


def set_up() -> None:
    GL.glClearColor(0.05, 0.07, 0.15, 1.0)
    for switch in (GL.GL_DEPTH_TEST, GL.GL_CULL_FACE, GL.GL_NORMALIZE, GL.GL_LIGHT0,
                   GL.GL_LIGHT1, GL.GL_COLOR_MATERIAL):  # fmt: skip
        GL.glEnable(switch)
    GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (1.0, 0.98, 0.92, 1.0))
    GL.glLightfv(GL.GL_LIGHT1, GL.GL_POSITION, (0.0, 0.3, 1.0, 0.0))  # where the eye is
    GL.glLightfv(GL.GL_LIGHT1, GL.GL_DIFFUSE, (0.34, 0.35, 0.40, 1.0))
    GL.glLightModelfv(GL.GL_LIGHT_MODEL_AMBIENT, (0.20, 0.20, 0.24, 1.0))


def main() -> None:
    GLUT.glutInit(sys.argv)
    GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE | GLUT.GLUT_RGB | GLUT.GLUT_DEPTH)
    GLUT.glutInitWindowSize(*SIZE)
    GLUT.glutCreateWindow(b"Solar system")
    set_up()
    system = System()
    GLUT.glutDisplayFunc(lambda: display(system))
    GLUT.glutReshapeFunc(reshape)
    GLUT.glutKeyboardFunc(keyboard)
    GLUT.glutSpecialFunc(arrows)
    GLUT.glutMouseFunc(mouse)
    GLUT.glutMotionFunc(motion)
    GLUT.glutTimerFunc(16, advance, 0)
    GLUT.glutMainLoop()


if __name__ == "__main__":
    main()
