"""Large and small primitives, one after the other: the same picture to the byte.

Colours that every vertex has are interpolated with other roundings than one for a whole draw, and
Mesa keeps what a primitive said per vertex for the next one until some state changes."""

from __future__ import annotations

import random

import numpy as np
import pytest
from OpenGL import GL

from tests.sweep import FULL, SEED

from .world import App, run

MODES = (GL.GL_TRIANGLES, GL.GL_QUADS, GL.GL_TRIANGLE_STRIP, GL.GL_LINES, GL.GL_POINTS,
         GL.GL_LINE_STRIP)  # fmt: skip
ATTRIBUTES = {
    "colour": lambda: GL.glColor3f(0.3, 0.7, 0.1),
    "alpha": lambda: GL.glColor4f(0.5, 0.2, 0.1, 0.5),
    "normal": lambda: GL.glNormal3f(0.2, 0.5, 0.8),
    "place": lambda: GL.glTexCoord2f(0.3, 0.4),
}
BETWEEN = (
    *(lambda: None,) * 6, ATTRIBUTES["colour"], ATTRIBUTES["alpha"],
    lambda: GL.glLineWidth(2.0), lambda: GL.glEnable(GL.GL_LIGHTING), GL.glPushMatrix,
    lambda: GL.glDisable(GL.GL_LIGHTING), lambda: GL.glEnable(GL.GL_COLOR_MATERIAL),
    lambda: GL.glFogCoordf(0.5),
)  # fmt: skip


def primitive(chance: random.Random) -> None:
    """One, small or large, with some attributes, for each vertex or once."""
    said = [
        ATTRIBUTES[name] for name in chance.sample(sorted(ATTRIBUTES), chance.choice((0, 0, 1, 2)))
    ]
    once, odd = chance.random() < 0.3, chance.random() < 0.05
    points = np.random.default_rng(chance.randrange(9)).uniform(-1, 1, (300, 3))
    GL.glBegin(chance.choice(MODES))
    if odd:
        GL.glSecondaryColor3f(0.1, 0.2, 0.3)
    for k, point in enumerate(points[: chance.choice((3, 5, 30, 130, 150, 300))]):
        if not once or k == 0:
            for say in said:
                say()
        GL.glVertex3d(*point)
    GL.glEnd()


def drawing(number: int, app: App) -> None:
    chance = random.Random(number)
    GL.glEnable(GL.GL_LIGHT0)
    for _ in range(chance.randint(2, 6)):
        chance.choice(BETWEEN)()
        primitive(chance)
    app.asks(GL.GL_CURRENT_COLOR, GL.GL_CURRENT_NORMAL, GL.GL_CURRENT_TEXTURE_COORDS)


@pytest.mark.parametrize("number", range(SEED, SEED + (2000 if FULL else 40)))
def test_none_is_plain(number: int) -> None:
    def draw(app: App) -> None:
        drawing(number, app)

    assert run(draw, None).differences(run(draw, "none")) == {}
