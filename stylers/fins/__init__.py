"""Style ``fins``: a quad along every edge where the surface turns away, made by a geometry shader.

P. Rideout, "Silhouette Extraction", The Little Grasshopper, 2010. Depths are compared at the middle
of a line (the spine test of F. Cole, A. Finkelstein, "Two Fast Methods for High-Quality Line
Visibility", 2010).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from math import pi
from typing import ClassVar

from glshim.geometry.meshshaders.edge_mesh import BOUNDARY, CONTOUR
from glshim.styling.glsl import glsl
from glshim.styling.media.ink import STROKE
from glshim.styling.passes import MeshShader, Pass, Sieve, State, Weld
from glshim.styling.pictures import is_coloured
from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names
from glshim.styling.textures import made
from glshim.styling.values import Uniform

from ..shared import options
from ..shared.intersections import intersection_lines
from ..shared.kinds import (
    Boundaries,
    Contours,
    Intersections,
    Look,
    Ridges,
    Valleys,
    former_names,
)
from ..shared.shading import UNLIT, by_light
from ..shared.strokes import inked, only
from .lighting import Lighting, relit


def _shader(name: str, fragment: str, *defined: str) -> MeshShader:
    given = "".join(f"#define {word}\n" for word in defined)
    # The stroke of a short one stays in the geometry shader.
    own = "#undef PASSED\n#define PASSED\n" if "SHORT_FINS" in defined else ""
    geometry = given + own + STROKE + glsl(__file__, "fins.geom")
    return MeshShader(name, glsl(__file__, "fins.vert"), given + fragment, geometry, needs=())


_LONG, _SHORT = STROKE + glsl(__file__, "fins.frag"), glsl(__file__, "short.frag")
FINS = _shader("fins", _LONG), _shader("short fins", _SHORT, "SHORT_FINS")
"""Over triangles with adjacency, as in the article. Of fins of a few pixels the geometry shader
finds out whether they are seen: drivers in software would ask for each pixel, of which these have
more than their share, and would walk through every branch of a shader that drew both."""
SIDES = _shader("sides", _LONG, "LINES"), _shader("short sides", _SHORT, "LINES", "SHORT_FINS")
"""Over halfedges, of which a sieve leaves few: the same picture, sooner."""
_SHORTEST = 4.0
"""Pixels of the longest short fin, as in the shader."""
JOINTS = ("none", "overhang", "round")


_KINDS = {"contour": 1, "boundary": 2}
"""Bits in the shader, of what fins are drawn for."""


@takes_old_names
@dataclass(frozen=True)
class Fins(Intersections, Valleys, Ridges, Boundaries, Contours):
    """Fins on contours and open edges, with a spine test (Rideout 2010)."""

    name: ClassVar[str] = "fins"
    former: ClassVar[Mapping[str, Renamed]] = former_names(
        (*_KINDS, "ridge", "valley", "intersection"), half_width=Renamed(("width",), factor=2.0)
    )

    ridges: bool = option(False, help="draw ridges, in plain ink: creases that stand out")
    valleys: bool = option(False, help="draw valleys, in plain ink: creases that lie in")
    width: float = options.width(4.0, "all lines, rim included", high=128.0)
    ink: Colour = options.ink("#000000")
    texture: str = options.texture()
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    crease_angle: float = options.crease_angle(60.0)
    overhang: float = option(
        0.15, help="extra length of a fin at both ends, as a share of its length (joints=overhang)",
        low=0.0, high=1.0,
    )  # fmt: skip
    joints: str = option(
        "round", help="joints between fins: round, overlapping (overhang), or gaps (none)",
        choices=JOINTS,
    )  # fmt: skip
    tip: float = option(
        1.0, help="width of the rim over which ink fades out; 0: hard edges",
        low=0.0, high=16.0, unit="px",
    )  # fmt: skip
    spine: bool = option(
        True, help="test visibility along the middle of a line; off: at each pixel"
    )
    intersections: str = options.intersections("off")
    tolerance: float = options.tolerance(0.0)
    fill: str | Colour = option(
        "app",
        help="surfaces: as the program draws them (app), shaded per pixel (lit), in flat bands of "
        "that shading (cel), not drawn (none), or in one colour",
        choices=("app", "lit", "cel", "none"), colour=True,
    )  # fmt: skip
    paint: str | Colour = options.paint()
    shine: float = option(0.4, help="brightness of highlights (lit, cel)", low=0.0, high=1.0)
    bands: int = option(4, help="flat shades of light (cel)", low=2, high=16)
    own_ink: str = options.own_ink()

    @property
    def wants_normals(self) -> bool:
        """Light falls by them."""
        return self.fill in ("lit", "cel")

    @property
    def wants_lights(self) -> bool:
        """What the app does not light keeps its own picture among what it does."""
        return self.fill in ("lit", "cel")

    @property
    def surface(self) -> str | Colour:
        """The option `fill`: what is lit anew is painted over the app's own."""
        return "app" if self.fill in ("lit", "cel") else self.fill

    def share(self, kind: str) -> float:
        return 1.0 if kind in _KINDS else 0.5

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """Triangles with adjacency, of which the geometry shader makes fins; and creases in ink,
        if they are asked for."""
        found = layer.bodies
        if not found:
            return
        if self.fill in ("lit", "cel"):
            bands = self.bands if self.fill == "cel" else 0
            look = Lighting(self.paint, self.shine, bands)
            lit, unlit = by_light(layer, "off" if layer.lighting is not None else "head")
            for some in lit:
                light = some.lights[0].position if some.lights else layer.light
                yield from relit(some.bodies, light, look, self.tolerance)
            plainly = self.fill == "cel" and self.paint == "app"
            ambient = {"ambient": UNLIT} if plainly else {}
            yield from relit(unlit, layer.light, look, self.tolerance, **ambient)
        looks = self.looks()
        creases = {kind: look for kind, look in looks.items() if kind in ("ridge", "valley")}
        if creases:
            wanted = only(self.features(self.crease_angle, tolerance=self.tolerance), creases)
            yield from inked(layer, wanted, creases, texture_length=self.texture_length)
        alike: dict[Look, int] = {}
        for kind in filter(looks.__contains__, _KINDS):
            alike[looks[kind]] = alike.get(looks[kind], 0) | _KINDS[kind]
        for own, kinds in alike.items():
            yield from self._fins(layer, own, kinds)
        yield from intersection_lines(self, self.intersections, layer)

    def _fins(self, layer: Layer, look: Look, kinds: int) -> Iterable[Pass]:
        """Fins of a look, for some kinds (bits)."""
        image, repeat = None, 1.0
        if look.stroke is not None:
            image, repeat, _ = made(look.texture, look.width, self.texture_length, look.dash)
        apart = self.spine and image is None
        uniforms: dict[str, Uniform] = {
            "half_width": look.width / 2.0,
            "overhang": self.overhang if self.joints == "overhang" else 0.0,
            "joints": JOINTS.index(self.joints),
            "tip": self.tip,
            "spine": int(self.spine),
            "apart": int(apart),
            "kinds": kinds,
            "ink": look.ink,
            "textured": 0 if image is None else 2 if is_coloured(image) else 1,
            "repeat": repeat,
            "hidden_share": 0.0,
        }
        wanted = (CONTOUR if kinds & _KINDS["contour"] else 0) | (
            BOUNDARY if kinds & _KINDS["boundary"] else 0
        )
        for short, shader in enumerate(SIDES if apart else SIDES[:1]):
            shortest = _SHORTEST if apart and not short else 0.0
            yield Pass(
                layer.bodies, shader, "lines", state=State(depth="always", blend="greatest"),
                uniforms=uniforms, image=image, sieve=Sieve(wanted, (pi, pi), shortest),
                weld=Weld(self.tolerance), lines=True,
            )  # fmt: skip


def as_printed(one: Pass) -> Pass:
    """A pass of this style with the article's own shader, over all triangles with adjacency."""
    if one.shader not in SIDES:
        return one
    return replace(one, shader=FINS[SIDES.index(one.shader)], element="adjacency", sieve=None)
