"""Options, the base class of stylers, and the registry."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

import pytest

from glshim.errors import StyleError, UnknownNameError
from glshim.styling import registry
from glshim.styling.colours import format_colour, parse_colour
from glshim.styling.options import options_of
from glshim.styling.protocol import Colour, Layer, Lines, Styler, option


@dataclass(frozen=True)
class Sample(Styler):
    name: ClassVar[str] = "sample"
    width: float = option(3.0, help="w", low=1, high=9, unit="px")
    on: bool = option(True, help="o")
    ink: Colour = option("#ff8000", help="i")
    fill: str | Colour = option("app", help="f", choices=("app", "none"), colour=True)
    mode: str = option("a", help="m", choices=("a", "b"))

    def draws(self, layer: Layer) -> Iterable[Lines]:
        return ()


def test_options_describe_themselves():
    found = {o.name: o for o in options_of(Sample)}
    assert [o.kind for o in found.values()] == [
        "number", "switch", "colour", "choice or colour", "choice"]  # fmt: skip
    assert found["width"].allowed == "1..9 px"
    assert found["fill"].allowed == "app, none, a colour name or #rrggbb"
    assert found["ink"].default == (1.0, 128 / 255, 0.0)
    for o in found.values():
        assert o.parse(o.show(o.default)) == o.default


@pytest.mark.parametrize("name, text, value", [
    ("width", "4", 4.0), ("width", " 1 ", 1.0), ("on", "off", False), ("on", "YES", True),
    ("ink", "#000000", (0.0, 0.0, 0.0)), ("fill", "none", "none"),
    ("fill", "#FFFFFF", (1.0, 1.0, 1.0)), ("mode", "b", "b"),
])  # fmt: skip
def test_texts_become_values(name, text, value):
    found = {o.name: o for o in options_of(Sample)}[name]
    assert found.parse(text) == value
    assert getattr(Sample(**{name: value}), name) == value


@pytest.mark.parametrize("name, text", [
    ("width", "0.5"), ("width", "10"), ("width", "nan"), ("width", "inf"), ("width", "wide"),
    ("on", "maybe"), ("ink", "blakc"), ("ink", "#12345"), ("fill", "flat"), ("mode", "c"),
    ("mode", "#ffffff"),
])  # fmt: skip
def test_bad_texts_name_the_option_and_what_is_allowed(name, text):
    found = {o.name: o for o in options_of(Sample)}[name]
    with pytest.raises(StyleError, match=name) as caught:
        found.parse(text)
    assert found.allowed in str(caught.value)


@pytest.mark.parametrize("bad", [
    {"width": True}, {"width": "4"}, {"width": 99}, {"on": 1}, {"ink": (2, 0, 0)}, {"ink": (0, 0)},
    {"fill": 3}, {"mode": (0, 0, 0)},
])  # fmt: skip
def test_bad_values_are_refused_at_construction(bad):
    with pytest.raises(StyleError, match=next(iter(bad))):
        Sample(**bad)


def test_whole_numbers_and_text_colours_are_welcome():
    assert Sample(width=4, ink="#0000ff", fill="#00ff00") == Sample(
        width=4.0, ink=(0.0, 0.0, 1.0), fill=(0.0, 1.0, 0.0)
    )


def test_colours_go_there_and_back():
    assert format_colour(parse_colour("#1a2b3c")) == "#1a2b3c"


def test_a_styler_must_draw():
    with pytest.raises(NotImplementedError):
        Styler().draws(Layer(()))


def test_registry_finds_our_own_and_suggests():
    assert {"none", "raskar"} <= set(registry.names())
    assert registry.load("raskar").name == "raskar"
    with pytest.raises(UnknownNameError, match="raskar") as caught:
        registry.load("rascar")
    assert caught.value.matches == ("raskar",)


@dataclass(frozen=True)
class Counting(Styler):
    name: ClassVar[str] = "counting"
    strokes: int = option(3, help="s", low=1, high=16)
    width: float = option(3, help="w", low=1, high=16)

    def draws(self, layer: Layer) -> Iterable[Lines]:
        return ()


def test_counts_are_whole_numbers():
    strokes, width = options_of(Counting)
    assert (strokes.kind, width.kind) == ("integer", "number")
    assert (strokes.allowed, width.allowed) == ("1..16, whole", "1..16")
    for given in (4, 4.0):
        made = Counting(strokes=given)
        assert (made.strokes, type(made.strokes)) == (4, int)
    assert [strokes.parse(text) for text in ("2", "2.0", "2e0")] == [2, 2, 2]
    assert strokes.show(strokes.default) == "3"
    assert type(Counting().width) is float and Counting(width=2.5).width == 2.5
    for bad in ("2.5", "0", "17", "many", "nan", "inf"):
        with pytest.raises(StyleError, match=r"strokes=.* is not allowed: give 1\.\.16, whole"):
            strokes.parse(bad)
    for value in (2.5, True, "3", float("nan")):
        with pytest.raises(StyleError, match="strokes"):
            Counting(strokes=value)
