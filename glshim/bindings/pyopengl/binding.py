"""PyOpenGL as a binding: its raw layer, the recorder, the hooks by role, and GLU, GLUT and GLE."""

from __future__ import annotations

from glshim.bindings.base import Binding, PrimitiveStream, Watcher
from glshim.bindings.pyopengl.clibraries import C_LIBRARIES
from glshim.bindings.pyopengl.names import NAMES
from glshim.bindings.pyopengl.raw import RAW
from glshim.bindings.pyopengl.recorder import RECORDER
from glshim.bindings.pyopengl.watch import WATCH


class PyOpenGL:
    """A `glshim.bindings.base.Binding`."""

    @property
    def installed(self) -> bool:
        return RAW.installed

    @property
    def stream(self) -> PrimitiveStream:
        return RECORDER.record

    def install(self) -> None:
        RAW.install()
        NAMES.install()
        RECORDER.install()
        WATCH.install()
        C_LIBRARIES.install()

    def uninstall(self) -> None:
        C_LIBRARIES.uninstall()
        WATCH.uninstall()
        RECORDER.uninstall()
        RAW.uninstall()

    def attach(self, watcher: Watcher) -> None:
        WATCH.attach(watcher)
        C_LIBRARIES.attach(watcher)

    def detach(self) -> None:
        C_LIBRARIES.detach()
        WATCH.detach()


PYOPENGL: Binding = PyOpenGL()
