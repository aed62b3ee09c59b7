"""What a shot shall be, and the tiles that it is put together from. Plain values."""

from __future__ import annotations

import json
import re
from dataclasses import asdict, dataclass
from math import ceil

from glshim.errors import StyleError, shown

VARIABLE = "GLSHIM_SHOT"
"""Set by us for programs that we start; never by people."""
MOST_SIDE = 8192
"""Pixels of a side of a tile, at most: textures of that size are had everywhere."""
MOST_AREA = 48 << 20
"""Pixels of a tile, at most: some 200 MB for each of a few buffers."""
_MARGIN = 48
"""Pixels of the window that neighbouring tiles share, as far as that leaves some to go on with."""
Size = tuple[int, int]


@dataclass(frozen=True, slots=True)
class Plan:
    """One shot."""

    output: str
    """An absolute path."""
    frame: int
    """The number of the frame, from 1."""
    size: Size | None = None
    """Pixels of the picture; None: `scale` says."""
    scale: float = 1.0
    """Pixels of the picture for one of the window."""
    tile: int = MOST_SIDE
    """Pixels of a tile's side, at most."""

    def as_text(self) -> str:
        """For `VARIABLE`."""
        return json.dumps(asdict(self))

    @classmethod
    def of_text(cls, text: str) -> Plan:
        """What `as_text` gave. Raises `StyleError` for anything else."""
        try:
            values = json.loads(text)
            size = values.pop("size")
            plan = cls(**values, size=None if size is None else (int(size[0]), int(size[1])))
            whole = plan.output.lower().endswith(".png") and min(plan.frame, plan.tile) > 0
            if whole and plan.scale > 0 and (plan.size is None or min(plan.size) > 0):
                return plan
        except (ValueError, TypeError, KeyError, AttributeError, IndexError, RecursionError):
            pass
        raise StyleError(f"'{shown(text)}' is not a valid plan: glshim shot sets this variable")

    def sheet_for(self, window: Size) -> Size:
        """Pixels of the program's whole frame: the greatest of the window's shape in the size asked
        for."""
        if self.size is None:
            return round(window[0] * self.scale) or 1, round(window[1] * self.scale) or 1
        width, height = self.size
        factor = min(width / window[0], height / window[1])
        whole = round(window[0] * factor), round(window[1] * factor)
        # Sides that are a rounding away are meant to be filled.
        across, up = (a if abs(a - b) <= 1 else b for a, b in zip(self.size, whole, strict=True))
        return max(across, 1), max(up, 1)


@dataclass(frozen=True, slots=True)
class Tile:
    """A part of a sheet that is drawn at once. Pixels from the sheet's lower left corner."""

    x: int
    y: int
    width: int
    height: int
    inner: tuple[int, int, int, int]
    """What of it is new: left, low, right, top, in pixels of the sheet."""


def tiles_of(sheet: Size, scale: float, side: int) -> list[Tile]:
    """The tiles, all of one size, from the lower left to the upper right."""
    side = min(side, MOST_SIDE)
    margin = min(ceil(_MARGIN * max(scale, 1.0)), side // 4)
    across = min(side, sheet[0])
    up = min(side, sheet[1])
    if across * up > MOST_AREA:
        up = max(MOST_AREA // across, 1)
    columns, rows = _starts(sheet[0], across, margin), _starts(sheet[1], up, margin)
    found = []
    for j, y in enumerate(rows):
        for i, x in enumerate(columns):
            # Neighbours meet in the middle of what they share.
            left = 0 if i == 0 else (x + columns[i - 1] + across) // 2
            low = 0 if j == 0 else (y + rows[j - 1] + up) // 2
            right = sheet[0] if x == columns[-1] else (x + across + columns[i + 1]) // 2
            top = sheet[1] if y == rows[-1] else (y + up + rows[j + 1]) // 2
            found.append(Tile(x, y, across, up, (left, low, right, top)))
    return found


def _starts(length: int, part: int, margin: int) -> list[int]:
    """Where parts that share margins begin, so that they cover a length."""
    if part >= length:
        return [0]
    count = ceil((length - margin) / (part - margin))
    return [round(k * (length - part) / (count - 1)) for k in range(count)]


def parse_size(text: str) -> Size:
    """``6000x4500``. Raises `StyleError`."""
    found = re.fullmatch(r"\s*([0-9]{1,6})\s*[xX]\s*([0-9]{1,6})\s*", text)
    if not found or not int(found[1]) or not int(found[2]):
        raise StyleError(f"{text!r} is not a valid size: write WIDTHxHEIGHT, e.g. 6000x4500")
    return int(found[1]), int(found[2])


def parse_scale(text: str) -> float:
    """A number greater than zero. Raises `StyleError`."""
    try:
        scale = float(text)
    except ValueError:
        scale = 0.0
    if not 0.01 <= scale <= 1000.0:
        raise StyleError(f"{text!r} is not a valid scale: give a number from 0.01 to 1000")
    return scale
