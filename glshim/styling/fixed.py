"""Draws that the fixed-function pipeline makes by itself, without a shader of anybody's."""

from __future__ import annotations

from dataclasses import dataclass

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.styling.values import Colour


@dataclass(frozen=True, slots=True)
class BackFaces:
    """The sides of back-facing polygons as lines, where the layer's depth does not hide them.

    The two passes of J. Lander, "Under the Shade of the Rendering Tree" (2000), as P. Rideout
    tells them in "Silhouette Extraction" (2010), "Old School Silhouettes": glPolygonMode(GL_BACK,
    GL_LINE) with depth less-or-equal over front faces with depth less. The front faces are the
    app's own, or flat ones. Of one layer all are filled before any line is drawn.
    """

    batch: PolygonBatch
    camera: Camera
    width: float
    """glLineWidth, pixels: half of it lies outside a silhouette, and front faces hide the rest."""
    ink: Colour
    fill: Colour | None = None
    """What front faces are filled with; None: they stay as they are."""
    smooth: bool = True
    """GL_LINE_SMOOTH."""
