"""What every styler and every look keeps to: the checks of ``glshim check-style``, and what
holds of glshim's own beside them."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from PIL import Image

from glshim import parse_style
from glshim.checks import values
from glshim.checks.finding import Check, finding
from glshim.checks.layers import usual
from glshim.styling import registry
from glshim.styling.protocol import Styler
from glshim.styling.textures import MADE


@pytest.fixture(params=registry.names())
def styler(request) -> type[Styler]:
    return registry.load(request.param)


SWEEPS = values.CHECKS[-2:]
"""Those that go through all settings: the same for a look as for its style."""


def checked() -> Iterator[object]:
    """Pairs of a style and a check."""
    for check in values.CHECKS:
        for style in (*registry.names(), *(() if check in SWEEPS else registry.looks())):
            yield pytest.param(style, check, id=f"{style}-{check.title}")


@pytest.mark.parametrize(("style", "check"), [*checked()])
def test_it_keeps_to_what_check_style_asks(style: str, check: Check) -> None:
    found = finding(check, parse_style(style))
    assert not found.wrong, str(found)


def test_it_is_found_under_its_own_name(styler: type[Styler]) -> None:
    assert styler.name in registry.names()
    assert registry.load(styler.name) is styler


@pytest.mark.parametrize("texture", [*MADE, "a picture"])
def test_textured_draws_are_pure_too(texture, tmp_path):
    if texture == "a picture":
        texture = str(tmp_path / "line.png")
        Image.new("RGB", (8, 4), (200, 10, 10)).save(texture)
    one, make = usual(), registry.load("raskar")
    first, second = (list(make(texture=texture).draws(one)) for _ in range(2))
    assert first == second
    (one,), (again,) = first, second
    assert one.medium.image is not None
    assert one.medium.image is again.medium.image


def test_a_styler_that_wants_no_polygons_draws_nothing(styler: type[Styler]) -> None:
    assert bool(list(styler().draws(usual()))) == styler.wants_polygons
