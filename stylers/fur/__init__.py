"""Style ``fur``: every surface grows hair in its own colours.

J. Lengyel, E. Praun, A. Finkelstein, H. Hoppe, "Real-Time Fur over Arbitrary Surfaces", I3D 2001,
with the fins found and extruded on the GPU: M. McGuire, J. F. Hughes, "Hardware-Determined Feature
Edges", NPAR 2004, section 1 and figure 1b.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import ceil
from typing import ClassVar

from glshim.styling.glsl import glsl
from glshim.styling.passes import MeshShader, Pass, Primitives, State
from glshim.styling.protocol import Colour, Layer, Styler, option
from glshim.styling.values import Uniform

from ..shared import options
from .scale import scale_of

_FRAGMENT = glsl(__file__, "fur.frag")
_NEEDS = ("app_colour", "rest", "light")
SHELLS = MeshShader(
    "fur shells", glsl(__file__, "hair", "shell.vert"), _FRAGMENT, needs=_NEEDS
)
FINS = MeshShader("fur fins", glsl(__file__, "hair", "fin.vert"), _FRAGMENT, needs=_NEEDS)
_STATE = State(writes_depth=True)
_QUADS = 2
"""Of a fin, one above the other."""
_LATTICE = (0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6)
"""A rotation (columns first) that turns no plane of an ordinary model along a layer of cells."""


@dataclass(frozen=True)
class Fur(Styler):
    """Hair on every surface: shells, and fins near contours (Lengyel et al. 2001)."""

    name: ClassVar[str] = "fur"
    categories: ClassVar[tuple[str, ...]] = ("effects",)

    length: float = option(
        20.0, help="hair length at the centre of an object", low=1.0, high=200.0, unit="px"
    )
    density: float = option(
        40.0, help="hairs per 100 pixels, side by side", low=2.0, high=100.0
    )
    thickness: float = option(
        1.0, help="hair width at the root; 1 covers the skin, less shows it", low=0.2, high=1.5
    )
    droop: float = option(
        0.6, help="how far hairs hang down; 0: upright, 2: flat", low=0.0, high=2.0
    )
    curl: float = option(0.6, help="strength of curls", low=0.0, high=2.0)
    layers: int = option(12, help="maximum number of shells; short fur uses fewer", low=2, high=64)
    sheen: float = option(0.25, help="brightness of highlights along hairs", low=0.0, high=1.0)
    fins: bool = option(True, help="draw hairs in profile near contours")
    colour: str | Colour = option(
        "app", help="colour of hairs: that of the surface (app), or one colour",
        choices=("app",), colour=True,
    )  # fmt: skip
    fill: str | Colour = options.fill()
    own_ink: str = options.own_ink()

    def draws(self, layer: Layer) -> Iterable[Pass]:
        """The fins of each body, and over them its shells from the skin outwards."""
        own = (0.0, 0.0, 0.0, 0.0) if isinstance(self.colour, str) else (*self.colour, 1.0)
        for body in layer.bodies:
            scale = scale_of(body, self.length, 100.0 / self.density)
            if scale is None:
                continue
            # A shell for each pixel is enough.
            shells = max(2, min(self.layers, ceil(scale.pixels)))
            uniforms: dict[str, Uniform] = {
                "hair_length": scale.length,
                "spacing": scale.spacing,
                "reach": scale.reach,
                "lattice": _LATTICE,
                "droop": self.droop,
                "curl": self.curl,
                "sheen": self.sheen,
                "thickness": 0.45 * self.thickness,
                "fur_colour": own,
                "shells": shells,
            }
            if self.fins:
                yield Pass(
                    (body,), FINS, "edges", Primitives("quads", _QUADS), state=_STATE,
                    uniforms=uniforms, light=layer.light,
                )  # fmt: skip
            yield Pass(
                (body,), SHELLS, "triangles", Primitives(copies=shells), state=_STATE,
                uniforms=uniforms, light=layer.light,
            )  # fmt: skip
