"""Style ``fins``: a quad along every edge where the surface turns away, made by a geometry shader.

P. Rideout, "Silhouette Extraction", The Little Grasshopper, 2010. Depths are compared at the middle
of a line (the spine test of F. Cole, A. Finkelstein, "Two Fast Methods for High-Quality Line
Visibility", 2010).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import pi
from typing import ClassVar

from glshim.geometry.meshshaders.edge_mesh import BOUNDARY, CONTOUR
from glshim.styling.glsl import glsl
from glshim.styling.media.ink import STROKE
from glshim.styling.passes import MeshShader, Pass, Sieve, State, Weld
from glshim.styling.protocol import Colour, Layer, Styler, option
from glshim.styling.values import Uniform

from ..shared import options
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
_CONTOURS = Sieve(CONTOUR | BOUNDARY, (pi, pi))


@dataclass(frozen=True)
class Fins(Styler):
    """Fins on contours and open edges, with a spine test (Rideout 2010)."""

    name: ClassVar[str] = "fins"

    half_width: float = option(
        2.0, help="half the width of the lines, rim included", low=0.5, high=64.0, unit="px"
    )
    overhang: float = option(
        0.15, help="share of its length that a fin is longer by at both ends (joints=overhang)",
        low=0.0, high=1.0,
    )  # fmt: skip
    joints: str = option(
        "round", help="between fins: round, longer fins that overlap, or gaps", choices=JOINTS
    )
    tip: float = option(
        1.0, help="width of the rim over which the ink fades; 0: no smooth edges",
        low=0.0, high=16.0, unit="px",
    )  # fmt: skip
    spine: bool = option(
        True, help="the middle of a line decides whether all of its width is seen; off: each pixel"
    )
    tolerance: float = options.tolerance(0.0)
    ink: Colour = option("#000000", help="colour of the lines")
    fill: str | Colour = option(
        "app",
        help="the surfaces: as the app drew them, lit anew pixel by pixel, in flat bands of that "
        "light, none, or flat in a colour",
        choices=("app", "lit", "cel", "none"), colour=True,
    )  # fmt: skip
    paint: str | Colour = option(
        "app", help="what lit surfaces are painted with: the app's colours, or one",
        choices=("app",), colour=True,
    )  # fmt: skip
    shine: float = option(0.4, help="brightness of highlights (lit, cel)", low=0.0, high=1.0)
    bands: int = option(4, help="shades of light (cel)", low=2, high=16)

    @property
    def wants_normals(self) -> bool:
        """Light falls by them."""
        return self.fill in ("lit", "cel")

    @property
    def surface(self) -> str | Colour:
        """The option `fill`: what is lit anew is painted over the app's own."""
        return "app" if self.fill in ("lit", "cel") else self.fill

    def draws(self, layer: Layer) -> Iterable[Pass]:
        """Triangles with adjacency, of which the geometry shader makes fins."""
        found = layer.bodies
        if not found:
            return
        if self.fill in ("lit", "cel"):
            bands = self.bands if self.fill == "cel" else 0
            look = Lighting(self.paint, self.shine, bands)
            yield from relit(found, layer.light, look, self.tolerance)
        uniforms: dict[str, Uniform] = {
            "half_width": self.half_width,
            "overhang": self.overhang if self.joints == "overhang" else 0.0,
            "joints": JOINTS.index(self.joints),
            "tip": self.tip,
            "spine": int(self.spine),
            "ink": self.ink,
            "hidden_share": 0.0,
        }
        state = State(depth="always", blend="greatest")
        for short, shader in enumerate(SIDES if self.spine else SIDES[:1]):
            shortest = 0.0 if short or not self.spine else _SHORTEST
            yield Pass(
                found, shader, "lines", state=state, uniforms=uniforms,
                sieve=replace(_CONTOURS, shortest=shortest), weld=Weld(self.tolerance), lines=True,
            )  # fmt: skip


def as_printed(one: Pass) -> Pass:
    """A pass of this style with the article's own shader, over all triangles with adjacency."""
    if one.shader not in SIDES:
        return one
    return replace(one, shader=FINS[SIDES.index(one.shader)], element="adjacency", sieve=None)
