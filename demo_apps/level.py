"""The level of 10_textured_room: its rooms, its textures and its light; plain numpy, no OpenGL."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

# One letter a square metre: # rock, - doorway, w water, 1 to 3 steps, u dais, o pillar, c crate,
# C two crates, l and L lamps.
LEVEL = (
    "####################",
    "#........###.......#",
    "#.o....o.###.c...c.#",
    "#...ww...#.....l.C.#",
    "#.l.ww.l.-.........#",
    "#...ww...#.........#",
    "#.o....o.###....c..#",
    "#c.......###.......#",
    "########-####-######",
    "#uuu321......l.....#",
    "#uLu321.l......c...#",
    "#uuu321.....C......#",
    "####################",
)
STEPS = {"1": 0.25, "2": 0.5, "3": 0.75, "u": 1.0, "L": 1.0, "w": -0.5}
CEILING, LINTEL, WATER = 3.0, 2.25, -0.14
LEVELS = (-0.5, 0.0, 0.25, 0.5, 0.75, 1.0, LINTEL, CEILING)  # where walls are cut, all alike
FINE = 8  # cells of the map of obstacles to a metre
LUMELS = 4  # samples of light along each side of a patch
PER_ROW = 64  # patches in a row of the light map
Floats = NDArray[np.float64]
Picture = NDArray[np.uint8]


def grain(seed: int, size: int = 128) -> Floats:
    """Noise that tiles, about 0, (size, size)."""
    generator = np.random.default_rng(seed)
    along = np.fft.fftfreq(size)[:, None] * size
    wave = np.hypot(along, along.T)
    smooth = np.where(wave > 0, np.maximum(wave, 1.0) ** -1.0, 0.0)
    field = np.fft.ifft2(smooth * np.fft.fft2(generator.normal(size=(size, size)))).real
    return np.asarray(field / field.std())


def painted(colour: Floats, seed: int, strength: float) -> Picture:
    """Colours (128, 128, 3) in 0..1, made uneven."""
    return (np.clip(colour * (1 + strength * grain(seed)[..., None]), 0, 1) * 255).astype(np.uint8)


def bricks() -> Picture:
    """Eight courses of four bricks, every other one shifted by half; two metres."""
    y, x = np.mgrid[0:128, 0:128]
    row = y // 16
    across = (x + 16 * (row % 2)) % 128
    joint = (y % 16 < 2) | (across % 32 < 2)
    tint = np.random.default_rng(4).uniform(0.82, 1.12, (8, 4))[row, across // 32]
    edge = np.where((y % 16 == 2) | (across % 32 == 2), 1.12, np.where(y % 16 == 15, 0.82, 1.0))
    clay = np.array((0.74, 0.42, 0.32)) * (tint * edge)[..., None]
    return painted(np.where(joint[..., None], (0.66, 0.62, 0.56), clay), 5, 0.09)


def tiles() -> Picture:
    """Sixteen tiles of two colours with light joints; two metres."""
    y, x = np.mgrid[0:128, 0:128]
    joint = (y % 32 < 2) | (x % 32 < 2)
    dark = ((x // 32 + y // 32) % 2 == 0)[..., None]
    body = np.where(dark, (0.52, 0.58, 0.60), (0.86, 0.82, 0.72))
    return painted(np.where(joint[..., None], (0.44, 0.44, 0.42), body), 6, 0.05)


def planks() -> Picture:
    """Four boards along v; a metre."""
    x = np.arange(128) + np.zeros((128, 1), int)
    fibre = np.sin(x * 0.9 + 5 * np.roll(grain(8)[:, :1], 3) + 0.6 * grain(9))
    tint = np.random.default_rng(2).uniform(0.85, 1.1, 4)[x // 32]
    wood = np.array((0.66, 0.47, 0.30)) * (tint * (1 + 0.07 * fibre))[..., None]
    return painted(np.where((x % 32 < 2)[..., None], (0.26, 0.17, 0.10), wood), 10, 0.04)


def crate() -> Picture:
    """One side of a crate: boards, a frame and a brace."""
    y, x = np.mgrid[0:128, 0:128]
    board = planks() / 255.0 * (1.15, 1.1, 1.0)
    rim = np.minimum(np.minimum(x, 127 - x), np.minimum(y, 127 - y))
    brace = np.abs(x - y) < 11
    frame = rim < 16
    line = (rim == 16) | ((np.abs(np.abs(x - y) - 11) < 2) & ~frame) | (rim < 1)
    board = np.where((brace | frame)[..., None], np.array((0.80, 0.60, 0.36)), 0.85 * board)
    return painted(np.where(line[..., None], (0.24, 0.15, 0.08), board), 12, 0.05)


def stone() -> Picture:
    """Two courses of blocks; a metre."""
    y, x = np.mgrid[0:128, 0:128]
    across = (x + 32 * (y // 64 % 2)) % 128
    joint = (y % 64 < 2) | (across % 64 < 2)
    body = np.full((128, 128, 3), (0.74, 0.73, 0.68))
    return painted(np.where(joint[..., None], (0.48, 0.47, 0.44), body), 13, 0.07)


def lamp() -> Picture:
    """A glowing pane in a dark frame."""
    y, x = np.mgrid[0:128, 0:128]
    rim = np.minimum(np.minimum(x, 127 - x), np.minimum(y, 127 - y))
    return painted(np.where((rim < 14)[..., None], (0.30, 0.26, 0.22), (1.0, 0.92, 0.66)), 14, 0.0)


def ripples() -> Picture:
    return painted(np.full((128, 128, 3), (0.52, 0.80, 0.84)), 15, 0.16)


TEXTURES: dict[str, Callable[[], Picture]] = {
    f.__name__: f for f in (bricks, tiles, planks, crate, stone, lamp, ripples)
}


SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])


def span(x: int, z: int) -> tuple[float, float]:
    """Heights of a cell's floor and ceiling."""
    letter = LEVEL[z][x]
    return STEPS.get(letter, 0.0), LINTEL if letter == "-" else CEILING


def polygon(x: float, z: float, radius: float, sides: int, turn: float = 0.0) -> Floats:
    """A regular border of the ground, (sides, 2), anticlockwise seen from above."""
    a = np.pi * (2 * np.arange(sides) + 1) / sides + math.radians(turn)
    return np.stack([x + radius * np.cos(a), z - radius * np.sin(a)], axis=1)


@dataclass
class Patch:
    """A quad, (4, 3) anticlockwise seen from inside the rooms, with its texture coordinates."""

    paint: str
    corners: Floats
    places: Floats


@dataclass
class Level:
    """Patches, and for tracing and walking the free space above each spot of the ground."""

    patches: list[Patch] = field(default_factory=list)
    lamps: list[tuple[float, float, float]] = field(default_factory=list)

    def __post_init__(self) -> None:
        shape = (len(LEVEL) * FINE, len(LEVEL[0]) * FINE)
        self.low, self.high = np.full(shape, 9.0), np.full(shape, 9.0)
        for z, row in enumerate(LEVEL):
            for x, letter in enumerate(row):
                if letter != "#":
                    part = (slice(z * FINE, z * FINE + FINE), slice(x * FINE, x * FINE + FINE))
                    self.low[part], self.high[part] = span(x, z)
        for z, row in enumerate(LEVEL):
            for x, letter in enumerate(row):
                if letter != "#":
                    self.cell(x, z)
                    self.furnish(letter, x + 0.5, z + 0.5)

    def add(self, paint: str, corners: object, places: object) -> None:
        self.patches.append(Patch(paint, np.array(corners, float), np.array(places, float)))

    def cell(self, x: int, z: int) -> None:
        """Floor, ceiling, and the walls towards what is rock, higher, or lower-ceiled."""
        low, high = span(x, z)
        ring = np.array([(x, z), (x, z + 1), (x + 1, z + 1), (x + 1, z)], float)
        self.add("tiles", np.insert(ring, 1, low, axis=1), ring / 2)
        self.add("planks", np.insert(ring[::-1], 1, high, axis=1), ring[::-1])
        for k, (dx, dz) in enumerate(((-1, 0), (0, 1), (1, 0), (0, -1))):
            next_low, next_high = span(x + dx, z + dz)
            rock = LEVEL[z + dz][x + dx] == "#"
            for bottom, top in [(low, high)] if rock else [(low, next_low), (next_high, high)]:
                door = LEVEL[z][x] == "-" or top <= 1.0
                for start, end in pairwise(h for h in LEVELS if bottom <= h <= top):
                    self.wall("stone" if door else "bricks", ring[k - 3], ring[k], start, end)

    def wall(self, paint: str, left: Floats, right: Floats, bottom: float, top: float) -> None:
        """An upright patch between two points of the ground, as seen from its front."""
        far = float(np.hypot(*(right - left)))
        # Whole metres of the map keep the texture's place; what is turned begins at its own edge.
        start = float(left @ (right - left)) / far if far == 1.0 else 0.0
        scale = 2.0 if paint == "bricks" else 1.0
        self.add(paint, [(x, y, z) for (x, z), y in
                         ((left, bottom), (right, bottom), (right, top), (left, top))],
                 [(u / scale, v / scale) for u, v in
                  ((start, bottom), (start + far, bottom), (start + far, top), (start, top))])

    def box(self, paint: str, ring: Floats, bottom: float, top: float, ends: str = "top") -> None:
        """Upright sides over a border of the ground, (n, 2), with a top, a bottom, or neither.

        Square sides of a crate or a lamp show the whole picture.
        """
        for left, right in zip(ring, np.roll(ring, -1, axis=0), strict=True):
            self.wall(paint, left, right, bottom, top)
            if paint in ("crate", "lamp"):
                self.patches[-1].places = SQUARE
        for end, height, order in (("top", top, 1), ("bottom", bottom, -1)):
            if end in ends:
                self.add(paint, np.insert(ring[::order], 1, height, axis=1), SQUARE)
        self.raise_ground(ring.mean(axis=0), float(np.abs(ring - ring.mean(axis=0)).max()),
                          bottom, top)  # fmt: skip

    def raise_ground(self, middle: Floats, reach: float, bottom: float, top: float) -> None:
        """What stands on the ground stops light and feet; what hangs lets both by."""
        if bottom > 1.5:
            return
        z, x = (np.arange(n) / FINE + 0.5 / FINE for n in self.low.shape)
        inside = np.hypot(x - middle[0], (z - middle[1])[:, None]) < reach * 1.08
        self.low = np.where(inside, np.maximum(self.low, top), self.low)

    def furnish(self, letter: str, x: float, z: float) -> None:
        """What stands in the middle of a cell."""
        if letter == "o":
            self.box("stone", polygon(x, z, 0.48, 4), 0.0, 0.25)
            self.box("stone", polygon(x, z, 0.27, 8), 0.25, 2.75, ends="")
            self.box("stone", polygon(x, z, 0.48, 4), 2.75, CEILING, ends="bottom")
        elif letter in "cC":
            turn = 37.0 * x + 61.0 * z
            self.box("crate", polygon(x, z, 0.58, 4, turn), 0.0, 0.82)
            if letter == "C":
                self.box("crate", polygon(x + 0.04, z, 0.48, 4, turn + 28.0), 0.82, 1.5)
        elif letter in "lL":
            self.box("lamp", polygon(x, z, 0.3, 4), 2.62, 2.88, ends="top bottom")
            self.lamps.append((x, 2.5, z))

    def light(self) -> Picture:
        """The light map: for each patch LUMELS x LUMELS samples, from edge to edge."""
        corners = np.stack([p.corners for p in self.patches])
        ahead, up = corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0]
        normals = np.cross(ahead, up)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        t, s = np.mgrid[0:LUMELS, 0:LUMELS] / (LUMELS - 1) * 0.96 + 0.02
        spots = (corners[:, None, None, 0] + s[..., None] * ahead[:, None, None]
                 + t[..., None] * up[:, None, None] + 0.09 * normals[:, None, None])  # fmt: skip
        shape = spots.shape
        spots, facing = spots.reshape(-1, 3), np.repeat(normals, LUMELS**2, axis=0)
        light = np.tile((0.20, 0.22, 0.28), (len(spots), 1))
        for lamp_place in self.lamps:
            for aside in ((0.12, 0.0), (-0.12, 0.0), (0.0, 0.12), (0.0, -0.12)):  # soft shadows
                way = np.add(lamp_place, (aside[0], 0.0, aside[1])) - spots
                far = np.linalg.norm(way, axis=1)
                lit = np.flatnonzero((far < 9.0) & ((way * facing).sum(axis=1) > 0.0))
                lit = lit[self.free(spots[lit], way[lit])]
                slant = (way[lit] * facing[lit]).sum(axis=1) / far[lit]
                strength = 0.55 * (0.25 + 0.75 * slant) / (1 + 0.10 * far[lit] ** 2)
                light[lit] += strength[:, None] * (1.0, 0.88, 0.66)
        glowing = np.array([p.paint == "lamp" for p in self.patches])
        patches = np.where(glowing[:, None, None, None], 1.0, light.reshape(shape))
        rows = 1 << (-(-len(patches) // PER_ROW) - 1).bit_length()
        table = np.zeros((rows * PER_ROW, LUMELS, LUMELS, 3))
        table[: len(patches)] = np.clip(patches, 0.0, 1.0)
        atlas = table.reshape(rows, PER_ROW, LUMELS, LUMELS, 3).transpose(0, 2, 1, 3, 4)
        self.rows = rows
        return (atlas.reshape(rows * LUMELS, PER_ROW * LUMELS, 3) * 255).astype(np.uint8)

    def free(self, spots: Floats, way: Floats, steps: int = 30) -> NDArray[np.bool_]:
        """Whether nothing lies between spots and spots + way, (n, 3) each."""
        found = np.ones(len(spots), bool)
        for part in np.linspace(0.02, 0.96, steps):
            x, y, z = (spots + part * way).T
            i, k = (z * FINE).astype(int), (x * FINE).astype(int)
            found &= (self.low[i, k] < y) & (y < self.high[i, k])
        return found

    def lumels(self, patch: int) -> Floats:
        """The light map's coordinates at a patch's corners, in the middles of its outer samples."""
        row, column = divmod(patch, PER_ROW)
        start = np.array((column, row)) * LUMELS + 0.5
        return (start + SQUARE * (LUMELS - 1)) / (np.array((PER_ROW, self.rows)) * LUMELS)
