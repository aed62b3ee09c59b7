"""What is installed: stylers and looks of other packages, and entry points that lead nowhere."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from glshim_stylers.raskar import Raskar

from glshim.errors import StyleError, UnknownNameError
from glshim.styling import registry
from glshim.styling.descriptions import of_look
from glshim.styling.texts import parse_style


@pytest.fixture(autouse=True)
def fresh() -> Iterator[None]:
    """What is installed is looked for anew, here and after."""
    registry.forget()
    yield
    registry.forget()
    for name in [name for name in sys.modules if name.partition(".")[0] == "inks"]:
        del sys.modules[name]


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder on Python's path with a distribution ``inks``, which has one look."""
    described = tmp_path / "inks-1.0.dist-info"
    described.mkdir()
    (described / "METADATA").write_text("Metadata-Version: 2.1\nName: inks\nVersion: 1.0\n")
    points(tmp_path, "[glshim.looks]\ninks = inks.looks\n")
    looks = tmp_path / "inks" / "looks"
    looks.mkdir(parents=True)
    (looks.parent / "__init__.py").write_text("")
    (looks / "red_ink.toml").write_text('# Lines in red.\nstyle = "raskar"\nink = "#ff0000"\n')
    monkeypatch.syspath_prepend(str(tmp_path))
    return tmp_path


def points(site: Path, text: str) -> None:
    (site / "inks-1.0.dist-info" / "entry_points.txt").write_text(text)
    registry.forget()


def test_a_package_of_others_brings_looks(site: Path) -> None:
    assert {"red_ink", "charcoal"} <= set(registry.looks())
    assert list(registry.looks()) == sorted(registry.looks())
    assert parse_style("red_ink:ridges=off") == Raskar(ridges=False, ink=(1.0, 0.0, 0.0))
    assert of_look("red_ink").startswith("red_ink: Lines in red.\n")
    with pytest.raises(UnknownNameError, match="did you mean red_ink"):
        parse_style("redink")
    mine = site / "mine.toml"
    mine.write_text('extends = "red_ink"\nridges = false\n')
    assert parse_style(str(mine)) == parse_style("red_ink:ridges=off")


def test_a_folder_of_looks_needs_no_init_and_is_not_imported(site: Path) -> None:
    assert "red_ink" in registry.looks()
    assert "inks.looks" not in sys.modules
    (site / "inks" / "looks" / "__init__.py").write_text("1 / 0")
    registry.forget()
    assert "red_ink" in registry.looks()


def test_a_name_is_a_styles_first_and_then_the_first_look(site: Path) -> None:
    for name in ("raskar", "charcoal"):
        (site / "inks" / "looks" / f"{name}.toml").write_text('style = "fins"\n')
    assert parse_style("raskar") == Raskar()
    assert parse_style("charcoal").name == "fins"  # the folder comes first on the path


@pytest.mark.parametrize("value", ["inks.gone", "gone.looks", "inks", "math", "inks looks"])
def test_looks_that_are_not_there_are_said_once(
    site: Path, value: str, capsys: pytest.CaptureFixture[str]
) -> None:
    points(site, f"[glshim.looks]\n{value.replace(' ', '_')} = {value}\n")
    assert parse_style("charcoal").name == "edge_mesh"
    for _ in range(2):
        assert "red_ink" not in registry.looks()
        with pytest.raises(UnknownNameError):
            parse_style("red_ink")
    said = capsys.readouterr().err
    assert said.count("\n") == (0 if value == "inks" else 1)  # a package that holds no file
    assert not said or f"({value}) cannot be found" in said


def test_without_entry_points_names_are_unknown(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "entry_points", lambda group: ())
    for name in ("charcoal", "raskar"):
        with pytest.raises(UnknownNameError, match=f"no style is called '{name}': "):
            parse_style(name)


@pytest.mark.parametrize(
    ("value", "says"), [("gone:Style", "cannot be loaded: No module"), ("math:pi", "is not a ")]
)
def test_a_styler_that_is_not_there_says_where_it_should_be(
    site: Path, value: str, says: str
) -> None:
    points(site, f"[glshim.stylers]\ndots = {value}\n")
    with pytest.raises(StyleError, match=says) as caught:
        registry.load("dots")
    assert f"style 'dots' ({value})" in str(caught.value)
