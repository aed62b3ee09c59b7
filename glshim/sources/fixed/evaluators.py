"""What an evaluated grid depends on, as a key: the map, its domain and the grid."""

from __future__ import annotations

import ctypes
from collections.abc import Hashable
from typing import Any

from glshim.spec.driver import gl

_MAPS = {"glEvalMesh2": (0x0DB7, 0x0DB8), "glEvalMesh1": (0x0D97, 0x0D98)}
"""GL_MAP*_VERTEX_3 and _4."""
_GRIDS = {"glEvalMesh2": (0x0DD2, 0x0DD3), "glEvalMesh1": (0x0DD0, 0x0DD1)}
_COEFF, _ORDER, _DOMAIN = 0x0A00, 0x0A01, 0x0A02


def evaluator_key(name: str, args: tuple[Any, ...]) -> Hashable:
    """Equal keys, equal polygons of a glEvalMesh call."""
    parts: list[Hashable] = [name, tuple(int(a) for a in args)]
    for size, target in zip((3, 4), _MAPS[name], strict=True):
        if not gl.glIsEnabled(target):
            continue
        order = (ctypes.c_int * 2)(1, 1)
        gl.glGetMapiv(target, _ORDER, order)
        if name == "glEvalMesh1":
            order[1] = 1
        coefficients = (ctypes.c_float * (size * order[0] * order[1]))()
        domain = (ctypes.c_float * 4)()
        gl.glGetMapfv(target, _COEFF, coefficients)
        gl.glGetMapfv(target, _DOMAIN, domain)
        parts += [target, bytes(order), bytes(coefficients), bytes(domain)]
    domain_name, segments_name = _GRIDS[name]
    grid, segments = (ctypes.c_float * 4)(), (ctypes.c_int * 2)()
    gl.glGetFloatv(domain_name, grid)
    gl.glGetIntegerv(segments_name, segments)
    return (*parts, bytes(grid), bytes(segments))
