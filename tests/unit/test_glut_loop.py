"""GLUT's main loop while its clock stands still, round by round."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from glshim.toolkits import glut
from glshim.toolkits.base import Changes
from glshim.toolkits.glut import SETTLE, GlutLoop
from glshim.toolkits.moment import STEP, Moment


class Clock:
    """The real one, as the loop sees it."""

    def __init__(self) -> None:
        self.now = 0.0

    def sleep(self, seconds: float) -> None:
        self.now += seconds


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    found = Clock()
    monkeypatch.setattr(glut, "real_clock", lambda: found.now)
    monkeypatch.setattr(glut, "real_sleep", found.sleep)
    return found


@pytest.fixture
def loop(clock: Clock) -> tuple[Any, GlutLoop]:
    """A program's GLUT, and the loop that stands in for its own."""
    module = SimpleNamespace(GLUT_ELAPSED_TIME=700)
    found = GlutLoop(module, Moment(), lambda: None)
    found.serve(Changes())
    return module, found


def test_no_time_passes_until_the_first_picture_however_late(loop: tuple[Any, GlutLoop]) -> None:
    module, pump = loop
    fired: list[float] = []
    module.glutTimerFunc(0, lambda value: fired.append(pump.moment.now))
    for _ in range(SETTLE + 100):
        pump.pump()
    assert pump.moment.now == 0
    assert fired == []
    pump.moment.frame_ends()
    pump.pump()
    assert fired == [STEP]


def test_a_program_that_shows_nothing_by_itself_is_served_after_a_while(
    loop: tuple[Any, GlutLoop], clock: Clock
) -> None:
    module, pump = loop
    idle: list[float] = []
    module.glutIdleFunc(lambda: idle.append(clock.now))
    while not idle:
        pump.pump()
    assert glut.COMES_UP <= idle[0] < glut.COMES_UP + 0.5
    assert pump.moment.now == pytest.approx(STEP)


def test_a_round_without_a_picture_passes_the_time_of_a_frame(loop: tuple[Any, GlutLoop]) -> None:
    module, pump = loop
    fired: list[float] = []
    for _ in range(SETTLE):
        pump.pump()
    pump.moment.frame_ends()
    module.glutTimerFunc(90, lambda value: fired.append(round(pump.moment.now / STEP)))
    for _ in range(6):
        pump.pump()
    assert fired == [6]
