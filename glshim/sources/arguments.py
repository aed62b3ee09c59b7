"""What the arguments of calls say, where they say anything."""

from __future__ import annotations

from typing import Any


def number(args: tuple[Any, ...], position: int) -> int:
    """An integer argument; 0 where there is none, as the binding will say."""
    try:
        return int(args[position])
    except (IndexError, TypeError, ValueError):
        return 0
