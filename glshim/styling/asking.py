"""What a styler asks for, and draws with, by its options."""

from __future__ import annotations

from glshim.model.batch import Wanted
from glshim.styling.protocol import Styler


def wanted(styler: Styler) -> Wanted:
    """What its polygons shall come with."""
    return Wanted(
        colours=styler.wants_colours, normals=styler.wants_normals, lights=styler.wants_lights
    )
