"""Programs that paint once and rest: asked for frames, and ended when none come."""

from __future__ import annotations

import threading

import pytest

from glshim import toolkits
from glshim.running import rest, runners
from glshim.toolkits import frames
from glshim.toolkits.moment import Alarm, Moment


class World:
    """A program, and the seconds that pass."""

    def __init__(
        self, monkeypatch: pytest.MonkeyPatch, moment: Moment | None = None
    ) -> None:
        self.now, self.frames, self.answers = 100.0, 0, True
        self.log: list[str] = []
        self.runner = ""
        monkeypatch.setattr(rest, "real_clock", lambda: self.now)
        monkeypatch.setattr(toolkits, "redraw_from_a_thread", self.ask)
        monkeypatch.setattr(frames, "leave_now", lambda leave: self.log.append("left"))
        monkeypatch.setattr(frames, "_loop_asked", False)
        monkeypatch.setattr(rest.runners, "runner", lambda: self.runner)
        monkeypatch.setattr(frames, "_leaving", False)
        monkeypatch.setattr(rest.os, "_exit", lambda status: self.log.append(f"exit {status}"))
        self.watcher = rest._Watcher(lambda: self.frames, moment, lambda: 1.0)

    def ask(self) -> None:
        self.log.append("asked")
        self.frames += self.answers

    def wait(self, seconds: float) -> None:
        for _ in range(round(seconds * 100)):
            self.now += 0.01
            self.watcher.look()


def test_a_program_that_rests_is_asked_and_soon_again(monkeypatch: pytest.MonkeyPatch) -> None:
    world = World(monkeypatch)
    world.wait(100)  # it has shown nothing yet, and may take its time
    world.frames = 1
    world.wait(0.9)
    assert world.log == []
    world.wait(0.3)
    assert 2 <= world.frames <= 6
    world.frames += 1  # by itself
    world.log.clear()
    world.wait(0.9)
    assert len(world.log) <= 1


def test_one_that_does_not_answer_is_ended(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    world = World(monkeypatch)
    world.frames, world.answers = 1, False
    world.wait(rest.PATIENCE + 0.1)
    assert world.log == ["asked", "left"]
    assert "shows nothing new after frame 1" in capsys.readouterr().err
    monkeypatch.setattr(frames, "_loop_asked", True)
    world.wait(rest.PATIENCE + 0.1)
    assert world.log[2:] == ["exit 0"]


def test_one_that_works_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    world = World(monkeypatch)
    world.frames = 1
    for _ in range(100):
        world.watcher._worked = world.now
        world.wait(0.5)
    assert world.log == []


@pytest.mark.parametrize("at_work", ["draws", "showing"])
def test_one_that_draws_for_long_is_left_more_time(
    at_work: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    moment = Moment()
    world = World(monkeypatch, moment)
    world.frames, world.answers = 1, False
    count = iter(range(1 << 20))
    if at_work == "draws":
        monkeypatch.setattr(rest, "draws", lambda: next(count))
    else:
        monkeypatch.setattr(frames, "_showing", {1})
    world.wait(rest.PATIENCE * 4)
    assert "left" not in world.log
    world.wait(rest.PATIENCE * 4 + 0.1)  # it may draw for ever without showing it
    assert world.log[-1] == "left"


def test_a_test_runner_is_not_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    world = World(monkeypatch)
    assert rest.runners.runner() == ""
    world.frames, world.answers, world.runner = 1, False, "pytest"
    world.wait(rest.PATIENCE + 0.1)
    assert world.log == ["asked"]
    world.watcher.run()  # which has ended


def test_the_runner_is_found_from_any_thread() -> None:
    found: list[str] = []
    thread = threading.Thread(target=lambda: found.append(runners.runner()))
    thread.start()
    thread.join()
    assert found == ["pytest"]


# -- clocks that stand still -----------------------------------------------------------------------


def test_a_program_that_waits_for_a_timer_gets_it(monkeypatch: pytest.MonkeyPatch) -> None:
    moment = Moment()
    world = World(monkeypatch, moment)
    world.frames = 1
    moment.frame_ends()
    alarm = Alarm(moment, 3.0)
    assert not alarm.comes(again=True)
    world.wait(rest._NEXT_ALARM + 0.05)
    assert moment.now == pytest.approx(3.02)
    assert world.log == []
    assert alarm.comes(again=True)
    assert not alarm.comes(again=True)
    moment.pass_by(9.0)
    assert not alarm.comes(again=True)  # once a frame at most
    moment.frame_ends()
    assert alarm.comes(again=False)
    assert not moment.alarms


def test_one_whose_timers_show_nothing_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    moment = Moment()
    world = World(monkeypatch, moment)
    world.frames = 1
    alarm = Alarm(moment, 0.01)
    for _ in range(300):
        alarm.comes(again=True)
        world.wait(0.01)
    assert "asked" in world.log


def test_a_held_moment_is_asked_for_and_timers_wait(monkeypatch: pytest.MonkeyPatch) -> None:
    moment = Moment()
    world = World(monkeypatch, moment)
    world.frames, world.answers, moment.held = 1, False, True
    alarm = Alarm(moment, 0.01)
    world.wait(0.5)
    assert world.log == ["asked"]
    assert not alarm.comes(again=True)
    world.wait(1.0)  # it draws by its timers alone
    assert alarm.comes(again=True)
    assert moment.now == 0.0
    moment.frame_ends()
    assert not alarm.comes(again=True)


def test_a_program_whose_first_frame_waits_for_a_timer(monkeypatch: pytest.MonkeyPatch) -> None:
    moment = Moment()
    world = World(monkeypatch, moment)
    alarm = Alarm(moment, 5.0)
    world.wait(rest._COMES_UP - 0.1)
    assert not alarm.comes(again=True)
    world.wait(0.3)
    assert alarm.comes(again=True)
