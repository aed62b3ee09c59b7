"""Patterns along strokes that stay where they were from frame to frame.

McGuire & Hughes 2004, section 4, give each edge a pattern of its own (object space: it jumps where
edges take over from each other) or cut it out of the screen (it swims under rotation), for their
GPU knew neither the next edge nor the last frame. Here strokes run on along chains by arc length
(`glshim.linework.walk`), and each takes the phase of what was drawn nearby in the frame
before.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.window import window
from glshim.linework.pairing import NamedObjects, paired
from glshim.linework.phases import Chain
from glshim.linework.walk import Walk
from glshim.model.arrays import Complexes, Doubles, Flags, Rows, within
from glshim.model.camera import Camera
from glshim.model.vectors import dot, unit

_REACH = 12.0
"""Pixels in which a stroke finds what it was."""
_STEP = 6.0
"""Pixels of a stroke for one sample."""
_MOST_SAMPLES = 64
"""Samples of one line."""
_STRANGE = 3.0
"""Pixels by which what is not quite alike counts as farther away."""
_OTHER = 0.5
"""The same of another edge."""
_CROWD = 24
"""Old samples in a cell that are looked at."""
_OCTAVE = 1.9
"""How much too long or too short a pattern may become on the screen; more than the root of two."""
_MOST_STRETCHED = 1.9
"""How much so it stays anywhere along a stroke."""
_MOST_TURNED = np.radians(15.0)
"""In a frame."""
_MOST_PASTS = 4
"""Pasts of a view."""
_DEPTH = 0.3
"""What a pixel's worth along the line of sight counts of one across: layers keep apart."""


@dataclass(frozen=True, slots=True, eq=False)
class Past:
    """What was drawn in a frame: samples of strokes."""

    points: Doubles
    """(N, 3) eye space, of the frame's camera."""
    tips: Doubles
    """(N, 3) about a pixel farther along their lines."""
    phase: Doubles
    """(N,) repeats of the pattern, modulo one."""
    gain: Doubles
    """(N,) repeats from there to the tip."""
    group: Rows
    """(N,) of the lines."""
    owner: Rows
    """(N,) object, by number."""
    edge: Doubles
    """(N,) number of its own that an edge keeps (`Line.NUMBER`)."""
    modelviews: tuple[Doubles, ...]
    """(4, 4) of each object."""
    names: tuple[Hashable, ...]
    """What each object is: of those of the same name in the next frame the nearest is the same."""

    @property
    def nbytes(self) -> int:
        """Memory, for caches."""
        return 128 * len(self.points) + 128 * len(self.names)


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
    edge: Doubles
    """(L,) number of its own that an edge keeps (`Line.NUMBER`)."""
    objects: NamedObjects


def keep(drawn: Drawn, camera: Camera) -> Past:
    """The past of the next frame."""
    walk = drawn.walk
    line, share, new = _sampled(drawn, camera)
    spread = walk.finish - walk.begin
    size = np.maximum(np.abs(walk.places[1] - walk.places[0]), 1e-9)
    return Past(
        new.points,
        new.tips,
        np.mod(walk.begin[line] + share * spread[line], 1.0),
        spread[line] / size[line] * new.reach,
        new.group,
        new.owner,
        new.edge,
        tuple(modelview for _, modelview in drawn.objects),
        tuple(name for name, _ in drawn.objects),
    )


def follow(drawn: Drawn, camera: Camera, past: Past) -> Walk:
    """The same strokes, as far along their pattern as what was drawn where they are now.

    Along each stroke the pattern is shifted by c, which minimises the sum of ``w |z - z'|^2`` and
    ``s |dz/dt - g z|^2`` for ``z = exp(2 pi i c)``, with z' the shift to the nearest old sample and
    g how that is known to grow: the pattern stays where it was, and gives way where old strokes
    that had nothing to do with each other are one now. Where it has become too long or too short
    on the screen, two repeats take the place of one, or one that of two (P. Bénard et al.,
    "Self-Similar Texture for Coherent Line Stylization", NPAR 2010: octaves).
    """
    walk = drawn.walk
    line, share, new = _sampled(drawn, camera)
    old = _now(past, drawn.objects, camera)
    if not len(line) or not len(old.places):
        return walk
    size = np.abs(walk.places[1] - walk.places[0])
    found = _nearest(new, old, camera)
    met = np.flatnonzero(found >= 0)
    if not len(met):
        return walk
    with np.errstate(all="ignore"):
        pace = past.gain / old.reach
    alike = (new.along[met] * old.along[found[met]].conj()).real * pace[found[met]]
    walk, kept = _turned(walk, line[met], alike)
    met = met[kept]
    weight = np.maximum(size[line] / np.bincount(line)[line], _STEP)[met]
    line, share, found = line[met], share[met], found[met]
    spread = walk.finish - walk.begin
    own = spread / np.maximum(size, 1e-9)
    pace = np.abs(pace[found]) * np.sign(own[line])
    ahead = ((new.places[met] - old.places[found]) * new.along[met].conj()).real
    then = past.phase[found] + pace * ahead
    here = walk.begin[line] + share * spread[line]

    octave = _octaves(walk, line, pace / own[line])
    doubled, halved = octave[line] > 0, octave[line] < 0
    then, pace = np.where(doubled, 2.0 * then, then), pace * np.exp2(octave[line])
    # Which half of a pattern twice as long is not known: shifts are told modulo a half there.
    here = np.where(halved, 2.0 * here, here)
    twice = np.where(octave < 0, 2.0, 1.0)
    chain = Chain(walk)
    rate = np.clip(pace / own[line], 1.0 / _MOST_STRETCHED, _MOST_STRETCHED) - 1.0
    gain = chain.nearby(line, share, rate) * np.abs(spread) * twice
    shift = chain.fitted(line, share, weight, then - here, gain)
    return replace(
        walk, begin=walk.begin + shift[0] / twice, finish=walk.finish + shift[1] / twice
    )


def _octaves(walk: Walk, line: Rows, stretched: Doubles) -> Rows:
    """(L,) 1 for lines of strokes whose pattern has become twice too long and is to be halved, -1
    where two repeats become one. Of samples on lines (N,): how many repeats there are for one."""
    found = np.zeros(len(walk.stroke), np.intp)
    stroke = walk.stroke[line]
    order = np.lexsort((stretched, stroke))
    firsts = np.flatnonzero(np.append(True, np.diff(stroke[order]) > 0))
    counts = np.diff(firsts, append=len(order))
    middle = stretched[order[firsts + counts // 2]]
    loop = walk.loop[line[order[firsts]]] > 0.0
    # Loops have whole repeats of their own, and the ends of half as many may not meet.
    most = np.where(loop, _OCTAVE**2, _OCTAVE)
    by_stroke = np.zeros(int(walk.stroke.max(initial=-1)) + 1, np.intp)
    by_stroke[stroke[order[firsts]]] = np.select(
        [middle < 1.0 / most, ~loop & (middle > most)], [1, -1], 0
    )
    on = walk.stroke >= 0
    found[on] = by_stroke[walk.stroke[on]]
    return found


def _turned(walk: Walk, line: Rows, alike: Doubles) -> tuple[Walk, Flags]:
    """Strokes the way that they ran before: which way a crease runs is decided by the first of its
    lines. And (N,) which samples then run as theirs did. line: (N,) of each; alike: (N,) above 0
    where what was there ran from the line's a to its b."""
    forth = np.where((walk.begin <= walk.finish)[line], alike, -alike) > 0.0
    stroke = walk.stroke[line]
    votes = np.bincount(stroke, np.where(forth, 1.0, -1.0), int(walk.stroke.max()) + 1)
    back: Flags = votes < 0.0
    turned = back[walk.stroke] & (walk.stroke >= 0)
    begin, finish = (np.where(turned, -end, end) for end in (walk.begin, walk.finish))
    return replace(walk, begin=begin, finish=finish), forth != back[stroke]


def _sampled(drawn: Drawn, camera: Camera) -> tuple[Rows, Doubles, _Samples]:
    """(N,) the line of each sample of a frame, (N,) how far along that in the window, 0..1, and
    the samples. Complexes in the window are those of the points, to the last bit: a line in
    perspective does not go by evenly."""
    line, share = _samples(drawn.walk)
    begin, step = drawn.a[line], (drawn.b - drawn.a)[line]
    points = begin + share[:, None] * step
    with np.errstate(all="ignore"):
        z0, z1 = drawn.walk.places
        way = (z1 - z0)[line]
        tips = points + step * np.minimum(1.0 / np.abs(way), 1.0)[:, None]
        places = _places(points, camera)
        share = ((places - z0[line]) * way.conj()).real / np.abs(way) ** 2
        reach = _places(tips, camera) - places
        good = np.flatnonzero((share >= 0.0) & (share <= 1.0))  # not what clip planes cut off
    line, way = line[good], way[good]
    samples = _Samples(
        points[good], tips[good], places[good], way / np.abs(way), np.abs(reach[good]),
        drawn.group[line], drawn.owner[line], drawn.edge[line],
    )  # fmt: skip
    return line, share[good], samples


def _places(points: Doubles, camera: Camera) -> Complexes:
    """(N,) points (N, 3) of eye space in the window."""
    found = window(points, camera)
    return np.asarray(found[:, 0] + 1j * found[:, 1])


def _samples(walk: Walk) -> tuple[Rows, Doubles]:
    """(N,) the line of each sample and (N,) how far along, 0..1: every `_STEP` pixels of a stroke,
    however short its lines are."""
    on = np.flatnonzero(walk.stroke >= 0)
    low = np.minimum(walk.begin, walk.finish)[on]
    order = on[np.lexsort((low, walk.stroke[on]))]
    size = np.abs(walk.places[1] - walk.places[0])[order]
    cut_off = walk.begin[order] == walk.finish[order]  # by the near plane
    size = np.where(np.isfinite(size) & ~cut_off, size, 0.0)
    total = np.cumsum(size)
    stroke = walk.stroke[order]
    first = np.flatnonzero(np.append(True, stroke[1:] != stroke[:-1])) if len(order) else order
    lengths = np.diff(first, append=len(order))
    along = total - size - np.repeat((total - size)[first], lengths)
    begins, ends = (np.floor(place / _STEP + 0.5) for place in (along, along + size))
    last = np.append(first[1:], len(order))[: len(first)] - 1
    ends[last] = np.maximum(ends[last], size[last] > 0.0)  # of a short stroke, too
    counts = np.minimum(ends - begins, _MOST_SAMPLES).astype(np.intp)
    which = np.repeat(np.arange(len(order)), counts)
    number = within(counts)
    share = ((begins[which] + number + 0.5) * _STEP - along[which]) / np.maximum(size[which], 1e-9)
    crowded = (ends - begins)[which] > _MOST_SAMPLES
    share = np.where(crowded, (number + 0.5) / _MOST_SAMPLES, np.clip(share, 0.0, 1.0))
    line = order[which]
    return line, np.where(walk.begin[line] <= walk.finish[line], share, 1.0 - share)


def _now(past: Past, objects: NamedObjects, camera: Camera) -> _Samples:
    """Old samples where they are now, moved with their objects; NaN where that is not known, and
    of objects that have turned too far to be followed: what they show now is something else."""
    before = tuple(zip(past.names, past.modelviews, strict=True))
    motions, owners = np.full((len(before), 4, 4), np.nan), np.full(len(before), -1, np.intp)
    for old, new in paired(before, objects).items():
        owners[old] = new
        try:
            motion = objects[new][1] @ np.linalg.inv(before[old][1])
        except np.linalg.LinAlgError:
            motion = np.eye(4)
        if _turns(motion) < _MOST_TURNED:
            motions[old] = motion
    with np.errstate(all="ignore"):
        moved = motions[past.owner]
        points, tips = (
            np.einsum("nij,nj->ni", moved[:, :3, :3], some) + moved[:, :3, 3]
            for some in (past.points, past.tips)
        )
        places = _places(points, camera)
        way = _places(tips, camera) - places
        reach = np.abs(way)
        along = way / reach
    owner = owners[past.owner]
    return _Samples(points, tips, places, along, reach, past.group, owner, past.edge)


def _turns(motion: Doubles) -> float:
    """Radians by which a motion (4, 4) turns things."""
    linear = motion[:3, :3]
    size = abs(float(np.linalg.det(linear))) ** (1.0 / 3.0)
    cosine = 0.5 * (float(np.trace(linear)) / max(size, 1e-30) - 1.0)
    return float(np.arccos(np.clip(cosine, -1.0, 1.0)))


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
    tips: Doubles
    """(N, 3) about a pixel farther along."""
    places: Complexes
    """(N,) the window."""
    along: Complexes
    """(N,) unit direction there."""
    reach: Doubles
    """(N,) pixels to the tip."""
    group: Rows
    owner: Rows
    """(N,) object, by number in the new frame."""
    edge: Doubles


def _nearest(new: _Samples, old: _Samples, camera: Camera) -> Rows:
    """(N,) the old sample nearest to each new one within `_REACH`, or -1: one that runs along it
    either way. Those of another group (a crease that is an outline now), another object or the
    other way count as `_STRANGE` farther, and those of another edge a little: of several that lie
    together each stays itself. Outlines that wind the other way are others."""
    known = np.isfinite(old.places) & np.isfinite(old.along)
    sound = np.flatnonzero(known & (np.abs(old.places) < 1e6) & (old.reach > 1e-6))
    keys = _cell(old.places[sound])
    order = sound[np.argsort(keys, kind="stable")]
    keys = np.sort(keys)
    sight = unit(camera.viewpoint[:3] - camera.viewpoint[3] * new.points)
    w = np.abs(new.points @ camera.projection[3, :3] + camera.projection[3, 3])
    scale = abs(camera.projection[1, 1]) * camera.viewport[3] / 2.0 / np.maximum(w, 1e-9)
    best = np.full(len(new.places), -1, np.intp)
    nearest = np.full(len(new.places), _REACH)
    for right in (0, -1, 1):
        for up in (0, -1, 1):
            wanted = _cell(new.places + _REACH * (right + 1j * up))
            first, last = np.searchsorted(keys, wanted), np.searchsorted(keys, wanted, "right")
            for k in range(_CROWD):
                at = np.flatnonzero(first + k < last)
                if not len(at):
                    break
                who = order[first[at] + k]
                flat = np.abs(old.places[who] - new.places[at])
                near = flat < nearest[at]
                at, who = at[near], who[near]
                deep = dot(new.points[at] - old.points[who], sight[at]) * scale[at]
                away = np.hypot(flat[near], _DEPTH * deep)
                same = (old.along[who] * new.along[at].conj()).real
                for strange in (old.group[who] != new.group[at], old.owner[who] != new.owner[at],
                                same < 0.0):  # fmt: skip
                    away += np.where(strange, _STRANGE, 0.0)
                away += np.where(old.edge[who] != new.edge[at], _OTHER, 0.0)
                fits = (away < nearest[at]) & (np.abs(same) > 0.5)
                fits &= (same > 0.0) | (old.group[who] != 0) | (new.group[at] != 0)
                best[at[fits]], nearest[at[fits]] = who[fits], away[fits]
    return best


def _cell(places: Complexes) -> NDArray[np.int64]:
    """(N,) numbers of squares of `_REACH` pixels."""
    x, y = (np.floor(part / _REACH).astype(np.int64) for part in (places.real, places.imag))
    return np.asarray((x << np.int64(32)) + y)
