"""Stylers by name: whatever is installed under the entry points ``glshim.stylers``."""

from __future__ import annotations

from functools import cache
from importlib.metadata import EntryPoint, entry_points

from glshim.errors import StyleError, UnknownNameError, nearest
from glshim.styling.protocol import Styler

GROUP = "glshim.stylers"


@cache
def _found() -> dict[str, EntryPoint]:
    return {point.name: point for point in entry_points(group=GROUP)}


def names() -> tuple[str, ...]:
    """The installed stylers, sorted."""
    return tuple(sorted(_found()))


def load(name: str) -> type[Styler]:
    """The class of the styler of that name.

    Raises `UnknownNameError` (with the nearest matches) when there is none, `StyleError` when
    it cannot be imported or is no `Styler`.
    """
    point = _found().get(name)
    if point is None:
        near = nearest(name, names())
        hint = f"did you mean {' or '.join(near)}?" if near else f"there are {', '.join(names())}"
        raise UnknownNameError(f"no style is called {name!r}: {hint}", near)
    try:
        found = point.load()
    except Exception as error:
        raise StyleError(f"style {name!r} ({point.value}) cannot be loaded: {error}") from error
    if not (isinstance(found, type) and issubclass(found, Styler)):
        raise StyleError(f"style {name!r} ({point.value}) is no glshim Styler")
    return found
