"""Which differences are glshim's: seen again in fresh processes, where plain is steady."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from tests.fuzz.compare import NONE, Difference, differences
from tests.fuzz.lanes import Lane
from tests.fuzz.program import Program
from tests.fuzz.worker import PLAIN

_FILLINGS = (0x55, 0xAA, 0)
"""What fresh memory holds, 0 as it comes: a program that depends on it has no one picture."""
_PLAYS = 24
"""In so many fresh processes plain must be the same. Where memory lies is by chance, and a program
may read what it no longer holds: one such program differed from itself in one process of eight."""


@dataclass
class Finding:
    """A program under a style, and what differs there."""

    program: Program
    style: str
    steps: tuple[str, ...]
    """Of the program, or fewer."""
    found: list[Difference]
    before: tuple[Program, ...] = ()
    """Programs that the same process must have played before."""

    judged: bool = True
    """False: of a cause that was judged often enough already."""

    @property
    def cause(self) -> str:
        """What groups findings."""
        return cause(self.style, self.found)


def cause(style: str, found: Sequence[Difference]) -> str:
    """What groups findings: the first difference."""
    return f"{'none' if style == NONE else 'a style'}: {found[0].what}"


class Pair:
    """Processes without glshim and one with a style: plays in all."""

    def __init__(self, style: str, flags: str) -> None:
        self.plain, *self.again = (Lane(PLAIN, flags, each) for each in _FILLINGS)
        self.styled = Lane(style, flags)
        self.style = style

    @property
    def lanes(self) -> tuple[Lane, ...]:
        """All of them."""
        return (self.plain, *self.again, self.styled)

    def differences(self, steps: Sequence[str]) -> list[Difference]:
        """None where plain itself dies or differs from play to play."""
        for lane in (self.plain, self.styled):
            lane.ask(steps)
        plain = self.plain.answer()
        if isinstance(plain, str):
            self.styled.end()
            return []
        styled = self.styled.answer()
        found = differences(steps, plain, styled, self.style)
        if not found:
            return []
        for lane in self.again:
            again = lane.play(steps)
            if isinstance(again, str) or differences(steps, plain, again, NONE):
                return []
        return found

    def close(self) -> None:
        """End the processes."""
        for lane in self.lanes:
            lane.close()


def judge(program: Program, style: str, before: Sequence[Program]) -> Finding | None:
    """Whether a difference is there again. before: what the same processes had played."""
    finding = _again(program, style, ()) or (before and _again(program, style, before)) or None
    return finding if finding and _steady(program) else None


def _again(program: Program, style: str, before: Sequence[Program]) -> Finding | None:
    pair = Pair(style, program.flags)
    try:
        # The others have played something else: what depends on that, plain too, is no finding.
        histories = [before, before, *(before[k::2] for k in range(len(pair.again)))]
        for lane, history in zip((pair.plain, pair.styled, *pair.again), histories, strict=True):
            for earlier in history:
                lane.play(earlier.steps)
        found = pair.differences(program.steps)
        return Finding(program, style, program.steps, found, tuple(before)) if found else None
    finally:
        pair.close()


def _steady(program: Program) -> bool:
    """Whether plain shows the same in every process."""
    first = None
    for _ in range(_PLAYS):
        lane = Lane(PLAIN, program.flags)
        try:
            seen = lane.play(program.steps)
        finally:
            lane.close()
        if isinstance(seen, str):
            return False
        if first is None:
            first = seen
        elif differences(program.steps, first, seen, NONE):
            return False
    return True
