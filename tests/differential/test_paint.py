"""Surface ``paint``: the app's polygons are what it would draw with its lighting off."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest
from OpenGL import GL, GLU

from glshim.styling.protocol import Layer, Lines, Pass, Styler

from .scenes_state import _fog, _texgen, _texture, mesh
from .world import App, Outcome, run

RED, GREEN = (0.8, 0.2, 0.1, 1.0), (0.1, 0.6, 0.3, 1.0)


@dataclass(frozen=True)
class Painting(Styler):
    """Paint and nothing over it."""

    name: ClassVar[str] = "painting"
    textures: bool = True

    @property
    def surface(self) -> str:
        return "paint" if self.textures else "colours"

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        return ()


def light(on: bool) -> None:
    """A light that would show, if lighting is on."""
    GL.glEnable(GL.GL_LIGHT0)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (1, 2, 3, 0))
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.5, 0.9, 0.2, 1))
    (GL.glEnable if on else GL.glDisable)(GL.GL_LIGHTING)


def paint(lit: bool, shade: tuple[float, ...], face: int = GL.GL_FRONT_AND_BACK) -> None:
    """The same paint with lighting and without."""
    if lit:
        GL.glMaterialfv(face, GL.GL_DIFFUSE, shade)
    else:
        GL.glColor4f(*shade)


def strip(size: float = 1.0) -> None:
    """Bent, with normals that would shade it."""
    GL.glBegin(GL.GL_QUAD_STRIP)
    for x in np.linspace(-1.2, 1.2, 9) * size:
        GL.glNormal3f(x, 0.2, 1.0)
        for y in (-0.9, 0.9):
            GL.glTexCoord2f(x, y)
            GL.glVertex3f(x, y * size, -x * x)
    GL.glEnd()


def material(lit: bool) -> None:
    paint(lit, RED)
    strip()
    paint(lit, GREEN)
    GL.glTranslatef(0, 0, 0.5)
    strip(0.5)


def material_and_a_colour_that_is_not_meant(lit: bool) -> None:
    GL.glColor3f(0, 0, 1)
    paint(lit, RED)
    strip()


def colour_material(lit: bool) -> None:
    if lit:
        GL.glColorMaterial(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT_AND_DIFFUSE)
        GL.glEnable(GL.GL_COLOR_MATERIAL)
    mesh(40)


def colour_material_of_the_ambient_alone(lit: bool) -> None:
    paint(lit, GREEN)
    if lit:
        GL.glColorMaterial(GL.GL_FRONT, GL.GL_AMBIENT)
        GL.glEnable(GL.GL_COLOR_MATERIAL)
        GL.glColor3f(1, 0, 1)
    strip()


def texture(lit: bool) -> None:
    _texture()
    GL.glMatrixMode(GL.GL_TEXTURE)
    GL.glScalef(1.5, 0.7, 1.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    paint(lit, RED)
    strip()


def sphere_map(lit: bool) -> None:
    _texgen()
    paint(lit, (1, 1, 1, 1))
    strip()


def planes(lit: bool) -> None:
    _texture()
    GL.glTexGeni(GL.GL_S, GL.GL_TEXTURE_GEN_MODE, GL.GL_OBJECT_LINEAR)
    GL.glTexGenfv(GL.GL_S, GL.GL_OBJECT_PLANE, (0.5, 0.5, 0, 0.1))
    GL.glTexGeni(GL.GL_T, GL.GL_TEXTURE_GEN_MODE, GL.GL_EYE_LINEAR)
    GL.glTexGenfv(GL.GL_T, GL.GL_EYE_PLANE, (0, 0.4, 0.2, 0))
    GL.glEnable(GL.GL_TEXTURE_GEN_S)
    GL.glEnable(GL.GL_TEXTURE_GEN_T)
    paint(lit, (1, 1, 1, 1))
    strip()


def fog(lit: bool) -> None:
    _fog()
    paint(lit, RED)
    strip()


def clipped(lit: bool) -> None:
    GL.glClipPlane(GL.GL_CLIP_PLANE0, (1, 0.5, 0, 0.1))
    GL.glEnable(GL.GL_CLIP_PLANE0)
    paint(lit, RED)
    strip()


def a_list_with_materials(lit: bool) -> None:
    GL.glNewList(1, GL.GL_COMPILE)
    material(lit)
    GL.glEndList()
    GL.glCallList(1)


def a_quadric(lit: bool) -> None:
    paint(lit, GREEN)
    GLU.gluSphere(GLU.gluNewQuadric(), 0.9, 16, 12)


def arrays(lit: bool) -> None:
    points = np.array([(-1, -1, 0), (1, -1, -1), (1, 1, 0), (-1, 1, 1)], np.float32)
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, points)
    paint(lit, RED)
    GL.glDrawArrays(GL.GL_QUADS, 0, 4)


def flat(lit: bool) -> None:
    GL.glShadeModel(GL.GL_FLAT)
    colour_material(lit)


def two_passes(lit: bool) -> None:
    """The second only where its depth is equal: vertices must not move."""
    paint(lit, RED)
    strip()
    GL.glDepthFunc(GL.GL_EQUAL)
    GL.glDisable(GL.GL_LIGHTING)
    GL.glColor4f(0, 0, 0.8, 1)
    GL.glEnable(GL.GL_BLEND)
    GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)
    GL.glDepthMask(0)
    strip()


def varied(lit: bool, parameter: int = GL.GL_DIFFUSE, face: int = GL.GL_FRONT_AND_BACK) -> None:
    """The paint of each quad, and of one corner, is set inside the primitive."""
    GL.glNormal3f(0.3, 0.2, 0.9)
    GL.glBegin(GL.GL_QUADS)
    for k, shade in enumerate((RED, GREEN, (0.2, 0.3, 0.9, 1.0), (0.9, 0.9, 0.2, 1.0))):
        if lit:
            GL.glMaterialfv(face, parameter, shade)
            GL.glMaterialfv(GL.GL_FRONT, GL.GL_SPECULAR, (0.5, 0.5, 0.5, 1))
        else:
            GL.glColor4f(*shade)
        for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
            GL.glTexCoord2f(u, v)
            GL.glVertex3f(0.6 * (k + u) - 1.2, v - 0.5, 0.1 * k)
            if k == 2 and u and not v:
                paint_inside(lit, RED, parameter)
    GL.glEnd()


def paint_inside(lit: bool, shade: tuple[float, ...], parameter: int) -> None:
    if lit:
        GL.glMaterialfv(GL.GL_FRONT_AND_BACK, parameter, shade)
    else:
        GL.glColor4f(*shade)


def diffuse_inside(lit: bool) -> None:
    paint(lit, GREEN)
    varied(lit)
    if lit:
        # What is ambient now is not what the paint is.
        GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT, (1, 0, 0, 1))
    GL.glTranslatef(0, 0, 0.5)
    varied(lit)


def ambient_and_diffuse_inside(lit: bool) -> None:
    _texture()
    _fog()
    varied(lit, GL.GL_AMBIENT_AND_DIFFUSE)


def ambient_inside_says_nothing(lit: bool) -> None:
    paint(lit, RED)
    GL.glBegin(GL.GL_TRIANGLES)
    for k, (x, y) in enumerate(((-0.8, -0.8), (0.8, -0.8), (0, 0.8))):
        if lit:
            GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT, (k, 0, 1, 1))
        GL.glVertex3f(x, y, 0)
    GL.glEnd()


def integers_inside(lit: bool) -> None:
    GL.glBegin(GL.GL_TRIANGLES)
    if lit:
        GL.glMaterialiv(GL.GL_FRONT, GL.GL_DIFFUSE, (2**31 - 1, 0, 2**30, 2**31 - 1))
    else:
        GL.glColor4f(1.0, 0.0, 0.5, 1.0)
    for x, y in ((-0.8, -0.8), (0.8, -0.8), (0, 0.8)):
        GL.glVertex3f(x, y, 0)
    GL.glEnd()


def a_list_with_materials_inside(lit: bool) -> None:
    GL.glNewList(1, GL.GL_COMPILE)
    varied(lit, GL.GL_AMBIENT_AND_DIFFUSE)
    GL.glEndList()
    GL.glNewList(2, GL.GL_COMPILE)
    GL.glCallList(1)
    GL.glEndList()
    GL.glCallLists([2])


def a_list_that_turns_colour_material_on(lit: bool) -> None:
    GL.glNewList(1, GL.GL_COMPILE)
    if lit:
        GL.glEnable(GL.GL_COLOR_MATERIAL)
    mesh(40)
    GL.glEndList()
    GL.glCallList(1)


SCENES: tuple[Callable[[bool], None], ...] = (
    material, material_and_a_colour_that_is_not_meant, colour_material,
    colour_material_of_the_ambient_alone, texture, sphere_map, planes, fog, clipped,
    a_list_with_materials, a_quadric, arrays, flat, two_passes, diffuse_inside,
    ambient_and_diffuse_inside, ambient_inside_says_nothing, integers_inside,
    a_list_with_materials_inside, a_list_that_turns_colour_material_on,
)  # fmt: skip


def outcome(scene: Callable[[bool], None], lit: bool, style: Styler | None) -> Outcome:
    def whole(_: App) -> None:
        light(lit)
        scene(lit)

    return run(whole, style)


def apart(one: Outcome, other: Outcome) -> int:
    """The greatest difference of a channel."""
    return int(np.abs(one.picture.astype(int) - other.picture).max())


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_paint_is_what_the_app_draws_without_light(scene: Callable[[bool], None]) -> None:
    lit, unlit = outcome(scene, True, None), outcome(scene, False, None)
    painted = outcome(scene, True, Painting())
    assert apart(painted, unlit) <= 1
    assert apart(lit, unlit) > 20  # the scene would show the difference
    assert lit.differences(painted, pictures=False) == {}


def test_what_is_not_lit_stays_as_it_is() -> None:
    plain = outcome(texture, False, None)
    assert plain.differences(outcome(texture, False, Painting())) == {}


def test_both_sides_have_their_own_paint() -> None:
    def scene(_: App) -> None:
        light(True)
        GL.glLightModeli(GL.GL_LIGHT_MODEL_TWO_SIDE, 1)
        GL.glMaterialfv(GL.GL_FRONT, GL.GL_DIFFUSE, (1, 0, 0, 1))
        GL.glMaterialfv(GL.GL_BACK, GL.GL_DIFFUSE, (0, 1, 0, 1))
        for turn in (1, -1):
            GL.glBegin(GL.GL_TRIANGLES)
            for x, y in ((0.2, -0.8), (1.2, -0.8), (0.2, 0.8)):
                GL.glVertex3f(turn * x, y, 0)
            GL.glEnd()

    picture = run(scene, Painting()).picture[..., :3].reshape(-1, 3)
    seen = {tuple(map(int, colour)) for colour in picture}
    assert {(255, 0, 0), (0, 255, 0)} <= seen
    assert run(scene).differences(run(scene, Painting()), pictures=False) == {}


def test_colours_are_without_textures_and_light() -> None:
    def scene(_: App) -> None:
        light(True)
        _texture()
        paint(True, RED)
        strip()
        GL.glDisable(GL.GL_LIGHTING)
        GL.glColor4f(*GREEN)
        GL.glTranslatef(0, 0, 0.5)
        strip(0.5)

    picture = run(scene, Painting(textures=False)).picture[..., :3].reshape(-1, 3)
    seen = {tuple(map(int, colour)) for colour in picture}
    paints = np.array([(204, 51, 26), (26, 153, 77), (128, 128, 128)])
    nearest = np.abs(np.array(sorted(seen))[:, None] - paints).max(axis=2)
    assert nearest.min(axis=1).max() <= 1  # nothing else
    assert nearest.min(axis=0).max() <= 1  # all of them
    assert run(scene).differences(run(scene, Painting(textures=False)), pictures=False) == {}
