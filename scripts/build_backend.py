"""setuptools' build backend, with the start-up files put at the root of every wheel.

A wheel's root lands in site-packages, the only place where Python reads `glshim.pth` and
`glshim.start`. setuptools has no setting for that which also covers editable wheels, so this
module wraps the two public hooks that make wheels (PEP 517, PEP 660) and touches nothing inside
setuptools.
"""

from __future__ import annotations

import base64
import hashlib
import os
import zipfile
from pathlib import Path

from setuptools import build_meta as _setuptools
from setuptools.build_meta import *  # noqa: F403  (the hooks that need nothing added)

_ROOT = Path(__file__).resolve().parent.parent
_STARTUP_FILES = ("glshim.pth", "glshim.start")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """PEP 517."""
    name = _setuptools.build_wheel(wheel_directory, config_settings, metadata_directory)
    _add_startup_files(Path(wheel_directory, name))
    return name


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """PEP 660."""
    name = _setuptools.build_editable(wheel_directory, config_settings, metadata_directory)
    _add_startup_files(Path(wheel_directory, name))
    return name


def _add_startup_files(wheel: Path) -> None:
    """Rewrite the wheel with the files added and listed in its RECORD."""
    rewritten = wheel.with_suffix(".rewritten")
    with (
        zipfile.ZipFile(wheel) as old,
        zipfile.ZipFile(rewritten, "w", zipfile.ZIP_DEFLATED) as new,
    ):
        for item in old.infolist():
            content = old.read(item)
            if item.filename.endswith(".dist-info/RECORD"):
                content = content.rstrip(b"\n") + b"\n" + _record_lines().encode()
            new.writestr(item, content)
        for name in _STARTUP_FILES:
            new.write(_ROOT / name, name)
    os.replace(rewritten, wheel)


def _record_lines() -> str:
    lines = []
    for name in _STARTUP_FILES:
        content = (_ROOT / name).read_bytes()
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        lines.append(f"{name},sha256={digest},{len(content)}\n")
    return "".join(lines)
