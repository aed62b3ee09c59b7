"""Faults of ours, in following: what they cost, and when they are too many."""

from __future__ import annotations

import functools
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import RLock
from typing import Any, Protocol, TypeVar

from glshim.notices import say_fault
from glshim.system.interrupts import Held, is_ours

_MOST_PLACES, _MOST_IN_A_ROW = 3, 16
"""So many kinds of them, or so many of one, are no exception any more."""


class StylingFault(Exception):
    """The styler, or an output, has failed; the cause says how."""


@contextmanager
def styling() -> Iterator[None]:
    """What fails inside is a `StylingFault`."""
    try:
        yield
    except Exception as error:
        if not is_ours(error):
            raise
        raise StylingFault from error


class Faults:
    """Those so far."""

    def __init__(
        self, drop: Callable[[], None], give_up: Callable[[BaseException], object]
    ) -> None:
        """drop: has what the current call draws carry no lines. give_up: ends the styling."""
        self.drop, self._give_up = drop, give_up
        self.one = RLock()
        """Of the thread that follows: what GL says and what is known is looked at by one at a time.
        """
        self.in_a_row: dict[str, int] = {}
        """How often, one after the other, by what was told."""
        self._places: set[str] = set()
        """Where they came up."""

    def contain(self, told: str, error: BaseException) -> None:
        """In following, a fault costs what one call has drawn: that is said once, and following
        goes on. Where it comes again and again, or in the styler, it ends the styling."""
        if isinstance(error, StylingFault):
            self._give_up(error.__cause__ or error)
            return
        place = _place(error)
        self._places.add(place)
        self.in_a_row[told] = self.in_a_row.get(told, 0) + 1
        if len(self._places) >= _MOST_PLACES or self.in_a_row[told] >= _MOST_IN_A_ROW:
            self._give_up(error)
            return
        say_fault(f"unstyled: what one call draws, by a fault of glshim at {place}", error)
        try:
            self.drop()
        except Exception as another:
            self._give_up(another)


class _Has(Protocol):
    faults: Faults


F = TypeVar("F", bound=Callable[..., Any])


def contained(method: F) -> F:
    """A fault of ours ends at most the styling, never the app's call: see `Faults.contain`. What a
    signal handler of the app's raises meanwhile comes out of its call."""
    name = method.__name__

    @functools.wraps(method)
    def safe(self: _Has, *args: Any) -> Any:
        faults = self.faults
        with faults.one:
            try:
                result = method(self, *args)
            except BaseException as error:
                if not is_ours(error):
                    with Held():
                        faults.drop()
                    raise
                faults.contain(name, error)
                return None
            if faults.in_a_row:
                faults.in_a_row.pop(name, None)
            return result

    return safe  # type: ignore[return-value]


def _place(error: BaseException) -> str:
    """Where a fault came up."""
    last = traceback.extract_tb(error.__traceback__)[-1]
    return f"{last.filename}:{last.lineno}"
