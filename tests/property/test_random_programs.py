"""Random programs run plain and under a style: pixels, gets, errors and exceptions are equal."""

from __future__ import annotations

import os
import pickle
import tempfile
from pathlib import Path

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.differential.world import App, run

from .calls import Step, play, programs

FUZZ = int(os.environ.get("PROPERTY_EXAMPLES", "0"))
"""How many random programs; 0: a short run that is the same every time."""
LAST = Path(tempfile.gettempdir(), "glshim-fuzz.pickle")
"""What ran last, when a long run crashes."""
AT_LENGTH = settings(
    max_examples=FUZZ or 120, derandomize=not FUZZ, deadline=None, database=None,
    suppress_health_check=list(HealthCheck),
)  # fmt: skip


def equal(program: list[Step], style: str, pictures: bool) -> None:
    """Hold a run in the style to the plain one. At length, what runs is written down first: a
    driver that crashes takes the process with it."""

    def scene(app: App) -> None:
        play(app, program)

    _note(program, "plain")
    plain = run(scene)
    _note(program, style)
    found = plain.differences(run(scene, style), pictures=pictures)
    if found and plain.differences(run(scene)):
        return  # Mesa reads what was never set: two plain runs differ
    assert found == {}


def _note(program: list[Step], style: str) -> None:
    if FUZZ:
        LAST.write_bytes(pickle.dumps((style, program)))


@AT_LENGTH
@given(programs())
def test_none_is_plain_to_the_byte(program: list[Step]) -> None:
    equal(program, "none", pictures=True)


@AT_LENGTH
@given(programs(), st.sampled_from(("raskar", "raskar:ridges=off")))
def test_raskar_changes_nothing_but_the_picture(program: list[Step], style: str) -> None:
    equal(program, style, pictures=False)
