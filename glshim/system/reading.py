"""The files that glshim reads: small regular ones. Nothing here waits, or opens a device; see
``docs/reference/security.md``.
"""

from __future__ import annotations

import os
import stat
from pathlib import Path

MOST_BYTES = 256 << 10
"""Size of a style file, at most."""
_KINDS = (
    (stat.S_ISDIR, "a directory"), (stat.S_ISFIFO, "a FIFO"), (stat.S_ISSOCK, "a socket"),
    (stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device"),
)  # fmt: skip


def has_elevated_rights() -> bool:
    """Whether the process has rights that its user does not have (setuid, setgid)."""
    if os.name != "posix":
        return False
    return os.getuid() != os.geteuid() or os.getgid() != os.getegid()


def read_small(path: Path, most: int = MOST_BYTES) -> bytes:
    """The bytes of a regular file that is not larger than ``most``. Never waits for a FIFO or a
    device. Raises OSError that says so, ValueError where the path cannot be one."""
    descriptor = open_regular(path)
    with os.fdopen(descriptor, "rb") as file:
        content = file.read(most + 1)
    if len(content) > most:
        raise OSError(f"it is larger than {most >> 10} KiB")
    return content


def require_regular(path: str | Path) -> os.stat_result:
    """What a regular file is like. Raises OSError for anything else."""
    found = os.stat(path)
    _require_regular(found)
    return found


def open_regular(path: Path, flags: int = 0) -> int:
    """A descriptor for reading a regular file. Raises OSError for anything else."""
    # Looked at before it is opened: opening a device can do something.
    _require_regular(os.lstat(path) if flags else os.stat(path))
    flags |= getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
    descriptor = os.open(path, os.O_RDONLY | flags)
    try:
        _require_regular(os.fstat(descriptor))  # it may be another one by now
    except BaseException:
        os.close(descriptor)
        raise
    return descriptor


def _require_regular(found: os.stat_result) -> None:
    if not stat.S_ISREG(found.st_mode):
        kind = next((name for test, name in _KINDS if test(found.st_mode)), "something else")
        raise OSError(f"it is {kind}, not a regular file")
