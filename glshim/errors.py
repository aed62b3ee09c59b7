"""Every error that glshim raises to its own callers. The app never sees one of them.

::

    GlshimError
    ├── StyleError            a style text, TOML file or styler option that does not hold up
    │   └── UnknownNameError  a style or option that does not exist (carries the nearest matches)
    ├── EnvironmentFault      something the machine lacks (a display, Xvfb, a library)
    └── RenderError           the extra geometry could not be drawn in this context
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class GlshimError(Exception):
    """Root of the tree: one clear line that says what, where and what to do."""


class StyleError(GlshimError):
    """A style text, style file or option value is not usable."""


class UnknownNameError(StyleError):
    """A style or option of that name does not exist."""

    def __init__(self, message: str, matches: tuple[str, ...] = ()) -> None:
        super().__init__(message)
        self.matches = matches


class EnvironmentFault(GlshimError):
    """The machine lacks something that was asked for."""


class RenderError(GlshimError):
    """The extra geometry could not be drawn in this context."""


def nearest(name: str, known: Iterable[str]) -> tuple[str, ...]:
    """The known names that one may have been meant to be, the likeliest first: those that are much
    like it, or where there are none those that are somewhat."""
    words = tuple(known)
    for least in (0.7, 0.5):
        found = difflib.get_close_matches(name, words, n=3, cutoff=least)
        if found:
            return tuple(found)
    return ()


def unknown(what: str, word: str, known: Iterable[str], form: str = "{}") -> UnknownNameError:
    """The error of a word that stands for nothing, with the nearest known ones, or all.

    what: the beginning of its message; form: how a known one is written."""
    known = tuple(known)
    near = nearest(word, known)
    if near:
        hint = f"did you mean {' or '.join(form.format(each) for each in near)}?"
    else:
        listed = ", ".join(form.format(each) for each in known)
        hint = f"there are {listed}" if listed else "it has none"
    return UnknownNameError(f"{what}: {hint}", near)
