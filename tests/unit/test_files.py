"""Files: what is read, what is written beside and renamed, and what is never overwritten."""

from __future__ import annotations

import itertools
import os
import socket
import stat
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from PIL import Image

from glshim.control import pictures
from glshim.errors import StyleError
from glshim.outputs.gl.frame import grab
from glshim.styling.pictures import read_image
from glshim.system import reading as files
from glshim.system.reading import MOST_BYTES, read_small
from glshim.system.writing import add_picture, picture_target, write_picture

RED, BLUE = Image.new("RGB", (4, 3), "red"), Image.new("RGB", (4, 3), "blue")
ENDINGS = {"toml": "", "py": ":Mine"}


@pytest.fixture(params=["FIFO", "socket", "directory"])
def odd(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Path]:
    """Something that is not a regular file."""
    path = tmp_path / "odd"
    with socket.socket(socket.AF_UNIX) as server:
        if request.param == "FIFO":
            os.mkfifo(path)
        elif request.param == "directory":
            path.mkdir()
        else:
            server.bind(str(path))
        yield path


def test_only_small_regular_files_are_read(odd: Path, tmp_path: Path) -> None:
    begin = time.monotonic()
    for path in (odd, Path("/dev/zero")):
        with pytest.raises(OSError, match="not a regular file"):
            read_small(path)
    with pytest.raises(StyleError, match="not a regular file"):
        read_image(str(odd))
    assert time.monotonic() - begin < 5.0
    large = tmp_path / "large"
    large.write_bytes(b"#" * MOST_BYTES)
    assert len(read_small(large)) == MOST_BYTES
    large.write_bytes(b"#" * (MOST_BYTES + 1))
    with pytest.raises(OSError, match="larger than 256 KiB"):
        read_small(large)


def test_a_picture_replaces_a_picture_and_nothing_else(odd: Path, tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    write_picture(path, RED)
    path.chmod(0o640)
    write_picture(path, BLUE)
    assert Image.open(path).getpixel((0, 0)) == (0, 0, 255)
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    RED.save(path, "JPEG")
    write_picture(path, RED)
    path.write_bytes(b"")
    write_picture(path, RED)
    path.write_text("my thesis")
    with pytest.raises(OSError, match="remove it first"):
        write_picture(path, RED)
    assert path.read_text() == "my thesis"
    with pytest.raises(OSError, match="not a regular file"):
        write_picture(odd, RED)
    assert {each.name for each in tmp_path.iterdir()} == {"a.png", "odd"}


def test_a_new_file_has_the_mode_that_the_program_gives_its_files(tmp_path: Path) -> None:
    write_picture(tmp_path / "a.png", RED)
    (tmp_path / "b").touch()
    assert (tmp_path / "a.png").stat().st_mode == (tmp_path / "b").stat().st_mode


def test_a_link_is_followed_in_its_folder_alone(tmp_path: Path) -> None:
    (tmp_path / "below").mkdir()
    inside, outside = tmp_path / "below" / "in.png", tmp_path / "out.png"
    outside.touch()
    link = tmp_path / "below" / "link.png"
    for target in (outside, tmp_path / "to_come.png", Path("/dev/null"), link):
        link.symlink_to(target)
        with pytest.raises(OSError):
            write_picture(link, RED)
        link.unlink()
    assert outside.read_bytes() == b""
    link.symlink_to("in.png")
    write_picture(link, RED)
    assert link.is_symlink() and not inside.is_symlink()
    assert Image.open(inside).size == (4, 3)
    folder = tmp_path / "linked"
    folder.symlink_to("below")  # folders are those that were asked for
    write_picture(folder / "b.png", RED)
    assert picture_target(folder / "b.png") == folder / "b.png"


def test_a_picture_that_cannot_be_written_leaves_the_old_one(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    write_picture(path, RED)
    before = path.read_bytes()
    with pytest.raises(OSError):
        write_picture(path, Image.new("CMYK", (4, 3)))
    with pytest.raises(OSError):
        add_picture(tmp_path / "b.png", Image.new("CMYK", (4, 3)))
    assert path.read_bytes() == before
    assert [each.name for each in tmp_path.iterdir()] == ["a.png"]


def test_a_new_picture_takes_no_name_that_is_there(odd: Path, tmp_path: Path) -> None:
    link = tmp_path / "link.png"
    link.symlink_to(tmp_path / "nowhere.png")
    for path in (odd, link):
        with pytest.raises(FileExistsError):
            add_picture(path, RED)
    assert not (tmp_path / "nowhere.png").exists()


@pytest.fixture
def writer(monkeypatch: pytest.MonkeyPatch) -> Iterator[pytest.MonkeyPatch]:
    """Frames without OpenGL."""
    monkeypatch.setattr(pictures, "grab", lambda size, framebuffer: RED)
    yield monkeypatch


def captured(pattern: Path, capsys: pytest.CaptureFixture[str], frames: int = 3) -> list[str]:
    writes = grab.FrameWriter(str(pattern), lambda: RED, itertools.count(1).__next__)
    for _ in range(frames):
        writes.write()
    return capsys.readouterr().err.splitlines()


@pytest.mark.usefixtures("writer")
def test_captures_keep_to_it_and_say_so_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert captured(tmp_path / "new" / "f%03d.png", capsys) == []
    assert sorted(each.name for each in (tmp_path / "new").iterdir()) == [
        "f001.png", "f002.png", "f003.png"
    ]  # fmt: skip
    (tmp_path / "%d").mkdir()  # only the last one is the number
    assert captured(tmp_path / "%d" / "f%d.png", capsys, frames=1) == []
    assert (tmp_path / "%d" / "f1.png").exists()
    text = tmp_path / "text.png"
    text.write_text("mine")
    (tmp_path / "link.png").symlink_to("/dev/null")
    (tmp_path / "folder.png").mkdir()
    os.mkfifo(tmp_path / "fifo.png")
    names = ["text.png", "link.png", "folder.png", "fifo.png", "text.png/a.png", "a\nb/text.png"]
    (tmp_path / "a\nb").mkdir()
    (tmp_path / "a\nb" / "text.png").write_text("mine")
    names.append("x" * 300 + ".png")
    for name in names:
        (line,) = captured(tmp_path / name, capsys)
        assert line.startswith("glshim: cannot write") and "no more frames" in line
    assert text.read_text() == "mine"


@pytest.mark.usefixtures("writer")
def test_saved_pictures_keep_to_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], writer: pytest.MonkeyPatch
) -> None:
    writer.setattr(pictures.frames, "drawable_size", lambda: (4, 3))
    saver = pictures.Pictures(str(tmp_path))
    saver.save("x" * 5000)
    saver.save("raskar")
    assert len(list(tmp_path.glob("*.png"))) == 2
    pictures.Pictures(str(tmp_path / ("y" * 300))).save("raskar")
    lines = capsys.readouterr().err.splitlines()
    assert [line.startswith("glshim: saved") for line in lines] == [True, True, False]
    writer.setattr(pictures, "has_elevated_rights", lambda: True)
    saver.save("raskar")
    assert "setuid" in capsys.readouterr().err
    assert len(list(tmp_path.glob("*"))) == 2


def test_rights_that_the_user_has_not_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not files.has_elevated_rights()
    for name in ("geteuid", "getegid"):
        with monkeypatch.context() as changed:
            changed.setattr(os, name, lambda: 12345)
            assert files.has_elevated_rights()
