"""What GL a window gets here, as JSON: ``python -m glshim.running.probe``.

In a process of its own, since a broken display or driver can take a process down.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import asdict, dataclass

from glshim.driver.ask import integer, text
from glshim.driver.context import MODERN, shortcoming
from glshim.errors import EnvironmentFault
from glshim.running import headless
from glshim.spec.constants import (
    GL_CONTEXT_PROFILE_MASK,
    GL_DEPTH_BITS,
    GL_RENDERER,
    GL_SAMPLES,
    GL_SHADING_LANGUAGE_VERSION,
    GL_VENDOR,
    GL_VERSION,
)

_SECONDS = 60


@dataclass(frozen=True, slots=True)
class Probe:
    """A default window's context, the one that GLUT, glfw and pygame ask for."""

    vendor: str
    renderer: str
    version: str
    glsl: str
    samples: int
    depth_bits: int
    profile_mask: int
    """0 below OpenGL 3.2; 1 core, 2 compatibility."""
    shortcoming: str
    """Why no lines can be drawn; empty when they can."""

    @property
    def number(self) -> tuple[int, int]:
        """The version as numbers."""
        major, _, minor = self.version.split()[0].partition(".")
        return int(major), int(minor.split(".")[0])

    @property
    def expands_on_gpu(self) -> bool:
        """Whether its GPU, not the CPU, makes strokes of lines."""
        return self.number >= MODERN

    @property
    def profile(self) -> str:
        """In words."""
        if self.number < (3, 2):
            return "none before OpenGL 3.2: fixed function"
        return "core: no fixed function" if self.profile_mask & 1 else "compatibility"


def ask(environ: Mapping[str, str]) -> Probe:
    """The context that a window gets in this environment, whatever its GLSHIM_* variables. Raises
    `EnvironmentFault`."""
    plain = {name: value for name, value in environ.items() if not name.startswith("GLSHIM_")}
    command = [sys.executable, "-m", __name__]
    try:
        done = subprocess.run(
            command, env=plain, capture_output=True, text=True, timeout=_SECONDS, check=False
        )
    except subprocess.TimeoutExpired as error:
        raise EnvironmentFault(f"the display did not answer within {_SECONDS} s") from error
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines()
        raise EnvironmentFault(
            lines[-1] if lines else f"the test program crashed (status {done.returncode})"
        )
    return Probe(**json.loads(done.stdout))


def probe() -> Probe:
    """Open a hidden window and ask. Raises `OSError` where there is none to be had."""
    import glfw

    headless.prepare()
    glfw.ERROR_REPORTING = "ignore"
    if not glfw.init():
        raise OSError("there is no display")
    try:
        glfw.window_hint(glfw.VISIBLE, glfw.FALSE)
        window = glfw.create_window(64, 64, "glshim doctor", None, None)
        if not window:
            raise OSError("the display cannot open an OpenGL window")
        glfw.make_context_current(window)
        return Probe(
            vendor=text(GL_VENDOR),
            renderer=text(GL_RENDERER),
            version=text(GL_VERSION),
            glsl=text(GL_SHADING_LANGUAGE_VERSION),
            samples=integer(GL_SAMPLES),
            depth_bits=integer(GL_DEPTH_BITS),
            profile_mask=integer(GL_CONTEXT_PROFILE_MASK),
            shortcoming=shortcoming(),
        )
    finally:
        glfw.terminate()


if __name__ == "__main__":
    try:
        print(json.dumps(asdict(probe())))
    except (OSError, ImportError) as error:
        sys.exit(str(error))
