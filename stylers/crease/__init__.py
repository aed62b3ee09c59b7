"""Style ``crease``: creases as quads in the planes of their triangles, and smooth silhouettes.

B. Hajagos, L. Szecsi, B. Csebfalvi, "Fast silhouette and crease edge synthesis with geometry
shaders", SCCG 2012. Creases are found from what the app's own normals say, and by angle; crease
differences on the vertices tell the geometry shader where the next crease goes on.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import radians
from typing import Any, ClassVar, cast

from glshim.geometry.crease.creases import Criterion
from glshim.geometry.meshshaders.sieve import CREASE, SMOOTH
from glshim.styling.glsl import glsl
from glshim.styling.media.ink import STROKE
from glshim.styling.passes import MeshShader, Pass, Sieve, State, Weld
from glshim.styling.pictures import Image, is_coloured
from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names
from glshim.styling.textures import made
from glshim.styling.values import Body, Uniform

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


_KINDS = {"ridge": 1, "valley": 2, "boundary": 4, "contour": 8}
"""Bits in the shader of creases."""
_CREASES = ("ridge", "valley", "boundary")
_OLD = {f"crease_{part}": Renamed(tuple(f"{kind}_{part}" for kind in _CREASES))
        for part in ("width", "ink", "texture", "dash")}  # fmt: skip


@takes_old_names
@dataclass(frozen=True)
class Crease(Intersections, Boundaries, Valleys, Ridges, Contours):
    """Creases and the silhouettes of smooth surfaces (Hajagos et al. 2012).

    Verifiers draw what flags draw, but where a side that is no crease fits the differences at both
    its ends: diagonals of squares in planes along the x axis, of which a verifier is the product.
    """

    name: ClassVar[str] = "crease"
    former: ClassVar[Mapping[str, Renamed]] = former_names(
        (*_CREASES, "contour", "intersection"), **_OLD,
        creases=Renamed(("ridges", "valleys", "boundary")), angle=Renamed(("crease_angle",)),
    )  # fmt: skip

    width: float = options.width(2.5)
    ink: Colour = options.ink("#000000")
    texture: str = options.texture()
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    rule: str = option(
        "either",
        help="what makes a crease: different normals of the program's (normals), a bend between "
        "polygons (angle), or either",
        choices=("either", "normals", "angle"),
    )
    crease_angle: float = options.crease_angle(60.0)
    least_angle: float = option(
        20.0, help="smallest bend drawn as a crease where normals differ; 0: any, as in the paper",
        low=0.0, high=180.0, unit="degrees",
    )  # fmt: skip
    indicator: str = option(
        "flags",
        help="how the shader recognises creases: exact flags, or the paper's verifiers",
        choices=("flags", "verifiers"),
    )
    bias: float = option(
        1.5, help="depth tolerance of creases, in pixels of depth", low=0.0, high=64.0, unit="px"
    )
    fade: float = option(
        2.0, help="depth over which creases fade out beyond bias", low=0.0, high=64.0, unit="px"
    )
    spine: bool = option(
        True, help="test visibility along the middle of a crease; off: by soft depth alone"
    )
    hidden_by: str = option(
        "surfaces",
        help="what hides contours: all surfaces, or back faces only, as in the paper",
        choices=("surfaces", "back_faces"),
    )
    intersections: str = options.intersections("off")
    tolerance: float = options.tolerance(0.0)
    fill: str | Colour = options.fill()
    own_ink: str = options.own_ink()

    @property
    def wants_normals(self) -> bool:
        """Creases are where they differ, and silhouettes where they turn away."""
        return True

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """Triangles with adjacency, of which geometry shaders make the quads."""
        found = layer.bodies
        if not found:
            return
        looks = self.looks()
        creased = any(kind in looks for kind in _CREASES)
        if self.contours:
            if self.hidden_by == "back_faces":
                yield Pass(
                    found, BACK, "surface", state=_NEAREST, buffer=True, weld=self._weld, lines=True
                )
            plain = self.hidden_by == "surfaces"
            given: dict[str, Uniform] = {"creased": int(creased)}
            yield from self._lines(
                SILHOUETTES, found, looks["contour"], SMOOTH, plain=plain, given=given
            )
        yield from intersection_lines(self, self.intersections, layer)
        if not creased:
            return
        alike: dict[Look, int] = {}
        for kind, look in looks.items():
            if kind not in _KINDS:
                continue
            alike[look] = alike.get(look, 0) | _KINDS[kind]
        for look, kinds in alike.items():
            given = {
                "kinds": kinds, "parted": int(self.contours),
                "verified": int(self.indicator == "verifiers"),
            }  # fmt: skip
            yield from self._lines(CREASES, found, look, CREASE, plain=self.spine, given=given)

    @property
    def _weld(self) -> Weld:
        rule, angles = cast(Any, self.rule), (self.crease_angle, self.least_angle)
        return Weld(self.tolerance, Criterion(rule, *map(radians, angles)))

    def _lines(
        self,
        shaders: tuple[MeshShader, MeshShader],
        found: tuple[Body, ...],
        look: Look,
        wanted: int,
        *,
        plain: bool,
        given: Mapping[str, Uniform],
    ) -> Iterator[Pass]:
        """Lines of a look, the short ones apart where one answer says whether they are seen."""
        image, repeat, textured = self._stroke(look)
        apart = plain and not textured
        uniforms: dict[str, Uniform] = {
            **given,
            "half_width": look.width / 2.0,
            "ink": look.ink,
            "bias": self.bias,
            "fade": self.fade,
            "spine": int(self.spine),
            "back_faces": int(self.hidden_by == "back_faces"),
            "cuts": int(textured > 0),
            "apart": int(apart),
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

    def _stroke(self, look: Look) -> tuple[Image | None, float, int]:
        """The texture, the pixels after which it repeats, and 2 where it has its own colours."""
        if look.stroke is None:
            return None, 1.0, 0
        image, length, _ = made(look.texture, look.width, self.texture_length, look.dash)
        return image, length, 2 if is_coloured(image) else 1
