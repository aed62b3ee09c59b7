"""The command line without a program: the short list of styles, pipes that nobody reads, options in
the wrong place."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

import glshim
from glshim.commands import cli, styles
from glshim.running import launch
from glshim.styling import registry


def test_the_list_of_styles_fits_a_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["styles"]) == 0
    lines = capsys.readouterr().out.splitlines()
    installed = [*registry.names(), *registry.looks()]
    assert [line.split()[0] for line in lines if line.startswith("  ")] == installed
    assert len(lines) == len(installed) + 3
    assert max(map(len, lines)) <= 80
    assert all(len(line.split()) > 2 for line in lines if line.startswith("  "))


def test_a_style_that_cannot_be_loaded_is_listed_all_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(registry, "load", lambda name: registry.unknown("gone", name, ()))
    monkeypatch.setattr(
        "glshim.styling.descriptions.of_name", lambda name: (_ for _ in ()).throw(
            glshim.StyleError("style 'x' (m:X) cannot be loaded: No module named 'm'"))
    )  # fmt: skip
    (line,) = [line for line in styles.short_list(["x"], []) if line.startswith("  ")]
    assert "cannot be loaded" in line


def test_the_options_of_one_style_and_of_all(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["styles", "raskar"]) == 0
    one = capsys.readouterr().out
    assert "ridge_angle" in one
    assert cli.main(["styles", "--long"]) == 0
    every = capsys.readouterr().out
    assert one in every
    assert "\nanime: " in every


def test_the_version(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        cli.main(["--version"])
    assert caught.value.code == 0
    assert capsys.readouterr().out == f"glshim {glshim.__version__}\n"


def test_without_a_command_it_says_which_there_are(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main([]) == 2
    told = capsys.readouterr()
    assert all(f"\n    {command.name}" in told.out for command in cli.COMMANDS)
    assert told.err == ""


@pytest.mark.programs
@pytest.mark.parametrize(
    "arguments", [["styles", "--long"], ["--help"], ["styles", "--help"], ["check-style", "gone"]]
)
def test_a_pipe_that_nobody_reads_ends_a_command_without_a_word(arguments: list[str]) -> None:
    command = [sys.executable, "-m", "glshim", *arguments]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        assert running.stdout is not None
        assert running.stderr is not None
        running.stdout.close()  # what `head` does
        assert running.stderr.read() == b""
    assert running.returncode in (0, 141)  # argparse itself lets go where nothing is buffered


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> list[str]:
    """What is handed to the program."""
    got: list[str] = []

    def started(program: list[str], variables: Mapping[str, str], *, headless: bool) -> int:
        got.extend(program)
        return 0

    monkeypatch.setattr(launch, "run", started)
    assert cli.main(["run", *arguments]) == 0
    return got


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("scene.py --style raskar --frames 2", "--style raskar --frames 2 scene.py"),
        ("--keys on scene.py x --frames=3 -v", "--keys on --frames=3 scene.py x -v"),
        ("scene.py --headless", "--headless scene.py"),
        ("-m scene --style charcoal", "--style charcoal -m scene"),
    ],
)
def test_options_behind_the_script_are_the_programs_and_warned_about(
    typed: str, meant: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scene.py").touch()
    got = run(monkeypatch, *typed.split())
    assert got == typed.removeprefix("--keys on ").split()
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert said.endswith(f" type: glshim run {meant}\n")


@pytest.mark.parametrize(
    ("typed", "text"),
    [
        ("scene.py --frames 3", "parser.add_argument('--frames')"),
        ("-m scene --frames=3", "parser.add_argument('--frames')"),
        ("-m package.part --frames=3", "parser.add_argument('--frames')"),
        ("-- scene.py --frames 3", ""),
        ("scene.py --help -m x -o y --size 3", ""),
        ("scene.py frames style", ""),
    ],
)
def test_a_programs_own_options_are_passed_on_without_a_word(
    typed: str, text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scene.py").write_text(text)
    (tmp_path / "package").mkdir()
    (tmp_path / "package" / "part.py").write_text(text)
    assert run(monkeypatch, *typed.split()) == typed.removeprefix("-- ").split()
    assert capsys.readouterr().err == ""
