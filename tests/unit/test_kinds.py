"""Options by feature, alike in every style that draws lines, and the names that they had before."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from glshim_stylers.shared.kinds import SWITCHES, LineStyle

from glshim.errors import StyleError
from glshim.styling import descriptions, registry
from glshim.styling.options import options_of
from glshim.styling.texts import parse_style

PAGE = (Path(__file__).parents[2] / "docs" / "guide" / "line_options.md").read_text("utf-8")
LINED = [name for name in registry.names() if issubclass(registry.load(name), LineStyle)]
RED, BLUE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


def lined(text: str) -> LineStyle:
    style = parse_style(text)
    assert isinstance(style, LineStyle)
    return style


def test_all_styles_that_draw_lines_have_kinds() -> None:
    others = {"fur", "none", "shadow"}
    assert {*LINED} == {*registry.names()} - others


@pytest.mark.parametrize("name", LINED)
def test_every_style_names_its_lines_alike(name: str) -> None:
    style = lined(name)
    words = {option.name for option in options_of(type(style))}
    assert {"width", "ink", "dash", "texture", "texture_length", "crease_angle"} <= words
    assert {"contour", "ridge", "valley"} <= {*style.kinds()}
    for kind in style.kinds():
        own = {"width", "ink", "dash"} | ({"texture"} if f"{kind}_texture" in words else set())
        assert {f"{kind}_{part}" for part in own} | {SWITCHES[kind]} <= words
    old = {word for word in words if word.endswith(("_width", "_ink", "_angle"))}
    assert old <= {
        *(f"{kind}_{part}" for kind in style.kinds() for part in ("width", "ink")),
        "ridge_angle", "valley_angle", "crease_angle", "least_angle", "own_ink",
    }  # fmt: skip


@pytest.mark.parametrize("name", LINED)
def test_a_kind_is_as_all_lines_are_until_it_is_told(name: str) -> None:
    all_lines, ridges = "width=8,ink=red,dash=9", "ridges=on,ridge.ink=blue,ridge_width=3"
    style = lined(f"{name}:{all_lines},{ridges},contour.dash=0")
    looks = style.looks()
    assert looks["contour"].width == 8.0
    assert (looks["contour"].ink, looks["contour"].dash) == (RED, 0.0)
    assert (looks["ridge"].ink, looks["ridge"].width, looks["ridge"].dash) == (BLUE, 3.0, 9.0)
    assert lined(f"{name}:ridge.ink=blue,ridge.ink=auto").look("ridge").ink == lined(name).ink


@pytest.mark.parametrize("name", LINED)
def test_a_file_has_a_table_for_each_kind(name: str, tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(
        f'extends = "{name}"\ndash = 9\n[contour]\nink = "red"\nwidth = 4\n[ridge]\non = false\n'
        "[valley]\non = true\ndash = 0\n"
    )
    looks = lined(str(path)).looks()
    assert looks["contour"].ink == RED and looks["contour"].dash == 9.0
    assert "ridge" not in looks
    assert looks["valley"].dash == 0.0


@pytest.mark.parametrize("look", ["charcoal", "neon", "x_ray", "whiteboard", "stencil"])
def test_what_is_said_of_all_lines_undoes_what_a_look_says_of_some(look: str) -> None:
    assert {each.ink for each in lined(f"{look}:ink=red").looks().values()} == {RED}
    assert len({each.width for each in lined(f"{look}:width=3").looks().values()}) == 1
    mixed = lined(f"{look}:ridge.ink=blue,ink=red").looks()
    assert (mixed["ridge"].ink, mixed["contour"].ink) == (BLUE, RED)


def test_the_page_says_what_is_read(tmp_path: Path) -> None:
    """Every style file and every style text of it."""
    files = re.findall(r"```toml\n(.*?)```", PAGE, re.DOTALL)
    texts = re.findall(r"`(\w+(?:\+\w+)?:[^` ]+|\w+\+\w+)`", PAGE)
    assert len(files) >= 2 and len(texts) >= 6
    for number, content in enumerate(files):
        path = tmp_path / f"{number}.toml"
        path.write_text(content)
        parse_style(str(path))
    for text in texts:
        parse_style(text)


WIDTHS = {
    "raskar": (2.5, 2.5), "edge_mesh": (2.5, 2.5), "crease": (2.5, 2.5), "hiddenline": (1.5, 1.5),
    "technical": (2.5, 1.0), "cartoon": (3.0, 1.5), "blueprint": (1.6, 1.0), "sketch": (2.0, 2.0),
    "brush": (7.0, 0.7 * 7.0), "pencil": (2.6, 0.7 * 2.6), "fins": (4.0, 2.0),
    "two_pass": (5.0, 2.5),
}  # fmt: skip


@pytest.mark.parametrize("name", LINED)
def test_lines_are_as_wide_as_they_were(name: str) -> None:
    style = lined(name)
    assert (style.look("contour").width, style.look("ridge").width) == WIDTHS[name]


FORMER = {
    "raskar:silhouettes=off,silhouette_width=4": "raskar:contours=off,contour_width=4",
    "crease:silhouettes=off,silhouette_width=4": "crease:contours=off,contour_width=4",
    "crease:creases=off": "crease:ridges=off,valleys=off,boundary=off",
    "crease:crease_width=3,angle=30":
        "crease:ridge_width=3,valley_width=3,boundary_width=3,crease_angle=30",
    "fins:half_width=64": "fins:width=128",
    "hiddenline:line=red,polygons=blue": "hiddenline:ink=red,fill=blue",
    "technical:outline_width=4,line_width=2": "technical:contour_width=4,boundary_width=4,"
        "ridge_width=2,valley_width=2,intersection_width=2",
    "cartoon:outline_width=4": "cartoon:contour_width=4,boundary_width=4",
    "cartoon:line_width=0": "cartoon:ridges=off,valleys=off,intersections=off",
    "cartoon:line_width=0.2": "cartoon:ridge_width=0.5,valley_width=0.5,intersection_width=0.5",
    "blueprint:inner_width=2": "blueprint:ridge_width=2,valley_width=2,intersection_width=2",
    "brush:brush=charcoal1,layers=2": "brush:texture=charcoal1,strokes=2",
    "edge_mesh:crease_ink=red,border_width=3":
        "edge_mesh:ridge_ink=red,valley_ink=red,boundary_width=3",
}  # fmt: skip
"""Style texts with names of before, and what they say today."""


@pytest.mark.parametrize("old", FORMER)
def test_names_of_before_are_read(old: str, tmp_path: Path) -> None:
    today = parse_style(FORMER[old])
    assert parse_style(old) == today
    name, _, assignments = old.partition(":")
    pairs = dict(piece.split("=") for piece in assignments.split(","))
    numbers = {key: float(text) if text[0].isdigit() else text for key, text in pairs.items()}
    flags = {"on": True, "off": False}
    values = {key: flags.get(value, value) for key, value in numbers.items()}  # type: ignore[call-overload]
    assert registry.load(name)(**values) == today
    path = tmp_path / "old.toml"
    lines = (
        f"{key} = {value!r}" if not isinstance(value, bool) else f"{key} = {str(value).lower()}"
        for key, value in values.items()
    )
    path.write_text("\n".join((f'style = "{name}"', *lines)))
    assert parse_style(str(path)) == today


def test_names_of_before_have_tables_too(tmp_path: Path) -> None:
    path = tmp_path / "old.toml"
    path.write_text(
        'style = "raskar"\n[silhouette]\non = false\nwidth = 4\n[crease]\nink = "red"\nangle = 30\n'
    )
    assert parse_style(str(path)) == parse_style(
        "raskar:contours=off,contour_width=4,ridge_ink=red,valley_ink=red,crease_angle=30"
    )


@pytest.mark.parametrize("name", LINED)
def test_names_of_before_are_listed_nowhere(name: str) -> None:
    rows = descriptions.of_name(name).splitlines()[1:]
    listed = {row.split()[0] for row in rows if row[2] != " "}
    assert not listed & {*registry.load(name).former}


@pytest.mark.parametrize(
    ("text", "near"),
    [
        ("raskar:silhouete_width=3", "contour_width"),
        ("cartoon:outlinewidth=3", "contour_width"),
        ("fins:half_widht=3", "width"),
        ("technical:widht=3", "width"),
    ],
)
def test_a_word_near_a_name_of_before_is_told_todays(text: str, near: str) -> None:
    with pytest.raises(StyleError, match=rf"did you mean {near}\b"):
        parse_style(text)
