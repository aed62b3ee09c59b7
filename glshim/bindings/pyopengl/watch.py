"""Hooks by role: what draws, clears, reads back or opens a list is told to a watcher.

With style ``none`` only the recorder's own needs are hooked; a styler that wants polygons adds the
rest. The watcher's faults never reach the app.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from glshim.bindings.base import Watcher
from glshim.bindings.pyopengl.raw import RAW, Call, Maker
from glshim.bindings.pyopengl.recorder import RECORDER
from glshim.driver import queries
from glshim.driver.arguments import are_ints
from glshim.driver.context import compiles_a_list
from glshim.spec.roles import (
    IN_LISTS,
    INSIDE,
    LIST_BRACKETS,
    LIST_CALLS,
    WATCHED,
    Role,
    role_of,
)
from glshim.system.interrupts import Held, is_ours

_RECORD = RECORDER.record
_SPILLING = INSIDE | LIST_BRACKETS | LIST_CALLS
"""Roles that what is recorded must not fall behind."""


class Watch:
    """The hooks by role. One instance: :data:`WATCH`."""

    def __init__(self) -> None:
        self._watcher: Watcher | None = None
        self._makers: dict[str, Maker] = {}

    def install(self) -> None:
        """The hooks that the recorder needs for itself."""
        RAW.hook_matching(self._own)

    def uninstall(self) -> None:
        """Undo :meth:`install` and :meth:`attach`."""
        self.detach()
        RAW.unhook_matching(self._own)

    def attach(self, watcher: Watcher) -> None:
        """Tell a watcher about every draw from now on."""
        RAW.unhook_matching(self._own)  # some of its names are the watcher's now
        self._watcher = _RECORD.sink = watcher
        RAW.hook_matching(self._watching)
        RAW.hook_matching(self._own)

    def detach(self) -> None:
        """Tell nobody any more."""
        if self._watcher is not None:
            self._follow_lists(False)
            RAW.unhook_matching(self._watching)
            RAW.unhook_matching(self._own)
            self._watcher = _RECORD.sink = None
            RAW.hook_matching(self._own)

    # -- makers, one per name, made when the name is first called -------------------------------

    def _own(self, name: str) -> Maker | None:
        role = role_of(name)
        if role is Role.QUERY_OPEN:
            return self._maker("own:" + name, lambda: _noting(queries.begin_seen))
        if role is Role.RENDER_MODE:
            return self._maker("own:" + name, lambda: _noting(_RECORD.render_mode_seen))
        if role not in _SPILLING or (self._watcher is not None and role in WATCHED):
            return None
        return self._maker("own:" + name, lambda: self._spilling(name, role))

    def _watching(self, name: str) -> Maker | None:
        role = role_of(name)
        if role in WATCHED:
            return self._maker(name, lambda: self._telling(name, role))
        return None

    def _in_lists(self, name: str) -> Maker | None:
        role = role_of(name)
        if role not in IN_LISTS:
            return None
        return self._maker(name, lambda: self._telling(name, role))

    def _maker(self, key: str, make: Callable[[], Maker]) -> Maker:
        if key not in self._makers:
            self._makers[key] = make()
        return self._makers[key]

    def _spilling(self, name: str, role: Role) -> Maker:
        opens, closes = role is Role.LIST_OPEN, role is Role.LIST_CLOSE
        attribute = role in INSIDE

        def maker(real: Call) -> Call:
            inside = _RECORD.inside

            def bracket(*args: Any, **named: Any) -> Any:
                if not are_ints(args):
                    return hook(*args, **named)
                with Held():
                    return hook(*args, **named)

            def hook(*args: Any, **named: Any) -> Any:
                if closes and _RECORD.list_open:
                    _RECORD.close_list()
                # In a list an attribute may belong to the primitive that calls it, or the next.
                if inside() or (attribute and _RECORD.list_open):
                    return self._inside(role, name, args, named, real)
                try:
                    return real(*args, **named)
                finally:
                    if opens and not _RECORD.list_open and compiles_a_list():
                        _RECORD.open_list(capturing=False)

            return bracket if opens or closes else hook

        return maker

    def _inside(
        self, role: Role, name: str, args: tuple[Any, ...], named: dict[str, Any], real: Call
    ) -> Any:
        """A call inside a primitive: what was recorded goes first, the rest straight through."""
        from OpenGL.error import GLError

        if role is Role.MATERIAL and self._watcher is not None:
            self._watcher.material_changes()
        _RECORD.spill()
        try:
            result = real(*args, **named)
        except GLError:
            if self._watcher is not None:
                self._watcher.inside(role, name, args, real)
            raise
        if self._watcher is not None:
            self._watcher.inside(role, name, args, real)
        return result

    def _telling(self, name: str, role: Role) -> Maker:
        if role in LIST_BRACKETS:
            return self._bracket(name, role)

        def maker(real: Call) -> Call:
            from OpenGL.error import GLError  # not before the app has set its flags

            inside = _RECORD.inside

            def hook(*args: Any, **named: Any) -> Any:
                watcher = self._watcher
                if watcher is None:
                    return real(*args, **named)
                if inside():
                    return self._inside(role, name, args, named, real)
                in_list, so_far = _RECORD.list_open, 0
                if in_list:
                    _RECORD.settle()
                    so_far = watcher.listed()
                watcher.before(role, name, args)
                try:
                    result = real(*args, **named)
                    watcher.after(role, name, args, real)
                except GLError:
                    watcher.failed(role, name, args, real)
                    raise
                except BaseException as error:
                    if in_list and not is_ours(error):  # a handler's: the list has the call by now
                        with Held():
                            if watcher.listed() == so_far:
                                watcher.after(role, name, args, real)
                    else:
                        watcher.refused()
                    raise
                return result

            return hook

        return maker

    def _bracket(self, name: str, role: Role) -> Maker:
        def maker(real: Call) -> Call:
            def hook(*args: Any, **named: Any) -> Any:
                if not are_ints(args):
                    return bracket(*args, **named)
                with Held():  # what is known of a list is what is in it
                    return bracket(*args, **named)

            def bracket(*args: Any, **named: Any) -> Any:
                watcher = self._watcher
                if role is Role.LIST_CLOSE:
                    if _RECORD.list_open:
                        _RECORD.close_list()
                        self._follow_lists(False)
                        if watcher is not None:
                            watcher.before(role, name, args)
                    else:
                        _RECORD.spill()
                    return real(*args, **named)
                closed = not _RECORD.list_open and not _RECORD.inside()
                _RECORD.spill()
                if closed and watcher is not None:
                    watcher.before(role, name, args)
                try:
                    return real(*args, **named)
                finally:
                    if closed and compiles_a_list():
                        if watcher is not None:
                            watcher.after(role, name, args, real)
                        self._follow_lists(True)
                        _RECORD.open_list(capturing=watcher is not None)

            return hook

        return maker

    def _follow_lists(self, follow: bool) -> None:
        if follow and self._in_lists not in RAW.matchers:
            RAW.hook_matching(self._in_lists)
        elif not follow and self._in_lists in RAW.matchers:
            RAW.unhook_matching(self._in_lists)


def _noting(note: Callable[[], None]) -> Maker:
    """What is asked about from its first call on."""

    def maker(real: Call) -> Call:
        def hook(*args: Any, **named: Any) -> Any:
            note()
            return real(*args, **named)

        return hook

    return maker


WATCH = Watch()
