"""Stylers for pictures that are larger than the program's window."""

from __future__ import annotations

from dataclasses import fields

from glshim.styling.composite import Composite
from glshim.styling.options import options_of
from glshim.styling.protocol import Styler


def enlarged(styler: Styler, scale: float) -> Styler:
    """The styler with its options in pixels scaled, past their ranges."""
    if scale == 1.0:
        return styler
    if isinstance(styler, Composite):
        return Composite(tuple(enlarged(part, scale) for part in styler.parts))
    kind = type(styler)
    lengths = {each.name for each in options_of(kind) if each.unit == "px"}
    found = object.__new__(kind)  # its checks hold for what people ask for
    for field in fields(styler):
        value = getattr(styler, field.name)
        long = field.name in lengths and value is not None
        object.__setattr__(found, field.name, value * scale if long else value)
    return found
