"""``python -m tests.arguments [--flags NAME ...] [--styles NAME ...] [--count N] [--seed S]
[--everything]`` makes calls with arguments of every kind and says what a style changes."""

from __future__ import annotations

import argparse
import json
import sys
from itertools import zip_longest
from typing import Any

from tests.arguments import FLAGS, told


def difference(one: str | None, other: str | None) -> list[tuple[Any, Any]]:
    """Where what came of a case differs."""
    if one is None or other is None:
        return [(one, other)]
    pairs = zip_longest(json.loads(one), json.loads(other))
    return [pair for pair in pairs if pair[0] != pair[1]]


def main() -> int:
    """Exit status: whether anything differs."""
    ask = argparse.ArgumentParser(prog="python -m tests.arguments")
    ask.add_argument("--flags", nargs="+", default=list(FLAGS), choices=FLAGS)
    ask.add_argument("--styles", nargs="+", default=["none", "raskar"])
    ask.add_argument("--count", type=int, default=0, help="so many by chance; else all")
    ask.add_argument("--seed", type=int, default=0)
    ask.add_argument("--everything", action="store_true", help="extensions, too")
    ask.add_argument("--handler", action="store_true", help="a list handler of the program's")
    ask.add_argument("--show", type=int, default=20)
    given = ask.parse_args()
    bad = 0
    for flags in given.flags:
        how = {"count": given.count, "seed": given.seed, "everything": given.everything,
               "handler": given.handler}  # fmt: skip
        plain = told(flags, "", **how)
        for at in plain.crashed[: given.show]:
            print(f"  ends plain PyOpenGL: {plain.cases[at]}")
        for style in given.styles:
            styled = told(flags, style, skipped=tuple(plain.crashed), **how)
            differ = [at for at in plain.came if plain.came[at] != styled.came.get(at)]
            faults = [
                t
                for t in ("Traceback", "glshim: fault", "switched off")
                if t in styled.said and t not in plain.said
            ]
            ended = f"{len(plain.crashed)} end plain PyOpenGL, {len(styled.crashed)} more under it"
            print(f"{flags}, {style}: {len(plain.came)} of {plain.total} cases,", end=" ")
            print(f"{len(differ)} differ, {ended} {faults or ''}", flush=True)
            for at in [*styled.crashed, *differ][: given.show]:
                print(f"  {at} {plain.cases[at]}")
                for one, other in difference(plain.came.get(at), styled.came.get(at)):
                    print(f"    plain: {one}\n    under it: {other}")
            if faults:
                print(styled.said[-2000:])
            bad += len(differ) + len(styled.crashed) + len(faults)
    return int(bad > 0)


if __name__ == "__main__":
    sys.exit(main())
