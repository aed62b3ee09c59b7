"""Styles put together: the surfaces of one, the lines of another."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from glshim.errors import StyleError
from glshim.styling.fixed import BackFaces
from glshim.styling.lines import Lines
from glshim.styling.passes import Pass
from glshim.styling.protocol import Styler
from glshim.styling.values import Colour, Layer

_APART = 64
"""Between the coats of a part and those of the next one."""
_Draw = Lines | Pass | BackFaces


@dataclass(frozen=True)
class Composite(Styler):
    """Surfaces and paper of the first part, lines of the others. Where the others draw no lines
    (shadows, fur), what they draw lies over the surfaces, and the lines of the first stay; with
    ``none`` they go."""

    parts: tuple[Styler, ...] = ()

    def __post_init__(self) -> None:
        if len(self.parts) < 2:
            raise StyleError("styles are put together from two or more")
        for part in self.parts:
            if part.alone:
                raise StyleError(f"{part.name} is not put together with other styles: {part.alone}")
        # Of this one: the class has none.
        object.__setattr__(self, "name", "+".join(part.name for part in self.parts))

    @property
    def wants_colours(self) -> bool:
        return any(part.wants_colours for part in self.parts)

    @property
    def wants_normals(self) -> bool:
        return any(part.wants_normals for part in self.parts)

    @property
    def wants_lights(self) -> bool:
        return any(part.wants_lights for part in self.parts)

    @property
    def surface(self) -> str | Colour:
        return self.parts[0].surface

    @property
    def gathers_ink(self) -> bool:
        return self.parts[0].gathers_ink

    @property
    def background(self) -> Colour | None:
        return self.parts[0].background

    def draws(self, layer: Layer) -> Iterable[_Draw]:
        """Surfaces, then lines; each part in coats of its own."""
        first, *others = (_parted(part, layer, k) for k, part in enumerate(self.parts))
        lines = [draw for other in others for draw in other.lines]
        over = [draw for other in others if not other.lines for draw in other.surfaces]
        if not lines and all(part.wants_polygons for part in self.parts[1:]):
            lines = first.lines
        return [*first.surfaces, *over, *lines]


@dataclass(frozen=True, slots=True)
class _Parted:
    """What a style draws of a layer."""

    surfaces: list[_Draw]
    lines: list[_Draw]


def _parted(part: Styler, layer: Layer, number: int) -> _Parted:
    drawn = list(part.draws(layer)) if part.wants_polygons else []
    lines = [_in_coat(draw, number) for draw in drawn if is_line(draw)]
    return _Parted([_in_coat(draw, number) for draw in drawn if not is_line(draw)], lines)


def _in_coat(draw: _Draw, number: int) -> _Draw:
    """In a coat that no other part has. Polygons that only lines need are not filled."""
    if isinstance(draw, BackFaces):
        return replace(draw, fill=draw.fill if number == 0 else None)
    return replace(draw, coat=draw.coat + _APART * number)


def is_line(draw: _Draw) -> bool:
    """Whether a draw is one of lines, not of surfaces."""
    return not isinstance(draw, Pass) or draw.lines
