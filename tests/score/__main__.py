"""``python -m tests.score [MODEL ...]``: precision and recall of drawn ink, mesh by mesh.

With files (whatever trimesh reads) those are scored, else the built-in meshes.
"""

from __future__ import annotations

import argparse
import shlex
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PIL import Image

from glshim.model.batch import PolygonBatch
from glshim.outputs.gl.backend import Backend
from tests import look
from tests.score import meshes, report, subjects, views

LIMIT = 0.998


def _arguments(given: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tests.score", description=__doc__)
    parser.add_argument("models", nargs="*", type=Path, help="files to score instead")
    parser.add_argument("--views", type=int, default=24, metavar="N", help="views of each mesh")
    parser.add_argument("--view", type=int, action="append", metavar="K", help="only view K")
    parser.add_argument("--only", action="append", choices=sorted(meshes.MESHES), metavar="MESH",
                        help=f"one of {', '.join(meshes.MESHES)}")  # fmt: skip
    parser.add_argument("--width", type=float, help="of every line in pixels; else the defaults")
    parser.add_argument("--style", choices=subjects.SUBJECTS, default="raskar", help="what draws")
    parser.add_argument("--out", type=Path, metavar="DIR", help="pictures of truth and errors")
    parser.add_argument("--write", type=Path, metavar="FILE", help="the table as Markdown")
    parser.add_argument("--check", action="store_true", help=f"fail below {LIMIT} or on a dot")
    return parser.parse_args(given)


def _chosen(args: argparse.Namespace) -> dict[str, Callable[[], PolygonBatch]]:
    if args.models:
        return {path.stem: lambda path=path: meshes.from_file(path) for path in args.models}
    return {name: meshes.MESHES[name] for name in args.only or meshes.MESHES}


def main(given: list[str]) -> int:
    args = _arguments(given)
    # Before the window opens: the teapot comes from a process with a window of its own.
    batches = {name: make() for name, make in _chosen(args).items()}
    rows: list[report.Row] = []
    print(report.HEAD, flush=True)
    with look.window(views.SIZE, views.SIZE):
        backend = Backend.attach()
        for name, batch in batches.items():
            tallies: dict[str, views.Tally] = {}
            seen = views.look_at_views(
                backend, batch, args.views, width=args.width, only=args.view, name=args.style
            )
            for view in seen:
                for kind, verdict in view.verdicts.items():
                    tallies.setdefault(kind, views.Tally()).add(view.number, verdict)
                if args.out:
                    _save(args.out, name, view)
            for kind, tally in tallies.items():
                rows.append(report.Row(name, batch.polygon_count, kind, tally))
                print(report.line(rows[-1]), flush=True)
    failing = [row for row in rows if not row.tally.passes(LIMIT)]
    for row in failing:
        print(report.complaint(row, LIMIT))
    if args.write:
        command = shlex.join(["python", "-m", "tests.score", *given])
        args.write.write_text(report.page(rows, command, args.views), "utf-8")
    return 1 if args.check and failing else 0


def _save(out: Path, name: str, view: views.View) -> None:
    out.mkdir(parents=True, exist_ok=True)
    tiles = [views.truth_picture(view), *(views.error_picture(view, k) for k in view.verdicts)]
    if len(tiles) % 2:
        tiles.append(view.after[list(view.after)[-1]][::-1])
    rows = [np.concatenate(tiles[k : k + 2], axis=1) for k in range(0, len(tiles), 2)]
    Image.fromarray(np.concatenate(rows)).save(out / f"{name}_{view.number:02d}.png")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
