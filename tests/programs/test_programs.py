"""Programs that others wrote, and ours, run unmodified: plain, under `none`, under `raskar`."""

import pytest

from .catalog import PROGRAMS, Program
from .harness import PLAIN, Run, run
from .sources import SourceMissing, launch

VISIBLE = "raskar:ink=#e8641b"  # an ink that shows on black and on white


@pytest.fixture(scope="module", params=PROGRAMS, ids=lambda p: p.name)
def program(request: pytest.FixtureRequest) -> Program:
    chosen: Program = request.param
    try:
        launch(chosen)
    except SourceMissing as reason:
        pytest.skip(str(reason))
    return chosen


@pytest.fixture(scope="module")
def plain(program: Program, display: str) -> Run:
    result = run(program, PLAIN, display)
    assert not result.fault(), result.log
    assert not result.shimmed
    assert any(len(set(map(bytes, picture[::7, ::7].reshape(-1, 3)))) > 1
               for picture in result.pictures), "nothing was drawn"
    return result


def test_none_gives_the_plain_frames(program: Program, plain: Run, display: str) -> None:
    """Which says of two runs, too, that they are the same (`python -m tests.programs` asks)."""
    none = run(program, "none", display)
    assert not none.fault(), none.log
    assert none.shimmed, none.log
    assert none.log.count("Traceback") == plain.log.count("Traceback"), none.log
    assert none.same_as(plain), f"{none.changed_pixels(plain)} pixels differ\n{none.log}"


def test_raskar_leaves_lines(program: Program, plain: Run, display: str) -> None:
    styled = run(program, VISIBLE, display)
    assert not styled.fault(), styled.log
    assert styled.shimmed, styled.log
    assert styled.log.count("Traceback") == plain.log.count("Traceback"), styled.log
    changed = styled.changed_pixels(plain)
    if program.inked:
        assert changed > 50
    else:
        assert changed == 0
