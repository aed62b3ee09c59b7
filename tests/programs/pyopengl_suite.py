"""`python -m tests.programs.pyopengl_suite`: PyOpenGL's own tests, plain and under the shim.

They come with PyOpenGL's source distribution and are run unmodified, each module in a process of
its own. Whatever comes out plain, passed or failed, must come out under every style.
"""

import argparse
import fnmatch
import os
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

from glshim.errors import EnvironmentFault
from glshim.running.headless import virtual_screen

from .harness import ROOT
from .sources import SourceMissing, unpacked

STYLES = ("none", "raskar")
UNSTEADY = frozenset({"test_sf_2980896", "test_test_glgetfloat_leak"})
"""They weigh the process to the byte: two plain runs differ."""
Outcomes = dict[str, str]
"""By the name of the test: passed, failed, error, skipped; or why there are none."""


def modules() -> list[str]:
    """The test modules that run here. Raises `SourceMissing` when they cannot be fetched."""
    unpacked("psutil")
    return sorted(path.stem for path in (unpacked("PyOpenGL") / "tests").glob("test_*.py"))


def shimmed() -> bool:
    """Whether the variable puts glshim to work in a program of this interpreter's."""
    look = "import sys, OpenGL.GL; sys.exit('glshim.pipeline' not in sys.modules)"
    done = subprocess.run([sys.executable, "-c", look], env={**os.environ, "GLSHIM_STYLE": "none"},
                          cwd=tempfile.gettempdir(), capture_output=True, check=False)
    return done.returncode == 0


def outcomes(module: str, style: str | None, display: str, limit: float = 120.0) -> Outcomes:
    """Run one module under a style, None for plain."""
    kept = {k: v for k, v in os.environ.items() if not k.startswith("GLSHIM")}
    kept |= {"DISPLAY": display, "SDL_AUDIODRIVER": "dummy", "PYTHONDONTWRITEBYTECODE": "1",
             "PYTHONPATH": os.pathsep.join(map(str, (ROOT, unpacked("psutil"))))}
    if style is not None:
        kept["GLSHIM_STYLE"] = style
    with tempfile.TemporaryDirectory() as scratch:
        report = Path(scratch) / "report.xml"
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider",
                   f"--rootdir={scratch}", f"--junitxml={report}", f"{module}.py"]
        try:
            done = subprocess.run(
                command, cwd=unpacked("PyOpenGL") / "tests", env=kept, timeout=limit,
                stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        except subprocess.TimeoutExpired:
            return {"the module": f"not done after {limit:.0f} s"}
        if not report.exists():
            return {"the module": f"ended with status {done.returncode}"}
        return {case.get("name", ""): _outcome(case)
                for case in ElementTree.parse(report).iter("testcase")}


def _outcome(case: ElementTree.Element) -> str:
    words = {"failure": "failed", "error": "error", "skipped": "skipped"}
    return next((word for tag, word in words.items() if case.find(tag) is not None), "passed")


def differences(plain: Outcomes, styled: Outcomes) -> list[str]:
    """The steady tests that came out otherwise, in words."""
    return [f"{name}: plain {plain.get(name, 'absent')}, styled {styled.get(name, 'absent')}"
            for name in sorted((plain.keys() | styled.keys()) - UNSTEADY)
            if plain.get(name) != styled.get(name)]


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="python -m tests.programs.pyopengl_suite", description=__doc__)
    parser.add_argument("--only", default="*", metavar="PATTERN", help="modules to run, a glob")
    choice = parser.parse_args()
    if not shimmed():
        print("glshim is not installed for this Python", file=sys.stderr)
        return 2
    print("| module | plain | " + " | ".join(STYLES) + " |\n|---|---|" + "---|" * len(STYLES))
    found = []
    try:
        with virtual_screen() as screen:
            for module in fnmatch.filter(modules(), f"*{choice.only}*"):
                plain = outcomes(module, None, screen["DISPLAY"])
                cells = [_counts(plain)]
                for style in STYLES:
                    styled = outcomes(module, style, screen["DISPLAY"])
                    cells.append(_counts(styled))
                    found += [f"{style}: {module}: {line}" for line in differences(plain, styled)]
                print(f"| {module} | " + " | ".join(cells) + " |", flush=True)
    except (EnvironmentFault, SourceMissing) as reason:
        print(reason, file=sys.stderr)
        return 2
    print("\n".join(found) or "everything comes out as it does plain")
    return 1 if found else 0


def _counts(result: Outcomes) -> str:
    return ", ".join(f"{n} {word}" for word, n in sorted(Counter(result.values()).items())) or "-"


if __name__ == "__main__":
    sys.exit(main())
