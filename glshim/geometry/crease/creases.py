"""Creases of a recovered mesh, and the crease differences by which a shader finds them.

B. Hajagos, L. Szecsi, B. Csebfalvi, "Fast silhouette and crease edge synthesis with geometry
shaders", SCCG 2012, sections 3 and 4. Object space. The paper's topology vertices are the app's
vertex records; here they are found from what the app sent at every corner, see
`smoothing_groups`, so that soups and meshes without normals have them too.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.crease.smoothing_groups import (
    Strips,
    following,
    topology_vertices,
    within_adjacency,
)
from glshim.geometry.recovery.halfedges import twins, with_adjacency
from glshim.geometry.recovery.mesh import Mesh
from glshim.geometry.recovery.welding import mixed
from glshim.model.arrays import Doubles, Flags, Floats, Indices
from glshim.model.vectors import dot, unit

Rule = Literal["normals", "angle", "either"]

_TOPOLOGY: tuple[str, ...] = ("adjacency", "strips")
"""What is derived from the connectivity and the creases alone."""
_DEFAULT = np.array((0.0, 0.0, 1.0), np.float32)
"""OpenGL's normal where a program says nothing."""
INVALID = np.float32(2.0)
"""The verifier of a vertex that no crease touches; those of others are sines, -1..1."""
_ALIKE = 1e-3
"""Unit normals no further apart than this are one."""
_POINTED = 0.82
"""A vertex has no normal where the mean of unit vectors around it is shorter: 35 degrees off."""
_UNIT = 1e-3
"""By how much the length of a neighbour's direction may differ from 1 (float32)."""
_SINE = 1e-3
"""By how much a verifier may be missed (float32)."""


class Criterion(NamedTuple):
    """Which edges between two triangles are creases."""

    rule: Rule
    """"normals": the app's normals differ at an end; "angle": the triangles turn; "either"."""
    angle: float
    """Radians by which triangles at least turn to be a crease by angle."""
    least: float
    """Radians by which triangles at least turn for differing normals to count. 0: always, as
    section 3 defines creases."""


class Sides(NamedTuple):
    """The edges of a mesh as halfedges, and what stays of them when it moves."""

    one: Indices
    """(E,) the halfedge of triangle A."""
    other: Indices
    """(E,) that of triangle B, -1 where there is none."""
    twins: Indices
    """(3 T,) the halfedge on the other side of each, as `recovery.halfedges.twins`."""
    parted: Flags
    """(E,) the app's normals differ at an end."""


@dataclass(frozen=True, eq=False)
class Creases:
    """The creases of a mesh and its topology vertices. Halfedge 3 t + k runs from corner k of
    triangle t to the next.

    Creases are edges between two triangles as the criterion says, boundary edges and sides of
    non-manifold edges (one halfedge each, with nothing on the other side) and twisted edges, over
    which no normal can be continuous. Sides inside a polygon never are.
    """

    mesh: Mesh
    criterion: Criterion
    vertices: Indices
    """(N,) the mesh's vertex of each topology vertex. The first V are 0..V-1."""
    triangles: Indices
    """(T, 3) topology vertices."""
    sides: Flags
    """(T, 3) halfedge 3 t + k is a crease halfedge: the exact indicator of section 6."""
    open: Flags
    """(T, 3) the crease halfedges with no triangle on the other side."""
    halfedges: Sides
    corner_normals: Floats | None
    """(T, 3, 3) what the app sent."""

    @cached_property
    def adjacency(self) -> Indices:
        """(T, 6) topology vertices in the order of GL_TRIANGLES_ADJACENCY."""
        return with_adjacency(self.triangles, self.halfedges.twins)

    @cached_property
    def strips(self) -> Strips:
        """(N,) and (N,) the crease halfedges that come in and go out at topology vertices."""
        return within_adjacency(self.triangles, self.sides, len(self.vertices))

    @cached_property
    def differences(self) -> Floats:
        """(N, 4) the crease difference and the verifier of each topology vertex (section 4).

        With unit directions e_in and e_out of the crease segments before and after it:
        e_out - e_in, and the x of e_in x e_out. Reflecting one direction on the difference gives
        the other. A strip that has no other segment here goes straight on: zeros. Invalid (the
        verifier is 2, the rest 0) where no crease is.
        """
        incoming, outgoing = self.strips
        out = np.zeros((len(self.vertices), 4), np.float32)
        out[:, 3] = INVALID
        out[(incoming >= 0) | (outgoing >= 0), 3] = 0.0
        both = np.flatnonzero((incoming >= 0) & (outgoing >= 0))
        corners = self.mesh.triangles.ravel()
        after = following(len(self.triangles))
        path = (corners[incoming[both]], self.vertices[both], corners[after[outgoing[both]]])
        points = self.mesh.positions
        before, here, ahead = (points.take(v, axis=0).astype(np.float64) for v in path)
        with np.errstate(invalid="ignore", over="ignore"):
            e_in, e_out = unit(here - before), unit(ahead - here)
            out[both, :3] = e_out - e_in
            out[both, 3] = e_in[:, 1] * e_out[:, 2] - e_in[:, 2] * e_out[:, 1]
        return out

    @property
    def normals(self) -> Floats:
        """(N, 3) of `facing`."""
        return self.facing[0]

    @cached_property
    def facing(self) -> tuple[Floats, Floats]:
        """(N, 3) unit normals of topology vertices, on the side from which the triangles wind
        counter-clockwise; zero where there is none.

        The mean of what the app sent at the fan's corners, else that of the triangles' normals
        weighted by their angles. An app's normal that points to the other side is turned round:
        silhouettes are zeros of n.c, whose sign must not jump within a surface. At the tip of a
        cone, where what is sent or the triangles point all around, there is none: so n.c is zero
        there, and silhouettes run into it.

        And (N,) 1 where the app's points that way, -1 where it is turned round, 0 where none was
        sent.
        """
        if self.triangles is self.mesh.triangles:
            around = self.mesh.vertex_normals
        else:
            # Of this other mesh only positions and triangles are looked at.
            points = self.mesh.positions.take(self.vertices, axis=0)
            around = replace(self.mesh, positions=points, triangles=self.triangles).vertex_normals
        own = self.corner_normals
        sent = np.repeat(self.mesh.normals, 3, axis=0)
        if own is not None:
            sent = _known(own.reshape(-1, 3))
        corners, count = self.triangles.ravel(), len(self.vertices)
        axes = [np.bincount(corners, weights=axis, minlength=count) for axis in sent.T]
        total: Doubles = np.stack(axes, axis=1).astype(np.float64)
        length = np.sqrt(dot(total, total))
        chosen, way = around, np.zeros(count, np.float32)
        if own is not None:
            # Normals that cancel out, but for rounding, say nothing.
            way[length > _ALIKE] = 1.0
            way[dot(total, around) < 0.0] *= -1.0
            chosen = np.where(way[:, None] != 0.0, unit(total) * way[:, None], around)
        said = np.bincount(corners, weights=sent.any(axis=1), minlength=count)
        chosen = np.where((length < _POINTED * said)[:, None], 0.0, chosen)
        return chosen.astype(np.float32), way

    @property
    def nbytes(self) -> int:
        """Memory of the arrays, the derived ones among them but not the mesh, for caches."""
        sent = 0 if self.corner_normals is None else self.corner_normals.nbytes
        own = (self.vertices, self.triangles, self.sides, self.open, *self.halfedges)
        derived = 24 * len(self.triangles) + 36 * len(self.vertices)
        return sent + derived + sum(a.nbytes for a in own)

    def moved(self, mesh: Mesh, corner_normals: Floats | None = None) -> Creases:
        """The creases of `Mesh.moved`, with what the app sends at its corners now.

        Where the app's normals differed they still do; angles are measured again. None: no
        normals are known now. The result is that of `creases` for the same normals' differences,
        but for the numbers of topology vertices.
        """
        if mesh.triangles is not self.mesh.triangles:
            raise ValueError("the mesh has another connectivity")
        corner_normals = _meant(mesh, corner_normals)
        flags = _edges(mesh, self.criterion, self.halfedges.parted)
        was = np.asarray(self.sides.ravel()[self.halfedges.one])
        if not np.array_equal(flags, was):
            return _build(mesh, self.criterion, flags, self.halfedges, corner_normals)
        moved = replace(self, mesh=mesh, corner_normals=corner_normals)
        moved.__dict__.update({k: self.__dict__[k] for k in _TOPOLOGY if k in self.__dict__})
        return moved


def creases(
    mesh: Mesh,
    corner_normals: Floats | None = None,
    *,
    rule: Rule = "either",
    angle: float = np.radians(40.0),
    least: float = np.radians(20.0),
) -> Creases:
    """The creases of a mesh by a rule, see `Criterion`; angles in radians.

    corner_normals (T, 3, 3): what the app sent at each corner of `mesh.triangles`, of any length;
    zero or not finite: unknown, which differs from nothing.
    """
    corner_normals = _meant(mesh, corner_normals)
    one, other = (np.ascontiguousarray(side) for side in mesh.halves.T)
    parted = np.zeros(len(one), np.bool_)
    if corner_normals is not None and rule != "angle":
        parted = _parted(mesh, one, other, corner_normals)
    criterion = Criterion(rule, float(angle), float(least))
    flags = _edges(mesh, criterion, parted)
    halves = Sides(one, other, twins(mesh), parted)
    return _build(mesh, criterion, flags, halves, corner_normals)


def decoded(found: Creases, positions: NDArray[np.floating]) -> Flags:
    """(T, 3) which halfedges the paper's shader takes for creases, from the differences alone.

    positions (V, 3) of the mesh. In float32, as a shader has it: both ends are valid, the
    directions before and after that the differences give have unit length, and their cross
    products with the halfedge give the verifiers. `Creases.sides` is what it should be.
    """
    corners = positions.astype(np.float32).take(found.mesh.triangles, axis=0)
    held = found.differences.take(found.triangles, axis=0)
    out = np.zeros(found.triangles.shape, np.bool_)
    for k in range(3):
        a, b = held[:, k], held[:, (k + 1) % 3]
        along = corners[:, (k + 1) % 3] - corners[:, k]
        e = along / np.maximum(np.sqrt((along * along).sum(axis=1)), np.float32(1e-30))[:, None]
        before, after = e - a[:, :3], e + b[:, :3]
        meets = (a[:, 3] < INVALID) & (b[:, 3] < INVALID)
        for way, verifier, u, v in ((before, a[:, 3], before, e), (after, b[:, 3], e, after)):
            meets &= np.abs(np.sqrt((way * way).sum(axis=1)) - 1.0) < _UNIT
            meets &= np.abs(u[:, 1] * v[:, 2] - u[:, 2] * v[:, 1] - verifier) < _SINE
        out[:, k] = meets
    return out


def _meant(mesh: Mesh, sent: Floats | None) -> Floats | None:
    """Normals (T, 3, 3) without those of components that turn and yet have (0, 0, 1) everywhere: so
    has a program that never sends any."""
    if sent is None:
        return None
    unset = sent[:, 0, 2] == _DEFAULT[2]
    if not unset.any():
        return sent
    unset &= (sent == _DEFAULT).all(axis=(1, 2))
    a, b = mesh.faces[unset[mesh.faces].all(axis=1) & (mesh.faces[:, 1] >= 0)].T
    turns = dot(mesh.normals[a], mesh.normals[b]) < 1.0 - _ALIKE
    if not turns.any():
        return sent
    label = mesh.components
    unsaid = (np.bincount(label, weights=~unset) == 0)[label]
    turning = np.zeros(len(sent), np.bool_)  # by component
    turning[label[a[turns]]] = True
    unsaid &= turning[label]
    return np.where(unsaid[:, None, None], np.float32(0.0), sent)


def _known(normals: Floats) -> Doubles:
    """(C, 3) unit normals, zero where normals (C, 3) are zero or not finite."""
    known = np.nan_to_num(normals.astype(np.float64), nan=0.0, posinf=0.0, neginf=0.0)
    known[~np.isfinite(normals).all(axis=1)] = 0.0
    return unit(known)


def _parted(mesh: Mesh, one: Indices, other: Indices, corner_normals: Floats) -> Flags:
    """(E,) two triangles meet, and what was sent at their corners differs at an end."""
    sent = np.ascontiguousarray(corner_normals, np.float32).reshape(-1, 3)
    after = following(len(mesh.triangles))
    parted = np.zeros(len(one), np.bool_)
    met = np.flatnonzero(other >= 0)
    h, g = one.take(met), other.take(met)
    near, far = after.take(g), g
    if mesh.twisted.any():
        along = mesh.twisted[met]
        near, far = np.where(along, far, near), np.where(along, near, far)
    ends, others = np.concatenate((h, after.take(h))), np.concatenate((near, far))
    # Most are equal, as a number of 64 bits for each says; only the others are normalised.
    key = mixed(sent.view(np.int32).T)
    at = np.flatnonzero(key.take(ends) != key.take(others))
    m, n = _known(sent[ends[at]]), _known(sent[others[at]])
    apart = (dot(m - n, m - n) > _ALIKE * _ALIKE) & m.any(axis=1) & n.any(axis=1)
    parted[met[at[apart] % max(len(met), 1)]] = True
    return parted


def _edges(mesh: Mesh, criterion: Criterion, parted: Flags) -> Flags:
    """(E,) which edges are creases."""
    alone = mesh.faces[:, 1] < 0
    flags = alone | mesh.twisted
    if criterion.rule != "angle":
        flags |= parted & _turning(mesh, criterion.least, parted)
    if criterion.rule != "normals":
        flags |= _turning(mesh, criterion.angle, None)
    return np.asarray(flags & mesh.true)


def _turning(mesh: Mesh, least: float, some: Flags | None) -> Flags:
    """(E,) two triangles turn by at least so many radians; only some edges (E,) need be asked."""
    if least <= 0.0:
        return np.asarray(mesh.faces[:, 1] >= 0)
    turning = np.zeros(len(mesh.edges), np.bool_)
    at = np.flatnonzero(mesh.faces[:, 1] >= 0 if some is None else some)
    a, b = (mesh.faces[at, k] for k in (0, 1))
    m, n = (mesh.polygon_normals.take(own, axis=0) for own in (a, b))
    # Of a triangle that has lost its area nothing is known.
    cosine = np.where(m.any(axis=1) & n.any(axis=1), dot(m, n), 1.0)
    turning[at] = cosine <= np.cos(min(least, np.pi))
    return turning


def _build(
    mesh: Mesh, criterion: Criterion, flags: Flags, halves: Sides, sent: Floats | None
) -> Creases:
    """The creases that edges (E,) are flagged to be."""
    one, other, twins, _ = halves
    sides = np.zeros(mesh.triangles.size, np.bool_)
    sides[one[flags]] = True
    sides[other[flags & (other >= 0)]] = True
    opened = sides & (twins < 0)
    joined = np.where(sides, np.int32(-1), twins)
    if mesh.twisted.any():
        joined[one[mesh.twisted]] = joined[other[mesh.twisted]] = -1
    triangles, vertices = topology_vertices(mesh.triangles, joined, len(mesh.positions))
    return Creases(
        mesh=mesh,
        criterion=criterion,
        vertices=vertices,
        triangles=triangles,
        sides=sides.reshape(-1, 3),
        open=opened.reshape(-1, 3),
        halfedges=halves,
        corner_normals=sent,
    )
