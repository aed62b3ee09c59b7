"""What is installed, by name: stylers, under the entry points ``glshim.stylers``, and looks, which
are style files, in packages named under ``glshim.looks``::

    [project.entry-points."glshim.stylers"]
    dots = "my_package.dots:Dots"
    [project.entry-points."glshim.looks"]
    my_package = "my_package.looks"      # a folder of TOML files

Looks in a folder ``former`` below are found by their names and listed nowhere: what was renamed.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from importlib.util import find_spec
from pathlib import Path
from types import MappingProxyType

from glshim.errors import StyleError, unknown
from glshim.notices import say_once
from glshim.styling.former import advice
from glshim.styling.protocol import Styler
from glshim.system.modules import OURS_ALONE

STYLERS, LOOKS = "glshim.stylers", "glshim.looks"
FORMER = "former"
FILE = ".toml"
"""How the name of a style file ends."""


@cache
def _found() -> dict[str, EntryPoint]:
    with OURS_ALONE:
        return {point.name: point for point in entry_points(group=STYLERS)}


def names() -> tuple[str, ...]:
    """The installed stylers, sorted."""
    return tuple(sorted(_found()))


@cache
def looks() -> Mapping[str, Path]:
    """The style file of each installed look, sorted by name.

    A name is a styler's first; of two looks called alike the one that comes first on Python's path
    counts. A package that cannot be found has no looks, which is said once.
    """
    return _looks("")


@cache
def _former() -> Mapping[str, Path]:
    return _looks(FORMER)


def look(name: str) -> Path | None:
    """The style file of a look, also of one that was renamed."""
    return looks().get(name) or _former().get(name)


def _looks(below: str) -> Mapping[str, Path]:
    """Those in a folder of each package of looks."""
    found: dict[str, Path] = {}
    with OURS_ALONE:
        points = entry_points(group=LOOKS)
    for point in points:
        try:
            for folder in _folders(point.value):
                for path in (folder / below).glob("*" + FILE):
                    found.setdefault(path.stem, path)
        except (ImportError, ValueError) as error:
            say_once(f"the looks of {point.name!r} ({point.value}) cannot be found: {error}")
    return MappingProxyType({name: found[name] for name in sorted(found) if name not in _found()})


def _folders(package: str) -> list[Path]:
    """Where a package lies, which is not imported (what it lies in is). Raises ImportError."""
    with OURS_ALONE:
        spec = find_spec(package)
    if spec is None or spec.submodule_search_locations is None:
        raise ImportError(f"there is no package {package}")
    return [*map(Path, spec.submodule_search_locations)]


def forget() -> None:
    """Look for what is installed anew."""
    _found.cache_clear()
    looks.cache_clear()
    _former.cache_clear()


def load(name: str) -> type[Styler]:
    """The class of the styler of that name.

    Raises `UnknownNameError` (with the nearest matches, of stylers and looks) when there is none,
    `StyleError` when it cannot be imported or is not a `Styler`.
    """
    point = _found().get(name)
    if point is None:
        known = (*names(), *looks())
        raise unknown(f"no style is called {name!r}", name, known, listed_by="glshim styles")
    try:
        with OURS_ALONE:
            found = point.load()
    except Exception as error:
        told = f"{error}{advice(error)}"
        raise StyleError(f"style {name!r} ({point.value}) cannot be loaded: {told}") from error
    if not (isinstance(found, type) and issubclass(found, Styler)):
        raise StyleError(f"style {name!r} ({point.value}) is not a glshim Styler")
    return found
