"""Armed by the start-up file when a GLSHIM_* variable is set.

Nothing but the watch on imports is loaded until a toolkit or PyOpenGL comes, so that every other
Python program that inherits the variables pays next to nothing.
"""

import os

from glshim.bindings.imports import after_import
from glshim.system.modules import OURS_ALONE, hide

TYPE_CHECKING = False
if TYPE_CHECKING:
    from types import ModuleType

# Everything of PyOpenGL that makes GL functions imports this first. By now the app has chosen its
# flags (ERROR_CHECKING, ...), and the platform is known.
PYOPENGL = "OpenGL.error"
KEYS = "GLSHIM_KEYS"
DISPLAYLESS = "_GLSHIM_DISPLAYLESS"
"""Set by us for programs that we start where there is no screen; never by people."""

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
    if DISPLAYLESS in os.environ:  # the first: others hook what it puts in place
        with OURS_ALONE:
            from glshim import toolkits

        toolkits.watch(toolkits.Part.DISPLAYLESS)
    if "GLSHIM_STILL" in os.environ:  # before the program has looked at a clock
        with OURS_ALONE:
            from glshim.running.stillness import begin

        begin()
    for package in _toolkit_files():
        after_import(package, _watch_toolkit)
    after_import(PYOPENGL, _begin)


def _toolkit_files() -> "list[str]":
    """The files in the toolkits' folder, most of which have the names of the packages they hook:
    an app may take names of those before it imports PyOpenGL."""
    folder = os.path.join(os.path.dirname(os.path.dirname(__file__)), "toolkits")
    return [name[:-3] for name in os.listdir(folder) if name.endswith(".py")]


def _watch_toolkit(module: "ModuleType") -> None:
    with OURS_ALONE:
        from glshim.toolkits import Part, watch_package

    parts = [Part.FRAMES]
    if KEYS in os.environ:  # windows that are made before PyOpenGL comes have keys, too
        parts.append(Part.KEYS)
    watch_package(module.__name__, *parts)
    hide()


def _begin(module: "ModuleType") -> None:
    with OURS_ALONE:
        from glshim.running.session import begin

    begin(_folder)
    hide()
