"""Makes a finding as short as it goes: fewer steps first, then simpler ones."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from tests.fuzz.judging import Finding, Pair

_PLAYS = 400
"""At most so many tries."""
_SIMPLER = (
    (r"-?\d+\.\d+", "0.0"), (r"-?\d+\.\d+", "1.0"), (r"\b\d{2,}\b", "1"),
    (r"np\.array\((\(.*?\)), '\w+'\)", r"\1"), (r"\[:\d+\]", "[:3]"), (r"\[:\d+\]", "[:130]"),
)  # fmt: skip


def shortest(finding: Finding, play: Callable[[Sequence[str]], list[str]]) -> tuple[str, ...]:
    """The fewest steps that show one of the finding's differences. play: what differs."""
    wanted = {each.what for each in finding.found}
    left = _PLAYS

    def shows(steps: Sequence[str]) -> bool:
        nonlocal left
        left -= 1
        return left > 0 and bool(wanted & set(play(steps)))

    last = max(each.step for each in finding.found)
    steps = list(finding.steps)
    if last >= 0 and shows(steps[: last + 1]):
        steps = steps[: last + 1]
    steps = _fewer(steps, shows)
    for number, step in enumerate(steps):
        for simpler in _simpler(step):
            tried = [*steps[:number], simpler, *steps[number + 1 :]]
            if simpler != steps[number] and shows(tried):
                steps = tried
    return tuple(_fewer(steps, shows))


def _fewer(steps: list[str], shows: Callable[[Sequence[str]], bool]) -> list[str]:
    size = max(1, len(steps) // 2)
    while True:
        at, dropped = 0, False
        while at < len(steps):
            tried = steps[:at] + steps[at + size :]
            if tried and shows(tried):
                steps, dropped = tried, True
            else:
                at += size
        if size == 1 and not dropped:
            return steps
        size = max(1, size // 2)


def _simpler(step: str) -> Iterator[str]:
    for pattern, text in _SIMPLER:
        yield re.sub(pattern, text, step)


def shrink(finding: Finding) -> Finding:
    """The same finding, shorter. One that needs programs before it stays as it is."""
    if finding.before:
        return finding
    pair = Pair(finding.style, finding.program.flags)
    try:
        steps = shortest(finding, lambda steps: [d.what for d in pair.differences(steps)])
    finally:
        pair.close()
    pair = Pair(finding.style, finding.program.flags)
    try:
        found = pair.differences(steps)
    finally:
        pair.close()
    return replace(finding, steps=steps, found=found) if found else finding
