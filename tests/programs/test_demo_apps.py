"""The demo programs at a keyboard and a mouse, in real time: they turn, zoom and end."""

import subprocess
import sys
import time

import pytest

from tests.sweep import some

from .catalog import HERE, OURS, Program
from .hand import ESCAPE, WHEEL_UP, Hand
from .harness import PLAIN, environment
from .sources import launch

PATIENCE = 20.0


@pytest.fixture
def hand(display: str) -> Hand:
    return Hand(display)


def start(program: Program, style: str | None, display: str, hand: Hand) -> "subprocess.Popen[str]":
    """Start it in real time and wait for its window."""
    command = launch(program)
    hand.let_go()
    process = subprocess.Popen(
        [sys.executable, *command.command], cwd=HERE.parent.parent,
        env=environment(style, display, command), stderr=subprocess.PIPE, text=True)
    limit = time.monotonic() + PATIENCE
    while not hand.windows() and time.monotonic() < limit and process.poll() is None:
        time.sleep(0.05)
    time.sleep(0.7)
    hand.move(320, 240)
    return process


@pytest.mark.parametrize(("program", "style"), [
    *(pytest.param(program, "raskar", id=f"{program.name}-raskar") for program in some(OURS, 9)),
    *(pytest.param(program, PLAIN, id=f"{program.name}-plain") for program in some(OURS, 4)),
])
def test_escape_ends_it_after_some_use(
        program: Program, style: str | None, display: str, hand: Hand) -> None:
    process = start(program, style, display, hand)
    try:
        hand.drag((300, 200), (360, 230))
        hand.click(WHEEL_UP)
        assert process.poll() is None
        hand.press(ESCAPE)
        _, errors = process.communicate(timeout=PATIENCE)
        assert process.returncode == 0, errors
        assert "Traceback" not in errors, errors
    finally:
        process.kill()
