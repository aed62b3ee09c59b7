"""Passes: draws of whole recovered meshes, with shaders and fixed state of a styler's own.

Where `Lines` say which lines there are, a `Pass` runs a shader over all edges or triangles of the
meshes that were recovered from the stream, and the shader decides (McGuire & Hughes 2004).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from glshim.errors import StyleError, unknown
from glshim.geometry.crease.creases import Criterion
from glshim.geometry.meshshaders.poses import Pose
from glshim.styling.former import accept
from glshim.styling.pictures import Image
from glshim.styling.values import Body, Layer, Place, Uniform

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


NEEDS = ("app_colour", "gbuffer", "rest", "light")
"""What a `MeshShader` may read: the app's finished picture, pixel for pixel (``uniform sampler2D
app_colour``); what passes before it drew into the G-buffer (``uniform sampler2D gbuffer``); where
vertices were when their mesh was first seen (``rest(v)``); the light of its pass (``light``)."""


@dataclass(frozen=True, slots=True)
class MeshShader:
    """GLSL texts (no ``#version`` line). `vertex` follows the preludes ``depth.glsl`` and
    ``mesh.glsl``, which give the mesh, the camera and the light; `fragment` follows ``depth.glsl``.
    Colours are premultiplied."""

    name: str
    vertex: str
    fragment: str
    geometry: str = ""
    """Follows the preludes of `vertex`; for elements ``adjacency`` and ``lines``."""
    needs: Collection[str] | None = None
    """What it reads beside the mesh and its own uniforms, of `NEEDS`. None: what its texts show."""

    def __post_init__(self) -> None:
        needs = shown_needs(self) if self.needs is None else frozenset(self.needs)
        for name in needs:
            if name not in NEEDS:
                raise unknown(f"shader {self.name!r} needs {name!r}", name, NEEDS)
        object.__setattr__(self, "needs", needs)


def shown_needs(shader: MeshShader) -> frozenset[str]:
    """What the texts of a shader show that it reads, for those that do not say; all but the light,
    whose name a text may have for something else."""
    texts = shader.vertex + shader.geometry
    shown = {
        "app_colour": "app_colour" in shader.fragment,
        "gbuffer": "gbuffer" in shader.fragment + texts,
        "rest": "rest(" in texts,
    }
    return frozenset(name for name, reads in shown.items() if reads)


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
class Primitives:
    """What a vertex shader makes of each element: it sees ``element()`` and ``corner()``."""

    kind: Primitive = "triangles"
    each: int = 1
    """Primitives for each element."""
    copies: int = 1
    """How often everything is drawn; the shader sees ``gl_InstanceID``."""


@dataclass(frozen=True, slots=True)
class Weld:
    """Which corners are one vertex of a recovered mesh."""

    tolerance: float = 0.0
    """Object units: corners no further apart are one vertex."""
    creases: Criterion | None = None
    """Vertices are topology vertices, which creases part: ``normal(v)`` is the app's own where it
    sent any, and shaders see creases (``mesh.glsl``). Not with a pose."""


@dataclass(frozen=True, slots=True)
class Sieve:
    """Elements that certainly are not wanted are left out before the shader decides: edges, lines
    and triangles with adjacency; none of meshes that a pose moves. Lines, and triangles with
    adjacency, stay for the sake of their edges: of the two at an edge the one whose corner off it
    has the lesser number; or where the pass has creases for the bits of
    `glshim.geometry.meshshaders.sieve`."""

    wanted: int
    """Bits of `glshim.geometry.meshshaders.edge_mesh.features`, or ``CREASE`` and ``SMOOTH``."""
    angles: tuple[float, float] = (0.0, 0.0)
    """Of ridges and valleys, radians (`glshim.model.dihedral.crease_limits`)."""
    shortest: float = 0.0
    """Pixels: a body none of whose sides can be that long on the screen is left out."""


HEADLIGHT: Place = (0.0, 0.0, 1.0, 0.0)
"""A light that shines from behind the viewer, in eye space."""


@dataclass(frozen=True, slots=True)
class Pass:
    """One shader over the elements of bodies."""

    bodies: tuple[Body, ...]
    """`Layer.bodies`, or some. For element ``screen`` their camera counts alone: one triangle
    covers all of its window."""
    shader: MeshShader
    element: Element
    """What the shader runs over."""
    primitives: Primitives = Primitives()
    """What it makes of each."""
    uniforms: Mapping[str, Uniform] = field(default_factory=dict)
    image: Image | None = None
    """What the sampler ``stroke`` reads."""
    light: Place | None = None
    """Where the ``light`` of the shader is in eye space: `Layer.light`, `HEADLIGHT`, or a styler's
    own. None: the shader reads none."""
    state: State = State()
    """Depth test, blending, culling, stencil."""
    weld: Weld = Weld()
    """Which corners are one vertex."""
    pose: Pose | None = None
    """How the shader moves vertices before anything else; None: as the app sent them."""
    sieve: Sieve | None = None
    """Which elements are left out before; None: none."""
    buffer: bool = False
    """Draws into the G-buffer: four floats for each pixel, cleared to zero, with a separate depth
    buffer. Later passes read it; another sequence of such passes clears it again."""
    coat: int = 0
    """Consecutive passes with the same coat share colour, depth and stencil. At the first pass with
    another coat, the result is drawn over the window, and all three are cleared. The order of
    drawing is that of the list, whatever the coats."""
    lines: bool = False
    """It draws lines: where styles are put together, those of a style are taken, or its surfaces.
    """

    def __post_init__(self) -> None:
        if self.light is None and "light" in (self.shader.needs or ()):
            raise StyleError(
                f"shader {self.shader.name!r} needs a light: give its Pass light=layer.light, or "
                "light=HEADLIGHT for one at the viewer"
            )


_OLD = (
    "shader", "bodies", "element", "primitive", "primitives", "copies", "state", "uniforms",
    "image", "light", "pose", "sieve", "creases", "least", "tolerance", "buffer", "sheet",
)  # fmt: skip
_GONE = {"primitive", "copies", "creases", "least", "tolerance", "sheet"}


def _former(args: tuple[Any, ...], given: dict[str, Any]) -> dict[str, Any] | None:
    """``Pass(shader, bodies, element, primitive, primitives, copies, ...)``: flat, and with a light
    that was the viewer's where none was given."""
    if not (args and isinstance(args[0], MeshShader)) and _GONE.isdisjoint(given):
        return None
    names = _OLD if args and isinstance(args[0], MeshShader) else ("bodies", "shader", "element")
    if len(args) > len(names):
        return None
    named = {"light": HEADLIGHT, **dict(zip(names, args, strict=False)), **given}

    def taken(**renamed: str) -> dict[str, Any]:
        return {new: named.pop(old) for new, old in renamed.items() if old in named}

    made = taken(kind="primitive", each="primitives", copies="copies")
    welded = taken(tolerance="tolerance", creases="creases")
    least = taken(shortest="least")
    if made:
        named["primitives"] = Primitives(**made)
    if welded:
        named["weld"] = Weld(**welded)
    if named.get("sieve") is not None:
        named["sieve"] = replace(named["sieve"], **least)
    coat = taken(coat="sheet")
    return {**named, **coat}


accept(Pass, _former, "Pass(bodies, shader, element, Primitives(...), weld=Weld(...), coat=...)")


def bodies(layer: Layer) -> tuple[Body, ...]:
    """`Layer.bodies`, as stylers wrote it before that was there."""
    return layer.bodies
