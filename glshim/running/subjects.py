"""What `glshim gallery` and `glshim shot` are asked to show: a script, a module or a model."""

from __future__ import annotations

import argparse
import importlib.util
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from glshim.errors import EnvironmentFault, StyleError
from glshim.running import stillness
from glshim.running.environment import parse_frames
from glshim.running.startup import DISPLAYLESS
from glshim.styling import texts

VIEWER = "glshim_demos.viewer"
"""`demo_apps/viewer`, under the name by which it is installed."""
_SHAPES = "glshim_demos.shapes"
_MODELS = (".obj", ".ply", ".stl", ".gltf", ".glb")


@dataclass(frozen=True, slots=True)
class Subject:
    """A program to start."""

    title: str
    """For people."""
    command: tuple[str, ...]
    """What follows ``python`` on a command line."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments that name a subject. Options may stand anywhere; those of the program's own
    come after ``--``."""
    parser.add_argument("-m", dest="module", metavar="MODULE", help="run a module")
    parser.add_argument(
        "subject", nargs="*", metavar="SCRIPT | MODEL",
        help="a script, or a model (an OBJ, PLY, STL or glTF file, or a built-in shape), then its "
        "arguments; put -- before arguments that begin with a dash",
    )  # fmt: skip
    parser.add_argument(
        "--frame", default="3", metavar="N", help="number of the frame (default: %(default)s)"
    )


def subject_of(asked: argparse.Namespace) -> Subject:
    """The subject of parsed arguments. Raises `EnvironmentFault` when there is no such thing."""
    if asked.module is not None:
        return Subject(asked.module, ("-m", asked.module, *asked.subject))
    if not asked.subject:
        raise EnvironmentFault("nothing to show: give a script, -m MODULE or a model")
    name, *arguments = asked.subject
    path = Path(name)
    if path.suffix.lower() in _MODELS or (name in _shapes() and not path.exists()):
        if path.suffix and not path.is_file():
            raise EnvironmentFault(f"no such model file: {name}")
        if importlib.util.find_spec(VIEWER.partition(".")[0]) is None:
            raise EnvironmentFault(f"showing models needs {VIEWER}, which is not installed")
        return Subject(path.name, ("-m", VIEWER, "--wait", name, *arguments))
    if not path.exists():
        raise EnvironmentFault(
            f"no file or built-in shape is named {name}; shapes: {', '.join(_shapes())}"
        )
    return Subject(path.name, (name, *arguments))


def frame_of(asked: argparse.Namespace) -> int:
    """The number of the frame asked for, from 1. Raises `StyleError`."""
    return parse_frames(asked.frame)


def style_variable(text: str) -> str:
    """A style's text, checked, as `GLSHIM_STYLE` takes it from any folder. Raises `StyleError`."""
    if not text.strip():
        raise StyleError("the style is empty: see glshim styles")
    texts.parse_style(text)
    return texts.anchored(text, os.getcwd())


def surroundings(environ: Mapping[str, str]) -> dict[str, str]:
    """An environment on a virtual screen, or without one, for a run whose picture can be compared
    with others': clocks and luck stand still, toolkits take that screen and make no sound."""
    screen = {} if DISPLAYLESS in environ else {"QT_QPA_PLATFORM": "xcb", "SDL_VIDEODRIVER": "x11"}
    return {
        **{name: text for name, text in environ.items() if not name.startswith("GLSHIM_")},
        stillness.VARIABLE: "1",
        "PYTHONHASHSEED": "0",
        **screen,
        "SDL_AUDIODRIVER": "dummy",
        "PYGAME_HIDE_SUPPORT_PROMPT": "1",
    }


def _shapes() -> tuple[str, ...]:
    try:
        from importlib import import_module

        return tuple(import_module(_SHAPES).SHAPES)
    except ImportError:
        return ()
