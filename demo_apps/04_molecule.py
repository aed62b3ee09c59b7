"""Molecules as balls and sticks: pygame, GLU quadrics, a legend in an orthographic overlay.

Caffeine has its measured shape; buckminsterfullerene and benzene are made from their geometry.
Atoms have the colours of Corey, Pauling and Koltun, double bonds are two sticks. Drag to turn,
wheel or +/- to zoom, 1 2 3 choose a molecule, s fills the atoms up, space stops it, ESC leaves.
"""

import math
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import pygame
from numpy.typing import NDArray
from OpenGL import GL, GLU

SIZE = (640, 480)
Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Element:
    """Colour, covalent and van der Waals radius in angstroms."""

    name: str
    colour: tuple[float, float, float]
    covalent: float
    outer: float


ELEMENTS = {
    "H": Element("hydrogen", (0.94, 0.94, 0.94), 0.31, 1.20),
    "C": Element("carbon", (0.36, 0.37, 0.39), 0.76, 1.70),
    "N": Element("nitrogen", (0.20, 0.36, 0.86), 0.71, 1.55),
    "O": Element("oxygen", (0.88, 0.16, 0.14), 0.66, 1.52),
}
CAFFEINE = """
O  0.470  2.569  0.001  O -3.127 -0.444  0.000  N -0.969 -1.313  0.000  N  2.218  0.141  0.000
N -1.348  1.080  0.000  N  1.412 -1.937  0.000  C  0.858  0.259 -0.001  C  0.390 -1.026  0.000
C  0.031  1.422 -0.001  C -1.906 -0.250  0.000  C  2.503 -1.200  0.000  C -1.428 -2.696  0.001
C  3.193  1.206  0.000  C -2.297  2.188  0.001  H  3.516 -1.579  0.001  H -1.045 -3.197 -0.894
H -2.519 -2.760  0.001  H -1.045 -3.196  0.896  H  4.199  0.780  0.000  H  3.047  1.809 -0.899
H  3.047  1.808  0.900  H -1.809  3.165  0.000  H -2.932  2.103  0.888  H -2.935  2.102 -0.885
"""
DOUBLE = {("C", "O"): 1.30, ("C", "C"): 1.40, ("C", "N"): 1.33}  # shorter bonds are double


@dataclass(frozen=True)
class Molecule:
    """Symbols, positions (atoms, 3) in angstroms, and bonds (first, second, order)."""

    name: str
    symbols: list[str]
    positions: Floats
    bonds: list[tuple[int, int, int]] = field(default_factory=list)

    @property
    def formula(self) -> str:
        """After Hill: carbon, hydrogen, then the alphabet."""
        order = sorted(Counter(self.symbols).items(), key=lambda e: ("CH".find(e[0]) % 3, e[0]))
        return " ".join(f"{symbol}{count if count > 1 else ''}" for symbol, count in order)

    @property
    def radius(self) -> float:
        return float(np.linalg.norm(self.positions, axis=1).max())


def bonded(name: str, symbols: list[str], positions: Floats,
           double: Callable[[tuple[str, str], float, tuple[int, int]], bool]) -> Molecule:
    """A molecule with a bond wherever two atoms are near enough to share electrons."""
    positions = positions - positions.mean(axis=0)
    bonds = []
    for i in range(len(symbols)):
        for k in range(i + 1, len(symbols)):
            length = float(np.linalg.norm(positions[i] - positions[k]))
            reach = ELEMENTS[symbols[i]].covalent + ELEMENTS[symbols[k]].covalent
            if length < 1.2 * reach:
                first, second = sorted((symbols[i], symbols[k]))
                bonds.append((i, k, 1 + double((first, second), length, (i, k))))
    return Molecule(name, symbols, positions, bonds)


def caffeine() -> Molecule:
    words = CAFFEINE.split()
    positions = np.array([[float(w) for w in words[i + 1 : i + 4]] for i in range(0, 96, 4)])
    return bonded("Caffeine", words[::4], positions,
                  lambda pair, length, _: length < DOUBLE.get(pair, 0.0))  # fmt: skip


def fullerene() -> Molecule:
    """C60: an icosahedron without its corners; what is left of its edges is the double bonds."""
    golden = (1 + math.sqrt(5)) / 2
    single, double = 1.45, 1.40
    size = single + double / 2  # half of an edge of the icosahedron
    corners = size * np.array([np.roll((0.0, a, b * golden), k)
                               for k in range(3) for a in (-1, 1) for b in (-1, 1)])  # fmt: skip
    cut = single / size / 2
    points = [a + cut * (b - a) for a in corners for b in corners
              if 1.9 * size < np.linalg.norm(a - b) < 2.1 * size]  # fmt: skip
    return bonded("Buckminsterfullerene", ["C"] * 60, np.array(points),
                  lambda _pair, length, _: length < 1.42)  # fmt: skip


def benzene() -> Molecule:
    turn = np.pi * np.arange(6) / 3
    ring = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    return bonded("Benzene", ["C"] * 6 + ["H"] * 6, np.concatenate([1.39 * ring, 2.48 * ring]),
                  lambda _pair, _length, atoms: atoms in {(0, 1), (2, 3), (4, 5)})


MOLECULES = (caffeine, fullerene, benzene)


def material(colour: tuple[float, ...]) -> None:
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT_AND_DIFFUSE, (*colour, 1.0))


def draw_stick(start: Floats, end: Floats, radius: float, aside: Floats) -> None:
    """Half a bond: a cylinder from an atom to the middle."""
    along = end - start
    length = float(np.linalg.norm(along))
    axis = np.cross((0.0, 0.0, 1.0), along)
    angle = math.degrees(math.acos(float(along[2]) / length))
    quadric = GLU.gluNewQuadric()
    GL.glPushMatrix()
    GL.glTranslatef(*(start + aside))
    GL.glRotatef(angle, *(axis if np.linalg.norm(axis) > 1e-9 else (1.0, 0.0, 0.0)))
    GLU.gluCylinder(quadric, radius, radius, length, 20, 1)
    GL.glPopMatrix()
    GLU.gluDeleteQuadric(quadric)


def draw_bonds(molecule: Molecule) -> None:
    for first, second, order in molecule.bonds:
        a, b = molecule.positions[[first, second]]
        middle = (a + b) / 2
        out = np.cross(b - a, (0.0, 0.0, 1.0))
        if order == 2 and np.linalg.norm(middle) > 1e-9 and abs(middle[2]) > 0.3:
            out = np.cross(b - a, middle)  # the two sticks lie side by side on a cage
        out = out / max(float(np.linalg.norm(out)), 1e-9)
        radius = 0.12 if order == 1 else 0.075
        for shift in (0.0,) if order == 1 else (-0.13, 0.13):
            for atom, start in ((first, a), (second, b)):
                material(ELEMENTS[molecule.symbols[atom]].colour)
                draw_stick(start, middle, radius, shift * out)


def draw_atoms(molecule: Molecule, filled: bool) -> None:
    quadric = GLU.gluNewQuadric()
    for symbol, position in zip(molecule.symbols, molecule.positions, strict=True):
        element = ELEMENTS[symbol]
        material(element.colour)
        GL.glPushMatrix()
        GL.glTranslatef(*position)
        GLU.gluSphere(quadric, element.outer if filled else 0.26 * element.outer, 28, 18)
        GL.glPopMatrix()
    GLU.gluDeleteQuadric(quadric)


def compiled(draw: Callable[[], None]) -> int:
    """A display list of what `draw` draws."""
    name = GL.glGenLists(1)
    GL.glNewList(name, GL.GL_COMPILE)
    draw()
    GL.glEndList()
    return int(name)


class Model:
    """A molecule, its two lists, and the words of its legend as pictures."""

    def __init__(self, molecule: Molecule) -> None:
        self.molecule = molecule
        self.filled = compiled(lambda: draw_atoms(molecule, True))
        self.sticks = compiled(lambda: (draw_bonds(molecule), draw_atoms(molecule, False))[0])
        big, small = pygame.font.Font(None, 34), pygame.font.Font(None, 22)
        self.title = words(big, molecule.name)
        self.formula = words(small, molecule.formula)
        self.elements = [(ELEMENTS[s], words(small, ELEMENTS[s].name))
                         for s in sorted(set(molecule.symbols))]  # fmt: skip


Words = tuple[bytes, int, int]  # RGBA rows from the bottom, width, height


def words(font: pygame.font.Font, text: str) -> Words:
    surface = font.render(text, True, (36, 40, 52))
    return pygame.image.tobytes(surface, "RGBA", True), *surface.get_size()


def write(x: float, y: float, text: Words) -> None:
    GL.glRasterPos2f(x, y)
    GL.glDrawPixels(text[1], text[2], GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, text[0])


def draw_legend(model: Model) -> None:
    """Name, formula, and a disc for each element, in window coordinates."""
    GL.glPushAttrib(GL.GL_ENABLE_BIT)
    for switch in (GL.GL_LIGHTING, GL.GL_DEPTH_TEST):
        GL.glDisable(switch)
    GL.glEnable(GL.GL_BLEND)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GL.glOrtho(0, SIZE[0], 0, SIZE[1], -1, 1)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    write(18, SIZE[1] - 40, model.title)
    write(18, SIZE[1] - 62, model.formula)
    for k, (element, name) in enumerate(model.elements):
        y = 24 + 24 * k
        for radius, colour in ((8.5, (0.14, 0.16, 0.20)), (7.5, element.colour)):
            GL.glColor3fv(colour)
            GL.glBegin(GL.GL_TRIANGLE_FAN)
            for step in range(24):
                a = 2 * math.pi * step / 24
                GL.glVertex2f(28 + radius * math.cos(a), y + radius * math.sin(a))
            GL.glEnd()
        write(44, y - 7, name)
    GL.glPopAttrib()


@dataclass
class View:
    azimuth: float = 18.0
    elevation: float = 34.0
    zoom: float = 1.0
    filled: bool = False
    moving: bool = True
    chosen: int = 0


def handle(event: pygame.event.Event, view: View) -> bool:
    """Whether the program goes on."""
    if event.type == pygame.QUIT:
        return False
    if event.type == pygame.KEYDOWN:
        if event.key == pygame.K_ESCAPE:
            return False
        view.moving ^= event.key == pygame.K_SPACE
        view.filled ^= event.key == pygame.K_s
        if event.unicode and event.unicode in "123":
            view.chosen = int(event.unicode) - 1
        elif event.unicode and event.unicode in "+=-":
            view.zoom *= 0.9 if event.unicode == "-" else 1 / 0.9
    elif event.type == pygame.MOUSEMOTION and event.buttons[0]:
        view.azimuth += 0.5 * event.rel[0]
        view.elevation += 0.5 * event.rel[1]
    elif event.type == pygame.MOUSEWHEEL:
        view.zoom *= 0.9**-event.y
    view.zoom = min(max(view.zoom, 0.4), 4.0)
    return True


def set_up() -> None:
    GL.glClearColor(0.93, 0.94, 0.90, 1.0)
    for switch in (GL.GL_DEPTH_TEST, GL.GL_CULL_FACE, GL.GL_NORMALIZE, GL.GL_LIGHTING,
                   GL.GL_LIGHT0, GL.GL_LIGHT1):  # fmt: skip
        GL.glEnable(switch)
    GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (-4.0, 6.0, 7.0, 0.0))
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.78, 0.77, 0.74, 1.0))
    GL.glLightfv(GL.GL_LIGHT1, GL.GL_POSITION, (6.0, -2.0, 3.0, 0.0))
    GL.glLightfv(GL.GL_LIGHT1, GL.GL_DIFFUSE, (0.20, 0.22, 0.28, 1.0))
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_SPECULAR, (0.55, 0.55, 0.55, 1.0))
    GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, 60.0)


def draw(model: Model, view: View) -> None:
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(30.0, SIZE[0] / SIZE[1], 1.0, 100.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.0, -(4.1 * model.molecule.radius + 1.5) / view.zoom)
    GL.glRotatef(view.elevation - 90.0, 1.0, 0.0, 0.0)
    GL.glRotatef(view.azimuth, 0.0, 0.0, 1.0)
    GL.glCallList(model.filled if view.filled else model.sticks)
    draw_legend(model)
    pygame.display.flip()


def main() -> None:
    pygame.display.init()
    pygame.font.init()
    pygame.display.set_mode(SIZE, pygame.OPENGL | pygame.DOUBLEBUF)
    pygame.display.set_caption("Molecule")
    set_up()
    models: dict[int, Model] = {}  # each made when it is first asked for
    view, clock = View(), pygame.time.Clock()
    last = pygame.time.get_ticks()
    while all([handle(event, view) for event in pygame.event.get()]):
        now = pygame.time.get_ticks()
        view.azimuth += view.moving * 0.02 * (now - last)
        last = now
        if view.chosen not in models:
            models[view.chosen] = Model(MOLECULES[view.chosen]())
        draw(models[view.chosen], view)
        clock.tick(60)
    pygame.quit()


if __name__ == "__main__":
    main()
