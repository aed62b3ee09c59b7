"""Which source gives the polygons of a draw, and what it gives. No GL."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from glshim.bindings.pyopengl.record import Record
from glshim.model.batch import POSITIONS
from glshim.model.camera import Camera
from glshim.sources.fixed.source import FixedFunction
from glshim.sources.following import scene as scenes
from glshim.sources.following.layers import LayerCollector
from glshim.sources.following.scene import Scene
from glshim.sources.programs.source import IN_USE, Programs
from glshim.sources.source import Primitive
from glshim.sources.state import DrawState
from glshim.spec.attributes import BY_NAME
from glshim.spec.constants import GL_TRIANGLES

CAMERA = Camera(np.eye(4), np.eye(4), (0, 0, 100, 100))
PLAIN = DrawState(
    CAMERA, framebuffer=0, depth_tested=True, depth_written=True, flat=False, upright=False,
    rendered=True, program=0, obstacle="", fill_faces=True,
)  # fmt: skip
SHADED = replace(PLAIN, program=7)
_ROW = BY_NAME["glVertex2f"]
TRIANGLE = Primitive(
    GL_TRIANGLES, b"".join(_ROW.pack.pack(x, y, _ROW.tag) for x, y in ((0, 0), (1, 0), (0, 1)))
)


@pytest.fixture
def scene(monkeypatch: pytest.MonkeyPatch) -> Scene:
    monkeypatch.setattr(scenes, "shortcoming", lambda: "")
    return Scene(Record())


def test_each_draw_is_of_one_source() -> None:
    sources = FixedFunction(Record(), POSITIONS), Programs()
    for state in (PLAIN, SHADED):
        assert sum(source.obstacle(state) is not None for source in sources) == 1


def test_the_fixed_function_gives_what_it_is_told(scene: Scene) -> None:
    assert scene.obstacle(PLAIN) == ""
    assert list(scene.source.polygons(TRIANGLE, PLAIN)) == [(TRIANGLE, CAMERA)]


def test_draws_under_a_program_are_recognised_and_passed_through(scene: Scene) -> None:
    assert scene.obstacle(SHADED) == IN_USE
    assert isinstance(scene.source, Programs)
    assert list(scene.source.polygons(TRIANGLE, SHADED)) == []
    assert scene.obstacle(PLAIN) == ""
    assert isinstance(scene.source, FixedFunction)


def test_what_is_in_the_way_first_is_said(scene: Scene) -> None:
    hidden = replace(SHADED, rendered=False, obstacle="no colour is written")
    assert scene.obstacle(hidden) == "selection or feedback"
    assert scene.obstacle(replace(hidden, rendered=True)) == IN_USE
    assert scene.obstacle(replace(PLAIN, obstacle="no colour is written")) == "no colour is written"


def test_a_taken_layer_is_whole() -> None:
    collector = LayerCollector()
    collector.add(PLAIN, TRIANGLE, CAMERA)
    first = collector.take()
    assert (first.fresh, first.over, first.lighting) == (True, False, None)
    ((batch, camera),) = first.items
    assert (batch.polygon_count, camera) == (1, CAMERA)
    assert not collector.pending and collector.take().items == ()
    collector.add(PLAIN, batch, CAMERA)
    second = collector.take()
    assert (second.fresh, second.over) == (False, True)
    collector.end_frame()
    assert (collector.take().fresh, collector.take().over) == (True, False)
