"""Passes: draws of whole recovered meshes, with shaders and fixed state of a styler's own.

Where `Draw` says which lines there are, a `Pass` runs a shader over all edges or triangles of the
meshes that were recovered from the stream, and the shader decides (McGuire & Hughes 2004).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from glshim.geometry.crease.creases import Criterion
from glshim.geometry.meshshaders.poses import Pose
from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.styling.pictures import Image
from glshim.styling.values import Layer, Uniform

Comparison = Literal["always", "never", "less", "lequal", "equal", "notequal", "gequal", "greater"]
Action = Literal["keep", "replace", "increase", "decrease", "zero"]
Element = Literal["edges", "sides", "triangles", "screen", "surface", "adjacency", "lines"]
"""What a shader runs over. Sides: the edges, and those left out of the edge mesh because they lie
inside flat polygons, so that every side of every triangle is in one row. Surface: the triangles by
index, so that the vertex shader runs once a vertex, ``gl_VertexID``. Adjacency: the same with the
vertices across the sides, six indices a triangle, for a geometry shader. Lines: the halfedges (3 t
+ k begins at corner k of triangle t), four indices each, for one, too: the triangle's third corner,
both ends, and the vertex across, which is the first end again where there is none."""
Primitive = Literal["lines", "quads", "triangles"]
Actions = tuple[Action, Action, Action]
"""What happens to the stencil where its test fails, where depth fails, and where both pass."""

VERTICES: Mapping[Primitive, int] = {"lines": 2, "triangles": 3, "quads": 4}
"""Vertices of one primitive."""


@dataclass(frozen=True, slots=True)
class Body:
    """Batches that share a camera, and so an object space: one mesh is recovered from them."""

    batches: tuple[PolygonBatch, ...]
    camera: Camera


@dataclass(frozen=True, slots=True)
class MeshShader:
    """GLSL texts (no ``#version`` line). `vertex` follows the preludes ``depth.glsl`` and
    ``mesh.glsl``, which give the mesh, the camera and the light; `fragment` follows ``depth.glsl``.
    One that declares ``uniform sampler2D app_colour`` finds the app's finished picture there, pixel
    for pixel, and in ``uniform sampler2D gbuffer`` what passes drew into that. Colours are
    premultiplied."""

    name: str
    vertex: str
    fragment: str
    geometry: str = ""
    """Follows the preludes of `vertex`; for elements ``adjacency`` and ``lines``."""


@dataclass(frozen=True, slots=True)
class Stencil:
    """The stencil test of a pass, and what it does to faces turned to the viewer and away."""

    test: Comparison = "always"
    reference: int = 0
    front: Actions = ("keep", "keep", "keep")
    back: Actions = ("keep", "keep", "keep")


@dataclass(frozen=True, slots=True)
class State:
    """Fixed state of a pass. The depth buffer begins as a copy of the layer's finished depth, the
    stencil at 255 and the colour at nothing; all three belong to the styler alone."""

    depth: Comparison = "lequal"
    writes_depth: bool = False
    writes_colour: bool = True
    blend: Literal["over", "greatest", "off"] = "over"
    cull: Literal["none", "front", "back"] = "none"
    offset: tuple[float, float] = (0.0, 0.0)
    """glPolygonOffset's factor and units: positive is away from the viewer."""
    clamps: bool = False
    """Whether depths beyond the near and the far plane are kept there instead of clipped."""
    stencil: Stencil | None = None
    clears_stencil: bool = False
    """Set all of the stencil to 255 first."""


@dataclass(frozen=True, slots=True)
class Sieve:
    """Elements that surely are none of these are left out before the shader decides. Of meshes that
    a pose moves none are. Lines, and triangles with adjacency, stay for the sake of their edges: of
    the two at an edge the one whose corner off it has the lesser number; or where the pass has
    creases for the bits of `glshim.geometry.meshshaders.sieve`."""

    wanted: int
    """Bits of `glshim.geometry.meshshaders.edge_mesh.features`, or ``CREASE`` and ``SMOOTH``."""
    angles: tuple[float, float] = (0.0, 0.0)
    """Of ridges and valleys, radians."""


@dataclass(frozen=True, slots=True)
class Pass:
    """One shader over the elements of bodies."""

    shader: MeshShader
    bodies: tuple[Body, ...]
    """For element ``screen`` their camera counts alone: one triangle covers all of its window."""
    element: Element
    primitive: Primitive = "triangles"
    primitives: int = 1
    """Primitives for each element: the shader sees ``element()`` and ``corner()``."""
    copies: int = 1
    """How often everything is drawn; the shader sees ``gl_InstanceID``."""
    state: State = State()
    uniforms: Mapping[str, Uniform] = field(default_factory=dict)
    image: Image | None = None
    """What the sampler ``stroke`` reads."""
    light: tuple[float, float, float, float] = (0.0, 0.0, 1.0, 0.0)
    """Where the light is in eye space, homogeneous (`Layer.light`, or a styler's own)."""
    pose: Pose | None = None
    """How the shader moves vertices before anything else; None: as the app sent them."""
    sieve: Sieve | None = None
    """For edges, lines and triangles with adjacency: which of them may be left out; None: none."""
    creases: Criterion | None = None
    """Vertices are topology vertices, which creases part: ``normal(v)`` is the app's own where it
    sent any, and shaders see creases (``mesh.glsl``). Not with a pose."""
    least: float = 0.0
    """Pixels: a body none of whose sides can be that long on the screen is left out. Not with a
    pose."""
    tolerance: float = 0.0
    """Object units: corners no further apart are one vertex."""
    buffer: bool = False
    """Draws into the G-buffer: four floats a pixel, nothing to begin with, and a depth buffer of
    its own, at the far plane. Passes after it read it; another run of such passes begins anew."""
    sheet: int = 0
    """Passes that follow each other on one sheet share colour, depth and stencil; at the first of
    another one what was drawn is laid over the window, and all three begin anew."""


def bodies(layer: Layer) -> tuple[Body, ...]:
    """The batches of a layer by camera, in the order of their first."""
    found: dict[object, tuple[list[PolygonBatch], Camera]] = {}
    known: dict[int, object] = {}
    for batch, camera in layer.items:
        key = known.get(id(camera))
        if key is None:
            key = known[id(camera)] = (
                camera.modelview.tobytes(), camera.projection.tobytes(), camera.viewport,
                camera.depth_range, camera.front_ccw, camera.scissor, camera.clip_planes,
                camera.stencil,
            )  # fmt: skip
        found.setdefault(key, ([], camera))[0].append(batch)
    return tuple(Body(tuple(batches), camera) for batches, camera in found.values())
