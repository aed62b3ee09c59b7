"""Style ``edge_mesh``: feature edges from a mesh that is recovered from the stream.

M. McGuire, J. F. Hughes, "Hardware-Determined Feature Edges", NPAR 2004.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from importlib.resources import files
from math import cos, radians
from typing import ClassVar

from glshim.styling.passes import MeshShader, Pass, bodies
from glshim.styling.protocol import Colour, Draw, Layer, Styler, option

_HERE = files(__package__)
THIN = MeshShader("edge_mesh thin", *((_HERE / f"thin.{kind}.glsl").read_text("utf-8") for kind in ("vert", "frag")))


@dataclass(frozen=True)
class EdgeMesh(Styler):
    name: ClassVar[str] = "edge_mesh"
    ink: Colour = option("#000000", help="colour of the lines")  # noqa: RUF009

    def draws(self, layer: Layer) -> Iterable[Draw | Pass]:
        yield Pass(THIN, bodies(layer), "edges", "lines", uniforms={"wanted": 31, "turns": (cos(radians(120)), cos(radians(120))), "inks": ((0.,0.,0.),(1.,0.,0.),(0.,.6,0.),(0.,0.,1.),(1.,0.,1.))})
