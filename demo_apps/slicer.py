"""A small slicer: `python -m demo_apps.slicer FILE.gcode` writes the planter of 09_gcode."""

import math
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

FILAMENT = math.pi * (1.75 / 2) ** 2  # square millimetres
LAYER, WIDTH = 2.0, 2.6  # of a strand, millimetres: a coarse nozzle
LAYERS, FLOOR = 17, 2  # in all; solid ones at the bottom
MIDDLE = 40.0  # of the bed, along x and y
Floats = NDArray[np.float64]


def outline(height: float, inset: float = 0.0, points: int = 60) -> Floats:
    """The planter's border at a height, (points, 2): six lobes that turn as they rise."""
    a = 2 * np.pi * np.arange(points) / points
    flare = 19.0 + 4.5 * math.sin(height / 34.0 * 2.2) + 0.10 * height
    radius = flare + 2.2 * np.cos(6 * (a + 0.022 * height)) - inset
    return np.stack([MIDDLE + radius * np.cos(a), MIDDLE + radius * np.sin(a)], axis=1)


def hatched(border: Floats, angle: float, gap: float) -> Iterator[Floats]:
    """Parallel lines, to and fro, inside a border: the two ends of each, (2, 2)."""
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    here = (border - MIDDLE) @ turn
    there = np.roll(here, -1, axis=0)
    for k, y in enumerate(np.arange(here[:, 1].min() + gap / 2, here[:, 1].max(), gap)):
        cuts = (here[:, 1] > y) != (there[:, 1] > y)
        a, b = here[cuts], there[cuts]
        x = np.sort(a[:, 0] + (y - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0]))
        for low, high in zip(x[::2], x[1::2], strict=True):
            if high - low > gap:
                yield np.array([(low, y), (high, y)])[:: (-1) ** k] @ turn.T + MIDDLE


class Writer:
    """Lines of G-code, and how much filament they have used."""

    def __init__(self) -> None:
        self.lines = ["; a twisted planter, made by demo_apps/slicer.py", "G28", "G90", "M82",
                      "G92 E0"]  # fmt: skip
        self.used = 0.0

    def strand(self, points: Floats, kind: str, z: float, closed: bool = True) -> None:
        """Lay plastic from point to point, (n, 2), and back to the first if it is closed."""
        self.lines.append(f";TYPE:{kind}")
        x, y = points[0]
        self.lines.append(f"G0 F6000 X{x:.3f} Y{y:.3f} Z{z:.3f}")
        for nx, ny in [*points[1:], points[0]] if closed else points[1:]:
            self.used += math.hypot(nx - x, ny - y) * LAYER * WIDTH / FILAMENT
            self.lines.append(f"G1 F1800 X{nx:.3f} Y{ny:.3f} E{self.used:.4f}")
            x, y = nx, ny


def sliced() -> str:
    """The planter as G-code: a skirt, a solid floor, two walls with a zigzag in between."""
    writer = Writer()
    writer.strand(outline(0.0, -6.0), "SKIRT", LAYER)
    for layer in range(LAYERS):
        z = LAYER * (layer + 1)
        writer.lines.append(f";LAYER:{layer}")
        if layer < FLOOR:
            for ends in hatched(outline(z, 3.4), math.pi / 4 * (1 + 2 * layer), WIDTH):
                writer.strand(ends, "SKIN", z, closed=False)
        else:
            writer.strand(outline(z, 8.4), "WALL-INNER", z)
            # Triangles between the walls: their corners in turn near the one and near the other.
            zigzag = outline(z, 3.6)
            zigzag[layer % 2 :: 2] = outline(z, 6.2)[layer % 2 :: 2]
            writer.strand(zigzag, "FILL", z)
        writer.strand(outline(z, 1.2), "WALL-OUTER", z)
    return "\n".join(writer.lines) + "\n"


def main() -> int:
    if len(sys.argv) != 2:
        print("usage: python -m demo_apps.slicer FILE.gcode", file=sys.stderr)
        return 2
    Path(sys.argv[1]).write_text(sliced(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
