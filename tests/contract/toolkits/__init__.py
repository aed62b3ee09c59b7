"""What the contract of toolkits runs on: for each toolkit a file that defines ``RIGS``, with its
package, or a stand-in of its shape, and a program that uses it."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from pathlib import Path

from .rig import SIZE, Rig

__all__ = ["RIGS", "SIZE", "Rig"]

FILES = sorted({path.stem for path in Path(__file__).parent.glob("*.py")} - {"__init__", "rig"})
RIGS: dict[str, Callable[[], Rig]] = {
    name: rig for file in FILES for name, rig in import_module(f"{__name__}.{file}").RIGS.items()
}
"""Every toolkit's, and every way in which it ends a frame."""
