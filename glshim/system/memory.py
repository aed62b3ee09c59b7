"""The program's own memory, read so that an address which holds nothing is an answer, not a fault
of the process."""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Octets = NDArray[np.uint8]

_MOST = 1 << 30
"""Bytes; nobody draws more at once."""
_TOP = 1 << 63


def read(address: int, size: int) -> Octets | None:
    """(size,) a copy of what is in memory; None where not all of it may be read."""
    if not 0 <= size <= _MOST or not 0 < address < _TOP - _MOST:
        return None if size else np.empty(0, np.uint8)
    return _read(address, size)


def _copied(address: int, size: int) -> Octets | None:
    return np.frombuffer(ctypes.string_at(address, size), np.uint8)


def _reader() -> Callable[[int, int], Octets | None]:
    """Linux copies from a process by a call that fails where a plain copy would end the process.
    Elsewhere, and where a sandbox forbids that call, it is a plain copy."""
    if not sys.platform.startswith("linux"):
        return _copied
    try:
        copy = ctypes.CDLL(None).process_vm_readv
    except (OSError, AttributeError):
        return _copied
    copy.restype = ctypes.c_ssize_t
    vector = ctypes.c_size_t * 2  # struct iovec: an address and a size
    one, none = ctypes.c_ulong(1), ctypes.c_ulong(0)

    def read_own(address: int, size: int) -> Octets | None:
        found = np.empty(size, np.uint8)
        here = vector(found.__array_interface__["data"][0], size)
        # The process may have been forked since: its number is asked for each time.
        done = copy(os.getpid(), here, one, vector(address, size), one, none)
        return found if done == size else None

    probe = ctypes.create_string_buffer(b"glshim")
    found = read_own(ctypes.addressof(probe), 6)
    return read_own if found is not None and found.tobytes() == b"glshim" else _copied


_read = _reader()
