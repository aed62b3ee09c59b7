"""Armed by the start-up file when a GLSHIM_* variable is set; cheap until PyOpenGL is imported."""

from __future__ import annotations

from types import ModuleType

from glshim.capture import frames
from glshim.capture.imports import after_import

# By now the app has chosen PyOpenGL's flags (ERROR_CHECKING, ...), and no GL function exists yet.
FIRST_MODULE = "OpenGL.platform"


_armed = False


def arm() -> None:
    """Take the frame ends of toolkits as they come, and begin when PyOpenGL comes.

    Once: `site` reads the start-up files of a virtual environment twice.
    """
    global _armed
    if _armed:
        return
    _armed = True
    frames.watch_toolkits()
    after_import(FIRST_MODULE, _begin)


def _begin(module: ModuleType) -> None:
    from glshim import session

    session.begin()
