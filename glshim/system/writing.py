"""The files that glshim writes: beside the target, then in its place.

Nothing here follows a link out of its folder, or overwrites what is not a picture of before; see
``docs/reference/security.md``.
"""

from __future__ import annotations

import os
import stat
from contextlib import suppress
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO

from glshim.system.modules import OURS_ALONE
from glshim.system.reading import open_regular

if TYPE_CHECKING:
    from collections.abc import Callable

    from PIL.Image import Image

PICTURES = (b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff")
"""How files begin that a picture may replace: PNG and JPEG."""
PAGES = (b"<!doctype html",)
"""How files begin that a page may replace."""
_numbers = count(1)


def picture_target(path: Path, beginnings: tuple[bytes, ...] = PICTURES) -> Path:
    """The file that writing to a path makes or replaces: the path, or for a symbolic link what it
    leads to in the same folder. Raises OSError where it leads elsewhere, or where something stands
    there that is neither empty nor begins as ``beginnings`` say."""
    target = path
    if path.is_symlink():
        target = Path(os.path.realpath(path))
        if target.parent != Path(os.path.realpath(path.parent)):
            raise OSError(f"it is a symbolic link to {target}, out of its folder")
    try:
        descriptor = open_regular(target, os.O_NOFOLLOW if os.name == "posix" else 0)
    except FileNotFoundError:
        return target
    with os.fdopen(descriptor, "rb") as file:
        begin = file.read(max(map(len, beginnings))).lower()
    if begin and not any(begin.startswith(each.lower()) for each in beginnings):
        raise OSError("the file there is not one that glshim could have written: remove it first")
    return target


def write_picture(path: Path, picture: Image, *, optimize: bool = False) -> None:
    """Write a PNG, in place of a picture of before (see `picture_target`); the folder has the old
    file or the whole new one. Raises OSError."""
    target = picture_target(path)
    _replace(target, _png(picture, optimize=optimize))


def write_html(path: Path, text: str) -> None:
    """Write an HTML page, in place of one of before. Raises OSError."""
    content = text.encode("utf-8")
    _replace(picture_target(path, PAGES), lambda file: file.write(content))


def write_text(path: Path, text: str, begin: bytes) -> None:
    """Write a text that begins so, in place of one of before. Raises OSError."""
    content = text.encode("utf-8")
    _replace(picture_target(path, (begin,)), lambda file: file.write(content))


def add_picture(path: Path, picture: Image) -> None:
    """Write a PNG to a new file. Raises FileExistsError where anything is there already, OSError
    where it cannot be written."""
    path.open("xb").close()  # the name is ours from here on; a link is not followed
    try:
        _replace(path, _png(picture))
    except BaseException:
        with suppress(OSError):
            path.unlink()
        raise


def _png(picture: Image, *, optimize: bool = False) -> Callable[[BinaryIO], None]:
    def write(file: BinaryIO) -> None:
        with OURS_ALONE:  # Pillow loads its modules for files now
            picture.save(file, "PNG", optimize=optimize)

    return write


def _replace(target: Path, write: Callable[[BinaryIO], object]) -> None:
    """Write a file beside the target and put it in its place."""
    # Not `tempfile`: its files are for their owner alone, and it draws from the program's luck.
    beside = target.with_name(f".glshim-{os.getpid()}-{next(_numbers)}.tmp")
    with suppress(FileNotFoundError):
        beside.unlink()  # of a process of that number that died
    try:
        with beside.open("xb") as file:
            write(file)
        with suppress(OSError):  # the mode of the file that it replaces
            beside.chmod(stat.S_IMODE(os.stat(target).st_mode))
        os.replace(beside, target)
    except BaseException:
        with suppress(OSError):
            beside.unlink()
        raise
