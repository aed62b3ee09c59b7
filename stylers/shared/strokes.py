"""Lines of several kinds, each with its own look: as few draws as their pictures allow."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any, TypeVar

from glshim.styling.lines import Lines, Medium
from glshim.styling.media.ink import Hidden, ink
from glshim.styling.protocol import Layer
from glshim.styling.textures import TEXTURES
from glshim.styling.wishes import Choice, Features

from .kinds import SWITCHES, Look

Looks = Mapping[str, Look]
"""By kind."""
_Wanted = TypeVar("_Wanted", Choice, Features)
_LASTING = frozenset(("none", *TEXTURES))
"""Textures that are made here."""


def parted(looks: Looks, *, plain_apart: bool = True) -> list[dict[str, Look]]:
    """Looks whose lines can be drawn with one picture, or with none, together. Plain ones join
    others unless they are to be apart."""
    found: dict[object, dict[str, Look]] = {}
    for kind, look in looks.items():
        found.setdefault(look.stroke, {})[kind] = look
    plain = found.get(None)
    if plain is not None and len(found) > 1 and not plain_apart:
        del found[None]
        first = next(iter(found.values()))
        first.update(plain)
    return [{kind: look for kind, look in looks.items() if kind in part} for part in found.values()]


def only(wanted: _Wanted, kinds: Collection[str]) -> _Wanted:
    """Of the lines that are wanted those of some kinds."""
    ridge = wanted.ridge_angle if "ridge" in kinds else None
    valley = wanted.valley_angle if "valley" in kinds else None
    if isinstance(wanted, Choice):
        return replace(
            wanted, silhouettes=wanted.silhouettes and "contour" in kinds, ridge_angle=ridge,
            valley_angle=valley, intersections=wanted.intersections and "intersection" in kinds,
        )  # fmt: skip
    return replace(
        wanted, contours=wanted.contours and "contour" in kinds, ridge_angle=ridge,
        valley_angle=valley, boundary=wanted.boundary and "boundary" in kinds,
        marked=wanted.marked and "marked" in kinds,
        suggestive=wanted.suggestive and "suggestive" in kinds,
    )  # fmt: skip


def inked(
    layer: Layer,
    wanted: _Wanted,
    looks: Looks,
    *,
    texture_length: float = 0.0,
    hidden: Hidden = "none",
    hidden_share: float = 1.0,
) -> Iterator[Lines]:
    """The lines that are wanted, in ink."""
    plan = _plan if all(look.texture in _LASTING for look in looks.values()) else _plan.__wrapped__
    kinds = tuple(looks.items())
    for found, medium in plan(wanted, kinds, texture_length, hidden, hidden_share):
        yield Lines(layer.bodies, found, medium)
        if layer.glass and isinstance(found, Features):
            yield Lines(layer.glass_bodies, found, medium)


@lru_cache(maxsize=64)
def _plan(
    wanted: Any,
    kinds: tuple[tuple[str, Look], ...],
    texture_length: float,
    hidden: Hidden,
    hidden_share: float,
) -> tuple[tuple[Choice | Features, Medium], ...]:
    """What is drawn with what, the same for every layer. Pictures in files may change."""
    # Dashes of what is hidden lie on the pattern of a stroke, which plain ones lack beside others.
    return tuple(
        (only(wanted, some), _ink(some, texture_length, hidden, hidden_share))
        for some in parted(dict(kinds), plain_apart=hidden == "dashed")
    )


def _ink(looks: Looks, texture_length: float, hidden: Hidden, hidden_share: float) -> Medium:
    textured = {kind: look for kind, look in looks.items() if look.stroke is not None}
    first = next(iter((textured or looks).values()))
    return ink(
        first.width,
        first.ink,
        widths={SWITCHES[kind]: look.width for kind, look in looks.items()},
        colours={SWITCHES[kind]: look.ink for kind, look in looks.items()},
        texture=first.texture,
        texture_length=texture_length,
        dash=first.dash,
        textured=[SWITCHES[kind] for kind in textured] if len(textured) < len(looks) else None,
        hidden=hidden,
        hidden_share=hidden_share,
    )
