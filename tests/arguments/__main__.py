"""``python -m tests.arguments [--flags NAME ...] [--styles NAME ...] [--count N] [--seed S]
[--everything] [--libraries] [--others WHEN]`` makes calls with arguments of every kind and says
what a style changes."""

from __future__ import annotations

import argparse
import json
import sys
from itertools import zip_longest
from typing import Any

from tests.arguments import FLAGS, MIXED, STYLES, differences, told


def pairs(one: str | None, other: str | None) -> list[tuple[Any, Any]]:
    """Where what came of a case differs."""
    both = zip_longest(*(json.loads(each or "[]") for each in (one, other)))
    return [pair for pair in both if pair[0] != pair[1]]


def main() -> int:
    """Exit status: whether anything differs."""
    ask = argparse.ArgumentParser(prog="python -m tests.arguments")
    ask.add_argument("--flags", nargs="+", default=list(FLAGS), metavar="NAME",
                     help=f"of {', '.join(FLAGS)}, or by chance: {MIXED}N for any number N")
    ask.add_argument("--styles", nargs="+", default=STYLES)
    ask.add_argument("--count", type=int, default=0, help="so many by chance; else all")
    ask.add_argument("--functions", type=int, default=0, help="of so many by chance; else of all")
    ask.add_argument("--seed", type=int, default=0)
    ask.add_argument("--everything", action="store_true", help="extensions, too")
    ask.add_argument("--handler", action="store_true", help="a list handler of the program's")
    ask.add_argument("--libraries", action="store_true", help="GLU and GLUT")
    ask.add_argument("--others", choices=("first", "last", ""), default="first",
                     help="when other modules meddle with ctypes")
    ask.add_argument("--only", default="", metavar="REGEX", help="functions by name")
    ask.add_argument("--show", type=int, default=20)
    given = ask.parse_args()
    bad = 0
    for flags in given.flags:
        how = {"count": given.count, "seed": given.seed, "everything": given.everything,
               "handler": given.handler, "functions": given.functions,
               "libraries": given.libraries, "others": given.others,
               "only": given.only}  # fmt: skip
        plain = told(flags, "", **how)
        for at in plain.crashed[: given.show]:
            print(f"  ends plain PyOpenGL: {plain.cases[at]}")
        for style in given.styles:
            styled = told(flags, style, skipped=tuple(plain.crashed), **how)
            differ = differences(plain, styled)
            print(
                f"{flags}, {style}: {len(plain.came)} of {plain.total} cases,",
                f"{len(differ)} differ;",
                f"{len(plain.crashed)} end plain PyOpenGL, {len(styled.crashed)} more under it",
                flush=True,
            )
            for at in styled.crashed[: given.show]:
                print(f"  ends it: {styled.cases[at]}")
            for case, (one, other) in list(differ.items())[: given.show]:
                print(f"  {case}")
                for a, b in pairs(one, other):
                    print(f"    plain: {a}\n    under it: {b}")
            bad += len(differ) + len(styled.crashed)
    return int(bad > 0)


if __name__ == "__main__":
    sys.exit(main())
