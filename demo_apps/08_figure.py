"""A small dragon that walks: GLUT, immediate mode, key frames as in Quake II's MD2 models.

Six key frames hold a position and a normal for each vertex. Between two of them each vertex goes
straight from one to the other, v + a (v' - v); the moved vertices are sent each frame as the
triangle fans of the model's list of commands. Arrow keys orbit, +/- zoom, space stops time, ESC
leaves.
"""

import sys
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from OpenGL import GL, GLU, GLUT

SIZE = (640, 480)
PACE = 6.0  # key frames in a second
STRIDE = 1.5  # how far it comes in one cycle
GREEN, BELLY, CREST = (0.36, 0.58, 0.34), (0.90, 0.82, 0.56), (0.80, 0.34, 0.22)
CLAW, WHITE, BLACK = (0.86, 0.78, 0.62), (0.97, 0.97, 0.94), (0.06, 0.06, 0.07)
Floats = NDArray[np.float64]
Indices = NDArray[np.intp]
Vector = tuple[float, float, float]
Quad = tuple[int, ...]

# The bones of the left half: the parent of each, and the joint that it turns about. The dragon
# looks along z; x is its left.
BONES: dict[str, tuple[str, Vector]] = {
    "hips": ("", (0.0, 1.0, 0.0)),
    "chest": ("hips", (0.0, 1.35, 0.0)),
    "head": ("chest", (0.0, 2.02, 0.1)),
    "jaw": ("head", (0.0, 2.16, 0.2)),
    "tail": ("hips", (0.0, 0.95, -0.4)),
    "middle": ("tail", (0.0, 0.72, -0.85)),
    "tip": ("middle", (0.0, 0.52, -1.3)),
    "thigh": ("hips", (0.24, 0.82, 0.0)),
    "shin": ("thigh", (0.28, 0.5, 0.06)),
    "foot": ("shin", (0.28, 0.14, -0.06)),
    "arm": ("chest", (0.46, 1.66, 0.04)),
    "hand": ("arm", (0.62, 1.38, 0.04)),
}
UP, DOWN, FRONT, BACK, LEFT = (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1), (1, 0, 0)

# A step of the left leg, in degrees: the thigh forward, the knee bent, the toes above the floor.
STEPS = ((28, 6, 14), (17, 22, 0), (-4, 12, 0), (-24, 14, -18), (-6, 66, -26), (24, 54, 4))


class Cage:
    """The left half of the model's control cage, of quads: a block that limbs are drawn out of."""

    def __init__(self, low: Vector, high: Vector) -> None:
        self.points = [np.where([k & 1, k & 2, k & 4], high, low) for k in range(8)]
        self.bones = [["hips"]] * 8
        block = "0462 1375 0154 2673 0231 4576"  # the corners of its quads
        self.paint = {tuple(map(int, quad)): GREEN for quad in block.split()}

    def facing(self, direction: Vector, quads: list[Quad] | None = None) -> Quad:
        """The one of the quads that looks that way the most."""

        def towards(quad: Quad) -> float:
            a, b, c, d = (self.points[k] for k in quad)
            normal = np.cross(c - a, d - b)
            return float(normal @ direction / np.linalg.norm(normal))

        return max(quads or self.paint, key=towards)

    def extrude(self, quad: Quad, bones: str, move: Vector, scale: Vector = (1.0, 1.0, 1.0),
                turned: tuple[float, ...] = (), *, paint: Vector = GREEN) -> list[Quad]:
        """Draw a quad out: its place in the skin is taken by four sides and an end.

        Its corners are scaled about their middle, turned (pitch, yaw, roll) and moved; they follow
        all of `bones` alike. Returns the end and the sides.
        """
        corners = np.array([self.points[k] for k in quad])
        middle = corners.mean(axis=0)
        if not corners[:, 0].all():  # it is half of a quad, whose other half the mirror adds
            middle[0] = 0.0
        corners = (corners - middle) * scale @ turn(*turned).T + middle + move
        end = tuple(range(len(self.points), len(self.points) + 4))
        self.points += list(corners)
        self.bones += [bones.split()] * 4
        del self.paint[quad]
        sides = [(quad[k - 1], quad[k], end[k], end[k - 1]) for k in range(4)]
        self.paint |= dict.fromkeys([end, *sides], paint)
        return [end, *sides]


def turn(pitch: float = 0.0, yaw: float = 0.0, roll: float = 0.0) -> Floats:
    """A rotation by degrees about z, then y, then x; pitch lowers what is in front."""
    (cx, cy, cz), (sx, sy, sz) = (f(np.radians((pitch, yaw, roll))) for f in (np.cos, np.sin))
    about_x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    about_y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    return np.asarray(about_x @ about_y @ [[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])


def half_cage() -> Cage:
    """The left half of the dragon at rest."""
    cage = Cage((0.0, 0.72, -0.36), (0.46, 1.22, 0.36))
    front, back = cage.facing(FRONT), cage.facing(BACK)
    cage.paint[front] = BELLY

    thigh, *_ = cage.extrude(cage.facing(DOWN), "thigh", (0.09, -0.15, 0.05), (1.0, 1, 0.86))
    knee, *_ = cage.extrude(thigh, "thigh shin", (0.0, -0.2, 0.04), (0.68, 1, 0.66))
    ankle, *_ = cage.extrude(knee, "shin foot", (0.0, -0.21, -0.1), (0.85, 1, 0.8))
    _, *sides = cage.extrude(ankle, "foot", (0.0, -0.16, 0.02), (1.3, 1, 1.4))
    cage.extrude(cage.facing(FRONT, sides), "foot", (0.0, -0.03, 0.36), (1.35, 0.7, 1), paint=CLAW)

    tail, *first = cage.extrude(back, "hips tail", (0, -0.06, -0.3), (0.7, 0.72, 1), (-15,))
    tail, *second = cage.extrude(tail, "tail middle", (0, -0.2, -0.38), (0.66, 0.7, 1), (-10,))
    tail, *third = cage.extrude(tail, "middle tip", (0, -0.18, -0.42), (0.6, 0.62, 1), (5,))
    tail, *_ = cage.extrude(tail, "tip", (0, 0.02, -0.5), (0.25, 0.3, 1), (20,))

    top = cage.facing(UP)
    top, *waist = cage.extrude(top, "hips chest", (0, 0.26, -0.02), (1.0, 1, 1.0))
    top, *chest = cage.extrude(top, "chest", (0, 0.34, 0.02), (0.84, 1, 0.8))
    neck, *shoulder = cage.extrude(top, "chest head", (0, 0.3, 0.02), (0.5, 1, 0.55), (10,))
    for part in (waist, chest, shoulder):
        cage.paint[cage.facing(FRONT, part)] = BELLY
    chin, *low = cage.extrude(neck, "head", (0, 0.16, 0.06), (1.9, 1, 1.75), (-10,))
    _, *skull = cage.extrude(chin, "head", (0, 0.40, 0.0), (0.8, 1, 0.85))
    jaw = cage.facing(FRONT, low)
    _, *mouth = cage.extrude(jaw, "jaw", (0, -0.04, 0.4), (0.72, 0.5, 1), paint=BELLY)
    cage.paint[cage.facing(UP, mouth)] = CREST
    snout, *_ = cage.extrude(cage.facing(FRONT, skull), "head", (0, -0.03, 0.26), (0.86, 0.74, 1))
    cage.extrude(snout, "head", (0, 0.0, 0.26), (0.9, 0.9, 1))
    eye, *_ = cage.extrude(cage.facing(LEFT, skull), "head", (0.03, 0.0, 0.06), (1, 0.5, 0.55))
    pupil, *_ = cage.extrude(eye, "head", (-0.14, 0.0, 0.0), (1, 0.95, 0.95), paint=WHITE)
    cage.paint[pupil] = BLACK

    arm, *_ = cage.extrude(cage.facing(LEFT, chest), "chest arm", (0.08, 0.0, 0.02),
                           (1, 0.75, 0.6), (0, 0, -25))
    elbow, *_ = cage.extrude(arm, "arm hand", (0.13, -0.26, -0.01), (0.7,) * 3, (-30, 0, -50))
    cage.extrude(elbow, "hand", (0.0, -0.1, 0.36), (0.8,) * 3, (-45, 0, 0))

    for part, bones in ((chest, "chest"), (first, "hips tail"), (second, "tail middle"),
                        (third, "middle tip")):  # fmt: skip
        spot = cage.facing(BACK if part is chest else UP, part)
        cage.extrude(spot, bones, (0, 0.3, -0.2), (0.1, 0.3, 0.2), paint=CREST)
    return cage


def pose(key: int) -> dict[str, Floats]:
    """How each bone of the left half is turned in a key frame of the walk."""
    phase = 2 * np.pi * key / len(STEPS)
    sway, roll, bob = np.cos(phase), np.sin(phase), np.cos(2 * phase)
    thigh, knee, toes = STEPS[key % len(STEPS)]
    return {
        "hips": turn(4 + 2 * bob, 6 * sway, 4 * roll),
        "chest": turn(2 - 2 * bob, -12 * sway, -3 * roll),
        "head": turn(-4 + 3 * bob, 6 * sway),
        "jaw": turn(10 + 6 * bob),
        "tail": turn(2 * bob, 12 * roll),
        "middle": turn(3 * bob, 18 * np.sin(phase - 0.8)),
        "tip": turn(4 * bob, 24 * np.sin(phase - 1.6)),
        "thigh": turn(-thigh),
        "shin": turn(knee),
        "foot": turn(thigh - knee - toes),
        "arm": turn(-10 + 24 * sway),
        "hand": turn(-12 + 14 * sway),
    }


def posed(cage: Cage, key: int) -> Floats:
    """The points of the cage in a key frame: each the mean of where its bones take it."""
    turns = pose(key)
    places = {"": (np.eye(3), np.zeros(3))}  # of each bone: rotation, translation
    for bone, (parent, joint) in BONES.items():
        rotation, shift = places[parent]
        places[bone] = (rotation @ turns[bone], rotation @ (joint - turns[bone] @ joint) + shift)
    return np.array([
        np.mean([places[bone][0] @ point + places[bone][1] for bone in bones], axis=0)
        for point, bones in zip(cage.points, cage.bones, strict=True)
    ])  # fmt: skip


class Smoother:
    """One step of Catmull and Clark's subdivision (1978); each quad becomes a fan of 8 triangles.

    `fans` is (F, 10): the middle of the quad, around it corners and edges in turn, the first again.
    """

    def __init__(self, quads: Indices) -> None:
        self.quads, self.count = quads, int(quads.max()) + 1
        sides = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2)
        self.edges, edge = np.unique(np.sort(sides, axis=2).reshape(-1, 2), axis=0,
                                     return_inverse=True)  # fmt: skip
        self.edge = edge.reshape(quads.shape)
        around = np.stack([quads, self.count + self.edge], axis=2).reshape(-1, 8)
        middle = self.count + len(self.edges) + np.arange(len(quads))
        self.fans = np.column_stack([middle, around, around[:, 0]])

    def gathered(self, to: Indices, values: Floats, count: int) -> Floats:
        """The means of the values that go to each of `count` places."""
        total, number = np.zeros((count, 3)), np.bincount(to.ravel(), minlength=count)
        np.add.at(total, to.ravel(), values)
        return np.asarray(total / number[:, None])

    def __call__(self, points: Floats) -> Floats:
        """Corners (moved), edges and middles of the cage with these points, (V + E + F, 3)."""
        middles = points[self.quads].mean(axis=1)
        spread = np.repeat(middles, 4, axis=0)
        halves = points[self.edges].mean(axis=1)
        edges = (halves + self.gathered(self.edge, spread, len(halves))) / 2
        degree = np.bincount(self.edges.ravel(), minlength=self.count)[:, None]
        faces = self.gathered(self.quads, spread, self.count)
        rims = self.gathered(self.edges, np.repeat(halves, 2, axis=0), self.count)
        corners = (faces + 2 * rims + (degree - 3) * points) / degree
        return np.concatenate([corners, edges, middles])


def normals_of(points: Floats, triangles: Indices) -> Floats:
    """The vertices' unit normals, (V, 3), each triangle counted by its area."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    normals = np.zeros_like(points)
    np.add.at(normals, triangles.T, np.cross(b - a, c - a))
    return np.asarray(normals / np.linalg.norm(normals, axis=1, keepdims=True))


class Model:
    """Key frames, (keys, V, 3) of positions and of normals, and the fans that they are drawn as."""

    def __init__(self) -> None:
        cage = half_cage()
        seam = np.array(cage.points)[:, 0] == 0.0
        twins = np.where(seam, np.arange(len(seam)), len(seam) + np.cumsum(~seam) - 1)
        half = [quad for quad in cage.paint if not seam[list(quad)].all()]
        self.paint = [cage.paint[quad] for quad in half] * 2
        smooth = Smoother(np.concatenate([half, twins[half][:, ::-1]]))
        self.fans = smooth.fans
        around = [np.repeat(self.fans[:, :1], 8, axis=1), self.fans[:, 1:-1], self.fans[:, 2:]]
        self.triangles = np.stack(around, axis=2).reshape(-1, 3)
        keys = []
        for key in range(len(STEPS)):
            # A walk is the same in a mirror, half a cycle later: that is the right half.
            left, right = posed(cage, key), posed(cage, key + len(STEPS) // 2) * (-1, 1, 1)
            points = smooth(np.concatenate([left, right[~seam]]))
            keys.append(points - (0, points[:, 1].min(), 0))
        self.positions = np.stack(keys)
        self.normals = np.stack([normals_of(points, self.triangles) for points in keys])

    def at(self, time: float) -> tuple[Floats, Floats]:
        """Positions and normals, (V, 3) each, `time` seconds into the walk."""
        key, part = divmod(time * PACE, 1.0)
        now, then = int(key) % len(STEPS), int(key + 1) % len(STEPS)
        positions, normals = (v[now] + part * (v[then] - v[now])
                              for v in (self.positions, self.normals))  # fmt: skip
        return positions, normals

    def draw(self, time: float) -> None:
        positions, normals = (array.tolist() for array in self.at(time))
        for fan, colour in zip(self.fans.tolist(), self.paint, strict=True):
            GL.glColor3fv(colour)
            GL.glBegin(GL.GL_TRIANGLE_FAN)
            for vertex in fan:
                GL.glNormal3fv(normals[vertex])
                GL.glVertex3fv(positions[vertex])
            GL.glEnd()


def draw_floor(time: float) -> None:
    """Tiles that pass below the feet."""
    gone = time * PACE / len(STEPS) * STRIDE
    tile, shift = int(gone), gone % 1.0
    GL.glBegin(GL.GL_QUADS)
    GL.glNormal3f(0.0, 1.0, 0.0)
    for i in range(-5, 5):
        for k in range(-4, 6):
            GL.glColor3fv(((0.70, 0.71, 0.68), (0.80, 0.80, 0.76))[(i + k + tile) % 2])
            near, far = max(k - shift, -4.0), min(k + 1 - shift, 5.0)
            for x, z in ((i, near), (i, far), (i + 1, far), (i + 1, near)):
                GL.glVertex3f(x, 0.0, z)
    GL.glEnd()


@dataclass
class View:
    azimuth: float = -62.0
    elevation: float = 12.0
    distance: float = 5.6
    size: tuple[int, int] = SIZE
    moving: bool = True
    frame: int = 0


view = View()


def display(model: Model) -> None:
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(34.0, view.size[0] / view.size[1], 1.0, 40.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.0, -view.distance)
    GL.glRotatef(view.elevation, 1.0, 0.0, 0.0)
    GL.glRotatef(view.azimuth, 0.0, 1.0, 0.0)
    GL.glTranslatef(0.0, -1.3, 0.5)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (5.0, 7.0, 4.0, 0.0))
    draw_floor(view.frame / 60)
    model.draw(view.frame / 60)
    GLUT.glutSwapBuffers()


def advance(_value: int) -> None:
    view.frame += view.moving
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
        view.distance = max(view.distance * 0.9, 4.0)
    elif key == b"-":
        view.distance = min(view.distance / 0.9, 20.0)


def arrows(key: int, _x: int, _y: int) -> None:
    view.azimuth += 5.0 * ((key == GLUT.GLUT_KEY_RIGHT) - (key == GLUT.GLUT_KEY_LEFT))
    view.elevation += 5.0 * ((key == GLUT.GLUT_KEY_UP) - (key == GLUT.GLUT_KEY_DOWN))


def set_up() -> None:
    GL.glClearColor(0.86, 0.91, 0.94, 1.0)
    for switch in (GL.GL_DEPTH_TEST, GL.GL_CULL_FACE, GL.GL_NORMALIZE, GL.GL_LIGHTING,
                   GL.GL_LIGHT0, GL.GL_COLOR_MATERIAL):  # fmt: skip
        GL.glEnable(switch)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.72, 0.70, 0.66, 1.0))
    GL.glLightModelfv(GL.GL_LIGHT_MODEL_AMBIENT, (0.42, 0.43, 0.45, 1.0))


def main() -> None:
    GLUT.glutInit(sys.argv)
    GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE | GLUT.GLUT_RGB | GLUT.GLUT_DEPTH)
    GLUT.glutInitWindowSize(*SIZE)
    GLUT.glutCreateWindow(b"Figure")
    set_up()
    model = Model()
    GLUT.glutDisplayFunc(lambda: display(model))
    GLUT.glutReshapeFunc(reshape)
    GLUT.glutKeyboardFunc(keyboard)
    GLUT.glutSpecialFunc(arrows)
    GLUT.glutTimerFunc(16, advance, 0)
    GLUT.glutMainLoop()


if __name__ == "__main__":
    main()
