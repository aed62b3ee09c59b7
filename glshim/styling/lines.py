"""Lines of bodies: which there are, and what they are drawn with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import cos, sin
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.notices import say_once
from glshim.styling.pictures import Image
from glshim.styling.values import Body, Uniform
from glshim.styling.wishes import Choice, Features, Pattern


@dataclass(frozen=True, slots=True, eq=False)
class Expansion:
    """Line records as the vertices of triangle strips, a strip a line that is drawn."""

    places: NDArray[np.floating[Any]]
    """(N, V, 2) pixels of the framebuffer."""
    values: Mapping[str, NDArray[np.floating[Any]]]
    """(N, 1..4) by the name of a ``PASSED`` float or vector: what the fragments of a line get,
    the same in all of it."""


class Expand(Protocol):
    """What a shader's `vertex` does, in numpy. Pure, and a function of a module."""

    def __call__(
        self,
        records: NDArray[np.float32],
        camera: Camera,
        uniforms: Mapping[str, Uniform],
        *,
        hair: float,
        blur: float,
    ) -> Expansion:
        """Strips of records (L, 21), see `glshim.model.lines.RECORD`. The camera's depth
        range is turned: greater is farther. hair: a few steps of the depth buffer; blur: pixels by
        which depths may not be those of pixel centres."""


@dataclass(frozen=True, slots=True)
class Shader:
    """GLSL texts (no ``#version`` line) that turn one line record into one triangle strip.

    `vertex` follows the prelude ``glshim/outputs/gl/shaders/line.glsl``, which declares the record
    and the camera and offers the offset formulas; `fragment` follows ``depth.glsl``, which gives
    the layer's finished depth. The ink that it writes is premultiplied; where strokes overlap each
    channel keeps its greatest value.
    """

    name: str
    vertex: str
    fragment: str
    vertices: int
    """Vertices of the strip of one edge."""
    expand: Expand | None = None
    """`vertex` for OpenGL before 3.3, which has the `fragment` alone, as GLSL 1.20. None: there the
    shader draws nothing."""


@dataclass(frozen=True, slots=True)
class Medium:
    """What lines are drawn with: a shader and all that it reads."""

    shader: Shader
    uniforms: Mapping[str, Uniform] = field(default_factory=dict)
    """The shader's own by name. It may also declare ``vec2 ridge_turn`` and ``valley_turn``: cosine
    and sine of the angles of `Lines.wanted`."""
    image: Image | None = None
    """What the fragment shader's sampler ``stroke`` reads."""
    pattern: Pattern | None = None
    """What repeats along strokes; None: what the lines that are wanted have."""


@dataclass(frozen=True, slots=True)
class Lines:
    """Lines of bodies, drawn with a medium, each in one strip."""

    bodies: tuple[Body, ...]
    """`Layer.bodies`, or some."""
    wanted: Choice | Features
    """Which lines; by what polygons show, or by the mesh that they make."""
    medium: Medium
    """What they look like."""
    coat: int = 0
    """Consecutive lines with the same coat merge: each pixel keeps the most ink. Lines with another
    coat are drawn over them. The order of drawing is that of the list, whatever the coats."""


def turns(wanted: Choice | Features) -> dict[str, tuple[float, float]]:
    """``ridge_turn``, ``valley_turn``: cosine and sine of the angles at which folds are lines."""
    ridge, valley = wanted.ridge_angle or 0.0, wanted.valley_angle or 0.0
    return {"ridge_turn": (cos(ridge), sin(ridge)), "valley_turn": (cos(valley), sin(valley))}


class Draw(Lines):
    """`Lines` of one batch, as stylers gave them before there were bodies: deprecated."""

    __slots__ = ()

    def __init__(  # noqa: PLR0917 (as it was written)
        self,
        batch: PolygonBatch,
        camera: Camera,
        choice: Choice | Features,
        shader: Shader,
        uniforms: Mapping[str, Uniform],
        image: Image | None = None,
        sheet: int = 0,
    ) -> None:
        say_once(
            "a style gives Draw(batch, camera, choice, shader, uniforms), of glshim 0.1: write "
            "Lines(layer.bodies, choice, Medium(shader, uniforms)), once a layer"
        )
        medium = Medium(shader, uniforms, image)
        super().__init__((Body((batch,), camera),), choice, medium, sheet)
