"""`python -m tests.matrix`: contract and differential tests on each combination of versions.

Each combination gets a virtual environment of its own, kept in the cache of the tests
(`GLSHIM_TEST_CACHE`). Pythons are looked for on PATH and among pyenv's; what is not there is named
in the table and does not count as a failure.

    python -m tests.matrix                    every combination
    python -m tests.matrix --only 3.12        those whose name has it
    python -m tests.matrix --ends             the oldest and the newest that can be had here
    python -m tests.matrix --share 6          one test in six, in turn day by day
    python -m tests.matrix -- tests/unit -x   other arguments for pytest
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

from tests.programs.harness import ROOT
from tests.programs.sources import cache_folder

from .combinations import COMBINATIONS, NEWEST, OLDEST, Combination

TESTS = ("tests/contract", "tests/differential")
TOOLS = ("pytest", "pytest-xdist", "hypothesis", "trimesh", "setuptools>=77")
GAME = "pygame-ce"
"""Has wheels for every Python; it is imported as pygame."""


def interpreters() -> dict[str, Path]:
    """Pythons that can be had here, by major and minor version."""
    found: dict[str, Path] = {}
    folders = [Path(folder) for folder in os.environ.get("PATH", "").split(os.pathsep) if folder]
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    folders += sorted(pyenv.glob("3.*/bin"))
    folders.append(Path(sys.executable).parent)
    for folder in folders:
        for path in folder.glob("python3.*"):
            version = re.fullmatch(r"python(3\.\d+)", path.name)
            if version and version[1] not in found and _makes_environments(path):
                found[version[1]] = path
    return found


def _makes_environments(python: Path) -> bool:
    """Whether it starts, and has what a virtual environment needs."""
    done = subprocess.run([python, "-c", "import ensurepip, ctypes, ssl"], capture_output=True,
                          check=False)
    return done.returncode == 0


def environment(combination: Combination, python: Path) -> Path:
    """The interpreter of the combination's virtual environment, made when it is not there yet."""
    folder = cache_folder() / "matrix" / combination.name
    inside = folder / "bin" / "python"
    if not (folder / "made").exists():
        shutil.rmtree(folder, ignore_errors=True)
        _run([python, "-m", "venv", folder])
        _install(inside, "--only-binary", ":all:", *combination.requirements(), *TOOLS, GAME)
        _link_glut(folder)
        (folder / "made").touch()
    _install(inside, "--no-deps", "--no-build-isolation", "-e", str(ROOT))
    return inside


def _link_glut(folder: Path) -> None:
    """Give freeglut the name that PyOpenGL 3.1.6 looks for: one digit after `.so`."""
    folder = folder / "libraries"
    folder.mkdir()
    there = subprocess.run(["ldconfig", "-p"], capture_output=True, text=True, check=False,
                           env=os.environ | {"PATH": os.environ["PATH"] + ":/sbin:/usr/sbin"})
    found = re.search(r"libglut\.so\.3\S* \(.*=> (\S+)", there.stdout)
    if found:
        (folder / "libglut.so.3").symlink_to(found[1])


def _install(python: Path, *what: str) -> None:
    _run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *what])


def _run(command: list[str | Path]) -> None:
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode:
        lines = [line for line in done.stderr.splitlines() if line.strip()]
        raise LookupError(lines[-1] if lines else f"{command} failed")


def versions(python: Path) -> str:
    """What the environment really holds."""
    look = (
        "import sys, importlib.metadata as m\n"
        "def of(n):\n"
        "    try: return m.version(n)\n"
        "    except m.PackageNotFoundError: return '-'\n"
        "print('%d.%d.%d' % sys.version_info[:3], *map(of, ('PyOpenGL', 'PyOpenGL-accelerate',"
        " 'numpy', 'moderngl')))"
    )
    return subprocess.run([python, "-c", look], capture_output=True, text=True, check=True).stdout


def passes(python: Path, arguments: list[str], share: int) -> tuple[bool, str]:
    """Run pytest there: whether all passed, and its last line."""
    kept = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    kept["TESTS_SHARE"] = str(share)
    kept["LD_LIBRARY_PATH"] = str(python.parents[1] / "libraries")
    done = subprocess.run([python, "-m", "pytest", "-q", "-n", "auto", "--dist", "loadfile",
                           "-p", "no:cacheprovider", *arguments],
                          cwd=ROOT, env=kept, capture_output=True, text=True, check=False)
    lines = done.stdout.strip().splitlines() or done.stderr.strip().splitlines() or ["nothing"]
    for line in lines:
        if line.startswith(("FAILED", "ERROR")):
            print("   ", line, flush=True)
    return done.returncode == 0, lines[-1].strip("= ")


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.matrix", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", metavar="TEXT", help="combinations by name")
    parser.add_argument("--ends", action="store_true", help="the oldest and the newest alone")
    parser.add_argument("--share", type=int, default=1, metavar="N", help="one test in N")
    parser.add_argument("arguments", nargs="*", help="of pytest; by default " + " ".join(TESTS))
    choice = parser.parse_args()
    pythons = interpreters()
    newest = max(pythons, key=lambda version: [int(part) for part in version.split(".")])
    oldest = OLDEST if OLDEST.python in pythons else replace(OLDEST, python=newest, numpy="")
    rows = (oldest, replace(NEWEST, python=newest)) if choice.ends else COMBINATIONS
    failed = 0
    for combination in rows:
        if choice.only not in combination.name:
            continue
        if combination.python not in pythons:
            print(f"{combination.name}: no python{combination.python} here", flush=True)
            continue
        begun = time.monotonic()
        try:
            python = environment(combination, pythons[combination.python])
        except LookupError as reason:
            print(f"{combination.name}: cannot be had here: {reason}", flush=True)
            continue
        holds = versions(python).split()
        good, summary = passes(python, choice.arguments or list(TESTS), choice.share)
        failed += not good
        row = "{}: Python {}, PyOpenGL {}, accelerate {}, numpy {}, moderngl {}: {} ({:.0f} s)"
        print(row.format("passed" if good else "FAILED", *holds, summary,
                         time.monotonic() - begun), flush=True)
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
