"""`python -m tests.decision.edge_mesh`: what the GPU decides of every edge of eight meshes from 24
directions, beside the numpy oracle of equation 1, as a table.

Both follow the same formula, the GPU in float32 and the oracle in float64. They may differ where
float32 cannot know: in the band that `unsure` spans, a millionth of the lengths that go into a
test. Exit status 1 where they differ anywhere else.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from math import cos, radians

import numpy as np

from glshim.geometry.meshshaders.edge_mesh import features
from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.outputs.gl.device.guard import Guard
from glshim.outputs.gl.passes.runner import seen_from
from glshim.styling.passes import MeshShader, Pass, Primitives
from glshim.styling.values import Body
from tests import look
from tests.captured import CapturingRunner
from tests.score import meshes as scored

BAND = 1e-6
ANGLES = (radians(120), radians(120))
VIEWS = 24
MESHES: dict[str, Callable[[], PolygonBatch]] = {
    **look.MESHES, **{name: scored.MESHES[name] for name in ("teapot", "gear", "part", "terrain")}
}  # fmt: skip
_DECIDE = MeshShader(
    "decide",
    """
    uniform vec2 turns;
    flat out float decided;
    void main() {
        gl_Position = NOWHERE;
        decided = float(features(this_edge(), turns));
    }
    """,
    "void main() { colour = vec4(0.0); }",
)


@dataclass
class Row:
    """Edges of a mesh from all directions."""

    edges: int = 0
    features: int = 0
    unsure: int = 0
    differ: int = 0
    wrong: int = 0
    """They differ where float32 is sure."""


def cameras(count: int = VIEWS) -> list[Camera]:
    """In perspective and in parallel, in turns."""
    return [
        Camera(look.look_at(5 * d), look.perspective() if k % 2 else look.orthographic(),
               (0, 0, 400, 400))
        for k, d in enumerate(look.directions(count))
    ]  # fmt: skip


def decided(run: CapturingRunner, one: Pass) -> np.ndarray:
    """(E,) bits as the GPU has them."""
    with Guard():
        found = run.varyings(one, {"decided": 1})
    return found[0]["decided"][:, 0, 0].astype(np.uint8)


def decide(body: Body, **more: object) -> Pass:
    turns = (cos(ANGLES[0]), cos(ANGLES[1]))
    return Pass((body,), _DECIDE, "edges", Primitives("lines"), uniforms={"turns": turns}, **more)  # type: ignore[arg-type]


def unsure(indices: np.ndarray, positions: np.ndarray, eye: np.ndarray) -> np.ndarray:
    """(E,) whether float32 may see another side, another angle or a ridge for a valley."""
    at = positions.astype(np.float64)
    p0, p1, p2, p3 = (at[np.where(i < 0, ~i, i)] for i in indices.T)
    towards = eye[:3] - eye[3] * p0
    found = np.zeros(len(indices), bool)
    units = []
    for one, other in ((p1 - p0, p2 - p0), (p3 - p0, p1 - p0)):
        out = np.cross(one, other)
        size = [np.linalg.norm(v, axis=1) for v in (one, other, towards, p0, out)]
        reach = size[0] * size[1] * (size[2] + np.linalg.norm(eye[:3]) + abs(eye[3]) * size[3])
        found |= np.abs((out * towards).sum(1)) <= BAND * reach
        units.append(out / np.maximum(size[4], 1e-300)[:, None])
    product = (units[0] * units[1]).sum(1)
    for angle in ANGLES:
        found |= np.abs(product + np.cos(angle)) <= BAND
    out, rise = np.cross(p1 - p0, p2 - p0), p3 - p2  # ridge or valley
    reach = np.linalg.norm(out, axis=1) * np.linalg.norm(rise, axis=1)
    folded = product < -min(np.cos(angle) for angle in ANGLES)
    found |= folded & (np.abs((rise * out).sum(1)) <= BAND * reach)
    v0, v1, _, v3 = (np.where(i < 0, ~i, i) for i in indices.T)
    return found & (v3 != v0) & (v3 != v1)


def compare(run: CapturingRunner, mesh: PolygonBatch, views: list[Camera]) -> Row:
    row = Row()
    for camera in views:
        body = Body((mesh,), camera)
        there = decided(run, decide(body))
        with Guard():
            resident = run.residents.find(body.batches)
            run.residents.release()
        seen = seen_from(camera, (0.0, 0.0, 1.0, 0.0))
        eye = np.array(seen["eye"])
        indices, positions = resident.edges.indices, resident.mesh.positions
        here = features(indices, positions, eye, ANGLES, facing=seen["facing"])
        band = unsure(indices, positions, eye)
        row.edges += len(here)
        row.features += int((here > 0).sum())
        row.unsure += int(band.sum())
        row.differ += int((here != there).sum())
        row.wrong += int(((here != there) & ~band).sum())
    return row


def main() -> int:
    wrong = 0
    with look.window():
        run = CapturingRunner()
        print("| mesh | edges seen | features | unsure | GPU differs | outside the band |")
        print("|---|---|---|---|---|---|")
        for name, make in MESHES.items():
            made = make()
            keyed = look.batch(made.positions, look.polygons_of(made), key=name)
            row = compare(run, keyed, cameras())
            wrong += row.wrong
            print(f"| {name} | {row.edges:,} | {row.features:,} | {row.unsure:,} "
                  f"| {row.differ:,} | {row.wrong:,} |")  # fmt: skip
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
