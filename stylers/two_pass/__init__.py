"""Style ``two_pass``: silhouettes as they were drawn before there were shaders.

P. Rideout, "Silhouette Extraction", The Little Grasshopper, 2010, "Old School Silhouettes", after
J. Lander, "Under the Shade of the Rendering Tree", Game Developer, 2000: front faces are filled
(depth less), then back faces are drawn as lines (depth less-or-equal). What the front faces do not
hide of those lines is the outer half along silhouettes. No creases; the inside of an open surface
shows the sides of all its polygons.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.protocol import BackFaces, Colour, Layer, Styler, option

from ..shared import options


@dataclass(frozen=True)
class TwoPass(Styler):
    """Silhouettes by the fixed function alone: back faces as lines (Lander 2000, Rideout 2010)."""

    name: ClassVar[str] = "two_pass"
    alone: ClassVar[str] = "its lines lie below all that others draw; take crease or raskar"

    width: float = option(
        5.0, help="width of the lines, of which half shows outside an object; as far as the "
        "driver draws them", low=1.0, high=64.0, unit="px",
    )  # fmt: skip
    smooth: bool = option(True, help="lines with smooth edges (GL_LINE_SMOOTH)")
    ink: Colour = option("#000000", help="colour of the lines")
    fill: str | Colour = options.fill("the front faces")

    @property
    def surface(self) -> str | Colour:
        """Depth alone under flat front faces: those need no shader, as a colour here would."""
        return "app" if self.fill == "app" else "none"

    def draws(self, layer: Layer) -> Iterable[BackFaces]:
        """All of them at once."""
        fill = None if isinstance(self.fill, str) else self.fill
        yield BackFaces(layer.bodies, self.width, self.ink, fill, self.smooth)
