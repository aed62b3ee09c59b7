"""Style files: what they extend, options by feature, and the line of everything that is wrong."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from glshim_stylers.edge_mesh import EdgeMesh
from glshim_stylers.raskar import Raskar
from hypothesis import given
from hypothesis import strategies as st

from glshim.errors import StyleError
from glshim.styling import registry
from glshim.styling.colours import parse_colour
from glshim.styling.lookup import features, find
from glshim.styling.options import options_of
from glshim.styling.stylefiles import StyleFile
from glshim.styling.texts import parse_style

Write = Callable[..., str]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    def written(content: str, name: str = "mine.toml") -> str:
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(content)
        return str(path)

    return written


def test_tables_are_options_by_feature(write: Write) -> None:
    style = parse_style(write("""
        style = "edge_mesh"
        hidden = "dashed"
        ridge.on = false
        [contour]
        width = 4
        ink = "#203040"
        [valley]
        on = "off"
        angle = 200
        [boundary]
        on = false
        width = 7
        [smooth]
        on = true
        [texture]
        length = 40
        """))
    assert style == EdgeMesh(
        hidden="dashed", ridges=False, contour_width=4, contour_ink=parse_colour("#203040"),
        valleys=False, valley_angle=200, boundary=False, boundary_width=7, smooth=True,
        texture_length=40,
    )  # fmt: skip


@pytest.mark.parametrize("name", registry.names())
def test_every_option_of_two_words_and_every_switch_has_a_feature(name: str) -> None:
    styler = registry.load(name)
    options = options_of(styler)
    by_feature = features(options)
    for option in options:
        homes = [(f, r) for f, own in by_feature.items() for r, o in own.items() if o is option]
        switches = option.kind == "switch" or {"on", "off"} <= {*option.choices}
        assert bool(homes) == ("_" in option.name or switches)
        for feature, rest in homes:
            assert f"{feature}_{rest}" == option.name or rest == "on"
            assert find(styler, (feature, rest)) == option


def test_a_file_extends_a_look_a_style_text_and_another_file(write: Write) -> None:
    charcoal = parse_style("charcoal")
    write('extends = "charcoal"\ncontour_width = 9\n', "below/base.toml")
    style = parse_style(write('extends = "below/base.toml"\n[contour]\nink = "#ff0000"\n'))
    assert isinstance(style, EdgeMesh)
    assert style == parse_style("charcoal:contour_width=9,contour_ink=#ff0000") != charcoal
    assert parse_style(write('extends = "raskar"')) == Raskar()
    assert parse_style(write('extends = "raskar:ridges=off"')) == Raskar(ridges=False)


def test_all_files_of_a_style_are_named_also_where_one_is_broken(
    write: Write, tmp_path: Path
) -> None:
    mine = write('extends = "base.toml"')
    base = write('extends = "gone.toml"', "base.toml")
    files: list[Path] = []
    with pytest.raises(StyleError):
        parse_style(mine, files=files)
    assert files == [Path(mine), Path(base), tmp_path / "gone.toml"]


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ('style = "raskar"\nextends = "charcoal"', ":2: extends beside style (line 1)"),
        ('\nextends = "mine.toml"', ":2: extends mine.toml, which extends this file: a circle"),
        ('\nextends = "gone.toml"', ":2: cannot read style file"),
        ('\nextends = "charcol"', ":2: no style is called 'charcol': did you mean charcoal"),
        ('extends = "raskar:ridges=7"', ":1: ridges=7 is not allowed: give on, off"),
        ('style = "charcoal"', ':1: charcoal is a look: write extends = "charcoal"'),
        ('style = "raskar"\n[ridge]\n# here\nagle = 3', ":4: [ridge] of style 'raskar' has no "
         "'agle': did you mean angle?"),
        ('style = "raskar"\n[ridge]\n\nangle = 700', ":4: ridge_angle=700 is not allowed: give "
         "0..360 degrees"),
        ('style = "raskar"\n[rigde]\nangle = 3', ":3: style 'raskar' has no feature [rigde]: did "
         "you mean [ridge]?"),
        ('style = "raskar"\n[ink]\nred = 3', ":3: ink is an option, not a table"),
        ('style = "raskar"\n[ridge.angle]\nred = 3', ":2: ridge_angle={'red': 3} is not allowed"),
        ('style = "raskar"\nridge_width = 3\n[ridge]\nwidth = 4', ":4: ridge_width was given "
         "before (line 2)"),
        ('style = "raskar"\nridge.width = 3\nridge.widht = 4', ":3: [ridge] of style 'raskar' "),
        ('style = "raskar"\nridge = { width = 3,\tagle = 4 }', ":2: [ridge] of style"),
        ('style = "raskar"\n"ridge_width" = 300', ":2: ridge_width=300"),
        ('style = """\\\nraskar"""\nfill = [\n1,\n# no colour\n2]\n', ":3: fill=[1, 2]"),
        ('style = "raskar"\nink = """\nridges = 3"""\nridges = 3', ":2: ink="),
        ('style = "raskar"\n# ridges = 3\nfill = "none" # ridges = 3\r\nridges = 3',
         ":4: ridges=3"),
        ("style = 'raskar'\nridges = 1\nridges = 2", ":3:10: Cannot overwrite a value"),
        ('style = "raskar"\nfill = "none"\nink = #e8dcc8 # warm', ":3:7: text values need quotes: "
         'write ink = "#e8dcc8"'),
        ('style = "raskar"\nridges = off', ':2:10: text values need quotes: write ridges = "off"'),
        ('style = raskar', ':1:9: text values need quotes: write style = "raskar"'),
        ('style = "edge_mesh"\n[contours]\nwidth = 3', ":3: style 'edge_mesh' has no feature "
         "[contours]: did you mean [contour]?"),
        ('style = "edge_mesh"\n[boundaries]\nwidth = 3', ":3: style 'edge_mesh' has no feature "
         "[boundaries]: did you mean [boundary]?"),
        ("style = " + 600 * "[", ": "),
        ("frames = " + 6000 * "9", ": "),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_with_its_line(write: Write, content: str, says: str) -> None:
    path = write(content)
    with pytest.raises(StyleError) as caught:
        parse_style(path)
    assert str(caught.value).startswith(path + says)
    assert "\n" not in str(caught.value)


def test_a_fault_in_what_is_extended_names_both_places(write: Write) -> None:
    mine = write('# mine\nextends = "base.toml"')
    base = write('style = "raskar"\n\nridges = 3', "base.toml")
    with pytest.raises(StyleError) as caught:
        parse_style(mine)
    assert str(caught.value) == (
        f"{base}:3: ridges=3 is not allowed: give on, off (extended by {mine}:2)"
    )


def test_a_circle_of_two_is_named(write: Write) -> None:
    mine = write('extends = "base.toml"')
    base = write('extends = "./mine.toml"', "base.toml")
    with pytest.raises(StyleError, match="a circle") as caught:
        parse_style(mine)
    assert f"{base}:1" in str(caught.value)
    assert f"{mine}:1" in str(caught.value)


def test_a_byte_order_mark_is_no_fault(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_bytes(b'\xef\xbb\xbfstyle = "raskar"\r\nridges = false\r\n')
    assert parse_style(str(path)) == Raskar(ridges=False)


lines = st.sampled_from(["", "# a = 1", "  ", "x = 2 # a = 3", "y = [\n 1, # a =\n 2]",
                         'z = """\na = 5\n"""', "w = {a = 1}"])  # fmt: skip


@given(st.lists(lines, unique=True), st.lists(lines, unique=True))
def test_a_line_is_found_whatever_stands_around_it(before: list[str], after: list[str]) -> None:
    after = [line for line in after if line not in before]
    first = "\n".join(before)
    content = "\n".join([*before, "a = 1", *after])
    expected = first.count("\n") + 2 if before else 1
    assert StyleFile(Path("x"), content, {}).line(("a",)) == expected
