"""A 3D printer at work: `python -m demo_apps.09_gcode [FILE.gcode]`; GLUT, buffer objects, a HUD.

Without a file it prints a twisted planter, which `slicer.py` made. Plastic is as wide as its E
values make it, and has the colour of its kind. Drag to orbit, wheel or +/- to zoom, up and down
change the speed, r begins at the first layer, space stops it, ESC leaves.
"""

import ctypes
import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from OpenGL import GL, GLU, GLUT
from OpenGL.arrays import vbo

try:
    from .gcode import BadFile, Strand, parsed
except ImportError:  # started as a file: its folder is on the path
    from gcode import BadFile, Strand, parsed

SIZE = (640, 480)
BED = 80.0  # its side, millimetres
PLANTER = Path(__file__).with_name("models") / "planter.gcode"
SECTION = ((0.5, 0.0), (0.28, 0.5), (-0.28, 0.5), (-0.5, 0.0), (-0.28, -0.5), (0.28, -0.5))
SIDES = len(SECTION)
COLOURS = {
    "SKIRT": (0.55, 0.56, 0.60), "WALL-OUTER": (0.93, 0.48, 0.14), "WALL-INNER": (0.95, 0.76, 0.24),
    "FILL": (0.78, 0.24, 0.20), "SKIN": (0.84, 0.34, 0.40), "": (0.30, 0.55, 0.74),
}  # fmt: skip
Floats = NDArray[np.float64]


def tube(strand: Strand) -> tuple[Floats, Floats]:
    """Quads around a strand, mitred at bends, and their normals, (quads, 4, 3) each.

    SIDES for each piece; before them and after them two for each end, unless it closes.
    """
    points = np.array(strand.points)
    along = np.diff(points, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    closed = strand.closed
    before = np.concatenate([along[-1:] if closed else along[:1], along])
    after = np.concatenate([along, along[:1] if closed else along[-1:]])
    sides = [np.stack([t[:, 1], -t[:, 0], 0 * t[:, 0]], axis=1) for t in (before, after)]
    out = sides[0] + sides[1]
    out /= np.maximum((out * sides[0]).sum(axis=1, keepdims=True), 0.7)
    widths = np.array([strand.widths[0], *strand.widths])
    # A flattened hexagon, whose top and bottom lie on the layers above and below.
    section = np.array(SECTION)
    aside = out[:, None] * (section[:, :1] * widths[:, None, None])
    rise = (section[:, 1:] - 0.5) * 0.98 * strand.height * np.array([0.0, 0.0, 1.0])
    rings = points[:, None] + aside + rise
    ahead = np.roll(rings, -1, axis=1)
    quads = np.stack([rings[:-1], rings[1:], ahead[1:], ahead[:-1]], axis=2).reshape(-1, 4, 3)
    if not closed:
        first, last = rings[0], rings[-1][::-1]
        halves = ([0, 1, 2, 3], [0, 3, 4, 5])
        quads = np.concatenate([first[np.array(halves)], quads, last[np.array(halves)]])
    normals = np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    return quads, np.repeat(normals[:, None], 4, axis=1)


def colour_of(kind: str) -> tuple[float, float, float]:
    return COLOURS.get(kind, COLOURS[""])


class Print:
    """All that will be printed, in one buffer, in order; and the way of the nozzle."""

    def __init__(self, strands: list[Strand]) -> None:
        tables, counts = [], []
        for strand in strands:
            quads, normals = tube(strand)
            colour = np.broadcast_to(colour_of(strand.kind), quads.shape)
            tables.append(np.concatenate([quads, normals, colour], axis=2).reshape(-1, 9))
            count = [SIDES * 4] * len(strand.widths)
            if not strand.closed:
                count[0] += 8
                count[-1] += 8
            counts += count
        self.buffer = vbo.VBO(np.concatenate(tables).astype(np.float32))
        self.counts = np.concatenate([[0], np.cumsum(counts)])  # of vertices, after each piece
        self.starts = np.concatenate([np.array(s.points[:-1]) for s in strands])
        self.ends = np.concatenate([np.array(s.points[1:]) for s in strands])
        self.owners = [strand for strand in strands for _ in strand.widths]
        self.widths = [width for strand in strands for width in strand.widths]
        self.reach = np.cumsum(np.linalg.norm(self.ends - self.starts, axis=1))
        self.layers = np.unique(np.round(self.ends[:, 2], 3))
        self.kinds = list(dict.fromkeys(strand.kind for strand in strands))
        corners = np.concatenate([self.starts, self.ends])
        self.low, self.high = corners.min(axis=0), corners.max(axis=0)

    def nozzle(self, way: float) -> tuple[int, Floats]:
        """How many pieces are complete after so many millimetres, and where the nozzle is."""
        done = int(np.searchsorted(self.reach, way))
        if done == len(self.reach):
            return done, self.ends[-1]
        begun = self.reach[done - 1] if done else 0.0
        part = (way - begun) / (self.reach[done] - begun)
        return done, np.asarray(self.starts[done] + part * (self.ends[done] - self.starts[done]))

    def draw(self, done: int, nozzle: Floats) -> None:
        """The complete pieces from the buffer, the one at work corner by corner."""
        with self.buffer:
            GL.glPushClientAttrib(GL.GL_CLIENT_VERTEX_ARRAY_BIT)
            for array in (GL.GL_VERTEX_ARRAY, GL.GL_NORMAL_ARRAY, GL.GL_COLOR_ARRAY):
                GL.glEnableClientState(array)
            GL.glVertexPointer(3, GL.GL_FLOAT, 36, ctypes.c_void_p(0))
            GL.glNormalPointer(GL.GL_FLOAT, 36, ctypes.c_void_p(12))
            GL.glColorPointer(3, GL.GL_FLOAT, 36, ctypes.c_void_p(24))
            GL.glDrawArrays(GL.GL_QUADS, 0, int(self.counts[done]))
            GL.glPopClientAttrib()
        if done == len(self.reach) or math.dist(self.starts[done], nozzle) < 1e-3:
            return
        owner = self.owners[done]
        ends = [tuple(self.starts[done]), tuple(nozzle)]
        piece = Strand(owner.kind, owner.height, ends, [self.widths[done]])
        GL.glColor3fv(colour_of(owner.kind))
        GL.glBegin(GL.GL_QUADS)
        for quad, normals in zip(*tube(piece), strict=True):
            GL.glNormal3fv(normals[0])
            for corner in quad:
                GL.glVertex3fv(corner)
        GL.glEnd()


def block(low: tuple[float, ...], high: tuple[float, ...]) -> None:
    """A box between two corners."""
    GL.glPushMatrix()
    GL.glTranslatef(*((a + b) / 2 for a, b in zip(low, high, strict=True)))
    GL.glScalef(*(b - a for a, b in zip(low, high, strict=True)))
    GLUT.glutSolidCube(1.0)
    GL.glPopMatrix()


def draw_bed(ground: float) -> None:
    """A plate with a grid of centimetres."""
    GL.glColor3f(0.42, 0.45, 0.50)
    block((-4.0, -4.0, ground - 4.0), (BED + 4.0, BED + 4.0, ground - 0.05))
    GL.glDisable(GL.GL_LIGHTING)
    GL.glBegin(GL.GL_LINES)
    for k in range(int(BED / 10) + 1):
        GL.glColor3fv((0.74, 0.78, 0.84) if k % 4 == 0 else (0.56, 0.60, 0.66))
        for a, b in (((10 * k, 0), (10 * k, BED)), ((0, 10 * k), (BED, 10 * k))):
            GL.glVertex3f(*a, ground + 0.1)
            GL.glVertex3f(*b, ground + 0.1)
    GL.glEnd()
    GL.glEnable(GL.GL_LIGHTING)


def draw_head(nozzle: Floats) -> None:
    """Nozzle, heater, cooler and the beam that the head runs along."""
    x, y, z = nozzle
    quadric = GLU.gluNewQuadric()
    GL.glPushMatrix()
    GL.glTranslatef(x, y, z)
    GL.glColor3f(0.84, 0.68, 0.30)
    GLU.gluCylinder(quadric, 0.5, 2.6, 4.0, 24, 1)
    GL.glPushMatrix()
    GL.glTranslatef(0.0, 0.0, 4.0)
    GLU.gluCylinder(quadric, 2.6, 2.6, 2.0, 6, 1)
    GL.glPopMatrix()
    GL.glColor3f(0.70, 0.72, 0.76)
    block((-5.0, -3.5, 6.0), (5.0, 3.5, 10.0))
    GL.glColor3f(0.26, 0.28, 0.32)
    for k in range(4):
        block((-4.5, -4.5, 11.0 + 2.2 * k), (4.5, 4.5, 12.4 + 2.2 * k))
    GL.glColor3f(0.70, 0.72, 0.76)
    GL.glTranslatef(0.0, 0.0, 10.0)
    GLU.gluCylinder(quadric, 1.8, 1.8, 10.0, 20, 1)
    GL.glPopMatrix()
    GLU.gluDeleteQuadric(quadric)
    GL.glColor3f(0.18, 0.42, 0.68)
    block((x - 6.0, y - 2.0, z + 20.0), (x + 6.0, y + 9.5, z + 25.0))
    GL.glColor3f(0.66, 0.68, 0.72)
    block((-8.0, y + 5.0, z + 15.5), (BED + 8.0, y + 9.0, z + 19.5))


@dataclass
class View:
    azimuth: float = 24.0
    elevation: float = 26.0
    distance: float = 146.0
    size: tuple[int, int] = SIZE
    way: float = 0.0  # millimetres laid
    speed: float = 160.0  # millimetres a second
    moving: bool = True
    grip: tuple[int, int] | None = None
    seen: float = 0.0  # the time of the last picture, seconds


view = View()


def write(x: float, y: float, text: str) -> None:
    GL.glRasterPos2f(x, y)
    for letter in text:
        GLUT.glutBitmapCharacter(GLUT.GLUT_BITMAP_HELVETICA_12, ord(letter))


def draw_overlay(job: Print, title: str, nozzle: Floats) -> None:
    """Title, layer, progress, and what the colours mean, in window coordinates."""
    width, height = view.size
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GL.glOrtho(0, width, 0, height, -1, 1)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    for switch in (GL.GL_LIGHTING, GL.GL_DEPTH_TEST):
        GL.glDisable(switch)
    GL.glEnable(GL.GL_BLEND)
    GL.glColor4f(1.0, 1.0, 1.0, 0.7)
    GL.glRectf(8, height - 68, 224, height - 8)
    GL.glRectf(8, 8, 118, 20 + 18 * len(job.kinds))
    GL.glDisable(GL.GL_BLEND)
    share = min(view.way / job.reach[-1], 1.0)
    layer = int(np.searchsorted(job.layers, nozzle[2] - 1e-3)) + 1
    GL.glColor3f(0.14, 0.18, 0.26)
    write(16, height - 26, title)
    write(16, height - 44, f"layer {layer} of {len(job.layers)}   z {nozzle[2]:.2f} mm   "
                           f"{share * 100:.0f} %")  # fmt: skip
    for right, colour in ((1.0, (0.78, 0.81, 0.85)), (share, (0.18, 0.50, 0.36))):
        GL.glColor3fv(colour)
        GL.glRectf(16, height - 60, 16 + 200 * right, height - 53)
    for k, kind in enumerate(job.kinds):
        GL.glColor3fv(colour_of(kind))
        GL.glRectf(16, 16 + 18 * k, 28, 28 + 18 * k)
        GL.glColor3f(0.14, 0.18, 0.26)
        write(36, 18 + 18 * k, kind.lower().replace("-", " ") or "printed")
    for switch in (GL.GL_LIGHTING, GL.GL_DEPTH_TEST):
        GL.glEnable(switch)


def display(job: Print, title: str) -> None:
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(34.0, view.size[0] / view.size[1], 5.0, 900.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.0, -view.distance)
    GL.glRotatef(view.elevation - 90.0, 1.0, 0.0, 0.0)
    GL.glRotatef(view.azimuth, 0.0, 0.0, 1.0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (-3.0, -4.0, 6.0, 0.0))
    GL.glLightfv(GL.GL_LIGHT1, GL.GL_POSITION, (5.0, -1.0, 2.0, 0.0))
    GL.glTranslatef(-BED / 2, -BED / 2, -0.5 * job.high[2] - 8.0)
    done, nozzle = job.nozzle(view.way)
    draw_bed(0.0)
    job.draw(done, nozzle)
    draw_head(nozzle + np.array([0.0, 0.0, 18.0 * (done == len(job.reach))]))
    draw_overlay(job, title, nozzle)
    GLUT.glutSwapBuffers()


def advance(job: Print) -> None:
    now = GLUT.glutGet(GLUT.GLUT_ELAPSED_TIME) / 1000
    view.way = min(view.way + view.moving * view.speed * (now - view.seen), job.reach[-1])
    view.seen = now
    GLUT.glutPostRedisplay()
    GLUT.glutTimerFunc(16, lambda _value: advance(job), 0)


def reshape(width: int, height: int) -> None:
    view.size = (width, max(height, 1))
    GL.glViewport(0, 0, *view.size)


def zoom(factor: float) -> None:
    view.distance = min(max(view.distance * factor, 40.0), 500.0)


def keyboard(key: bytes, _x: int, _y: int) -> None:
    if key == b"\x1b":
        GLUT.glutLeaveMainLoop()
    elif key == b" ":
        view.moving = not view.moving
    elif key == b"r":
        view.way = 0.0
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
        view.azimuth += 0.5 * (x - view.grip[0])
        view.elevation = min(max(view.elevation + 0.5 * (y - view.grip[1]), 0.0), 90.0)
        view.grip = (x, y)


def set_up() -> None:
    GL.glClearColor(0.90, 0.92, 0.94, 1.0)
    for switch in (GL.GL_DEPTH_TEST, GL.GL_CULL_FACE, GL.GL_NORMALIZE, GL.GL_LIGHTING,
                   GL.GL_LIGHT0, GL.GL_LIGHT1, GL.GL_COLOR_MATERIAL):  # fmt: skip
        GL.glEnable(switch)
    GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.78, 0.77, 0.74, 1.0))
    GL.glLightfv(GL.GL_LIGHT1, GL.GL_DIFFUSE, (0.20, 0.22, 0.26, 1.0))


def opened(path: Path) -> list[Strand]:
    try:
        return parsed(path.read_text(encoding="utf-8"))
    except UnicodeDecodeError:
        raise BadFile("it is not text") from None
    except OSError as reason:
        raise BadFile(reason.strerror or str(reason)) from None


def main() -> int:
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else PLANTER
    try:
        strands = opened(path)
    except BadFile as reason:
        print(f"{path}: {reason}", file=sys.stderr)
        return 2
    GLUT.glutInit(sys.argv)
    GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE | GLUT.GLUT_RGB | GLUT.GLUT_DEPTH)
    GLUT.glutInitWindowSize(*SIZE)
    GLUT.glutCreateWindow(b"3D printer")
    set_up()
    job = Print(strands)
    view.way = 0.66 * job.reach[-1]  # there is something to see; r begins at the first layer
    GLUT.glutDisplayFunc(lambda: display(job, path.name))
    GLUT.glutReshapeFunc(reshape)
    GLUT.glutKeyboardFunc(keyboard)
    GLUT.glutSpecialFunc(arrows)
    GLUT.glutMouseFunc(mouse)
    GLUT.glutMotionFunc(motion)
    view.seen = GLUT.glutGet(GLUT.GLUT_ELAPSED_TIME) / 1000
    advance(job)
    GLUT.glutMainLoop()
    return 0


if __name__ == "__main__":
    sys.exit(main())
