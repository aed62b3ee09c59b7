"""The viewer's models, without a window: shapes, files, and what is said of bad ones."""

import ast
from pathlib import Path

import numpy as np
import pytest

import demo_apps
from demo_apps import viewer
from demo_apps.shapes import SHAPES, Mesh, polygon_normals


def volume(mesh: Mesh) -> float:
    """The volume inside a closed mesh; negative where it is wound inside out."""
    return sum(float(np.einsum("ij,ij->", mesh.points[p].mean(axis=1),
                               polygon_normals(mesh.points[p]))) / 6 for p in mesh.polygons)


def edges(mesh: Mesh) -> set[tuple[int, int]]:
    _, spot = np.unique(np.round(mesh.points, 9), axis=0, return_inverse=True)
    spot = spot.ravel()
    return {(int(a), int(b)) for polygons in mesh.polygons for polygon in spot[polygons]
            for a, b in zip(polygon, np.roll(polygon, -1), strict=True)}


@pytest.mark.parametrize("name", SHAPES)
def test_shapes_are_whole_and_wound_counter_clockwise(name: str) -> None:
    mesh = SHAPES[name]()
    assert volume(mesh) > 0
    for polygons in mesh.polygons:
        assert (np.linalg.norm(polygon_normals(mesh.points[polygons]), axis=1) > 1e-9).all()
    directed = edges(mesh)
    lonely = sum((b, a) not in directed for a, b in directed)
    assert lonely == {"bowl": 40, "teapot": 144}.get(name, 0)


@pytest.mark.parametrize("name", SHAPES)
def test_normals_are_unit_and_on_the_polygons_side(name: str) -> None:
    for points, normals, _ in SHAPES[name]().corners():
        assert np.allclose(np.linalg.norm(normals, axis=2), 1.0)
        assert (np.einsum("mki,mi->mk", normals, polygon_normals(points)) > 0).all()


def test_a_cubes_normals_stay_flat_and_a_spheres_are_round() -> None:
    (points, normals, _), = SHAPES["cube"]().corners()
    assert np.allclose(normals, np.sign(points.mean(axis=1))[:, None])
    for points, normals, _ in SHAPES["sphere"]().corners():
        assert np.einsum("mki,mki->mk", normals, points).min() > 0.999


def test_fitted_lies_in_the_unit_sphere() -> None:
    mesh = Mesh(np.array([[5.0, 5, 5], [9, 5, 5], [5, 8, 5]]), (np.array([[0, 1, 2]]),)).fitted()
    assert np.isclose(np.linalg.norm(mesh.points, axis=1).max(), 1.0)


@pytest.mark.parametrize("suffix", ["obj", "ply", "stl", "glb", "gltf"])
def test_files_keep_their_polygons(suffix: str, tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    folder = tmp_path / "a model"
    folder.mkdir()
    trimesh.creation.box().export(folder / f"box.{suffix}")
    mesh = viewer.load(str(folder / f"box.{suffix}"))
    assert [p.shape for p in mesh.polygons] == [(12, 3)]
    assert np.isclose(volume(mesh), 1.0)


def test_the_parts_of_a_scene_stand_where_they_are_placed(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    scene = trimesh.Scene()
    for x in (0.0, 5.0):
        scene.add_geometry(trimesh.creation.box(),
                           transform=trimesh.transformations.translation_matrix([x, 0, 0]))
    scene.export(tmp_path / "two.glb")
    mesh = viewer.load(str(tmp_path / "two.glb"))
    assert np.isclose(np.ptp(mesh.points[:, 0]), 6.0)


@pytest.mark.parametrize(("name", "content", "says"), [
    ("tours", None, "shapes: torus"),
    ("nothing.obj", None, "there is no file"),
    ("model.txt", "x", "only .obj"),
    ("empty.obj", "", "holds no polygons"),
    ("bad.glb", "garbage", "cannot be read"),
    ("bad.ply", "ply", "cannot be read"),
    ("bad.stl", "solid", "holds no polygons"),
])
def test_what_cannot_be_shown_is_said_in_one_line(  # noqa: PLR0917
        name: str, content: str | None, says: str, tmp_path: Path,
        monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    if says in ("cannot be read", "holds no polygons"):
        pytest.importorskip("trimesh")
    monkeypatch.chdir(tmp_path)
    if content is not None:
        Path(name).write_text(content)
    assert viewer.main([name]) == 2
    message = capsys.readouterr().err
    assert says in message and message.count("\n") == 1


def test_without_trimesh_files_are_refused_in_one_line(
        tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
        capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setitem(__import__("sys").modules, "trimesh", None)
    (tmp_path / "a.obj").write_text("")
    assert viewer.main([str(tmp_path / "a.obj")]) == 2
    assert "pip install trimesh" in capsys.readouterr().err


def test_demo_apps_never_import_glshim() -> None:
    for script in Path(demo_apps.__file__).parent.glob("*.py"):
        for node in ast.walk(ast.parse(script.read_text())):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            assert not any(n.split(".")[0] in ("glshim", "stylers") for n in names), script
