"""Paper under everything."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files

from glshim.styling.passes import Body, MeshShader, Pass, State, bodies
from glshim.styling.protocol import Colour, Layer, Uniform
from stylers.edge_mesh.tones import grain

_STATE = State(depth="always", blend="off")
UNDER = -2
"""The sheet: hatching and strokes go over it."""


@dataclass(frozen=True, slots=True)
class Paper:
    """What everything is drawn on."""

    colour: Colour
    tint: float = 0.0
    """Of the program's own colours on its surfaces, 0..1."""
    shade: float = 0.0
    """Of its brightness."""
    tooth: float = 1.0
    """Of the paper's grain."""
    grid: float = 0.0
    """Pixels from line to line of printed paper; 0: plain."""
    rule: Colour = (0.5, 0.5, 0.5)
    """Colour of these lines."""


@cache
def _shader() -> MeshShader:
    tones, here = files("stylers.edge_mesh"), files(__package__)
    vertex, tone = ((tones / f"{name}.glsl").read_text("utf-8") for name in ("recede.vert", "tone"))
    return MeshShader("paper", vertex, tone + (here / "under.frag.glsl").read_text("utf-8"))


def under(paper: Paper, layer: Layer) -> Iterator[Pass]:
    """One pass over every window. A layer over another lies on that one's paper, but for the
    surfaces of a view of its own."""
    if layer.over and not layer.fresh:
        return
    uniforms: dict[str, Uniform] = {
        "paper": paper.colour, "behind": int(not layer.over), "ink": (0.0, 0.0, 0.0),
        "tint": paper.tint, "shade": paper.shade, "grid": paper.grid, "tooth": paper.tooth,
        "rule": paper.rule,
    }  # fmt: skip
    yield Pass(
        _shader(), windows(layer), "screen", state=_STATE, uniforms=uniforms, image=grain(),
        sheet=UNDER,
    )  # fmt: skip


def windows(layer: Layer) -> tuple[Body, ...]:
    """One body for each window of a layer, whose pass goes over all of it."""
    found = {body.camera.viewport: body for body in bodies(layer)}
    return tuple(map(_whole, found.values()))


def _whole(body: Body) -> Body:
    if body.camera.scissor is None and body.camera.depth_range == (0.0, 1.0):
        return body
    return replace(body, camera=replace(body.camera, scissor=None, depth_range=(0.0, 1.0)))
