"""Pictures of folds, many in one window, and what is drawn on each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from glshim_stylers.raskar import Raskar
from OpenGL import GL

from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look
from tests.decision.folds import DEPTH, HALF_LENGTH, Variant, View, items, placed

SIZE = 384
"""Pixels of the window, square."""
WIDTH = 4.0
"""Pixels of the lines."""
_FOV = 60.0
_PIECE = 1.5
"""Pixels: short, and yet a strip 2 px wide has a pixel centre in each."""
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


DISTANCES = (Distance(4.9, 4), Distance(14.0, 12), Distance(28.0, 16))


@dataclass(frozen=True)
class Outcome:
    """What one picture shows: `NONE` (no pixel of ink), `WHOLE` (ink along at least 99 % of
    the fold) or `BROKEN`."""

    view: View
    found: str
    share: float
    """Of the fold, the part with ink; see `classify`."""


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
    wide = np.array([view.narrowest for view in views]) * DEPTH / (2 * HALF_LENGTH)
    return after, *classify(before, after, ends, wide * distance.pixels, distance.tiles)


def classify(
    before: np.ndarray, after: np.ndarray, ends: np.ndarray, wide: np.ndarray, tiles: int
) -> tuple[list[str], list[float]]:
    """Whether the fold of each tile is drawn, and the share of it that is.

    Ends (N, 2, 2) are the folds' in pixels, wide (N,) the pixels that the narrower face shows.
    Asked is along the fold, half the line's width and more from its ends: is there ink within 1 px
    in every piece of 1.5 px, and, where both faces are as wide as half the line and a pixel, in
    all pixels whose centre lies within 1 px? Ink elsewhere in the tile, but for `WIDTH` around the
    ends, breaks it, too.
    """
    count, side = len(ends), SIZE // tiles
    ink = 1.0 - after[..., 0] / before[..., 0].astype(np.float32)  # all is grey
    every = np.zeros((tiles * tiles, 2, 2), np.float32)
    every[:count] = ends
    every[count:, 1] = 1.0
    a, b = (every[:, end].reshape(tiles, 1, tiles, 1, 2) for end in (0, 1))
    x, y = (b - a)[..., 0], (b - a)[..., 1]
    length = np.hypot(x, y)
    x, y = x / length, y / length
    columns = np.arange(SIZE, dtype=np.float32).reshape(1, 1, tiles, side) + 0.5 - a[..., 0]
    rows = np.arange(SIZE, dtype=np.float32).reshape(tiles, side, 1, 1) + 0.5 - a[..., 1]
    off, way = np.abs(columns * y - rows * x), columns * x + rows * y
    dark = ink.reshape(tiles, side, tiles, side)
    trim = np.minimum(WIDTH / 2, 0.3 * length)
    core = (off <= 1.0) & (way > trim) & (way < length - trim)
    touched = dark > 0.02
    touched &= ~((off <= WIDTH) & ((way < 0) & (way >= -WIDTH)
                 | (way > length) & (way <= length + WIDTH)))  # fmt: skip
    touched = touched.any(axis=(1, 3)).ravel()[:count]
    tile = np.broadcast_to(np.arange(tiles**2).reshape(tiles, 1, tiles, 1), core.shape)[core]
    piece = tile * SIZE + ((way - trim)[core] / _PIECE).astype(int)
    piece, inked = piece[tile < count], (dark[core] > 0.5)[tile < count]
    pieces = np.bincount(piece, minlength=count * SIZE).reshape(count, SIZE)
    inked = np.bincount(piece, inked, count * SIZE).reshape(count, SIZE)
    if not pieces.any(axis=1).all():
        raise ValueError("a fold is too short on the screen to be asked about")
    share = (inked > 0).sum(axis=1) / (pieces > 0).sum(axis=1)
    full = inked.sum(axis=1) / pieces.sum(axis=1)
    share = np.where(wide > WIDTH / 2 + 1, np.minimum(share, full), share)
    found = [WHOLE if s >= 0.99 else BROKEN if t else NONE
             for s, t in zip(share, touched, strict=True)]  # fmt: skip
    return found, share.tolist()
