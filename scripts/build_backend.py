"""setuptools' build backend, with every wheel rewritten for what setuptools has no setting for.

Start-up files: a wheel's root lands in site-packages, the only place where Python reads
`glshim.pth` and `glshim.start`.

Names: the folders `stylers` and `demo_apps` are installed as packages of other names, since a
program may well have modules called so. An editable wheel puts no folder of ours on Python's path,
which would give every program of that environment our `tests` and `docs` to import: each package is
one small file that says where it lies.

This module wraps the two public hooks that make wheels (PEP 517, PEP 660) and touches nothing
inside setuptools.
"""

from __future__ import annotations

import base64
import hashlib
import os
import zipfile
from pathlib import Path

from setuptools import build_meta as _setuptools
from setuptools.build_meta import *  # noqa: F403  (the hooks that need nothing added)

INSTALLED_AS = {"glshim": "glshim", "stylers": "glshim_stylers", "demo_apps": "glshim_demos"}
"""The folders of the repository that are packages, and what they are called once installed."""
_ROOT = Path(__file__).resolve().parent.parent
_STARTUP_FILES = ("glshim.pth", "glshim.start")
_START = "_glshim_start.py"
_HERE = '''"""Editable install: this is {path}"""
__file__ = {path!r}
{more}exec(compile(__loader__.get_data(__file__), __file__, "exec"))
'''


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """PEP 517."""
    name = _setuptools.build_wheel(wheel_directory, config_settings, metadata_directory)
    wheel = Path(wheel_directory, name)
    _write(wheel, {_renamed(file): content for file, content in _content(wheel).items()})
    return name


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """PEP 660."""
    name = _setuptools.build_editable(wheel_directory, config_settings, metadata_directory)
    wheel = Path(wheel_directory, name)
    files = {
        file: content
        for file, content in _content(wheel).items()
        if not file.startswith("__editable__")
    }
    files[_START] = _HERE.format(path=str(_ROOT / _START), more="").encode()
    for folder, package in INSTALLED_AS.items():
        path, more = _ROOT / folder / "__init__.py", f"__path__[:] = [{str(_ROOT / folder)!r}]\n"
        files[f"{package}/__init__.py"] = _HERE.format(path=str(path), more=more).encode()
    _write(wheel, files)
    return name


def _renamed(file: str) -> str:
    folder, slash, rest = file.partition("/")
    return INSTALLED_AS.get(folder, folder) + slash + rest


def _content(wheel: Path) -> dict[str, bytes]:
    with zipfile.ZipFile(wheel) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def _write(wheel: Path, files: dict[str, bytes]) -> None:
    """The wheel anew, with the start-up files, its list of top-level names and its RECORD."""
    files |= {name: (_ROOT / name).read_bytes() for name in _STARTUP_FILES}
    (record,) = (name for name in files if name.endswith(".dist-info/RECORD"))
    tops = sorted({*INSTALLED_AS.values(), _START.removesuffix(".py")})
    files[record.replace("RECORD", "top_level.txt")] = "".join(f"{top}\n" for top in tops).encode()
    del files[record]
    lines = [f"{name},sha256={_digest(content)},{len(content)}" for name, content in files.items()]
    files[record] = "".join(f"{line}\n" for line in (*lines, f"{record},,")).encode()
    rewritten = wheel.with_suffix(".rewritten")
    with zipfile.ZipFile(rewritten, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    os.replace(rewritten, wheel)


def _digest(content: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
