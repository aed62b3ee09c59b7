"""Edges of solids that stand side by side, whatever the viewer: those on which another solid's lie,
and those that are inside, or in a face, of what the solids make together.

Around an edge each solid is a wedge. Where wedges meet in a face, that face is inside; what is left
of all of them is the edge of the whole: nothing, where they fill the space around it, or one flat
face.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple, Protocol

import numpy as np

from glshim.geometry.edges.folds import Topology
from glshim.geometry.edges.pieces import pieces
from glshim.geometry.recovery.junctions import PARTED
from glshim.geometry.recovery.welding import weld
from glshim.model.arrays import Doubles, Flags, Floats, Rows
from glshim.model.camera import cofactors
from glshim.model.vectors import cross, dot, unit

_FLAT = 0.03
"""Radians by which faces side by side in one plane may bend, as in ``stroke.glsl``."""


class Solid(Protocol):
    """What is asked of an object (`glshim.linework.feature_lines.EdgeLines`)."""

    topology: Topology
    positions: Floats
    """(V, 3) object space."""
    normals: Doubles
    """(T, 3) unit, object space."""

    @property
    def sharp(self) -> Rows:
        """(S,) sharp edges."""

    @property
    def outward(self) -> Doubles:
        """(T,) +1 where normals point out of a solid, -1 where they point into it, 0 of open
        surfaces."""


class Touching(NamedTuple):
    """Edges (E,) of an object."""

    shared: Flags
    """Sharp edges on which, or on a part of which, sharp edges of other objects lie."""
    inside: Flags
    """Of those the ones that are no edges of the whole."""


def touching(objects: Sequence[tuple[Solid, Doubles]]) -> list[Touching]:
    """Of objects, each under its modelview (4, 4)."""
    found = _Found(objects)
    shared, inside = found.decided
    result, first = [], 0
    for (lines, _), rows in zip(objects, found.rows, strict=True):
        own = Touching(*(np.zeros(len(lines.topology.edges), np.bool_) for _ in range(2)))
        part = slice(first, first + len(rows))
        own.shared[rows], own.inside[rows] = shared[part], inside[part]
        result.append(own)
        first += len(rows)
    return result


def sharp_sides(objects: Sequence[tuple[Solid, Doubles]]) -> Floats:
    """(N, 6) the sharp edges of objects, one after the other, in eye space."""
    with np.errstate(over="ignore", invalid="ignore"):
        ends = [
            lines.positions[lines.topology.edges[lines.sharp]] @ at[:3, :3].T + at[:3, 3]
            for lines, at in objects
        ]
        sides = np.concatenate(ends).reshape(-1, 6).astype(np.float32)
    return np.where(np.isfinite(sides), sides, np.float32(0.0))


class _Found:
    """The sharp edges of all objects, one after the other (N of them), in eye space."""

    def __init__(self, objects: Sequence[tuple[Solid, Doubles]]) -> None:
        self._objects = objects
        self.rows = [lines.sharp for lines, _ in objects]
        self._owner = np.repeat(np.arange(len(objects)), [len(rows) for rows in self.rows])
        self._sides = sharp_sides(objects)

    @cached_property
    def decided(self) -> tuple[Flags, Flags]:
        """(N,) and (N,) of `Touching`."""
        count = len(self._sides)
        parent, edge, size = np.arange(count), *_met(self._sides)
        shared = size[edge] > 1
        cut = pieces(self._sides, parent.astype(np.int32), np.flatnonzero(~shared), None)
        if cut is not None:
            sides, parent = cut
            edge, size = _met(sides)
            shared = np.zeros(count, np.bool_)
            shared[parent[size[edge] > 1]] = True
        inside = np.zeros(count, np.bool_)
        if shared.any():
            whole = np.zeros(len(parent), np.bool_)
            together = np.flatnonzero(size[edge] > 1)
            whole[together] = self._filled(parent[together], edge[together])
            outside = np.bincount(parent, ~whole, minlength=count)
            inside = shared & (outside == 0)
        return shared, inside

    def _filled(self, which: Rows, edge: Rows) -> Flags:
        """(M,) whether around their edges (M,), by number, sharp edges (M,) leave nothing or one
        flat face."""
        numbers, first, edge = np.unique(edge, return_index=True, return_inverse=True)
        used, where = np.unique(which, return_inverse=True)
        into, out, sound = self._wedges(used)
        ends = self._sides[which[first]].astype(np.float64)
        axis = unit(ends[:, 3:6] - ends[:, :3])[edge]
        x = into[where[first], 0][edge]
        x = unit(x - axis * dot(x, axis)[:, None])
        y = cross(axis, x)
        even = np.zeros((len(numbers), 2), np.complex128)
        for face in range(2):
            u, m = into[where, face], out[where, face]
            turn = np.arctan2(dot(u, y), dot(u, x))
            sign = -np.sign(dot(m, cross(axis, u)))  # 1: the solid lies counter-clockwise of it
            for k, times in enumerate((2.0, 4.0)):
                term = sign * np.exp(1j * times * turn)
                even[:, k] += np.bincount(edge, term.real) + 1j * np.bincount(edge, term.imag)
        # A face and the one that goes on are alike in even harmonics; so two that meet, and two
        # that go on in one plane, cancel out.
        left = (np.abs(even) > (2.0 * _FLAT, 4.0 * _FLAT)).any(axis=1)
        left |= np.bincount(edge, ~sound[where]) > 0
        return np.asarray(~left[edge])

    def _wedges(self, which: Rows) -> tuple[Doubles, Doubles, Flags]:
        """(M, 2, 3) the directions into both faces from sharp edges, (M, 2, 3) normals out of the
        solid, and (M,) whether there is one."""
        into, out = np.zeros((len(which), 2, 3)), np.zeros((len(which), 2, 3))
        sound = np.zeros(len(which), np.bool_)
        starts = np.concatenate(([0], np.cumsum([len(rows) for rows in self.rows])))
        for owner in np.unique(self._owner[which]):
            lines, modelview = self._objects[owner]
            at = np.flatnonzero(self._owner[which] == owner)
            rows = self.rows[owner][which[at] - starts[owner]]
            topology, turn = lines.topology, cofactors(modelview).T
            mirrored = -1.0 if np.linalg.det(modelview[:3, :3]) < 0.0 else 1.0
            ends = self._sides[which[at]].astype(np.float64)
            along = unit(ends[:, 3:6] - ends[:, :3])
            for face, (triangle, way) in enumerate(((topology.a, 1.0), (topology.b, -1.0))):
                normals = unit(lines.normals[triangle[rows]] @ turn)
                into[at, face] = cross(normals, way * along)
                out[at, face] = normals * (mirrored * lines.outward[triangle[rows]])[:, None]
            sound[at] = (lines.outward[topology.a[rows]] != 0.0) & ~topology.twisted[rows]
        return into, out, sound


def _met(sides: Floats) -> tuple[Rows, Rows]:
    """(N,) the edge of each of sides (N, 6), by number, and how many lie on each."""
    if not len(sides):
        return np.empty(0, np.intp), np.empty(0, np.intp)
    points = sides.reshape(-1, 3)
    extent = float((points.max(axis=0) - points.min(axis=0)).max())
    ends = np.sort(weld(points, extent * PARTED)[1].reshape(-1, 2).astype(np.int64), axis=1)
    alone = ends[:, 0] == ends[:, 1]  # shorter than that: an edge of its own
    key = np.where(alone, -1 - np.arange(len(ends)), ends[:, 0] << 32 | ends[:, 1])
    _, edge, size = np.unique(key, return_inverse=True, return_counts=True)
    return edge.reshape(-1), size
