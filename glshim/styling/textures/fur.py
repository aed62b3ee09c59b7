"""Cartoon fur: tufts as Dr. Seuss drew them in The Lorax (McGuire & Hughes 2004, figure 6)."""

from __future__ import annotations

import numpy as np
from numpy.random import Generator, default_rng
from PIL import Image, ImageDraw

from glshim.styling.textures.fields import Doubles, sharp

_SEED = 1971
_SPACING = 0.55
"""From one tuft to the next, in widths of the line."""
_FLAT = 24
"""Points of a curve."""
_ROOMY = 18.0
"""Pixels of a line whose locks have room for a hair within."""
_NARROWEST = 8
"""Columns that a tuft has at least."""


def cartoon_fur(width: float, length: float) -> Doubles:
    """Locks of hair that bend over to one side and end in points, drawn in outline, on a thin line
    along the inside. Drawn larger, then averaged: the rims are clean."""
    rows, columns = sharp(width, length)
    finer = max(256 // rows, 2)
    sheet = Image.new("L", (columns * finer, rows * finer))
    draw = ImageDraw.Draw(sheet)
    chance = default_rng(_SEED)
    end = length / width
    tufts = max(min(round(end / _SPACING), columns // _NARROWEST), 1)
    room = end / tufts / _SPACING  # 1, but where the tile is too short or too long to draw

    def fill(start: float, points: Doubles, ink: int) -> None:
        """A polygon in widths of the line, along and out from the inside, wherever it repeats."""
        along = start + points[:, 0] * room
        out = (1.0 - points[:, 1]) * sheet.height
        for turn in range(-int(along.max() // end), 1 + int((end - along.min()) // end)):
            at = (along + turn * end) * (sheet.width / end)
            draw.polygon(list(zip(at.tolist(), out.tolist(), strict=True)), fill=ink)

    thick = max(0.085, min(1.6 / width, 0.25))  # that much ink stays black in small fur
    starts = (np.arange(tufts) + chance.uniform(-0.3, 0.3, tufts)) * _SPACING * room
    for start in chance.permutation(starts):
        back, front, hair = _lock(chance)
        fill(start, np.concatenate([back, front[::-1]]), 0)  # it hides what is behind
        if width >= _ROOMY:
            fill(start, _stroke(hair, 0.7 * thick), 255)
        fill(start, _stroke(front, 0.8 * thick), 255)
        fill(start, _stroke(back, 1.1 * thick), 255)
    draw.rectangle((0, sheet.height * (1.0 - 1.2 * thick), sheet.width, sheet.height), fill=255)
    return np.asarray(sheet.reduce(finer), np.float64) / 255.0


def _lock(chance: Generator) -> tuple[Doubles, Doubles, Doubles]:
    """The long side of a lock, its short side and a hair within, each from the foot to the tip."""
    high = 0.42 + 0.55 * float(chance.beta(1.3, 1.1))
    wide = chance.uniform(0.55, 0.8)
    lean = high * chance.uniform(0.55, 1.2)
    tip = (lean, high)
    back = _curve(
        (-wide / 2, -0.05), (-0.1 * lean - wide / 2, chance.uniform(0.6, 0.8) * high), tip
    )
    front = _curve(
        (wide / 2, -0.05), (0.1 * lean + 0.35 * wide, chance.uniform(0.25, 0.4) * high), tip
    )
    part = chance.uniform(0.4, 0.65)
    hair = (1.0 - part) * back + part * front
    return back, front, hair[: int(_FLAT * chance.uniform(0.35, 0.7))]


def _curve(
    foot: tuple[float, float], bend: tuple[float, float], tip: tuple[float, float]
) -> Doubles:
    """(N, 2) points of a quadratic Bezier curve."""
    t = np.linspace(0.0, 1.0, _FLAT)[:, None]
    sides = (1.0 - t) ** 2 * np.array(foot) + t**2 * np.array(tip)
    return np.asarray(sides + 2.0 * t * (1.0 - t) * np.array(bend))


def _stroke(curve: Doubles, thick: float) -> Doubles:
    """(2 N, 2) outline of a curve that is thick at its foot and ends in a point."""
    way = np.gradient(curve, axis=0)
    way /= np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-12)
    half = thick / 2.0 * (1.0 - np.linspace(0.0, 1.0, len(curve)) ** 3)[:, None]
    aside = way[:, ::-1] * (-1.0, 1.0) * half
    return np.concatenate([curve + aside, (curve - aside)[::-1]])
