"""Pictures of folds, many in one window, and what is drawn on each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from OpenGL import GL

from glshim.render.backend import Backend
from glshim.styling.protocol import Layer
from stylers.raskar import Raskar
from tests import look
from tests.decision.folds import HALF_LENGTH, Variant, View, items, placed

SIZE = 384
"""Pixels of the window, square."""
WIDTH = 4.0
"""Pixels of the lines."""
_FOV = 60.0
NONE, WHOLE, BROKEN = "none", "whole", "broken"


@dataclass(frozen=True)
class Distance:
    """How far away folds stand, in object units (a fold is 0.9 long), and how many a side of the
    window show without touching."""

    away: float
    tiles: int

    @property
    def pixels(self) -> float:
        """Length on the screen of a fold seen square on."""
        return 2 * HALF_LENGTH / self.away * SIZE / 2 / np.tan(np.radians(_FOV / 2))


DISTANCES = (Distance(4.9, 4), Distance(14.0, 12), Distance(28.0, 24))


@dataclass(frozen=True)
class Outcome:
    """What one picture shows: `NONE` (no pixel of ink), `WHOLE` (at least 99 % of the pixels along
    the fold) or `BROKEN`."""

    view: View
    found: str
    share: float
    """Of the pixels along the fold, those with ink."""


def outcomes(
    backend: Backend, style: Raskar, views: Sequence[View], distance: Distance, variant: Variant
) -> Iterator[Outcome]:
    """Render views into the current window of `SIZE`, as many at once as it holds."""
    many = distance.tiles**2
    for first in range(0, len(views), many):
        part = views[first : first + many]
        _, found, share = picture(backend, style, part, distance, variant)
        yield from map(Outcome, part, found, share)


def picture(
    backend: Backend, style: Raskar, views: Sequence[View], distance: Distance, variant: Variant
) -> tuple[np.ndarray, list[str], list[float]]:
    """One frame with views as tiles from the lower left, what each shows, and its share of ink."""
    projection = look.perspective(_FOV)
    reach = distance.away * np.tan(np.radians(_FOV / 2))
    layer, ends = [], np.empty((len(views), 2, 2))
    for k, view in enumerate(views):
        row, column = divmod(k, distance.tiles)
        x, y = (reach * (2 * (at + 0.5) / distance.tiles - 1) for at in (column, row))
        camera = placed(view, np.array([x, y, -distance.away]), projection, (0, 0, SIZE, SIZE))
        layer += items(view, camera, variant)
        fold = np.array([(-HALF_LENGTH, 0, 0, 1), (HALF_LENGTH, 0, 0, 1)])
        clip = fold @ (projection @ camera.modelview).T
        ends[k] = (clip[:, :2] / clip[:, 3:] + 1) * SIZE / 2
    look.clear()
    for item in layer:
        look.draw_base(*item)
    before = look.pixels(SIZE, SIZE)
    backend.render(style.draws(Layer(tuple(layer))))
    after = look.pixels(SIZE, SIZE)
    GL.glFinish()
    return after, *classify(before, after, ends, distance.tiles)


def classify(
    before: np.ndarray, after: np.ndarray, ends: np.ndarray, tiles: int
) -> tuple[list[str], list[float]]:
    """Whether the fold of each tile is drawn; ends (N, 2, 2) are its ends in pixels.

    Asked are the pixels whose centre lies within 1 px of the fold, half the line's width and more
    from its ends. Ink elsewhere in the tile, but for `WIDTH` around the ends, breaks it, too.
    """
    ink = 1.0 - after.mean(axis=2) / before.mean(axis=2)
    rows, columns = np.mgrid[:SIZE, :SIZE]
    side = SIZE // tiles
    tile = (rows // side * tiles + columns // side).ravel()
    held = tile < len(ends)
    tile, ink = tile[held], ink.ravel()[held]
    centre = np.stack([columns, rows], axis=2).reshape(-1, 2)[held] + 0.5
    a, b = ends[tile, 0], ends[tile, 1]
    length = np.maximum(np.hypot(*(b - a).T), 1e-9)
    along = (b - a) / length[:, None]
    way = centre - a
    off = np.abs(way[:, 0] * along[:, 1] - way[:, 1] * along[:, 0])
    way = np.einsum("ij,ij->i", way, along)
    trim = np.minimum(WIDTH / 2, 0.3 * length)
    core = (off <= 1.0) & (way > trim) & (way < length - trim)
    count = len(ends)
    asked = np.bincount(tile[core], minlength=count)
    inked = np.bincount(tile[core & (ink > 0.5)], minlength=count)
    beyond = np.maximum(np.maximum(-way, way - length), 0.0)
    at_end = (beyond > 0) & (beyond <= WIDTH) & (off <= WIDTH)
    touched = np.bincount(tile[(ink > 0.02) & ~at_end], minlength=count)
    if (asked == 0).any():
        raise ValueError("a fold is too short on the screen to be asked about")
    share = inked / asked
    found = [WHOLE if s >= 0.99 else BROKEN if t else NONE
             for s, t in zip(share, touched, strict=True)]  # fmt: skip
    return found, share.tolist()
