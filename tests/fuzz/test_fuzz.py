"""The command itself, on some programs of the day, and on a fault that it must find."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests import sweep
from tests.fuzz import compare, look, making
from tests.fuzz.lanes import Lane
from tests.fuzz.worker import PLAIN

PROGRAMS = 3000 if sweep.FULL else 300


def test_programs_of_the_day(tmp_path: Path) -> None:
    ran = subprocess.run(
        [sys.executable, "-m", "tests.fuzz", "--programs", str(PROGRAMS), "--seed",
         str(sweep.SEED), "--every", "1" if sweep.FULL else "3", "--out", str(tmp_path)],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stdout


def test_a_program_is_the_same_each_time() -> None:
    assert making.program(3, 5) == making.program(3, 5) != making.program(3, 6)


@pytest.mark.parametrize(
    ("other", "seen"),
    [("GL.glFogf(GL.GL_FOG_END, 3.0)", "state: GL_FOG_END"), ("1 / 0", "result of 1 / 0"),
     ("GL.glRectf(0, 0, 1, 1)", "before: back")],
)  # fmt: skip
def test_the_comparison_sees_a_difference(
    display: str, monkeypatch: pytest.MonkeyPatch, other: str, seen: str
) -> None:
    monkeypatch.setenv("DISPLAY", display)
    one = ("a = window()", "None", "swap()")
    two = ("a = window()", other, "swap()")
    lane = Lane(PLAIN, "")
    try:
        plain, changed = lane.play(one), lane.play(two)
        assert compare.differences(one, plain, lane.play(one), compare.NONE) == []
        found = compare.differences(two, plain, changed, compare.NONE)
        assert seen in [difference.what for difference in found]
    finally:
        lane.close()


def test_every_row_of_the_state_has_a_name_of_its_own() -> None:
    for rows in look.PARTS.values():
        assert len({row.name for row in rows}) == len(rows)
