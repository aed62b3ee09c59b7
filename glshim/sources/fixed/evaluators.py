"""What an evaluated grid depends on, as a key: the map, its domain and the grid."""

from __future__ import annotations

import ctypes
from collections.abc import Hashable
from typing import Any

from glshim.driver.arguments import signed
from glshim.driver.ask import integers, is_enabled, reals
from glshim.driver.functions import gl
from glshim.spec.constants import GL_COEFF, GL_DOMAIN, GL_ORDER
from glshim.spec.draws import EVALUATOR_MESHES


def evaluator_key(name: str, args: tuple[Any, ...]) -> Hashable:
    """Equal keys, equal polygons of an EVALUATOR_MESH call."""
    mesh = EVALUATOR_MESHES[name]
    parts: list[Hashable] = [name, tuple(map(signed, args))]
    for target, size in mesh.maps:
        if not is_enabled(target):
            continue
        order = (ctypes.c_int * 2)(1, 1)
        gl.glGetMapiv(target, GL_ORDER, order)
        if mesh.dimensions == 1:
            order[1] = 1
        coefficients = (ctypes.c_float * (size * order[0] * order[1]))()
        domain = (ctypes.c_float * 4)()
        gl.glGetMapfv(target, GL_COEFF, coefficients)
        gl.glGetMapfv(target, GL_DOMAIN, domain)
        parts += [target, bytes(order), bytes(coefficients), bytes(domain)]
    return (*parts, reals(mesh.domain, 4), integers(mesh.segments, 2))
