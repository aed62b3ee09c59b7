"""Luck, held: generators of random numbers that nobody seeds draw the same in every run.

Each gets a seed of its own, in the order in which they are made. What is random for safety's sake
stays so: `os.urandom`, `secrets`, `random.SystemRandom`, `uuid.uuid4`.
"""

from __future__ import annotations

import random
import sys
from collections.abc import Iterator
from itertools import count
from types import ModuleType
from typing import Any

from glshim.bindings.imports import after_import

SEED = 1
"""Of the generators that modules `random` and `numpy.random` share among all."""


def hold() -> None:
    """Seed from now on what a program does not seed, whether it has taken its names or not."""
    _hold_random()
    after_import("numpy.random", _hold_numpy)


def _hold_random() -> None:
    plain, seeds = random.Random.seed, count(SEED)

    def seed(generator: random.Random, a: Any = None, version: int = 2) -> None:
        plain(generator, next(seeds) if a is None else a, version)

    random.Random.seed = seed  # type: ignore[assignment, method-assign]
    random.seed = random._inst.seed
    random.seed(SEED)


def _hold_numpy(module: ModuleType) -> None:
    """Everything in numpy that is not seeded takes its entropy from one function: `default_rng`,
    `RandomState`, `SeedSequence` and the bit generators."""
    seeds: Iterator[int] = count(SEED)
    sys.modules["numpy.random.bit_generator"].randbits = (  # type: ignore[attr-defined]
        lambda bits: random.Random(next(seeds)).getrandbits(bits)
    )
    module.seed(SEED)
