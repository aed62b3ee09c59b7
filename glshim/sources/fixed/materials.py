"""glMaterial inside primitives and lists: which colour it sets."""

from __future__ import annotations

from typing import Any

import numpy as np

from glshim.driver.arguments import name as name_among
from glshim.model.lights import MaterialChange
from glshim.sources.fixed.pointers import numbers_at
from glshim.spec.constants import (
    GL_AMBIENT,
    GL_AMBIENT_AND_DIFFUSE,
    GL_DIFFUSE,
)
from glshim.spec.roles import MATERIAL_TYPES
from glshim.system.interrupts import is_ours

_COLOURS = frozenset((GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE))
"""Parameters that are known here."""


def material_change(name: str, args: tuple[Any, ...]) -> MaterialChange | None:
    """What a call of MATERIAL says of ambient and diffuse colours; None: nothing, or what cannot be
    read."""
    letter = MATERIAL_TYPES.get(name)
    if letter is None:
        return None
    try:
        face, parameter = name_among(args, 0), name_among(args, 1)
        if parameter not in _COLOURS:
            return None
        values = numbers_at(args[2], letter, 4).astype(np.float64)
    except Exception as error:  # the driver took what we cannot read
        if not is_ours(error):
            raise
        return None
    if letter == "i":  # OpenGL 2.1, section 2.14, table 2.9
        values = (2.0 * values + 1.0) / (2.0**32 - 1.0)
    red, green, blue, alpha = values.tolist()
    return MaterialChange(face, parameter, (red, green, blue, alpha))
