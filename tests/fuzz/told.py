"""What the program gets, in words that are the same in each process."""

from __future__ import annotations

import ctypes
import hashlib
import re
from typing import Any

import numpy as np

_LONG = 48
"""Elements: of longer arrays a digest is told."""
_HIGHEST = 1 << 40
"""Greater numbers are addresses."""


def told(value: Any) -> str:
    """A returned value, by kind and content."""
    if isinstance(value, np.ndarray):
        data = np.ascontiguousarray(value)
        text = str(data.tolist()) if data.size <= _LONG else _digest(data.tobytes())
        return f"array {data.dtype} {data.shape} {text}"
    if isinstance(value, (bytes, bytearray, memoryview)):
        data = bytes(value)
        return (
            f"{type(value).__name__} {data!r}"
            if len(data) <= _LONG
            else f"bytes {len(data)} {_digest(data)}"
        )
    if isinstance(value, (list, tuple)):
        inside = ", ".join(map(told, value))
        return (
            f"{type(value).__name__} ({inside})"
            if len(inside) < 4000
            else f"{len(value)} {_digest(inside.encode())}"
        )
    if isinstance(value, dict):
        return "{" + ", ".join(f"{told(k)}: {told(v)}" for k, v in value.items()) + "}"
    if isinstance(value, bool) or value is None:
        return repr(value)
    if isinstance(value, int) and not -_HIGHEST < value < _HIGHEST:
        return "an address" if value < 1 << 63 else repr(value)
    if isinstance(value, ctypes.Array):
        return f"{type(value).__name__} {told(list(value))}"
    if isinstance(value, ctypes._SimpleCData):
        return f"{type(value).__name__} {told(value.value)}"
    if isinstance(value, ctypes._Pointer):
        return f"{type(value).__name__} {'to something' if value else 'NULL'}"
    if hasattr(value, "__dict__") and type(value).__module__.startswith("OpenGL"):
        return f"{type(value).__name__} {told(vars(value))}"
    return steady(f"{type(value).__name__} {value!r}")


def raised(error: BaseException) -> str:
    """An exception, by kind and text."""
    return steady(f"raises {type(error).__name__}: {error}")


def steady(text: str) -> str:
    """Without addresses, and without who was first to make a type of arrays."""
    text = re.sub(r"[\w.]*\b(c_\w+_Array_\d+)", r"\1", text)
    text = re.sub(r"0x[0-9a-fA-F]{5,}", "0x...", text)
    text = re.sub(r"\b\d{13,}\b", "<long number>", text)
    return re.sub(r"c_void_p\(\d+\)", "c_void_p(...)", text)


def _digest(data: bytes) -> str:
    return hashlib.blake2b(data, digest_size=8).hexdigest()
