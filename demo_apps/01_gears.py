"""A planetary gear set at work: glfw, display lists, two lights, materials.

The sun turns three planets inside a ring that stands still, and they carry the output shaft round.
Teeth are involutes of 20 degrees, so they roll on each other without touching where they must not.
Drag to orbit, wheel or +/- to zoom, up and down for the speed, space stops the shaft, ESC leaves.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import glfw
import numpy as np
from numpy.typing import NDArray
from OpenGL import GL, GLU

SIZE = (640, 480)
MODULE = 0.1  # pitch diameter over number of teeth
SUN, PLANET, RING = 24, 18, 60  # teeth: RING = SUN + 2 PLANET, and SUN + RING divides by 3
PRESSURE = math.radians(20.0)
BACKLASH = 0.04  # of a tooth's thickness
THICK = 0.42  # width of the toothed rims
STEEL = (0.66, 0.70, 0.75, 1.0)
BRASS = (0.86, 0.66, 0.26, 1.0)
PAINT = (0.16, 0.38, 0.62, 1.0)
RED = (0.76, 0.22, 0.16, 1.0)
DARK = (0.30, 0.32, 0.36, 1.0)
Floats = NDArray[np.float64]


def involute(angle: float) -> float:
    return math.tan(angle) - angle


def gear_outline(teeth: int, above: float = 0.9, below: float = 1.15,
                 slack: float = BACKLASH) -> Floats:
    """The border of a spur gear, anticlockwise, (points, 2); a tooth points along x.

    `above` and `below` are its height and depth from the pitch circle, in modules; `slack` thins
    the teeth by that share. Each has the same number of points.
    """
    pitch = MODULE * teeth / 2
    base, tip, root = pitch * math.cos(PRESSURE), pitch + above * MODULE, pitch - below * MODULE
    middle = math.pi / 2 / teeth * (1 - slack)  # half of a tooth, on the pitch circle

    def half(radius: float) -> float:
        at = math.acos(min(base / radius, 1.0))
        return middle + involute(PRESSURE) - involute(at)

    flank = [(r, half(r)) for r in np.linspace(max(base, root), tip, 6)]
    if root < base:  # a radial foot below the base circle, a little rounded
        flank.insert(0, (root, half(base) + 0.12 * math.pi / teeth))
    side = [(r, -a) for r, a in flank] + [(r, a) for r, a in reversed(flank)]
    points = [(r, a + 2 * math.pi * k / teeth) for k in range(teeth) for r, a in side]
    return np.array([(r * math.cos(a), r * math.sin(a)) for r, a in points])


def circle(radius: float, like: Floats) -> Floats:
    """A circle with a point in the direction of each point of an outline."""
    return like / np.linalg.norm(like, axis=1, keepdims=True) * radius


def edge_normals(loop: Floats) -> tuple[Floats, Floats]:
    """Normals of a border, to its right, (n, 2) each: at the start and at the end of each edge.

    They are the means of two edges' normals unless the border turns by more than 25 degrees.
    """
    along = np.roll(loop, -1, axis=0) - loop
    own = np.stack([along[:, 1], -along[:, 0]], axis=1)
    own /= np.linalg.norm(own, axis=1, keepdims=True)

    def blended(other: Floats) -> Floats:
        mean = own + other
        mean /= np.maximum(np.linalg.norm(mean, axis=1, keepdims=True), 1e-9)
        near = (own * other).sum(axis=1) > math.cos(math.radians(25.0))
        return np.where(near[:, None], mean, own)

    return blended(np.roll(own, 1, axis=0)), blended(np.roll(own, -1, axis=0))


def wall(loop: Floats, low: float, high: float) -> None:
    """The sides of what stands on a border, from one height to another."""
    first, last = edge_normals(loop)
    ahead = np.roll(loop, -1, axis=0)
    GL.glBegin(GL.GL_QUADS)
    for (ax, ay), (bx, by), na, nb in zip(loop, ahead, first, last, strict=True):
        GL.glNormal3f(*na, 0.0)
        GL.glVertex3f(ax, ay, low)
        GL.glNormal3f(*nb, 0.0)
        GL.glVertex3f(bx, by, low)
        GL.glVertex3f(bx, by, high)
        GL.glNormal3f(*na, 0.0)
        GL.glVertex3f(ax, ay, high)
    GL.glEnd()


def annulus(inner: Floats, outer: Floats, z: float, up: float) -> None:
    """The flat face between two borders, seen from above (up = 1) or from below (up = -1)."""
    GL.glBegin(GL.GL_QUAD_STRIP)
    GL.glNormal3f(0.0, 0.0, up)
    for k in range(len(inner) + 1):
        pair = (inner[k % len(inner)], outer[k % len(outer)])
        for x, y in pair if up > 0 else pair[::-1]:
            GL.glVertex3f(x, y, z)
    GL.glEnd()


def turned(section: list[tuple[Floats, float]]) -> None:
    """A solid from borders and heights: its section, anticlockwise with the axis on the left."""
    for (a, low), (b, high) in zip(section, section[1:] + section[:1], strict=True):
        if a is b and low < high:
            wall(a, low, high)
        elif a is b:  # the inside of a hole or of a recess: seen from the axis
            wall(a[::-1], high, low)
        else:
            outward = np.linalg.norm(b[0]) > np.linalg.norm(a[0])
            annulus(*((a, b) if outward else (b, a)), low, -1.0 if outward else 1.0)


def draw_gear(teeth: int, bore: float) -> None:
    """A gear with a recessed web between its hub and its rim, around the z axis."""
    rim = gear_outline(teeth)
    root = MODULE * teeth / 2 - 1.15 * MODULE
    hole, hub, web = circle(bore, rim), circle(bore + 0.14, rim), circle(root - 0.14, rim)
    h, thin = THICK / 2, THICK / 5
    turned([(hole, -h - 0.06), (hub, -h - 0.06), (hub, -thin), (web, -thin), (web, -h), (rim, -h),
            (rim, h), (web, h), (web, thin), (hub, thin), (hub, h + 0.06),
            (hole, h + 0.06)])  # fmt: skip


def draw_ring() -> None:
    """The ring: its spaces have the form of a gear's teeth."""
    space = gear_outline(RING, above=1.15, below=0.9, slack=-BACKLASH)
    outside = circle(MODULE * RING / 2 + 0.42, space)
    h = THICK / 2
    turned([(space, -h), (outside, -h), (outside, h), (space, h)])


def drum(radius: float, low: float, high: float, sides: int = 40) -> None:
    """A closed cylinder around the z axis."""
    turn = 2 * np.pi * np.arange(sides) / sides
    ring = radius * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    wall(ring, low, high)
    for z, up in ((high, 1.0), (low, -1.0)):
        GL.glBegin(GL.GL_POLYGON)
        GL.glNormal3f(0.0, 0.0, up)
        for x, y in ring if up > 0 else ring[::-1]:
            GL.glVertex3f(x, y, z)
        GL.glEnd()


def draw_bolts() -> None:
    """Hexagon heads around the ring."""
    for k in range(12):
        GL.glPushMatrix()
        GL.glRotatef(30.0 * k + 15.0, 0.0, 0.0, 1.0)
        GL.glTranslatef(MODULE * RING / 2 + 0.27, 0.0, 0.0)
        drum(0.09, THICK / 2, THICK / 2 + 0.08, 6)
        GL.glPopMatrix()


def draw_carrier() -> None:
    """A plate with three arms behind the gears, pins through the planets, the output shaft."""
    reach = MODULE * (SUN + PLANET) / 2
    turn = 2 * np.pi * np.arange(120) / 120
    radius = 0.62 + (reach - 0.30) * (0.5 + 0.5 * np.cos(3 * turn)) ** 1.5
    plate = radius[:, None] * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    hole = circle(0.3, plate)
    turned([(hole, -0.62), (plate, -0.62), (plate, -0.42), (hole, -0.42)])
    drum(0.3, -1.5, -0.42)
    for k in range(3):
        GL.glPushMatrix()
        GL.glRotatef(120.0 * k, 0.0, 0.0, 1.0)
        GL.glTranslatef(reach, 0.0, 0.0)
        drum(0.18, -0.5, 0.36)
        GL.glPopMatrix()


def material(colour: tuple[float, ...], shine: float = 50.0) -> None:
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT_AND_DIFFUSE, colour)
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_SPECULAR, (0.35, 0.35, 0.35, 1.0))
    GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, shine)


def compiled(draw: Callable[[], None]) -> int:
    """A display list of what `draw` draws."""
    name = GL.glGenLists(1)
    GL.glNewList(name, GL.GL_COMPILE)
    draw()
    GL.glEndList()
    return int(name)


@dataclass
class Parts:
    """Display lists."""

    sun: int = field(default_factory=lambda: compiled(lambda: draw_gear(SUN, 0.28)))
    planet: int = field(default_factory=lambda: compiled(lambda: draw_gear(PLANET, 0.2)))
    ring: int = field(default_factory=lambda: compiled(draw_ring))
    bolts: int = field(default_factory=lambda: compiled(draw_bolts))
    carrier: int = field(default_factory=lambda: compiled(draw_carrier))
    shaft: int = field(default_factory=lambda: compiled(lambda: drum(0.26, -0.38, 1.1)))


def planet_turns(sun: float) -> tuple[float, list[float]]:
    """Angles, in degrees, of the carrier and of the planets within it when the sun is at `sun`."""
    carrier = sun * SUN / (SUN + RING)
    spin = -(sun - carrier) * SUN / PLANET
    return carrier, [180.0 / PLANET + spin] * 3


def draw(parts: Parts, sun: float) -> None:
    carrier, spins = planet_turns(sun)
    material(PAINT, 20.0)
    GL.glPushMatrix()
    GL.glRotatef(180.0 / RING, 0.0, 0.0, 1.0)  # a tooth of the ring where a planet has a space
    GL.glCallList(parts.ring)
    GL.glPopMatrix()
    material(DARK)
    GL.glCallList(parts.bolts)
    GL.glPushMatrix()
    GL.glRotatef(sun, 0.0, 0.0, 1.0)
    material(BRASS)
    GL.glCallList(parts.sun)
    material(STEEL, 80.0)
    GL.glCallList(parts.shaft)
    GL.glPopMatrix()
    GL.glPushMatrix()
    GL.glRotatef(carrier, 0.0, 0.0, 1.0)
    material(RED, 20.0)
    GL.glCallList(parts.carrier)
    material(STEEL, 80.0)
    for k, spin in enumerate(spins):
        GL.glPushMatrix()
        GL.glRotatef(120.0 * k, 0.0, 0.0, 1.0)
        GL.glTranslatef(MODULE * (SUN + PLANET) / 2, 0.0, 0.0)
        GL.glRotatef(spin, 0.0, 0.0, 1.0)
        GL.glCallList(parts.planet)
        GL.glPopMatrix()
    GL.glPopMatrix()


@dataclass
class View:
    azimuth: float = -24.0
    elevation: float = 58.0
    distance: float = 12.0
    speed: float = 40.0  # of the sun, degrees a second
    sun: float = 0.0
    moving: bool = True
    grip: tuple[float, float] | None = None


def connect(window: object, view: View) -> None:
    """Keys, wheel and drag."""

    def zoom(factor: float) -> None:
        view.distance = min(max(view.distance * factor, 5.0), 40.0)

    def key(_window: object, which: int, _scan: int, action: int, _mods: int) -> None:
        if action == glfw.RELEASE:
            return
        if which == glfw.KEY_ESCAPE:
            glfw.set_window_should_close(window, True)
        elif which == glfw.KEY_SPACE:
            view.moving = not view.moving
        view.speed += 10.0 * ((which == glfw.KEY_UP) - (which == glfw.KEY_DOWN))

    def char(_window: object, code: int) -> None:
        if chr(code) in "+=-":
            zoom(1 / 0.9 if chr(code) == "-" else 0.9)

    def button(_window: object, which: int, action: int, _mods: int) -> None:
        if which == glfw.MOUSE_BUTTON_LEFT:
            view.grip = glfw.get_cursor_pos(window) if action == glfw.PRESS else None

    def cursor(_window: object, x: float, y: float) -> None:
        if view.grip is not None:
            view.azimuth += 0.5 * (x - view.grip[0])
            view.elevation = min(max(view.elevation + 0.5 * (y - view.grip[1]), 0.0), 90.0)
            view.grip = (x, y)

    glfw.set_key_callback(window, key)
    glfw.set_char_callback(window, char)
    glfw.set_mouse_button_callback(window, button)
    glfw.set_cursor_pos_callback(window, cursor)
    glfw.set_scroll_callback(window, lambda _window, _x, y: zoom(0.9**y))


def set_up() -> None:
    GL.glClearColor(0.88, 0.90, 0.92, 1.0)
    for switch in (GL.GL_DEPTH_TEST, GL.GL_CULL_FACE, GL.GL_LIGHTING, GL.GL_LIGHT0, GL.GL_LIGHT1,
                   GL.GL_NORMALIZE):  # fmt: skip
        GL.glEnable(switch)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (-3.0, 5.0, 7.0, 0.0))
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.80, 0.79, 0.75, 1.0))
    GL.glLightfv(GL.GL_LIGHT1, GL.GL_POSITION, (6.0, -1.0, 2.0, 0.0))
    GL.glLightfv(GL.GL_LIGHT1, GL.GL_DIFFUSE, (0.22, 0.26, 0.34, 1.0))


def look(window: object, view: View) -> None:
    width, height = glfw.get_framebuffer_size(window)
    GL.glViewport(0, 0, width, height)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(36.0, width / max(height, 1), 1.0, 80.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.0, -view.distance)
    GL.glRotatef(view.elevation - 90.0, 1.0, 0.0, 0.0)
    GL.glRotatef(view.azimuth, 0.0, 0.0, 1.0)


def main() -> None:
    if not glfw.init():
        raise SystemExit("no display to open a window on")
    glfw.window_hint(glfw.SAMPLES, 4)
    window = glfw.create_window(*SIZE, "Planetary gears", None, None)
    glfw.make_context_current(window)
    set_up()
    parts, view = Parts(), View()
    connect(window, view)
    last = glfw.get_time()
    while not glfw.window_should_close(window):
        now = glfw.get_time()
        view.sun += view.moving * view.speed * (now - last)
        last = now
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        look(window, view)
        draw(parts, view.sun)
        glfw.swap_buffers(window)
        glfw.poll_events()
    glfw.terminate()


if __name__ == "__main__":
    main()
