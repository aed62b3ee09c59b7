"""Texts of GLSHIM_KEYS and GLSHIM_STYLES, and what the controls make of wishes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from glshim import pipeline
from glshim.control import live, owners, pictures
from glshim.control.keys import (
    DEFAULTS,
    Keys,
    LiveSettings,
    parse_keys,
    parse_styles,
)
from glshim.errors import StyleError
from glshim.styling.protocol import Styler
from glshim.styling.texts import parse_style
from glshim.toolkits import keyboard


@pytest.mark.parametrize("text", ["on", " ON ", "yes", "true", "1"])
def test_on_gives_the_default_keys(text: str) -> None:
    assert parse_keys(text) == Keys(DEFAULTS)


@pytest.mark.parametrize("text", ["off", "no", "FALSE", "0"])
def test_off_gives_none(text: str) -> None:
    assert parse_keys(text) is None


@pytest.mark.parametrize(
    ("text", "changes"),
    [
        ("cycle=F5", {"cycle": "F5", "back": "shift+F5"}),
        ("cycle=ctrl+f5", {"cycle": "ctrl+F5", "back": "ctrl+shift+F5"}),
        ("cycle=shift+F5", {"cycle": "shift+F5", "back": None}),
        ("cycle=5", {"cycle": "5", "back": None}),
        ("cycle=off", {"cycle": None, "back": None}),
        ("cycle=F5, back=F4", {"cycle": "F5", "back": "F4"}),
        ("save=Alt+Ctrl+s,overlay=off", {"save": "ctrl+alt+S", "overlay": None}),
        ("toggle=pageup,", {"toggle": "PageUp"}),
        ("cycle=F10,toggle=F9", {"cycle": "F10", "back": "shift+F10", "toggle": "F9"}),
    ],
)
def test_keys_that_are_named_replace_their_defaults(
    text: str, changes: dict[str, str | None]
) -> None:
    keys = parse_keys(text)
    assert keys is not None
    assert keys.chords == {a: k for a, k in {**DEFAULTS, **changes}.items() if k}
    assert keys.named == set(changes)
    for action, key in keys.chords.items():
        assert keys.action(key) == action
    assert keys.action("F1") is None


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("cycle=F99", "unknown key 'F99': did you mean F9?"),
        ("cycle=hyper", "unknown key 'hyper': use F1 to F12, A to Z, 0 to 9, Insert"),
        ("cycle=meta+F3", "'meta' is not a modifier: use ctrl, alt, shift"),
        ("cicle=F3", "unknown action 'cicle': did you mean cycle?"),
        ("F3", "'F3' assigns no key: write on, off or ACTION=KEY"),
        ("cycle=", "'cycle=' assigns no key"),
        ("cycle=F10", "F10 is assigned to both cycle and toggle"),
        ("save=shift+7", "shift+7: shift with a digit types another character"),
    ],
)
def test_a_bad_text_says_what_is_wrong(text: str, says: str) -> None:
    with pytest.raises(StyleError, match=r".") as caught:
        parse_keys(text)
    assert str(caught.value).startswith(says)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("styles", "first", "row"),
    [
        (("a", "b", "c"), None, ("a", "b", "c")),
        (("a", "b", "c"), "none", ("a", "b", "c")),
        (("a", "b", "c"), "b", ("b", "c", "a")),
        (("a", "b"), "c:x=1", ("c:x=1", "a", "b")),
    ],
)
def test_the_row_begins_with_the_style_that_is_on(
    styles: tuple[str, ...], first: str | None, row: tuple[str, ...]
) -> None:
    assert live.cycle_of(styles, first) == row


def test_without_a_list_all_styles_and_looks_are_gone_through() -> None:
    row = live.cycle_of((), None)
    assert {"raskar", "edge_mesh", "fins"} < set(row)
    assert "none" not in row
    assert len(set(row)) == len(row)


class Stage:
    """Stands in for the pipeline: what is switched to draws from the next frame on."""

    def __init__(self, styler: Styler | None) -> None:
        self.now = self.next = styler


@pytest.fixture
def stage(monkeypatch: pytest.MonkeyPatch) -> Stage:
    made = Stage(None)
    monkeypatch.setattr(pipeline, "current", lambda: made.now)
    monkeypatch.setattr(pipeline, "switch", lambda styler: setattr(made, "next", styler))
    return made


def controls(folder: Path, styles: str, style: str | None = None) -> live.Controls:
    settings = LiveSettings(Keys(DEFAULTS), parse_styles(styles, str(folder)), str(folder))
    return live.Controls(settings, style, str(folder))


def after(made: live.Controls, stage: Stage, *chords: str) -> str:
    """The name of what draws once keys were pressed and frames have passed."""
    for chord in chords:
        made.press(chord)
    for _ in chords:
        made.frame_ends()
        stage.now = stage.next
    return stage.now.name if stage.now is not None else "none"


def test_cycling_goes_round_both_ways(tmp_path: Path, stage: Stage) -> None:
    made = controls(tmp_path, "raskar,fins,crease")
    assert [after(made, stage, "F9") for _ in range(4)] == ["raskar", "fins", "crease", "raskar"]
    assert [after(made, stage, "shift+F9") for _ in range(2)] == ["crease", "fins"]
    made = controls(tmp_path, "raskar,fins,crease")
    assert after(made, stage, "shift+F9") == "crease"


def test_presses_between_two_frames_are_all_heard(tmp_path: Path, stage: Stage) -> None:
    assert after(controls(tmp_path, "raskar,fins,crease"), stage, "F9", "F9", "F9") == "crease"


def test_toggling_comes_back_to_the_same_style(tmp_path: Path, stage: Stage) -> None:
    stage.now = stage.next = parse_style("fins")
    made = controls(tmp_path, "raskar,fins", "fins")
    assert [after(made, stage, "F10") for _ in range(2)] == ["none", "fins"]
    assert after(made, stage, "F10", "F9") == "raskar"
    stage.now = stage.next = None  # it failed
    assert after(made, stage, "F10") == "fins"


def test_a_file_that_is_saved_changes_its_own_style_alone(tmp_path: Path, stage: Stage) -> None:
    old, new, newer = (parse_style(f"fins:ink=#00000{n}") for n in range(3))
    stage.now = stage.next = old
    made = controls(tmp_path, "a.toml,raskar", str(tmp_path / "a.toml"))
    made.renew(new)
    assert stage.next is new  # it is on
    stage.now = new
    assert after(made, stage, "F10") == "none"
    made.renew(newer)
    assert stage.next is None  # it is off, and comes back as it was saved
    assert after(made, stage, "F10") == "fins"
    assert stage.now is newer
    assert after(made, stage, "F9") == "raskar"
    made.renew(new)
    assert stage.next is stage.now  # another one is on


def test_a_file_that_is_mended_comes_on(tmp_path: Path, stage: Stage) -> None:
    made = controls(tmp_path, "a.toml,raskar", str(tmp_path / "a.toml"))
    mended = parse_style("fins")
    made.renew(mended)
    assert stage.next is mended


def test_a_style_that_cannot_be_read_is_passed_over(
    tmp_path: Path, stage: Stage, capsys: pytest.CaptureFixture[str]
) -> None:
    made = controls(tmp_path, "raskar,missing.toml,fins")
    assert [after(made, stage, "F9") for _ in range(3)] == ["raskar", "fins", "raskar"]
    assert "missing.toml': cannot read style file" in capsys.readouterr().err
    nothing = controls(tmp_path, "nosuch")
    stage.now = stage.next = None
    assert after(nothing, stage, "F9") == "none"


def test_the_panel_says_which_style_of_how_many_is_on(tmp_path: Path, stage: Stage) -> None:
    made = controls(tmp_path, "raskar,fins:ink=#ff0000,crease")
    assert made._lines()[0] == "none"
    after(made, stage, "F9", "F9")
    assert made._lines()[0] == "2/3  fins ink=#ff0000"
    assert "F9 next   shift+F9 previous   F10 on/off   F11 save PNG   F12 hide" in made._lines()[2]


def test_pictures_are_named_after_what_a_viewer_shows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pictures, "grab", lambda *_: Image.new("RGB", (2, 2)))
    writer = pictures.Pictures(str(tmp_path))
    for name in ("bunny", "../small box"):
        monkeypatch.setenv("GLSHIM_NAME", name)
        writer.save("raskar")
    assert {path.name for path in tmp_path.iterdir()} == {
        "glshim-bunny-raskar-001.png", "glshim-small_box-raskar-001.png"
    }


def test_a_picture_never_replaces_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    picture = Image.fromarray(np.full((2, 3, 3), 7, np.uint8))
    monkeypatch.setattr(pictures, "grab", lambda *_: picture)
    monkeypatch.delenv("GLSHIM_NAME", raising=False)
    monkeypatch.setattr(pictures, "program_name", lambda: "app")
    (tmp_path / "glshim-app-a_b-002.png").write_text("kept")
    writer = pictures.Pictures(str(tmp_path / "new" / ".."))
    for _ in range(2):
        writer.save("a/b")
    assert (tmp_path / "glshim-app-a_b-002.png").read_text() == "kept"
    assert Image.open(tmp_path / "glshim-app-a_b-003.png").getpixel((0, 0)) == (7, 7, 7)
    said = capsys.readouterr().err.splitlines()
    assert [line.rpartition("-")[2] for line in said] == ["001.png", "003.png"]
    (tmp_path / "file").write_text("")
    pictures.Pictures(str(tmp_path / "file")).save("a")
    assert "cannot save a picture in" in capsys.readouterr().err


def test_a_default_key_that_the_program_names_stays_its_own(
    tmp_path: Path, stage: Stage, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.setattr(owners, "user_of", {"F9": "app.py"}.get)
    made = controls(tmp_path, "raskar")
    assert not made.owns("F9")
    assert not made.owns("shift+F9")
    assert made.owns("F10")
    assert not made.owns("F3")
    assert "the program uses F9 itself (app.py); choose another key with GLSHIM_KEYS=cycle=KEY" in (
        capsys.readouterr().err
    )
    named = live.Controls(LiveSettings(parse_keys("cycle=F9") or Keys({})), None, "")
    assert named.owns("F9")
    assert named.claims("F9")
    assert not named.claims("F10")


@pytest.mark.parametrize(
    ("line", "used"),
    [
        ("if key == glfw.KEY_F9: pass", True),
        ("def f(key):\n    return key == GLUT_KEY_F9", True),
        ("class A:\n    def f(self, e):\n        return e == Qt.Key.Key_F9", True),
        ("K = [pygame.K_F9]", True),
        ("print('F9: help')", True),
        ("widget.bind('<F9>')", True),
        ("KEYS = {'next': ('F9', 1)}", True),
        ("if os.environ['GLSHIM_KEYS'] == 'on': print('F9: next style')", False),
        ("# F9 is free\nx = 1", False),
        ("colour = '#F9'; b = 'AF9 F99 %F9'; KEY_F90 = 1", False),
    ],
)
def test_a_key_is_used_where_code_names_it(
    line: str, used: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import importlib.util
    import sys

    path = tmp_path / "part.py"
    path.write_text(f"if False:\n    {line.replace(chr(10), chr(10) + '    ')}\n")
    (tmp_path / "main.py").write_text("")
    for name, file in (("__main__", "main.py"), ("part", "part.py")):
        spec = importlib.util.spec_from_file_location(name, tmp_path / file)
        assert spec is not None
        monkeypatch.setitem(sys.modules, name, importlib.util.module_from_spec(spec))
    owners.user_of.cache_clear()
    try:
        assert owners.user_of("F9") == (str(path) if used else None)
    finally:
        owners.user_of.cache_clear()


class Listening:
    """Owns F5, and notes what is pressed."""

    def __init__(self) -> None:
        self.pressed: list[str] = []

    def owns(self, chord: str) -> bool:
        return chord in ("F5", "ctrl+F5")

    claims = owns

    def press(self, chord: str) -> None:
        self.pressed.append(chord)


def test_a_key_belongs_to_one_from_its_press_to_its_release() -> None:
    listening = Listening()
    keyboard.listen(listening)
    try:
        assert keyboard.pressed("F5", {"ctrl"})
        assert keyboard.pressed("F5", {"ctrl"}, again=True)
        assert keyboard.released("F5")
        assert not keyboard.released("F5")
        assert not keyboard.pressed("F5", {"shift"})
        assert not keyboard.pressed("F5", {"shift"}, again=True)
        assert not keyboard.released("F5")
        assert not keyboard.pressed(None)
        assert listening.pressed == ["ctrl+F5"]
    finally:
        keyboard.listen(None)
    assert not keyboard.pressed("F5")
