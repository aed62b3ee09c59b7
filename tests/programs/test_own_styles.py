"""Styles of one's own on programs that know nothing of them: the page's styler, and style files
and stylers that are saved while a program runs."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from .harness import ROOT

PAGE = ROOT / "docs" / "guide" / "writing_a_styler.md"
APP = """
import time
import glfw
from OpenGL.GL import *
glfw.init()
window = glfw.create_window(120, 120, "app", None, None)
glfw.make_context_current(window)
glEnable(GL_DEPTH_TEST)
glClearColor(1, 1, 1, 1)
name = glGenLists(1)
glNewList(name, GL_COMPILE)
glBegin(GL_QUADS)
glColor3f(0.8, 0.8, 0.8)
for corner in ((-0.6, -0.6), (0.6, -0.6), (0.6, 0.6), (-0.6, 0.6)):
    glVertex2f(*corner)
glEnd()
glEndList()
while True:
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glCallList(name)
    glfw.swap_buffers(window)
    glfw.poll_events()
    time.sleep(0.02)
"""


def environment(display: str, **variables: str) -> dict[str, str]:
    plain = {key: text for key, text in os.environ.items() if not key.startswith("GLSHIM")}
    return plain | {"DISPLAY": display, "PYTHONPATH": str(ROOT), **variables}


def pixels(path: Path) -> np.ndarray:
    return np.asarray(Image.open(path).convert("RGB")).astype(int)


def of_the_page(folder: Path) -> str:
    (folder / "my_style.py").write_text(PAGE.read_text().split("```python\n")[1].split("```")[0])
    return str(folder / "my_style.py:Glow")


def test_the_styler_of_the_page_is_twenty_lines_or_so_and_works_when_pasted(
    tmp_path: Path, display: str
) -> None:
    style = of_the_page(tmp_path)
    lines = (tmp_path / "my_style.py").read_text().splitlines()
    assert sum(bool(line.strip()) for line in lines) <= 25
    shown = {}
    for name, text in (("plain", "none"), ("blue", style), ("red", f"{style}:ink=#ff0000")):
        subprocess.run(
            [sys.executable, "-m", "demo_apps.viewer", "torus"], cwd=ROOT, check=True, timeout=60,
            env=environment(display, GLSHIM_STYLE=text, GLSHIM_FRAMES="2",
                            GLSHIM_CAPTURE=str(tmp_path / f"{name}.png")),
        )  # fmt: skip
        shown[name] = pixels(tmp_path / f"{name}.png")
    plain = shown["plain"]
    torus = (plain != plain[0, 0]).any(axis=2)
    inside = np.zeros_like(torus)
    inside[3:-3, 3:-3] = torus[3:-3, 3:-3]
    for name, channel in (("blue", 2), ("red", 0)):
        gained = shown[name] - plain
        assert not gained[~torus].any()
        # Rims turn to the ink's colour, what faces the viewer stays.
        strong = gained[..., channel] > 60
        assert 0.03 < strong.sum() / torus.sum() < 0.6
        assert (np.abs(gained[torus]).max(axis=1) < 20).mean() > 0.1
        others = [c for c in (0, 2) if c != channel]
        assert gained[strong][:, channel].mean() > gained[strong][:, others].mean() + 60


def test_the_pages_styler_with_borrowed_media_draws_when_pasted(
    tmp_path: Path, display: str
) -> None:
    (tmp_path / "draft.py").write_text(PAGE.read_text().split("```python\n")[2].split("```")[0])
    shown = {}
    for name, text in (("plain", "none"), ("drawn", f"{tmp_path / 'draft.py'}:Draft:strokes=2")):
        done = subprocess.run(
            [sys.executable, "-m", "demo_apps.viewer", "torus"], cwd=ROOT, check=True, timeout=60,
            env=environment(display, GLSHIM_STYLE=text, GLSHIM_FRAMES="2",
                            GLSHIM_CAPTURE=str(tmp_path / f"{name}.png")),
            capture_output=True, text=True,
        )  # fmt: skip
        assert "glshim" not in done.stderr
        shown[name] = pixels(tmp_path / f"{name}.png")
    darker = (shown["plain"] - shown["drawn"]).max(axis=2)
    assert 0.002 < (darker > 60).mean() < 0.2


class Running:
    """A program under a style, its last frame, and what is said meanwhile."""

    def __init__(self, folder: Path, display: str, style: str) -> None:
        (folder / "app.py").write_text(APP)
        self.picture, self.errors = folder / "frame.png", folder / "errors.txt"
        with self.errors.open("w") as stream:
            self.process = subprocess.Popen(
                [sys.executable, "app.py"], cwd=folder, stderr=stream,
                env=environment(display, GLSHIM_STYLE=style, GLSHIM_CAPTURE=str(self.picture)),
            )  # fmt: skip

    def until(self, true: Callable[[], bool], what: str) -> None:
        end = time.monotonic() + 30.0
        while time.monotonic() < end:
            assert self.process.poll() is None, self.errors.read_text()
            try:
                if true():
                    return
            except (OSError, SyntaxError, ValueError):  # a picture that is being written
                pass
            time.sleep(0.05)
        raise AssertionError(f"{what} within 30 s; {self.errors.read_text()}")

    def shows(self, colour: tuple[int, int, int]) -> Callable[[], bool]:
        """Whether the square has lines of about that colour."""

        def found() -> bool:
            near = np.abs(pixels(self.picture) - np.array(colour)).max(axis=2) < 60
            return bool(near.sum() > 100)

        return found

    def said(self) -> list[str]:
        return self.errors.read_text().splitlines()


@pytest.fixture
def run(tmp_path: Path, display: str) -> Iterator[Callable[[str], Running]]:
    started: list[Running] = []

    def begin(style: str) -> Running:
        started.append(Running(tmp_path, display, style))
        return started[-1]

    yield begin
    for running in started:
        running.process.terminate()
        running.process.wait()


RED, BLUE, GREEN = (255, 0, 0), (0, 0, 255), (0, 255, 0)


def test_a_style_file_that_is_saved_is_taken_up_by_a_running_program(
    tmp_path: Path, run: Callable[[str], Running]
) -> None:
    mine = tmp_path / "mine.toml"
    mine.write_text('style = "raskar"\nink = "#ff0000"\nsilhouette_width = 6')
    app = run("mine.toml")
    app.until(app.shows(RED), "red lines")
    mine.write_text('style = "raskar"\nink = "#0000fX"\nsilhouette_width = 6')
    app.until(lambda: len(app.said()) == 1, "a line about the broken file")
    assert "mine.toml:2: ink=#0000fX is not allowed" in app.said()[0]
    assert app.said()[0].endswith("the last good style stays")
    app.until(app.shows(RED), "red lines still")
    mine.write_text('extends = "raskar"\nink = "#0000ff"\n[silhouette]\nwidth = 6')
    app.until(app.shows(BLUE), "blue lines")
    assert app.said()[1:] == [f"glshim: {mine} is valid again; reloaded"]


def test_a_file_that_was_broken_at_the_start_styles_lists_made_before(
    tmp_path: Path, run: Callable[[str], Running]
) -> None:
    mine = tmp_path / "mine.toml"
    mine.write_text('style = "rasker"')
    app = run("mine.toml")
    app.until(app.picture.exists, "a frame")
    assert "mine.toml:1: no style is called 'rasker'" in app.said()[0]
    mine.write_text('style = "raskar"\nink = "#0000ff"\nsilhouette_width = 6')
    app.until(app.shows(BLUE), "blue lines")


FLAT = """
from dataclasses import dataclass
from typing import ClassVar
from glshim import Layer, MeshShader, Pass, State, Styler
FLAT = MeshShader("flat", "void main() { gl_Position = clip(position(gl_VertexID)); }",
                  "void main() { colour = vec4(COLOUR, 1.0); }")

@dataclass(frozen=True)
class Flat(Styler):
    name: ClassVar[str] = "flat"
    def draws(self, layer: Layer) -> list[Pass]:
        return [Pass(layer.bodies, FLAT, "surface", state=State(offset=(-1.0, -2.0)))]
"""


def test_a_styler_that_fails_is_switched_off_and_back_on_when_it_is_mended(
    tmp_path: Path, run: Callable[[str], Running]
) -> None:
    path = tmp_path / "flat.py"
    path.write_text(FLAT.replace("COLOUR", "1.0, 0.0, 0.0"))
    app = run("flat.py:Flat")
    app.until(app.shows(RED), "a red square")
    path.write_text(FLAT.replace("COLOUR", "0.0, 1.0, 0.0").replace("return [", "1 / 0; return ["))
    app.until(lambda: any("ZeroDivisionError" in line for line in app.said()), "the fault")
    assert any(f'File "{path}", line 12' in line for line in app.said())
    path.write_text(FLAT.replace("COLOUR", "0.0, 0.0, 1.0"))
    app.until(app.shows(BLUE), "a blue square")
    path.write_text(FLAT.replace("COLOUR", "0.0, 1.0, 0.0").replace("def draws", "def draws("))
    app.until(lambda: app.said()[-1].endswith("the last good style stays"), "the syntax error")
    assert f"{path}:11: " in app.said()[-1]
    path.write_text(FLAT.replace("COLOUR", "0.0, 1.0, 0.0"))
    app.until(app.shows(GREEN), "a green square")
