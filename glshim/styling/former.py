"""How stylers were written for version 0.1, and what to write instead.

Old spellings of values go on working: `accept` takes their arguments in a class's stead, and one
line says what to write now. Old modules are gone: `advice` says where their names are.
"""

from __future__ import annotations

import re
import traceback
from collections.abc import Callable
from functools import wraps
from importlib import import_module
from typing import Any

from glshim.notices import say_once

Renew = Callable[[tuple[Any, ...], dict[str, Any]], dict[str, Any] | None]
"""Arguments of an old spelling to those of the new one, by name; None: it is the new one."""


MODULES = {
    "glshim.assembly.batch": "glshim.model.batch",
    "glshim.geometry.camera": "glshim.model.camera",
    "glshim.geometry.contour.smooth_lines": "glshim.linework.smooth_lines",
    "glshim.geometry.lights": "glshim.model.lights",
    "glshim.geometry.passes": "glshim.geometry.meshshaders",
    "glshim.geometry.strokes.chains": "glshim.linework.walk",
    "glshim.geometry.strokes.coherence": "glshim.linework.coherence",
    "glshim.geometry.strokes.edges": "glshim.geometry.edges.edges",
    "glshim.geometry.strokes.feature_lines": "glshim.linework.feature_lines",
    "glshim.geometry.strokes.hand": "glshim.linework.hand",
    "glshim.geometry.strokes.lines": "glshim.model.lines",
    "glshim.geometry.strokes.raskar": "glshim.geometry.raskar",
    "glshim.geometry.strokes.screen": "glshim.geometry.window",
    "glshim.geometry.strokes": "glshim.linework",
    "glshim.geometry.transforms": "glshim.model.transforms",
    "glshim.geometry.vectors": "glshim.model.vectors",
    "glshim.options": "glshim.styling.texts",
    "glshim.render": "glshim.outputs.gl",
    "stylers.crossings": "glshim_stylers.shared.intersections",
    "stylers.edge_mesh.tones": "glshim_stylers.shared.tones",
    "stylers.hand": "glshim_stylers.shared.hand",
    "stylers.options": "glshim_stylers.shared.options",
    "stylers.shading": "glshim_stylers.shared.shading",
    "stylers.shared": "glshim_stylers.shared",
    "stylers.strokes": "glshim.styling.textures",
    "stylers": "glshim_stylers",
}
"""Modules of 0.1, or packages, that stylers may have imported, and where what they held is now."""
PAGE = "docs/guide/writing_a_styler.md"
_FROM = re.compile(r"from\s+([\w.]+)\s+import\s+\(?([\w, ]*)")
_MODULE = re.compile(r"(?:glshim_stylers|glshim|stylers)(?:\.\w+)+")
_NAME = re.compile(r"cannot import name '(\w+)'")


def advice(error: BaseException) -> str:
    """What to write instead of an import of ours that failed, to follow its message; else nothing.
    """
    if not isinstance(error, ImportError) or not (error.name or "").startswith(
        ("glshim", "stylers")
    ):
        return ""
    lines = (frame.line or "" for frame in reversed(traceback.extract_tb(error.__traceback__)))
    line = next((line for line in lines if _MODULE.search(line)), "")
    found = _FROM.search(line)
    module = found[1] if found else (_MODULE.findall(line) or [error.name])[0]
    names = re.findall(r"(\w+)(?: as \w+)?", found[2]) if found else _NAME.findall(str(error))
    public = import_module("glshim").__all__
    if names and all(name in public for name in names):
        return f": write from glshim import {', '.join(names)}"
    old = max((one for one in MODULES if f"{module}.".startswith(f"{one}.")), key=len, default="")
    if old:
        moved = f"what was {old} is in {MODULES[old]} now"
        return f": {moved}, and what stylers need in glshim ({PAGE})"
    return f": what stylers need is imported from glshim itself ({PAGE})"


def accept(cls: type, renew: Renew, instead: str) -> None:
    """Let a dataclass take the arguments of an old spelling, too; instead: what to write now."""
    init = cls.__init__  # type: ignore[misc]

    @wraps(init)
    def either(self: Any, *args: Any, **given: Any) -> None:
        renewed = renew(args, given)
        if renewed is None:
            init(self, *args, **given)
        else:
            say_once(f"a style spells {cls.__name__} as glshim 0.1 had it: write {instead}")
            init(self, **renewed)

    setattr(cls, "__init__", either)  # noqa: B010 (to mypy it has the new signature alone)


def by_order(*names: str) -> Renew:
    """Of arguments that were given by their places and have names now."""

    def renew(args: tuple[Any, ...], given: dict[str, Any]) -> dict[str, Any] | None:
        if not args or len(args) > len(names):
            return None
        return {**dict(zip(names, args, strict=False)), **given}

    return renew
