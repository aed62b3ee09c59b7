"""A scene to two pictures: the paper's method as printed, and style raskar."""

from __future__ import annotations

import numpy as np
from OpenGL import GL

from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look
from tests.flaws import paper
from tests.flaws.measure import Picture
from tests.flaws.scenes import SIZE, Scene
from tests.styles import only

_BEHIND = (0.93, 0.93, 0.93)


def both(backend: Backend, scene: Scene) -> tuple[np.ndarray, Picture, np.ndarray, Picture]:
    """Before and after: each (h, w, 3) uint8 with row 0 at the bottom, and what is measured on
    it. The current window is `SIZE` square."""
    plain, depth = _bare(scene)
    look.clear()
    GL.glDepthFunc(GL.GL_LESS)
    paper.draw(scene.behind, shade=_BEHIND)
    quad = scene.quad_width
    if quad is None and scene.ridge_width is not None:
        quad = scene.ridge_width / 2
    paper.draw(
        scene.items,
        silhouette_width=scene.silhouette_width,
        quad_width=quad,
        ridge_angle=scene.ridge_angle,
    )
    before = look.pixels(SIZE, SIZE)
    _bare(scene)
    kinds = {"silhouettes": scene.silhouette_width, "ridges": scene.ridge_width}
    style = only(
        *(kind for kind, width in kinds.items() if width is not None),
        **{f"{kind[:-1]}_width": width for kind, width in kinds.items() if width is not None},
        ridge_angle=scene.ridge_angle,
    )
    backend.render(style.draws(Layer((*scene.behind, *scene.items))))
    after = look.pixels(SIZE, SIZE)
    solid = _solid(scene)
    made = []
    for frame in (before, after):
        ink = np.clip(1.0 - frame.mean(axis=2) / plain.mean(axis=2), 0.0, 1.0)
        made += [frame, Picture(ink, depth, solid, scene.items, scene.ridge_angle)]
    return tuple(made)


def _bare(scene: Scene) -> tuple[np.ndarray, np.ndarray]:
    """Draw the scene without lines: its pixels and depths."""
    look.clear()
    GL.glDepthFunc(GL.GL_LESS)
    for item in scene.behind:
        look.draw_base(*item, shade=_BEHIND)
    for item in scene.items:
        look.draw_base(*item)
    return look.pixels(SIZE, SIZE), look.depths(SIZE, SIZE)


def _solid(scene: Scene) -> np.ndarray:
    """(h, w) bool: where the objects whose lines are asked about are."""
    look.clear()
    for item in scene.items:
        look.draw_base(*item)
    return (look.pixels(SIZE, SIZE) != 255).any(axis=2)
