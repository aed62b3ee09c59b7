"""Patterns along strokes that stay where they were from frame to frame.

McGuire & Hughes 2004, section 4, give each edge a pattern of its own (object space: it jumps where
edges take over from each other) or cut it out of the screen (it swims under rotation), for their
GPU knew neither the next edge nor the last frame. Here strokes run on along chains by arc length
(`glshim.linework.walk`), and each takes the phase of what was drawn nearby in the frame
before.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.window import window
from glshim.linework.walk import Walk
from glshim.model.arrays import Complexes, Doubles, Rows, within
from glshim.model.camera import Camera
from glshim.model.vectors import dot, unit

NamedObjects = tuple[tuple[Hashable, Doubles], ...]
"""Name and modelview (4, 4) of each object."""

_REACH = 12.0
"""Pixels in which a stroke finds what it was."""
_STEP = 6.0
"""Pixels of a stroke for one sample."""
_MOST_SAMPLES = 64
"""Samples of one line."""
_CROWD = 24
"""Old samples in a cell that are looked at."""
_STIFFNESS = 12.0**2
"""Square of the pixels over which a pattern gives way to what was there."""
_ROUNDS = 60
_MOST_ALIKE = 200
"""NamedObjects of one name that are told apart by where they are; of more, by their order."""
_MOST_PASTS = 4
"""Pasts of a view."""
_DEPTH = 0.3
"""What a pixel's worth along the line of sight counts of one across: layers keep apart."""


@dataclass(frozen=True, slots=True, eq=False)
class Past:
    """What was drawn in a frame: samples of strokes."""

    points: Doubles
    """(N, 3) eye space, of the frame's camera."""
    along: Complexes
    """(N,) unit direction in the window."""
    phase: Doubles
    """(N,) repeats of the pattern, modulo one."""
    pace: Doubles
    """(N,) repeats a pixel."""
    group: Rows
    """(N,) of the lines."""
    owner: Rows
    """(N,) object, by number."""
    modelviews: tuple[Doubles, ...]
    """(4, 4) of each object."""
    names: tuple[Hashable, ...]
    """What each object is: of those of the same name in the next frame the nearest is the same."""

    @property
    def nbytes(self) -> int:
        """Memory, for caches."""
        return 96 * len(self.points) + 128 * len(self.names)


@dataclass(frozen=True, slots=True, eq=False)
class Drawn:
    """The lines of a frame."""

    walk: Walk
    a: Doubles
    """(L, 3) where lines begin, eye space."""
    b: Doubles
    """(L, 3) where they end."""
    group: Rows
    """(L,) of the lines."""
    owner: Rows
    """(L,) object of each, by number."""
    objects: NamedObjects


def keep(drawn: Drawn, camera: Camera) -> Past:
    """The past of the next frame."""
    walk = drawn.walk
    line, share, new = _sampled(drawn, camera)
    spread = walk.finish - walk.begin
    size = np.maximum(np.abs(walk.places[1] - walk.places[0]), 1e-9)
    return Past(
        new.points,
        new.along,
        np.mod(walk.begin[line] + share * spread[line], 1.0),
        spread[line] / size[line],
        new.group,
        drawn.owner[line],
        tuple(modelview for _, modelview in drawn.objects),
        tuple(name for name, _ in drawn.objects),
    )


def follow(drawn: Drawn, camera: Camera, past: Past) -> Walk:
    """The same strokes, as far along their pattern as what was drawn where they are now.

    Along each stroke the pattern is shifted by c, which minimises the sum of ``w |z - z'|^2`` and
    ``s |dz/dt|^2`` for ``z = exp(2 pi i c)``, with z' the shift to the nearest old sample: nearby
    the pattern stays where it was, over longer distances it has its own length.
    """
    walk = drawn.walk
    line, share, new = _sampled(drawn, camera)
    points, old = _now(past, drawn.objects, camera)
    if not len(line) or not len(old):
        return walk
    size = np.abs(walk.places[1] - walk.places[0])[line]
    before = _Samples(points, old, past.along, past.group)
    found = _nearest(new, before, camera)
    met = np.flatnonzero(found >= 0)
    if not len(met):
        return walk
    weight = np.maximum(size / np.bincount(line)[line], _STEP)[met]
    line, share, found = line[met], share[met], found[met]
    here = walk.begin[line] + share * (walk.finish - walk.begin)[line]
    ahead = ((new.places[met] - old[found]) * past.along[found].conj()).real
    apart = np.exp(2j * np.pi * (past.phase[found] + past.pace[found] * ahead - here))

    chain = _Chain(walk)
    shift = chain.fitted(line, share, weight, apart)
    return Walk(
        walk.begin + shift[0], walk.finish + shift[1], walk.stroke, walk.loop, walk.places
    )


class _Chain:
    """The ends of lines as nodes of their strokes: what ends where another begins is one node."""

    def __init__(self, walk: Walk) -> None:
        on = np.flatnonzero(walk.stroke >= 0)
        low = np.minimum(walk.begin, walk.finish)[on]
        order = on[np.lexsort((low, walk.stroke[on]))]
        stroke = walk.stroke[order]
        first = np.flatnonzero(np.append(True, stroke[1:] != stroke[:-1]))
        last = np.append(first[1:], len(order)) - 1
        ends = np.arange(1, len(order) + 1)
        loops = walk.loop[order[first]] > 0.0
        ends[last] = np.where(loops, first, len(order) + np.arange(len(first)))
        self.count = len(order) + len(first)
        self._order, self._stroke_starts, self._loops = order, first, loops
        self._from, self._to = np.arange(len(order)), ends
        self._row = np.full(len(walk.stroke), -1, np.intp)
        self._row[order] = self._from
        size = np.abs(walk.places[1] - walk.places[0])[order]
        self._spring = _STIFFNESS / np.maximum(np.where(np.isfinite(size), size, 1.0), 0.5)
        self._forward = (walk.begin <= walk.finish)[order]

    def fitted(
        self, line: Rows, share: Doubles, weight: Doubles, wanted: Complexes
    ) -> tuple[Doubles, Doubles]:
        """(L,), (L,) the shift at both ends of all lines, from the wanted shifts of samples, as
        complex numbers of size one."""
        row = self._row[line]
        along = np.where(self._forward[row], share, 1.0 - share)
        low, high = self._from[row], self._to[row]

        def gathered(values: Complexes) -> Complexes:
            """To the nodes: of samples, by how near they are."""
            parts = ((values.real, values.imag) for _ in (0, 1))
            out = np.zeros(self.count, complex)
            for nodes, near, (x, y) in zip((low, high), (1.0 - along, along), parts, strict=True):
                out += np.bincount(nodes, near * x, self.count)
                out += 1j * np.bincount(nodes, near * y, self.count)
            return out

        def applied(z: Complexes) -> Complexes:
            pull = self._spring * (z[self._to] - z[self._from])
            out = gathered(weight * ((1.0 - along) * z[low] + along * z[high])) + 1e-9 * z
            for nodes, sign in ((self._from, -1.0), (self._to, 1.0)):
                out += sign * np.bincount(nodes, pull.real, self.count)
                out += sign * 1j * np.bincount(nodes, pull.imag, self.count)
            return out

        z = _solved(applied, gathered(weight * wanted))
        turn = np.angle(z) / (2.0 * np.pi)
        # Unwrapped along each stroke from its first node.
        jump = turn[self._to] - turn[self._from]
        jump -= np.rint(jump)
        total = np.cumsum(jump)
        before = total - jump
        base = turn[self._from[self._stroke_starts]] - before[self._stroke_starts]
        counts = np.diff(self._stroke_starts, append=len(self._order))
        before += np.repeat(base, counts)
        after = before + jump
        shifts = np.zeros((2, len(self._row)))
        shifts[0, self._order] = np.where(self._forward, before, after)
        shifts[1, self._order] = np.where(self._forward, after, before)
        return shifts[0], shifts[1]


def _solved(applied: Callable[[Complexes], Complexes], right: Complexes) -> Complexes:
    """Conjugate gradients, as far as a phase needs."""
    z = np.zeros_like(right)
    rest = right.copy()
    way, size = rest.copy(), float(np.vdot(rest, rest).real)
    goal = 1e-6 * size
    for _ in range(_ROUNDS):
        if size <= goal:
            break
        moved = applied(way)
        pace = size / max(float(np.vdot(way, moved).real), 1e-300)
        z += pace * way
        rest -= pace * moved
        size, before = float(np.vdot(rest, rest).real), size
        way = rest + size / max(before, 1e-300) * way
    return z


def _sampled(drawn: Drawn, camera: Camera) -> tuple[Rows, Doubles, _Samples]:
    """(N,) the line of each sample of a frame, (N,) how far along that in the window, 0..1, and
    the samples. Complexes in the window are those of the points, to the last bit: a line in
    perspective does not go by evenly."""
    line, share = _samples(drawn.walk)
    begin, step = drawn.a[line], (drawn.b - drawn.a)[line]
    points = begin + share[:, None] * step
    with np.errstate(all="ignore"):
        found = window(points, camera)
        places = found[:, 0] + 1j * found[:, 1]
        z0, z1 = drawn.walk.places
        way = (z1 - z0)[line]
        share = ((places - z0[line]) * way.conj()).real / np.abs(way) ** 2
        good = np.flatnonzero((share >= 0.0) & (share <= 1.0))  # not what clip planes cut off
    line, way = line[good], way[good]
    samples = _Samples(points[good], places[good], way / np.abs(way), drawn.group[line])
    return line, share[good], samples


def _samples(walk: Walk) -> tuple[Rows, Doubles]:
    """(N,) the line of each sample and (N,) how far along, 0..1: every `_STEP` pixels of a stroke,
    however short its lines are."""
    on = np.flatnonzero(walk.stroke >= 0)
    low = np.minimum(walk.begin, walk.finish)[on]
    order = on[np.lexsort((low, walk.stroke[on]))]
    size = np.abs(walk.places[1] - walk.places[0])[order]
    size = np.where(np.isfinite(size), size, 0.0)
    total = np.cumsum(size)
    stroke = walk.stroke[order]
    first = np.flatnonzero(np.append(True, stroke[1:] != stroke[:-1])) if len(order) else order
    lengths = np.diff(first, append=len(order))
    along = total - size - np.repeat((total - size)[first], lengths)
    begins, ends = (np.floor(place / _STEP + 0.5) for place in (along, along + size))
    counts = np.minimum(ends - begins, _MOST_SAMPLES).astype(np.intp)
    which = np.repeat(np.arange(len(order)), counts)
    number = within(counts)
    share = ((begins[which] + number + 0.5) * _STEP - along[which]) / np.maximum(size[which], 1e-9)
    crowded = (ends - begins)[which] > _MOST_SAMPLES
    share = np.where(crowded, (number + 0.5) / _MOST_SAMPLES, np.clip(share, 0.0, 1.0))
    line = order[which]
    return line, np.where(walk.begin[line] <= walk.finish[line], share, 1.0 - share)


def _now(
    past: Past, objects: NamedObjects, camera: Camera
) -> tuple[Doubles, Complexes]:
    """(N, 3) where old samples are now in eye space, moved with their objects, and (N,) in the
    window; NaN where that is not known."""
    before = tuple(zip(past.names, past.modelviews, strict=True))
    motions = np.full((len(before), 4, 4), np.nan)
    for old, new in paired(before, objects).items():
        try:
            motions[old] = objects[new][1] @ np.linalg.inv(before[old][1])
        except np.linalg.LinAlgError:
            motions[old] = np.eye(4)
    with np.errstate(all="ignore"):
        motion = motions[past.owner]
        points = np.einsum("nij,nj->ni", motion[:, :3, :3], past.points) + motion[:, :3, 3]
        found = window(points, camera)
    return points, np.asarray(found[:, 0] + 1j * found[:, 1])


def paired(before: NamedObjects, now: NamedObjects) -> dict[int, int]:
    """For objects of a frame, by number, which of the next frame they are: of those of one name
    the nearest. Those whose names are new go on from those whose names are gone, in their order:
    a surface that is made anew in each frame has no lasting connectivity."""
    found: dict[int, int] = {}
    by_name: dict[Hashable, tuple[list[int], list[int]]] = {}
    for k, objects in enumerate((before, now)):
        for number, (name, _) in enumerate(objects):
            by_name.setdefault(name, ([], []))[k].append(number)
    for old, new in by_name.values():
        found.update(_nearest_poses(old, new, before, now))
    gone = [number for old, new in by_name.values() if not new for number in old]
    fresh = [number for old, new in by_name.values() if not old for number in new]
    found.update(zip(sorted(gone), sorted(fresh), strict=False))
    return found


def _nearest_poses(
    old: list[int], new: list[int], before: NamedObjects, now: NamedObjects
) -> Iterable[tuple[int, int]]:
    """Pairs of objects of one name, the most alike poses first."""
    if len(old) == len(new) == 1 or max(len(old), len(new)) > _MOST_ALIKE:
        return zip(old, new, strict=False)
    one, other = (
        np.array([objects[number][1][:3].ravel() for number in numbers]).reshape(-1, 12)
        for numbers, objects in ((old, before), (new, now))
    )
    away = np.nan_to_num(((one[:, None] - other[None]) ** 2).sum(axis=2), nan=np.inf)
    pairs: list[tuple[int, int]] = []
    free = np.ones(away.shape, np.bool_)
    for place in np.argsort(away, axis=None, kind="stable").tolist():
        i, j = divmod(place, len(new))
        if free[i, j]:
            pairs.append((old[i], new[j]))
            free[i], free[:, j] = False, False
    return pairs


def latest(pasts: tuple[Past, ...], names: Sequence[Hashable]) -> Past | None:
    """Of several pasts of a view, the latest first, the one that shows most of some objects: an
    app may draw several layers in one viewport."""
    known = set(names)
    return max(pasts, key=lambda past: len(known.intersection(past.names)), default=None)


def kept_with(past: Past, pasts: tuple[Past, ...], before: Past | None) -> tuple[Past, ...]:
    """The pasts of a view with a new one, which takes the place of the one that it went on from
    if they have objects in common."""
    went_on = before is not None and not set(before.names).isdisjoint(past.names)
    others = tuple(one for one in pasts if not (went_on and one is before))
    return (past, *others)[:_MOST_PASTS]


@dataclass(frozen=True, slots=True, eq=False)
class _Samples:
    points: Doubles
    """(N, 3) eye space."""
    places: Complexes
    """(N,) the window."""
    along: Complexes
    group: Rows


def _nearest(new: _Samples, old: _Samples, camera: Camera) -> Rows:
    """(N,) the old sample nearest to each new one within `_REACH`, of its group and direction, or
    -1."""
    sound = np.flatnonzero(np.isfinite(old.places) & (np.abs(old.places) < 1e6))
    keys = _cell(old.places[sound])
    order = sound[np.argsort(keys, kind="stable")]
    keys = np.sort(keys)
    sight = unit(camera.viewpoint[:3] - camera.viewpoint[3] * new.points)
    w = np.abs(new.points @ camera.projection[3, :3] + camera.projection[3, 3])
    scale = abs(camera.projection[1, 1]) * camera.viewport[3] / 2.0 / np.maximum(w, 1e-9)
    best = np.full(len(new.places), -1, np.intp)
    nearest = np.full(len(new.places), _REACH)
    for right in (-1, 0, 1):
        for up in (-1, 0, 1):
            wanted = _cell(new.places + _REACH * (right + 1j * up))
            first, last = np.searchsorted(keys, wanted), np.searchsorted(keys, wanted, "right")
            for k in range(_CROWD):
                at = np.flatnonzero(first + k < last)
                if not len(at):
                    break
                who = order[first[at] + k]
                deep = dot(new.points[at] - old.points[who], sight[at]) * scale[at]
                away = np.hypot(np.abs(old.places[who] - new.places[at]), _DEPTH * deep)
                fits = (away < nearest[at]) & (old.group[who] == new.group[at])
                fits &= (old.along[who] * new.along[at].conj()).real > 0.5
                best[at[fits]], nearest[at[fits]] = who[fits], away[fits]
    return best


def _cell(places: Complexes) -> NDArray[np.int64]:
    """(N,) numbers of squares of `_REACH` pixels."""
    x, y = (np.floor(part / _REACH).astype(np.int64) for part in (places.real, places.imag))
    return np.asarray((x << np.int64(32)) + y)
