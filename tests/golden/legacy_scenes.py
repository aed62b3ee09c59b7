"""Meshes under style raskar, and drawn by hand, as the contexts of now draw them.

``python -m tests.golden.legacy_scenes OUT`` writes the pictures without and with lines, and who
expanded them.
"""

from __future__ import annotations

import dataclasses
import sys

import numpy as np
from glshim_stylers.raskar import Raskar
from glshim_stylers.shared.hand import Hand, strokes
from OpenGL import GL

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.media.hand import hand, outlines
from glshim.styling.protocol import Layer, Styler
from tests import look

PORT = (0, 0, 400, 400)
LENS = look.perspective()


def star(points=5) -> PolygonBatch:
    """A prism over a star: ridges at its tips, valleys between them."""
    angles = np.pi * np.arange(2 * points) / points
    rim = [((1.2, 0.5)[k % 2] * np.cos(a), (1.2, 0.5)[k % 2] * np.sin(a))
           for k, a in enumerate(angles)]  # fmt: skip
    n = len(rim)
    corners = [(0, 0, z) for z in (-0.6, 0.6)] + [(x, y, z) for z in (-0.6, 0.6) for x, y in rim]
    sides = [[2 + i, 2 + (i + 1) % n, 2 + n + (i + 1) % n, 2 + n + i] for i in range(n)]
    lids = [[0, 2 + (i + 1) % n, 2 + i] for i in range(n)]
    lids += [[1, 2 + n + i, 2 + n + (i + 1) % n] for i in range(n)]
    return look.batch(corners, [*sides, *lids])


@dataclasses.dataclass(frozen=True)
class ByHand(Styler):
    """Strokes of a hand; where it goes is the GPU's to say, but for what it would do at random."""

    hand: Hand

    def draws(self, layer):
        return strokes(self.hand, layer)


def scenes():
    """Style and items by name."""
    style = Raskar(silhouette_width=3, ridge_width=2, valley_width=3, intersections=False)
    for name, make in {**look.MESHES, "teapot": look.teapot, "star": star}.items():
        mesh = make()
        for k, direction in enumerate(look.directions(5)):
            lens = look.orthographic() if k % 2 else LENS
            camera = Camera(look.look_at(5 * direction), lens, PORT, front_ccw=name != "teapot")
            yield f"{name} {k}", style, ((mesh, camera),)
    drawing = Hand(60.0, hand(3.0, widths=outlines(5.0), taper=30.0, tip=80.0))
    for name, mesh in (("cube", look.cube()), ("star", star()), ("cylinder", look.cylinder())):
        for k, direction in enumerate(look.directions(3)):
            camera = Camera(look.look_at(5 * direction), LENS, PORT)
            yield f"{name} by hand {k}", ByHand(drawing), ((mesh, camera),)
    near = Camera(look.look_at((1.3, 0.95, 0.3), (0.0, 0.4, 0.2)), look.perspective(75, near=0.05),
                  PORT)  # fmt: skip
    yield "inside a cube", style, ((look.cube(), near),)
    plain = Camera(look.look_at((3, 2, 2)), LENS, PORT)
    # Asks for intersections, too, and has none.
    wide = Raskar(silhouette_width=12, ridge_width=9, intersections=True)  # unavailable on 2.1
    yield "wide", wide, ((look.cylinder(), plain),)
    paper = dataclasses.replace(style, connectivity=False)
    for name, mesh in (("cube", look.cube()), ("star", star())):
        yield f"{name}, no polygon knows another", paper, ((mesh, plain),)
    far = Camera(look.look_at((3, 2, 2), (0, 0.8, 0)), LENS, PORT)
    yield "two cameras", style, ((look.cube(), plain), (look.torus(), far))
    narrow = Camera(plain.modelview, LENS, (50, 80, 300, 200), scissor=(60, 90, 200, 300),
                    depth_range=(0.2, 0.7))  # fmt: skip
    yield "viewport, scissor box, depth range", style, ((look.torus(), narrow),)


def _without_depth() -> None:
    """Draw into a framebuffer of colours alone from now on."""
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, GL.glGenFramebuffers(1))
    GL.glBindRenderbuffer(GL.GL_RENDERBUFFER, GL.glGenRenderbuffers(1))
    GL.glRenderbufferStorage(GL.GL_RENDERBUFFER, GL.GL_RGBA8, 400, 400)
    GL.glFramebufferRenderbuffer(
        GL.GL_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_RENDERBUFFER,
        GL.glGetIntegerv(GL.GL_RENDERBUFFER_BINDING),
    )  # fmt: skip


def main(out: str) -> None:
    found = {}
    with look.window():
        backend = Backend.attach()
        found["pen"] = np.array(type(backend.pen).__name__)
        for name, style, items in scenes():
            before, after, _ = look.styled(backend, style, *items)
            found[f"{name}|before"], found[f"{name}|after"] = before, after
        _without_depth()
        name, style, items = next(scenes())
        look.clear()
        look.draw_base(*items[0])
        found["no depth buffer|before"] = look.pixels()
        backend.render(style.draws(Layer(items)))
        found["no depth buffer|after"] = look.pixels()
        assert GL.glGetError() == 0
    with look.window(samples=4):
        backend = Backend.attach()
        name, style, items = next(scenes())
        before, after, _ = look.styled(backend, style, *items)
        found["several samples|before"], found["several samples|after"] = before, after
    np.savez_compressed(out, **found)


if __name__ == "__main__":
    main(sys.argv[1])
