"""Draws that the fixed-function pipeline makes by itself, without a shader of anybody's."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from glshim.model.batch import PolygonBatch
from glshim.styling.former import accept
from glshim.styling.values import Body, Colour


@dataclass(frozen=True, slots=True)
class BackFaces:
    """The sides of back-facing polygons as lines, where the layer's depth does not hide them.

    The two passes of J. Lander, "Under the Shade of the Rendering Tree" (2000), as described by P.
    Rideout, "Silhouette Extraction" (2010), "Old School Silhouettes": glPolygonMode(GL_BACK,
    GL_LINE) with depth less-or-equal over front faces with depth less. The front faces are the
    app's own, or flat ones. Of one layer all are filled before any line is drawn.
    """

    bodies: tuple[Body, ...]
    """`Layer.bodies`, or some."""
    width: float
    """glLineWidth, pixels: half of it lies outside a silhouette, and front faces hide the rest."""
    ink: Colour
    fill: Colour | None = None
    """What front faces are filled with; None: they stay as they are."""
    smooth: bool = True
    """GL_LINE_SMOOTH."""
    dash: float = 0.0
    """Pixels of a dash with the gap after it, as glLineStipple has them; 0: none."""


def _former(args: tuple[Any, ...], given: dict[str, Any]) -> dict[str, Any] | None:
    """``BackFaces(batch, camera, width, ink, fill, smooth)``."""
    if not (args and isinstance(args[0], PolygonBatch)) and "batch" not in given:
        return None
    names = ("batch", "camera", "width", "ink", "fill", "smooth")
    named = {**dict(zip(names, args, strict=False)), **given}
    return {"bodies": (Body((named.pop("batch"),), named.pop("camera")),), **named}


accept(BackFaces, _former, "BackFaces(layer.bodies, width, ink, ...), once a layer")
