"""A flight over hills and a lake: glfw, buffer objects, fog, a blended lake, trees from one list.

The land is a height field in vertex buffers, drawn by indices; pines stand where it is flat and
neither wet nor high. Space stops the flight, left and right look about, up and down fly higher and
lower, ESC leaves.
"""

import ctypes
import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import glfw
import numpy as np
from numpy.typing import NDArray
from OpenGL import GL, GLU
from OpenGL.arrays import vbo

SIZE = (640, 480)
CELLS = 88  # squares along one side
HALF = 24.0  # half the side
WATER = 0.0  # the height of the lake
TREES = 260
LAP = 70.0  # seconds once round
SKY, HAZE = (0.42, 0.62, 0.86), (0.80, 0.87, 0.92)
Floats = NDArray[np.float64]


def fractal(cells: int, seed: int) -> Floats:
    """Noise with the spectrum of hills, (cells + 1, cells + 1), of deviation 1."""
    generator = np.random.default_rng(seed)
    n = 2 * cells
    along = np.fft.fftfreq(n)[:, None]
    wave = np.hypot(along, along.T) * n
    spectrum = np.where(wave > 1.5, np.maximum(wave, 1.0) ** -2.3, 0.0)
    field = np.fft.ifft2(spectrum * np.fft.fft2(generator.normal(size=(n, n)))).real
    field = field[: cells + 1, : cells + 1]
    return np.asarray((field - field.mean()) / field.std())


class Land:
    """Heights on a square of ground, y up, and what is made of them."""

    def __init__(self) -> None:
        self.axis = np.linspace(-HALF, HALF, CELLS + 1)
        x, z = np.meshgrid(self.axis, self.axis)
        rim = np.hypot(x, z) / HALF
        lake = np.exp(-(((x - 2.0) / 6.8) ** 2) - ((z + 1.0) / 5.2) ** 2)
        height = 0.95 * fractal(CELLS, 22) + 1.1 - 4.0 * lake
        height += np.exp(-(((rim - 0.86) / 0.17) ** 2)) * (2.6 + 1.1 * fractal(CELLS, 5))
        self.height = np.where(height > WATER, height, WATER + 0.6 * (height - WATER))
        along, across = np.gradient(self.height, self.axis[1] - self.axis[0])
        normals = np.stack([-across, np.ones_like(across), -along], axis=2)
        self.normals = normals / np.linalg.norm(normals, axis=2, keepdims=True)
        self.points = np.stack([x, self.height, z], axis=2)

    def at(self, x: float, z: float) -> float:
        """The height between the grid's points."""
        i, k = (min(max((v + HALF) / (2 * HALF) * CELLS, 0.0), CELLS - 1e-6) for v in (z, x))
        (a, u), (b, v) = ((int(i), i % 1.0), (int(k), k % 1.0))
        h = self.height[a : a + 2, b : b + 2]
        return float((h[0] * (1 - u) + h[1] * u) @ (1 - v, v))

    def colours(self) -> Floats:
        """Sand, meadow, forest floor, rock on slopes, snow, each a little mottled, (n, n, 3)."""
        bands = np.array([(0.40, 0.42, 0.34), (0.84, 0.77, 0.56), (0.52, 0.66, 0.32),
                          (0.40, 0.56, 0.28), (0.56, 0.58, 0.40), (0.95, 0.96, 0.98)])  # fmt: skip
        levels = np.array([-1.5, 0.10, 0.55, 1.5, 3.0, 4.4])
        found = np.stack([np.interp(self.height, levels, bands[:, c]) for c in range(3)], axis=2)
        steep = np.clip((0.80 - self.normals[..., 1]) * 8, 0, 1)[..., None]
        found = found * (1 - steep) + np.array((0.52, 0.48, 0.44)) * steep
        mottle = np.random.default_rng(3).uniform(0.93, 1.05, self.height.shape)
        return np.clip(found * mottle[..., None], 0, 1)

    def clearings(self) -> list[tuple[float, float, float, float]]:
        """Where trees stand: x, y, z and size; they keep together."""
        generator = np.random.default_rng(11)
        wood = fractal(CELLS, 31)
        found: list[tuple[float, float, float, float]] = []
        while len(found) < TREES:
            x, z = generator.uniform(-0.94 * HALF, 0.94 * HALF, 2)
            y = self.at(x, z)
            i, k = (round((v + HALF) / (2 * HALF) * CELLS) for v in (z, x))
            fits = 0.35 < y < 3.0 and self.normals[i, k, 1] > 0.80 and wood[i, k] > -0.1
            if fits and all(math.hypot(x - a, z - b) > 0.55 for a, _, b, _ in found):
                found.append((x, y - 0.06, z, generator.uniform(0.75, 1.35)))
        return found

    def shores(self, bearings: tuple[float, ...]) -> list[tuple[float, float, float, float]]:
        """Places a little above the lake, seen from its middle: x, y, z and the way to face."""
        found = []
        for bearing in bearings:
            c, s = math.cos(math.radians(bearing)), math.sin(math.radians(bearing))
            far = next(r for r in np.arange(3.0, HALF, 0.1)
                       if self.at(2 + r * c, -1 + r * s) > WATER + 0.35)  # fmt: skip
            x, z = 2 + far * c, -1 + far * s
            found.append((x, self.at(x, z) + 0.12, z, -90.0 - bearing))
        return found


def quads() -> NDArray[np.uint32]:
    """Indices of the grid's squares, anticlockwise from above."""
    corner = (np.arange(CELLS)[:, None] * (CELLS + 1) + np.arange(CELLS)).ravel()
    ring = [corner, corner + CELLS + 1, corner + CELLS + 2, corner + 1]
    return np.stack(ring, axis=1).astype(np.uint32)


class Ground:
    """The land in buffers: position, normal and colour side by side, and the squares' indices."""

    def __init__(self, land: Land) -> None:
        table = np.concatenate([land.points, land.normals, land.colours()], axis=2)
        self.vertices = vbo.VBO(table.astype(np.float32))
        indices = quads()
        self.count = indices.size
        self.indices = vbo.VBO(indices, target=GL.GL_ELEMENT_ARRAY_BUFFER)

    def draw(self) -> None:
        arrays = (GL.GL_VERTEX_ARRAY, GL.GL_NORMAL_ARRAY, GL.GL_COLOR_ARRAY)
        with self.vertices, self.indices:
            for array in arrays:
                GL.glEnableClientState(array)
            GL.glVertexPointer(3, GL.GL_FLOAT, 36, ctypes.c_void_p(0))
            GL.glNormalPointer(GL.GL_FLOAT, 36, ctypes.c_void_p(12))
            GL.glColorPointer(3, GL.GL_FLOAT, 36, ctypes.c_void_p(24))
            GL.glDrawElements(GL.GL_QUADS, self.count, GL.GL_UNSIGNED_INT, ctypes.c_void_p(0))
            for array in arrays:
                GL.glDisableClientState(array)


def cone(radius: float, low: float, high: float, colour: tuple[float, float, float],
         sides: int = 10) -> None:
    """A cone with a bottom, along y."""
    GL.glColor3fv(colour)
    turns = [2 * math.pi * k / sides for k in range(sides)]
    ring = [(radius * math.cos(a), -radius * math.sin(a)) for a in turns]
    up = radius / (high - low)
    GL.glBegin(GL.GL_TRIANGLES)
    for k, (x, z) in enumerate(ring):
        other = ring[(k + 1) % sides]
        GL.glNormal3f(x / radius, up, z / radius)
        GL.glVertex3f(x, low, z)
        GL.glNormal3f(other[0] / radius, up, other[1] / radius)
        GL.glVertex3f(other[0], low, other[1])
        GL.glNormal3f((x + other[0]) / 2 / radius, up, (z + other[1]) / 2 / radius)
        GL.glVertex3f(0.0, high, 0.0)
    GL.glEnd()
    GL.glBegin(GL.GL_POLYGON)
    GL.glNormal3f(0.0, -1.0, 0.0)
    for x, z in reversed(ring):
        GL.glVertex3f(x, low, z)
    GL.glEnd()


def draw_pine() -> None:
    """A trunk and three cones, one unit tall."""
    cone(0.05, -0.1, 0.5, (0.42, 0.30, 0.20), 6)
    for radius, low, high, green in ((0.30, 0.16, 0.62, 0.36), (0.24, 0.38, 0.82, 0.41),
                                     (0.17, 0.62, 1.05, 0.46)):  # fmt: skip
        cone(radius, low, high, (0.14, green, 0.20))


def draw_hut() -> None:
    """A hut with a gable roof and a chimney, by the lake."""

    def face(colour: tuple[float, float, float], *corners: tuple[float, float, float]) -> None:
        a, b, c = np.array(corners[:3])
        normal = np.cross(b - a, c - a)
        GL.glColor3fv(colour)
        GL.glBegin(GL.GL_POLYGON)
        GL.glNormal3fv(normal / np.linalg.norm(normal))
        for corner in corners:
            GL.glVertex3fv(corner)
        GL.glEnd()

    def walls(x: float, z: float, height: tuple[float, float],
              colour: tuple[float, float, float], aside: float = 0.0) -> None:
        low, high = height
        ring = [(aside - x, z), (aside + x, z), (aside + x, -z), (aside - x, -z)]
        for (ax, az), (bx, bz) in zip(ring, ring[1:] + ring[:1], strict=True):
            face(colour, (ax, low, az), (bx, low, bz), (bx, high, bz), (ax, high, az))

    wood, tile, dark = (0.72, 0.50, 0.32), (0.66, 0.22, 0.16), (0.28, 0.18, 0.12)
    walls(0.6, 0.4, (-0.5, 0.5), wood)
    for side in (1, -1):
        face(wood, (side * 0.6, 0.5, side * 0.4), (side * 0.6, 0.5, -side * 0.4),
             (side * 0.6, 0.86, 0.0))  # fmt: skip
        face(tile, (-side * 0.7, 0.44, side * 0.46), (side * 0.7, 0.44, side * 0.46),
             (side * 0.7, 0.90, 0.0), (-side * 0.7, 0.90, 0.0))  # fmt: skip
        face(dark, (side * 0.7, 0.44, side * 0.46), (-side * 0.7, 0.44, side * 0.46),
             (-side * 0.7, 0.84, 0.0), (side * 0.7, 0.84, 0.0))  # fmt: skip
    face(dark, (-0.12, -0.1, 0.41), (0.12, -0.1, 0.41), (0.12, 0.32, 0.41), (-0.12, 0.32, 0.41))
    walls(0.09, 0.09, (0.55, 1.12), (0.55, 0.52, 0.50), 0.35)
    face((0.2, 0.2, 0.2), (0.26, 1.12, 0.09), (0.44, 1.12, 0.09), (0.44, 1.12, -0.09),
         (0.26, 1.12, -0.09))  # fmt: skip


def compiled(draw: Callable[[], None]) -> int:
    """A display list of what `draw` draws."""
    name = GL.glGenLists(1)
    GL.glNewList(name, GL.GL_COMPILE)
    draw()
    GL.glEndList()
    return int(name)


@dataclass
class Flight:
    """Where the eye is on its closed course."""

    land: Land
    time: float = 0.0
    turn: float = 0.0  # looked aside, degrees
    higher: float = 0.0
    moving: bool = True
    aspect: float = SIZE[0] / SIZE[1]

    def course(self, time: float) -> tuple[float, float]:
        a = 2 * math.pi * time / LAP + 6.75
        radius = 13.0 + 2.2 * math.sin(3 * a)
        return 1.0 + radius * math.cos(a), radius * math.sin(a)

    def level(self, time: float) -> float:
        """Above the land now, before and soon: a smooth flight over rough land."""
        ground = [max(self.land.at(*self.course(time + dt)), WATER) for dt in np.arange(-3, 5.5)]
        return 1.9 + 0.6 * max(ground) + 0.4 * sum(ground) / len(ground)

    def look(self) -> None:
        x, z = self.course(self.time)
        ahead = self.course(self.time + 5.0)
        y = self.level(self.time) + self.higher
        # Towards the course ahead and a little to the lake in the middle.
        dx, dz = 0.62 * (ahead[0] - x) + 0.25 * (2 - x), 0.62 * (ahead[1] - z) + 0.25 * (-1 - z)
        a = math.radians(self.turn)
        dx, dz = dx * math.cos(a) - dz * math.sin(a), dx * math.sin(a) + dz * math.cos(a)
        far = math.hypot(dx, dz)
        bank = 0.06
        side = (-dz / far * bank, 1.0, dx / far * bank)
        GLU.gluLookAt(x, y, z, x + dx, y - 0.20 * far, z + dz, *side)


def draw_sky() -> None:
    """Haze below, blue above."""
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    for switch in (GL.GL_DEPTH_TEST, GL.GL_LIGHTING, GL.GL_FOG):
        GL.glDisable(switch)
    GL.glBegin(GL.GL_QUAD_STRIP)
    for y, colour in ((-1.0, HAZE), (0.3, HAZE), (1.0, SKY)):
        GL.glColor3fv(colour)
        GL.glVertex2f(-1.0, y)
        GL.glVertex2f(1.0, y)
    GL.glEnd()
    for switch in (GL.GL_DEPTH_TEST, GL.GL_LIGHTING, GL.GL_FOG):
        GL.glEnable(switch)


def draw_lake(time: float) -> None:
    """A sheet of water that lets the bed shine through; its light moves with slow waves."""
    steps = 16
    axis = np.linspace(-0.72 * HALF, 0.72 * HALF, steps + 1)
    GL.glEnable(GL.GL_BLEND)
    GL.glColor4f(0.22, 0.46, 0.66, 0.72)
    GL.glBegin(GL.GL_QUADS)
    for x, far_x in pairwise(axis):
        for z, far_z in pairwise(axis):
            for px, pz in ((x, z), (x, far_z), (far_x, far_z), (far_x, z)):
                GL.glNormal3f(0.10 * math.sin(0.7 * px + time), 1.0,
                              0.10 * math.cos(0.9 * pz + 0.8 * time))  # fmt: skip
                GL.glVertex3f(px, WATER, pz)
    GL.glEnd()
    GL.glDisable(GL.GL_BLEND)


class Scene:
    def __init__(self) -> None:
        self.land = Land()
        self.ground = Ground(self.land)
        self.pine, self.hut = compiled(draw_pine), compiled(draw_hut)
        self.huts = self.land.shores((20.0, 50.0, 130.0, 155.0, 270.0))
        self.trees = [tree for tree in self.land.clearings()
                      if all(math.dist(tree[:3], hut[:3]) > 1.2 for hut in self.huts)]

    def draw(self, flight: Flight) -> None:
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        draw_sky()
        GL.glMatrixMode(GL.GL_PROJECTION)
        GL.glLoadIdentity()
        GLU.gluPerspective(52.0, flight.aspect, 0.4, 90.0)
        GL.glMatrixMode(GL.GL_MODELVIEW)
        GL.glLoadIdentity()
        flight.look()
        GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (0.6, 0.8, 0.35, 0.0))
        self.ground.draw()
        for k, (x, y, z, size) in enumerate(self.trees):
            GL.glPushMatrix()
            GL.glTranslatef(x, y, z)
            GL.glRotatef(77.0 * k, 0.0, 1.0, 0.0)
            GL.glScalef(size, 1.3 * size, size)
            GL.glCallList(self.pine)
            GL.glPopMatrix()
        for x, y, z, turn in self.huts:
            GL.glPushMatrix()
            GL.glTranslatef(x, y, z)
            GL.glRotatef(turn, 0.0, 1.0, 0.0)
            GL.glCallList(self.hut)
            GL.glPopMatrix()
        draw_lake(flight.time)


def connect(window: object, flight: Flight) -> None:
    def key(_window: object, which: int, _scan: int, action: int, _mods: int) -> None:
        if action == glfw.RELEASE:
            return
        if which == glfw.KEY_ESCAPE:
            glfw.set_window_should_close(window, True)
        elif which == glfw.KEY_SPACE and action == glfw.PRESS:
            flight.moving = not flight.moving
        flight.turn += 4.0 * ((which == glfw.KEY_RIGHT) - (which == glfw.KEY_LEFT))
        rise = 0.25 * ((which == glfw.KEY_UP) - (which == glfw.KEY_DOWN))
        flight.higher = min(max(flight.higher + rise, -0.6), 6.0)

    glfw.set_key_callback(window, key)


def set_up() -> None:
    for switch in (GL.GL_CULL_FACE, GL.GL_NORMALIZE, GL.GL_LIGHT0, GL.GL_COLOR_MATERIAL):
        GL.glEnable(switch)
    GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.86, 0.82, 0.72, 1.0))
    GL.glLightModelfv(GL.GL_LIGHT_MODEL_AMBIENT, (0.34, 0.37, 0.42, 1.0))
    GL.glFogi(GL.GL_FOG_MODE, GL.GL_LINEAR)
    GL.glFogf(GL.GL_FOG_START, 14.0)
    GL.glFogf(GL.GL_FOG_END, 52.0)
    GL.glFogfv(GL.GL_FOG_COLOR, (*HAZE, 1.0))


def main() -> None:
    if not glfw.init():
        raise SystemExit("no display to open a window on")
    window = glfw.create_window(*SIZE, "Terrain", None, None)
    glfw.make_context_current(window)
    set_up()
    scene = Scene()
    flight = Flight(scene.land)
    connect(window, flight)
    last = glfw.get_time()
    while not glfw.window_should_close(window):
        now = glfw.get_time()
        flight.time += flight.moving * (now - last)
        last = now
        width, height = glfw.get_framebuffer_size(window)
        GL.glViewport(0, 0, width, height)
        flight.aspect = width / max(height, 1)
        scene.draw(flight)
        glfw.swap_buffers(window)
        glfw.poll_events()
    glfw.terminate()


if __name__ == "__main__":
    main()
