"""Another output is plugged in beside or in place of the OpenGL picture, and needs no OpenGL."""

from __future__ import annotations

from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from glshim_stylers.cartoon import Cartoon
from glshim_stylers.raskar import Raskar

from glshim import pipeline
from glshim.errors import RenderError
from glshim.model.camera import Camera
from glshim.outputs.gl.picture import Picture
from glshim.outputs.output import WINDOW, Destination, Output
from glshim.sources.following.layers import FinishedLayer
from glshim.styling.lines import Lines
from glshim.styling.options import option
from glshim.styling.passes import Pass
from glshim.styling.protocol import Styler
from tests import look


class Noted(Output):
    """Writes down what it gets."""

    def __init__(self) -> None:
        self.heard: list[Any] = []

    def set_styler(self, styler: Styler | None) -> None:
        self.heard.append(("styler", styler))

    def add(self, given: Any, layer: Any, destination: Destination, context: Any) -> None:
        self.heard.append((list(given), layer, destination))

    def frame_ends(self) -> None:
        self.heard.append("frame ends")


class Refusing(Output):
    def add(self, given: Any, layer: Any, destination: Destination, context: Any) -> None:
        raise RenderError("not here")


FINISHED = FinishedLayer(
    ((look.cube(), Camera(np.eye(4), look.perspective(), (0, 0, 64, 48))),),
    over=False, bare=(), fresh=True, lighting=None,
)  # fmt: skip


@pytest.fixture(autouse=True)
def _no_opengl(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pipeline, "light", lambda: (0.0, 0.0, 1.0, 0.0))
    monkeypatch.setattr(pipeline, "say_unstyled", lambda text: None)


def scene() -> Any:
    return SimpleNamespace(unpainted="")


def test_an_output_gets_the_lines_and_passes_of_a_layer_and_the_ends_of_frames() -> None:
    output = Noted()
    followed = pipeline.Pipeline([output])
    for styler in (Raskar(), Cartoon()):
        followed.use_style(styler)
        followed.layer_ends(FINISHED, scene())
    followed._frame_over()
    assert output.heard[0] == ("styler", Raskar())
    lines, layer, destination = output.heard[1]
    assert [type(each) for each in lines] == [Lines] and destination is WINDOW
    assert layer.items == FINISHED.items
    assert any(isinstance(each, Pass) for each in output.heard[3][0])
    assert output.heard[-1] == "frame ends"


def test_every_output_gets_all_and_only_refusals_of_all_leave_a_scene_unpainted() -> None:
    one, other = Noted(), Noted()
    followed = pipeline.Pipeline([one, Refusing(), other])
    followed.use_style(Raskar())
    here = scene()
    followed.layer_ends(FINISHED, here)
    assert len(one.heard) == len(other.heard) == 2 and here.unpainted == ""
    alone = pipeline.Pipeline([Refusing()])
    alone.use_style(Raskar())
    alone.layer_ends(FINISHED, here)
    assert here.unpainted == "not here"


@dataclass(frozen=True)
class Sized(Styler):
    """Says how wide its lines are."""

    width: float = option(3.0, help="", low=0.0, high=10.0, unit="px")

    def draws(self, layer: Any) -> Any:
        return [(self.width, layer.scale)]


def test_a_larger_drawable_enlarges_the_style_and_tells_the_outputs(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(pipeline, "_count", lambda given: 1)
    output = Noted()
    followed = pipeline.Pipeline([output])
    followed.use_style(Sized())
    tile = Destination((100.0, 0.0), 8.0, (512, 512), double_buffered=True)
    followed.draw_into(tile)
    followed.layer_ends(FINISHED, scene())
    assert output.heard[-1][::2] == ([(24.0, 8.0)], tile)
    assert followed.styler == Sized()
    followed.draw_into(WINDOW)
    followed.layer_ends(FINISHED, scene())
    assert output.heard[-1][::2] == ([(3.0, 1.0)], WINDOW)


def test_the_picture_is_an_output() -> None:
    assert all(isinstance(output, Output) for output in pipeline.OUTPUTS)
    assert isinstance(pipeline.OUTPUTS[0], Picture)
