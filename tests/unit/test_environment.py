"""The variables: what is read, and the line of each that cannot be used."""

from __future__ import annotations

from pathlib import Path

import pytest

import _glshim_start
from glshim.control.keys import DEFAULTS, KEYS, Keys, LiveSettings, parse_keys
from glshim.errors import StyleError
from glshim.running import environment, session, startup, stillness
from glshim.running.environment import Settings, parse_capture, parse_frames
from glshim.running.shots import plan

ROOT = Path(__file__).parents[2]


def test_what_starts_glshim_is_what_the_startup_files_look_for() -> None:
    starting = tuple(each.name for each in environment.VARIABLES if not each.needs)
    assert starting == _glshim_start.VARIABLES
    quoted = ", ".join(f'"{name}"' for name in starting)
    assert f"({quoted})" in (ROOT / "glshim.pth").read_text()


def test_names_that_are_written_twice_to_load_nothing_are_the_same() -> None:
    assert startup.KEYS == KEYS
    assert session.SHOT == plan.VARIABLE
    assert f'"{stillness.VARIABLE}"' in Path(startup.__file__).read_text()


def test_the_page_lists_every_variable_with_what_it_does() -> None:
    page = (ROOT / "docs" / "guide" / "running.md").read_text()
    for each in environment.VARIABLES:
        assert f"`{each.name}={each.example}`" in page
        assert each.needs or f"`{each.name}={each.example}` | {each.help}" in page


def test_nothing_set_asks_for_nothing() -> None:
    assert environment.read({}) == (Settings(), ())
    blank = {each.name: " " for each in environment.VARIABLES}
    assert environment.read(blank) == (Settings(), ())
    assert environment.read({"GLSHIM_STYLES": "fins,fill=cel"}) == (Settings(), ())  # needs keys


def test_the_environment_is_read_whole(tmp_path: Path) -> None:
    variables = {"GLSHIM_STYLE": " raskar ", "GLSHIM_FRAMES": "12", "GLSHIM_CAPTURE": "f%03d.png"}
    settings, complaints = environment.read(variables, str(tmp_path))
    assert complaints == ()
    assert settings.style == "raskar"
    assert settings.frames == 12
    assert settings.capture == str(tmp_path / "f%03d.png")


def test_a_style_file_is_found_from_where_the_program_was_started() -> None:
    settings, _ = environment.read({"GLSHIM_STYLE": "mine.toml"}, "/started/here")
    assert settings.style == "/started/here/mine.toml"
    settings, _ = environment.read({"GLSHIM_STYLE": "/there/mine.toml"}, "/started/here")
    assert settings.style == "/there/mine.toml"


def test_a_wrong_variable_counts_as_unset_and_is_said() -> None:
    settings, complaints = environment.read(
        {"GLSHIM_STYLE": "", "GLSHIM_FRAMES": "many", "GLSHIM_CAPTURE": "a.gif"}
    )
    assert (settings.style, settings.frames, settings.capture) == (None, None, None)
    assert [line.partition(":")[0] for line in complaints] == ["GLSHIM_FRAMES", "GLSHIM_CAPTURE"]


@pytest.mark.parametrize("text", ["0", "-1", "1.5", "ten", "", "1e3", "٣"])
def test_frames_are_a_whole_number_from_one(text: str) -> None:
    with pytest.raises(StyleError):
        parse_frames(text)


@pytest.mark.parametrize(
    "text", ["a%s.png", "a%d%d.png", "a%.png", "a.jpg", "a%d", "%", "a%(n)d.png"]
)
def test_a_capture_pattern_holds_one_number_at_most(text: str) -> None:
    with pytest.raises(StyleError):
        parse_capture(text)


@pytest.mark.parametrize("text", ["cycle=F99", "F3", "cycle=F10"])
def test_keys_that_make_no_sense_are_not_watched(text: str) -> None:
    with pytest.raises(StyleError) as caught:
        parse_keys(text)
    settings, complaints = environment.read({"GLSHIM_KEYS": text, "GLSHIM_STYLE": "raskar"})
    assert settings == Settings("raskar")
    assert complaints == (f"GLSHIM_KEYS: {caught.value}; live control is off",)


def test_keys_are_off_where_they_are_not_asked_for() -> None:
    for text in ("", " ", "off"):
        settings, complaints = environment.read({"GLSHIM_KEYS": text, "GLSHIM_STYLES": "raskar"})
        assert (settings.live, complaints) == (None, ())


def test_paths_are_taken_from_where_the_program_was_started(tmp_path: Path) -> None:
    environ = {"GLSHIM_KEYS": "on", "GLSHIM_STYLES": "raskar, a.toml,", "GLSHIM_SAVE": "shots"}
    settings, _ = environment.read(environ, str(tmp_path))
    assert settings.live is not None
    assert settings.live.styles == ("raskar", str(tmp_path / "a.toml"))
    assert settings.live.folder == str(tmp_path / "shots")
    settings, _ = environment.read({"GLSHIM_KEYS": "on"}, str(tmp_path))
    assert settings.live == LiveSettings(Keys(DEFAULTS), (), str(tmp_path))


def test_a_list_that_makes_no_sense_is_said_and_all_styles_are_gone_through() -> None:
    settings, complaints = environment.read({"GLSHIM_KEYS": "on", "GLSHIM_STYLES": "fins,fill=cel"})
    assert settings.live is not None
    assert settings.live.styles == ()
    assert complaints == (
        "GLSHIM_STYLES: fill=cel follows fins: write fins:fill=cel; "
        "the keys step through all styles",
    )
