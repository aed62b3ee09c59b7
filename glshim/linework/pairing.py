"""Which objects of a frame are which of the next one."""

from __future__ import annotations

from collections.abc import Hashable, Iterable

import numpy as np

from glshim.model.arrays import Doubles

NamedObjects = tuple[tuple[Hashable, Doubles], ...]
"""Name and modelview (4, 4) of each object."""

_MOST_ALIKE = 200
"""Objects of one name that are told apart by where they are; of more, by their order."""


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
