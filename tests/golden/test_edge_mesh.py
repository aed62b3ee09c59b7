"""Pictures of style edge_mesh with chained strokes."""

from __future__ import annotations

import os
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from glshim_stylers.edge_mesh import EdgeMesh
from glshim_stylers.raskar import Raskar

from glshim.geometry.recovery.mesh import mesh
from glshim.geometry.window import window
from glshim.linework.feature_lines import EdgeLines, feature_lines
from glshim.model.camera import Camera
from glshim.model.lines import CONTOUR, SUGGESTIVE, Line, group_of, kind_of
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from glshim.styling.wishes import Features
from tests import look, surfaces
from tests.coherence import patterns
from tests.golden.test_legacy import LEGACY, widened
from tests.score import meshes as scored
from tests.score import views
from tests.score.__main__ import LIMIT

ROOT = Path(__file__).parents[2]
SIZE = 400
PORT = (0, 0, SIZE, SIZE)
EYE = look.look_at((3, 2, 2.5))
OFF = {"contours": False, "ridges": False, "valleys": False, "boundary": False}


@pytest.fixture(scope="module")
def backend():
    with look.window(SIZE, SIZE):
        yield Backend.attach()


def camera(eye=EYE, lens=None):
    return Camera(eye, look.perspective() if lens is None else lens, PORT)


def drawn(backend, style, *items):
    """(SIZE, SIZE) shares of ink."""
    before, after, _ = look.styled(backend, style, *items)
    return look.ink(before, after)


@pytest.mark.parametrize("name", ["torus", "cube", "cylinder", "gear"])
def test_ink_is_that_of_raskar_where_the_options_agree(backend, name):
    made = {**look.MESHES, "gear": scored.gear}[name]()
    for k, direction in enumerate(look.directions(6)):
        lens = look.perspective() if k % 2 else look.orthographic()
        item = (made, camera(look.look_at(5 * direction), lens))
        raskar = Raskar(silhouette_width=2.5, ridge_width=2.5, valley_width=2.5, valleys=True,
                        intersections=False, ridge_angle=120, valley_angle=240)  # fmt: skip
        one, other = (drawn(backend, style, item) > 0.5 for style in (EdgeMesh(), raskar))
        assert one.sum() > 500
        assert (one & ~widened(other)).sum() <= 0.001 * one.sum()
        assert (other & ~widened(one)).sum() <= 0.001 * one.sum()


def test_order_and_batches_do_not_matter(backend):
    made, view = scored.part(), camera()
    polygons = look.polygons_of(made)
    first = drawn(backend, EdgeMesh(), (made, view))
    rng = np.random.default_rng(3)
    for count in (1, 2, 7):
        order = rng.permutation(len(polygons))
        parts = [look.batch(made.positions, [polygons[i] for i in order[k::count]],
                            key=k if count == 7 else None) for k in range(count)]  # fmt: skip
        # The app's own picture may differ in a last bit of depth: lines are compared on one.
        look.clear()
        look.draw_base(made, view)
        before = look.pixels()
        layer = Layer(tuple((part, view) for part in parts))
        backend.render(EdgeMesh().draws(layer))
        assert np.abs(look.ink(before, look.pixels()) - first).max() <= 2 / 255


def cube_edges(view):
    """(E, 2, 2) in the window of a cube's edges that are hidden, far from the outline."""
    cube = look.cube()
    eye = np.linalg.inv(view.modelview)[:3, 3]
    hidden = cube.positions[np.sum((cube.positions - eye) ** 2, axis=1).argmax()]
    ends = [(hidden, np.where(np.arange(3) == k, -hidden, hidden)) for k in range(3)]
    eyes = np.array(ends) @ view.modelview[:3, :3].T + view.modelview[:3, 3]
    return window(eyes.reshape(-1, 3), view)[:, :2].reshape(-1, 2, 2)


def along(ink, a, b):
    """The greatest share of ink across each pixel of a line, away from its ends."""
    count = int(np.hypot(*(b - a)))
    at = a + np.linspace(0.1, 0.9, count)[:, None] * (b - a)
    normal = np.array((a[1] - b[1], b[0] - a[0])) / np.hypot(*(b - a))
    around = [np.floor(at + off * normal).astype(int) for off in (-1, 0, 1)]
    return np.max([ink[p[:, 1], p[:, 0]] for p in around], axis=0)


@pytest.mark.parametrize("eye", [(3, 2, 2.5), (-2, 3, -4), (1, -4, 2)])
def test_hidden_edges_of_a_cube(backend, eye):
    view = camera(look.look_at(eye))
    found, inks = {}, {}
    for hidden in ("none", "solid", "dimmed", "dashed"):
        ink = drawn(backend, EdgeMesh(hidden=hidden), (look.cube(), view))
        found[hidden] = [along(ink, a, b) for a, b in cube_edges(view)]
        inks[hidden] = ink
        assert (ink >= inks["none"] - 0.05).all()
    for none, solid, dimmed, dashed in zip(*found.values(), strict=True):
        alone = none == 0.0  # a visible edge may cross it
        assert alone.mean() > 0.7
        assert solid[alone].min() > 0.7
        assert dimmed[alone].min() > 0.15 and dimmed[alone].max() < 0.45
        assert 0.3 < (dashed[alone] > 0.5).mean() < 0.9
        gaps = np.diff((dashed < 0.2).astype(int)) == 1
        assert abs(gaps.sum() - len(dashed) / 12) <= 0.35 * len(dashed) / 12 + 1


def test_dashes_of_a_dense_mesh_are_dashes(backend):
    """Edges shorter than a dash: dashes run along chains."""
    view = camera(look.look_at((4, 0.2, 2.2)))
    for make in (lambda: look.cylinder(24), lambda: look.cylinder(400)):
        ink = {hidden: drawn(backend, EdgeMesh(hidden=hidden), (make(), view))
               for hidden in ("none", "solid", "dashed")}  # fmt: skip
        behind = (ink["solid"] > 0.9) & ~widened(ink["none"] > 0.01)
        assert behind.sum() > 100
        share = ink["dashed"][behind]
        assert 0.35 < share.mean() < 0.85
        assert ((share < 0.1) | (share > 0.9)).mean() > 0.5


def test_kinds_have_their_own_inks_and_widths(backend):
    inks = {"contour": "#ff0000", "ridge": "#00ff00", "valley": "#0000ff"}
    style = EdgeMesh(**{f"{kind}_ink": ink for kind, ink in inks.items()})
    view = camera()
    _, after, _ = look.styled(backend, style, (scored.gear(), view))
    counts = {kind: (np.abs(after.astype(int) - colour).max(axis=2) < 20).sum()
              for kind, colour in zip(inks, np.eye(3) * 255, strict=True)}  # fmt: skip
    assert min(counts.values()) > 60, counts
    bowl = EdgeMesh(boundary_ink="#ff00ff")
    _, after, _ = look.styled(backend, bowl, (look.bowl(), view))
    assert ((after == (255, 0, 255)).all(axis=2)).sum() > 200
    for kind, make in (("contour", look.torus), ("ridge", look.cube), ("valley", scored.gear),
                       ("boundary", look.bowl)):  # fmt: skip
        name = kind if kind == "boundary" else f"{kind}s"
        areas = [drawn(backend, EdgeMesh(**(OFF | {name: True, f"{kind}_width": width})),
                       (make(), view)).sum() for width in (2.0, 6.0)]  # fmt: skip
        assert 2.0 < areas[1] / areas[0] < 3.6, (kind, areas)


def smooth_lines(made, view, **more):
    """Records of smooth contours alone and their ends in the window."""
    wanted = Features(contours=True, smooth=True, **more)
    records, _ = feature_lines([(EdgeLines(mesh(made)), view.modelview)], view, wanted)
    ends = [window(records[:, end].astype(float), view) for end in (Line.A, Line.B)]
    return records, ends


def triangles_of(points, triangles):
    return look.batch(points, triangles)


@pytest.mark.parametrize("eye", [(5, 0, 0), (3, 2, 2.5), (0.5, -1, 5)])
def test_smooth_contours_of_a_sphere_lie_on_its_outline_and_close(eye):
    points, triangles = surfaces.icosphere(3)
    for lens in (look.perspective(), look.orthographic()):
        view = camera(look.look_at(eye), lens)
        records, ends = smooth_lines(triangles_of(points, triangles), view)
        assert (kind_of(records) == CONTOUR).all()
        if view.orthographic:
            radius = SIZE / 4
        else:
            far = np.linalg.norm(eye)
            radius = SIZE / 2 * view.projection[0, 0] / np.sqrt(far**2 - 1)
        for end in ends:
            away = np.hypot(*(end[:, :2] - SIZE / 2).T) - radius
            assert np.abs(away).max() < 1.5
        assert_closed(records)


def assert_closed(records):
    """Every line's end is where just one other begins."""
    a, b = (np.round(records[:, end], 4) for end in (Line.A, Line.B))
    long = np.linalg.norm(b - a, axis=1) > 1e-6
    a, b = (sorted(map(tuple, end[long].tolist())) for end in (a, b))
    assert len(a) > 20
    assert np.abs(np.array(a) - np.array(b)).max() < 3e-4


def test_smooth_contours_of_a_torus_lie_on_its_outline(backend):
    """Against the contour of the exact torus; and in the picture, nothing at the hole but that."""
    big, small = surfaces.TORUS
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 1500), np.linspace(0, 2 * np.pi, 1500))
    normal = np.stack((np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)), axis=-1)
    ring = np.stack((np.cos(u), np.sin(u), 0 * u), axis=-1)
    points, triangles, _, _ = surfaces.torus(72, 36)
    made = triangles_of(points, triangles)
    for eye in ((3, 2, 2.5), (1, 1, 5), (4, 1.0, 1.3)):
        view = camera(look.look_at(eye))
        exact = big * ring + small * normal
        facing = (normal * (np.array(eye) - exact)).sum(axis=-1) > 0
        edge = facing[:-1, :-1] != facing[1:, :-1]
        edge |= facing[:-1, :-1] != facing[:-1, 1:]
        place = exact[:-1, :-1][edge] @ view.modelview[:3, :3].T + view.modelview[:3, 3]
        truth = window(place, view)[:, :2]
        records, ends = smooth_lines(made, view)
        assert_closed(records)
        middle = (ends[0] + ends[1])[:, :2] / 2
        for found in (ends[0][:, :2], middle):
            away = np.sqrt(((found[:, None] - truth[None]) ** 2).sum(axis=2).min(axis=1))
            assert away.max() < 1.5
        style = EdgeMesh(**(OFF | {"contours": True}), smooth=True)
        ink = drawn(backend, style, (made, view)) > 0.3
        near = np.zeros((SIZE, SIZE), bool)
        near[truth[:, 1].astype(int), truth[:, 0].astype(int)] = True
        for _ in range(5):
            near = widened(near)
        assert ink.sum() > 800 and not (ink & ~near).any()


@pytest.mark.parametrize("make", [scored.gear, look.cylinder, look.cube, scored.part])
def test_smooth_contours_go_on_at_creases_and_close(make):
    """Around every closed solid: what ends on a crease goes on along it."""
    for direction in look.directions(8):
        view = camera(look.look_at(5 * direction))
        records, _ = smooth_lines(make(), view)
        lines = EdgeLines(mesh(make()))
        flat = lines.records(view.modelview, view, Features(contours=True))
        assert len(records) >= 0.5 * len(flat)
        ends = records.astype(np.float64)
        # Lines come nearer to the viewer by what they need: across the sight they meet.
        a, b = (window(ends[:, k : k + 3], view)[:, :2] for k in (0, 3))
        away = np.sqrt(((b[:, None] - a[None]) ** 2).sum(axis=2).min(axis=1))
        assert away.max() < 0.5


def test_smooth_contours_behind_a_wall_stay_behind(backend):
    """They come nearer by a polygon's width, and a long cylinder's polygons are narrow."""
    view = camera(look.look_at((0, -6, 0.5), up=(0, 0, 1)))
    wall = look.batch([(-1.2, -1.1, -1.4), (1.2, -1.1, -1.4), (1.2, -1.1, 1.4), (-1.2, -1.1, 1.4)],
                      [[0, 1, 2, 3]])  # fmt: skip
    items = ((look.cylinder(24), view), (wall, view))
    only = OFF | {"contours": True}
    assert drawn(backend, EdgeMesh(**only, smooth=True), *items).sum() == 0.0
    assert drawn(backend, EdgeMesh(**only, smooth=True), items[0]).sum() > 500


def test_suggestive_contours_lie_on_front_faces_and_stay_inside(backend):
    points, triangles = surfaces.blob(4)
    made = triangles_of(points, triangles)
    lines, total = EdgeLines(mesh(made)), 0
    for direction in look.directions(6):
        view = camera(look.look_at(5 * direction))
        wanted = Features(suggestive=True)
        records, _ = feature_lines([(lines, view.modelview)], view, wanted)
        assert (group_of(records) == SUGGESTIVE).all()
        total += len(records)
        pieces = lines.pieces
        eye = np.linalg.inv(view.modelview)[:3, 3]
        back = np.linalg.inv(view.modelview)
        middle = (records[:, Line.A] + records[:, Line.B]) / 2 @ back[:3, :3].T + back[:3, 3]
        away = ((middle[:, None] - pieces.positions[None]) ** 2).sum(axis=2)
        nearest = away.argmin(axis=1)
        facing = (pieces.normals[nearest] * (eye - pieces.positions[nearest])).sum(axis=1)
        size = np.linalg.norm(eye - pieces.positions[nearest], axis=1)
        assert (facing / size > -0.12).all()  # a vertex next to the contour may face away
        outline = drawn(backend, EdgeMesh(**OFF, fill="app"), (made, view))
        assert outline.max() == 0.0
        both = look.styled(backend, EdgeMesh(**OFF, suggestive=True), (made, view))
        ink = look.ink(*both[:2])
        covered = (both[0] != 255).any(axis=2)
        assert ink.sum() > 50 and not (ink[~widened(covered)] > 0).any()
    assert total > 300


def is_the_same(one, other):
    """But for a fraction of a pixel by which patterns settle."""
    return (np.abs(one.astype(int) - other).max(axis=2) > 64).sum() <= 10


@pytest.mark.parametrize("texture", ["dashed", "charcoal"])
def test_a_still_scene_gives_equal_frames(backend, texture):
    view = camera()
    look_of = EdgeMesh(texture=texture, contour_width=8)
    frames = [look.styled(backend, look_of, (look.torus(), view))[1] for _ in range(5)]
    for frame in frames[1:]:
        assert is_the_same(frame, frames[0])


def test_two_layers_of_one_viewport_do_not_disturb_each_other(backend):
    look_of = EdgeMesh(texture="dashed", contour_width=8)
    torus, cube = look.torus(), look.cylinder()
    one, other = camera(), camera(look.look_at((3, 2.1, 2.4)))
    frames = []
    for _ in range(4):
        pair = [look.styled(backend, look_of, item)[1] for item in ((torus, one), (cube, other))]
        frames.append(pair)
    for before, pair in pairwise(frames):
        apart = [(np.abs(frame.astype(int) - old).max(axis=2) > 64).sum()
                 for old, frame in zip(before, pair, strict=True)]  # fmt: skip
        # What followed the other's lines in the first frame still settles.
        assert max(apart) <= 40, apart


def test_a_turning_scene_moves_patterns_less_than_the_paper_does():
    pot = look.torus(48, 24)
    with look.window(patterns.SIZE, patterns.SIZE):
        for smooth in (False, True):
            shift = {name: patterns.mean_shift(patterns.Method(pot, name, smooth), 12, 2.0)
                     for name in patterns.NAMES}  # fmt: skip
            for name in ("object", "screen"):
                assert shift["coherent"][1] < 0.9 * shift[name][1], (smooth, shift)


@pytest.fixture(scope="module")
def scores():
    """Tallies by mesh."""
    found = {}
    with look.window(views.SIZE, views.SIZE):
        backend = Backend.attach()
        for name in ("torus", "gear", "part"):
            tallies = found[name] = {}
            seen = views.look_at_views(
                backend, scored.MESHES[name](), only=(2, 5, 11, 17), name="edge_mesh"
            )
            for view in seen:
                for kind, verdict in view.verdicts.items():
                    tallies.setdefault(kind, views.Tally()).add(view.number, verdict)
    return found


@pytest.mark.parametrize("name", ["torus", "gear", "part"])
def test_ink_lies_where_lines_are_and_nowhere_else(scores, name):
    tally = scores[name]["all"]
    assert tally.sure > 3000
    assert tally.passes(LIMIT), (tally.precision, tally.recall, tally.dots)
    assert scores[name]["silhouettes"].passes(LIMIT)
    for kind in ("ridges", "valleys"):
        assert scores[name][kind].recall >= LIMIT


OLD = """
import sys
import numpy as np
from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim_stylers.edge_mesh import EdgeMesh
from tests import look
from tests.score import meshes

with look.window():
    backend = Backend.attach()
    found = {"pen": np.array(type(backend.pen).__name__)}
    view = Camera(look.look_at((3, 2, 2.5)), look.perspective(), (0, 0, 400, 400))
    styles = {"plain": {}, "smooth": {"smooth": True}, "solid": {"hidden": "solid"},
              "dashed": {"hidden": "dashed"}}
    for name, options in styles.items():
        for make in (look.torus, look.cube, meshes.gear):
            before, after, _ = look.styled(backend, EdgeMesh(**options), (make(), view))
            found[f"{name} {make.__name__}"] = look.ink(before, after)
np.savez_compressed(sys.argv[1], **found)
"""


def test_opengl_2_1_draws_the_same(tmp_path):
    found = []
    for number, variables in enumerate(({}, LEGACY)):
        out = tmp_path / f"{number}.npz"
        environment = os.environ | {"PYTHONPATH": str(ROOT)} | variables
        done = subprocess.run([sys.executable, "-c", OLD, str(out)], cwd=ROOT, env=environment,
                              capture_output=True, text=True, check=False)  # fmt: skip
        assert done.returncode == 0, done.stderr
        with np.load(out) as saved:
            found.append(dict(saved))
    assert [str(one.pop("pen")) for one in found] == ["Pen", "LegacyPen"]
    for name, ink in found[0].items():
        one, other = ink > 0.5, found[1][name] > 0.5
        assert one.sum() > 300, name
        assert not (one & ~widened(other)).any() and not (other & ~widened(one)).any(), name
