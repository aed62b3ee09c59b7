"""The GPU's strokes are the numpy reference's, and the reference is the paper's geometry.

On OpenGL 2.1 the reference itself is what is drawn (`glshim.styling.media.ink_expansion`).
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from glshim.driver.functions import gl
from glshim.geometry import raskar
from glshim.geometry.edges.edges import edges
from glshim.geometry.edges.gather import Placement
from glshim.linework.polygon_lines import polygon_lines
from glshim.model.camera import Camera
from glshim.model.lines import (
    FIN,
    INTERSECTION,
    LONE_RIDGE,
    OUTLINES,
    RIDGE,
    RING,
    VALLEY,
    Line,
)
from glshim.outputs.gl.backend import Backend
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.guard import Guard
from glshim.outputs.gl.frame.cameras import turned
from glshim.outputs.gl.frame.canvas import Canvas
from glshim.outputs.gl.frame.depth import DepthCopy
from glshim.outputs.gl.frame.frame import Frame
from glshim.styling.media.ink import SHADER
from glshim.styling.media.ink_expansion import expand
from glshim.styling.wishes import Choice
from tests import look
from tests.captured import CapturingPen

VIEW = (10, 20, 640, 360)
HAIR = 3e-7
OUTPUTS = {
    "gl_Position": 4, "line_a": 3, "line_b": 3, "onwards": 2, "slopes": 4, "extent": 3,
    "repeats": 2, "grain": 2,
}  # fmt: skip
WIDTHS = (5.0, 2.5, 4.0, 3.0, 1.0, 6.0, 2.0, 1.5)


def cameras():
    tilted = look.look_at((2.5, -1.9, 1.6))
    skewed = tilted @ np.array([[1.4, 0.3, 0, 0.1], [0, -0.7, 0.2, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    lens = look.perspective(50, 16 / 9)
    off = look.perspective(60, 16 / 9)
    off[0, 2], off[1, 2] = 0.4, -0.2
    planes = ((0.3, 1.0, 0.2, 0.4), (0.9, -0.1, 0.1, 0.6))
    return {
        "perspective": Camera(tilted, lens, VIEW),
        "parallel": Camera(tilted, look.orthographic(2, 16 / 9), VIEW),
        "off centre": Camera(tilted, off, VIEW),
        "skewed and mirrored": Camera(skewed, lens, VIEW, front_ccw=False),
        "flipped": Camera(tilted, np.diag([1.0, -1, 1, 1]) @ lens, VIEW),
        "inside": Camera(look.look_at((0.9, 0.1, 0.05)), look.perspective(70, 16 / 9), VIEW),
        "clip planes": Camera(tilted, lens, VIEW, clip_planes=planes),
        "greater depth": turned(Camera(tilted, lens, VIEW, depth_range=(0.9, 0.2)), True),
    }


def records_of(mesh, camera, angle):
    """Lines of every kind: with neighbours, without, and some as if they were intersections."""
    found = edges(mesh)
    parts = [(found, Placement.one(camera.modelview, len(found.planes)))]
    choice = Choice(silhouettes=True, ridge_angle=angle, valley_angle=2 * np.pi - angle)
    known = polygon_lines(parts, camera, choice)
    alone = polygon_lines(parts, camera, dataclasses.replace(choice, connectivity=False))
    crossing = known[np.isin(known[:, Line.KIND], (RIDGE, VALLEY))].copy()
    crossing[:, Line.KIND] = INTERSECTION
    found = np.concatenate([known, alone, crossing])
    found[:, Line.REPEATS] = np.random.default_rng(2).uniform(-3, 3, (len(found), 2))
    return found


def uniforms_of(angle):
    other = 2 * np.pi - angle
    return {
        "widths": WIDTHS,
        "hidden_share": 1.0,  # every line counts, seen or not
        "ridge_turn": (np.cos(angle), np.sin(angle)),
        "valley_turn": (np.cos(other), np.sin(other)),
    }


def strokes_of(records, camera, angle):
    return raskar.strokes(
        records, camera, widths=WIDTHS, hair=HAIR,
        ridge_angle=angle, valley_angle=2 * np.pi - angle,
    )  # fmt: skip


def reference(records, camera, angle):
    """Drawn or not, and every output of the vertex shader, in float64."""
    with np.errstate(all="ignore"):
        strokes = strokes_of(records, camera, angle)
        places = raskar.quads(strokes)
    return strokes.drawn, {
        "gl_Position": places, "line_a": strokes.start, "line_b": strokes.finish,
        "onwards": strokes.onwards, "slopes": strokes.slopes, "extent": strokes.extent,
        "grain": strokes.grain, "repeats": strokes.repeats,
    }  # fmt: skip


def shaken(records, camera, rng):
    """Both, as far off as rounding to float32 may put them."""
    projection = camera.projection * (1 + 5e-7 * rng.uniform(-1, 1, (4, 4)))
    some = records.astype(np.float64)
    some[:, : Line.KIND] *= 1 + 5e-7 * rng.uniform(-1, 1, (len(records), 15))
    return some, dataclasses.replace(camera, projection=projection)


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


@pytest.fixture(scope="module")
def pen(backend):
    return CapturingPen()


@pytest.mark.parametrize("camera", cameras().values(), ids=cameras().keys())
@pytest.mark.parametrize("angle", [60.0, 120.0, 180.0, 250.0])
@pytest.mark.parametrize("name", ["cube", "torus", "bowl"])
def test_gpu_strokes_are_the_reference(pen, camera, angle, name):
    """All that the vertex shader gives, as near as rounding the inputs to float32 lets it be."""
    angle = np.radians(angle)
    records = records_of(look.MESHES[name](), camera, angle)
    found = pen.varyings(
        records, camera, SHADER, uniforms_of(angle), OUTPUTS, hair=HAIR
    )
    drawn, wanted = reference(records, camera, angle)
    assert drawn.sum() > 10
    rng = np.random.default_rng(1)
    others = [reference(*shaken(records, camera, rng), angle) for _ in range(8)]
    sure = np.all([other[0] == drawn for other in others], axis=0)
    assert sure.mean() > 0.98
    nowhere = (found["gl_Position"] == (0, 0, 2, 1)).all(axis=(1, 2))
    assert (nowhere == ~drawn)[sure].all()

    x, y, *size = VIEW
    half = np.array(size) / 2
    assert (found["gl_Position"][drawn & ~nowhere][..., 2:] == (0, 1)).all()
    found["gl_Position"] = found["gl_Position"][..., :2] * half + (x + half[0], y + half[1])
    # Sides that go straight on may be corners or not.
    along = wanted["line_b"] - wanted["line_a"]
    along /= np.hypot(along[:, :1], along[:, 1:2])
    hinge = wanted["onwards"].any(axis=1) != found["onwards"][:, 0].any(axis=1)
    next_ = np.where(wanted["onwards"].any(axis=1)[:, None], wanted["onwards"],
                     found["onwards"][:, 0])  # fmt: skip
    turn = along[:, 0] * next_[:, 1] - along[:, 1] * next_[:, 0]
    assert (np.abs(turn) < 2e-3)[hinge & drawn & sure].all()
    assert (hinge & drawn).mean() < 0.1
    compared = drawn & sure & ~nowhere & ~hinge
    for output, every in wanted.items():
        spread = np.max([np.abs(other[1][output] - every) for other in others], axis=0)[compared]
        values = every[compared]
        here = found[output][compared]
        if output != "gl_Position":
            assert (here == here[:, :1]).all(), output  # flat
            here = here[:, 0]
        # Pixels, and depths, which are 0 where a side is cut at the near plane.
        least = {"line_a": (2e-3, 2e-3, 1.5e-6), "line_b": (2e-3, 2e-3, 1.5e-6),
                 "slopes": 3e-7, "grain": 3e-7}.get(output, 2e-3)  # fmt: skip
        off = np.abs(here - values) / (least + 2e-6 * np.abs(values) + 15 * spread)
        assert off.max() < 1.0, (output, off.max())


@pytest.mark.parametrize("camera", cameras().values(), ids=cameras().keys())
def test_the_expansion_is_the_reference_of_what_is_drawn(camera):
    angle = np.radians(120.0)
    records = records_of(look.torus(), camera, angle)
    drawn, wanted = reference(records, camera, angle)
    found = expand(records, camera, uniforms_of(angle), hair=HAIR, blur=0.0)
    assert np.allclose(found.places, wanted["gl_Position"][drawn], rtol=0, atol=1e-9)
    assert {name: rows.shape[1] for name, rows in found.values.items()} == {
        name: size for name, size in OUTPUTS.items() if name != "gl_Position"
    }
    for name, rows in found.values.items():
        assert np.allclose(rows, wanted[name][drawn], rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("name", ["perspective", "parallel", "off centre"])
def test_strokes_have_the_asked_pixels_and_lie_in_the_papers_planes(name):
    """Sections 2.1 and 2.2: the depth of a line goes on in the plane of the polygon (ring) or of
    the quad at the threshold angle (lone ridge), and the ink reaches as far as it was asked to."""
    camera, angle = cameras()[name], np.radians(120.0)
    records = records_of(look.cube(), camera, angle)
    drawn, _ = reference(records, camera, angle)
    found = expand(records, camera, uniforms_of(angle), hair=0.0, blur=0.0)
    checked = set()
    for k, record in enumerate(records[drawn]):
        kind, (inner, outer) = int(record[15]), found.values["extent"][k, :2]
        width = WIDTHS[max(kind - 2, 0) // 2]
        if kind in OUTLINES:
            assert (inner, outer) == (-raskar.INWARD, width - raskar.INWARD)
        elif kind in (RIDGE, VALLEY, INTERSECTION):
            assert (inner, outer) == (-width / 2, width / 2)
        if kind not in (RING, LONE_RIDGE):
            continue
        a, b, own = (record[i : i + 3].astype(float) for i in (0, 3, 9))
        normal = own
        if kind == LONE_RIDGE:
            edge = (b - a) / np.linalg.norm(b - a)
            sight = camera.viewpoint[:3] - camera.viewpoint[3] * a
            upright = own if own @ sight > 0 else -own
            normal = np.sin(angle) * np.cross(edge, own) - np.cos(angle) * upright
        start, slope = found.values["line_a"][k], found.values["slopes"][k, :2]
        deep = found.values["grain"][k, 0]
        if np.hypot(*slope) > 0.99 * raskar.STEEPEST * deep:
            continue  # cut
        for offset in ((5.0, 0.0), (0.0, -7.0), (3.0, 4.0)):
            place = start + np.array((*offset, slope @ offset))
            x, y, width_, height = camera.viewport
            half = np.array((width_, height)) / 2
            ndc = np.r_[(place[:2] - (x, y) - half) / half, 2 * place[2] - 1, 1]
            eye = np.linalg.inv(camera.projection) @ ndc
            assert abs((eye[:3] / eye[3] - a) @ normal) < 1e-5
        checked.add(kind)
    assert checked == {RING, LONE_RIDGE}


@pytest.mark.parametrize("name", ["perspective", "inside", "clip planes"])
def test_coverage_is_what_the_gpu_draws(backend, name):
    """Single strokes, nothing in front of them: the ink of every pixel to within 2 of 255."""
    camera, angle = cameras()[name], np.radians(120.0)
    records = records_of(look.cube(), camera, angle)
    strokes = strokes_of(records, camera, angle)
    uniforms = uniforms_of(angle) | {"inks": 8 * ((1.0, 1.0, 1.0),), "tinted": 1.0}
    width, height = VIEW[0] + VIEW[2], VIEW[1] + VIEW[3]
    box = (0, 0, width, height)
    centres = np.stack(np.meshgrid(np.arange(width), np.arange(height)), axis=2) + 0.5
    inside = (centres > VIEW[:2]).all(axis=2)
    kinds = set()
    with Guard():
        canvas, depth = Canvas(ModernDevice()), DepthCopy()
        depth.open(box, False)  # as empty as the far plane
        for row in np.flatnonzero(strokes.drawn):
            if records[row, 15] in kinds and row % 5:
                continue
            canvas.open(box)
            one = records[row : row + 1]
            backend.pen.draw(one, camera, SHADER, uniforms, Frame(depth, HAIR))
            found = np.empty((height, width), np.uint8)
            gl.glPixelStorei(0x0D05, 1)
            gl.glReadPixels(*box, 0x1903, 0x1401, found.ctypes.data)
            wanted = np.where(inside, raskar.coverage(strokes, row, centres), 0.0)
            assert np.abs(found / 255.0 - wanted).max() <= 2.0 / 255.0, (row, one[0, 15])
            kinds.add(records[row, 15])
    assert FIN in kinds
    assert name != "perspective" or {RING, RIDGE, LONE_RIDGE, INTERSECTION} <= kinds
