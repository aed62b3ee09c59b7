"""Our modules and the program's: each has its own under a name, and neither meets the other's.

What glshim imports comes from where Python itself looked at its start, never from the program's
folder nor from a path that the program adds. What our imports alone have brought is not in
`sys.modules` outside of them, by its first name (``email``, not ``email.message``): the program
imports what it would import without us, its own module of that name where it has one. Where it
means the same file it gets the same module: there is never a second one.

`begin` is for the start-up file. A program that imports glshim by itself does so as it imports
anything else.
"""

import os
import sys
from _thread import RLock, get_ident

TYPE_CHECKING = False  # the module `typing` would be a good part of the cost of a start
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from importlib.machinery import ModuleSpec
    from types import FrameType, ModuleType
    from typing import Any

OURS = ("glshim", "glshim_stylers")
STYLE_FILE = "glshim_style_file_"
"""How the modules of style files begin. What they import may lie in the program's folder, too."""
_SHARED = ("OpenGL", "OpenGL_accelerate", "__main__", "__mp_main__")
"""The program's, wherever it comes from: it is what we hook."""
_MACHINERY = ("importlib", "importlib.util", "glshim.bindings.imports", __name__)
_AT_HAND = ("built-in", "frozen")

_path: "list[str]" = []
"""Where Python looked at its start; empty where nothing is told apart."""
_hidden: "dict[str, ModuleType]" = {}
"""What our imports have brought: in `sys.modules` only while we import."""
_found: "set[str]" = set()
"""First names that our imports have found since they began."""
_staying: "set[str]" = set()
"""Hidden ones that an import outside of `OURS_ALONE` has brought back: to `hide` again."""
_theirs: "dict[str, ModuleType]" = {}
"""The program's modules that have names of ours, while we import."""
_depths: "dict[int, int]" = {}
"""How deep each thread is in imports of ours."""
_lock = RLock()


def begin() -> None:
    """Tell modules apart from now on. While `site` runs: the program's folder is not there yet."""
    if _path:  # `site` reads the start-up files of a virtual environment twice
        return
    _path[:] = sys.path
    sys.meta_path.insert(0, FINDER)
    with OURS_ALONE:
        _found.update(OURS)


class Ours:
    """``with OURS_ALONE:`` what this thread imports is ours. No code of the program's runs
    within."""

    def __enter__(self) -> None:
        thread = get_ident()
        with _lock:
            if not _depths and _path:
                _come_in()
            _depths[thread] = _depths.get(thread, 0) + 1

    def __exit__(self, *_: object) -> None:
        thread = get_ident()
        with _lock:
            _depths[thread] -= 1
            if not _depths[thread]:
                del _depths[thread]
            if not _depths and _path:
                _go_out()


OURS_ALONE = Ours()


def hide() -> None:
    """Hide what imports of ours outside of `OURS_ALONE` have brought back. While none is under
    way: as a layer or a frame ends."""
    if _staying and not _depths:
        _found.update(_staying)
        _staying.clear()
        with OURS_ALONE:
            pass


def _come_in() -> None:
    for name in [*_strangers(), *_hidden]:
        if name in sys.modules and sys.modules[name] is not _hidden.get(name):
            _theirs[name] = sys.modules.pop(name)
    sys.modules.update(_hidden)


def _go_out() -> None:
    for name in {*_hidden, *_found, *_theirs} - _staying:
        spec = getattr(sys.modules.get(name), "__spec__", None)
        if getattr(spec, "_initializing", False):  # in another thread
            _staying.add(name)
        elif spec is not None:
            _hidden[name] = sys.modules.pop(name)
    _found.clear()
    sys.modules.update(_theirs)
    _theirs.clear()


def _strangers() -> "Iterator[str]":
    """Modules of the program's that have names of ours, with what they hold."""
    for name, module in list(sys.modules.items()):
        if "." in name or name in _SHARED or name in sys.builtin_module_names:
            continue
        folders, origin = list(getattr(module, "__path__", None) or ()), _origin(module)
        folder = os.path.dirname(origin)
        if origin in _AT_HAND or (os.path.dirname(folder) if folders else folder) in _path:
            continue
        if name == "numpy" and hasattr(module, "ndarray"):  # two of it cannot be loaded
            continue
        spec = _look(name, _path)
        if spec is not None and spec.origin != origin:
            yield name
            held = list(sys.modules.items()) if folders and name not in OURS else ()
            for below, each in held:
                if below.startswith(name + ".") and _origin(each).startswith(tuple(folders)):
                    yield below


def _origin(module: "ModuleType") -> str:
    return getattr(getattr(module, "__spec__", None), "origin", None) or ""


def _look(
    name: str, path: "list[str]", target: "ModuleType | None" = None
) -> "ModuleSpec | None":
    """What the finders of others say of a first name, on that path."""
    for finder in list(sys.meta_path):
        if type(finder).__module__.startswith("glshim.") or not hasattr(finder, "find_spec"):
            continue
        on_path = getattr(finder, "__name__", "") == "PathFinder"
        spec: ModuleSpec | None = finder.find_spec(name, path if on_path else None, target)
        if spec is not None:
            return spec
    return None


class Finder:
    """Answers our imports from our path, and gives the program what is the same for both."""

    def find_spec(
        self, name: str, path: "Sequence[str] | None" = None, target: "ModuleType | None" = None
    ) -> "ModuleSpec | None":
        if name in ("sitecustomize", "usercustomize"):  # `site` has read every start-up file
            _path[:] = sys.path
            return None
        if path is not None:
            return _ask_for(name, path, target) if name.partition(".")[0] in OURS else None
        if name in _SHARED:
            return None
        importer, imports = _importer()
        if get_ident() in _depths or _is_ours(importer):
            spec = self._of_ours(name, target)
            if spec is not None:
                return spec
            # The finders of others would look where the program's modules lie.
            if imports and not str(importer.get("__name__")).startswith(STYLE_FILE):
                raise ModuleNotFoundError(f"No module named {name!r}", name=name)
        return self._of_program(name, target)

    def _of_ours(self, name: str, target: "ModuleType | None") -> "ModuleSpec | None":
        spec = _look(name, _path, target) if name not in _hidden else None
        if spec is not None and spec.origin in _AT_HAND:
            return spec
        if get_ident() in _depths:
            if spec is not None:
                _found.add(name)
                _alone(spec)
            return spec
        if spec is not None:
            with OURS_ALONE:
                __import__(name)
        module = _hidden.get(name)
        if module is None:
            return None
        _staying.add(name)  # C code, and the import of what lies below, look for it now
        return _known(module, _Known(module))

    def _of_program(self, name: str, target: "ModuleType | None") -> "ModuleSpec | None":
        module = _hidden.get(name)
        if module is None:
            return None
        spec = _look(name, sys.path, target)
        # An editable install of ours is found by another file than its own.
        if spec is not None and spec.origin in (_origin(module), getattr(module, "__file__", "")):
            return _known(module, _Given(module))
        if spec is not None:
            _make_way(name, is_package=spec.submodule_search_locations is not None)
        return spec


FINDER = Finder()


def _importer() -> "tuple[dict[str, Any], bool]":
    """The globals of whoever imports, and whether it does or only asks where a module lies."""
    frame: FrameType | None = sys._getframe(2)
    imports = False
    while frame is not None and (
        frame.f_globals.get("__name__") in _MACHINERY
        or frame.f_code.co_filename.startswith("<frozen importlib")
    ):
        imports = imports or frame.f_code.co_name == "_find_and_load"
        frame = frame.f_back
    return (frame.f_globals if frame is not None else {}), imports


def _is_ours(globals_: "dict[str, Any]") -> bool:
    name = str(globals_.get("__name__"))
    first, dot, _ = name.partition(".")
    if first.startswith(STYLE_FILE) or (dot and first in OURS):
        return True
    module = _hidden.get(name) or (sys.modules.get(name) if first in _hidden else None)
    return getattr(module, "__dict__", None) is globals_


def _ask_for(
    name: str, path: "Sequence[str]", target: "ModuleType | None"
) -> "ModuleSpec | None":
    for finder in list(sys.meta_path):
        if finder is not FINDER and hasattr(finder, "find_spec"):
            spec: ModuleSpec | None = finder.find_spec(name, path, target)
            if spec is not None:
                return _alone(spec)
    return None


def _alone(spec: "ModuleSpec") -> "ModuleSpec":
    """A module of ours, whose own imports are ours when it is run. Shadows the loader's method for
    one run, so that the loader stays what it is."""
    loader: Any = spec.loader
    execute = getattr(loader, "exec_module", None)
    if execute is None or spec.origin in _AT_HAND:
        return spec

    def exec_module(module: "ModuleType") -> None:
        if vars(loader).get("exec_module") is exec_module:  # else who shadows it, too, has done so
            del loader.exec_module
        with OURS_ALONE:
            execute(module)

    if hasattr(loader, "__dict__"):
        loader.exec_module = exec_module
    return spec


class _Known:
    """A loader of a module that is loaded already."""

    def __init__(self, module: "ModuleType") -> None:
        self._module = module
        self._spec: Any = module.__spec__

    def create_module(self, spec: "ModuleSpec") -> "ModuleType":
        return self._module

    def exec_module(self, module: "ModuleType") -> None:
        module.__spec__ = self._spec

    def __getattr__(self, name: str) -> "Any":
        return getattr(self._spec.loader, name)


class _Given(_Known):
    """The program's from now on as well."""

    def create_module(self, spec: "ModuleSpec") -> "ModuleType":
        _give(spec.name)
        return self._module


def _known(module: "ModuleType", loader: _Known) -> "ModuleSpec":
    known: Any = module.__spec__
    spec: Any = type(known)(known.name, loader)
    vars(spec).update({**vars(known), "loader": loader})
    return spec  # type: ignore[no-any-return]


def _give(name: str) -> None:
    """The program imports a module that is hidden: it is the program's as well from now on, with
    the modules that it imports itself."""
    module = _hidden.pop(name, None)
    if module is None:
        return
    sys.modules.setdefault(name, module)
    for value in list(vars(module).values()):
        if isinstance(value, type(sys)):
            found = value.__name__
        elif isinstance(value, (type, type(_give))):
            found = value.__module__
        else:
            continue
        if isinstance(found, str) and found.partition(".")[0] != name:
            _give(found.partition(".")[0])


def _make_way(name: str, *, is_package: bool) -> None:
    """The program has a module of its own under a name of ours."""
    if name in OURS:
        _enter_rooms(_hidden[name])
    elif is_package:  # what is in ours is not in its
        for each in [each for each in sys.modules if each.startswith(name + ".")]:
            _hidden[each] = sys.modules.pop(each)


def _enter_rooms(package: "ModuleType") -> None:
    """Load all that lies directly below, which nothing finds any more once a module of the
    program's has the package's name; what lies deeper is found by them."""
    with OURS_ALONE:
        for entry in os.scandir(package.__path__[0]):
            name = entry.name.removesuffix(".py")
            if name.isidentifier() and not name.startswith("__"):
                __import__(f"{package.__name__}.{name}")
