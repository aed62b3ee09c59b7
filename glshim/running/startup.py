"""Armed by the start-up file when a GLSHIM_* variable is set.

Nothing but the watch on imports is loaded until a toolkit or PyOpenGL comes, so that every other
Python program that inherits the variables pays next to nothing.
"""

import os

from glshim.bindings.imports import after_import

TYPE_CHECKING = False
if TYPE_CHECKING:
    from types import ModuleType

# Everything of PyOpenGL that makes GL functions imports this first. By now the app has chosen its
# flags (ERROR_CHECKING, ...), and the platform is known.
PYOPENGL = "OpenGL.error"
# Toolkits whose names an app may take before it imports PyOpenGL.
EARLY_TOOLKITS = ("glfw", "pygame.display")
KEYS = "GLSHIM_KEYS"

_armed = False
_folder = ""
"""Where the program was started: what the paths in the variables are relative to."""


def arm() -> None:
    """Take the frame ends of toolkits as they come, and begin when PyOpenGL comes.

    Once: `site` reads the start-up files of a virtual environment twice.
    """
    global _armed, _folder
    if _armed:
        return
    _armed = True
    _folder = os.getcwd()
    if "GLSHIM_STILL" in os.environ:  # before the program has looked at a clock
        from glshim.running import stillness

        stillness.begin()
    for toolkit in EARLY_TOOLKITS:
        after_import(toolkit, _watch_toolkits)
    after_import(PYOPENGL, _begin)


def _watch_toolkits(module: "ModuleType") -> None:
    from glshim.toolkits import frames

    frames.watch_toolkits()
    if KEYS in os.environ:  # windows that are made before PyOpenGL comes have keys, too
        from glshim.toolkits import keyboards

        keyboards.watch()


def _begin(module: "ModuleType") -> None:
    from glshim.running import session

    session.begin(_folder)
