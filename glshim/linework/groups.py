"""Batches whose lines go together: one camera but for the modelview, one look."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, replace
from math import isfinite

from glshim.model.camera import Camera
from glshim.styling.lines import Lines, Medium, turns
from glshim.styling.values import Item, Uniform, in_order
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
    """Lines as groups."""
    found: dict[Hashable, tuple[list[Item], Lines]] = {}
    seen: dict[int, tuple[Camera, Hashable]] = {}
    last: Lines | None = None
    look: Hashable = None
    for lines in given:
        if last is None or not _look_alike(lines, last):
            medium = lines.medium
            uniforms = tuple(medium.uniforms.items())
            look = (lines.wanted, medium.shader, uniforms, medium.image, medium.pattern)
        last = lines
        for batch, camera in in_order(lines.bodies):
            if batch.polygon_count == 0:
                continue
            known = seen.get(id(camera))
            if known is None:
                affine = camera.affine()
                if not all(map(isfinite, affine.modelview.ravel().tolist())):
                    continue
                known = seen[id(camera)] = (affine, affine.lens)
            affine, lens = known
            found.setdefault((lens, look), ([], lines))[0].append((batch, affine))
    return [Group(tuple(items), _wanted(lines), lines.medium) for items, lines in found.values()]


def _wanted(lines: Lines) -> Choice | Features:
    """Which lines, with the pattern of what they are drawn with."""
    pattern = lines.medium.pattern
    return lines.wanted if pattern is None else replace(lines.wanted, pattern=pattern)


def _look_alike(lines: Lines, other: Lines) -> bool:
    """Whether their looks are the same objects, as they are of one styler."""
    one, two = lines.medium, other.medium
    return (
        lines.wanted is other.wanted
        and one.shader is two.shader
        and one.uniforms is two.uniforms
        and one.image is two.image
        and one.pattern is two.pattern
    )
