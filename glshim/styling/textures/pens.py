"""What a hand holds: pen, charcoal and watercolour (McGuire & Hughes 2004, figure 6).

Each function gives the ink (rows, columns), 0..1, of a stroke for a width and a length in pixels.
"""

from __future__ import annotations

import numpy as np
from numpy.random import default_rng

from glshim.styling.textures.fields import MOST, Doubles, even, inside, noise, places

_SEED = 2001


def pen(width: float, length: float) -> Doubles:
    """A hand-drawn pen stroke: solid, clean at the rims, swelling slowly as the hand presses."""
    along, across, grain = places(width, length)
    columns = along.shape[1]
    chance = default_rng(_SEED)

    def hand(pixels: float) -> Doubles:
        found = noise(chance, (1, columns), (1.0, pixels * columns / length))
        return np.asarray(np.tanh(0.7 * found))

    swell, wobble = hand(max(5.0 * width, 30.0)), hand(max(4.0 * width, 24.0))
    tremor, other = hand(max(1.2 * width, 6.0)), hand(max(1.2 * width, 6.0))
    outer = width * (0.17 - 0.15 * swell + 0.04 * wobble + 0.035 * tremor)
    inner = width * (0.97 + 0.02 * swell + 0.035 * wobble + 0.012 * other)
    y = across + width / 2.0
    return inside(np.maximum(outer - y, y - inner), 1.5 * grain)


def charcoal(width: float, length: float) -> Doubles:
    """A stick dragged over rough paper: it leaves ink on the paper's tooth, and more of it where it
    is pressed; the rim is uneven, most of all outside."""
    rows = int(np.clip(np.ceil(2.0 * width), 8, 256))
    columns = int(np.clip(round(rows * length / width), 16, MOST))
    fine = rows / width  # texels a pixel
    chance = default_rng(_SEED)
    tooth = even(
        noise(chance, (rows, columns), (1.1 * fine, 1.1 * fine))
        + 0.7 * noise(chance, (rows, columns), (0.6 * fine, 5.0 * fine))
        + 0.5 * noise(chance, (rows, columns), (2.6 * fine, 2.6 * fine))
    )
    firm = float(np.clip((8.0 - width) / 6.0, 0.0, 1.0))  # a fine line would break into dashes
    pressure = 0.86 + 0.2 * firm + 0.1 * noise(chance, (1, columns), (1.0, 14.0 * fine))
    across = (np.arange(rows)[:, None] + 0.5) / rows  # 0 outside, 1 inside
    wander = noise(chance, (1, columns), (1.0, 9.0 * fine))
    ragged = noise(chance, (1, columns), (1.0, 2.0 * fine))
    outer = 0.2 + 0.07 * wander + 0.05 * ragged
    inner = 0.06 + 0.03 * noise(chance, (1, columns), (1.0, 4.0 * fine))
    soft = max(0.3, 1.2 / width)
    body = np.clip((across - outer) / soft + 0.5, 0.0, 1.0)
    body *= np.clip((1.0 - across - inner) / (0.5 * soft) + 0.5, 0.0, 1.0)
    return np.clip((body * pressure - tooth) / 0.22 + 0.35, 0.0, 1.0) * (0.55 + 0.45 * body)


def watercolour(width: float, length: float) -> Doubles:
    """A wash: thin in the middle, darker at the rim to which the water carries the pigment, grainy
    where that settles in the paper, and of a strength that changes along."""
    rows = int(np.clip(np.ceil(3.0 * width), 24, 96))
    columns = int(np.clip(round(rows * length / width), 16, MOST))
    down, along = rows / width, columns / length  # texels a pixel
    chance = default_rng(_SEED)

    def line(pixels: float) -> Doubles:
        return noise(chance, (1, columns), (1.0, pixels * along))

    def cloud(across: float, pixels: float) -> Doubles:
        return noise(chance, (rows, columns), (across * down, pixels * along))

    grain = cloud(1.2, 1.2) + 0.6 * cloud(2.8, 2.8)
    bloom = cloud(0.5 * width, 1.2 * width)
    y = (np.arange(rows)[:, None] + 0.5) / down
    ragged = min(0.02 * width, 0.35) * grain
    outer = width * (0.15 + 0.045 * line(5.0 * width) + 0.025 * line(0.9 * width)) + ragged
    inner = width * (0.975 + 0.012 * line(4.0 * width)) - 0.5 * ragged
    depth = np.minimum(y - outer, inner - y)
    wet = np.clip(depth / max(0.02 * width, 0.7) + 0.5, 0.0, 1.0)
    load = 0.42 * np.exp(0.3 * np.tanh(line(7.0 * width)) + 0.4 * np.tanh(bloom))
    edge = np.clip(0.8 + 0.3 * line(3.0 * width), 0.3, 1.2)
    gathered = edge * (1.6 * _falling(depth, max(0.025 * width, 0.5))
                       + 0.45 * _falling(depth, 0.11 * width))  # fmt: skip
    front = np.clip(bloom / 0.05, 0.0, 1.0) * _falling(bloom, 0.25)  # where one wash ran into wet
    pigment = (load + 0.22 * front) * np.exp(0.14 * grain) + gathered
    return wet * (1.0 - np.exp(-pigment))


def _falling(distance: Doubles, reach: float) -> Doubles:
    return np.exp(-np.maximum(distance, 0.0) / reach)
