"""The quads of the GPU are the numpy references' (glshim/geometry/references/crease_quads.py)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from glshim_stylers.crease import CREASES, SILHOUETTES

from glshim.geometry.crease.creases import creases
from glshim.geometry.recovery.mesh import mesh as recovered
from glshim.geometry.references.crease_quads import crease_quads, silhouette_quads, silhouettes
from glshim.model.camera import Camera
from glshim.outputs.gl.device.guard import Guard
from glshim.outputs.gl.passes.runner import seen_from
from glshim.styling.protocol import Layer
from tests import creased, look
from tests.captured import CapturingRunner
from tests.golden.test_crease import wide

VIEW = (10, 20, 640, 360)
HALF = (320.0, 180.0)
JOINT = 0.05  # quads.glsl: by how much quads overlap
TILTED = look.look_at((2.5, -1.9, 1.6))
CAMERAS = {
    "perspective": Camera(TILTED, look.perspective(50, 16 / 9), VIEW),
    "parallel": Camera(TILTED, look.orthographic(2, 16 / 9), VIEW),
    "from below": Camera(look.look_at((-1.3, 2.2, -2.4)), look.perspective(50, 16 / 9), VIEW),
    "mirrored": Camera(TILTED @ np.diag((-1.0, 1, 1, 1)), look.perspective(50, 16 / 9), VIEW),
    "near": Camera(look.look_at((1.5, -1.2, 1.3)), look.perspective(70, 16 / 9), VIEW),
}
NAMES = {"gl_Position": 4, "spot": 3, "extent": 3, "line_a": 3, "line_b": 3}


@pytest.fixture(scope="module")
def run():
    with look.window():
        yield CapturingRunner()


def emitted(run, mesh, camera, shader, width):
    """Of each quad that a shader emits: corners (Q, 4, 2) in pixels, far and near end of its one
    side and of the other, ``spot`` there, ``extent``, and the line (Q, 2, 3)."""
    style = wide(width, texture="pen")
    (one,) = (p for p in style.draws(Layer(((mesh, camera),))) if p.shader is shader)
    with Guard():
        found = run.varyings(replace(one, sieve=None), NAMES)[0]
    assert np.allclose(found["gl_Position"][..., 3], 1.0)
    pairs = {name: rows.reshape(-1, 2, 3, rows.shape[-1]) for name, rows in found.items()}
    # Of a strip 0 1 2 3 feedback has the triangles 0 1 2 and 2 1 3.
    first, second = pairs["gl_Position"][:, 0], pairs["gl_Position"][:, 1]
    new = np.array([[not (q == p).all(axis=1).any() for q in two]
                    for p, two in zip(first, second, strict=True)])  # fmt: skip
    # Quads that end in a point repeat a corner.
    last = np.where(new.any(axis=1), new.argmax(axis=1), 2)
    at = np.arange(len(first))

    def quad(name):
        rows = pairs[name]
        return np.concatenate((rows[:, 0], rows[at, 1, last][:, None]), axis=1)

    corners = quad("gl_Position")[..., :2] * HALF
    middle = (VIEW[0] + HALF[0], VIEW[1] + HALF[1])
    lines = np.stack((pairs["line_a"][:, 0, 0], pairs["line_b"][:, 0, 0]), axis=1)
    lines[..., :2] -= middle
    return corners, quad("spot"), pairs["extent"][:, 0, 0], lines


def turned(v):
    return np.stack((v[..., 1], -v[..., 0]), axis=-1)


def expected(line, bisectors, joined, width):
    """(Q, 4, 2) corners from the reference's bisectors (Q, 2, 2), each for a pixel to the right of
    the line (Q, 2, 2), at signed distances width (2,): ends that are not joined (Q, 2) run on."""
    way = line[:, 1] - line[:, 0]
    size = np.linalg.norm(way, axis=1)
    v = way / size[:, None]
    own = turned(v)
    lean = (bisectors * v[:, None]).sum(axis=2)
    cap = np.abs(width).max()
    past = np.where(joined, JOINT, cap)
    corners = []
    for end in (0, 1):
        for s in width:
            room = size + past.sum(axis=1) + s * (lean[:, 1] - lean[:, 0])
            whole = np.where(room < 0.0, size + past.sum(axis=1) - room, 1.0)
            cut = np.where(room < 0.0, s * (1.0 + room / whole), s)
            t = cut * lean[:, end] + (-past[:, 0] if end == 0 else size + past[:, 1])
            corners.append(line[:, 0] + t[:, None] * v + cut[:, None] * own)
    return np.stack(corners, axis=1)


@pytest.mark.parametrize("name", ["cube", "cylinder", "cone", "ell", "lathe"])
@pytest.mark.parametrize("seen", CAMERAS)
@pytest.mark.parametrize("width", [3.0, 24.0])
def test_halves_of_creases(run, name, seen, width):
    batch, camera = creased.MESHES[name](), CAMERAS[seen]
    corners, spots, extent, lines = emitted(run, batch, camera, CREASES[0], width)
    mine = extent[:, 1] < 1.0  # the halves in the planes of triangles
    found = creases(recovered(batch))
    matrix = camera.projection @ camera.modelview
    halves, quads = crease_quads(found, matrix, width / 2 + 1.0, half=HALF)
    fronts = front_faces(found.mesh, camera)
    shown = quads.shown & fronts[halves // 3]
    ref = quads.clip[shown]
    ends = ref[:, :2, :2] / ref[:, :2, 3:] * HALF
    long = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) > 1e-3
    assert mine.sum() == long.sum() > 4
    # The shader has the triangle on its left: it may run the other way.
    got, spots, lines = corners[mine], spots[mine], lines[mine]
    ends, bisectors = ends[long], quads.bisectors[shown][long]
    swapped = np.linalg.norm(lines[:, 0, :2] - ends[:, 0], axis=1) > np.linalg.norm(
        lines[:, 1, :2] - ends[:, 0], axis=1
    )
    ends[swapped], bisectors[swapped] = ends[swapped][:, ::-1], bisectors[swapped][:, ::-1]
    sure = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) > 2.0
    sure &= np.abs(ends).max(axis=(1, 2)) < 2000
    assert np.allclose(lines[sure][..., :2], ends[sure], rtol=1e-5, atol=0.01)
    own = turned(ends[:, 1] - ends[:, 0])
    own /= np.linalg.norm(own, axis=1)[:, None]
    joined = np.linalg.norm(bisectors + own[:, None], axis=2) > 1e-6  # none goes straight on
    wanted = expected(ends, -bisectors, joined, np.array((-width / 2 - 1.0, JOINT)))
    off = np.linalg.norm(got - wanted, axis=2).max(axis=1)
    assert (off[sure] < 0.05).mean() == 1.0, (np.flatnonzero(sure & (off > 0.05)), off[sure].max())
    # Depth in the plane of the triangle, where the shader holds on to that.
    inset = quads.clip[shown][long][:, (3, 2)]
    flat = quads.insets[shown][long].any(axis=(1, 2))
    inset[swapped] = inset[swapped][:, ::-1]
    places = inset[..., :2] / inset[..., 3:] * HALF
    depths = 0.5 + 0.5 * inset[..., 2] / inset[..., 3]
    slope, held = plane_slopes(found.mesh, halves[shown][long] // 3, camera)
    for end, corner in ((0, 0), (1, 2)):
        away = got[:, corner] - places[:, end]
        depth = depths[:, end] + (slope * away).sum(axis=1)
        check = sure & flat & held & (np.linalg.norm(away, axis=1) < 40)
        assert np.allclose(spots[check, corner, 2], depth[check], atol=2e-5)
    assert (sure & flat & held).sum() > 1 or seen == "near"


def front_faces(mesh, camera):
    eye = np.array(seen_from(camera, (0.0, 0.0, 1.0, 0.0))["eye"])
    a, b, c = (mesh.positions[mesh.triangles[:, k]].astype(float) for k in range(3))
    return (np.cross(b - a, c - a) * (eye[:3] - eye[3] * a)).sum(axis=1) > 0


def plane_slopes(mesh, triangles, camera):
    """(N, 2) window depth a pixel on triangles, and whether the shader does not bend it: seen from
    within some 60 degrees."""
    at = mesh.positions[mesh.triangles[triangles]].astype(float)
    clip = np.concatenate((at, np.ones((*at.shape[:2], 1))), axis=2) @ (
        camera.projection @ camera.modelview).T  # fmt: skip
    p = clip[..., :3] / clip[..., 3:] * (*HALF, 0.5)
    u, v = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    slope = np.stack((u[:, 2] * v[:, 1] - v[:, 2] * u[:, 1],
                      v[:, 2] * u[:, 0] - u[:, 2] * v[:, 0]), axis=1) / area[:, None]  # fmt: skip
    eye = at @ camera.modelview[:3, :3].T + camera.modelview[:3, 3]
    normal = np.cross(eye[:, 1] - eye[:, 0], eye[:, 2] - eye[:, 0])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    sight = eye.mean(axis=1) if camera.projection[3, :3].any() else np.array([[0.0, 0, 1]])
    cosine = np.abs((normal * sight).sum(axis=1)) / np.linalg.norm(sight, axis=1)
    return slope, (cosine > 0.5) & (clip[..., 3].min(axis=1) > 0.1)


@pytest.mark.parametrize("name", ["torus", "cylinder", "cone", "lathe", "bowl"])
@pytest.mark.parametrize("seen", CAMERAS)
@pytest.mark.parametrize("width", [3.0, 24.0])
def test_smooth_silhouettes(run, name, seen, width):
    batch, camera = creased.MESHES[name](), CAMERAS[seen]
    corners, _, _, lines = emitted(run, batch, camera, SILHOUETTES[0], width)
    found = creases(recovered(batch))
    eye = np.array(seen_from(camera, (0.0, 0.0, 1.0, 0.0))["eye"])
    smooth = silhouettes(found, eye)
    reach = width / 2 + 1.0
    quads = silhouette_quads(smooth, camera.projection @ camera.modelview, reach, reach, half=HALF)
    shown = quads.shown
    ref = quads.clip[shown]
    # Back from the corners to the ends.
    centre = (ref[..., :2] / ref[..., 3:] * HALF).reshape(-1, 4, 2)
    right = quads.reach[shown, 0]
    u = quads.bisectors[shown]
    ends = np.stack((centre[:, 0] + right[:, None] * u[:, 0],
                     centre[:, 1] + right[:, None] * u[:, 1]), axis=1)  # fmt: skip
    sizes = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    # Lines shorter than a thousandth of a pixel are not drawn, and nothing is joined to them.
    short = [pair for pair, size in zip(ends, sizes, strict=True) if size < 0.01]
    matched = 0
    ways = np.stack((smooth.before, smooth.after), axis=1)[shown].any(axis=2)
    for forwards, size in zip(zip(ends, u, ways, strict=True), sizes, strict=True):
        end, two, join = forwards
        if size < 2.0 or np.abs(end).max() > 2000:
            continue
        if any(np.abs(pair.mean(axis=0) - end).max(axis=1).min() < 0.01 for pair in short):
            continue
        one = np.abs(lines[..., :2] - end).max(axis=(1, 2))
        other = np.abs(lines[:, ::-1, :2] - end).max(axis=(1, 2))
        at = int(np.minimum(one, other).argmin())
        assert min(one[at], other[at]) < 0.02
        if other[at] < one[at]:
            end, two, join = end[::-1], -two[::-1], join[::-1]
        # A join that is too sharp is square, and so is one that goes straight on.
        own = turned(end[1] - end[0]) / size
        square = np.linalg.norm(two + own, axis=1) < 1e-4
        choices = [join, join & ~square]
        wanted = [expected(end[None], -two[None], c[None], np.array((-reach, reach)))[0]
                  for c in choices]  # fmt: skip
        assert any(np.allclose(corners[at], w, atol=0.1) for w in wanted), (at, corners[at], wanted)
        matched += 1
    assert matched > 1 or name == "cone"  # lines that run into its tip meet short ones
    assert len(lines) >= (sizes > 2e-3).sum()
