"""A program as data: its steps, the flags of PyOpenGL it sets, the style it meets."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

FLAGS: dict[str, dict[str, Any]] = {
    "": {},
    "unchecked": {"ERROR_CHECKING": False},
    "on_copy": {"ERROR_ON_COPY": True},
    "unsized": {"ARRAY_SIZE_CHECKING": False},
    "context": {"CONTEXT_CHECKING": True},
    "logged": {"FULL_LOGGING": True},
    "logged_errors": {"ERROR_LOGGING": True},
    "scalars": {"ALLOW_NUMPY_SCALARS": True},
    "images": {"UNSIGNED_BYTE_IMAGES_AS_STRING": False},
    "packed": {"SIZE_1_ARRAY_UNPACK": False},
    "forward": {"FORWARD_COMPATIBLE_ONLY": True},
    "legacy": {"ERROR_CHECKING": False},
}
"""PyOpenGL's flags, set before it is imported, by a name of ours."""
ENVIRONMENTS: dict[str, dict[str, str]] = {
    "legacy": {"MESA_GL_VERSION_OVERRIDE": "2.1", "MESA_GLSL_VERSION_OVERRIDE": "120"},
}
"""And variables, by the same names."""


@dataclass(frozen=True)
class Program:
    """What is played."""

    seed: int
    number: int
    flags: str
    style: str
    """Beside ``none``, which every program meets."""
    steps: tuple[str, ...]

    def script(self, comment: str = "") -> str:
        """A Python program that plays it and prints what it sees."""
        lines = [f'"""Program {self.number} of seed {self.seed}.', ""]
        lines += [f"    {line}" for line in comment.splitlines()] + [""] * bool(comment)
        lines += [f"Run it plain, with GLSHIM_STYLE=none and with GLSHIM_STYLE={self.style},",
                  'from the root of the repository."""', "",
                  "import sys", "", "import OpenGL", ""]  # fmt: skip
        lines += [f"OpenGL.{name} = {value}" for name, value in FLAGS[self.flags].items()]
        lines += ['sys.path.insert(0, ".")', "from tests.fuzz.stage import play", ""]
        body = "\n".join(self.steps)
        quotes = "'''" if '"""' in body else '"""'
        return "\n".join([*lines, f"play(r{quotes}", body, f"{quotes})", ""])


def functions(step: str) -> tuple[str, ...]:
    """The functions that a step calls."""
    return tuple(dict.fromkeys(re.findall(r"\b(gl[A-Z]\w+|glu[A-Z]\w+)\(", step)))
