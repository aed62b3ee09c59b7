"""What every run checks, and what a full sweep checks: `sh scripts/test sweep` runs all.

Where one mechanism serves many cases (the guard around every style, the recorder below every
program) each run takes some of them in turn: others on each day, so that all had theirs after some
days. The seed of a run stands in pytest's header; ``TESTS_SEED=N`` repeats its choice.
"""

from __future__ import annotations

import os
import time
import zlib
from collections.abc import Sequence
from typing import TypeVar

T = TypeVar("T")
FULL = os.environ.get("TESTS_SWEEP") == "1"
SEED = int(os.environ.setdefault("TESTS_SEED", str(int(time.time()) // 86400)))
"""Set once: worker processes take it over."""
SHARE = int(os.environ.get("TESTS_SHARE", "1"))
"""One in so many tests runs, in turn by the seed: where the same tests run more than once."""


def has_its_turn(name: str) -> bool:
    """Whether a test of that name is in this run's share."""
    return (zlib.crc32(name.encode()) + SEED) % SHARE == 0


def some(cases: Sequence[T], count: int, turn: int = 0) -> tuple[T, ...]:
    """`count` of the cases, or all of them in a full sweep.

    `turn` numbers the places that ask about the same cases, such as scenes that each run under some
    styles: neighbours get others.
    """
    if FULL or count >= len(cases):
        return tuple(cases)
    first = (SEED + turn) * count
    return tuple(cases[(first + i) % len(cases)] for i in range(count))
