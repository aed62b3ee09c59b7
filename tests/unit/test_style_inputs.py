"""Style texts, style files and variables with any content: one clear line, at once."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from glshim.control.keys import KEYS
from glshim.errors import StyleError
from glshim.running import environment
from glshim.running.shots.plan import Plan
from glshim.styling import fromfile, registry
from glshim.styling.options import options_of
from glshim.styling.protocol import Styler
from glshim.styling.stylefiles import StyleFile
from glshim.styling.texts import MOST_FILES, parse_style
from glshim.system.reading import MOST_BYTES
from tests import sweep

MOST_SECONDS = 2.0
fuzz = settings(
    max_examples=10_000 if sweep.FULL else 300, deadline=None, derandomize=not sweep.FULL,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)  # fmt: skip


def refused(text: str, **more: Any) -> str:
    """The one line that refuses a style text, quickly; empty: it is taken."""
    begin = time.monotonic()
    try:
        assert isinstance(parse_style(text, **more), Styler)
        line = ""
    except StyleError as error:
        line = str(error)
        assert line and line.isprintable() and len(line) <= 1100
    assert time.monotonic() - begin < MOST_SECONDS
    return line


@pytest.mark.parametrize("name", ["odd.toml", "odd.py"])
@pytest.mark.parametrize("kind", ["FIFO", "directory", "device", "circle"])
def test_what_is_not_a_regular_file_is_refused(tmp_path: Path, name: str, kind: str) -> None:
    path = tmp_path / name
    if kind == "FIFO":
        os.mkfifo(path)
    elif kind == "directory":
        path.mkdir()
    else:
        path.symlink_to("/dev/zero" if kind == "device" else path)
    text = str(path) + (":Mine" if name.endswith(".py") else "")
    extends = tmp_path / "extends.toml"
    extends.write_text(f'\nextends = "{text}"')
    line, extended = refused(text), refused(str(extends))
    assert line.startswith(f"cannot read style file {str(path)!r}: ")
    assert extended.startswith(f"{extends}:2: {line}")


@pytest.mark.parametrize("name", ["large.toml", "large.py"])
def test_a_large_file_is_refused(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text("#" * MOST_BYTES + "\n")
    assert "larger than 256 KiB" in refused(str(path) + (":A" if name.endswith("py") else ""))


def test_a_long_chain_of_files_is_refused_and_a_shorter_one_is_not(tmp_path: Path) -> None:
    for number in range(400):
        (tmp_path / f"c{number}.toml").write_text(f'extends = "c{number + 1}.toml"')
    (tmp_path / "c400.toml").write_text('style = "raskar"')
    assert f"more than {MOST_FILES} style files" in refused(str(tmp_path / "c0.toml"))
    assert refused(str(tmp_path / f"c{401 - MOST_FILES}.toml")) == ""
    (tmp_path / "c400.toml").write_text('extends = "c399.toml"')
    assert "a circle" in refused(str(tmp_path / "c399.toml"))


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b'# ...\nextends = "a\\u0000.toml"', ":2: 'a\\x00.toml' is not a style"),
        (b'style = "a\\u0000.py:B"', ":1: 'a\\x00.py:B' is not a style"),
        (b'style = "raskar"\ntexture = "a\\u0000.png"', ":2: texture=a\\x00.png: "),
        (b'style = "raskar"\ntexture = "~a\\u0000/b.png"', ":2: texture=~a\\x00/b.png: "),
        (b'style = "raskar"\ntexture = "' + b"a" * 9999 + b'.png"', ":2: texture=aaa"),
        (b'extends = "' + b"a" * 9999 + b'.toml"', ":1: cannot read style file"),
        (b'style = "' + b"a" * 9999 + b'.py:B"', ":1: cannot read style file"),
        (b'style = "' + b"a" * 9999 + b'"', ":1: no style is called"),
        (b'style = "raskar"\n' + b"a" * 9999 + b" = 1", ":2: style 'raskar' has no option"),
        (b'style = "raskar"\nsilhouette_width = 0x' + b"f" * 9999, ":2: contour_width=a int"),
        (b'style = "raskar"\nsilhouette_width = nan', ":2: contour_width=nan is not allowed"),
        (b'style = "raskar"\n"\\u001b[2J" = 1', ":2: style 'raskar' has no option '\\x1b[2J'"),
        (b'style = "raskar"\n' + b"a." * 9999 + b"a = 1", ": a key has more than 16 parts"),
        (b'style = "raskar"\n' + b'"a" . ' * 9999 + b"a = 1", ": a key has more than 16 parts"),
        (b'style = "raskar"\nridges = """' + b"\n" * 99999 + b'"""', ":2: ridges="),
        (b'style = "raskar"\nridges = [' + b"1,\n" * 9999 + b"]", ":2: ridges=[1, 1, 1,"),
        (b'style = """' + b'\\"""' * 50_000, ":1:"),
        (b"style = " + b'\\"' * 99_999, ":1:"),
        (b"a" * 200_000, ":1:"),
        (b"a " * 100_000, ":1:"),
        (b"[[a]]\n" * 40_000, ": a style file names its style"),
        (b"a=[" * 50_000, ":"),
        (b"a={b=" * 40_000, ":"),
        (b'style = "raskar"\n' + b"# c\n" * 6000 + b"silhouette_widht = 3", ":6002: style "),
    ],
    ids=lambda value: str(value[:24]) if isinstance(value, bytes) else "",
)  # fmt: skip
def test_odd_content_is_refused_with_its_line(tmp_path: Path, content: bytes, says: str) -> None:
    path = tmp_path / "mine.toml"
    path.write_bytes(content)
    line = refused(str(path))
    assert line.startswith(f"{path}{says}"), line


@pytest.mark.parametrize("content", [b"\xff\xfes\x00", b"\xed\xa0\x80", b'a = "\x80"'])
def test_what_is_not_utf_8_is_refused(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "mine.toml"
    path.write_bytes(content)
    assert "cannot read style file" in refused(str(path))


@pytest.mark.parametrize("content", ["\0", "(" * 5000, "x = 1" * 3, "raise SystemExit", "A = 1"])
def test_odd_python_files_are_refused(tmp_path: Path, content: str) -> None:
    path = tmp_path / "mine.py"
    path.write_text(content)
    assert refused(f"{path}:A").startswith(str(path))


def test_python_files_are_not_run_with_rights_of_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "mine.py"
    path.write_text("raise AssertionError('run')")
    monkeypatch.setattr(fromfile, "has_elevated_rights", lambda: True)
    assert refused(f"{path}:A") == (
        f"{path}: Python files are not run in a setuid or setgid program"
    )


TEXTS = st.text(max_size=30) | st.sampled_from([
    *registry.names(), *registry.looks(), "raskar:ridges=off", "mine.toml", "./mine.toml",
    "/dev/zero", "\0", "~", "\ud800", "a.py", "a.py:B", "..", "a\0.toml", "/proc/self/mem.toml",
])  # fmt: skip
WORDS = st.sampled_from(sorted({
    part for name in registry.names() for option in options_of(registry.load(name))
    for part in (option.name, *option.name.split("_", 1), *option.choices)
})) | st.text(max_size=12)  # fmt: skip
SIMPLE = (
    st.integers(-(10**30), 10**30) | st.floats() | st.booleans() | WORDS | TEXTS
    | st.sampled_from(["0x" + "f" * 500, "1e999", "[" * 90 + "]" * 90, "1979-05-27", "07:32:00"])
)  # fmt: skip


def toml(value: object) -> str:
    """A value as TOML; some are written already."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(toml, value))}]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{toml(k)} = {toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, str) and value[:2] not in ("0x", "1e", "[[", "19", "07"):
        escaped = "".join(
            c if c.isalnum() and c.isascii() else f"\\U{ord(c):08x}" for c in value
        )
        return f'"{escaped}"'
    return str(value)


VALUES = st.recursive(
    SIMPLE, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(WORDS, inner, max_size=3),
    max_leaves=6,
)  # fmt: skip
LINES = (
    st.tuples(st.sampled_from(["style", "extends"]), TEXTS).map(lambda t: f"{t[0]} = {toml(t[1])}")
    | st.tuples(WORDS, VALUES).map(lambda kv: f"{toml(kv[0])} = {toml(kv[1])}")
    | st.tuples(WORDS, WORDS, VALUES).map(lambda t: f"{toml(t[0])}.{toml(t[1])} = {toml(t[2])}")
    | WORDS.map(lambda word: f"[{toml(word)}]") | WORDS.map(lambda word: f"[[{toml(word)}]]")
    | st.text(max_size=20).map(lambda text: "# " + text)
)  # fmt: skip


@fuzz
@given(st.lists(LINES, max_size=6), st.sampled_from(registry.names()))
def test_files_of_toml_are_taken_or_refused_with_their_place(
    tmp_path: Path, lines: list[str], name: str
) -> None:
    path = tmp_path / "mine.toml"
    content = "\n".join([f'style = "{name}"', *lines])
    path.write_bytes(content.encode("utf-8", "surrogatepass"))
    line = refused(str(path))
    assert not line or str(path) in line


@fuzz
@given(st.sampled_from(registry.names()), st.data())
def test_options_of_a_style_take_or_refuse_any_value(
    tmp_path: Path, name: str, data: st.DataObject
) -> None:
    """Files that are valid TOML and name options that there are, flat and by feature."""
    options = {option.name: option for option in options_of(registry.load(name))}
    names = st.sampled_from(sorted(options)) if options else st.just("none")
    flat, tables = [], []
    for each in data.draw(st.lists(names, max_size=4, unique=True)):
        own = [st.integers(-1, 400), st.floats(-1.0, 400.0), VALUES]
        if each in options:
            option = options[each]
            words = (option.show(option.default), *option.choices)
            own.append(st.sampled_from(words))
        value = toml(data.draw(st.one_of(own)))
        feature, _, rest = each.partition("_")
        if rest and data.draw(st.booleans()) and f"[{feature}]" not in tables:
            tables += [f"[{feature}]", f"{rest} = {value}"]
        else:
            flat.append(f"{each} = {value}")
    path = tmp_path / "mine.toml"
    content = "\n".join([f'style = "{name}"', *flat, *tables])
    path.write_bytes(content.encode("utf-8", "surrogatepass"))
    line = refused(str(path))
    assert not line or line.startswith(f"{path}:")


@fuzz
@given(st.binary(max_size=200) | st.lists(LINES, max_size=4).map(
    lambda lines: "\n".join(lines).encode("utf-8", "surrogatepass")))  # fmt: skip
def test_files_of_anything_are_taken_or_refused(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "mine.toml"
    path.write_bytes(content)
    line = refused(str(path))
    assert not line or str(path) in line


@fuzz
@given(
    TEXTS | st.tuples(TEXTS, st.lists(st.tuples(WORDS, SIMPLE), max_size=3)).map(
        lambda t: f"{t[0]}:" + ",".join(f"{key}={value}" for key, value in t[1]))
)  # fmt: skip
def test_texts_are_taken_or_refused(tmp_path: Path, text: str) -> None:
    refused(text, folder=str(tmp_path))


@fuzz
@given(st.lists(LINES, min_size=1, max_size=8), st.data())
def test_the_line_of_a_key_is_that_of_its_statement(
    lines: list[str], data: st.DataObject
) -> None:
    """As the slow way finds it: the first line up to which the file holds the key."""
    from glshim.styling.stylefiles import _holds, tomllib

    content = "\n".join(lines)
    try:
        table = tomllib.loads(content)
    except (ValueError, RecursionError):
        return
    keys = [(key, *([*value][:1] if isinstance(value, dict) else [])) for key, value in
            table.items()]  # fmt: skip
    if not keys:
        return
    key = data.draw(st.sampled_from(keys))
    expected = begin = 0
    whole = content.split("\n")
    for end in range(1, len(whole) + 1):
        try:
            part = tomllib.loads("\n".join([*whole[:end], ""]))
        except ValueError:
            continue
        if _holds(part, key):
            expected = begin + 1
            break
        begin = end
    assert StyleFile(Path("mine.toml"), content, table).line(key) == expected


ODD = [
    "", " ", "\n", "9" * 5000, "-1", "0", "x" * 100_000, "é\u202e", "\udcff", "a\nb", "/", ".",
    "%0999999999d.png", "%d%d.png", ".png", "a/.png", "%d", "%", "x" * 251 + ".png",
    "é" * 200 + ".png", "%0" + "9" * 5000 + "d.png", "on", "cycle=" + "F" * 9999,
    "cycle=shift+" * 99, "a,b;c:d=e,,,;;", "fins,fill=cel", "{}", "[" * 9999, '{"size": []}',
    "a\nb.toml", "a\nb.py:C", "~nobody/x", "~", "٣", "0" * 999 + "1", "0" * 5000 + "1",
]  # fmt: skip


def check_variables(variables: dict[str, str]) -> environment.Settings:
    begin = time.monotonic()
    settings, complaints = environment.read(variables, "/started/here")
    for line in complaints:
        assert line.isprintable() and len(line) < 1200
    assert len({line.partition(":")[0] for line in complaints}) == len(complaints)
    assert time.monotonic() - begin < MOST_SECONDS
    return settings


@pytest.mark.parametrize("variable", [each.name for each in environment.VARIABLES])
@pytest.mark.parametrize("text", ODD, ids=lambda text: ascii(text)[:20])
def test_odd_variables_get_a_line_at_most(variable: str, text: str) -> None:
    found = check_variables({KEYS: "on", variable: text})
    if found.style:
        refused(found.style)


@pytest.mark.parametrize(
    "text", ["%0999999999d.png", ".png", "a/.png", "x" * 251 + ".png", "é" * 200 + ".png",
             "%0" + "9" * 5000 + "d.png", "%d%d.png", "\n"],
    ids=lambda text: ascii(text)[:20],
)  # fmt: skip
def test_odd_captures_are_refused(text: str) -> None:
    with pytest.raises(StyleError):
        environment.parse_capture(text)


@fuzz
@given(st.dictionaries(st.sampled_from([each.name for each in environment.VARIABLES]),
                       st.text(st.characters(exclude_characters="\0"), max_size=60)
                       | st.sampled_from(ODD)))  # fmt: skip
def test_any_variables_get_a_line_at_most(variables: dict[str, str]) -> None:
    check_variables(variables)


@fuzz
@given(st.text(max_size=60) | st.sampled_from(ODD) | st.builds(
    '{{"output": {}, "frame": {}, "size": {}, "scale": {}, "tile": {}}}'.format,
    *[st.sampled_from(['"a.png"', "1", "null", "[1, 2]", "-1", '""', "{}", "1e999"])] * 5))
def test_plans_of_shots_are_taken_or_refused(text: str) -> None:
    try:
        Plan.of_text(text)
    except StyleError as error:
        assert str(error).isprintable()
