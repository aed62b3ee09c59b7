"""The viewer: its models, what is said of bad ones, and its window."""

import ast
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import glfw
import numpy as np
import pytest
from OpenGL import GL
from PIL import Image

import demo_apps
from demo_apps import viewer
from demo_apps.shapes import SHAPES, Mesh, polygon_normals
from demo_apps.viewer.models import Part
from demo_apps.viewer.prepare import CREASE, Ready, prepared
from demo_apps.viewer.window import Window

from .hand import ESCAPE, Hand
from .harness import ROOT


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
    (part,) = viewer.load(str(folder / f"box.{suffix}"))
    mesh = part.mesh
    assert [p.shape for p in mesh.polygons] == [(12, 3)]
    assert np.isclose(volume(mesh), 1.0)


def test_the_parts_of_a_scene_stand_where_they_are_placed(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    scene = trimesh.Scene()
    for x in (0.0, 5.0):
        scene.add_geometry(trimesh.creation.box(),
                           transform=trimesh.transformations.translation_matrix([x, 0, 0]))
    scene.export(tmp_path / "two.glb")
    (part,) = viewer.load(str(tmp_path / "two.glb"))
    assert np.isclose(np.ptp(part.mesh.points[:, 0]), 6.0)


@pytest.mark.parametrize(("name", "content", "says"), [
    ("tours", None, "shapes: torus"),
    ("nothing.obj", None, "no such file"),
    ("model.txt", "x", "is not a model: give a file in .obj"),
    ("empty.obj", "", "contains no polygons"),
    ("bad.glb", "garbage", "cannot be read"),
    ("bad.ply", "ply", "cannot be read"),
    ("bad.stl", "solid", "contains no polygons"),
])
def test_what_cannot_be_shown_is_said_in_one_line(  # noqa: PLR0917
        name: str, content: str | None, says: str, tmp_path: Path,
        monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    if says in ("cannot be read", "contains no polygons"):
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
    for script in Path(demo_apps.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(script.read_text())):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            assert not any(n.startswith(("glshim", "stylers")) for n in names), script


def corners(model: Ready) -> tuple[np.ndarray, np.ndarray]:
    """Points and normals of all corners, sorted by both."""
    rows = np.concatenate([
        np.concatenate([surface.positions[p.ravel()], surface.normals[p.ravel()]], axis=1)
        for surface in model.surfaces for p in surface.polygons])
    rows = rows[np.lexsort(np.round(rows, 4).T)]
    return rows[:, :3], rows[:, 3:]


@pytest.mark.parametrize("name", SHAPES)
def test_prepared_normals_are_those_of_the_exact_rule(name: str) -> None:
    mesh = SHAPES[name]().fitted()
    exact = np.concatenate([np.concatenate([p.reshape(-1, 3), n.reshape(-1, 3)], axis=1)
                            for p, n, _ in mesh.corners(CREASE)])
    exact = exact[np.lexsort(np.round(exact, 4).T)]
    points, normals = corners(prepared((Part(SHAPES[name]()),)))
    assert np.allclose(points, exact[:, :3], atol=1e-4)
    assert np.mean(np.einsum("ij,ij->i", normals, exact[:, 3:]) > 0.999) > 0.99


def test_smooth_surfaces_share_their_vertices_and_folded_ones_do_not() -> None:
    (torus,), (cube,) = (prepared((Part(SHAPES[name]()),)).surfaces for name in ("torus", "cube"))
    assert len(torus.positions) == 48 * 24
    assert len(np.unique(cube.polygons[0])) == 24
    assert len(prepared((Part(SHAPES["torus"]()),)).surfaces[0].normals) == 48 * 24


def test_a_model_fills_the_unit_sphere_and_keeps_its_measures() -> None:
    mesh = Mesh(np.array([[5.0, 5, 5], [9, 5, 5], [5, 8, 5]]), (np.array([[0, 1, 2]]),))
    model = prepared((Part(mesh), Part(Mesh(mesh.points + 10.0, mesh.polygons))))
    points = np.concatenate([surface.positions for surface in model.surfaces])
    assert np.isclose(np.linalg.norm(points, axis=1).max(), 1.0)
    assert model.size == (14.0, 13.0, 10.0)
    assert model.triangles == 2


@pytest.fixture
def ball(tmp_path: Path) -> Callable[[str], str]:
    """A file of a sphere with a picture on it, left half red, right half blue."""
    trimesh = pytest.importorskip("trimesh")

    def made(suffix: str) -> str:
        mesh = trimesh.creation.icosphere(3)
        places = np.stack([mesh.vertices[:, 0] * 0.5 + 0.5, mesh.vertices[:, 1] * 0.5 + 0.5], 1)
        pixels = np.zeros((8, 8, 3), np.uint8)
        pixels[:, :4, 0] = pixels[:, 4:, 2] = 255
        material = trimesh.visual.material.SimpleMaterial(
            image=Image.fromarray(pixels), diffuse=(255, 255, 255, 255))
        mesh.visual = trimesh.visual.TextureVisuals(uv=places, material=material)
        mesh.export(tmp_path / f"ball.{suffix}")
        return str(tmp_path / f"ball.{suffix}")

    return made


@pytest.fixture
def window(monkeypatch: pytest.MonkeyPatch) -> Iterator[Window]:
    monkeypatch.setenv("GLSHIM_NAME", "")  # which it sets
    made = Window("test")
    yield made
    made.close()


def picture(window: Window) -> np.ndarray:
    """A frame, as it is presented: (height, width, 3), first row on top."""
    found: list[np.ndarray] = []
    real = glfw.swap_buffers

    def grab(handle: Any) -> None:
        width, height = window.view.size
        raw = GL.glReadPixels(0, 0, width, height, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
        found.append(np.frombuffer(raw, np.uint8).reshape(height, width, 3)[::-1].astype(int))
        real(handle)

    glfw.swap_buffers = grab
    try:
        window.frame()
    finally:
        glfw.swap_buffers = real
    return found[0]


def until_shown(window: Window) -> list[np.ndarray]:
    """All frames until nothing is on its way."""
    end, found = time.monotonic() + 60.0, []
    while window.loading is not None or window.coming is not None:
        assert time.monotonic() < end
        found.append(picture(window))
    return [*found, picture(window)]


@pytest.mark.parametrize("suffix", ["obj", "glb"])
def test_a_dropped_file_is_shown_with_its_picture(
        window: Window, ball: Callable[[str], str], suffix: str) -> None:
    window.open("cube")
    window.view.look_from("front")
    window.drop([ball(suffix)])
    shown = until_shown(window)[-1]
    height, width = shown.shape[:2]
    left, right = shown[height // 2, width // 2 - 60], shown[height // 2, width // 2 + 60]
    assert left[0] > 60 > left[2] + 30
    assert right[2] > 60 > right[0] + 30
    assert window.name.endswith(suffix)
    assert window.sent is not None
    assert window.sent.model.triangles == 1280


def test_a_bad_file_is_said_in_the_window_and_the_model_stays(
        window: Window, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("trimesh")
    window.open("cube")
    plain = picture(window)
    (tmp_path / "bad.stl").write_text("solid")
    window.drop([str(tmp_path / "bad.stl")])
    said = until_shown(window)[-1]
    assert window.message == "bad.stl contains no polygons"
    assert window.name == "cube"
    rows = np.flatnonzero((said != plain).any(axis=(1, 2)))
    assert len(rows) and rows.min() > 400  # at the foot of the window
    assert capsys.readouterr().out == "viewer: bad.stl contains no polygons\n"
    window.drop([str(tmp_path / "gone.stl")])
    assert "no such file" in window.message
    window.open("torus")
    assert window.message == ""


def test_the_window_goes_on_while_a_large_file_comes(window: Window, tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    trimesh.creation.icosphere(7).export(tmp_path / "large.ply")  # 327,680 triangles
    window.open("cube")
    plain = picture(window)
    window.drop([str(tmp_path / "large.ply")])
    begun, frames, bars, phases = time.monotonic(), 0, 0, set()
    while window.loading is not None or window.coming is not None:
        assert time.monotonic() < begun + 60.0
        phases.add(window.progress()[0].split(": ")[1].split()[0].rstrip(","))
        frames += 1
        shown = picture(window)
        bars += bool((shown != plain).any()) and window.name == "cube"
    assert frames > 10
    assert bars > 0
    assert phases >= {"reading", "sending"}
    assert window.sent is not None
    assert window.sent.model.triangles == 327_680


def test_what_is_given_up_leaves_nothing_behind(window: Window, tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    trimesh.creation.icosphere(6).export(tmp_path / "large.ply")
    window.drop([str(tmp_path / "large.ply")])
    loading = window.loading
    assert loading is not None
    window.open("cube")
    assert window.loading is None
    assert loading.ended
    assert window.name == "cube"


def test_every_key_does_what_its_help_says(window: Window) -> None:
    window.open("gear")
    plain = picture(window)

    def press(name: str) -> np.ndarray:
        (key,) = (key for key in window.keys if name in key.names)
        key.does()
        return picture(window)

    for name in ("W", "P", "L", "A", "I", "H", "U"):
        assert (press(name) != plain).any(), name
        for _ in range({"L": 3, "U": 2}.get(name, 1)):
            again = press(name)
        assert (again == plain).all(), name
    for name in ("1", "2", "3", "LEFT", "RIGHT", "UP", "DOWN", "EQUAL", "MINUS"):
        window.view.reset()
        assert (press(name) != plain).any(), name
    assert (press("R") == plain).all()
    for name in ("N", "B"):
        before = window.name
        press(name)
        assert window.name != before
    press("T")
    assert (picture(window) != picture(window)).any()
    assert set("hiwtpaulnbr") <= set(window.help().replace(", ", "\n").replace("\t", "\n").split())


def test_the_help_leaves_a_margin_in_a_window_of_its_first_size(
        window: Window, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GLSHIM_KEYS", "on")
    window.open("cube")
    plain = picture(window)
    window.helps = True
    rows, columns = np.nonzero((picture(window) != plain).any(axis=2))
    height, width = plain.shape[:2]
    assert rows.min() >= 8
    assert rows.max() < height - 8
    assert columns.max() < width - 8


@pytest.mark.parametrize(("suffix", "asked", "stands"), [
    ("stl", None, True), ("glb", None, False), ("stl", "y", False), ("glb", "z", True)])
def test_the_axis_that_points_up(
        tmp_path: Path, suffix: str, asked: str | None, stands: bool,
        monkeypatch: pytest.MonkeyPatch) -> None:
    """A pole along z, upright or lying; its measures stay those of the file."""
    monkeypatch.setenv("GLSHIM_NAME", "")  # which a window sets
    trimesh = pytest.importorskip("trimesh")
    trimesh.creation.box((1, 1, 8)).export(tmp_path / f"pole.{suffix}")
    window = Window("test", up=asked, background=(1.0, 0.0, 0.0))
    try:
        window.open(str(tmp_path / f"pole.{suffix}"))
        window.view.look_from("right")
        shown = until_shown(window)[-1]
        assert window.sent is not None
        assert window.sent.model.size == (1.0, 1.0, 8.0)
    finally:
        window.close()
    assert tuple(shown[2, 2]) == (255, 0, 0)
    rows, columns = np.nonzero((shown != (255, 0, 0)).any(axis=2))
    assert (np.ptp(rows) > np.ptp(columns)) == stands


def test_saved_pictures_are_named_after_the_model(window: Window, tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    trimesh.creation.box().export(tmp_path / "small box.stl")
    window.open("cube")
    assert os.environ["GLSHIM_NAME"] == "cube"
    window.drop([str(tmp_path / "small box.stl")])
    until_shown(window)
    assert os.environ["GLSHIM_NAME"] == "small box"


def test_a_drag_with_the_right_button_moves_the_model(window: Window) -> None:
    window.open("sphere")
    picture(window)
    window.view.take(100.0, 100.0, pans=True)
    window.view.drag(160.0, 70.0)
    window.view.grip = None
    shown = picture(window)
    rows, columns = np.nonzero(np.abs(shown - shown[0, 0]).sum(axis=2) > 8)
    height, width = shown.shape[:2]
    # 4% more, since what is shown is nearer than the middle of the model.
    assert abs((columns.min() + columns.max()) / 2 - (width / 2 + 60)) < 8
    assert abs((rows.min() + rows.max()) / 2 - (height / 2 - 30)) < 8


def test_the_help_names_the_keys_of_styles_where_there_are_any(
        window: Window, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("GLSHIM_KEYS", raising=False)
    assert "style" not in window.help()
    monkeypatch.setenv("GLSHIM_KEYS", "on")
    assert "F9\tnext style" in window.help()
    monkeypatch.setenv("GLSHIM_KEYS", "cycle=F5,toggle=off")
    assert "F5\tnext style" in window.help()
    assert "F10" not in window.help()
    window.helps = True
    assert picture(window)[12, 12].min() > 240


def test_a_hand_at_the_keyboard(tmp_path: Path, small_display: str) -> None:
    """h shows the help, a drag orbits, ESC leaves with status 0."""
    hand = Hand(small_display)
    program = subprocess.Popen(
        [sys.executable, "-m", "demo_apps.viewer", "cube"], cwd=ROOT,
        env={**os.environ, "DISPLAY": small_display,
             "GLSHIM_CAPTURE": str(tmp_path / "frame.png")})
    end = time.monotonic() + 30.0
    while not (tmp_path / "frame.png").exists() and time.monotonic() < end:
        time.sleep(0.1)
    time.sleep(1.0)
    hand.move(320, 240)
    hand.press(ord("h"))
    time.sleep(1.0)
    hand.press(ESCAPE)
    assert program.wait(30) == 0
    shown = np.asarray(Image.open(tmp_path / "frame.png").convert("RGB")).astype(int)
    assert shown[12, 12].min() > 240  # the panel's ground over the window's


def test_with_wait_the_first_frame_shows_a_large_file(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    trimesh.creation.icosphere(6).export(tmp_path / "large.ply")
    subprocess.run(
        [sys.executable, "-m", "demo_apps.viewer", "--wait", "large.ply"], cwd=tmp_path, check=True,
        timeout=60, env={**os.environ, "PYTHONPATH": str(ROOT), "GLSHIM_FRAMES": "1",
                         "GLSHIM_CAPTURE": str(tmp_path / "first.png")})
    shown = np.asarray(Image.open(tmp_path / "first.png").convert("RGB")).astype(int)
    assert np.abs(shown[240, 320] - shown[2, 2]).max() > 20
