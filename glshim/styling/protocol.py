"""What a styler is, what it gets (`Layer`) and what it gives (`Lines`, `Pass`, `BackFaces`).

A styler is a frozen dataclass whose fields are its options; it says what to draw and never
calls GL::

    @dataclass(frozen=True)
    class Dots(Styler):
        name: ClassVar[str] = "dots"
        size: float = option(4.0, help="diameter", low=1, high=64, unit="px")
        ink: Colour = option("#000000", help="colour of the dots")

        def draws(self, layer: Layer) -> list[Lines]:
            dots = Medium(DOTS, {"size": self.size, "ink": self.ink})
            return [Lines(layer.bodies, Choice(silhouettes=True), dots)]
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import ClassVar

from glshim.styling.fixed import BackFaces
from glshim.styling.lines import Lines
from glshim.styling.options import option, options_of
from glshim.styling.passes import Pass
from glshim.styling.renamed import Renamed
from glshim.styling.values import Colour, Layer

__all__ = ["BackFaces", "Colour", "Layer", "Lines", "Pass", "Styler", "option"]

PAINTED = ("paint", "colours")
"""Surfaces in the app's own paints, without its light or its textures."""
SURFACES = ("app", "none", *PAINTED)
"""Words of `Styler.surface`."""


@dataclass(frozen=True)
class Styler:
    """Base of all stylers. Options that are not allowed raise `StyleError` at construction."""

    name: ClassVar[str] = ""
    """The name of the style in texts and entry points."""
    wants_polygons: ClassVar[bool] = True
    """False: no polygons are collected, and `draws` is never called."""
    alone: ClassVar[str] = ""
    """Why it is not put together with other styles (``a+b``); empty: it is."""
    categories: ClassVar[tuple[str, ...]] = ()
    """Words by which galleries filter it (`glshim.styling.categories`); empty: its options say."""
    former: ClassVar[Mapping[str, Renamed]] = MappingProxyType({})
    """Names that options had before: with `takes_old_names` they are still read."""

    @property
    def wants_colours(self) -> bool:
        """Whether `PolygonBatch.regions` is filled, which tells polygons of different colours
        apart."""
        return False

    @property
    def wants_normals(self) -> bool:
        """Whether `PolygonBatch.normals` is filled with the normals that the program sends."""
        return False

    @property
    def wants_lights(self) -> bool:
        """Whether `Camera.lit`, `gleams` and `textured`, and `Layer.lighting` are filled: how the
        program lights its polygons."""
        return False

    @property
    def surface(self) -> str | Colour:
        """How the program's own polygons look: ``"app"`` (untouched), ``"none"`` (depth only),
        ``"paint"`` (its colours and textures without its light), ``"colours"`` (also without its
        textures and fog), or a colour. For a style with an option `fill`, it is that option."""
        fill: str | Colour = getattr(self, "fill", "app")
        return fill

    @property
    def gathers_ink(self) -> bool:
        """Whether text and lines that the program draws itself are kept out of its picture, and
        laid over what the style makes of that, in colours that can be read there. For a style with
        an option `own_ink` that says so; ``auto`` is where it brings a `paper`."""
        own = getattr(self, "own_ink", "off")
        return own == "on" or (own == "auto" and getattr(self, "paper", "app") != "app")

    @property
    def background(self) -> Colour | None:
        """The colour that the background has before the program draws anything solid in front of
        it, so that what the program blends with it, or draws without depth, comes out as on paper;
        None: as the program has it. For a style with an option `paper`, it is that option."""
        paper = getattr(self, "paper", None)
        return paper if isinstance(paper, tuple) else None

    @abstractmethod
    def draws(self, layer: Layer) -> Iterable[Lines | Pass | BackFaces]:
        """What to add to a finished layer. Pure: equal layers give equal draws."""
        raise NotImplementedError

    def __post_init__(self) -> None:
        for described in options_of(type(self)):
            value = described.check(getattr(self, described.name))
            object.__setattr__(self, described.name, value)
