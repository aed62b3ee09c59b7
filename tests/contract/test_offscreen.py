"""Frames that no toolkit shows: read back by the program, or finished, in windows that stay hidden,
by EGL and by OSMesa."""

from __future__ import annotations

import ctypes.util
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

pytestmark = pytest.mark.programs
APPS = Path(__file__).parents[1] / "programs" / "apps"

HIDDEN = """
import ctypes, glfw
glfw.init()
glfw.window_hint(glfw.VISIBLE, VISIBLE)
window = glfw.create_window(100, 80, "app", None, None)
glfw.make_context_current(window)
from OpenGL.GL import *
def target(samples):
    glBindFramebuffer(GL_FRAMEBUFFER, glGenFramebuffers(1))
    glBindRenderbuffer(GL_RENDERBUFFER, glGenRenderbuffers(1))
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, 100, 80)
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              glGetIntegerv(GL_RENDERBUFFER_BINDING))
def read(format=GL_RGB, kind=GL_UNSIGNED_BYTE, size=(100, 80)):
    return glReadPixels(0, 0, *size, format, kind)
def texture():
    name = glGenTextures(1)
    glBindTexture(GL_TEXTURE_2D, name)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 100, 80, 0, GL_RGBA, GL_UNSIGNED_BYTE, None)
    return name
BEFORE
drawn = 0
for frame in range(FRAMES):
    glClearColor((frame + 1) / 5, 0, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    EACH
    drawn += 1
print("drawn", drawn)
"""
RED_RISING = [((100, 80), (round(255 * n / 5), 0, 0)) for n in (1, 2, 3)]
TEXTURE = """
name = texture()
glBindFramebuffer(GL_FRAMEBUFFER, glGenFramebuffers(1))
glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0)
"""


def run(program: str, folder: Path, *arguments: str, **variables: str) -> tuple[int, str, str]:
    path = folder / "app.py"
    path.write_text(program)
    return start(path, folder, *arguments, **variables)


def start(path: Path, folder: Path, *arguments: str, **variables: str) -> tuple[int, str, str]:
    done = subprocess.run(
        [sys.executable, str(path), *arguments], cwd=folder, env={**os.environ, **variables},
        capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    return done.returncode, done.stdout, done.stderr


def pictures(folder: Path) -> list[np.ndarray]:
    return [np.array(Image.open(path)) for path in sorted(folder.glob("*.png"))]


def colours(folder: Path) -> list[tuple[tuple[int, int], tuple[int, ...]]]:
    """Size and the one colour of every picture, in order."""
    found = []
    for picture in pictures(folder):
        (colour,) = {tuple(map(int, pixel)) for pixel in picture.reshape(-1, 3)}
        found.append(((picture.shape[1], picture.shape[0]), colour))
    return found


def program(each: str, before: str = "", frames: int = 9, visible: bool = False) -> str:
    filled = HIDDEN.replace("VISIBLE, VISIBLE", f"VISIBLE, {visible}").replace("BEFORE", before)
    return filled.replace("EACH", each).replace("FRAMES", str(frames))


@pytest.mark.parametrize(
    ("each", "before"),
    [
        ("read(); read(GL_DEPTH_COMPONENT, GL_FLOAT); glFinish()", ""),
        ("read(GL_DEPTH_COMPONENT, GL_FLOAT); read()", ""),
        ("glFinish(); read()", "target(0)"),
        ("glFinish()", "target(4)"),
        ("glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE)", TEXTURE),
        ("read(size=(3, 3)); glReadPixels(0, 0, 100, 80, GL_RGBA, GL_FLOAT)", ""),
    ],
)
def test_a_picture_that_is_read_back_is_a_frame(tmp_path: Path, each: str, before: str) -> None:
    """Once, whatever else of it is read; the program ends as the next one is begun, or sooner."""
    status, said, faults = run(
        program(each, before), tmp_path, GLSHIM_FRAMES="3", GLSHIM_CAPTURE="%d.png")
    assert (status, said, faults) == (0, "", "")
    assert colours(tmp_path) == RED_RISING


def test_frames_that_are_shown_are_not_counted_twice(tmp_path: Path) -> None:
    each = "read(); print('read'); glfw.swap_buffers(window)"
    status, said, _ = run(
        program(each, visible=True), tmp_path, GLSHIM_FRAMES="3", GLSHIM_CAPTURE="%d.png")
    assert (status, said.split()) == (0, ["read"] * 3)
    assert colours(tmp_path) == RED_RISING


@pytest.mark.parametrize("each", ["read(size=(8, 8))", "read(GL_DEPTH_COMPONENT, GL_FLOAT)"])
def test_picking_is_no_frame_and_depth_no_picture(tmp_path: Path, each: str) -> None:
    status, said, _ = run(
        program(each, frames=4), tmp_path, GLSHIM_FRAMES="3", GLSHIM_CAPTURE="%d.png")
    assert (status, said) == (0, "drawn 4\n" if "size" in each else "")
    assert pictures(tmp_path) == []


def test_a_texture_that_was_loaded_is_no_picture(tmp_path: Path) -> None:
    before = "texture(); glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE)"
    status, said, _ = run(
        program("pass", before, 4), tmp_path, GLSHIM_FRAMES="1", GLSHIM_CAPTURE="%d.png")
    assert (status, said, pictures(tmp_path)) == (0, "drawn 4\n", [])


def test_the_one_picture_of_a_program_that_ends(tmp_path: Path) -> None:
    status, said, _ = run(
        program("read()", frames=1), tmp_path, GLSHIM_FRAMES="5", GLSHIM_CAPTURE="%d.png")
    assert (status, said) == (0, "drawn 1\n")
    assert colours(tmp_path) == RED_RISING[:1]


KINDS = {"EGL pbuffer": ("egl",), "EGL surfaceless": ("egl", "surfaceless"), "OSMesa": ("osmesa",)}


@pytest.mark.parametrize("kind", KINDS)
def test_contexts_without_a_window(tmp_path: Path, kind: str) -> None:
    """The program reads what plain OpenGL gives under `none`, and lines under a style."""
    app, *arguments = KINDS[kind]
    library = {"egl": "EGL", "osmesa": "OSMesa"}[app]
    if ctypes.util.find_library(library) is None:
        pytest.skip(f"there is no lib{library} here")
    path = APPS / f"{app}_pictures.py"
    status, plain, faults = start(path, tmp_path, "2", *arguments)
    assert status == 0, faults
    for style in ("none", "raskar:ink=#e8641b"):
        folder = tmp_path / style[:6]
        folder.mkdir()
        status, said, faults = start(
            path, folder, "9", *arguments,
            GLSHIM_STYLE=style, GLSHIM_FRAMES="3", GLSHIM_CAPTURE="%d.png")  # fmt: skip
        assert (status, faults) == (0, "")
        assert said.startswith("version")
        assert said.startswith(plain) is (style == "none")
    unstyled, styled = pictures(tmp_path / "none"), pictures(tmp_path / "raskar")
    assert [picture.shape for picture in unstyled] == [(200, 300, 3)] * 3
    changed = [int((a != b).any(2).sum()) for a, b in zip(unstyled, styled, strict=True)]
    assert min(changed) > 500
