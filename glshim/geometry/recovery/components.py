"""What hangs together: connected components of a graph, by whole arrays at a time."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from glshim.model.arrays import Flags, Indices


class Components(NamedTuple):
    """The connected components of a graph of N nodes."""

    label: Indices
    """(N,) component of each node, numbered by their first nodes."""
    odd: Flags
    """(N,) whether the way from the first node of the component has an odd number of odd links;
    by one of the ways, where they disagree."""
    first: Indices
    """(C,) the first node of each component."""


def components(count: int, one: Indices, other: Indices, odd: Flags | None = None) -> Components:
    """The components of count nodes under links (L,), (L,), of which some may be odd (L,).

    Every node hooks itself to a neighbour, pointers double their reach until they point to roots
    (Shiloach & Vishkin 1982), and the roots are the nodes of the next, smaller graph: union-find
    with parity in a logarithmic number of passes.
    """
    label = np.arange(count, dtype=np.int32)
    parity = np.zeros(count, np.bool_)
    odd = np.zeros(len(one), np.bool_) if odd is None else odd
    left, down = count, True
    while len(one):
        roots, flips, left = _contract(left, one, other, odd, down)
        down = not down  # a hub hooks to one neighbour only; the next turn its neighbours hook
        odd = odd ^ flips[one] ^ flips[other]
        one, other = roots[one], roots[other]
        apart = one != other
        one, other, odd = one[apart], other[apart], odd[apart]
        parity ^= flips[label]
        label = roots[label]
    first = np.full(left, count, np.int32)
    np.minimum.at(first, label, np.arange(count, dtype=np.int32))
    by_first = np.argsort(first)
    rank = np.empty(left, np.int32)
    rank[by_first] = np.arange(left, dtype=np.int32)
    label, first = rank[label], first[by_first]
    return Components(label, parity ^ parity[first][label], first)


def _contract(
    count: int, one: Indices, other: Indices, odd: Flags, down: bool
) -> tuple[Indices, Flags, int]:
    """One round: (count,) the root that each node now hangs on, numbered anew, the parity of the
    way there, and the number of roots."""
    lesser, greater = np.minimum(one, other), np.maximum(one, other)
    # All hooks of a round go to lesser, or all to greater, nodes: no cycles.
    source, target = (greater, lesser) if down else (lesser, greater)
    links = np.arange(len(one), dtype=np.int32)
    slot = np.empty(count, np.int32)
    slot[source] = links
    chosen = np.flatnonzero(slot[source] == links)  # one link for each node that hooks
    parent = np.arange(count, dtype=np.int32)
    flips = np.zeros(count, np.bool_)
    parent[source[chosen]] = target[chosen]
    flips[source[chosen]] = odd[chosen]
    while True:
        grand = parent[parent]
        if np.array_equal(grand, parent):
            break
        flips ^= flips[parent]
        parent = grand
    is_root = parent == np.arange(count, dtype=np.int32)
    number = np.cumsum(is_root, dtype=np.int32) - np.int32(1)
    return number[parent], flips, int(number[-1]) + 1


def turned(count: int, one: Indices, other: Indices, against: Flags) -> Flags:
    """(count,) which of the faces must turn round to agree with their neighbours.

    one, other (L,) are neighbours, and against (L,) says whether they disagree. The majority of
    each component stays as it is, the first face's part where they are equally many. A component
    that no turning makes consistent (a Moebius strip) is turned only if that leaves fewer
    neighbours in disagreement.
    """
    if not against.any():
        return np.zeros(count, np.bool_)
    label, odd, first = components(count, one, other, against)
    sizes = np.bincount(label)
    minority = 2 * np.bincount(label, weights=odd) > sizes
    turn = odd ^ minority[label]
    still = against ^ turn[one] ^ turn[other]
    before, after = (
        np.bincount(label[one], weights=flags, minlength=len(first)) for flags in (against, still)
    )
    return np.asarray(turn & (after < before)[label])
