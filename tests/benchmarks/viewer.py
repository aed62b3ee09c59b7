"""The viewer with a million triangles: ``python -m tests.benchmarks.viewer [TRIANGLES]``.

Prints how long a binary PLY and an OBJ of so many triangles take to read, to prepare and to send,
and the middle time of a frame from a display list, plain and under styles, with the ratio to plain.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

import numpy as np

MODES = ("plain", "none", "raskar")
FRAMES = 8


def surface(triangles: int) -> tuple[np.ndarray, np.ndarray]:
    """A bumpy torus: points (n, 3) and triangles (m, 3), about so many."""
    sides = max(round((triangles / 4) ** 0.5), 3)
    rings = 2 * sides
    u, v = np.meshgrid(
        2 * np.pi * np.arange(rings) / rings, 2 * np.pi * np.arange(sides) / sides, indexing="ij"
    )
    r = 0.4 + 0.03 * np.sin(9 * u) * np.sin(6 * v)
    points = np.stack(
        [(1 + r * np.cos(v)) * np.cos(u), (1 + r * np.cos(v)) * np.sin(u), r * np.sin(v)], axis=2
    )
    i, j = np.arange(rings)[:, None], np.arange(sides)
    down, right = (i + 1) % rings * sides, (j + 1) % sides
    a, b, c, d = (np.broadcast_to(x, (rings, sides)).ravel()
                  for x in (i * sides + j, down + j, down + right, i * sides + right))
    return points.reshape(-1, 3), np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def loads(path: Path) -> dict[str, float]:
    """Seconds: of reading, of preparing."""
    from demo_apps.viewer.models import load
    from demo_apps.viewer.prepare import prepared

    begin = time.perf_counter()
    model = load(str(path))
    read = time.perf_counter()
    prepared(model)
    return {"reading": read - begin, "preparing": time.perf_counter() - read}


def frames(path: Path) -> dict[str, float]:
    """Seconds: until all is sent, of the first frame, of the middle one; in this process's style.
    """
    import glfw
    from OpenGL import GL

    from demo_apps.viewer.models import load
    from demo_apps.viewer.prepare import prepared
    from demo_apps.viewer.window import Window

    model = prepared(load(str(path)))
    window = Window("benchmark")
    glfw.swap_interval(0)
    begin = time.perf_counter()
    window.show(str(path), model)
    if window.coming is not None:
        window.send_all()
    GL.glFinish()
    sent = time.perf_counter() - begin
    times = []
    for _ in range(FRAMES):
        window.view.orbit(3.0, 0.0)
        begin = time.perf_counter()
        window.frame()
        GL.glFinish()
        times.append(time.perf_counter() - begin)
    window.close()
    return {"sending": sent, "first": times[0], "frame": median(times[2:])}


def child(mode: str, *arguments: str) -> dict[str, float]:
    environment = {k: v for k, v in os.environ.items() if not k.startswith("GLSHIM")}
    if mode != "plain":
        environment["GLSHIM_STYLE"] = mode
    done = subprocess.run(
        [sys.executable, "-m", "tests.benchmarks.viewer", *arguments], env=environment,
        stdout=subprocess.PIPE, text=True, check=True,
    )  # fmt: skip
    found: dict[str, float] = json.loads(done.stdout.splitlines()[-1])
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("triangles", nargs="?", type=int, default=1_000_000)
    parser.add_argument("--loads", metavar="FILE", help="read one file here (for the benchmark)")
    parser.add_argument("--frames", metavar="FILE", help="draw one file here (for the benchmark)")
    asked = parser.parse_args()
    if asked.loads or asked.frames:
        print(json.dumps(loads(Path(asked.loads)) if asked.loads else frames(Path(asked.frames))))
        return
    import trimesh

    points, triangles = surface(asked.triangles)
    print(f"{len(triangles):,} triangles, {len(points):,} points")
    mesh = trimesh.Trimesh(points, triangles, process=False)
    with tempfile.TemporaryDirectory() as folder:
        for suffix in ("ply", "obj"):
            path = Path(folder, f"surface.{suffix}")
            mesh.export(path)
            took = child("plain", "--loads", str(path))
            print(f"{suffix}: reading {took['reading']:.2f} s, preparing {took['preparing']:.2f} s")
        plain = 0.0
        for mode in MODES:
            took = child(mode, "--frames", str(Path(folder, "surface.ply")))
            plain = plain or took["frame"]
            print(
                f"{mode}: sending {took['sending']:.2f} s, first frame {took['first']:.2f} s, "
                f"frame {1000 * took['frame']:.0f} ms ({took['frame'] / plain:.2f}x)", flush=True,
            )  # fmt: skip


if __name__ == "__main__":
    main()
