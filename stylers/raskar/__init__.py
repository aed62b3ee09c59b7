"""Style ``raskar``: silhouettes, ridges, valleys and intersections.

R. Raskar, "Hardware Support for Non-photorealistic Rendering", Graphics Hardware 2001,
sections 2.1 to 2.4. The formulas stand in `glshim.geometry.raskar`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from importlib.resources import files
from math import cos, radians, sin
from typing import ClassVar

from glshim.geometry.raskar import INWARD
from glshim.model.lines import GROUPS
from glshim.styling.pictures import Image
from glshim.styling.protocol import (
    Colour,
    Layer,
    Lines,
    Medium,
    Shader,
    Styler,
    Uniform,
    option,
)
from glshim.styling.wishes import Choice, Pattern
from stylers import options, strokes
from stylers.raskar.expansion import expand

_HERE = files(__package__)


def _text(name: str) -> str:
    return (_HERE / f"{name}.glsl").read_text("utf-8")


_STROKE = _text("stroke")
SHADER = Shader(
    "raskar",
    _STROKE + _text("trace") + _text("raskar.vert"),
    _STROKE + _text("raskar.frag"),
    vertices=4,
    expand=expand,
)


@dataclass(frozen=True)
class Raskar(Styler):
    """Ink on silhouettes, ridges, valleys and intersections (Raskar 2001)."""

    name: ClassVar[str] = "raskar"

    silhouettes: bool = option(True, help="ink where front-facing polygons meet back-facing ones")
    ridges: bool = option(True, help="ink where the dihedral angle is at most ridge_angle")
    valleys: bool = option(True, help="ink where the dihedral angle is more than valley_angle")
    intersections: bool = option(
        False, help="ink where polygons pass through each other (draws them twice more)"
    )
    silhouette_width: float = option(
        2.5, help="width of a silhouette, outside the object", low=0.5, high=64.0, unit="px"
    )
    ridge_width: float = option(
        2.5, help="width of a ridge, half on either side of the edge", low=0.5, high=64.0, unit="px"
    )
    valley_width: float = option(
        2.5,
        help="width of a valley, half on either side of the edge",
        low=0.5,
        high=64.0,
        unit="px",
    )
    intersection_width: float = option(
        2.5, help="width of an intersection, half on either side", low=0.5, high=64.0, unit="px"
    )
    ridge_angle: float = option(
        120.0, help="greatest dihedral angle of a ridge", low=0.0, high=360.0, unit="degrees"
    )
    valley_angle: float = option(
        240.0, help="a valley has a greater dihedral angle", low=0.0, high=360.0, unit="degrees"
    )
    connectivity: bool = option(
        True, help="off: no polygon knows its neighbours, depth alone decides, as in the paper"
    )
    texture: str = options.texture("silhouettes")
    texture_length: float = options.texture_length("a silhouette")
    texture_on: str = option(
        "silhouettes", help="the lines that have the texture", choices=("silhouettes", "all")
    )
    ink: Colour = option("#000000", help="colour of the lines")  # noqa: RUF009
    fill: str | Colour = options.fill()  # noqa: RUF009

    def draws(self, layer: Layer) -> Iterable[Lines]:
        """Rings around back-facing polygons, strokes on front-facing ones."""
        if not (self.silhouettes or self.ridges or self.valleys or self.intersections):
            return
        ridge, valley = radians(self.ridge_angle), radians(self.valley_angle)
        pattern, image, tinted = self._stroke()
        choice = Choice(
            silhouettes=self.silhouettes,
            ridge_angle=ridge if self.ridges else None,
            valley_angle=valley if self.valleys else None,
            intersections=self.intersections,
            connectivity=self.connectivity,
        )
        uniforms: dict[str, Uniform] = {
            "widths": (*self._widths, *(GROUPS - 4) * (1.0,)),
            "ridge_turn": (cos(ridge), sin(ridge)),
            "valley_turn": (cos(valley), sin(valley)),
            "inks": GROUPS * (self.ink,),
            "hidden_share": 0.0,
            "textured": float(pattern is not None),
            "tinted": tinted,
            "dashes": 0.0,
        }
        yield Lines(layer.bodies, choice, Medium(SHADER, uniforms, image, pattern))

    @property
    def _widths(self) -> tuple[float, float, float, float]:
        return self.silhouette_width, self.ridge_width, self.valley_width, self.intersection_width

    def _stroke(self) -> tuple[Pattern | None, Image | None, float]:
        """The texture: how it repeats, on narrower lines sooner; its image; 1.0 where that takes
        the colour of the ink."""
        if self.texture == "none":
            return None, None, 1.0
        width = self.silhouette_width
        image, length, coloured = strokes.made(self.texture, width, self.texture_length)
        silhouettes, *others = (length * own / width for own in self._widths)
        if self.texture_on == "silhouettes":
            others = [0.0, 0.0, 0.0]
        ridges, valleys, intersections = others
        pattern = Pattern((silhouettes, ridges, valleys, intersections), width / 2.0 - INWARD)
        return pattern, image, 0.0 if coloured else 1.0
