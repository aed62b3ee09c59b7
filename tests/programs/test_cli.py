"""The command line: what is refused before anything starts, and that a program runs as plain."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import venv
from collections.abc import Mapping
from pathlib import Path

import pytest

from glshim.commands import cli
from glshim.errors import StyleError
from glshim.running import headless, launch

LOOK = """# takes --frames and --style itself
import __main__, json, os, sys
print(json.dumps({
    "argv": sys.argv, "path": sys.path[0], "name": __name__, "file": __file__,
    "main": __main__.__file__, "optimize": sys.flags.optimize, "spec": __spec__ and __spec__.name,
    "stdin": sys.stdin.read(), "cwd": os.getcwd(),
}))
"""


def glshim(
    *arguments: str, cwd: Path | None = None, environ: Mapping[str, str] = os.environ,
    flags: tuple[str, ...] = (), stdin: str = "",
) -> subprocess.CompletedProcess[str]:  # fmt: skip
    command = [sys.executable, *flags, "-m", "glshim", *arguments]
    return subprocess.run(
        command, cwd=cwd, env=environ, input=stdin, capture_output=True, text=True, timeout=120,
        check=False,
    )  # fmt: skip


def python(*arguments: str, cwd: Path, stdin: str = "") -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *arguments], cwd=cwd, input=stdin, capture_output=True, text=True,
        timeout=60, check=False,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--style", "rasker"], "did you mean raskar?"),
        (["--style", "raskar:ridge_angle=999"], "0..360 degrees"),
        (["--style", "nowhere.toml"], "nowhere.toml"),
        (["--frames", "0"], "whole number from 1"),
        (["--capture", "a.jpg"], ".png"),
        (["--keys", "cycle=F99"], "unknown key 'F99': did you mean F9?"),
    ],
)
def test_what_makes_no_sense_ends_with_2_before_the_program(
    tmp_path: Path, arguments: list[str], says: str
) -> None:
    (tmp_path / "app.py").write_text("open('started', 'w')")
    done = glshim("run", *arguments, "app.py", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stdout == ""
    assert says in done.stderr
    assert done.stderr.startswith("glshim: ")
    assert done.stderr.count("\n") == 1
    assert not (tmp_path / "started").exists()


@pytest.mark.parametrize("headless", [[], ["--headless"]])
@pytest.mark.parametrize(
    "program", [["app.py", "--frames", "x", "-m", "--"], ["-m", "app", "-m", "--style", "no"]]
)
def test_a_program_sees_what_python_shows_it(
    tmp_path: Path, program: list[str], headless: list[str]
) -> None:
    (tmp_path / "app.py").write_text(LOOK)
    plain = python("-O", *program, cwd=tmp_path, stdin="typed")
    shimmed = glshim("run", *headless, *program, cwd=tmp_path, flags=("-O",), stdin="typed")
    assert plain.returncode == 0
    assert shimmed.stdout == plain.stdout
    assert shimmed.stderr == ""


def test_the_flags_come_to_the_program_as_variables(tmp_path: Path) -> None:
    (tmp_path / "app.py").write_text(
        "import os; print(*(os.environ[f'GLSHIM_{n}'] for n in ('STYLE', 'FRAMES', 'CAPTURE')))"
    )
    done = glshim("run", "--frames", "3", "--capture", "f%02d.png", "app.py", cwd=tmp_path)
    assert done.stdout.split() == ["raskar", "3", str(tmp_path / "f%02d.png")]


@pytest.mark.parametrize(
    ("given", "variable", "style"),
    [
        (["--style", "pencil"], "blueprint", "pencil"),
        ([], " blueprint:width=3", "blueprint:width=3"),
        ([], "", "raskar"),
    ],
)
@pytest.mark.parametrize("command", [["run"], ["view"], ["shot"], ["doctor"]])
def test_the_option_comes_before_the_variable_and_that_before_raskar(
    command: list[str], given: list[str], variable: str, style: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    seen: list[str] = []

    def stop(text: str) -> str:
        seen.append(text.strip())
        raise StyleError("seen")

    monkeypatch.setenv("GLSHIM_STYLE", variable)
    monkeypatch.setattr("glshim.commands.command.style_variable", stop)
    assert cli.main([*command, *given, __file__]) == 2
    assert seen == [style]


@pytest.mark.parametrize("command", ["run", "view", "shot", "doctor"])
def test_a_wrong_name_in_the_variable_is_refused_with_the_nearest(
    command: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("GLSHIM_STYLE", "raskr")
    assert cli.main([command, __file__]) == 2
    told = capsys.readouterr().err
    assert told.startswith("glshim: GLSHIM_STYLE: no style is called 'raskr': did you mean raskar")


@pytest.mark.parametrize("headless", [[], ["--headless"]])
def test_the_exit_status_is_the_programs(tmp_path: Path, headless: list[str]) -> None:
    (tmp_path / "app.py").write_text("import sys; sys.exit(7)")
    assert glshim("run", *headless, "app.py", cwd=tmp_path).returncode == 7
    (tmp_path / "app.py").write_text("import os; os.kill(os.getpid(), 9)")
    assert glshim("run", *headless, "app.py", cwd=tmp_path).returncode == -9


def test_a_signal_reaches_the_program_and_the_screen_goes(tmp_path: Path) -> None:
    (tmp_path / "app.py").write_text(
        "import os, signal, sys, time\n"
        "signal.signal(signal.SIGTERM, lambda *_: sys.exit(5))\n"
        "print(os.environ['DISPLAY'], flush=True)\n"
        "time.sleep(60)"
    )
    command = [sys.executable, "-m", "glshim", "run", "--headless", "app.py"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, text=True) as running:
        assert running.stdout is not None
        display = running.stdout.readline().strip()
        socket = Path("/tmp/.X11-unix", "X" + display.removeprefix(":"))
        assert display != os.environ["DISPLAY"]
        assert socket.exists()
        running.send_signal(signal.SIGTERM)
        assert running.wait(20) == 5
    assert not socket.exists()


def test_a_machine_without_xvfb_and_egl_is_told_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(headless, "_has_egl", lambda: False)
    assert cli.main(["run", "--headless", "app.py"]) == 2
    assert "apt-get install xvfb" in capsys.readouterr().err


def test_python_that_reads_no_startup_file_is_refused(tmp_path: Path) -> None:
    root = Path(__file__).parents[2]
    environ = {**os.environ, "PYTHONPATH": os.pathsep.join([str(root), *sys.path[1:]])}
    done = glshim("run", "app.py", cwd=tmp_path, environ=environ, flags=("-S",))
    assert done.returncode == 2
    assert "without -S" in done.stderr


@pytest.mark.parametrize("command", [["run", "app.py"], ["doctor"]])
def test_an_install_that_is_only_on_pythonpath_is_told_that_it_does_not_start(
    tmp_path: Path, command: list[str]
) -> None:
    """As of ``pip install --target``: Python reads no .pth there, and all would seem well."""
    root = Path(__file__).parents[2]
    target = tmp_path / "target"
    for name in ("glshim", "stylers", "demo_apps", "glshim.pth", "_glshim_start.py"):
        target.mkdir(exist_ok=True)
        (target / name).symlink_to(root / name)
    (tmp_path / "app.py").write_text("open('started', 'w')")
    bare = tmp_path / "bare"
    venv.create(bare)
    packages = [path for path in sys.path if path.endswith("site-packages")]
    environ = {**os.environ, "PYTHONPATH": os.pathsep.join([str(target), *packages])}
    done = subprocess.run(
        [str(bare / "bin" / "python"), "-m", "glshim", *command], cwd=tmp_path, env=environ,
        capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == (2 if command[0] == "run" else 1)
    told = done.stderr if command[0] == "run" else done.stdout
    assert f"glshim is in {target}, which is on PYTHONPATH: Python reads no .pth files" in told
    assert not (tmp_path / "started").exists()


def test_styles_lists_every_style_with_its_options() -> None:
    done = glshim("styles", "--long")
    assert done.returncode == 0
    for word in ("none:", "raskar:", "ridge_angle", "0..360 degrees", "#rrggbb", "anime: "):
        assert word in done.stdout
    assert glshim("styles", "rasker").returncode == 2


def test_doctor_finds_the_context_and_the_toolkits() -> None:
    done = glshim("doctor")
    assert done.returncode == 0, done.stdout
    for word in ("renderer", "compatibility", "glutSwapBuffers", "start-up file", "lines "):
        assert word in done.stdout


def test_doctor_says_so_where_no_window_opens() -> None:
    environ = {name: text for name, text in os.environ.items() if name != "DISPLAY"}
    done = glshim("doctor", environ={**environ, "GLSHIM_FRAMES": "none"})
    assert done.returncode == 1
    assert "cannot open a window" in done.stdout
    assert "GLSHIM_FRAMES: 'none' is not a valid frame count" in done.stdout


def test_doctor_measures_the_startup_cost() -> None:
    done = glshim("doctor", "--startup-cost")
    assert done.returncode == 0
    assert "glshim modules imported           nothing" in done.stdout


@pytest.mark.parametrize(
    ("command", "environ", "keys"),
    [
        (["view"], {}, "on"),
        (["view", "--keys", "off"], {}, "off"),
        (["view"], {"GLSHIM_KEYS": "cycle=F5"}, "cycle=F5"),
        (["run", "app.py"], {}, None),
        (["run", "--keys", "cycle=F5", "app.py"], {}, "cycle=F5"),
    ],
)
def test_keys_are_on_in_the_viewer_and_elsewhere_when_asked_for(
    command: list[str], environ: dict[str, str], keys: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run(program: list[str], variables: Mapping[str, str], *, headless: bool) -> int:
        assert ({**os.environ, **variables}).get("GLSHIM_KEYS") == keys
        return 7

    for name, text in environ.items():
        monkeypatch.setenv(name, text)
    monkeypatch.setattr(launch, "run", run)
    assert cli.main(command) == 7
