"""Style ``crease``: creases as quads in the planes of their triangles, and smooth silhouettes.

B. Hajagos, L. Szecsi, B. Csebfalvi, "Fast silhouette and crease edge synthesis with geometry
shaders", SCCG 2012. Creases are found from what the app's own normals say, and by angle; crease
differences on the vertices tell the geometry shader where the next crease goes on.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import radians
from typing import Any, ClassVar, cast

from glshim.geometry.crease.creases import Criterion
from glshim.geometry.meshshaders.sieve import CREASE, SMOOTH
from glshim.styling.glsl import glsl
from glshim.styling.media.ink import STROKE
from glshim.styling.passes import MeshShader, Pass, Sieve, State, Weld
from glshim.styling.pictures import Image, is_coloured
from glshim.styling.protocol import Colour, Layer, Styler, option
from glshim.styling.textures import made
from glshim.styling.values import Body, Uniform

from ..shared import options


def _shaders(name: str) -> tuple[MeshShader, MeshShader]:
    """For lines, and for those of a few pixels, whose strokes stay in the geometry shader."""
    geometry = STROKE + glsl(__file__, "quads", f"{name}.geom")
    short = "#define SHORT_LINES\n#undef PASSED\n#define PASSED\n" + geometry
    fragment = STROKE + glsl(__file__, "crease.frag")
    record = glsl(__file__, "record.vert")
    return (
        MeshShader(f"crease {name}", record, fragment, geometry, needs=("gbuffer",)),
        MeshShader(f"crease short {name}", record, glsl(__file__, "short.frag"), short, needs=()),
    )


CREASES, SILHOUETTES = _shaders("crease"), _shaders("smooth")
_SHORTEST = 4.0
"""Pixels of the longest short line, as in the shader. Most of what a dense mesh gives is shorter;
asking for each of its pixels whether it is seen is what costs a driver in software most."""
BACK = MeshShader(
    "crease back", glsl(__file__, "back.vert"), glsl(__file__, "back.frag"), needs=()
)
_INK = State(depth="always", blend="greatest")
_NEAREST = State(depth="less", writes_depth=True, blend="off")


@dataclass(frozen=True)
class Crease(Styler):
    """Creases and the silhouettes of smooth surfaces (Hajagos et al. 2012).

    Verifiers draw what flags draw, but where a side that is no crease fits the differences at both
    its ends: diagonals of squares in planes along the x axis, of which a verifier is the product.
    """

    name: ClassVar[str] = "crease"

    creases: bool = option(True, help="ink where the surface has a crease, or ends")
    silhouettes: bool = option(True, help="ink where smooth surfaces turn away from the viewer")
    crease_width: float = option(2.5, help="width of creases", low=0.5, high=64.0, unit="px")
    silhouette_width: float = option(
        2.5, help="width of silhouettes", low=0.5, high=64.0, unit="px"
    )
    rule: str = option(
        "either",
        help="what is a crease: where the program's normals differ, where polygons turn, or either",
        choices=("either", "normals", "angle"),
    )
    angle: float = option(
        60.0, help="polygons that turn by so much make a crease", low=0.0, high=180.0,
        unit="degrees",
    )  # fmt: skip
    least_angle: float = option(
        20.0, help="where the normals differ polygons must turn by so much; 0: the paper's creases",
        low=0.0, high=180.0, unit="degrees",
    )  # fmt: skip
    indicator: str = option(
        "flags",
        help="how the shader knows creases: exact flags, or the paper's verifiers",
        choices=("flags", "verifiers"),
    )
    bias: float = option(
        1.5, help="depth by which creases may lie behind what is drawn, in pixels", low=0.0,
        high=64.0, unit="px",
    )  # fmt: skip
    fade: float = option(
        2.0, help="depth over which they fade away beyond that, in pixels", low=0.0, high=64.0,
        unit="px",
    )  # fmt: skip
    spine: bool = option(
        True, help="creases are seen where their middle is; off: the soft depth test alone"
    )
    hidden_by: str = option(
        "surfaces",
        help="what hides silhouettes: all surfaces, or as in the paper those that look away",
        choices=("surfaces", "back_faces"),
    )
    texture: str = options.texture("lines")
    texture_length: float = options.texture_length("a line")
    tolerance: float = options.tolerance(0.0)
    ink: Colour = option("#000000", help="colour of the lines")
    fill: str | Colour = options.fill()

    @property
    def wants_normals(self) -> bool:
        """Creases are where they differ, and silhouettes where they turn away."""
        return True

    def draws(self, layer: Layer) -> Iterable[Pass]:
        """Triangles with adjacency, of which geometry shaders make the quads."""
        found = layer.bodies
        if not found:
            return
        if self.silhouettes:
            if self.hidden_by == "back_faces":
                yield Pass(
                    found, BACK, "surface", state=_NEAREST, buffer=True, weld=self._weld, lines=True
                )
            plain = self.hidden_by == "surfaces"
            yield from self._lines(SILHOUETTES, found, self.silhouette_width, SMOOTH, plain)
        if self.creases:
            yield from self._lines(CREASES, found, self.crease_width, CREASE, self.spine)

    @property
    def _weld(self) -> Weld:
        rule = cast(Any, self.rule)
        return Weld(
            self.tolerance, Criterion(rule, radians(self.angle), radians(self.least_angle))
        )

    def _lines(
        self,
        shaders: tuple[MeshShader, MeshShader],
        found: tuple[Body, ...],
        width: float,
        wanted: int,
        plain: bool,
    ) -> Iterator[Pass]:
        """Lines of a kind, the short ones apart where one answer says whether they are seen."""
        image, repeat, textured = self._stroke(width)
        apart = plain and not textured
        uniforms: dict[str, Uniform] = {
            "half_width": width / 2.0,
            "ink": self.ink,
            "bias": self.bias,
            "fade": self.fade,
            "spine": int(self.spine),
            "back_faces": int(self.hidden_by == "back_faces"),
            "verified": int(self.indicator == "verifiers"),
            "cuts": int(textured > 0),
            "apart": int(apart),
            "creased": int(self.creases),
            "textured": textured,
            "repeat": repeat,
            "hidden_share": 0.0,
        }
        for short, shader in enumerate(shaders if apart else shaders[:1]):
            shortest = _SHORTEST if apart and not short else 0.0
            yield Pass(
                found, shader, "adjacency", state=_INK, uniforms=uniforms, image=image,
                sieve=Sieve(wanted, shortest=shortest), weld=self._weld, lines=True,
            )  # fmt: skip

    def _stroke(self, width: float) -> tuple[Image | None, float, int]:
        """The texture, the pixels after which it repeats, and 2 where it has its own colours."""
        if self.texture == "none":
            return None, 1.0, 0
        image, length, _ = made(self.texture, width, self.texture_length)
        return image, length, 2 if is_coloured(image) else 1
