"""A cache that stays small: bounded in bytes, and forgetting what nobody asks for any more."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

Value = TypeVar("Value")

_MOST_BYTES = 256 << 20
_LONGEST_REST = 120


class AgingCache(Generic[Value]):
    """Values by key, least recently used first to go.

    A value goes when the whole exceeds ``most_bytes``, or after ``longest_rest`` calls of
    :meth:`tick` in which nobody asked for it: geometry that is made anew in each frame does not
    pile up, and what is out of sight for a moment stays.
    """

    def __init__(
        self,
        most_bytes: int = _MOST_BYTES,
        longest_rest: int = _LONGEST_REST,
        drop: Callable[[Value], None] | None = None,
    ) -> None:
        """drop is called with each value that goes: for what Python does not free."""
        self._entries: OrderedDict[Hashable, tuple[Value, int, int]] = OrderedDict()
        self._most_bytes, self._longest_rest = most_bytes, longest_rest
        self._bytes = self._now = 0
        self._drop = drop

    def __len__(self) -> int:
        return len(self._entries)

    def __contains__(self, key: Hashable) -> bool:
        return key in self._entries

    def get(self, key: Hashable) -> Value | None:
        """The value, which counts as used now."""
        entry = self._entries.get(key)
        if entry is None:
            return None
        value, size, used = entry
        if used != self._now:
            self._entries[key] = (value, size, self._now)
            self._entries.move_to_end(key)
        return value

    def put(self, key: Hashable, value: Value, size: int) -> Value:
        """Keep a value that takes so many bytes. The value."""
        old = self._entries.pop(key, None)
        self._bytes += size - (old[1] if old is not None else 0)
        if old is not None and self._drop is not None:
            self._drop(old[0])
        self._entries[key] = (value, size, self._now)
        while self._bytes > self._most_bytes and len(self._entries) > 1:
            self._drop_first()
        return value

    def tick(self) -> None:
        """A frame, or a layer, has passed."""
        self._now += 1
        while self._entries:
            _, _, used = next(iter(self._entries.values()))
            if self._now - used <= self._longest_rest:
                break
            self._drop_first()

    def _drop_first(self) -> None:
        _, (value, size, _) = self._entries.popitem(last=False)
        self._bytes -= size
        if self._drop is not None:
            self._drop(value)
