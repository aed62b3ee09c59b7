"""``glshim check-style`` finds what is wrong with stylers: each of these has one fault."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from glshim import parse_style
from glshim.checks import values, window
from glshim.checks.finding import Finding, finding
from glshim.errors import StyleError

PAGE = Path(__file__).parents[2] / "docs" / "guide" / "writing_a_styler.md"


def styler_of_the_page() -> str:
    return PAGE.read_text().split("```python\n")[1].split("```")[0]


GOOD = styler_of_the_page()
RETURN = "        return [Pass(layer.bodies"
BEFORE = "    def draws(self"


def findings(folder: Path, text: str, title: str = "") -> list[Finding]:
    """Of the checks whose titles hold the words."""
    path = folder / "my_style.py"
    path.write_text(text)
    styler = parse_style(f"{path}:Glow")
    checks = (*values.CHECKS, *window.CHECKS)
    return [finding(check, styler) for check in checks if title in check.title]


@pytest.mark.gl
def test_the_styler_of_the_page_holds_up(tmp_path: Path) -> None:
    assert [str(found) for found in findings(tmp_path, GOOD) if found.wrong] == []


@pytest.mark.gl
@pytest.mark.parametrize(
    ("old", "new", "title", "says"),
    [
        (RETURN, "        uniforms['sharpness'] *= len(SEEN)\n        SEEN.append(1)\n" + RETURN,
         "equal layers", "other draws a second time (number 1 of 1)"),
        (RETURN, "        import time\n        uniforms['sharpness'] = time.perf_counter()\n"
         + RETURN, "equal layers", "other draws"),
        (RETURN, "        layer.items[0][0].positions[0] = 7\n" + RETURN, "the layer is left",
         "changes the layer's PolygonBatch.positions"),
        (RETURN, "        layer.items[0]\n" + RETURN, "odd layers",
         "an empty layer makes it raise IndexError"),
        (RETURN, "        if self.sharpness == 8: raise RuntimeError('eight')\n" + RETURN,
         "every setting", "with sharpness=8 it raises RuntimeError: eight"),
        (RETURN, "        return [3]\n" + RETURN, "draws are plain", "it draws 3"),
        (RETURN, "        return None\n" + RETURN, "draws are plain", "draws() gives None"),
        (RETURN, "        uniforms['ink'] = (float('nan'),) * 3\n" + RETURN, "draws are plain",
         "uniform ink is (nan, nan, nan)"),
        (RETURN, "        uniforms['projection'] = 1.0\n" + RETURN, "uniforms",
         "a uniform 'projection', which is glshim's own"),
        (RETURN, "        uniforms['sharpnes'] = 1.0\n" + RETURN, "uniforms",
         "'sharpnes' that it does not have"),
        (RETURN, "        del uniforms['ink']\n" + RETURN, "uniforms",
         "declares a uniform 'ink' that no draw sets"),
        ("low=0.5, high=8", "low=0.5", "options have", "option sharpness has no range"),
        ('help="colour of the light"', 'help=" "', "options have", "option ink has no help"),
        (BEFORE, "    def __post_init__(self):\n        pass\n" + BEFORE, "options have",
         "is taken, although only"),
        (BEFORE, "    def __post_init__(self):\n        super().__post_init__()\n"
         "        object.__setattr__(self, 'sharpness', 3.0)\n" + BEFORE, "options have",
         "becomes 3.0"),
        (BEFORE, "    surface = 'blue'\n" + BEFORE, "draws are plain", "its surface is 'blue'"),
        (BEFORE, "    wants_polygons: ClassVar[bool] = False\n" + BEFORE, "draws are plain",
         "it wants no polygons"),
        (BEFORE, "    def __eq__(self, other): return False\n    __hash__ = None\n" + BEFORE,
         "frozen dataclass", "not equal"),
        ("colour = vec4(ink, 1.0)", "colour = vec5(ink, 1.0)", "compile", "vec5"),
        ('"ink": self.ink', '"ink": 1.0', "compile", "as given: "),
        (RETURN, "        from OpenGL import GL\n        GL.glLineWidth(7)\n" + RETURN,
         "state, errors", "GL_LINE_WIDTH"),
        (RETURN, "        if layer.items[0][1].viewport[0] > 0: 1 / 0\n" + RETURN,
         "state, errors", "is switched off"),
    ],
)  # fmt: skip
def test_a_fault_is_found_and_told(
    tmp_path: Path, old: str, new: str, title: str, says: str
) -> None:
    assert old in GOOD
    text = "SEEN = [1]\n" + GOOD.replace(old, new, 1)
    (found,) = findings(tmp_path, text, title)
    assert says in found.wrong
    assert found.advice


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("class Glow(Styler)", "class Glow(Styler", "my_style.py:1"),
        ("class Glow(Styler)", "class Glw(Styler)", "there is no class 'Glow': did you mean Glw?"),
        ("class Glow(Styler)", "class Glow", "Glow is not a styler: derive it from glshim.Styler"),
        ("@dataclass(frozen=True)", "", "is not a dataclass: write @dataclass(frozen=True)"),
        ("@dataclass(frozen=True)", "@dataclass", "cannot inherit non-frozen dataclass"),
        ('    name: ClassVar[str] = "glow"\n', "", 'has no name: write name: ClassVar[str] = '),
        ("def draws(", "def drawn(", "has no method draws(self, layer)"),
        (BEFORE, "    count: int = 3\n" + BEFORE, "has a field 'count' that is not an option"),
        (BEFORE, "    count: int\n" + BEFORE, "non-default argument 'count' follows"),
        ("option(2.0,", "option(20.0,", "'sharpness' whose default is not allowed: sharpness=20"),
        ("option(2.0, help", "option(2.0, hlep", "TypeError: option() "),
        ("GLOW = MeshShader", "import gone\nGLOW = MeshShader", "No module named 'gone'"),
        ("GLOW = MeshShader", "raise SystemExit(3)\nGLOW = MeshShader", "SystemExit: 3"),
        (BEFORE, "    def __post_init__(self):\n        1 / 0\n" + BEFORE,
         "Glow() raises ZeroDivisionError: division by zero"),
    ],
)  # fmt: skip
def test_a_file_that_holds_no_styler_gives_one_line_with_its_place(
    tmp_path: Path, old: str, new: str, says: str
) -> None:
    assert old in GOOD
    path = tmp_path / "my_style.py"
    path.write_text(GOOD.replace(old, new, 1))
    with pytest.raises(StyleError) as caught:
        parse_style(f"{path}:Glow")
    line = str(caught.value)
    assert says in line
    assert "\n" not in line
    numbered = line.startswith(f"{path}:") and line.removeprefix(f"{path}:")[0].isdigit()
    assert numbered or "no class" in says


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("my_style.py", "names no class: write my_style.py:MyStyle"),
        ("gone.py:Glow", "gone.py': No such file"),
        ("my_style.py:Glow:sharpnes=3", "style 'glow' has no option 'sharpnes': did you mean"),
        ("my_style.py:Glow:sharpness=30", "sharpness=30.0 is not allowed: give 0.5..8"),
        ("my_style.py:Glow:sharpness", "has no value: write sharpness=2"),
        ("my_style.py:Styler", "Styler has no name"),
        ("my_style.py:dataclass", "dataclass is not a styler"),
    ],
)
def test_a_wrong_text_gives_one_clear_line(tmp_path: Path, text: str, says: str) -> None:
    (tmp_path / "my_style.py").write_text(GOOD)
    with pytest.raises(StyleError) as caught:
        parse_style(text, str(tmp_path))
    assert says in str(caught.value)
    assert "\n" not in str(caught.value)


def test_options_come_after_the_class_and_in_style_files(tmp_path: Path) -> None:
    (tmp_path / "my_style.py").write_text(GOOD)
    style = parse_style("my_style.py:Glow:sharpness=3,ink=#ff0000", str(tmp_path))
    assert (style.sharpness, style.ink) == (3.0, (1.0, 0.0, 0.0))  # type: ignore[attr-defined]
    (tmp_path / "mine.toml").write_text('style = "my_style.py:Glow"\n\nsharpness = 5\n')
    assert parse_style("mine.toml", str(tmp_path)).sharpness == 5.0  # type: ignore[attr-defined]
    (tmp_path / "mine.toml").write_text('style = "my_style.py:Glow"\n\nsharpness = 50\n')
    with pytest.raises(StyleError, match=r"mine\.toml:3: sharpness=50"):
        parse_style("mine.toml", str(tmp_path))
    (tmp_path / "mine.toml").write_text('\nstyle = "my_style.py:Glo"\n')
    with pytest.raises(StyleError, match=r"mine\.toml:2: .*there is no class 'Glo'"):
        parse_style("mine.toml", str(tmp_path))


@pytest.mark.programs
def test_a_driver_that_goes_down_is_a_finding(tmp_path: Path) -> None:
    path = tmp_path / "my_style.py"
    path.write_text(GOOD.replace(RETURN, "        import os; os.kill(os.getpid(), 11)\n" + RETURN))
    done = subprocess.run(
        [sys.executable, "-m", "glshim", "check-style", f"{path}:Glow"],
        capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert "killed by signal 11" in done.stdout


@pytest.mark.programs
def test_the_command_tells_all_of_a_good_style_on_a_screen_of_its_own(tmp_path: Path) -> None:
    path = tmp_path / "my_style.py"
    path.write_text(GOOD)
    done = subprocess.run(
        [sys.executable, "-m", "glshim", "check-style", "--headless", f"{path}:Glow"],
        capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    lines = done.stdout.splitlines()
    assert len(lines) == 1 + len(values.CHECKS) + len(window.CHECKS)
    assert all(line.startswith("ok ") for line in lines)
