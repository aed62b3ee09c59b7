"""What happens when a style file is saved while a program runs: by a clock of the test's own."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest
from glshim_stylers.raskar import Raskar

from glshim.control.reload import INTERVAL, Reloader
from glshim.errors import StyleError
from glshim.styling.protocol import Styler
from glshim.styling.texts import parse_style


class Bench:
    """A reloader whose frames end when the test says so."""

    def __init__(self, folder: Path, text: str = "mine.toml") -> None:
        self.folder, self.now, self.taken = folder, 100.0, []
        self.reloader = Reloader(text, str(folder), self.taken.append, lambda: self.now)

    taken: list[Styler]

    def begin(self) -> Styler:
        return self.reloader.begin()

    def save(self, content: str, name: str = "mine.toml") -> None:
        (self.folder / name).write_text(content)

    def frames(self, count: int = 1, seconds: float = INTERVAL) -> None:
        for _ in range(count):
            self.now += seconds
            self.reloader.look()


Say = Callable[[], list[str]]


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    made = Bench(tmp_path)
    made.save('style = "raskar"')
    made.begin()
    return made


@pytest.fixture
def said(capsys: pytest.CaptureFixture[str]) -> Say:
    def lines() -> list[str]:
        return capsys.readouterr().err.splitlines()

    return lines


def test_what_is_saved_is_taken_up_once(bench: Bench, said: Say) -> None:
    bench.frames(3)
    assert bench.taken == []
    bench.save('style = "raskar"\nridges = false')
    bench.frames(3)
    assert bench.taken == [Raskar(ridges=False)]
    bench.save('style = "raskar" # the same\nridges = false')
    bench.frames(3)
    assert len(bench.taken) == 1
    assert said() == []


def test_files_are_looked_at_four_times_a_second(bench: Bench, monkeypatch) -> None:
    looks: list[str] = []
    plain = os.stat
    monkeypatch.setattr(os, "stat", lambda path: looks.append(str(path)) or plain(path))
    bench.frames(1000, 1 / 1000)
    assert len(looks) in (4, 5)


def test_a_broken_file_is_said_once_and_the_last_good_style_stays(bench: Bench, said: Say) -> None:
    bench.save('style = "raskar"\nridges = 3')
    bench.frames(1)
    assert said() == []  # it may be half written
    bench.frames(5)
    (line,) = said()
    assert line == (
        f"glshim: {bench.folder}/mine.toml:2: ridges=3 is not allowed: give on, off; "
        "the last good style stays"
    )
    bench.save('style = "raskar"\nridges = 3')
    bench.frames(5)
    assert said() == []
    bench.save('style = "raskar"\nridges = 3 # still')
    bench.frames(5)
    assert len(said()) == 1
    assert bench.taken == []
    bench.save('style = "raskar"\nridges = true\nridge_width = 9')
    bench.frames(5)
    assert said() == ["glshim: mine.toml is valid again; reloaded"]
    assert bench.taken == [Raskar(ridge_width=9)]


def test_a_half_written_file_is_nothing_to_speak_of(bench: Bench, said: Say) -> None:
    bench.save('style = "raskar"\nridges = fa')
    bench.frames(1)
    bench.save('style = "raskar"\nridges = false')
    bench.frames(1)
    assert bench.taken == [Raskar(ridges=False)]
    assert said() == []


def test_editors_that_delete_or_rename_are_followed(bench: Bench, said: Say) -> None:
    (bench.folder / "mine.toml").unlink()
    bench.frames(1)
    bench.save('style = "raskar"\nridges = false')
    bench.frames(1)
    bench.save('style = "raskar"\nridges = true', "mine.toml~")
    os.utime(bench.folder / "mine.toml~", ns=(0, 0))  # an older one, moved here
    os.replace(bench.folder / "mine.toml~", bench.folder / "mine.toml")
    bench.frames(1)
    assert bench.taken == [Raskar(ridges=False), Raskar()]
    assert said() == []


def test_whatever_is_extended_is_watched_too(bench: Bench, said: Say) -> None:
    bench.save('style = "raskar"', "base.toml")
    bench.save('extends = "base.toml"\nridge_width = 4')
    bench.frames(1)
    bench.save('style = "raskar"\nridges = false', "base.toml")
    bench.frames(1)
    assert bench.taken == [Raskar(ridge_width=4), Raskar(ridges=False, ridge_width=4)]
    bench.save("no toml", "base.toml")
    bench.frames(2)
    assert f"{bench.folder}/base.toml:1:" in said()[0]
    bench.save('style = "raskar"', "base.toml")
    bench.frames(1)
    assert bench.taken[2:] == [Raskar(ridge_width=4)]


def test_a_file_broken_at_the_start_is_taken_up_when_it_is_mended(
    tmp_path: Path, said: Say
) -> None:
    bench = Bench(tmp_path)
    with pytest.raises(StyleError):
        bench.begin()
    bench.frames(4)
    bench.save('style = "rasker"')
    bench.frames(4)
    assert ":1: no style is called 'rasker'" in said()[0]
    bench.save('style = "raskar"')
    bench.frames(1)
    assert bench.taken == [Raskar()]


STYLER = """
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar
from glshim import Styler, option

TEXT = Path(__file__).with_name("dots.glsl").read_text()

@dataclass(frozen=True)
class Dots(Styler):
    name: ClassVar[str] = "dots"
    size: float = option(SIZE, help="diameter", low=1, high=9)
    def draws(self, layer):
        return []
"""


def test_a_styler_and_the_shaders_beside_it_are_read_anew(tmp_path: Path, said: Say) -> None:
    bench = Bench(tmp_path, "dots.py:Dots:size=5")
    bench.save("one", "dots.glsl")
    bench.save(STYLER.replace("SIZE", "3"), "dots.py")
    first = bench.begin()
    assert first.size == 5
    bench.save("two", "dots.glsl")
    bench.frames(1)
    (second,) = bench.taken
    assert first != second  # their classes differ, and what these read
    bench.save(STYLER.replace("SIZE", "99"), "dots.py")
    bench.frames(3)
    assert "has an option 'size' whose default is not allowed: size=99.0" in said()[0]
    assert len(bench.taken) == 1


def test_a_text_without_a_file_is_not_watched(tmp_path: Path) -> None:
    from glshim.toolkits import frames

    reloader = Reloader("charcoal", str(tmp_path), lambda styler: None)
    assert reloader.begin() == parse_style("charcoal")
    before = frames._listeners
    reloader.install()
    assert frames._listeners == before
