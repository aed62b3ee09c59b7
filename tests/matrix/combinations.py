"""Which versions are tried together, as data."""

from __future__ import annotations

import re
from dataclasses import dataclass

from tests.programs.harness import ROOT


@dataclass(frozen=True)
class Combination:
    """Versions that one environment holds; an empty one is the newest that can be had."""

    python: str
    """Major and minor version, such as "3.10"."""
    pyopengl: str = ""
    numpy: str = ""
    accelerate: bool = False
    lowest: bool = False
    """Whether every other dependency is as old as pyproject.toml allows."""

    @property
    def name(self) -> str:
        """For folders and tables."""
        words = [f"python{self.python}", f"pyopengl{self.pyopengl or '-newest'}"]
        words += [f"numpy{self.numpy or '-newest'}"]
        words += ["accelerate"] * self.accelerate + ["lowest"] * self.lowest
        return "-".join(words)

    def requirements(self) -> list[str]:
        """What pip is asked for, glshim aside."""
        pins = {"PyOpenGL": self.pyopengl, "numpy": self.numpy}
        if self.accelerate:
            pins["PyOpenGL-accelerate"] = self.pyopengl
        if self.lowest:
            pins = lower_bounds() | {name: pin for name, pin in pins.items() if pin}
        else:
            pins = dict.fromkeys(lower_bounds(), "") | pins
        return [f"{name}=={pin}" if pin else name for name, pin in pins.items()]


def lower_bounds() -> dict[str, str]:
    """The oldest version of each dependency that pyproject.toml allows."""
    text = (ROOT / "pyproject.toml").read_text("utf-8")
    block = re.search(r"^dependencies = \[(.*?)^\]", text, re.DOTALL | re.MULTILINE)
    assert block
    return dict(re.findall(r'"([\w-]+)>=([\w.]+)"', block[1]))


OLDEST = Combination("3.10", "3.1.6", "1.26.4", lowest=True)
NEWEST = Combination("newest", accelerate=True)
COMBINATIONS = (
    OLDEST,
    Combination("3.10", "3.1.7", "1.26.4", accelerate=True),
    Combination("3.11", "3.1.6", "2.2.6"),
    Combination("3.11", "3.1.7", "1.26.4"),
    Combination("3.11", "3.1.9", "2.2.6", accelerate=True),
    Combination("3.12", "3.1.9", "1.26.4"),
    Combination("3.12", accelerate=True),
    Combination("3.13", "3.1.9", accelerate=True),
    Combination("3.13"),
    Combination("3.13", accelerate=True),
    Combination("3.14"),
    Combination("3.14", accelerate=True),
)
"""Every version of each occurs, and each neighbour of the oldest and the newest; not all pairs."""
