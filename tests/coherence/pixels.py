"""What of a picture is not carried along with the surfaces: lines, patterns, single pixels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.coherence.carry import NEAR, Motion

INK = 28.0
"""Levels by which a pixel of lines differs from what they are drawn on."""
REACH = 3
"""Pixels about the place that a line was carried to, in which it is looked for."""
OUTLINE = 5
"""Pixels beside a surface that its outline may take."""
_AROUND = ((0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1))
FAR = 6
"""Pixels in which a pattern is looked for; one that is found nowhere counts as so far away."""


def skeleton(mask: np.ndarray) -> np.ndarray:
    """(H, W) middle lines of strokes: T. Y. Zhang, C. Y. Suen, "A Fast Parallel Algorithm for
    Thinning Digital Patterns", CACM 1984."""
    found = np.pad(mask, 1)
    while True:
        before = int(found.sum())
        for odd in (0, 1):
            p = [np.roll(found, (-j, -i), (0, 1)) for i, j in _AROUND]
            neighbours = np.sum(p, axis=0)
            rises = np.sum([~p[k] & p[(k + 1) % 8] for k in range(8)], axis=0)
            up, right, down, left = p[0], p[2], p[4], p[6]
            if odd:
                kept = (up & right & left) | (up & down & left)
            else:
                kept = (up & right & down) | (right & down & left)
            found &= ~((neighbours >= 2) & (neighbours <= 6) & (rises == 1) & ~kept)
        if int(found.sum()) == before:
            return found[1:-1, 1:-1]


def dilated(mask: np.ndarray, reach: int) -> np.ndarray:
    """(H, W) within a square of so many pixels about it."""
    for axis in (0, 1):
        mask = np.any([np.roll(mask, k, axis) for k in range(-reach, reach + 1)], axis=0)
    return mask


def foremost(depth: np.ndarray, reach: int) -> tuple[np.ndarray, np.ndarray]:
    """(H, W), (H, W) the row and the column of the nearest surface in a square about each pixel:
    an outline lies beside its own."""
    at = np.arange(depth.size).reshape(depth.shape)
    for axis in (0, 1):
        best, own = depth.ravel()[at], at
        for k in range(-reach, reach + 1):
            moved = np.roll(own, -k, axis)
            there = depth.ravel()[moved]
            nearer = there < best - 1e-5
            best, at = np.where(nearer, there, best), np.where(nearer, moved, at)
    return np.divmod(at, depth.shape[1])


def lost(lines: np.ndarray, then: np.ndarray, motion: Motion, depth: np.ndarray) -> tuple[int, int]:
    """Pixels of length of lines that another frame does not have where they should be seen, and of
    all that could be told. lines, then: (H, W) where ink is; depth (H, W) of the first frame."""
    rows, columns = np.nonzero(skeleton(lines))
    front = foremost(depth, 2)
    around = dilated(then, REACH)
    height, width = lines.shape
    told = np.zeros(len(rows), np.bool_)
    missed = np.ones(len(rows), np.bool_)
    for at in ((rows, columns), (front[0][rows, columns], front[1][rows, columns])):
        # So far as its surface moves, from the line's own place.
        step = motion.there[at] - np.stack((at[1], at[0]), axis=1) - 0.5
        known = np.isfinite(step).all(axis=1)
        x, y = (np.where(known, np.rint(own + step[:, k]), 0).astype(int)
                for k, own in ((0, columns), (1, rows)))  # fmt: skip
        within = known & (x >= 2) & (y >= 2) & (x < width - 2) & (y < height - 2)
        x, y = np.where(within, x, 0), np.where(within, y, 0)
        told |= within
        missed &= ~within | (motion.seen[at] & ~around[y, x])
    return int((told & missed).sum()), int(told.sum())


def flicker(
    pictures: tuple[np.ndarray, np.ndarray], motion: Motion, depths: tuple[np.ndarray, np.ndarray]
) -> float:
    """Levels by which the pixels of surfaces differ from all nine where they have been carried to:
    of pictures (H, W, 3) and depths (H, W) of a frame and another one.

    Next to a nearer surface lies its outline, which goes with that: a pixel there may be carried
    with either; one that is not there before, but then, is not told.
    """
    picture, then = pictures
    (front, beside), (_, beside_then) = (_front(depth) for depth in depths)
    height, width = motion.seen.shape
    row, column = np.indices(motion.seen.shape)
    off = np.full(motion.seen.shape, np.inf)
    for at in ((row, column), front):
        step = np.nan_to_num(motion.there[at] - np.stack((at[1], at[0]), axis=2) - 0.5)
        x, y = (np.floor(own + step[..., k] + 0.5).astype(int)
                for k, own in ((0, column), (1, row)))  # fmt: skip
        told = motion.seen[at] & (x > 0) & (y > 0) & (x < width - 1) & (y < height - 1)
        x, y = np.where(told, x, 1), np.where(told, y, 1)
        told &= beside | ~beside_then[y, x]
        around = np.stack([then[y + j, x + i] for i in (-1, 0, 1) for j in (-1, 0, 1)])
        least, most = around.min(axis=0).astype(float), around.max(axis=0).astype(float)
        away = np.maximum(picture - most, least - picture).max(axis=2)
        off = np.where(told, np.minimum(off, np.maximum(away, 0.0)), off)
    return float(off[np.isfinite(off)].mean()) if np.isfinite(off).any() else 0.0


def _front(depth: np.ndarray) -> tuple[tuple[np.ndarray, np.ndarray], np.ndarray]:
    """The rows and columns of the nearest surface about each pixel, and (H, W) whether that is
    another one, before the pixel's own."""
    at = foremost(depth, OUTLINE)
    return at, depth[at] < depth - NEAR * (1.0 - depth) * OUTLINE - 1e-6


@dataclass
class Drift:
    """Of a pattern on surfaces."""

    pixels: float = 0.0
    """Sum over blocks."""
    blocks: int = 0

    def add(self, picture: np.ndarray, then: np.ndarray, base: np.ndarray, motion: Motion) -> None:
        """How far off the surfaces the pattern of a picture (H, W, 3) is in another one, block by
        block, where the program's own picture (H, W, 3) says little."""
        grey, later, plain = (one.astype(float).mean(axis=2) for one in (picture, then, base))
        carried, sound = _sampled(later, motion)
        flat = np.abs(plain - _box(plain, 7)) < 5.0
        one_body = _box((motion.body > 0).astype(float), 3) > 0.99
        calm = np.all([_box(np.roll(motion.body, s, a) == motion.body, 0) > 0.5
                       for s in (-5, 5) for a in (0, 1)], axis=0)  # fmt: skip
        valid = (sound & flat & one_body & calm).astype(float)
        a, b = (_box(one, 1) - _box(one, 7) for one in (grey, carried))
        half, step = 9, 16
        weight = _box(valid, half)
        power = _box(valid * a * a, half)
        best = np.full(grey.shape, np.inf)
        off = np.full(grey.shape, float(FAR))
        for j in range(-FAR, FAR + 1):
            for i in range(-FAR, FAR + 1):
                other = np.roll(b, (-j, -i), (0, 1))
                there = valid * np.roll(valid, (-j, -i), (0, 1))
                share = np.maximum(_box(there, half), 1e-9)
                cost = _box(there * (a - other) ** 2, half) / share
                cost = np.where(share < 0.5 * weight, np.inf, cost)
                better = cost < best
                best, off = np.where(better, cost, best), np.where(better, np.hypot(i, j), off)
        mean = power / np.maximum(weight, 1e-9)
        off = np.where(best < 1.3 * mean, off, float(FAR))
        blocks = np.zeros(grey.shape, np.bool_)
        blocks[half + FAR : -half - FAR : step, half + FAR : -half - FAR : step] = True
        blocks &= (weight > 0.6) & (mean > 3.0**2)
        self.pixels += float(off[blocks].sum())
        self.blocks += int(blocks.sum())

    @property
    def mean(self) -> float | None:
        """Pixels a frame; None where surfaces have no pattern."""
        return self.pixels / self.blocks if self.blocks >= 4 else None


def _sampled(image: np.ndarray, motion: Motion) -> tuple[np.ndarray, np.ndarray]:
    """(H, W) another frame's picture where pixels have been carried to, and (H, W) where that is
    known."""
    there = np.where(motion.seen[..., None], motion.there, 1.5) - 0.5
    x, y = (np.floor(there[..., k]).astype(int) for k in (0, 1))
    u, v = there[..., 0] - x, there[..., 1] - y
    found = (1 - v) * ((1 - u) * image[y, x] + u * image[y, x + 1])
    found += v * ((1 - u) * image[y + 1, x] + u * image[y + 1, x + 1])
    return found, motion.seen


def _box(image: np.ndarray, half: int) -> np.ndarray:
    """(H, W) means over squares."""
    image = np.asarray(image, float)
    if not half:
        return image
    size = 2 * half + 1
    for axis in (0, 1):
        pad = [(0, 0), (0, 0)]
        pad[axis] = (half + 1, half)
        total = np.cumsum(np.pad(image, pad, mode="edge"), axis=axis)
        ends = [slice(None), slice(None)]
        starts = [slice(None), slice(None)]
        ends[axis], starts[axis] = slice(size, None), slice(None, -size)
        image = (total[tuple(ends)] - total[tuple(starts)]) / size
    return image
