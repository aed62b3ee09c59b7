"""What a style that wants lights is told of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import ClassVar

import pytest
from OpenGL import GL

from glshim.model.lights import Light, Lighting
from glshim.styling.protocol import Layer, Lines, Pass, Styler

from .world import App, run


@dataclass(frozen=True)
class Asking(Styler):
    """Draws nothing, holds layers."""

    name: ClassVar[str] = "asking"
    layers: list[Layer] = field(default_factory=list)
    lights: bool = True

    @property
    def wants_lights(self) -> bool:
        return self.lights

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        self.layers.append(layer)
        return ()


def triangle(at: float = 0.0) -> None:
    GL.glBegin(GL.GL_TRIANGLES)
    for x, y in ((-0.5, -0.5), (0.5, -0.5), (0, 0.5)):
        GL.glVertex3f(x + at, y, 0)
    GL.glEnd()


def told(scene, lights: bool = True) -> list[Layer]:
    """The layers of a scene."""
    style = Asking(lights=lights)

    def whole(_: App) -> None:
        GL.glClear(GL.GL_DEPTH_BUFFER_BIT)
        scene()

    run(whole, style)
    return style.layers


def test_lights_come_as_the_driver_holds_them():
    def scene() -> None:
        GL.glEnable(GL.GL_LIGHTING)
        GL.glLightModelfv(GL.GL_LIGHT_MODEL_AMBIENT, (0.1, 0.2, 0.3, 1))
        GL.glTranslatef(1, 2, 3)
        GL.glEnable(GL.GL_LIGHT2)
        GL.glLightfv(GL.GL_LIGHT2, GL.GL_POSITION, (1, 0, 0, 1))
        GL.glLightfv(GL.GL_LIGHT2, GL.GL_DIFFUSE, (0.5, 0.25, 0.75, 1))
        GL.glLightfv(GL.GL_LIGHT2, GL.GL_AMBIENT, (0.0, 0.125, 0, 1))
        GL.glLightfv(GL.GL_LIGHT2, GL.GL_SPECULAR, (0, 0, 0.5, 1))
        GL.glLightf(GL.GL_LIGHT2, GL.GL_LINEAR_ATTENUATION, 0.25)
        GL.glLightfv(GL.GL_LIGHT2, GL.GL_SPOT_DIRECTION, (0, 1, 0))
        GL.glLightf(GL.GL_LIGHT2, GL.GL_SPOT_CUTOFF, 30)
        GL.glLightf(GL.GL_LIGHT2, GL.GL_SPOT_EXPONENT, 4)
        triangle()

    (layer,) = told(scene)
    assert layer.lighting is not None
    assert layer.lighting.ambient == pytest.approx((0.1, 0.2, 0.3))
    assert layer.lighting.lights == (
        Light(
            (2, 2, -2, 1), (0, 0.125, 0), (0.5, 0.25, 0.75), (0, 0, 0.5), (1, 0.25, 0), (0, 1, 0),
            30, 4,
        ),
    )  # fmt: skip


def test_an_app_that_moves_a_light_is_seen_in_the_light_it_began_with():
    def scene() -> None:
        triangle()  # not lit
        GL.glEnable(GL.GL_LIGHTING)
        GL.glEnable(GL.GL_LIGHT0)
        for x in (1, 2):
            GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (x, 0, 5, 1))
            triangle(0.5)
        GL.glDisable(GL.GL_LIGHT0)

    (layer,) = told(scene)
    assert layer.lighting is not None
    assert [light.position for light in layer.lighting.lights] == [(1, 0, 0, 1)]


def test_each_layer_has_its_own_lights():
    def scene() -> None:
        GL.glEnable(GL.GL_LIGHTING)
        for light in (GL.GL_LIGHT0, GL.GL_LIGHT1):
            GL.glEnable(light)
            triangle()
            GL.glClear(GL.GL_DEPTH_BUFFER_BIT)
        GL.glDisable(GL.GL_LIGHTING)
        triangle()

    found = [layer.lighting for layer in told(scene)]
    assert [None if one is None else len(one.lights) for one in found] == [1, 2, None]


def test_cameras_say_what_is_lit_and_what_gleams():
    def scene() -> None:
        for lit in (False, True):
            (GL.glEnable if lit else GL.glDisable)(GL.GL_LIGHTING)
            for shine in (0.0, 0.8):
                GL.glMaterialfv(GL.GL_FRONT, GL.GL_SPECULAR, (0, shine, 0, 1))
                triangle()

    (layer,) = told(scene)
    seen = {(camera.lit, camera.gleams) for _, camera in layer.items}
    assert seen == {(False, False), (True, False), (True, True)}
    (layer,) = told(scene, lights=False)
    assert [(camera.lit, camera.gleams) for _, camera in layer.items] == [(False, False)]
    assert layer.lighting is None


def test_cameras_say_what_is_textured():
    def scene() -> None:
        for on in (GL.glEnable, GL.glDisable):
            on(GL.GL_TEXTURE_2D)
            triangle()

    assert [[c.textured for _, c in layer.items] for layer in told(scene)] == [[True, False]]
    assert not any(c.textured for layer in told(scene, lights=False) for _, c in layer.items)


def test_no_light_at_all_is_lighting_too():
    def scene() -> None:
        GL.glEnable(GL.GL_LIGHTING)
        triangle()

    (layer,) = told(scene)
    assert layer.lighting is not None
    assert layer.lighting == Lighting((), layer.lighting.ambient)
