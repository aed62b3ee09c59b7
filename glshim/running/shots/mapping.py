"""From pixels of the program's window to those of a tile, and back. Pure."""

from __future__ import annotations

from collections.abc import Sequence

from glshim.running.shots.plan import Size

Rect = tuple[int, int, int, int]
"""x, y, width, height in pixels."""


class Mapping:
    """window: its size; sheet: that of the whole frame; origin: the tile's first pixel on it."""

    def __init__(self, window: Size, sheet: Size, origin: tuple[int, int]) -> None:
        self.window, self.sheet, self.origin = window, sheet, origin
        self.across, self.up = sheet[0] / window[0], sheet[1] / window[1]
        self.scale: float = (self.across * self.up) ** 0.5
        """For lengths that have no direction: widths of lines, sizes of points."""
        self._rects: dict[Rect, Rect] = {}

    def place(self, x: float, y: float) -> tuple[float, float]:
        """A place."""
        return x * self.across - self.origin[0], y * self.up - self.origin[1]

    def place_back(self, x: float, y: float) -> tuple[float, float]:
        """The place that `place` gave."""
        return (x + self.origin[0]) / self.across, (y + self.origin[1]) / self.up

    def rect(self, values: Sequence[int]) -> Rect:
        """A box: neighbours stay neighbours."""
        x, y, width, height = values
        left, low = round(x * self.across), round(y * self.up)
        right, top = round((x + width) * self.across), round((y + height) * self.up)
        # A size below zero is an error that the driver shall find.
        size = (right - left if width > 0 else width), (top - low if height > 0 else height)
        found = left - self.origin[0], low - self.origin[1], *size
        self._rects[found] = (x, y, width, height)
        return found

    def rect_back(self, values: Sequence[int]) -> Rect:
        """The box that `rect` gave."""
        x, y, width, height = values
        known = self._rects.get((x, y, width, height))
        if known is not None:
            return known
        left, low = self.place_back(x, y)
        right, top = self.place_back(x + width, y + height)
        return round(left), round(low), round(right) - round(left), round(top) - round(low)

    def knows(self, values: Sequence[int]) -> bool:
        """Whether `rect` gave that box."""
        return tuple(values) in self._rects

    def length(self, value: float) -> float:
        """A width."""
        return value * self.scale

    def length_back(self, value: float) -> float:
        """The width that `length` gave."""
        found = value / self.scale
        near = round(found * 64) / 64  # what programs say, which floats need not give back
        return near if abs(near - found) < 1e-4 * max(found, 1.0) else found
