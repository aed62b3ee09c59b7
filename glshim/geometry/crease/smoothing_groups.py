"""What creases do to a mesh's vertices, and how crease halfedges follow one another there.

B. Hajagos, L. Szecsi, B. Csebfalvi, "Fast silhouette and crease edge synthesis with geometry
shaders", SCCG 2012, sections 3 and 4.1. A *topology vertex* is a fan of triangle corners around a
geometry vertex that hang together over sides that are no creases. The fan's ends are the crease
halfedges that come in and go out there, at most one each. Halfedges are numbered as in
`recovery/halfedges.py`: 3 t + k starts at corner 3 t + k.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from glshim.model.arrays import Flags, Indices

_WALK = 8
"""Steps after which a vertex of many triangles is left to doubling."""


class Strips(NamedTuple):
    """The crease halfedges at each topology vertex, -1 where there is none."""

    incoming: Indices
    """(N,) the one that ends there."""
    outgoing: Indices
    """(N,) the one that starts there."""


def following(count: int) -> Indices:
    """(3 T,) the next halfedge in each triangle, of count triangles."""
    return _turned(count, (1, 2, 0))


def preceding(count: int) -> Indices:
    """(3 T,) the halfedge before each in its triangle, of count triangles."""
    return _turned(count, (2, 0, 1))


def _turned(count: int, order: tuple[int, int, int]) -> Indices:
    first = np.arange(0, 3 * count, 3, dtype=np.int32)
    found = np.empty((count, 3), np.int32)
    for k, other in enumerate(order):
        np.add(first, np.int32(other), out=found[:, k])
    return found.ravel()


def topology_vertices(triangles: Indices, joined: Indices, count: int) -> tuple[Indices, Indices]:
    """(T, 3) the topology vertex of each corner and (N,) the geometry vertex of each.

    triangles (T, 3) of count vertices; joined (3 T,) the halfedge on the other side that runs the
    other way, -1 at creases and where nothing hangs together. Vertices that nothing parts keep
    their numbers, and so does the first fan of every other; more fans are numbered from count on.
    """
    corners = triangles.ravel()
    onward = following(len(triangles))
    hard = _hard(corners, onward, joined, count)
    if not len(hard):
        return triangles, np.arange(count, dtype=np.int32)
    local = np.empty(len(corners), np.int32)
    local[hard] = np.arange(len(hard), dtype=np.int32)
    most = int(np.bincount(corners[hard]).max())
    fan = _fans(hard, onward, joined, local, most)
    # Fans by the vertices that they are around: the first of each keeps the vertex's number.
    leads = np.flatnonzero(fan == np.arange(len(hard), dtype=np.int32))
    around = corners[hard[leads]]
    number = around.copy()
    keeps = np.full(count, -1, np.int32)
    keeps[around[::-1]] = np.arange(len(leads) - 1, -1, -1, dtype=np.int32)
    more = np.flatnonzero(keeps[around] != np.arange(len(leads), dtype=np.int32))
    number[more] = count + np.arange(len(more), dtype=np.int32)
    of_lead = np.empty(len(hard), np.int32)
    of_lead[leads] = number
    found = corners.copy()
    found[hard] = of_lead[fan]
    vertices = np.concatenate((np.arange(count, dtype=np.int32), around[more]))
    return found.reshape(-1, 3), vertices


def _hard(corners: Indices, onward: Indices, joined: Indices, count: int) -> Indices:
    """(H,) the corners at vertices that may have several fans, or an open one: those that creases
    touch, those of very many triangles, and those where several closed fans meet."""
    hard = np.zeros(count, np.bool_)
    ends = np.flatnonzero(joined < 0)
    hard[corners[ends]] = True
    hard[corners[onward[ends]]] = True
    # Of the others, one walk around from any corner must pass them all.
    leader = np.full(count, -1, np.int32)
    leader[corners] = np.arange(len(corners), dtype=np.int32)
    left = np.bincount(corners, minlength=count).astype(np.int32)
    walkers = np.flatnonzero(~hard & (leader >= 0))
    at, left = leader.take(walkers), left.take(walkers)
    home = at
    for _ in range(_WALK):
        at, left = onward.take(joined.take(at)), left - 1
        back = at == home
        if back.any():
            hard[walkers[back & (left != 0)]] = True
            out = np.flatnonzero(~back)
            walkers = walkers.take(out)
            at, home, left = at.take(out), home.take(out), left.take(out)
        if not len(walkers):
            break
    hard[walkers] = True
    return np.flatnonzero(hard.take(corners)).astype(np.int32)


def _fans(hard: Indices, onward: Indices, joined: Indices, local: Indices, most: int) -> Indices:
    """(H,) a corner that stands for its fan, by its place in hard: the fan's end, or the least of
    its corners if it goes all the way around. Fans have at most so many corners, and pointers
    double their reach until they arrive."""
    own = np.arange(len(hard), dtype=np.int32)
    over = joined[hard]  # of -1 whatever is there
    step = np.where(over >= 0, local.take(onward.take(over)), own)
    passes = range(most.bit_length())
    ahead = step
    for _ in passes:
        ahead = ahead.take(ahead)
    closed = np.flatnonzero(step[ahead] != ahead)
    if len(closed):
        least, reach = np.minimum(own, step), step
        for _ in passes:
            least, reach = np.minimum(least, least.take(reach)), reach.take(reach)
        ahead[closed] = least[closed]
    return ahead


def by_traversal(triangles: Indices, sides: Flags, joined: Indices, count: int) -> Strips:
    """The strips at count topology vertices, by the search of section 4.1 and figure 4.

    triangles (T, 3) topology vertices; sides (T, 3) crease halfedges; joined as above. From every
    crease halfedge it turns around both its vertices, from halfedge to halfedge, until the next
    crease halfedge; all that still turn step at once.
    """
    corners, crease = triangles.ravel(), sides.ravel()
    after, before = following(len(triangles)), preceding(len(triangles))
    first = np.flatnonzero(crease).astype(np.int32)
    starts, ends = corners[first], corners[after[first]]
    incoming, outgoing = (np.full(count, -1, np.int32) for _ in range(2))
    outgoing[starts], incoming[ends] = first, first
    for found, ahead, turn in ((incoming, starts, before), (outgoing, ends, after)):
        s, at = first, ahead
        while len(s):
            z = turn.take(s)
            met = crease.take(z)
            found[at[met]] = z[met]
            s = joined.take(z)
            on = ~met & (s >= 0)
            s, at = s[on], at[on]
    return Strips(incoming, outgoing)


def within_adjacency(triangles: Indices, sides: Flags, count: int) -> Strips:
    """The strips at count topology vertices, as section 4.1 gets them without any search: every
    crease halfedge (T, 3) is written at the topology vertices (T, 3) where it starts and ends."""
    corners = triangles.ravel()
    crease = np.flatnonzero(sides).astype(np.int32)
    incoming, outgoing = (np.full(count, -1, np.int32) for _ in range(2))
    outgoing[corners[crease]] = crease
    incoming[corners[following(len(triangles))[crease]]] = crease
    return Strips(incoming, outgoing)
