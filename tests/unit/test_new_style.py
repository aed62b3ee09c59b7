"""``glshim new-style``: what it writes is a style that holds up, and it writes over nothing."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from OpenGL import GL

import glshim
from glshim import parse_style
from glshim.checks import scenes, values, window
from glshim.checks.finding import finding
from glshim.checks.layers import SIDE
from glshim.commands import cli
from glshim.styling import registry


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def styles_said(capsys: pytest.CaptureFixture[str]) -> list[str]:
    """The styles in the commands that are printed."""
    return re.findall(r"--style (\S+)|check-style (\S+)", capsys.readouterr().out)


@pytest.mark.parametrize(
    ("arguments", "file", "style"),
    [
        (["ink-lines"], "ink_lines.py", "ink_lines.py:InkLines"),
        (["dots.py"], "dots.py", "dots.py:Dots"),
        (["mine", "--toml"], "mine.toml", "mine.toml"),
        (["mine.toml"], "mine.toml", "mine.toml"),
        (["mine", "--extends", "charcoal:paper=#ffffff"], "mine.toml", "mine.toml"),
    ],
)
def test_it_writes_a_style_and_says_how_to_run_it(
    folder: Path, arguments: list[str], file: str, style: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["new-style", *arguments]) == 0
    out = capsys.readouterr().out
    assert [path.name for path in folder.iterdir()] == [file]
    for command in ("glshim run --style", "glshim view --style", "glshim check-style"):
        assert f"{command} {style}" in out
        assert f"    {command} {style}" in (folder / file).read_text()
    made = parse_style(style)
    checks = values.CHECKS if file.endswith(".py") else ()  # others are styles that are installed
    assert [str(found) for check in checks if (found := finding(check, made)).wrong] == []
    assert not re.search("FILE|CLASS|NAME|STYLE", (folder / file).read_text())


@pytest.mark.gl
@pytest.mark.parametrize("arguments", [["mine"], ["mine", "--toml"]])
def test_what_it_writes_draws_lines(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["new-style", *arguments]) == 0
    pictures = []
    for style in ("none", "mine.toml" if "--toml" in arguments else "mine.py:Mine"):
        with window.window(), glshim.style(style) as s:
            GL.glViewport(0, 0, SIDE, SIDE)
            scenes.prepare(SIDE)
            scenes.solids()
            pictures.append(s.image((SIDE, SIDE)).astype(int))
    assert capsys.readouterr().err == ""
    changed = np.abs(pictures[0] - pictures[1]).max(axis=2) > 40
    assert 0.002 < changed.mean() < 0.2


@pytest.mark.programs
def test_check_style_finds_nothing_wrong_with_it() -> None:
    assert cli.main(["new-style", "mine"]) == 0
    done = subprocess.run(
        [sys.executable, "-m", "glshim", "check-style", "mine.py:Mine"],
        capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("style", [*registry.names(), *registry.looks(), "cartoon+raskar"])
def test_every_option_of_a_style_file_is_what_it_was_once_it_is_uncommented(
    folder: Path, style: str
) -> None:
    assert cli.main(["new-style", "mine", "--extends", style]) == 0
    path = folder / "mine.toml"
    text = path.read_text()
    assert max(map(len, text.splitlines())) <= 100
    path.write_text(re.sub(r"(?m)^# (\w+ = )", r"\1", text))
    made = parse_style(style)
    assert parse_style(str(path)) == made
    assert text.count(" = ") > (1 if made.wants_polygons else 0)


def test_it_writes_over_nothing(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("mine.py", "mine.toml"):
        (folder / name).write_text("mine\n")
        assert cli.main(["new-style", name]) == 2
        assert f"{name} exists already" in capsys.readouterr().err
        assert (folder / name).read_text() == "mine\n"


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("3d", "not a valid name"),
        ("my style", "not a valid name"),
        ("class", "not a valid name"),
        ("random", "the name of a Python module"),
        ("numpy", "the name of a Python module"),
        ("gone/mine", "cannot write gone/mine.py: No such file"),
    ],
)
def test_what_it_does_not_write(
    folder: Path, name: str, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["new-style", name]) == 2
    assert says in capsys.readouterr().err
    assert [*folder.iterdir()] == []
