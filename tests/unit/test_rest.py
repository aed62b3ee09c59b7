"""Programs that paint once and rest: asked for frames, and ended when none come."""

from __future__ import annotations

import threading

import pytest

from glshim import toolkits
from glshim.running import rest, runners
from glshim.toolkits import frames


class World:
    """A program, and the seconds that pass."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, *, asks: bool = True) -> None:
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
        self.watcher = rest._Watcher(lambda: self.frames, asks, lambda: 1.0)

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
