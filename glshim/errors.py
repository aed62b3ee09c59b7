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

_MOST_WORD, _MOST_MESSAGE = 80, 1000
"""Characters of what is quoted in a message, and of a message."""
_MOST_LISTED = 12
"""Known words that a message names where none is near."""


class GlshimError(Exception):
    """Root of the tree: one clear line that says what, where and what to do."""


class StyleError(GlshimError):
    """A style text, style file or option value is not usable. Its message is one line of bounded
    length, whatever the text or file holds."""

    def __init__(self, message: str) -> None:
        super().__init__(shown(message, _MOST_MESSAGE))


class UnknownNameError(StyleError):
    """A style or option of that name does not exist."""

    def __init__(self, message: str, matches: tuple[str, ...] = ()) -> None:
        super().__init__(message)
        self.matches = matches


class EnvironmentFault(GlshimError):
    """The machine lacks something that was asked for."""


class RenderError(GlshimError):
    """The extra geometry could not be drawn in this context."""


def shown(value: object, most: int = _MOST_WORD) -> str:
    """A value as part of a message: printable, on one line, its middle left out where it is
    long."""
    try:
        text = str(value)
    except (ValueError, RecursionError):  # a whole number of thousands of digits; deep tables
        return f"a {type(value).__name__} that is too long to show"
    if len(text) > most:
        text = f"{text[: most // 2]} ... {text[-most // 3 :]}"
    text = " ".join(text.splitlines())
    return text if text.isprintable() else "".join(map(_printable, text))


def _printable(character: str) -> str:
    return character if character.isprintable() else ascii(character)[1:-1]


def nearest(name: str, known: Iterable[str]) -> tuple[str, ...]:
    """The known names that one may have been meant to be, the likeliest first: those that are much
    like it, or where there are none those that are somewhat. Capitals count for nothing."""
    words = {word.lower(): word for word in known}
    if len(name) > _MOST_WORD:  # no typo; the comparison would take its time
        return ()
    for least in (0.7, 0.5):
        found = difflib.get_close_matches(name.lower(), words, n=3, cutoff=least)
        if found:
            return tuple(words[each] for each in found)
    return ()


def unknown(
    what: str, word: str, known: Iterable[str], form: str = "{}", *, listed_by: str = "",
    near: Iterable[str] = (),
) -> UnknownNameError:
    """The error of a word that stands for nothing, with the nearest known ones, or all.

    what: the beginning of its message; form: how a known one is written; listed_by: the command
    that prints all where they are too many for a message; near: the nearest, if they are known."""
    known = tuple(known)
    near = tuple(dict.fromkeys(near or nearest(word, known)))
    see = listed_by if len(known) > _MOST_LISTED else ""
    if near:
        hint = f"did you mean {' or '.join(form.format(each) for each in near)}?"
        hint += f" ({see} lists all)" if see else ""
    elif see:
        hint = f"{see} lists all"
    else:
        listed = ", ".join(form.format(each) for each in known)
        hint = f"there are {listed}" if listed else "it has none"
    return UnknownNameError(f"{what}: {hint}", near)
