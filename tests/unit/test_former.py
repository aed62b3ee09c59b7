"""Stylers as they were written for version 0.1: they go on working, or are told what to write."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

import glshim
from glshim import (
    HEADLIGHT,
    BackFaces,
    Body,
    Choice,
    Criterion,
    Draw,
    Features,
    Layer,
    Lines,
    Medium,
    MeshShader,
    Pass,
    Primitives,
    Shader,
    Sieve,
    State,
    StyleError,
    Weld,
    notices,
    parse_style,
)
from glshim.checks.layers import camera, cube, usual

SHADER, MESH = Shader("old", "", "", 4), MeshShader("old", "", "")
BODIES = usual().bodies


@pytest.fixture(autouse=True)
def silence(capsys: pytest.CaptureFixture[str]) -> None:
    notices.forget("")


def said(capsys: pytest.CaptureFixture[str]) -> str:
    return capsys.readouterr().err


def test_a_draw_is_lines_of_one_batch(capsys: pytest.CaptureFixture[str]) -> None:
    batch, seen, uniforms = cube(), camera(), {"size": 1.0}
    old = Draw(batch, seen, Choice(silhouettes=True), SHADER, uniforms, sheet=3)
    assert isinstance(old, Lines)
    assert old.bodies == (Body((batch,), seen),)
    assert (old.medium, old.coat) == (Medium(SHADER, uniforms), 3)
    assert "write Lines(layer.bodies, choice, Medium(shader, uniforms))" in said(capsys)


def test_choices_by_their_places(capsys: pytest.CaptureFixture[str]) -> None:
    assert Choice(False, None, 4.0) == Choice(valley_angle=4.0)  # type: ignore[misc]
    assert Features(True, 2.0, 4.0, True) == Features(  # type: ignore[misc]
        contours=True, ridge_angle=2.0, valley_angle=4.0, marked=True
    )
    assert said(capsys).count("\n") == 2
    with pytest.raises(TypeError):
        Choice(True, 1.0, 2.0, True, True, None, 7)  # type: ignore[misc]


def test_a_flat_pass(capsys: pytest.CaptureFixture[str]) -> None:
    criterion, state = Criterion("either", 1.0, 0.1), State(depth="always")
    old = Pass(  # type: ignore[call-overload, misc]
        MESH, BODIES, "edges", "quads", 2, copies=3, state=state, sieve=Sieve(1), least=4.0,  # type: ignore[arg-type]
        creases=criterion, tolerance=0.5, sheet=-1,
    )  # fmt: skip
    assert old == Pass(
        BODIES, MESH, "edges", Primitives("quads", 2, 3), state=state, light=HEADLIGHT,
        sieve=Sieve(1, shortest=4.0), weld=Weld(0.5, criterion), coat=-1,
    )  # fmt: skip
    assert "write Pass(bodies, shader, element" in said(capsys)
    assert replace(old, coat=2).coat == 2
    assert said(capsys) == ""
    with pytest.raises(TypeError, match="unexpected keyword argument 'colour'"):
        Pass(MESH, BODIES, "surface", colour=1)  # type: ignore[call-arg, arg-type]


def test_back_faces_of_a_batch(capsys: pytest.CaptureFixture[str]) -> None:
    batch, seen, ink = cube(), camera(), (0.0, 0.0, 0.0)
    new = BackFaces((Body((batch,), seen),), 2.0, ink, smooth=False)
    assert said(capsys) == ""
    assert BackFaces(batch, seen, 2.0, ink, smooth=False) == new  # type: ignore[arg-type, call-arg]
    assert "write BackFaces(layer.bodies" in said(capsys)


def test_bodies_of_a_layer_were_a_function() -> None:
    layer = usual()
    assert glshim.bodies(layer) is layer.bodies


OLD = """
from dataclasses import dataclass
from typing import ClassVar
from glshim import Choice, Draw, Layer, Pass, Shader, Styler, bodies, option
@dataclass(frozen=True)
class Old(Styler):
    name: ClassVar[str] = "old"
    size: float = option(3.0, help="s", low=1, high=9)
    def draws(self, layer: Layer) -> "list[Draw | Pass]":
        assert len(bodies(layer)) == 1
        return [Draw(batch, camera, Choice(True, None), Shader("s", "", "", 4), {"size": self.size})
                for batch, camera in layer.items]
"""


def test_a_whole_styler_of_then(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "old.py").write_text(OLD)
    drawn = list(parse_style("old.py:Old:size=2", str(tmp_path)).draws(usual()))
    assert [len(one.bodies[0].batches) for one in drawn] == [1, 1]  # type: ignore[union-attr]
    assert said(capsys).count("\n") == 2


def test_a_light_is_given_to_what_needs_one() -> None:
    lit = MeshShader("lit", "", "", needs=("light",))
    with pytest.raises(StyleError, match=r"light=layer\.light, or light=HEADLIGHT"):
        Pass(BODIES, lit, "surface")
    assert Pass(BODIES, lit, "surface", light=HEADLIGHT).light == (0.0, 0.0, 1.0, 0.0)
    with pytest.raises(StyleError, match=r"shader 'x' needs 'app_color': did you mean app_colour"):
        MeshShader("x", "", "", needs=("app_color",))
    shown = MeshShader("shown", "void main() { rest(1); }", "uniform sampler2D app_colour;")
    assert shown.needs == {"app_colour", "rest"}


def test_bodies_keep_the_order_of_drawing() -> None:
    from glshim.styling.values import in_order

    one, other = camera(), camera((1.0, 2.0, 3.0))
    first, second, third = cube(), cube(0.5), cube(0.1)
    layer = Layer(((first, one), (second, other), (third, one)))
    assert [body.batches for body in layer.bodies] == [(first, third), (second,)]
    assert in_order(layer.bodies) == list(layer.items)
    assert in_order(layer.bodies[:1]) == [(first, one), (third, one)]
    assert layer.bodies is layer.bodies


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("from glshim.styling.protocol import Draw, Layer", "write from glshim import Draw, Layer"),
        ("from glshim.geometry.strokes.lines import Choice", "write from glshim import Choice"),
        ("from glshim.geometry.strokes.chains import Pattern", "write from glshim import Pattern"),
        ("from glshim.geometry.strokes.feature_lines import Features as F",
         "write from glshim import Features"),
        ("from glshim.assembly.batch import PolygonBatch", "write from glshim import PolygonBatch"),
        ("import glshim.geometry.camera",
         "what was glshim.geometry.camera is in glshim.model.camera now"),
        ("from glshim.geometry.strokes.lines import RECORD", "is in glshim.model.lines now"),
        ("from glshim.render.passes.runner import Runner", "is in glshim.outputs.gl now"),
        ("from stylers.strokes import made", "write from glshim import made"),
        ("from stylers.gone import Raskar", "what was stylers is in glshim_stylers now"),
        ("from glshim.gone import away", "what stylers need is imported from glshim itself"),
        ("import elsewhere", "No module named 'elsewhere'"),
    ],
)  # fmt: skip
def test_an_import_of_then_is_told_what_it_is_now(tmp_path: Path, line: str, says: str) -> None:
    (tmp_path / "old.py").write_text(f"import glshim\n{line}\n")
    with pytest.raises(StyleError) as caught:
        parse_style("old.py:Old", str(tmp_path))
    told = str(caught.value)
    assert told.startswith(f"{tmp_path / 'old.py'}:2: ")
    assert says in told and "\n" not in told
    assert ("glshim" in told) == ("elsewhere" not in told)
