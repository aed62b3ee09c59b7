"""`python -m tests.programs`: run every program plain and styled, and print how they compare."""

import argparse
import fnmatch
import sys
from pathlib import Path

from glshim.errors import EnvironmentFault
from glshim.running.headless import virtual_screen

from .catalog import PROGRAMS, Program
from .checkouts import starts_from
from .everything import every_demo
from .harness import PLAIN, Run, run
from .sources import Launch, SourceMissing


def compare(program: Program, style: str, display: str, out: Path,
            start: Launch | SourceMissing | None = None) -> list[str]:
    """One row: plain against plain, against `none`, and the pixels that the style changes."""
    def once(mode: str | None) -> Run:
        return run(program, mode, display, start=start)

    if isinstance(start, SourceMissing):
        return [program.name, "-", "-", "-", str(start)]
    try:
        plain, again = once(PLAIN), once(PLAIN)
    except SourceMissing as reason:
        return [program.name, "-", "-", "-", str(reason)]
    plain.save(out / f"{program.slug}.plain.png")
    if plain.fault():
        return [program.name, "-", "-", "-", "plain: " + plain.fault()]
    none, styled = once("none"), once(style)
    word = style.partition(":")[0]
    none.save(out / f"{program.slug}.none.png")
    saved = styled.save(out / f"{program.slug}.{word}.png")
    for mode, result in (("none", none), (word, styled)):
        (out / f"{program.slug}.{mode}.log").write_text(result.log)

    def verdict(other_is_same: bool, changed: int) -> str:
        return "yes" if other_is_same else f"NO ({changed} px)"

    notes = none.fault() or styled.fault() or str(saved)
    if not none.fault() and not styled.fault() and not (none.shimmed and styled.shimmed):
        notes = "glshim was not at work"
    elif styled.log.count("Traceback") > plain.log.count("Traceback"):
        notes += "; says " + styled.log.strip().splitlines()[-1]
    return [
        program.name,
        verdict(plain.same_as(again), plain.changed_pixels(again)),
        verdict(plain.same_as(none), plain.changed_pixels(none)),
        str(plain.changed_pixels(styled)),
        notes,
    ]


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.programs", description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("out/programs"), help="folder for PNGs")
    parser.add_argument("--only", default="*", metavar="PATTERN", help="programs to run, a glob")
    parser.add_argument("--style", default="raskar:ink=#e8641b",
                        help="the style beside none; by default with an ink that always shows")
    parser.add_argument("--all", action="store_true",
                        help="every fixed-function script of PyOpenGL-Demo, not only the list")
    parser.add_argument("--checkouts", type=Path, metavar="FOLDER",
                        help="the programs of tests/programs/checkouts.py, from clones in a folder")
    choice = parser.parse_args()
    starts = starts_from(choice.checkouts.resolve()) if choice.checkouts else {}
    programs = tuple(starts) or (every_demo() if choice.all else PROGRAMS)
    chosen = [p for p in programs if fnmatch.fnmatch(p.name, f"*{choice.only}*")]
    styled = choice.style.partition(":")[0]
    print(f"| program | plain == plain | none == plain | {styled}: changed px | picture |")
    print("|---|---|---|---|---|")
    faults = 0
    try:
        with virtual_screen() as screen:
            for program in chosen:
                row = compare(program, choice.style, screen["DISPLAY"], choice.out,
                              starts.get(program))
                faults += "NO" in row[2] or row[2] == "-"
                print("| " + " | ".join(row) + " |", flush=True)
    except EnvironmentFault as reason:
        print(reason, file=sys.stderr)
        return 2
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
