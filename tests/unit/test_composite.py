"""Styles that are put together: the surfaces of one, the lines of another."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from glshim_stylers.cartoon import Cartoon
from glshim_stylers.hiddenline import HiddenLine
from glshim_stylers.raskar import Raskar

from glshim.checks.layers import usual
from glshim.errors import StyleError
from glshim.styling import descriptions
from glshim.styling.composite import Composite, is_line
from glshim.styling.enlarging import enlarged
from glshim.styling.protocol import Styler
from glshim.styling.registry import names
from glshim.styling.texts import anchored, name_of, parse_style, split_styles

LINED = (
    "raskar", "edge_mesh", "edge_mesh:strokes=quads", "edge_mesh:outer=on", "crease", "fins",
    "hiddenline", "technical", "cartoon", "blueprint", "sketch", "brush", "pencil",
)  # fmt: skip


LAYER = usual()


def drawn(styler: Styler, *, lines: bool) -> list[Any]:
    return [draw for draw in styler.draws(LAYER) if is_line(draw) is lines]


def test_surfaces_are_of_the_first_and_lines_of_the_others() -> None:
    both = parse_style("cartoon:bands=2+hiddenline:width=4")
    one, other = Cartoon(bands=2), HiddenLine(width=4)
    assert both == Composite((one, other))
    assert both.name == "cartoon+hiddenline"
    assert both.surface == one.surface
    assert both.wants_lights and both.wants_normals
    assert drawn(both, lines=False) == drawn(one, lines=False)
    shaders = [draw.medium.uniforms["widths"] for draw in drawn(both, lines=True)]
    assert shaders == [draw.medium.uniforms["widths"] for draw in drawn(other, lines=True)]


@pytest.mark.parametrize("lines", LINED)
@pytest.mark.parametrize("surfaces", ["cartoon", "shadow", "none"])
def test_every_line_style_gives_its_lines_over_any_surfaces(surfaces: str, lines: str) -> None:
    both = parse_style(f"{surfaces}+{lines}")
    kinds = [is_line(draw) for draw in both.draws(LAYER)]
    assert kinds == sorted(kinds)  # surfaces first
    assert sum(kinds) == len(drawn(parse_style(lines), lines=True)) > 0


@pytest.mark.parametrize("over", ["shadow", "fur"])
def test_what_has_no_lines_lies_over_the_surfaces_of_the_first(over: str) -> None:
    both, first = parse_style(f"cartoon+{over}"), Cartoon()
    assert len(drawn(both, lines=True)) == len(drawn(first, lines=True))
    more = drawn(parse_style(over), lines=False)
    assert len(drawn(both, lines=False)) == len(drawn(first, lines=False)) + len(more)


def test_lines_go_with_none() -> None:
    assert drawn(parse_style("cartoon+none"), lines=True) == []
    assert drawn(parse_style("cartoon+none"), lines=False) == drawn(Cartoon(), lines=False)


def test_parts_share_no_coat() -> None:
    lines, surfaces = (
        {draw.coat for draw in drawn(parse_style("fur+crease"), lines=kind)}
        for kind in (True, False)
    )
    assert not lines & surfaces


def test_a_file_extends_several_and_gives_options_to_those_that_have_them(tmp_path: Path) -> None:
    mine = tmp_path / "mine.toml"
    mine.write_text(
        'extends = ["cartoon", "edge_mesh"]\nbands = 2\ntolerance = 0.5\n[contour]\nwidth = 7\n'
    )
    found = parse_style(str(mine))
    assert isinstance(found, Composite)
    cartoon, mesh = found.parts
    assert (cartoon.bands, cartoon.tolerance) == (2, 0.5)  # type: ignore[attr-defined]
    assert (mesh.contour_width, mesh.tolerance) == (7.0, 0.5)  # type: ignore[attr-defined]
    other = tmp_path / "other.toml"
    other.write_text('extends = "mine.toml+none"')
    assert parse_style(str(other)) == parse_style(f"{mine}+none")


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ('extends = ["cartoon", "edge_mesh"]\nbnads = 3', ":2: style 'cartoon' has no option "
         "'bnads': did you mean bands?"),
        ('extends = ["cartoon", "egde_mesh"]', ":1: no style is called 'egde_mesh': did you mean "
         "edge_mesh"),
        ('extends = ["cartoon", 3]', ":1: extends names its style as a text"),
        ('style = ["cartoon", "raskar"]', ':1: style names its style as a text: extends = ['),
        ('extends = "cartoon+mine.toml"', ":1: extends mine.toml, which extends this file"),
        ('extends = []', ":1: extends names its style as a text"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_with_its_line(tmp_path: Path, content: str, says: str) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(content)
    with pytest.raises(StyleError) as caught:
        parse_style(str(path))
    assert str(caught.value).startswith(f"{path}{says}")


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("cartoon+two_pass", "two_pass is not put together with other styles: its lines lie below"),
        ("cartoon+hidenline", "did you mean hiddenline"),
        ("cartoon+raskar:bands=2", "style 'raskar' has no option 'bands'"),
        ("+".join(9 * ["raskar"]), "more than 8 styles are put together"),
        ("cartoon+", "no style is called 'cartoon+': did you mean cartoon"),
    ],
)
def test_what_cannot_be_put_together_is_told(text: str, says: str) -> None:
    with pytest.raises(StyleError) as caught:
        parse_style(text)
    assert says in str(caught.value)


def test_a_path_may_hold_the_character(tmp_path: Path) -> None:
    folder = tmp_path / "c++"
    folder.mkdir()
    path = folder / "a+b.toml"
    path.write_text('style = "raskar"')
    assert parse_style(str(path)) == Raskar()
    assert parse_style(f"cartoon+{path}").name == "cartoon+raskar"
    with pytest.raises(StyleError, match="there is no picture"):
        parse_style("raskar:texture=a+b.png")


def test_texts_of_several_are_anchored_named_and_listed() -> None:
    assert anchored("cartoon+mine.toml", "/there") == "cartoon+/there/mine.toml"
    assert name_of("cartoon:bands=2+below/mine.toml") == "cartoon+mine"
    listed = ["cartoon:bands=2,rim=1+hiddenline:width=3,ink=red", "raskar+none"]
    assert split_styles(",".join(listed)) == listed
    first, more = descriptions.of_text("cartoon+hiddenline:width=3")
    assert first == "surfaces of cartoon, lines of hiddenline"
    assert "bands" in more and "crease_angle" in more


def test_lengths_grow_in_all_parts() -> None:
    larger = enlarged(parse_style("cartoon+hiddenline:width=3"), 2.0)
    assert isinstance(larger, Composite)
    assert larger.parts[1].width == 6.0  # type: ignore[attr-defined]


@pytest.mark.parametrize("name", [name for name in names() if name != "two_pass"])
def test_every_style_is_put_together_with_every_other(name: str) -> None:
    for other in ("raskar", "cartoon", "shadow", "none", "pencil"):
        for text in (f"{name}+{other}", f"{other}+{name}"):
            styler = parse_style(text)
            assert styler.name == text
            assert list(styler.draws(LAYER)) or "none" in text
