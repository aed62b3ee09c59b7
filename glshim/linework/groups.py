"""Batches whose lines go together: one camera but for the modelview, one look."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, replace
from math import isfinite

from glshim.model.batch import Item
from glshim.model.camera import Camera
from glshim.styling.lines import Lines, Medium, turns
from glshim.styling.values import Uniform, in_order
from glshim.styling.wishes import Choice, Features


@dataclass(frozen=True, slots=True)
class Group:
    """Batches whose lines one draw can serve."""

    items: tuple[Item, ...]
    """In the order in which the app drew them; cameras are affine, alike in all but modelview."""
    wanted: Choice | Features
    medium: Medium

    @property
    def uniforms(self) -> Mapping[str, Uniform]:
        """What the medium's shader reads: its own, and at which angles folds are lines."""
        return {**turns(self.wanted), **self.medium.uniforms}

    @property
    def camera(self) -> Camera:
        """The camera of all, but for its modelview."""
        return self.items[0][1]

    @property
    def name(self) -> Hashable:
        """What tells the lines of groups of one layer apart."""
        return self.wanted, tuple((id(batch), id(camera)) for batch, camera in self.items)


def grouped(given: Iterable[Lines]) -> list[Group]:
    """Lines as groups, in the order of their first batches."""
    found: list[tuple[list[Item], Lines]] = []
    looks: dict[Hashable, dict[int, list[Item]]] = {}
    lenses: dict[Hashable, int] = {}
    seen: dict[int, tuple[Camera, int] | None] = {}
    for lines in given:
        own = looks.setdefault(_look(lines), {})
        for batch, camera in in_order(lines.bodies):
            if batch.polygon_count == 0:
                continue
            if id(camera) not in seen:
                affine = camera.affine()
                sound = all(map(isfinite, affine.modelview.ravel().tolist()))
                number = lenses.setdefault(affine.lens, len(lenses))
                seen[id(camera)] = (affine, number) if sound else None
            known = seen[id(camera)]
            if known is None:
                continue
            affine, lens = known
            if lens not in own:
                own[lens] = []
                found.append((own[lens], lines))
            own[lens].append((batch, affine))
    return [Group(tuple(items), _wanted(lines), lines.medium) for items, lines in found]


def _look(lines: Lines) -> Hashable:
    """What lines have in common that one draw can serve, but for the lens."""
    medium = lines.medium
    uniforms = tuple(medium.uniforms.items())
    return lines.wanted, medium.shader, uniforms, medium.image, medium.pattern


def _wanted(lines: Lines) -> Choice | Features:
    """Which lines, with the pattern of what they are drawn with."""
    pattern = lines.medium.pattern
    return lines.wanted if pattern is None else replace(lines.wanted, pattern=pattern)
