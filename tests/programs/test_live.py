"""Live control of programs that know nothing of it, by key presses on a screen of their own."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageGrab

from .catalog import HERE
from .hand import ESCAPE, Hand
from .harness import ROOT
from .sources import LIBRARIES, TCL, SourceMissing, fetched

F1, SHIFT = 0xFFBE, 0xFFE1
SHIFT_ALONE = ("key", "key t", "key F112", "key LEFT SHIFT", "key Shift_L", "key LSHIFT")
"""What the programs make of a shift key, which nobody takes from them."""
TOOLKITS = ("glut", "glut deaf", "glfw", "glfw wait", "pygame", "pygame wait", "qt")
OTHERS = ("tk", "tk togl", "sdl2", "pyglet", "wx", "gtk 3", "gtk 4")
SOURCES = {
    "qt": ("PyQt5", "dxf2gcode"), "tk": ("pyopengltk",), "tk togl": ("Togl",),
    "sdl2": ("PySDL2",), "pyglet": ("pyglet",), "wx": ("wx",),
    "gtk": ("PyGObject",),
}  # fmt: skip
"""What brings the toolkits that are fetched."""


@pytest.fixture(scope="module")
def display(small_display: str) -> str:
    return small_display


_PATIENCE = 60.0
"""Seconds: the machine may be busy with other tests."""
_PRESSES = 8


class Program:
    """One that runs, and a hand at its keyboard."""

    def __init__(self, process: subprocess.Popen[str], hand: Hand, pictures: Path) -> None:
        self.process, self.hand, self.folder = process, hand, pictures
        self.said: list[str] = []
        for stream in (process.stdout, process.stderr):
            threading.Thread(target=self._read, args=(stream,), daemon=True).start()

    def _read(self, stream: object) -> None:
        for line in stream:  # type: ignore[attr-defined]
            self.said.append(line.rstrip())

    def press(self, number: int, shift: bool = False) -> None:
        """A function key, and time for two frames."""
        if shift:
            self.hand.hold(SHIFT, True)
        self.hand.press(F1 + number - 1)
        if shift:
            self.hand.hold(SHIFT, False)
        time.sleep(0.5)

    def saved(self, number: int = 11) -> tuple[str, np.ndarray]:
        """Press the key that saves: the name of the new file and its picture."""
        before, lines = set(self.folder.glob("*")), len(self.lines("glshim: saved"))
        self.press(number)
        self.wait(lambda: len(set(self.folder.glob("*"))) > len(before), "a picture")
        self.wait(lambda: len(self.lines("glshim: saved")) > lines, "a line that says so")
        (path,) = set(self.folder.glob("*")) - before
        return path.name, np.array(Image.open(path))

    def lines(self, start: str) -> list[str]:
        return [line for line in self.said if line.startswith(start)]

    def wait(self, happened: Callable[[], bool], what: str) -> None:
        limit = time.monotonic() + _PATIENCE
        while not happened():
            assert time.monotonic() < limit, f"no {what}: {self.said}"
            assert self.process.poll() is None, f"the program has ended: {self.said}"
            time.sleep(0.02)

    def end(self) -> None:
        """Press Escape, again where a busy screen has lost it, until the program has ended."""
        for _ in range(_PRESSES):
            self.hand.press(ESCAPE)
            with suppress(subprocess.TimeoutExpired):
                self.process.wait(5)
                break
        assert self.process.poll() is not None, f"the program does not end: {self.said}"
        time.sleep(0.1)


@contextmanager
def running(name: str, display: str, folder: Path, **variables: str) -> Iterator[Program]:
    app, *arguments = name.split()
    sources = SOURCES.get(name, SOURCES.get(app, ()))
    try:
        found = {source: fetched(source) for source in sources}
    except SourceMissing as reason:
        pytest.skip(str(reason))
    folders = {source: folder for source, folder in found.items() if folder is not None}
    paths = [str(ROOT), *map(str, folders.values())]
    libraries, tcl = (
        os.pathsep.join(str(folders[source] / places[source]) for source in folders
                        if source in places)
        for places in (LIBRARIES, TCL)
    )  # fmt: skip
    environ = {k: v for k, v in os.environ.items() if not k.startswith("GLSHIM")}
    environ |= {
        "DISPLAY": display, "PYTHONPATH": os.pathsep.join(paths), "LD_LIBRARY_PATH": libraries,
        "TCLLIBPATH": tcl,
        "QT_QPA_PLATFORM": "xcb", "SDL_AUDIODRIVER": "dummy", "SDL_VIDEO_WINDOW_POS": "0,0",
        "GLSHIM_STYLE": "none", "GLSHIM_SAVE": str(folder), **variables,
    }  # fmt: skip
    hand = Hand(display)
    hand.let_go()
    program_of = [str(HERE / "apps" / f"keys_{app}.py")] if app != "-m" else ["-m"]
    process = subprocess.Popen(
        [sys.executable, *program_of, *arguments],
        env=environ, cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip
    program = Program(process, hand, folder)
    try:
        program.wait(lambda: hand.windows() > 0, "window")
        hand.move(150, 120)
        time.sleep(1.0)
        yield program
    finally:
        process.kill()
        process.wait()


def screen(display: str) -> np.ndarray:
    """(H, W, 3) what is seen of a program of 320 x 240 pixels, perhaps with a border."""
    return np.array(ImageGrab.grab(xdisplay=display))[:250, :330]


def red_of(picture: np.ndarray) -> np.ndarray:
    """(H, W) where it has the ink's colour."""
    return (picture == (255, 0, 0)).all(axis=2)


@pytest.mark.parametrize("toolkit", TOOLKITS)
def test_keys_do_what_they_say_and_the_program_does_not_get_them(
    toolkit: str, display: str, tmp_path: Path
) -> None:
    styles = "raskar:ink=#ff0000;edge_mesh"
    with running(toolkit, display, tmp_path, GLSHIM_KEYS="on", GLSHIM_STYLES=styles) as program:
        app = f"glshim-keys_{toolkit.split(maxsplit=1)[0]}"
        name, plain = program.saved()
        assert name == f"{app}-none-001.png"
        program.press(9)
        program.wait(lambda: red_of(screen(display)).sum() > 300, "red ink without another event")
        shown = screen(display)
        name, inked = program.saved()
        assert name == f"{app}-raskar-001.png"
        red = red_of(inked)
        assert red_of(shown).sum() == red.sum()
        assert (inked[~red] == plain[~red]).all(axis=1).mean() > 0.9
        program.press(12)
        covers = lambda: (screen(display)[10:45, 10:150] != shown[10:45, 10:150])  # noqa: E731
        program.wait(lambda: bool(covers().any(axis=2).all()), "panel")
        covered = screen(display)
        name, again = program.saved()  # the panel, which is on the screen alone, is not in it
        assert name == f"{app}-raskar-002.png"
        assert np.array_equal(again, inked)
        assert np.array_equal(covered[120:], shown[120:])
        program.press(12)
        program.press(10)
        name, off = program.saved()
        assert name == f"{app}-off-001.png"
        assert np.array_equal(off, plain)
        program.press(10)
        assert np.array_equal(program.saved()[1], inked)
        program.press(9)
        name, other = program.saved()
        assert name == f"{app}-edge_mesh-001.png"
        assert not np.array_equal(other, inked)
        program.press(9, shift=True)
        assert program.saved()[0] == f"{app}-raskar-004.png"
        program.press(8)
        program.end()
        keys = [line for line in program.lines("key") if line not in SHIFT_ALONE]
        deaf = "deaf" in toolkit
        assert keys[:-1] == ([] if deaf else ["key F8"]), program.said
        assert keys, "the program's own key has not reached it"
        assert not [line for line in program.said if "Traceback" in line], program.said
        assert not program.lines("released")


@pytest.mark.parametrize("toolkit", OTHERS)
def test_keys_of_other_toolkits(toolkit: str, display: str, tmp_path: Path) -> None:
    """The same, in short: what is done is done by the same code for all."""
    styles = "raskar:ink=#ff0000;edge_mesh"
    with running(toolkit, display, tmp_path, GLSHIM_KEYS="on", GLSHIM_STYLES=styles) as program:
        app = f"glshim-keys_{toolkit.split(maxsplit=1)[0]}"
        if app.endswith("gtk"):  # whose window is there long before it is painted
            program.wait(lambda: bool(program.lines("painted")), "frame")
            time.sleep(1.0)
        program.press(9)
        program.wait(lambda: red_of(screen(display)).sum() > 300, "red ink without another event")
        name, inked = program.saved()
        assert name == f"{app}-raskar-001.png"
        assert red_of(screen(display)).sum() == red_of(inked).sum()
        program.press(9, shift=True)
        program.press(8)
        assert program.saved()[0] == f"{app}-edge_mesh-001.png"
        program.end()
        keys = [line for line in program.lines("key") if line not in SHIFT_ALONE]
        assert keys[:-1] == ["key F8"], program.said
        assert keys, "the program's own key has not reached it"
        assert not [line for line in program.said if "Traceback" in line], program.said
        assert not program.lines("released")


def test_a_key_that_the_user_names_goes_before_shortcuts_of_the_programs(
    display: str, tmp_path: Path
) -> None:
    """One of Qt's shortcuts lies on F9, by its number, which no code names."""
    with running("qt shortcut", display, tmp_path, GLSHIM_KEYS="on") as program:
        program.press(9)
        program.wait(lambda: bool(program.lines("key shortcut")), "shortcut")
        assert program.saved()[0] == "glshim-keys_qt-none-001.png"
        program.end()
    named = {"GLSHIM_KEYS": "cycle=F9", "GLSHIM_STYLES": "raskar"}
    with running("qt shortcut", display, tmp_path, **named) as program:
        program.press(9)
        assert program.saved()[0] == "glshim-keys_qt-raskar-001.png"
        assert not program.lines("key")
        program.end()


def test_the_viewer_speaks_of_our_keys_and_leaves_them_to_us(display: str, tmp_path: Path) -> None:
    styles = {"GLSHIM_KEYS": "on", "GLSHIM_STYLES": "raskar:ink=#ff0000"}
    with running("-m glshim_demos.viewer", display, tmp_path, **styles) as program:
        program.press(9)
        program.press(12)
        name, picture = program.saved()
        assert name == "glshim-gear-raskar-001.png"  # after the model
        assert red_of(picture).any()
        program.end()


def test_a_default_key_that_the_program_names_reaches_it(display: str, tmp_path: Path) -> None:
    with running("glfw own", display, tmp_path, GLSHIM_KEYS="on") as program:
        program.press(10)
        program.wait(lambda: program.lines("key") == ["key F10"], "key of its own")
        program.wait(lambda: len(program.lines("glshim: the program uses F10 itself")) == 1, "line")
        program.press(9)
        assert program.saved()[0].count("none") == 0
        assert program.lines("key") == ["key F10"]
        program.end()


@pytest.mark.parametrize("toolkit", ["glut", "glfw", "pygame", "qt"])
def test_with_keys_on_and_none_pressed_the_program_is_as_it_was(
    toolkit: str, display: str, tmp_path: Path
) -> None:
    """Its frames, to the byte, and what it says of the keys that are its own."""
    seen = []
    for keys in ("off", "on"):
        folder = tmp_path / keys
        folder.mkdir()
        capture = str(folder / "%03d.png")
        with running(toolkit, display, folder, GLSHIM_KEYS=keys, GLSHIM_CAPTURE=capture) as program:
            program.press(8)
            program.press(7)
            program.end()
            pictures = [np.array(Image.open(path)) for path in sorted(folder.glob("*.png"))]
        assert len(pictures) > 0
        assert all(np.array_equal(picture, pictures[0]) for picture in pictures)
        seen.append((pictures[0].tobytes(), program.lines("key"), program.lines("glshim")))
    assert seen[0] == seen[1]
    assert seen[0][1][:2] == ["key F8", "key F7"]
    assert seen[0][2] == []


def test_what_cannot_be_used_is_said_in_a_line(display: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    bad = {"GLSHIM_KEYS": "cycle=F99", "GLSHIM_STYLE": "raskar"}
    with running("glfw", display, tmp_path, **bad) as program:
        program.press(9)
        program.end()
        assert program.lines("glshim") == [
            "glshim: GLSHIM_KEYS: unknown key 'F99': did you mean F9?; live control is off"
        ]
        assert program.lines("key")[0] == "key F9"
    full = {"GLSHIM_KEYS": "on", "GLSHIM_SAVE": str(tmp_path / "file")}
    with running("glfw", display, tmp_path, **full) as program:
        program.press(11)
        program.wait(lambda: bool(program.lines("glshim: cannot save a picture in")), "line")
        program.end()
    wrong = {"GLSHIM_KEYS": "on", "GLSHIM_STYLE": "rascar", "GLSHIM_STYLES": "raskar"}
    with running("glfw", display, tmp_path, **wrong) as program:
        program.press(9)
        assert program.saved()[0] == "glshim-keys_glfw-raskar-001.png"
        program.end()
