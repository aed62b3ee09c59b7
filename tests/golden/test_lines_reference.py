"""The GPU's vertices are the numpy reference's, and the reference is the paper's geometry."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.geometry import raskar
from glshim.geometry.camera import Camera
from glshim.geometry.edges import edges
from glshim.geometry.lines import FIN, RIDGE, RING, Choice, choose
from glshim.render.backend import Backend
from stylers.raskar import SHADER
from tests import look

VIEW = (10, 20, 640, 360)
HAIR = 3e-7


def cameras():
    tilted = look.look_at((2.5, -1.9, 1.6))
    skewed = tilted @ np.array([[1.4, 0.3, 0, 0.1], [0, -0.7, 0.2, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    off = look.perspective(60, 16 / 9)
    off[0, 2], off[1, 2] = 0.4, -0.2
    return {
        "perspective": Camera(tilted, look.perspective(50, 16 / 9), VIEW),
        "parallel": Camera(tilted, look.orthographic(2, 16 / 9), VIEW),
        "off centre": Camera(tilted, off, VIEW),
        "skewed and mirrored": Camera(skewed, look.perspective(50, 16 / 9), VIEW, front_ccw=False),
        "flipped": Camera(tilted, np.diag([1.0, -1, 1, 1]) @ look.perspective(), VIEW),
        "inside": Camera(look.look_at((0.9, 0.1, 0.05)), look.perspective(70, 16 / 9), VIEW),
    }


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


@pytest.mark.parametrize("camera", cameras().values(), ids=cameras().keys())
@pytest.mark.parametrize("angle", [60.0, 120.0, 180.0, 250.0])
@pytest.mark.parametrize("name", ["cube", "torus", "bowl"])
def test_gpu_vertices_are_the_reference(backend, camera, angle, name):
    records = choose(edges(look.MESHES[name]()), camera, Choice(True, np.radians(angle)))
    assert len(records)
    options = {"silhouette_width": 5.0, "ridge_width": 2.5}
    uniforms = options | {"ridge_turn": (np.cos(np.radians(angle)), np.sin(np.radians(angle)))}
    found = backend.vertices(records, camera, SHADER, uniforms, HAIR)
    expected, drawn = raskar.strips(
        records, camera, **options, ridge_angle=np.radians(angle), hair=HAIR
    )
    assert drawn.any()
    nowhere = (found == (0, 0, 2, 1)).all(axis=(1, 2))
    unsure = _near_a_decision(records, camera, np.radians(angle))
    assert (nowhere == ~drawn)[~unsure].all()
    compared = drawn & ~nowhere & ~unsure
    assert compared.mean() > 0.3
    place = found[compared, :, :2] / found[compared, :, 3:]
    wanted = expected[compared, :, :2] / expected[compared, :, 3:]
    # Screen places to 0.02 px, unless float32 runs out on vertices far outside the window.
    size = np.maximum(np.abs(wanted), 1.0)
    tolerance = 0.02 / (np.array(VIEW[2:]) / 2)
    corners = np.arange(6) < 4  # the tip of a corner jumps where a turn is nearly none
    assert (np.abs(place - wanted) / size <= tolerance)[:, corners].all()
    close = (np.abs(place - wanted) / size <= tolerance).all(axis=2)
    assert close.mean() > 0.99
    depth = found[compared, :, 2] / found[compared, :, 3]
    deep = expected[compared, :, 2] / expected[compared, :, 3]
    steep = np.ptp(deep, axis=1, keepdims=True)
    near = np.abs(depth - deep) <= 2e-5 + 0.02 * steep
    assert near.mean() > 0.99


def _near_a_decision(records, camera, angle):
    """Records whose vertices hang on a comparison that float32 may turn the other way."""
    kind = records[:, 13].astype(int)
    eye = records[:, :6].astype(float).reshape(-1, 2, 3)
    eye = eye @ camera.modelview[:3, :3].T + camera.modelview[:3, 3]
    along = eye[:, 1] - eye[:, 0]
    along /= np.linalg.norm(along, axis=1)[:, None]
    normal = records[:, 9:12] @ camera.normal_matrix.T
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    sight = camera.viewpoint[:3] - camera.viewpoint[3] * eye[:, 0]
    sight /= np.linalg.norm(sight, axis=1)[:, None]
    planes = raskar.line_planes(kind, along, normal, sight, angle)
    turned = np.abs((planes * sight).sum(axis=1))
    ridge = (kind != RING) & (kind != FIN)
    return ridge & ((np.abs(turned - raskar.EDGE_ON) < 1e-4) | (turned < 1e-4))


@pytest.mark.parametrize("camera", list(cameras().values())[:3], ids=list(cameras())[:3])
def test_offsets_are_the_asked_pixels_and_lie_in_the_papers_planes(camera):
    """Section 2.1 and 2.2: offset vertices lie on the line w px beside the side, and in the plane
    of the polygon (ring) or of the quad at the threshold angle (ridge), lifted by at most a
    pixel's worth of depth; a ridge never lies behind its side."""
    angle = np.radians(120.0)
    records = choose(edges(look.cube()), camera, Choice(True, angle))
    vertices, drawn = raskar.strips(
        records, camera, silhouette_width=7.0, ridge_width=4.0, ridge_angle=angle, hair=0.0
    )
    half = np.array(VIEW[2:]) / 2
    checked = set()
    for record, strip in zip(records[drawn], vertices[drawn], strict=True):
        kind = int(record[13])
        a, b = (record[i : i + 3] @ camera.modelview[:3, :3].T + camera.modelview[:3, 3]
                for i in (0, 3))  # fmt: skip
        ends = np.array([np.r_[p, 1] @ camera.projection.T for p in (a, b)])
        ends = ends[:, :3] / ends[:, 3:]
        start, end = ends[:, :2] * half
        along = (end - start) / np.linalg.norm(end - start)
        width = 4.0 if kind == RIDGE else 7.0
        pixel = strip[:, :2] / strip[:, 3:] * half
        normal = record[9:12] @ camera.normal_matrix.T
        normal /= np.linalg.norm(normal)
        sight = camera.viewpoint[:3] - camera.viewpoint[3] * a
        edge = (b - a) / np.linalg.norm(b - a)
        if kind == RIDGE:
            seen = normal if normal @ sight > 0 else -normal
            normal = np.sin(angle) * np.cross(edge, normal) - np.cos(angle) * seen
        turned = abs(normal @ sight) / np.linalg.norm(sight)
        slope = raskar.depth_slope(normal[None], a[None], camera, half)[0]
        for corner, at in ((0, 0), (2, 1)):
            offset = pixel[corner] - (start, end)[at]
            across = along[0] * offset[1] - along[1] * offset[0]
            assert abs(abs(across) - width - raskar.SNAP) < 1e-6
            deeper = slope @ offset
            place = np.r_[pixel[corner] / half, ends[at, 2] + deeper, 1]
            eye = np.linalg.inv(camera.projection) @ place
            assert abs((eye[:3] / eye[3] - a) @ normal) < 1e-6
            if kind == RING and turned < raskar.STEEP:
                continue
            wanted = min(deeper, 0.0) if kind == RIDGE else deeper
            lift = wanted - (strip[corner, 2] / strip[corner, 3] - ends[at, 2])
            assert 0.0 < lift < np.hypot(*slope)
            checked.add(kind)
    assert RIDGE in checked and RING in checked
