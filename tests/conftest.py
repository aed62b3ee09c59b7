"""Every test sees a virtual screen of its own run, and no GLSHIM_* variable of the caller's."""

from __future__ import annotations

import os
from contextlib import ExitStack

import pytest

from glshim.running.headless import virtual_screen

_until_the_end = ExitStack()


def pytest_configure(config: pytest.Config) -> None:
    """Before any test module is imported, for those that look at DISPLAY then."""
    for name in [name for name in os.environ if name.startswith("GLSHIM_")]:
        del os.environ[name]
    os.environ.pop("WAYLAND_DISPLAY", None)
    os.environ.setdefault("SDL_AUDIODRIVER", "dummy")
    if not config.option.collectonly:
        os.environ.update(_until_the_end.enter_context(virtual_screen()))


def pytest_unconfigure(config: pytest.Config) -> None:
    """Stop the screen."""
    _until_the_end.close()
