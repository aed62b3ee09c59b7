"""Shader texts that lie beside the module that uses them."""

from __future__ import annotations

from pathlib import Path


def glsl(beside: str, *names: str) -> str:
    """The texts of ``NAME.glsl`` beside a module (its ``__file__``), one after another."""
    folder = Path(beside).parent
    return "".join((folder / f"{name}.glsl").read_text("utf-8") for name in names)
