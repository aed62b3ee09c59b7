"""Actions that run right after a module was imported, wherever and whenever that happens.

A finder in front of ``sys.meta_path`` that finds nothing itself: for a watched name it lets the
real finders answer and has the action run once the module's own code has run, before whoever
imports it sees a single name of it.
"""

from __future__ import annotations

import sys

TYPE_CHECKING = False  # the module `typing` would be a good part of the cost of a start
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from importlib.machinery import ModuleSpec
    from types import ModuleType

    Action = Callable[[ModuleType], None]

_actions: dict[str, list[Action]] = {}


def after_import(name: str, action: Action) -> None:
    """Run ``action(module)`` when the module is imported, now if it already is."""
    module = sys.modules.get(name)
    if module is not None:
        if getattr(module.__spec__, "_initializing", False):
            _run_when_initialized(action, module)
        else:
            _run(action, module)
        return
    _actions.setdefault(name, []).append(action)
    if _FINDER not in sys.meta_path:
        sys.meta_path.insert(0, _FINDER)


def _run(action: Action, module: ModuleType) -> None:
    from glshim.system.interrupts import Held

    try:
        with Held():
            action(module)
    except Exception as error:  # an import of the app's must not fail for us
        from glshim.notices import say_fault

        say_fault(f"not ready for {module.__name__}, which stays plain", error)


def _run_when_initialized(action: Action, module: ModuleType) -> None:
    """For a module whose import is under way: the import system ends it by clearing a flag on the
    module's spec, which for that long gets a class of its own."""
    spec = module.__spec__
    plain = type(spec)

    class Watched(plain):  # type: ignore[misc, valid-type]
        def __setattr__(self, name: str, value: object) -> None:
            super().__setattr__(name, value)
            if name == "_initializing" and not value:
                self.__class__ = plain  # type: ignore[assignment]
                _run(action, module)

    spec.__class__ = Watched


class _Finder:
    """Answers None for every module, and for a watched one prepares the real finder's answer."""

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if name not in _actions:
            return None
        spec = _ask_the_others(name, path, target)
        if spec is not None and spec.loader is not None:
            _run_after(spec.loader, name)
        return spec


_FINDER = _Finder()


def _ask_the_others(
    name: str, path: Sequence[str] | None, target: ModuleType | None
) -> ModuleSpec | None:
    for finder in sys.meta_path:
        find_spec = getattr(finder, "find_spec", None)
        if finder is _FINDER or find_spec is None:
            continue
        spec: ModuleSpec | None = find_spec(name, path, target)
        if spec is not None:
            return spec
    return None


def _run_after(loader: object, name: str) -> None:
    """Shadow the loader's ``exec_module``, or in old ones ``load_module``, for one run: spec and
    loader stay the app's own objects, as `inspect`, `pkgutil` and `importlib.resources` expect
    them."""
    method = "exec_module" if hasattr(loader, "exec_module") else "load_module"
    plain: Callable[..., ModuleType | None] | None = getattr(loader, method, None)
    if plain is None:
        return

    def shadow(given: ModuleType | str) -> ModuleType | None:
        delattr(loader, method)
        loaded = plain(given)
        module = loaded or given
        if not isinstance(module, str):
            for action in _actions.pop(name, ()):
                _run(action, module)
        return loaded

    try:
        setattr(loader, method, shadow)
    except AttributeError:  # a loader without a __dict__: the module is used as it is
        _actions.pop(name, None)
