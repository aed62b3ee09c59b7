"""`python -m tests.benchmarks.connectivity`: how long it takes to recover connectivity from
triangles that were sent without indices, beside Hajagos 2012, table 1, and to find it again once
the positions have moved. Milliseconds, medians."""

import argparse
import sys
from collections.abc import Callable, Iterator
from itertools import count
from statistics import median
from time import perf_counter

import numpy as np

from glshim.geometry.crease.creases import Creases, creases
from glshim.geometry.crease.smoothing_groups import by_traversal
from glshim.geometry.recovery.mesh import mesh, weld
from glshim.geometry.recovery.meshes import Meshes
from glshim.model.batch import PolygonBatch

# Name, triangles, and Hajagos's milliseconds: adjacency alone, with creases.
PAPER = (
    ("King", 8_000, 16, 20),
    ("Stanford bunny", 16_000, 32, 47),
    ("Ming head", 32_000, 172, 234),
    ("Dragon", 50_000, 265, 343),
    ("Horse", 112_000, 422, 578),
    ("a million", 1_000_000, None, None),
)
FLIPPED = 0.3
PLATES = 10
"""Every so many rings of a torus the app's normals break."""


def points_of(rows: int, columns: int, time: float) -> np.ndarray:
    """The vertices of a torus that swells with time."""
    u, v = np.meshgrid(2 * np.pi * np.arange(rows) / rows,
                       2 * np.pi * np.arange(columns) / columns, indexing="ij")  # fmt: skip
    small = 0.3 + 0.1 * np.sin(time + u)
    ring = 1 + small * np.cos(v)
    points = np.stack((ring * np.cos(u), ring * np.sin(u), small * np.sin(v)), axis=-1)
    return points.reshape(-1, 3).astype(np.float32)


def triangles_of(rows: int, columns: int, is_open: bool) -> np.ndarray:
    """(2 rows columns, 3), less a row if the torus is cut open."""
    i, j = (a.ravel() for a in np.meshgrid(np.arange(rows - is_open), np.arange(columns),
                                           indexing="ij"))  # fmt: skip
    ahead, beside = (i + 1) % rows, (j + 1) % columns
    a, b, c, d = (x * columns + y for x, y in ((i, j), (ahead, j), (ahead, beside), (i, beside)))
    return np.concatenate((np.stack((a, b, c), axis=1), np.stack((a, c, d), axis=1)))


def soup(points: np.ndarray, triangles: np.ndarray) -> PolygonBatch:
    corners = triangles.size
    return PolygonBatch(
        points[triangles].reshape(-1, 3),
        np.arange(corners, dtype=np.int32),
        np.arange(0, corners + 1, 3, dtype=np.int32),
        np.ones(corners, np.bool_),
    )


def milliseconds(rounds: int, run: Callable[[], object]) -> float:
    taken = []
    for _ in range(rounds):
        start = perf_counter()
        found = run()
        taken.append(1000 * (perf_counter() - start))
        del found  # giving its memory back is not part of it
    return median(taken)


def finding(rounds: int, points: Iterator[np.ndarray], triangles: np.ndarray) -> float:
    """Finding a mesh again, with other positions each time."""
    meshes = Meshes(most_bytes=4 << 30)
    meshes.find(soup(next(points), triangles))
    taken = []
    for _ in range(rounds):
        batch = soup(next(points), triangles)
        taken.append(milliseconds(1, lambda batch=batch: meshes.find(batch)))
    if meshes.recovered != 1:
        raise SystemExit(f"recovered {meshes.recovered} times: the moved mesh was not found")
    return median(taken)


def creasing(rounds: int, rows: int, columns: int) -> tuple[float, float, float]:
    """A mesh without indices, its adjacency and its crease differences, by the search and within
    adjacency, and the differences again once it has moved."""
    faces = triangles_of(rows, columns, False)
    order = np.random.default_rng(0).permutation(len(faces))
    sent = np.zeros((len(faces), 3, 3), np.float32)
    ring = np.tile(np.repeat(np.arange(rows), columns), 2) // PLATES % 2
    sent[..., 0], sent[..., 1] = ring[:, None], 1 - ring[:, None]
    sent, batch = sent[order], soup(points_of(rows, columns, 0.0), faces[order])

    def within() -> Creases:
        found = creases(mesh(batch), sent, rule="normals", least=0.0)
        assert found.adjacency.any()
        assert found.differences.any()
        return found

    def search() -> Creases:
        found = creases(mesh(batch), sent, rule="normals", least=0.0)
        joined = np.where(found.sides.ravel(), np.int32(-1), found.halfedges.twins)
        strips = by_traversal(found.triangles, found.sides, joined, len(found.vertices))
        found.__dict__["strips"] = strips
        assert found.adjacency.any()
        assert found.differences.any()
        return found

    was = creases(mesh(batch), sent, rule="normals", least=0.0)
    assert was.strips.incoming.any()
    moved = was.mesh.moved(1.5 * batch.positions)
    return (
        milliseconds(rounds, search),
        milliseconds(rounds, within),
        milliseconds(rounds, lambda: was.moved(moved, sent).differences),
    )


def row(triangles: int, rounds: int) -> tuple[float, ...]:
    """Welding, all of it, all of it with mixed windings, found again closed and open, and
    `creasing`."""
    columns = 500 if triangles > 500_000 else 50
    rows = triangles // (2 * columns)
    random = np.random.default_rng(0)
    faces = random.permutation(triangles_of(rows, columns, False))
    mixed = faces.copy()
    turned = random.random(triangles) < FLIPPED
    mixed[turned] = mixed[turned][:, ::-1]
    points = points_of(rows, columns, 0.0)
    consistent, inconsistent = soup(points, faces), soup(points, mixed)
    cut = random.permutation(triangles_of(rows, columns, True))
    return (
        milliseconds(rounds, lambda: weld(consistent.positions)),
        milliseconds(rounds, lambda: mesh(consistent)),
        milliseconds(rounds, lambda: mesh(inconsistent)),
        *(
            finding(rounds, (points_of(rows, columns, 0.1 * k) for k in count()), sent)
            for sent in (faces, cut)
        ),
        *creasing(rounds, rows, columns),
    )


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.connectivity",
                                     description=__doc__)  # fmt: skip
    parser.add_argument("--rounds", type=int, default=7, help="times to measure each")
    rounds = parser.parse_args(arguments).rounds
    print("Milliseconds. The paper's meshes are not ours: tori of as many triangles, each sent as")
    print("three positions, in random order.")
    print()
    print("| mesh of the paper | triangles | Hajagos: adjacency | and creases | glshim: welding "
          "| all | all, 30% wound wrongly | moved, found again | the same, open "
          "| all and creases, by search | within adjacency | moved: differences |")  # fmt: skip
    print("|---|" + 11 * "--:|")
    for name, triangles, *paper in PAPER:
        ours = row(triangles, rounds)
        cells = [f"{triangles:,}", *("" if p is None else str(p) for p in paper),
                 *(f"{t:.1f}" for t in ours)]  # fmt: skip
        print(f"| {name} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
