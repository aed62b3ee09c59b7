"""What programs use beside OpenGL: memory, odd numbers, callbacks, a second thread."""

from __future__ import annotations

import enum
import queue
import signal
import threading
from collections.abc import Callable
from types import FrameType
from typing import Any

import numpy as np
from numpy.typing import NDArray


class Interrupt(Exception):
    """What the program's signal handler raises."""


class Refusal(Exception):
    """What the program raises where it is asked for a number."""


def interrupt(number: int, frame: FrameType | None) -> None:
    """The program's handler."""
    raise Interrupt


def strike() -> None:
    """A signal comes now."""
    signal.raise_signal(signal.SIGUSR1)


class Striking:
    """A number; while it is read a signal comes, whose handler raises."""

    def __init__(self, value: float, error: type[BaseException] | None = Interrupt) -> None:
        self.value, self.error = value, error

    def _read(self) -> float:
        if self.error is Interrupt:
            strike()
        elif self.error is not None:
            raise self.error("the program's own")
        return self.value

    def __float__(self) -> float:
        return float(self._read())

    def __index__(self) -> int:
        return int(self._read())

    def __repr__(self) -> str:
        return f"Striking({self.value})"


class Number(enum.IntEnum):
    """Numbers that are members of an Enum, and ints."""

    ZERO, ONE, TWO, THREE, FOUR, FIVE, SIX, SEVEN, EIGHT, NINE = range(10)


class Valued(enum.Enum):
    """Members of an Enum that are not ints."""

    ONE = 1
    FOUR = 4
    SEVEN = 7


class Holding:
    """No number, but it has what some look for."""

    def __init__(self, value: Any) -> None:
        self.value = value


class Memory:
    """Blocks of the program's memory that GL may point into until the program ends. Each holds the
    same in each process."""

    SIZE = 8192
    """Bytes."""

    def __init__(self) -> None:
        self._blocks: dict[Any, NDArray[Any]] = {}
        self._kept: list[Any] = []

    def floats(self, number: int = 0) -> NDArray[np.float32]:
        """Points in and around the unit cube; (683, 3) float32."""
        return self._block(("floats", number), lambda chance: np.round(
            chance.uniform(-1, 1, (self.SIZE // 12, 3)), 2).astype(np.float32))  # fmt: skip

    def doubles(self, number: int = 0) -> NDArray[np.float64]:
        """(1024,) float64."""
        return self._block(("doubles", number), lambda chance: np.round(
            chance.uniform(-1, 1, self.SIZE // 8), 2))  # fmt: skip

    def octets(self, number: int = 0) -> NDArray[np.uint8]:
        """(8192,) uint8 of any value: pixels."""
        return self._block(("octets", number), lambda chance: chance.integers(
            0, 256, self.SIZE, dtype=np.uint8))  # fmt: skip

    def indices(self, number: int = 0) -> NDArray[np.uint32]:
        """(2048,) uint32 below 40: so read as bytes or shorts they are small too."""
        return self._block(("indices", number), lambda chance: chance.integers(
            0, 40, self.SIZE // 4, dtype=np.uint32))  # fmt: skip

    def room(self, kind: str = "B") -> NDArray[Any]:
        """Zeros to write to; a dtype."""
        return self._block(("room", len(self._blocks)), lambda chance: np.zeros(
            self.SIZE // np.dtype(kind).itemsize, kind))  # fmt: skip

    def keep(self, value: Any) -> Any:
        """Hold a value until the program ends; gives it back."""
        self._kept.append(value)
        return value

    def _block(self, key: Any, make: Callable[[Any], NDArray[Any]]) -> Any:
        if key not in self._blocks:
            self._blocks[key] = make(np.random.default_rng(sum(map(ord, repr(key)))))
        return self._blocks[key]

    def place(self, address: int) -> int:
        """What is told of an address: whose block it is in and where, the same in each process."""
        if address < 65536:
            return address
        for number, block in enumerate(self._blocks.values()):
            offset = address - block.ctypes.data
            if 0 <= offset <= block.nbytes:
                return 1_000_000 * (number + 1) + offset
        return 999_999


class Other:
    """The program's second thread: ``other(call)`` runs a call in it and gives what it gives."""

    def __init__(self) -> None:
        self._asked: queue.SimpleQueue[Callable[[], Any] | None] = queue.SimpleQueue()
        self._said: queue.SimpleQueue[tuple[Any, BaseException | None]] = queue.SimpleQueue()
        self._thread: threading.Thread | None = None

    def __call__(self, call: Callable[[], Any]) -> Any:
        if self._thread is None:
            self._thread = threading.Thread(target=self._run, daemon=True)
            self._thread.start()
        self._asked.put(call)
        value, error = self._said.get()
        if error is not None:
            raise error
        return value

    @property
    def number(self) -> int | None:
        """The thread's, if there is one yet."""
        return self._thread.ident if self._thread is not None else None

    def _run(self) -> None:
        while (call := self._asked.get()) is not None:
            try:
                said = call(), None
            except BaseException as error:
                said = None, error
            self._said.put(said)

    def end(self) -> None:
        """Let it run out."""
        if self._thread is not None:
            self._asked.put(None)
            self._thread.join()
            self._thread = None
