"""What a styler asks for, and draws with, by its options."""

from __future__ import annotations

from glshim.model.batch import Wanted
from glshim.styling.options import options_of
from glshim.styling.protocol import Colour, Styler


def wanted(styler: Styler) -> Wanted:
    """What its polygons shall come with."""
    return Wanted(
        colours=styler.wants_colours, normals=styler.wants_normals, lights=styler.wants_lights
    )


def inks_of(styler: Styler) -> dict[str, Colour]:
    """The colours of its lines over the app's own background, by option; none where it brings one:
    ``ink`` and ``..._ink``, ``paper`` and ``fill`` are what styles call them."""
    if getattr(styler, "paper", "app") != "app" or not isinstance(styler.surface, str):
        return {}
    names = (option.name for option in options_of(type(styler)) if option.kind == "colour")
    inks = {name: getattr(styler, name) for name in names if f"_{name}".endswith("_ink")}
    return {name: ink for name, ink in inks.items() if ink is not None}
