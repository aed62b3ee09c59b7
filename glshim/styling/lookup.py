"""Which option of a styler a key stands for: its name, its place in a feature's table, or a name
that it had before."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import SequenceMatcher
from typing import Any

from glshim.errors import StyleError, UnknownNameError, nearest, unknown
from glshim.styling.options import Option, options_of
from glshim.styling.protocol import Styler
from glshim.styling.renamed import Renamed

Key = tuple[str, ...]
SWITCH = "on"
"""The key of a feature's table that switches it."""


@dataclass(frozen=True, slots=True)
class Target:
    """What a key gives values to."""

    options: tuple[Option, ...]
    renamed: Renamed

    def values(self, read: Callable[[Option], Any]) -> dict[str, Any]:
        """By name, of an option's value as it is read. Raises `StyleError`."""
        first = self.options[0]
        value = read(replace(first, low=0.0) if self.renamed.off else first)
        return self.renamed.values(value, first.low)


def targets(stylers: Sequence[type[Styler]], key: Key) -> list[tuple[int, Target]]:
    """What a key stands for in each styler that knows it, by number. Raises `StyleError` where
    none does."""
    found, errors = [], []
    for number, styler in enumerate(stylers):
        try:
            found.append((number, wanted(styler, key)))
        except StyleError as error:
            errors.append(error)
    if not found:
        raise max(errors, key=lambda error: _nearness(key[-1], error))
    return found


def _nearness(word: str, error: StyleError) -> float:
    """How near the word is that an error suggests."""
    matches = error.matches if isinstance(error, UnknownNameError) else ()
    return max((SequenceMatcher(None, word, match).ratio() for match in matches), default=0.0)


def wanted(styler: type[Styler], key: Key) -> Target:
    """What a key of one part, or of a feature and the rest, stands for. Raises `StyleError` with
    the nearest right words."""
    renamed = styler.former.get("_".join(part for part in key if part != SWITCH))
    if renamed is None and len(key) == 2 and key[1] == SWITCH:
        renamed = next((styler.former[n] for n in _called(key[0]) if n in styler.former), None)
    try:
        option = find(styler, key)
    except StyleError:
        if renamed is None:
            raise
        options = {option.name: option for option in options_of(styler)}
        return Target(tuple(options[name] for name in renamed.names), renamed)
    return Target((option,), Renamed((option.name,)))


def find(styler: type[Styler], key: Key) -> Option:
    """The option that a key stands for: its name, or its feature and the rest of its name.
    Raises `StyleError` with the nearest right words."""
    options = {option.name: option for option in options_of(styler)}
    if len(key) == 1:
        (name,) = key
        if name not in options:
            raise _no_option(styler, name, options)
        return options[name]
    feature, rest = key
    known = features(options.values())
    if feature not in known:
        raise _no_feature(styler, feature, options, known)
    if rest not in known[feature]:
        what = f"[{feature}] of style {styler.name!r} has no {rest!r}"
        raise unknown(what, rest, known[feature])
    return known[feature][rest]


def features(options: Iterable[Option]) -> dict[str, dict[str, Option]]:
    """The options of each feature by the rest of their names: ``ridge_width`` is ``width`` of
    ``ridge``. A switch called like a feature, or like several of it (``ridges``), is its ``on``."""
    options = tuple(options)
    found: dict[str, dict[str, Option]] = {}
    for option in options:
        parts = option.name.split("_")
        for end in range(1, len(parts)):
            found.setdefault("_".join(parts[:end]), {})["_".join(parts[end:])] = option
    for option in options:
        if option.kind == "switch" or {"on", "off"} <= {*option.choices}:
            own = [name for name in found if option.name in _called(name)] or [option.name]
            for name in own:
                found.setdefault(name, {}).setdefault(SWITCH, option)
    return found


def _no_option(
    styler: type[Styler], name: str, options: Mapping[str, Option]
) -> UnknownNameError:
    """With the nearest names, also where those that are near are names of before."""
    what = f"style {styler.name!r} has no option {name!r}"
    near = [*_today(styler, nearest(name, (*options, *styler.former)))]
    return unknown(what, name, near or options, listed_by=f"glshim styles {styler.name}", near=near)


def _today(styler: type[Styler], names: Iterable[str]) -> Iterator[str]:
    """Names that options have today."""
    for name in names:
        yield styler.former[name].names[0] if name in styler.former else name


def _no_feature(
    styler: type[Styler], feature: str, options: Mapping[str, Option],
    known: Mapping[str, Mapping[str, Option]],
) -> StyleError:  # fmt: skip
    what = f"style {styler.name!r} has no feature [{feature}]"
    meant = [name for name in known if feature in _called(name)]
    if meant:
        return UnknownNameError(f"{what}: did you mean [{meant[0]}]?", (meant[0],))
    if feature in options:
        default = options[feature].show(options[feature].default)
        return StyleError(f"{feature} is an option, not a table: write {feature} = {default!r}")
    return unknown(what, feature, known, "[{}]", listed_by=f"glshim styles {styler.name}")


def _called(feature: str) -> tuple[str, ...]:
    """One and several of a feature."""
    several = (feature + "s", feature + "es")
    return (feature, *several, *([feature[:-1] + "ies"] if feature.endswith("y") else []))
