"""How moderngl reaches the driver: one connection for all contexts of it.

What moderngl calls a context is the driver's functions and its limits, which contexts share. It is
not free to make another for each, and some of its memory stays (moderngl 5.13: 45 kB).
"""

from __future__ import annotations

import ctypes
from collections.abc import Iterable
from threading import get_ident
from typing import Any

import moderngl

from glshim.driver.ask import text
from glshim.driver.functions import address, gl, prototype
from glshim.driver.objects import function_for_ours
from glshim.spec.constants import GL_RENDERER, GL_VENDOR, GL_VERSION
from glshim.spec.signatures import deletes


class Connection:
    """Make it inside the state guard: by `connection`."""

    def __init__(self) -> None:
        self._forgetting = 0
        """The thread in which what moderngl deletes is gone already."""
        self._functions: list[Any] = []
        """Held for moderngl, which calls them."""
        store = getattr(moderngl, "_store", None)
        shared = getattr(store, "default_context", None)
        given: Any = self  # moderngl's stubs know no such object
        self.context: Any = moderngl.create_context(require=330, context=given)
        """Makes objects in whatever context is current."""
        if store is not None:  # an app's own moderngl.get_context() does not get ours
            store.default_context = shared

    def forget(self, made: Iterable[Any]) -> None:
        """Free what objects of moderngl's take on our side, whose context is gone. Calls no GL:
        their names may be those of objects in the context that is current."""
        self._forgetting = get_ident()
        try:
            for each in made:
                each.release()
        finally:
            self._forgetting = 0

    # -- for moderngl ----------------------------------------------------------------------------

    def load_opengl_function(self, name: str) -> int:
        """Its address, 0: there is none. Looked up as PyOpenGL does, whatever made the context (by
        itself moderngl looks for GLX alone once it has seen another). Names are of our choice."""
        own, place = function_for_ours(name), address(name)
        if place and deletes(name):
            delete = own or getattr(gl, name)

            def own(*arguments: Any) -> None:
                if self._forgetting != get_ident():
                    delete(*arguments)

        if not place or own is None:
            return place
        self._functions.append(prototype(name)(own))
        return ctypes.cast(self._functions[-1], ctypes.c_void_p).value or 0

    def __enter__(self) -> None: ...

    def __exit__(self, *_: object) -> None: ...

    def release(self) -> None:
        """Nothing is held."""


_connections: dict[tuple[object, ...], Connection] = {}


def connection() -> Connection:
    """To the driver of the current context. Inside the state guard."""
    driver = (*map(text, (GL_VENDOR, GL_RENDERER, GL_VERSION)), address("glCreateProgram"))
    found = _connections.get(driver)
    if found is None:
        found = _connections[driver] = Connection()
    return found
