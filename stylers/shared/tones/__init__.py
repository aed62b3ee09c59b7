"""Tones: how surfaces are laid in under the lines, and the paper behind them.

M. McGuire, J. F. Hughes, "Hardware-Determined Feature Edges", NPAR 2004, figure 7: pen and ink,
charcoal, anime and watercolour differ in their strokes and in the fill of the mesh. Here the fill
is a pass over the app's finished picture, so every program's own colours and light are kept.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache, lru_cache

import numpy as np
from numpy.random import default_rng

from glshim.model.boxes import Box, overlap, without
from glshim.model.camera import Camera
from glshim.styling.glsl import glsl
from glshim.styling.passes import MeshShader, Pass, State, Weld
from glshim.styling.pictures import Image
from glshim.styling.screen import SCREEN
from glshim.styling.textures.fields import Doubles, even, noise
from glshim.styling.values import Body, Colour, Layer, Uniform

from ..held import HELD, held

TONES = ("paper", "hatch", "grain", "cel", "wash")
BY_LIGHT = ("hatch",)
"""Tones by the light, for styles that want lights: what has none is laid in evenly."""
WHITE: Colour = (0.985, 0.975, 0.95)
"""The paper of tones where the background stays the app's."""
_SIDE = 512
"""Pixels after which the paper's grain repeats."""
_STATE = State(depth="always", blend="off")
_UNDER = -1
"""The coat: lines go over it."""


def tone_shader(name: str, fragment: str, *, on_object: bool = False) -> MeshShader:
    """A shader over the pixels of a window: a fragment text that follows ``tone.glsl``, and with
    on_object ``held.glsl``."""
    text = glsl(__file__, "tone") + (HELD if on_object else "") + fragment
    return MeshShader(
        name, SCREEN, text, needs=("app_colour", "gbuffer") if on_object else ("app_colour",)
    )


_ON_OBJECT = ("hatch", "grain", "wash")
"""Tones with patterns."""
_SHADERS = {
    name: tone_shader(
        f"tone {name}", glsl(__file__, f"tone_{name}.frag"), on_object=name in _ON_OBJECT
    )
    for name in ("app", *TONES)
}


def over_windows(
    shader: MeshShader, layer: Layer, uniforms: Mapping[str, Uniform], coat: int, *,
    paper: bool = True, tones: bool = True, weld: Weld | None = None, by_light: bool = False,
) -> Iterator[Pass]:
    """A `tone_shader` over every window of a layer. paper: whether that lies behind the surfaces,
    in what the layer has of the picture for itself; tones: whether surfaces over others are laid
    in, which they are once where they share a depth; weld: of meshes that hold patterns;
    by_light: as `held`."""
    windows = {body.camera.viewport: body for body in layer.bodies}
    parts: list[tuple[bool, list[Body]]] = []
    if not layer.over:
        parts.append((paper, [_seen(body) for body in windows.values()]))
    else:
        bare, rest = _parted(windows, layer.bare) if paper else ([], [])
        parts.append((True, bare))
        if tones and layer.fresh:
            parts.append((False, rest if bare else [_seen(body) for body in windows.values()]))
    if "gbuffer" in (shader.needs or ()) and any(screens for _, screens in parts):
        yield from held(layer, coat, weld or Weld(), by_light=by_light)
    for behind, screens in parts:
        if screens:
            yield Pass(
                tuple(screens), shader, "screen", state=_STATE,
                uniforms={**uniforms, "behind": int(behind), "backed": int(layer.backed)},
                image=grain(), coat=coat,
            )  # fmt: skip


def _parted(
    windows: Mapping[Box, Body], bare: tuple[Box, ...]
) -> tuple[list[Body], list[Body]]:
    """Windows as boxes in which nothing lies below, and the others."""
    free, rest = [], []
    for window, body in windows.items():
        left = [window]
        for box in bare:
            if overlap(window, box):
                free.append(_seen(body, box))
                left = without(left, box)
        rest += [_seen(body, box) for box in left]
    return free, rest


def tone_passes(
    tone: str, paper: str | Colour, ink: Colour, layer: Layer, tolerance: float = 0.0, *,
    scenery: float = 1.0,
) -> Iterator[Pass]:
    """One pass over every viewport, unless all stays as the app drew it. tone: ``app`` or one of
    `TONES`; paper: ``app`` or the colour of the background; ink: of what is drawn by hand;
    tolerance: object units at which corners are one; scenery: share of its own colours that what
    has no depth keeps under ``app``.

    A layer has no paper of its own where it lies over another, and no tone where it shares that
    one's depth: that has laid the surfaces in."""
    if tone == "app" and paper == "app":
        return
    uniforms: dict[str, Uniform] = {
        "paper": WHITE if isinstance(paper, str) else paper, "ink": ink, "scenery": scenery,
    }  # fmt: skip
    yield from over_windows(
        _SHADERS[tone], layer, uniforms, _UNDER,
        paper=not isinstance(paper, str), tones=tone != "app", weld=Weld(tolerance),
        by_light=tone in BY_LIGHT,
    )  # fmt: skip


def _seen(body: Body, box: Box | None = None) -> Body:
    """A body for its camera, which sees a box of its window, or all of it."""
    return replace(body, camera=_through(body.camera, box))


@lru_cache(maxsize=64)
def _through(camera: Camera, box: Box | None) -> Camera:
    """The same camera again for the same one and the same box."""
    return replace(camera, scissor=box, depth_range=(0.0, 1.0))


@cache
def grain() -> Image:
    """What paper is like, a value a pixel, all in 0..1 equally common: its tooth (red), and two
    fields of clouds (green, blue)."""
    chance = default_rng(2004)
    shape = (_SIDE, _SIDE)

    def field(fine: float, coarse: float) -> Doubles:
        """Noise of two sizes, pixels."""
        sizes = ((fine, fine), (coarse, coarse))
        first, second = (noise(chance, shape, size) for size in sizes)
        return even(first + 0.8 * second)

    found = [field(1.2, 3.0), field(14.0, 40.0), field(14.0, 40.0)]
    pixels = np.full((*shape, 4), 255, np.uint8)
    pixels[..., :3] = np.rint(np.stack(found, axis=-1) * 255.0)
    return Image(pixels)
