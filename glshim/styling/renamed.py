"""Names that options had before. They go on being read, in style texts, in style files and by
constructors, and are listed nowhere."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import wraps
from typing import Any, TypeVar

from glshim.styling.options import options_of

_Class = TypeVar("_Class", bound=type)


@dataclass(frozen=True, slots=True)
class Renamed:
    """What an old name stands for."""

    names: tuple[str, ...]
    """The options that take its value."""
    factor: float = 1.0
    """By which it is multiplied."""
    off: tuple[str, ...] = ()
    """Switches that a value of 0 turned off."""

    def values(self, value: Any, low: float | None = None) -> dict[str, Any]:
        """The values of options by name. low: the least that they take."""
        if self.off and value == 0:
            return {name: False for name in self.off}
        if self.factor != 1.0 and isinstance(value, (int, float)):
            value *= self.factor
        if self.off and low is not None and isinstance(value, (int, float)):
            value = max(value, low)
        return {name: value for name in self.names}


def takes_old_names(cls: _Class) -> _Class:
    """Of a styler: let its constructor take the names of ``cls.former``, too."""
    init = cls.__init__  # type: ignore[misc]
    former: Mapping[str, Renamed] = cls.former  # type: ignore[attr-defined]
    least = {option.name: option.low for option in options_of(cls)}

    @wraps(init)
    def either(self: Any, *args: Any, **given: Any) -> None:
        for name in former.keys() & given.keys():
            old = former[name]
            given |= old.values(given.pop(name), least[old.names[0]])
        init(self, *args, **given)

    setattr(cls, "__init__", either)  # noqa: B010 (to mypy it has the new signature alone)
    return cls
