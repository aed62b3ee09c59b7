"""What Tab offers after ``glshim``, and the scripts by which shells ask for it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from glshim.commands import cli
from glshim.styling import registry


def offered(line: str, capsys: pytest.CaptureFixture[str], *more: str) -> list[str]:
    assert cli.main(["completion", "--of", line, *more]) == 0
    return capsys.readouterr().out.split("\n")[:-1]


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("glshim ru", ["run"]),
        ("glshim --v", ["--version"]),
        ("glshim run --cap", ["--capture"]),
        ("glshim shot --s", ["--scale", "--size", "--style"]),
        ("glshim run --style rask", ["raskar"]),
        ("glshim run --style=rask", ["--style=raskar"]),
        ("glshim gallery --compare none rask", ["raskar"]),
        ("glshim gallery --styles 'none;rask", ["'none;raskar"]),
        ("glshim new-style mine --extends cartoon+rask", ["cartoon+raskar"]),
        ("glshim styles rask", ["raskar"]),
        ("glshim check-style rask", ["raskar"]),
        ("glshim view --style raskar:ridge_w", ["raskar:ridge_width="]),
        ("glshim run --style raskar:ridge_width=3,ridge_w", []),
        ("glshim run --style raskar:ridges=", ["raskar:ridges=off", "raskar:ridges=on"]),
        ("glshim run --style raskar:ink=red,texture=do", ["raskar:ink=red,texture=dotted"]),
        ("glshim run --style nothing:", []),
        ("glshim run --keys o", ["off", "on"]),
        ("glshim completion ", ["bash", "fish", "zsh"]),
        ("glshim run app.py --st", []),
        ("glshim run -m package --st", []),
        ("glshim run --style raskar app.py --st", []),
        ("glshim shot app.py --st", ["--style"]),
        ("glshim run ", []),
        ("glshim nothing ", []),
        ("glshim run 'a b", []),
    ],
)
def test_what_the_last_word_may_become(
    line: str, found: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert offered(line, capsys) == found


def test_every_command_and_every_style_is_offered(capsys: pytest.CaptureFixture[str]) -> None:
    assert offered("glshim ", capsys) == sorted(command.name for command in cli.COMMANDS)
    styles = sorted((*registry.names(), *registry.looks()))
    assert offered("glshim run --style ", capsys) == styles


def test_bash_gets_what_follows_its_own_word(capsys: pytest.CaptureFixture[str]) -> None:
    line = "glshim run --style raskar:ridge_w"
    assert offered(line, capsys, "--word", "ridge_w") == ["ridge_width="]
    assert offered("glshim run --style=rask", capsys, "--word", "rask") == ["raskar"]


def test_what_shells_call_is_not_in_the_help(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        cli.main(["completion", "--help"])
    assert "--of" not in capsys.readouterr().out
    with pytest.raises(SystemExit):
        cli.main(["completion"])


BASH = """
compopt() { :; }
COMP_LINE='glshim run --style raskar:ridge_w' COMP_POINT=33
_glshim glshim ridge_w :
printf '%s\\n' "${COMPREPLY[@]}"
COMP_LINE='glshim ru more' COMP_POINT=9
_glshim glshim ru glshim
printf '%s\\n' "${COMPREPLY[@]}"
"""
FISH = """
complete -C 'glshim run --style raskar:ridge_w'
complete -C 'glshim ru'
"""
ZSH = """
compadd() { while [[ $1 != -- ]]; do shift; done; shift; (( $# )) && print -l -- $@ }
_files() { print files }
words=(glshim run --style raskar:ridge_w) CURRENT=4; _glshim
words=(glshim ru) CURRENT=2; _glshim
words=(glshim run '') CURRENT=3; _glshim
"""
PROGRAMS = {
    "bash": (BASH, ["ridge_width=", "run"]),
    "fish": (FISH, ["raskar:ridge_width=", "run"]),
    "zsh": (f"compdef() {{ : }}\n{ZSH}", ["raskar:ridge_width=", "run", "files"]),
}


@pytest.mark.programs
@pytest.mark.parametrize("shell", PROGRAMS)
def test_the_shells_take_their_scripts(
    tmp_path: Path, shell: str, capsys: pytest.CaptureFixture[str]
) -> None:
    if shutil.which(shell) is None:
        pytest.skip(f"there is no {shell} here")
    command = tmp_path / "glshim"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m glshim "$@"\n')
    command.chmod(0o755)
    assert cli.main(["completion", shell]) == 0
    script = capsys.readouterr().out
    program, found = PROGRAMS[shell]
    before, rest = program.split("\n", 1)
    done = subprocess.run(
        [shell, "-c", f"{before}\n{script}\n{rest}"], capture_output=True, text=True, timeout=60,
        env=os.environ | {"PATH": f"{tmp_path}:{os.environ['PATH']}", "HOME": str(tmp_path)},
        check=False,
    )  # fmt: skip
    assert (done.stdout.split(), done.stderr) == (found, "")
