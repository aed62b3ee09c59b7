"""A rubber arm that bends, turns and grips: glfw, a matrix-skinned mesh in client vertex arrays.

One closed skin over nine bones. Each vertex follows up to four of them, by weights that sum to one;
numpy moves them all each frame and glDrawElements draws what came out. Drag or arrow keys orbit,
wheel or +/- zoom, space stops time, ESC leaves.
"""

import sys
from dataclasses import dataclass, field

import glfw
import numpy as np
from numpy.typing import NDArray
from OpenGL import GL, GLU

SIZE = (640, 480)
FINGERS = 3
AROUND = 18  # vertices in each ring of the arm and of the fingers
INFLUENCES = 4  # bones that a vertex may follow
ORANGE, RUBBER, STEEL = (0.90, 0.52, 0.22), (0.36, 0.40, 0.46), (0.70, 0.73, 0.76)
Floats = NDArray[np.float64]
Indices = NDArray[np.intp]
Colour = tuple[float, float, float]

# At rest the arm stands up along y, and a place on it is its height; in a finger this goes on.
ELBOW, WRIST, PALM = 1.65, 2.75, 3.2
KNUCKLE, TIP = PALM + 0.46, PALM + 0.94
SOFT = {ELBOW: 0.5, WRIST: 0.27, PALM: 0.12, KNUCKLE: 0.12}  # how far a joint's bend reaches
THICK = (  # places, and there the radius
    (0.0, 0.25, 1.1, 1.2, 2.1, 2.48, 3.02, PALM, PALM + 0.1, KNUCKLE - 0.1, KNUCKLE, TIP - 0.1,
     TIP),
    (0.40, 0.36, 0.33, 0.28, 0.27, 0.19, 0.22, 0.35, 0.15, 0.12, 0.135, 0.09, 0.0),
)  # fmt: skip
RIBBED, RIB = {ELBOW: 6, WRIST: 3}, 0.08  # ribs on either side of a joint, and their width
PLAIN = (0.0, 0.2, 0.4, 0.6, 0.8, 0.98, 1.14, 2.16, 2.26, 2.37, 2.48, 3.02, 3.06, 3.13, PALM)
FINGER_RINGS = (0.1, 0.22, 0.35, 0.46, 0.57, 0.7, 0.84, 0.91)  # on from the palm


def out(angle: Floats | float) -> Floats:
    """The direction away from the arm's axis at an angle in radians."""
    angle = np.asarray(angle)
    return np.stack([np.sin(angle), np.zeros_like(angle), np.cos(angle)], axis=-1)


def finger(number: int) -> tuple[Floats, Floats]:
    """Where a finger starts and its direction at rest."""
    away = out((number + 0.5) * 2 * np.pi / FINGERS)
    along = 0.36 * away + (0.0, 0.94, 0.0)
    return 0.19 * away + (0.0, PALM, 0.0), along / np.linalg.norm(along)


def stations() -> list[tuple[float, float, Colour]]:
    """The arm's rings from the bottom up: place, radius and colour."""
    ribs = {joint + k * RIB: 1.0 + 0.06 * (-1) ** k for joint, many in RIBBED.items()
            for k in range(-many, many + 1)}  # fmt: skip
    rings = [(place, swell, RUBBER) for place, swell in ribs.items()]
    rings += [(place, 1.0, ORANGE) for place in PLAIN]
    return [(place, float(np.interp(place, *THICK)) * swell, colour)
            for place, swell, colour in sorted(rings)]  # fmt: skip


@dataclass
class Skin:
    """Rings of vertices sewn to each other: a tube that parts into fingers.

    Of each vertex: its point, its place along the arm, its share in each finger (they sum to one)
    and its colour.
    """

    points: list[Floats] = field(default_factory=list)
    along: list[float] = field(default_factory=list)
    shares: list[Floats] = field(default_factory=list)
    colours: list[Colour] = field(default_factory=list)
    triangles: list[Indices] = field(default_factory=list)

    def add(self, points: Floats, place: float, shares: Floats, colour: Colour) -> Indices:
        """The numbers of new vertices."""
        first = len(self.points)
        self.points += list(points)
        self.shares += list(np.broadcast_to(shares, (len(points), FINGERS)))
        self.along += [place] * len(points)
        self.colours += [colour] * len(points)
        return np.arange(first, len(self.points))

    def sew(self, low: Indices, high: Indices) -> None:
        """Triangles between two rings that run counter-clockwise as seen from the high one."""
        a, b = np.roll(low, -1), np.roll(high, -1)
        self.triangles += [np.stack([low, a, b], axis=1), np.stack([low, b, high], axis=1)]

    def close(self, ring: Indices, tip: int) -> None:
        """Triangles from a ring up to its tip."""
        self.triangles += [np.stack([ring, np.roll(ring, -1), np.full_like(ring, tip)], axis=1)]

    def tube(self) -> Indices:
        """The arm; its last ring is the rim of the palm."""
        angles = np.arange(AROUND) * 2 * np.pi / AROUND
        roots = (np.arange(FINGERS) + 0.5) * 2 * np.pi / FINGERS
        shares = np.maximum(np.cos(angles[:, None] - roots) + 0.5, 0.0)
        shares /= shares.sum(axis=1, keepdims=True)
        ring = np.empty(0, np.intp)
        for place, radius, colour in stations():
            points = radius * out(angles) + (0.0, place, 0.0)
            last, ring = ring, self.add(points, place, shares, colour)
            if len(last):
                self.sew(last, ring)
            else:
                middle = self.add(np.zeros((1, 3)), 0.0, np.full(FINGERS, 1 / FINGERS), colour)
                self.close(ring[::-1], int(middle[0]))
        return ring

    def part(self, rim: Indices) -> list[Indices]:
        """Part the palm by spokes from its middle into a ring for each finger."""
        step = AROUND // FINGERS
        even = np.full(FINGERS, 1 / FINGERS)
        middle = self.add(np.array([[0.0, PALM, 0.0]]), PALM, even, STEEL)
        inner = (AROUND - step) // 2 - 1  # vertices on a spoke, between the rim and the middle
        spokes = []
        for end in rim[::step]:
            part = np.linspace(1.0, 0.0, inner + 2)[1:-1, None]
            points = part * self.points[end] + (1 - part) * self.points[middle[0]]
            shares = part * self.shares[end] + (1 - part) * even
            spokes.append(self.add(points, PALM, shares, STEEL))
        rim = np.append(rim, rim[0])
        return [
            np.concatenate([rim[k * step : (k + 1) * step + 1], spokes[(k + 1) % FINGERS], middle,
                            spokes[k][::-1]])
            for k in range(FINGERS)
        ]  # fmt: skip

    def finger(self, number: int, ring: Indices) -> None:
        """A finger on its ring in the palm."""
        root, along = finger(number)
        away = out((number + 0.5) * 2 * np.pi / FINGERS)
        side = np.cross(along, away)
        side /= np.linalg.norm(side)
        away = np.cross(side, along)
        from_root = np.array([self.points[k] for k in ring]) - root
        circle = np.stack([from_root @ away, from_root @ side], axis=1)
        circle = circle / np.linalg.norm(circle, axis=1, keepdims=True) @ np.stack([away, side])
        own = np.eye(FINGERS)[number]
        for far in FINGER_RINGS:
            points = root + far * along + np.interp(PALM + far, *THICK) * circle
            last, ring = ring, self.add(points, PALM + far, own, STEEL)
            self.sew(last, ring)
        tip = self.add((root + (TIP - PALM) * along)[None], TIP, own, STEEL)
        self.close(ring, int(tip[0]))


class Arm:
    """The skin at rest, its bones, and what each vertex has of them."""

    def __init__(self) -> None:
        skin = Skin()
        for number, ring in enumerate(skin.part(skin.tube())):
            skin.finger(number, ring)
        self.points = np.array(skin.points)
        self.triangles = np.concatenate(skin.triangles)
        self.colours = np.array(skin.colours, np.float32)
        self.normals = normals_of(self.points, self.triangles)
        self.bones, self.weights = influences(np.array(skin.along), np.array(skin.shares))

    def skinned(self, time: float) -> tuple[Floats, Floats]:
        """Points and normals (V, 3) `time` seconds on: each a mean of where its bones take it."""
        matrices = pose(time)[self.bones]  # (V, INFLUENCES, 3, 4)
        blend = np.einsum("vb,vbij->vij", self.weights, matrices)
        points = np.einsum("vij,vj->vi", blend[:, :, :3], self.points) + blend[:, :, 3]
        normals = np.einsum("vij,vj->vi", blend[:, :, :3], self.normals)
        return points, normals


def influences(along: Floats, shares: Floats) -> tuple[Indices, Floats]:
    """The bones that each vertex follows and their weights, (V, INFLUENCES) both.

    Bones: upper arm, forearm, hand, then the two of each finger. A joint passes what is beyond it
    on from one bone to the next.
    """
    steps = [np.clip((along - joint) / soft / 2 + 0.5, 0.0, 1.0) for joint, soft in SOFT.items()]
    elbow, wrist, palm, knuckle = (step * step * (3 - 2 * step) for step in steps)
    columns = [1 - elbow, elbow - wrist, wrist - palm]
    for share in shares.T:
        columns += [(palm - knuckle) * share, knuckle * share]
    weights = np.stack(columns, axis=1)
    bones = np.argsort(-weights, axis=1)[:, :INFLUENCES]
    kept = np.take_along_axis(weights, bones, axis=1)
    return bones, kept / kept.sum(axis=1, keepdims=True)


def normals_of(points: Floats, triangles: Indices) -> Floats:
    """The vertices' unit normals, (V, 3), each triangle counted by its area."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    normals = np.zeros_like(points)
    np.add.at(normals, triangles.T, np.cross(b - a, c - a))
    return np.asarray(normals / np.linalg.norm(normals, axis=1, keepdims=True))


def about(pivot: Floats, axis: Floats, degrees: float) -> Floats:
    """The turn about an axis through a point, (4, 4)."""
    x, y, z = axis
    angle = np.radians(degrees)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix = np.eye(4)
    matrix[:3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    matrix[:3, 3] = pivot - matrix[:3, :3] @ pivot
    return matrix


def pose(time: float) -> Floats:
    """The matrices of the bones, (bones, 3, 4), from where a vertex rests to where it goes."""
    up, side = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, -1.0])
    grip = 0.5 - 0.5 * np.cos(1.9 * time)
    upper = about(0 * up, up, 40 * np.sin(0.5 * time))
    upper = upper @ about(0 * up, side, -14 + 18 * np.sin(time))
    fore = upper @ about(ELBOW * up, side, 60 + 24 * np.sin(time + 0.6))
    hand = fore @ about(WRIST * up, side, 28 + 30 * np.sin(1.3 * time))
    hand = hand @ about(WRIST * up, up, 50 * np.sin(0.8 * time))
    found = [upper, fore, hand]
    for number in range(FINGERS):
        root, along = finger(number)
        curl = np.cross(along, up)
        curl /= np.linalg.norm(curl)
        first = hand @ about(root, curl, -18 + 30 * grip)
        knuckle = root + (KNUCKLE - PALM) * along
        found += [first, first @ about(knuckle, curl, 4 + 26 * grip)]
    return np.stack(found)[:, :3]


@dataclass
class View:
    azimuth: float = -24.0
    elevation: float = 14.0
    distance: float = 7.8
    size: tuple[int, int] = SIZE
    moving: bool = True
    frame: int = 0
    grip: tuple[float, float] | None = field(default=None)

    def orbit(self, azimuth: float, elevation: float) -> None:
        self.azimuth += azimuth
        self.elevation = min(max(self.elevation + elevation, 1.0), 80.0)

    def drag(self, x: float, y: float) -> None:
        if self.grip is not None:
            self.orbit(0.4 * (x - self.grip[0]), 0.4 * (y - self.grip[1]))
            self.grip = (x, y)

    def zoom(self, steps: float) -> None:
        self.distance = min(max(self.distance * 0.9**steps, 4.0), 20.0)


def draw_arm(arm: Arm, time: float) -> None:
    points, normals = (array.astype(np.float32) for array in arm.skinned(time))
    corners = arm.triangles.astype(np.uint32)
    arrays = (GL.GL_VERTEX_ARRAY, GL.GL_NORMAL_ARRAY, GL.GL_COLOR_ARRAY)
    for array in arrays:
        GL.glEnableClientState(array)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, points)
    GL.glNormalPointer(GL.GL_FLOAT, 0, normals)
    GL.glColorPointer(3, GL.GL_FLOAT, 0, arm.colours)
    GL.glDrawElements(GL.GL_TRIANGLES, corners.size, GL.GL_UNSIGNED_INT, corners)
    for array in arrays:
        GL.glDisableClientState(array)


def draw_stand(quadric: object) -> None:
    """The floor, and a drum that the arm is set in."""
    GL.glPushMatrix()
    GL.glRotatef(-90.0, 1.0, 0.0, 0.0)
    GL.glTranslatef(0.0, 0.0, -0.05)
    GL.glColor3f(0.74, 0.77, 0.78)
    GLU.gluDisk(quadric, 0.0, 5.0, 64, 4)
    GL.glColor3f(*STEEL)
    GLU.gluCylinder(quadric, 0.62, 0.62, 0.2, 36, 1)
    GL.glTranslatef(0.0, 0.0, 0.2)
    GLU.gluDisk(quadric, 0.0, 0.62, 36, 1)
    GL.glPopMatrix()


def set_up() -> None:
    GL.glClearColor(0.88, 0.91, 0.93, 1.0)
    for switch in (GL.GL_DEPTH_TEST, GL.GL_CULL_FACE, GL.GL_NORMALIZE, GL.GL_LIGHTING,
                   GL.GL_LIGHT0, GL.GL_COLOR_MATERIAL):  # fmt: skip
        GL.glEnable(switch)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.76, 0.74, 0.70, 1.0))
    GL.glLightModelfv(GL.GL_LIGHT_MODEL_AMBIENT, (0.38, 0.39, 0.42, 1.0))
    GL.glMaterialfv(GL.GL_FRONT, GL.GL_SPECULAR, (0.25, 0.25, 0.25, 1.0))
    GL.glMaterialf(GL.GL_FRONT, GL.GL_SHININESS, 40.0)


def look(view: View) -> None:
    GL.glViewport(0, 0, *view.size)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(34.0, view.size[0] / max(view.size[1], 1), 1.0, 40.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.0, -view.distance)
    GL.glRotatef(view.elevation, 1.0, 0.0, 0.0)
    GL.glRotatef(view.azimuth, 0.0, 1.0, 0.0)
    GL.glTranslatef(-0.7, -1.75, 0.0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (-3.0, 6.0, 5.0, 0.0))


def connect(window: object, view: View) -> None:
    keys = {
        glfw.KEY_ESCAPE: lambda: glfw.set_window_should_close(window, True),
        glfw.KEY_SPACE: lambda: setattr(view, "moving", not view.moving),
        glfw.KEY_LEFT: lambda: view.orbit(-5.0, 0.0), glfw.KEY_RIGHT: lambda: view.orbit(5.0, 0.0),
        glfw.KEY_DOWN: lambda: view.orbit(0.0, -5.0), glfw.KEY_UP: lambda: view.orbit(0.0, 5.0),
        glfw.KEY_EQUAL: lambda: view.zoom(1), glfw.KEY_KP_ADD: lambda: view.zoom(1),
        glfw.KEY_MINUS: lambda: view.zoom(-1), glfw.KEY_KP_SUBTRACT: lambda: view.zoom(-1),
    }  # fmt: skip

    def key(_window: object, key: int, _scan: int, action: int, _mods: int) -> None:
        if action != glfw.RELEASE and key in keys:
            keys[key]()

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
        print("bending_arm: no display to open a window on", file=sys.stderr)
        return 1
    window = glfw.create_window(*SIZE, "Bending arm", None, None)
    glfw.make_context_current(window)
    glfw.swap_interval(1)
    view, arm, quadric = View(), Arm(), GLU.gluNewQuadric()
    connect(window, view)
    set_up()
    while not glfw.window_should_close(window):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        look(view)
        draw_stand(quadric)
        draw_arm(arm, view.frame / 60)
        glfw.swap_buffers(window)
        view.frame += view.moving
        glfw.poll_events()
    glfw.terminate()
    return 0


if __name__ == "__main__":
    sys.exit(main())
