"""Models by name: built-in shapes, and files with their colours and textures. No OpenGL."""

import difflib
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..shapes import SHAPES, Floats, Mesh, joined

FILES = (".obj", ".ply", ".stl", ".gltf", ".glb")
Z_UP = (".stl",)  # printers and CAD programs write them; in the others y points up


class ModelError(Exception):
    """The model cannot be shown; the message is one line."""


@dataclass(frozen=True, slots=True)
class Part:
    """A mesh with, perhaps, a picture (height, width, 4) uint8 on it, first row on top, and where
    in it each point lies: (n, 2), the lower left corner of the picture at (0, 0)."""

    mesh: Mesh
    places: Floats | None = None
    picture: NDArray[np.uint8] | None = None


Model = tuple[Part, ...]


def check(name: str) -> None:
    """Raises ModelError where there is no such shape or file, or none that can be read here."""
    if name in SHAPES:
        return
    path = Path(name)
    if path.is_dir():
        raise ModelError(f"{name} is a folder, not a model")
    if not path.is_file():
        if path.suffix.lower() in FILES or len(path.parts) > 1:
            raise ModelError(f"no such file: {name}")
        near = difflib.get_close_matches(name, SHAPES, 2) or list(SHAPES)
        raise ModelError(f"no shape or file is named {name!r}; shapes: {', '.join(near)}")
    if path.suffix.lower() not in FILES:
        raise ModelError(f"{path.name} is not a model: give a file in {', '.join(FILES)}")
    if find_spec("trimesh") is None:
        raise ModelError("reading model files needs trimesh: pip install trimesh")


def up_of(name: str) -> str:
    """The axis of a model that points up, as far as its format tells."""
    return "z" if name not in SHAPES and Path(name).suffix.lower() in Z_UP else "y"


def load(name: str) -> Model:
    """A built-in shape by its name, or a file. Raises ModelError."""
    check(name)
    return (Part(SHAPES[name]()),) if name in SHAPES else load_file(Path(name))


def load_file(path: Path) -> Model:
    import trimesh

    try:
        scene = trimesh.load_scene(path)
        parts = [convert(part) for part in scene.dump() if isinstance(part, trimesh.Trimesh)]
    except Exception as fault:  # trimesh's readers raise whatever a broken file makes them
        reason = str(fault).strip().splitlines() or [type(fault).__name__]
        raise ModelError(f"{path.name} cannot be read: {reason[0]}") from None
    parts = [part for part in parts if part.mesh.polygons[0].size]
    if not parts:
        raise ModelError(f"{path.name} contains no polygons")
    if not all(np.isfinite(part.mesh.points).all() for part in parts):
        raise ModelError(f"{path.name} contains points that are not finite")
    plain = [part.mesh for part in parts if part.picture is None]
    pictured = tuple(part for part in parts if part.picture is not None)
    return (*([Part(joined(plain))] if plain else []), *pictured)


def convert(part: Any) -> Part:
    """A trimesh.Trimesh as triangles, with the colours of the vertices or of the material, and the
    picture of that, where there are any."""
    triangles = np.asarray(part.faces, np.int64)
    colours, places, picture = None, None, None
    if part.visual.defined:
        visual = part.visual
        material = getattr(visual, "material", None)
        shade = visual.vertex_colors if material is None else [material.main_color]
        colours = np.broadcast_to(np.asarray(shade)[:, :3] / 255.0, (len(part.vertices), 3))
        places, picture = on_it(visual, material, len(part.vertices))
    mesh = Mesh(np.asarray(part.vertices, np.float64), (triangles,), colours)
    if picture is not None and getattr(material, "baseColorFactor", None) is None:
        mesh = Mesh(mesh.points, mesh.polygons, np.ones_like(mesh.points))  # the picture's own
    return Part(mesh, places, picture)


def on_it(visual: Any, material: Any, points: int) -> tuple[Any, Any]:
    """Where the points lie in the material's picture, and that; None where there is none."""
    found = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
    places = getattr(visual, "uv", None)
    if found is None or places is None or np.shape(places) != (points, 2):
        return None, None
    return np.asarray(places, np.float64), np.asarray(found.convert("RGBA"))
