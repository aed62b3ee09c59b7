"""Signal handlers of the program's: they wait where they must, and what they raise is known."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable, Iterator
from functools import partial
from types import FrameType
from typing import Any

import pytest

from glshim.system.interrupts import Held, at_once, is_ours, raiser


class Timeout(Exception):
    """What the program's handlers raise."""


def _raises(number: int, frame: FrameType | None) -> None:
    raise Timeout


@pytest.fixture(autouse=True)
def _handlers() -> Iterator[None]:
    numbers = (signal.SIGUSR1, signal.SIGUSR2)
    before = [signal.signal(number, _raises) for number in numbers]
    yield
    for number, handler in zip(numbers, before, strict=True):
        signal.signal(number, handler)


class Method:
    def handler(self, number: int, frame: FrameType | None) -> None:
        raise TypeError

    def named(self, more: int, number: int, frame: FrameType | None) -> None:
        raise TypeError


def _anything(*_: object) -> None:
    raise TypeError


@pytest.mark.parametrize(
    "handler",
    [
        _raises, _anything, Method().handler, partial(Method().named, 3),
        lambda number, frame: 1 // 0, lambda *_: [].pop(),
    ],
)  # fmt: skip
def test_what_a_handler_raises_is_the_programs(handler: Any) -> None:
    signal.signal(signal.SIGUSR1, handler)
    with pytest.raises(Exception) as caught:
        signal.raise_signal(signal.SIGUSR1)
    assert not is_ours(caught.value)


def test_what_a_trace_function_raises_is_the_programs() -> None:
    def trace(frame: FrameType, event: str, arg: object) -> None:
        raise ValueError

    before = sys.gettrace()
    try:
        sys.settrace(trace)
        _anything()
    except ValueError as error:
        found = error
    finally:
        sys.settrace(before)
    assert not is_ours(found)


@pytest.mark.parametrize("fault", [lambda: 1 // 0, lambda: _anything(1, (2, 3)), lambda: int("x")])
def test_faults_are_ours(fault: Callable[[], object]) -> None:
    with pytest.raises(Exception) as caught:
        fault()
    assert is_ours(caught.value)


def test_an_interrupt_from_the_keyboard_is_the_programs() -> None:
    assert not is_ours(KeyboardInterrupt())


def test_a_handler_waits_and_runs_once_where_the_work_was_done() -> None:
    done = []
    with pytest.raises(Timeout):
        with Held():
            signal.raise_signal(signal.SIGUSR1)
            with Held():
                signal.raise_signal(signal.SIGUSR1)
            done.append(1)
        done.append(2)
    assert done == [1]
    assert signal.getsignal(signal.SIGUSR1) is _raises


def test_each_handler_that_waited_runs() -> None:
    came = []
    signal.signal(signal.SIGUSR1, lambda number, frame: came.append(number))
    signal.signal(signal.SIGUSR2, lambda number, frame: (came.append(number), 1 // 0))
    with pytest.raises(ZeroDivisionError), Held():
        signal.raise_signal(signal.SIGUSR1)
        signal.raise_signal(signal.SIGUSR2)
        signal.raise_signal(signal.SIGUSR1)
        assert came == []
    assert sorted(came) == sorted((signal.SIGUSR1, signal.SIGUSR2))


def test_a_handler_is_told_where_the_program_was() -> None:
    found: list[FrameType | None] = []
    signal.signal(signal.SIGUSR1, lambda number, frame: found.append(frame))
    with Held():
        signal.raise_signal(signal.SIGUSR1)
    assert found[0] is not None
    assert found[0].f_code is sys._getframe().f_code


def test_a_handler_may_choose_another_one() -> None:
    def chooses(number: int, frame: FrameType | None) -> None:
        signal.signal(number, _anything)

    signal.signal(signal.SIGUSR1, chooses)
    with Held():
        signal.raise_signal(signal.SIGUSR1)
    assert signal.getsignal(signal.SIGUSR1) is _anything


def test_handlers_come_back_whenever_a_signal_comes() -> None:
    raised = caught = 0

    def handler(number: int, frame: FrameType | None) -> None:
        nonlocal raised
        raised += 1
        raise Timeout

    signal.signal(signal.SIGALRM, handler)
    try:
        for turn in range(300):
            try:
                signal.setitimer(signal.ITIMER_REAL, 1e-5 + turn % 50 * 4e-6)
                now = raised
                while raised == now:
                    with Held():
                        pass
            except Timeout:
                caught += 1
            with Held():
                pass
            assert signal.getsignal(signal.SIGALRM) is handler
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
    assert (raised, caught) == (300, 300)


def test_calls_at_once_are_made_in_turn() -> None:
    made: list[int] = []
    at_once([partial(made.append, number) for number in range(5)])
    assert made == [0, 1, 2, 3, 4]


def test_an_error_is_raised_where_c_returns_to() -> None:
    """The very one, once."""
    error, done = KeyError("the program's"), []
    calls = [raiser(error), partial(done.append, "all calls are made")]
    with pytest.raises(KeyError) as caught:
        at_once(calls)
    assert caught.value is error
    assert done == ["all calls are made"]
