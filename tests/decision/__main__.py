"""`python -m tests.decision`: folds of 1 to 359 degrees seen from 50 directions at three distances,
as a table of how many are drawn that should not be, the other way round, and in part.

    python -m tests.decision [--write docs/measurements/decision.md]
    python -m tests.decision --quick
    python -m tests.decision --ridge 90 150 179 200 --valley 181 200 300

Exit status 1 where anything is wrong or broken.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from glshim.outputs.gl.backend import Backend
from tests import look
from tests.decision.folds import VARIANTS
from tests.decision.sweep import DISTANCES, SIZE
from tests.decision.table import COUNTS, Row, all_angles, document, markdown, quick_angles, row


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.decision")
    parser.add_argument("--ridge", type=float, nargs="*", metavar="DEGREES",
                        help="thresholds of ridges (120)")  # fmt: skip
    parser.add_argument("--valley", type=float, nargs="*", metavar="DEGREES",
                        help="thresholds of valleys (240)")  # fmt: skip
    parser.add_argument("--variant", choices=VARIANTS, nargs="*", default=VARIANTS)
    parser.add_argument("--quick", action="store_true", help="a seeded part of the folds")
    parser.add_argument("--write", type=Path, metavar="FILE", help="the table as Markdown")
    parser.add_argument("--show", type=int, default=0, metavar="N", help="say N wrong ones of each")
    options = parser.parse_args()
    if options.ridge is None and options.valley is None:
        options.ridge, options.valley = [120.0], [240.0]
    asked = [("ridge", t) for t in options.ridge or ()]
    asked += [("valley", t) for t in options.valley or ()]
    rows: list[Row] = []
    with look.window(SIZE, SIZE):
        backend = Backend.attach()
        print(markdown([], header=True), flush=True)
        for kind, threshold in asked:
            angles = quick_angles(threshold) if options.quick else all_angles(threshold)
            for variant in options.variant:
                for distance in DISTANCES:
                    rows.append(row(backend, kind, threshold, variant, distance, angles))
                    print(markdown(rows[-1:]), flush=True)
                    for fault in rows[-1].faults[: options.show]:
                        print("   ", fault)
    if options.write:
        words = " ".join(sys.argv[1:]).replace(f"--show {options.show} ", "")
        options.write.write_text(document(rows, words), "utf-8")
    return int(any(getattr(r, name) for r in rows for name in COUNTS))


if __name__ == "__main__":
    sys.exit(main())
