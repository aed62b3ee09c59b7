"""Tiers, and the virtual screens that tests draw on; see docs/internals/testing.md.

The tier of a test is that of its folder, unless the test or its module has the marker of another.
"""

from __future__ import annotations

import gc
import os
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

# Before anything imports numpy: OpenBLAS's threads spin while they wait for a processor, and here
# several processes share those that there are.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from glshim.running.headless import virtual_screen
from tests import sweep

HERE = Path(__file__).parent
TIERS = {
    "unit": "neither a screen nor OpenGL",
    "gl": "OpenGL in the process of the test, on a virtual screen",
    "programs": "programs in processes of their own",
}
TIER_OF = {
    "unit": "unit", "contract": "unit", "differential": "gl", "golden": "gl",
    "programs": "programs", "fuzz": "programs", "benchmarks": "programs",
}  # fmt: skip
"""By folder."""
FIRST = (
    "fuzz/test_fuzz.py", "programs/test_live.py",
    "differential/test_transparent.py", "programs/test_demo_apps.py",
    "golden/test_scenes.py", "programs/test_programs.py", "golden/test_lines.py",
    "golden/test_legacy.py", "programs/test_shot.py", "golden/test_two_pass.py",
)  # fmt: skip
"""The files that take longest: begun late, one of them would keep one processor busy alone."""
ORDER = ("fuzz", "differential", "golden", "programs", "benchmarks", "contract", "unit")
_until_the_end = ExitStack()


def pytest_configure(config: pytest.Config) -> None:
    """No `GLSHIM_*` variable of the caller's, and no screen of theirs."""
    for tier, meaning in TIERS.items():
        config.addinivalue_line("markers", f"{tier}: {meaning}")
    for name in list(os.environ):
        if name.startswith("GLSHIM_") or name in ("DISPLAY", "WAYLAND_DISPLAY"):
            del os.environ[name]
    os.environ["XDG_SESSION_TYPE"] = "x11"  # PyOpenGL looks at it when it is imported
    os.environ.setdefault("SDL_AUDIODRIVER", "dummy")


def pytest_report_header() -> str:
    """How to repeat what this run checks."""
    return "a full sweep" if sweep.FULL else f"TESTS_SEED={sweep.SEED}"


def pytest_xdist_auto_num_workers() -> int:
    """More than processors: a third of the time a test waits for a program or for a frame."""
    return -(-3 * len(os.sched_getaffinity(0)) // 2)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Every test gets the marker of its tier, so that `-m` chooses by it; long files go first."""
    items[:] = [item for item in items if sweep.has_its_turn(item.nodeid)]
    for item in items:
        if not any(item.get_closest_marker(tier) for tier in TIERS):
            item.add_marker(TIER_OF[_place(item).parts[0]])
    items.sort(key=_rank)


def pytest_collection_finish() -> None:
    """What is there now stays to the end: garbage collection need not look at it again."""
    gc.freeze()


def _place(item: pytest.Item) -> Path:
    return item.path.relative_to(HERE)


def _rank(item: pytest.Item) -> tuple[int, int]:
    place = _place(item)
    early = FIRST.index(str(place)) if str(place) in FIRST else len(FIRST)
    return early, ORDER.index(place.parts[0])


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """The first test that draws starts this process's screen. Each worker has its own: windows of
    one test never lie over those of another."""
    if "DISPLAY" not in os.environ and not item.get_closest_marker("unit"):
        os.environ.update(_until_the_end.enter_context(virtual_screen()))


def pytest_unconfigure() -> None:
    """Stop the screen."""
    _until_the_end.close()


@pytest.fixture(scope="module")
def display() -> Iterator[str]:
    """The name of a screen for programs alone, whose pictures are read from it."""
    with virtual_screen() as environment:
        yield environment["DISPLAY"]


@pytest.fixture(scope="module")
def small_display() -> Iterator[str]:
    """The same, not much larger than a window: the pointer is over it."""
    with virtual_screen("640x480x24") as environment:
        yield environment["DISPLAY"]
