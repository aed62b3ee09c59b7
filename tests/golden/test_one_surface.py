"""What is one surface has no lines in it, however a program cuts it into polygons and bodies:
small fixed-function programs under every style that draws lines."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import pairwise, product

import numpy as np
import pytest
from OpenGL import GL, GLU

import glshim
from tests.differential.world import window
from tests.sweep import some

SIZE = 300
EYE = (3.0, 2.2, 4.0)
STYLES = (
    "raskar", "edge_mesh", "edge_mesh:strokes=quads", "crease", "fins:ridges=on",
    "cartoon:shade_unlit=off", "technical:paper=app,hidden=none",
    "hiddenline:paper=app,fill=app", "brush", "pencil",
    "blueprint:dimensions=0", "sketch:hatching=0",
)  # fmt: skip
BY_HAND = ("brush", "pencil", "blueprint", "sketch")
Draw = Callable[[], None]


@pytest.fixture(scope="module")
def view() -> Iterator[None]:
    with window(SIZE, SIZE):
        yield


def camera() -> None:
    GL.glViewport(0, 0, SIZE, SIZE)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(40.0, 1.0, 0.1, 100.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GLU.gluLookAt(*EYE, 0, 0, 0, 0, 1, 0)


def picture(style: str, draw: Draw) -> np.ndarray:
    """(H, W) darkness 0..1 of a scene in a style, lit by nothing, grey on white."""
    camera()
    GL.glClearColor(1.0, 1.0, 1.0, 1.0)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glColor3f(0.8, 0.8, 0.8)
    with glshim.style(style) as styled:
        draw()
        found = styled.image()
    return np.asarray(found.astype(float) / 255.0)


def changed(style: str, one: Draw, other: Draw) -> np.ndarray:
    """(H, W) pixels at which two scenes differ in a style, but for what a hand does along lines
    that both have."""
    apart = np.abs(picture(style, one) - picture(style, other)).max(axis=2) > 0.15
    near = np.abs(picture("raskar", other) - picture("none", other)).max(axis=2) > 0.1
    if style.partition(":")[0] in BY_HAND:
        for _ in range(5):
            near = np.pad(near, 1)
            near = np.any([near[1 + i : 1 + i + SIZE, 1 + j : 1 + j + SIZE]
                           for i in (-1, 0, 1) for j in (-1, 0, 1)], axis=0)  # fmt: skip
        apart &= ~near
    return apart


def polygon(*corners: tuple[float, float, float]) -> None:
    GL.glBegin(GL.GL_POLYGON)
    for corner in corners:
        GL.glVertex3f(*corner)
    GL.glEnd()


def back() -> None:
    """The three sides of a cube that are not seen."""
    polygon((1, -1, -1), (-1, -1, -1), (-1, 1, -1), (1, 1, -1))
    polygon((-1, -1, -1), (-1, -1, 1), (-1, 1, 1), (-1, 1, -1))
    polygon((-1, -1, -1), (1, -1, -1), (1, -1, 1), (-1, -1, 1))


def whole() -> None:
    polygon((-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))
    polygon((1, -1, 1), (1, -1, -1), (1, 1, -1), (1, 1, 1))
    polygon((-1, 1, 1), (1, 1, 1), (1, 1, -1), (-1, 1, -1))
    back()


def cut() -> None:
    """The same cube as a program that joins solids leaves it: sides along several others'."""
    third = 1.0 / 3.0
    for x, end in ((-1.0, -third), (-third, 0.4), (0.4, 1.0)):
        polygon((x, -1, 1), (end, -1, 1), (end, 1, 1), (x, 1, 1))
    polygon((1, -1, 1), (1, -1, -1), (1, 0.25, -1), (1, 0.25, 1))
    polygon((1, 0.25, 1), (1, 0.25, third), (1, 1, third), (1, 1, 1))
    polygon((1, 0.25, third), (1, 0.25, -1), (1, 1, -1), (1, 1, third))
    polygon((-1, 1, 1), (0, 1, 1), (0, 1, -1), (-1, 1, -1))
    for a, b in (((0, 1, 1), (1, 1, 1)), ((1, 1, 1), (1, 1, -1)), ((1, 1, -1), (0, 1, -1))):
        polygon(a, b, (0, 1, 0.1))  # a side of the quad's along two of theirs
    back()


def sheet(*steps: int) -> None:
    """A curved sheet of patches, one above the other, each tessellated by itself."""
    for row, count in enumerate(steps):
        low, high = -1.0 + 2.0 * row / len(steps), -1.0 + 2.0 * (row + 1) / len(steps)
        GL.glBegin(GL.GL_QUAD_STRIP)
        for turn in np.linspace(1.0, -1.0, count + 1):
            x, z = 1.4 * np.sin(turn), 1.4 * np.cos(turn) - 0.6
            GL.glVertex3f(x, low, z)
            GL.glVertex3f(x, high, z)
        GL.glEnd()


@pytest.mark.parametrize("style", some(STYLES, 5))
def test_a_cut_face_is_one_face(view: None, style: str) -> None:
    assert changed(style, cut, whole).mean() < 0.002


@pytest.mark.parametrize("style", some(STYLES, 5, 1))
def test_patches_tessellated_apart_are_one_sheet(view: None, style: str) -> None:
    apart = changed(style, partial(sheet, 24, 16), partial(sheet, 24))
    assert apart.mean() < 0.003


def box(x: float, y: float, z: float, half: float = 0.5) -> None:
    """A cube by itself, under a matrix of its own."""
    GL.glPushMatrix()
    GL.glTranslatef(x, y, z)
    GL.glScalef(half, half, half)
    whole()
    GL.glPopMatrix()


def cubes() -> None:
    """The same cube as eight."""
    for corner in product((-0.5, 0.5), repeat=3):
        box(*corner)


def capsule(parts: int) -> None:
    """A cylinder closed by two spheres, each under a matrix of its own; 1: all their polygons are
    one body's."""
    quadric = GLU.gluNewQuadric()
    GLU.gluQuadricNormals(quadric, GLU.GLU_NONE)
    GL.glPushMatrix()
    GL.glRotatef(-90.0, 1.0, 0.0, 0.0)
    GL.glTranslatef(0.0, 0.0, -0.6)
    if parts > 1:
        GLU.gluCylinder(quadric, 0.6, 0.6, 1.2, 24, 1)
        for _ in range(2):
            GLU.gluSphere(quadric, 0.6, 24, 16)
            GL.glTranslatef(0.0, 0.0, 1.2)
    else:
        turns = np.linspace(0.0, 2.0 * np.pi, 25)
        profile = [(0.6 * np.cos(a), 0.6 * np.sin(a) + (1.2 if a > 0 else 0.0))
                   for a in np.linspace(-np.pi / 2, np.pi / 2, 17) for _ in range(1)]  # fmt: skip
        middle = [(0.6, 0.0), (0.6, 1.2)]
        profile = [p for p in profile if p[1] < 0.0] + middle + [p for p in profile if p[1] > 1.2]
        for (r, z), (s, w) in pairwise(profile):
            GL.glBegin(GL.GL_QUAD_STRIP)
            for a in turns:
                GL.glVertex3f(s * np.sin(a), s * np.cos(a), w)
                GL.glVertex3f(r * np.sin(a), r * np.cos(a), z)
            GL.glEnd()
    GL.glPopMatrix()
    GLU.gluDeleteQuadric(quadric)


SEEN = tuple(style for style in STYLES if "strokes=quads" not in style)
"""All but the one that draws what the mesh says, as its paper does."""


@pytest.mark.parametrize("style", some(SEEN, 5, 2))
def test_a_wall_of_cubes_is_one_face(view: None, style: str) -> None:
    """Eight bodies side by side, each under a matrix of its own."""
    assert changed(style, cubes, whole).mean() < 0.002


@pytest.mark.parametrize("style", some(SEEN, 5, 3))
def test_bodies_that_touch_along_a_curve_are_one(view: None, style: str) -> None:
    assert changed(style, partial(capsule, 3), partial(capsule, 1)).mean() < 0.002


@pytest.mark.parametrize("hidden", ["dimmed", "solid"])
def test_a_wall_of_cubes_has_no_hidden_lines_inside(view: None, hidden: str) -> None:
    style = f"technical:paper=app,hidden={hidden}"
    assert changed(style, cubes, whole).mean() < 0.002


def test_inner_faces_of_a_wall_are_not_hatched(view: None) -> None:
    """They lie edge on in the face that is seen."""

    def wall() -> None:
        GL.glLoadIdentity()
        GLU.gluLookAt(0.1, 0.0, 4.0, 0.1, 0.0, 0.0, 0.0, 1.0, 0.0)
        for x in range(-2, 3):
            box(float(x), 0.0, 0.0)
        at.append([int(GLU.gluProject(x + 0.5, 0.0, 0.5)[0]) for x in range(-2, 2)])

    at: list[list[int]] = []
    with_, without = (
        picture(style, wall).mean(axis=2) for style in ("sketch:hatching=1", "sketch:hatching=0")
    )
    drawn = np.maximum(without - with_, 0.0)[120:180].mean(axis=0)
    assert drawn.mean() > 0.01
    for seam in at[0]:
        if 20 < seam < SIZE - 20:
            beside = drawn[seam - 20 : seam + 21].mean()
            assert drawn[seam - 2 : seam + 3].max() < 2.0 * beside


def crossing() -> None:
    whole()
    GL.glPushMatrix()
    GL.glTranslatef(0.0, 0.0, 0.9)
    GL.glRotatef(45.0, 0.0, 0.0, 1.0)
    GL.glScalef(0.4, 0.4, 0.4)
    whole()
    GL.glPopMatrix()


ALL = ("raskar", "edge_mesh", "edge_mesh:strokes=quads", "crease", "fins", "two_pass", "cartoon",
       "technical", "hiddenline", "brush", "pencil", "blueprint", "sketch")  # fmt: skip


@pytest.mark.parametrize("style", some(ALL, 6))
def test_every_line_style_has_lines_where_surfaces_cross(view: None, style: str) -> None:
    """By one option. The lines are looked for halfway along the four of a post in a face."""
    between = ":" if ":" not in style else ","
    with_, without = (
        picture(f"{style}{between}intersections={word}", crossing) for word in ("on", "off")
    )
    drawn = np.abs(with_ - without).max(axis=2) > 0.1
    found = 0
    reach = 0.4 * 2**0.5 / 2
    for x, y in product((-reach, reach), repeat=2):
        at = GLU.gluProject(x, y, 1.0)
        column, row = int(at[0]), SIZE - 1 - int(at[1])
        found += drawn[row - 4 : row + 5, column - 4 : column + 5].any()
    assert found >= 2, style  # the post hides the others
