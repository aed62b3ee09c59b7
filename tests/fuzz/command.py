"""The command: ``python -m tests.fuzz --programs N --seed S``."""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections import defaultdict
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import contextmanager
from pathlib import Path

from glshim.running.headless import virtual_screen
from tests import sweep
from tests.fuzz.batches import Count, batches, run, show
from tests.fuzz.compare import NONE
from tests.fuzz.judging import Finding
from tests.fuzz.making import program


def main(arguments: Sequence[str] | None = None) -> int:
    """Run it; 1 where something differs."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--programs", type=int, default=300, help="how many (300)")
    parser.add_argument("--seed", type=int, default=sweep.SEED, help="which ones (by the day)")
    parser.add_argument("--first", type=int, default=0, help="number of the first (0)")
    parser.add_argument(
        "--style", default="", help="only none and this one, instead of every style in turn"
    )
    parser.add_argument(
        "--every", type=int, default=1, help="styles for one batch of so many; none for all (1)"
    )
    parser.add_argument(
        "--jobs", type=int, default=len(os.sched_getaffinity(0)), help="batches at once"
    )
    parser.add_argument(
        "--shrink",
        type=int,
        default=2,
        help="findings of each cause that are made short (2)",
    )
    parser.add_argument(
        "--out", type=Path, default=Path("out/fuzz"), help="folder for their scripts"
    )
    parser.add_argument("--show", type=int, metavar="N", help="print program N as a script")
    asked = parser.parse_args(arguments)
    if asked.show is not None:
        print(program(asked.seed, asked.show).script())
        return 0
    with _screen():
        return _run(asked)


def _run(asked: argparse.Namespace) -> int:
    begin = time.monotonic()
    count, findings = Count(), list[Finding]()
    with ThreadPoolExecutor(asked.jobs) as pool:
        jobs = [
            pool.submit(run, asked.seed, numbers, style, count, asked.shrink)
            for turn, numbers in enumerate(batches(asked.first, asked.programs))
            for style in [NONE if turn % asked.every else asked.style]
        ]
        for job in as_completed(jobs):
            for finding in job.result():
                findings.append(finding)
                _tell(finding, asked.out)
            _progress(count, findings, begin)
    _summary(count, findings, asked.seed, begin)
    return 1 if findings else 0


def _tell(finding: Finding, folder: Path) -> None:
    if not finding.judged:
        return
    folder.mkdir(parents=True, exist_ok=True)
    each = finding.program
    path = folder / f"{each.seed}_{each.number}_{finding.style.partition(':')[0]}.py"
    words = [f"{d.what}: {d.plain} then {d.other}" for d in finding.found[:6]]
    if finding.before:
        words.append(
            f"only after programs {finding.before[0].number} to {finding.before[-1].number}"
        )
    path.write_text(show(finding).script("\n".join(words)))
    steps = (f"    {step}" for step in finding.steps[:25])
    print(f"\n{each.number} {finding.style} [{each.flags}] {path}", *words, *steps, sep="\n  ")
    sys.stdout.flush()


def _progress(count: Count, findings: list[Finding], begin: float) -> None:
    seconds = time.monotonic() - begin
    print(
        f"{count.programs} programs in {seconds:.0f} s: {len(findings)} differ",
        file=sys.stderr,
        flush=True,
    )


def _summary(count: Count, findings: list[Finding], seed: int, begin: float) -> None:
    causes: dict[str, list[Finding]] = defaultdict(list)
    for finding in findings:
        causes[finding.cause].append(finding)
    plays = sum(count.compared.values())
    print(f"\nseed {seed}: {count.programs} programs, {plays} plays compared with plain,"
          f" {len(count.compared)} styles, {time.monotonic() - begin:.0f} s")  # fmt: skip
    print(f"{len(count.died)} programs that plain dies of: {sorted(count.died)[:20]}")
    print(f"{len(count.unsteady)} differences once only: {sorted(count.unsteady)[:20]}")
    print(f"{len(findings)} differences by cause:")
    for cause, those in sorted(causes.items(), key=lambda item: -len(item[1])):
        print(f"  {len(those):4}  {cause[:150]}: programs {[f.program.number for f in those[:6]]}")


@contextmanager
def _screen() -> Iterator[None]:
    """A virtual screen: windows of fuzzed programs belong on nobody's own."""
    with virtual_screen("640x480x24") as environment:
        before = dict(os.environ)
        os.environ.update(environment)
        try:
            yield
        finally:
            os.environ.clear()
            os.environ.update(before)
