"""A model viewer: `python -m demo_apps.viewer [MODEL]`.

MODEL is a built-in shape or an OBJ, PLY, STL or glTF file. Drag to orbit, wheel or +/- to zoom,
r resets the view, ESC leaves. glfw opens the window; a display list of fixed-function OpenGL draws.
"""

import argparse
import difflib
import math
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import glfw
import numpy as np
from OpenGL import GL, GLU

from .shapes import SHAPES, Mesh, joined

FILES = (".obj", ".ply", ".stl", ".gltf", ".glb")
DEFAULT = "gear"
CLAY = (0.72, 0.70, 0.66)
ANGLE = 35.0  # vertical field of view, degrees


class ModelError(Exception):
    """The model cannot be shown; the message is one line."""


def load(name: str) -> Mesh:
    """A built-in shape by its name, or a file."""
    if name in SHAPES:
        return SHAPES[name]()
    path = Path(name)
    if path.is_file():
        return load_file(path)
    if path.is_dir():
        raise ModelError(f"{name} is a folder, not a model")
    if path.suffix.lower() in FILES or len(path.parts) > 1:
        raise ModelError(f"there is no file {name}")
    near = difflib.get_close_matches(name, SHAPES, 2) or list(SHAPES)
    raise ModelError(f"there is no shape or file named {name!r}; shapes: {', '.join(near)}")


def load_file(path: Path) -> Mesh:
    if path.suffix.lower() not in FILES:
        raise ModelError(f"{path.name}: only {', '.join(FILES)} files can be read")
    try:
        import trimesh
    except ImportError:
        raise ModelError("reading files needs trimesh: pip install trimesh") from None
    try:
        scene = trimesh.load_scene(path)
        parts = [convert(part) for part in scene.dump() if isinstance(part, trimesh.Trimesh)]
    except Exception as fault:  # trimesh's readers raise whatever a broken file makes them
        reason = str(fault).strip().splitlines() or [type(fault).__name__]
        raise ModelError(f"{path.name} cannot be read: {reason[0]}") from None
    parts = [part for part in parts if part.polygons[0].size]
    if not parts:
        raise ModelError(f"{path.name} holds no polygons")
    mesh = joined(parts)
    if not np.isfinite(mesh.points).all():
        raise ModelError(f"{path.name} holds points that are not finite")
    return mesh


def convert(part: "trimesh.Trimesh") -> Mesh:  # type: ignore[name-defined]  # noqa: F821
    """Triangles, with the colours of the vertices or of the material where there are any."""
    colours = None
    if part.visual.defined:
        visual = part.visual
        material = getattr(visual, "material", None)
        shade = visual.vertex_colors if material is None else [material.main_color]
        colours = np.broadcast_to(np.asarray(shade)[:, :3] / 255.0, (len(part.vertices), 3))
    triangles = np.asarray(part.faces, np.int64)
    return Mesh(np.asarray(part.vertices, np.float64), (triangles,), colours)


def compiled(mesh: Mesh) -> int:
    """A display list of the mesh: quads stay quads."""
    modes = {3: GL.GL_TRIANGLES, 4: GL.GL_QUADS}
    name = int(GL.glGenLists(1))
    GL.glNewList(name, GL.GL_COMPILE)
    GL.glColor3f(*CLAY)
    for points, normals, numbers in mesh.corners():
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
        GL.glVertexPointerf(points.reshape(-1, 3).astype(np.float32))
        GL.glNormalPointerf(normals.reshape(-1, 3).astype(np.float32))
        if mesh.colours is not None:
            GL.glEnableClientState(GL.GL_COLOR_ARRAY)
            GL.glColorPointerf(mesh.colours[numbers.ravel()].astype(np.float32))
        GL.glDrawArrays(modes[numbers.shape[1]], 0, numbers.size)
        GL.glDisableClientState(GL.GL_COLOR_ARRAY)
        GL.glDisableClientState(GL.GL_NORMAL_ARRAY)
        GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
    GL.glEndList()
    return name


@dataclass
class View:
    """Where the camera stands, and the drag in progress."""

    azimuth: float = 35.0
    elevation: float = 28.0
    distance: float = 3.8
    size: tuple[int, int] = (640, 480)
    grip: tuple[float, float] | None = field(default=None, repr=False)

    def drag(self, x: float, y: float) -> None:
        if self.grip is not None:
            self.azimuth += 0.4 * (x - self.grip[0])
            self.elevation = min(max(self.elevation + 0.4 * (y - self.grip[1]), -90.0), 90.0)
            self.grip = (x, y)

    def zoom(self, steps: float) -> None:
        self.distance = min(max(self.distance * 0.9**steps, 1.2), 40.0)

    def reset(self) -> None:
        fresh = View()
        self.azimuth, self.elevation = fresh.azimuth, fresh.elevation
        self.distance = fresh.distance

    def apply(self) -> None:
        width, height = self.size[0], max(self.size[1], 1)
        GL.glViewport(0, 0, width, height)
        GL.glMatrixMode(GL.GL_PROJECTION)
        GL.glLoadIdentity()
        narrow = min(width / height, 1.0)  # keep the model in view in an upright window, too
        upright = 2 * math.degrees(math.atan(math.tan(math.radians(ANGLE / 2)) / narrow))
        near = max(self.distance - 1.1, 0.05)
        GLU.gluPerspective(upright, width / height, near, self.distance + 1.1)
        GL.glMatrixMode(GL.GL_MODELVIEW)
        GL.glLoadIdentity()
        GL.glTranslatef(0.0, 0.0, -self.distance)
        GL.glRotatef(self.elevation, 1.0, 0.0, 0.0)
        GL.glRotatef(self.azimuth, 0.0, 1.0, 0.0)


def set_up() -> None:
    """Two lights that stay with the camera."""
    GL.glClearColor(0.90, 0.92, 0.94, 1.0)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glEnable(GL.GL_LIGHTING)
    GL.glEnable(GL.GL_COLOR_MATERIAL)
    GL.glLightModeli(GL.GL_LIGHT_MODEL_TWO_SIDE, GL.GL_TRUE)
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_SPECULAR, (0.25, 0.25, 0.25, 1.0))
    GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, 30.0)
    for light, place, bright in ((GL.GL_LIGHT0, (2.0, 4.0, 3.0, 0.0), 0.85),
                                 (GL.GL_LIGHT1, (-4.0, 1.0, 1.0, 0.0), 0.25)):
        GL.glEnable(light)
        GL.glLightfv(light, GL.GL_POSITION, place)
        GL.glLightfv(light, GL.GL_DIFFUSE, (bright, bright, bright, 1.0))


def connect(window: object, view: View) -> None:
    """Keys and mouse."""
    keys = {
        glfw.KEY_EQUAL: lambda: view.zoom(1), glfw.KEY_KP_ADD: lambda: view.zoom(1),
        glfw.KEY_MINUS: lambda: view.zoom(-1), glfw.KEY_KP_SUBTRACT: lambda: view.zoom(-1),
        glfw.KEY_R: view.reset,
        glfw.KEY_ESCAPE: lambda: glfw.set_window_should_close(window, True),
    }

    def key(_window: object, key: int, _scan: int, action: int, _mods: int) -> None:
        if action != glfw.RELEASE and key in keys:
            keys[key]()

    def button(window: object, button: int, action: int, _mods: int) -> None:
        if button == glfw.MOUSE_BUTTON_LEFT:
            view.grip = glfw.get_cursor_pos(window) if action == glfw.PRESS else None

    def resize(_window: object, width: int, height: int) -> None:
        view.size = (width, height)

    glfw.set_key_callback(window, key)
    glfw.set_mouse_button_callback(window, button)
    glfw.set_cursor_pos_callback(window, lambda _window, x, y: view.drag(x, y))
    glfw.set_scroll_callback(window, lambda _window, _x, y: view.zoom(y))
    glfw.set_framebuffer_size_callback(window, resize)


def show(mesh: Mesh, title: str) -> None:
    """Open a window and draw until it is closed."""
    view = View()
    glfw.ERROR_REPORTING = "ignore"  # what goes wrong is told in one line below
    if not glfw.init():
        raise ModelError("no display to open a window on")
    window = glfw.create_window(*view.size, title, None, None)
    if not window:
        glfw.terminate()
        raise ModelError("no window with OpenGL could be opened")
    glfw.make_context_current(window)
    glfw.swap_interval(1)
    view.size = glfw.get_framebuffer_size(window)
    connect(window, view)
    set_up()
    model = compiled(mesh.fitted())
    while not glfw.window_should_close(window):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        view.apply()
        GL.glCallList(model)
        glfw.swap_buffers(window)
        glfw.poll_events()
    glfw.terminate()


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="viewer", description="Show a model; drag to orbit.")
    parser.add_argument("model", nargs="?", default=DEFAULT, metavar="MODEL",
                        help=f"a shape ({', '.join(SHAPES)}; default {DEFAULT}) or a file "
                             f"({', '.join(FILES)})")
    name = parser.parse_args(arguments).model
    try:
        show(load(name), Path(name).name)
    except ModelError as fault:
        print(f"viewer: {fault}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
