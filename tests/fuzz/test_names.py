"""Names of objects, by the areas of programs that are about them alone: in compatibility and core
profiles, in contexts that share, with drivers that give names again and with others."""

from __future__ import annotations

import random
import sys
from collections.abc import Iterator
from contextlib import ExitStack

import pytest

from tests import sweep
from tests.fuzz.areas import names
from tests.fuzz.compare import Difference, differences
from tests.fuzz.lanes import Lane
from tests.fuzz.making import styles
from tests.fuzz.worker import PLAIN
from tests.fuzz.writing import Writer

MANY = 200 if sweep.FULL else 4
CORE = "CONTEXT_VERSION_MAJOR=4, CONTEXT_VERSION_MINOR=5, OPENGL_PROFILE=0x32001"
CUBE = ("GL.glUseProgram(0)", "GL.glBindVertexArray(0)", "GL.glBindProgramPipeline(0)",
        "GL.glClear(0x4100)", "GL.glEnable(GL.GL_DEPTH_TEST)", "GL.glRotatef(31, 1, 1, 0)",
        "GL.glBegin(GL.GL_QUADS)",
        "[GL.glVertex3f(0.6 * x, 0.6 * y, z) for z in (-0.3, 0.3)"
        " for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]",
        "GL.glEnd()")  # fmt: skip
GIVEN = {"least": {"force_gl_names_reuse": "true"}, "counted": {}}
"""Mesa from 23 on gives the least name that is free."""


def program(seed: int, *, core: bool, shared: bool) -> list[str]:
    """Frames that are drawn, and names between them."""
    w = Writer(random.Random(seed))
    w.odd = 0.0
    w.say(f"a = window({CORE if core else ''})")
    if shared:
        w.say(f"b = window(a{', ' + CORE if core else ''})", "use(a)")
    for _ in range(w.whole(2, 4)):
        for _ in range(w.whole(2, 6)):
            w.pick((names.names, names.names, names.program_names,
                    names.names if core else names.list_names))(w)  # fmt: skip
            if shared and w.maybe(0.3):
                w.say(w.pick(("use(a)", "use(b)")))
        w.say(*(CUBE[:4] if core else CUBE), "swap(False)")
    w.say("GL.glGetError()")
    return w.steps


@pytest.fixture(scope="module", params=sorted(GIVEN))
def lanes(request: pytest.FixtureRequest, display: str) -> Iterator[list[Lane]]:
    """Plain, none, and a style of the day."""
    if request.param == "least" and sys.platform != "linux":
        pytest.skip("only Mesa can be told how to give names")
    some = styles()
    with pytest.MonkeyPatch.context() as patch, ExitStack() as stack:
        patch.setenv("DISPLAY", display)
        for name, value in GIVEN[request.param].items():
            patch.setenv(name, value)
        found = [Lane(style, "") for style in (PLAIN, "none", "raskar")]
        found.append(Lane(some[sweep.SEED % len(some)], ""))
        for lane in found:
            stack.callback(lane.close)
        yield found


@pytest.mark.parametrize("shared", [False, True], ids=["alone", "shared"])
@pytest.mark.parametrize("core", [False, True], ids=["compatible", "core"])
def test_names_are_those_of_plain_opengl(lanes: list[Lane], core: bool, shared: bool) -> None:
    for seed in range(sweep.SEED, sweep.SEED + (MANY // 2 if core else MANY)):
        steps = program(seed, core=core, shared=shared)
        assert (seed, compared(lanes, steps)) == (seed, {})


def compared(lanes: list[Lane], steps: list[str]) -> dict[str, list[Difference]]:
    """Differences by style."""
    for lane in lanes:
        lane.ask(steps)
    plain, *others = (lane.answer() for lane in lanes)
    found = {
        lane.style: differences(steps, plain, other, "raskar")
        for lane, other in zip(lanes[1:], others, strict=True)
    }
    return {style: some for style, some in found.items() if some}


def test_a_name_that_is_ours_is_seen(display: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISPLAY", display)
    lanes = [Lane(PLAIN, ""), Lane("none", "")]
    try:
        one, other = (
            ["a = window()", f"GL.glGenTextures({number})", "GL.glGenTextures(1)"]
            for number in (1, 2)
        )
        plain, mine = lanes[0].play(one), lanes[1].play(other)
        assert [each.what for each in differences(one, plain, mine, "raskar")] != []
    finally:
        for lane in lanes:
            lane.close()
