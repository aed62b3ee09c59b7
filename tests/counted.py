"""What some work takes, counted rather than timed: the same on every machine, however busy."""

from __future__ import annotations

import sys
import tracemalloc
from collections.abc import Callable
from types import FrameType
from typing import NamedTuple


class Work(NamedTuple):
    """Of one call."""

    calls: int
    """Functions called, in Python and in C: a loop over elements calls once for each."""
    bytes: int
    """Most memory held at once beside what was held before: each pass over elements takes some."""


def work(run: Callable[[], object]) -> Work:
    """What run takes the second time: what it keeps is kept."""
    run()
    calls = 0

    def count(_frame: FrameType, event: str, _arg: object) -> None:
        nonlocal calls
        calls += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        run()
    finally:
        sys.setprofile(before)
    running = tracemalloc.is_tracing()
    if not running:
        tracemalloc.start()
    try:
        tracemalloc.reset_peak()
        held = tracemalloc.get_traced_memory()[0]
        run()
        peak = tracemalloc.get_traced_memory()[1] - held
    finally:
        if not running:
            tracemalloc.stop()
    return Work(calls, peak)
