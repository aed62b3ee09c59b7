"""Programs by the batch: each batch is played by processes of its own, in step with each other."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from tests.fuzz.compare import NONE, Difference, differences
from tests.fuzz.judging import Finding, cause, judge
from tests.fuzz.lanes import Lane
from tests.fuzz.making import BATCH, program
from tests.fuzz.program import Program
from tests.fuzz.shrink import shrink
from tests.fuzz.worker import PLAIN

_JUDGED = 20
"""Findings of one cause that are judged; more of it are taken for more of it."""


@dataclass
class Count:
    """What a run was made of."""

    programs: int = 0
    compared: Counter[str] = field(default_factory=Counter)
    """Plays compared with plain, by style."""
    causes: Counter[str] = field(default_factory=Counter)
    died: list[int] = field(default_factory=list)
    """Programs that plain itself dies of."""
    unsteady: list[int] = field(default_factory=list)
    """Differences that were not there again: plain differs from play to play, too."""


def batches(first: int, count: int) -> Iterator[range]:
    """Numbers of programs, each range within a batch."""
    at, end = first, first + count
    while at < end:
        stop = min(end, (at // BATCH + 1) * BATCH)
        yield range(at, stop)
        at = stop


def run(seed: int, numbers: Sequence[int], style: str, count: Count, most: int) -> list[Finding]:
    """Play a batch. style: beside none, instead of the programs' own if not empty. most: findings
    of one cause that are made short."""
    programs = [program(seed, number) for number in numbers]
    styles = [*dict.fromkeys((NONE, style or programs[0].style))]
    lanes = {each: Lane(each, programs[0].flags) for each in (PLAIN, *styles)}
    suspects: list[tuple[int, str, list[Difference]]] = []
    try:
        for lane in lanes.values():
            lane.start()
        for position, each in enumerate(programs):
            for lane in lanes.values():
                lane.ask(each.steps)
            seen = {PLAIN: lanes[PLAIN].answer()}
            count.programs += 1
            if isinstance(seen[PLAIN], str):
                count.died.append(each.number)
                for name in styles:
                    lanes[name].end()
                continue
            seen |= {name: lanes[name].answer() for name in styles}
            for name in styles:
                count.compared[name] += 1
                found = differences(each.steps, seen[PLAIN], seen[name], name)
                if found:
                    suspects.append((position, name, found))
    finally:
        for lane in lanes.values():
            lane.close()
    findings = []
    for position, name, found in suspects:
        why = cause(name, found)
        if count.causes[why] >= _JUDGED:
            each = programs[position]
            findings.append(Finding(each, name, each.steps, found, judged=False))
            continue
        before = [p for p in programs[:position] if p.number not in count.died]
        finding = judge(programs[position], name, before)
        if finding is None:
            count.unsteady.append(programs[position].number)
            continue
        count.causes[why] += 1
        findings.append(shrink(finding) if count.causes[why] <= most else finding)
    return findings


def show(finding: Finding) -> Program:
    """The finding as a program."""
    each = finding.program
    return Program(each.seed, each.number, each.flags, finding.style, finding.steps)
