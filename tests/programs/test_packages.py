"""The source distribution and the wheel: they hold every file, and install and run in a clean
environment, which has what they say they need and nothing else."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import venv
from collections.abc import Iterator
from importlib.metadata import Distribution, distribution
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from packaging.requirements import Requirement
from PIL import Image

ROOT = Path(__file__).parents[2]
FOLDERS = {"glshim": "glshim", "stylers": "glshim_stylers", "demo_apps": "glshim_demos"}
NOT_SHIPPED = shutil.ignore_patterns(
    ".*", "__pycache__", "*.pyc", "*.egg-info", "build", "dist", "out", "venv"
)
HOOKS = "import sys; sys.path.insert(0, 'scripts'); import build_backend as hooks; "


def command(*words: str | Path, folder: Path, **variables: str) -> str:
    """What a command prints. It sees neither this repository nor variables of ours."""
    environ = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    done = subprocess.run(
        [str(word) for word in words], cwd=folder, env=environ | variables,
        capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def files(folder: Path) -> set[str]:
    """The files below a folder, relative to it."""
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


def requirements(lines: list[str]) -> Iterator[Distribution]:
    """The installed distributions that requirements name, and what those need."""
    for asked in map(Requirement, lines):
        if asked.marker is None or asked.marker.evaluate({"extra": ""}):
            found = distribution(asked.name)
            yield found
            yield from requirements(found.requires or [])


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Both distributions, made of a copy of the repository: the wheel of the unpacked sdist."""
    folder = tmp_path_factory.mktemp("packages")
    copy = folder / "repository"
    shutil.copytree(ROOT, copy, ignore=NOT_SHIPPED)
    command(sys.executable, "-c", f"{HOOKS} hooks.build_sdist({str(folder)!r})", folder=copy)
    (sdist,) = folder.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        archive.extractall(folder / "unpacked", filter="data")
    (unpacked,) = (folder / "unpacked").iterdir()
    command(sys.executable, "-c", f"{HOOKS} hooks.build_wheel({str(folder)!r})", folder=unpacked)
    (wheel,) = folder.glob("*.whl")
    return {"copy": copy, "sdist": sdist, "unpacked": unpacked, "wheel": wheel}


def clean_environment(folder: Path) -> Path:
    """The interpreter of an environment with glshim's requirements, those of its build and no
    others: links to what is installed here."""
    venv.create(folder, with_pip=False)
    python = folder / "bin" / "python"
    asked = "import sysconfig; print(sysconfig.get_path('purelib'))"
    there = Path(command(python, "-c", asked, folder=folder).strip())
    here = Path(sysconfig.get_path("purelib"))
    for found in requirements([*(distribution("glshim").requires or ()), "setuptools"]):
        for name in {path.parts[0] for path in found.files or () if path.parts[0] != ".."}:
            if not (there / name).exists() and not name.endswith(".pth"):
                (there / name).symlink_to(here / name)
    return python


def install(python: Path, package: Path) -> None:
    command(
        sys.executable, "-m", "pip", "--python", python, "install", "--quiet", "--no-deps",
        "--no-index", "--no-build-isolation", "--disable-pip-version-check", package,
        folder=python.parent,
    )  # fmt: skip


def installed(python: Path) -> set[str]:
    code = (
        "from importlib.metadata import files; "
        "print(*(file for file in files('glshim') if file.suffix != '.pyc' and "
        "not file.parts[0].endswith('.dist-info')), sep='\\n')"
    )
    return set(command(python, "-c", code, folder=python.parent).splitlines())


def picture(python: Path, path: Path) -> NDArray[np.uint8]:
    """A bundled program's, restyled with textures, light and paper, by the command that is
    installed beside an interpreter."""
    command(
        python.parent / "glshim", "shot", "-m", "glshim_demos.07_cad_part", "--style", "charcoal",
        "--frame", "1", "--scale", "1", "-o", path, folder=path.parent,
    )  # fmt: skip
    return np.asarray(Image.open(path))


def test_the_source_distribution_holds_the_repository(packages: dict[str, Path]) -> None:
    assert files(packages["copy"]) - files(packages["unpacked"]) == set()


def test_wheel_and_source_distribution_install_and_run(
    packages: dict[str, Path], tmp_path: Path
) -> None:
    python = clean_environment(tmp_path / "wheel")
    install(python, packages["wheel"])
    expected = {
        f"{package}/{name}"
        for folder, package in FOLDERS.items()
        for name in files(packages["copy"] / folder)
    }
    assert expected - installed(python) == set()
    assert {"glshim.pth", "glshim.start"} <= installed(python)

    from_source = clean_environment(tmp_path / "sdist")
    install(from_source, packages["sdist"])
    assert installed(from_source) == installed(python)

    drawn = picture(python, tmp_path / "wheel.png")
    assert len(np.unique(drawn)) > 100
    assert np.array_equal(drawn, picture(Path(sys.executable), tmp_path / "here.png"))
    line = command(python, "-c", "import glshim; print(glshim.__file__)", folder=tmp_path)
    assert line.startswith(str(tmp_path))
