"""Style texts, style files and the environment: what is read, and the line when it cannot be."""

from __future__ import annotations

from pathlib import Path

import pytest
from glshim_stylers.raskar import Raskar
from hypothesis import example, given
from hypothesis import strategies as st
from PIL import Image

from glshim.errors import StyleError, UnknownNameError
from glshim.styling import descriptions, registry
from glshim.styling.colournames import COLOUR_NAMES
from glshim.styling.colours import parse_colour
from glshim.styling.options import Option, options_of
from glshim.styling.protocol import Colour, Styler
from glshim.styling.registry import looks
from glshim.styling.texts import (
    changed,
    name_of,
    parse_style,
    split_styles,
)
from glshim.styling.textures import MADE


def test_a_name_gives_the_defaults() -> None:
    assert parse_style("raskar") == Raskar()


def test_values_are_numbers_colours_switches_and_words() -> None:
    text = " raskar : ridges=off, ridge_width=4.5 ,ink=#FF0080,fill=none,"
    expected = Raskar(ridges=False, ridge_width=4.5, ink=(1.0, 0.0, 128 / 255), fill="none")
    assert parse_style(text) == expected


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("rasker", "did you mean raskar? (glshim styles lists all)"),
        ("RASKAR", "did you mean raskar?"),
        ("zzzz", "no style is called 'zzzz': glshim styles lists all"),
        ("raskar:ridge_agle=3", "did you mean ridge_angle"),
        ("none:ridges=on", "no option 'ridges': it has none"),
        ("raskar:ridge_angle=361", "0..360 degrees"),
        ("raskar:ridge_angle=nan", "0..360 degrees"),
        ("raskar:ridge_angle=wide", "0..360 degrees"),
        ("raskar:ink=blakc", "did you mean black? Give a colour name or #rrggbb"),
        ("raskar:ridges=perhaps", "on, off"),
        ("raskar:fill=#12345", "give app, none, a colour name or #rrggbb"),
        ("raskar:ridges", "write ridges=on"),
        ("", "no style"),
        ("raskar:=3", "no option ''"),
        ("raskar:texture=dashy", "/dashy': No such file or directory; did you mean dashed?"),
        ("raskar:texture=away/line.png", "/away/line.png': No such file or directory; give none,"),
        ("raskar:texture=/", "'/': it is a directory, not a regular file"),
        ("raskar:texture=/dev/null", "it is a device, not a regular file; give none, dotted,"),
        ("raskar:texture=", "give none, dotted, dashed, pen, charcoal, "),
        ("raskar:texture_on=ridges", "silhouettes, all"),
    ],
)
def test_a_wrong_text_gives_one_clear_line(text: str, says: str) -> None:
    with pytest.raises(StyleError) as caught:
        parse_style(text)
    assert says in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("text", "colour"),
    [
        ("blue", (0.0, 0.0, 1.0)),
        ("RebeccaPurple", (0x66 / 255, 0x33 / 255, 0x99 / 255)),
        ("grey", (128 / 255,) * 3),
        ("#fff", (1.0, 1.0, 1.0)),
        ("#f80", (1.0, 0x88 / 255, 0.0)),
        ("#fffa", (1.0, 1.0, 1.0)),
        ("#ff8000ff", (1.0, 128 / 255, 0.0)),
    ],
)
def test_colours_have_names_and_a_short_form(text: str, colour: Colour) -> None:
    assert parse_style(f"raskar:ink={text},fill={text}") == Raskar(ink=colour, fill=colour)
    assert parse_colour(text) == colour == Raskar(ink=text).ink


def test_names_of_colours_are_those_of_css() -> None:
    assert len(COLOUR_NAMES) == 148
    assert all(len(digits) == 6 and int(digits, 16) >= 0 for digits in COLOUR_NAMES.values())
    for wrong in ("bleu", "#12", "#12345", "#fffffff", "", "# fff", "#ggg"):
        with pytest.raises(StyleError, match="is not a colour"):
            parse_colour(wrong)


def test_an_alpha_is_not_used_which_is_said_once(capsys: pytest.CaptureFixture[str]) -> None:
    for _ in range(2):
        parse_colour("#1234")
    assert capsys.readouterr().err.count("the alpha of #1234 is not used") == 1


def test_a_look_that_was_renamed_is_read_and_listed_nowhere() -> None:
    old = parse_style("hidden_line:width=3")
    assert old.name == "hiddenline"
    assert old.hidden == "dashed"  # type: ignore[attr-defined]
    assert "hidden_line" not in {*registry.names(), *looks()}


def test_an_unknown_name_carries_its_nearest_matches() -> None:
    with pytest.raises(UnknownNameError) as caught:
        parse_style("raskar:silhouete_width=2")
    assert caught.value.matches[0] == "contour_width"


@pytest.mark.parametrize("name", looks())
def test_a_look_is_a_style_file_that_comes_with_glshim(name: str) -> None:
    style = parse_style(name)
    assert style != type(style)()
    option = next(o for o in options_of(type(style)) if o.kind == "number")
    text = f" {name} : {option.name}={option.high:g},"
    assert parse_style(text) == changed(style, {option.name: option.high})
    title, text = descriptions.of_look(name).splitlines()
    assert title.startswith(f"{name}: ")
    assert parse_style(text) == style


def test_looks_are_not_styles_and_are_among_what_is_near() -> None:
    assert set(looks()) >= {"pen_and_ink", "charcoal", "anime", "watercolour"}
    assert len(looks()) >= 6 + 12
    assert not set(looks()) & set(registry.names())
    with pytest.raises(UnknownNameError, match="did you mean watercolour") as caught:
        parse_style("watercolor:ridges=off")
    assert caught.value.matches[0] == "watercolour"
    with pytest.raises(StyleError, match="style 'edge_mesh' has no option 'bands'"):
        parse_style("anime:bands=3")


def test_a_file_has_the_same_keys(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('style = "raskar"\nridges = false\nridge_width = 4\nink = "#ff0000"\n')
    assert parse_style(str(path)) == Raskar(ridges=False, ridge_width=4, ink=(1.0, 0.0, 0.0))


def test_a_file_may_write_a_switch_as_a_word(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('style = "raskar"\nridges = "off"\n')
    assert parse_style(str(path)) == Raskar(ridges=False)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ('style = "raskar"\n\nridge_agle = 3\n', "mine.toml:3: style 'raskar' has no option"),
        ('style = "raskar"\nridge_angle = 700\n', "mine.toml:2: ridge_angle=700"),
        ('style = "raskar"\nridge_angle = "wide"\n', "mine.toml:2: ridge_angle=wide"),
        ('style = "raskar"\nridges = 3\n', "mine.toml:2: ridges=3"),
        ('# mine\nstyle = "rasker"\n', "mine.toml:2: no style is called 'rasker'"),
        ("ridges = true\n", 'style = "raskar"'),
        ('style = "raskar"\nridges = \n', "mine.toml:2:10: Invalid value"),
        ("style = 3\n", "names its style"),
        ('style = "raskar"\nink = "a\\nb"\n', "mine.toml:2: ink=a b"),
    ],
)
def test_a_wrong_file_names_itself_and_the_line(tmp_path: Path, content: str, says: str) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(content)
    with pytest.raises(StyleError) as caught:
        parse_style(str(path))
    assert says in str(caught.value)
    assert "mine.toml" in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.fixture
def line(tmp_path: Path) -> Path:
    """A picture, in a folder beside which style files lie."""
    path = tmp_path / "brushes" / "line.png"
    path.parent.mkdir()
    Image.new("L", (8, 4), 90).save(path)
    return path


@pytest.mark.parametrize("name", ["none", *MADE])
def test_a_texture_is_a_word(name: str) -> None:
    assert parse_style(f"raskar:texture={name}") == Raskar(texture=name)


def test_a_texture_is_a_picture_whose_whole_path_is_kept(
    line: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(line.parent)
    for style in (
        parse_style("raskar:texture=line.png"),
        parse_style(f"raskar:texture={line}"),
        parse_style("raskar:texture=brushes/line.png", str(line.parent.parent)),
    ):
        assert style == Raskar(texture=str(line))


def test_a_picture_is_looked_for_beside_the_style_file(
    line: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = line.parent.parent / "mine.toml"
    path.write_text('style = "raskar"\ntexture = "brushes/line.png"\n')
    expected = Raskar(texture=str(line))
    assert parse_style(str(path)) == expected
    assert parse_style("mine.toml", str(path.parent)) == expected
    monkeypatch.chdir(path.parent)
    assert parse_style("mine.toml") == expected


def test_a_picture_missing_beside_a_style_file_is_named_with_the_line(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('style = "raskar"\n\ntexture = "gone.png"\n')
    with pytest.raises(StyleError) as caught:
        parse_style(str(path))
    assert f"{path}:3: texture=gone.png: there is no picture '{tmp_path}/gone.png'" in str(
        caught.value
    )


def test_a_broken_picture_is_refused(line: Path) -> None:
    whole = line.read_bytes()
    for broken in (b"", whole[:40], whole.replace(b"IDAT", b"IDOT")):
        line.write_bytes(broken)
        with pytest.raises(StyleError, match="as a picture"):
            parse_style(f"raskar:texture={line}")


def test_a_file_that_is_not_there_is_named() -> None:
    with pytest.raises(StyleError, match=r"'nowhere\.toml': No such file"):
        parse_style("nowhere.toml")


def test_a_file_takes_no_options_after_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.toml").write_text('style = "raskar"')
    with pytest.raises(StyleError, match="given alone"):
        parse_style("mine.toml:ridges=off")


@pytest.mark.parametrize(
    ("text", "name"),
    [("raskar", "raskar"), (" charcoal : paper=#ffffff", "charcoal"), ("a/mine.toml", "mine"),
     ("a/my_style.py:Glow:size=3", "Glow"), ("/x:y/my_style.py", "/x")],
)  # fmt: skip
def test_a_text_has_a_short_name(text: str, name: str) -> None:
    assert name_of(text) == name


@pytest.mark.parametrize(
    ("text", "styles"),
    [
        ("", []),
        (" ;, ", []),
        ("raskar", ["raskar"]),
        ("raskar, fins,", ["raskar", "fins"]),
        ("raskar;fins; ", ["raskar", "fins"]),
        ("none, raskar:ink=#000000,ridges=off,crease,watercolour",
         ["none", "raskar:ink=#000000,ridges=off", "crease", "watercolour"]),
        ("raskar:ridges=off, ink=#ff0000; fins", ["raskar:ridges=off,ink=#ff0000", "fins"]),
        ("raskar;fins:fill=cel,crease", ["raskar", "fins:fill=cel", "crease"]),
        ("none,raskar:ridges = off,ink = #ff0000,none:",
         ["none", "raskar:ridges = off,ink = #ff0000", "none:"]),
        ("raskar:,ridges=off", ["raskar:,ridges=off"]),
        ("a/mine.toml,my.py:Glow:size=3,ink=#ff0000,charcoal",
         ["a/mine.toml", "my.py:Glow:size=3,ink=#ff0000", "charcoal"]),
        ("my.py:Glow,my.py:Other", ["my.py:Glow", "my.py:Other"]),
        ("raskar,nosuch,fins", ["raskar", "nosuch", "fins"]),
        ("raskar,a=b.toml", ["raskar", "a=b.toml"]),
        ("raskar:ridges=off;a=b.toml", ["raskar:ridges=off", "a=b.toml"]),
    ],
)  # fmt: skip
def test_a_list_of_styles_is_parted_where_a_style_begins(text: str, styles: list[str]) -> None:
    assert split_styles(text) == styles
    assert split_styles(";".join(styles)) == styles


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("raskar,ridges=off", "ridges=off follows raskar: write raskar:ridges=off"),
        ("my.py:Glow,size=3", "size=3 follows my.py:Glow: write my.py:Glow:size=3"),
        ("a.toml, ink=#ff0000", "ink=#ff0000 follows a.toml: options go into the file"),
    ],
)
def test_options_of_no_style_say_what_to_write(text: str, says: str) -> None:
    with pytest.raises(StyleError) as caught:
        split_styles(text)
    assert str(caught.value) == says


@given(st.lists(st.sampled_from(["raskar", "fins:fill=cel", "a.toml", "m.py:Glow:size=3,ink=no",
                                 "charcoal:paper=#aabbcc,marked=on"]), max_size=6))  # fmt: skip
def test_a_list_of_valid_texts_reads_the_same_with_either_separator(styles: list[str]) -> None:
    assert split_styles(",".join(styles)) == split_styles("; ".join(styles)) == styles


def test_a_description_lists_every_option_with_range_and_default() -> None:
    text = descriptions.of_styler(registry.load("raskar"))
    listed = {line.split()[0]: line.split()[1:] for line in text.splitlines()}
    assert listed["crease_angle"][0] == "60"
    assert {option.name for option in options_of(Raskar) if not option.follows} <= {*listed}
    assert "[0..180 degrees]" in " ".join(text.split())
    assert "KIND_width, KIND_ink, KIND_texture, KIND_dash" in text
    assert all(len(line) <= 100 for line in text.splitlines())
    assert descriptions.of_styler(registry.load("none")).startswith("none: ")


@given(
    st.text()
    | st.builds(
        "raskar:{}={}".format,
        st.sampled_from(["ink", "ridges", "ridge_angle", "texture"]),
        st.text(),
    )
    | st.text().map("{}.toml".format)
)
@example("\0")
@example("\0.toml")
@example("x" * 5000)
@example("x" * 5000 + ".toml")
@example("raskar:ridge_angle=1e999")
def test_any_text_gives_a_style_or_one_line(text: str) -> None:
    try:
        assert isinstance(parse_style(text), Styler)
    except StyleError as error:
        assert str(error)
        assert len(str(error).splitlines()) == 1


def values(option: Option) -> st.SearchStrategy[object]:
    """Values of an option that its text can hold."""
    if option.kind == "number":
        whole = st.integers(int(option.low or 0) + 1, int(option.high or 0) - 1)
        return whole.map(lambda number: number / 2 + 0.5)
    if option.kind == "switch":
        return st.booleans()
    colours = st.tuples(*[st.integers(0, 255).map(lambda byte: byte / 255)] * 3)
    words = [st.sampled_from(option.choices)] if option.choices else []
    return st.one_of(*([colours] if "colour" in option.kind else []), *words)


@given(st.fixed_dictionaries({option.name: values(option) for option in options_of(Raskar)}))
def test_a_style_written_out_is_read_back(chosen: dict[str, object]) -> None:
    written = [f"{option.name}={option.show(chosen[option.name])}" for option in options_of(Raskar)]
    assert parse_style("raskar:" + ",".join(written)) == Raskar(**chosen)  # type: ignore[arg-type]


@pytest.mark.parametrize("strokes", ["thin", "quads", "half"])
def test_strokes_of_the_paper_refuse_angles_that_its_cosines_cannot_tell(strokes: str) -> None:
    for odd in ("ridge_angle=181", "valley_angle=179"):
        with pytest.raises(StyleError, match=f"strokes={strokes} takes a ridge_angle"):
            parse_style(f"edge_mesh:strokes={strokes},{odd}")
        parse_style(f"edge_mesh:{odd}")
    parse_style(f"edge_mesh:strokes={strokes},ridge_angle=180,valley_angle=180")
