"""Figures as data: a program, and the styles that it is shown in."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from PIL import Image

from tests.figures.shots import sheet, shot

Box = tuple[int, int, int, int]


@dataclass(frozen=True, slots=True)
class Figure:
    """One sheet: each style of a program is a tile."""

    name: str
    program: tuple[str, ...]
    """As the command line of Python names it."""
    styles: tuple[str, ...]
    columns: int = 1
    frames: int = 3
    """The last of so many is shown."""
    crop: Box | None = None
    """Left, upper, right, lower pixel of what is shown of each picture."""

    def tiles(self) -> list[Image.Image]:
        """Raises RuntimeError, with the style and the program, where one cannot be drawn."""
        found = (shot(style, *self.program, frames=self.frames) for style in self.styles)
        return [tile.crop(self.crop) if self.crop else tile for tile in found]

    def write(self, out: Path) -> Path:
        """One PNG in a folder; says where."""
        path = out / f"{self.name}.png"
        sheet(self.tiles(), self.columns).save(path)
        return path
