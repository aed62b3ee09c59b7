"""How stylers were written for version 0.1, and what to write instead.

Old spellings of values go on working: `accept` takes their arguments in a class's stead, and one
line says what to write now.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

from glshim.notices import say_once

Renew = Callable[[tuple[Any, ...], dict[str, Any]], dict[str, Any] | None]
"""Arguments of an old spelling to those of the new one, by name; None: it is the new one."""


def accept(cls: type, renew: Renew, instead: str) -> None:
    """Let a dataclass take the arguments of an old spelling, too; instead: what to write now."""
    init = cls.__init__  # type: ignore[misc]

    @wraps(init)
    def either(self: Any, *args: Any, **given: Any) -> None:
        renewed = renew(args, given)
        if renewed is None:
            init(self, *args, **given)
        else:
            say_once(f"a style spells {cls.__name__} as glshim 0.1 had it: write {instead}")
            init(self, **renewed)

    setattr(cls, "__init__", either)  # noqa: B010 (to mypy it has the new signature alone)


def by_order(*names: str) -> Renew:
    """Of arguments that were given by their places and have names now."""

    def renew(args: tuple[Any, ...], given: dict[str, Any]) -> dict[str, Any] | None:
        if not args or len(args) > len(names):
            return None
        return {**dict(zip(names, args, strict=False)), **given}

    return renew
