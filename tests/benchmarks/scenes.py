"""The scenes that are timed, as one ordinary PyOpenGL program: `python scenes.py NAME SECONDS`.

A 400x300 window of glfw; the mesh covers about a tenth of it, so that what is measured is the cost
of calls and vertices and not of filling pixels. A frame is timed from its clear to the return of
the swap, glFinish included. The camera turns from frame to frame. Prints one line of JSON.
"""

import ctypes
import gc
import json
import sys
import time
from collections.abc import Callable
from pathlib import Path

import glfw
import numpy as np
from numpy.typing import NDArray
from OpenGL.arrays import vbo
from OpenGL.GL import *  # noqa: F403
from OpenGL.GLU import gluDeleteQuadric, gluNewQuadric, gluPerspective, gluSphere

# ruff: noqa: F405

Draw = Callable[[int], None]
SIZE = (400, 300)
WARM = 4  # frames before the timing begins; the first of them is reported apart
MOVES = 16  # different shapes of the mesh that moves
PLEATS = 16
COUNTED = 4  # frames whose vertices are counted
VERTICES_SUBMITTED = 0x82EE  # OpenGL 4.6, ARB_pipeline_statistics_query


def sphere(quads: int, swell: float = 0.0, pleats: float = 0.0) -> NDArray[np.float32]:
    """Normals and points (quads, 4, 6) of a sphere of that many quads. pleats: depth of folds from
    pole to pole, ridges and valleys of about 90 and 270 degrees at 0.2."""
    columns = round((2 * quads) ** 0.5)
    if pleats:
        columns = max(round(columns / (2 * PLEATS)), 1) * 2 * PLEATS
    rows = -(-quads // columns)
    polar = np.linspace(0.02, np.pi - 0.02, rows + 1)[:, None]
    turn = np.linspace(0.0, 2 * np.pi, columns + 1)
    normals = np.stack([np.sin(polar) * np.cos(turn), np.cos(polar) + 0 * turn,
                        np.sin(polar) * np.sin(turn)], axis=2)
    height = np.abs(turn * PLEATS / np.pi % 2 - 1) - 0.5  # from -0.5 to 0.5 and back
    height = swell * np.sin(5 * polar + 3 * turn) + pleats * np.sin(polar) * height
    points = normals * (1 + height)[..., None]
    grid = np.concatenate([normals, points], axis=2)
    corners = [grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]]
    return np.stack(corners, axis=2).reshape(-1, 4, 6)[:quads].astype(np.float32)


def calls(mesh: NDArray[np.float32]) -> list[tuple[float, ...]]:
    return [tuple(row) for row in mesh.reshape(-1, 6).tolist()]


def immediate(vertices: int) -> Draw:
    """One glBegin/glEnd of quads, glNormal3f and glVertex3f for each vertex."""
    data = calls(sphere(vertices // 4))

    def draw(_frame: int) -> None:
        glBegin(GL_QUADS)
        for nx, ny, nz, x, y, z in data:
            glNormal3f(nx, ny, nz)
            glVertex3f(x, y, z)
        glEnd()

    return draw


def vectors(vertices: int) -> Draw:
    """The same with glNormal3fv and glVertex3fv of lists."""
    data = [(list(row[:3]), list(row[3:])) for row in calls(sphere(vertices // 4))]

    def draw(_frame: int) -> None:
        glBegin(GL_QUADS)
        for normal, point in data:
            glNormal3fv(normal)
            glVertex3fv(point)
        glEnd()

    return draw


def moving(vertices: int) -> Draw:
    """The same with glNormal3f and glVertex3f, and another shape in each frame."""
    shapes = [calls(sphere(vertices // 4, 0.1 * np.sin(2 * np.pi * i / MOVES)))
              for i in range(MOVES)]

    def draw(frame: int) -> None:
        glBegin(GL_QUADS)
        for nx, ny, nz, x, y, z in shapes[frame % MOVES]:
            glNormal3f(nx, ny, nz)
            glVertex3f(x, y, z)
        glEnd()

    return draw


def pairs(count: int) -> Draw:
    """A glBegin/glEnd around every single quad."""
    quads = [[row[3:] for row in calls(quad)] for quad in sphere(count)]
    normals = [tuple(quad[0, :3].tolist()) for quad in sphere(count)]

    def draw(_frame: int) -> None:
        for normal, quad in zip(normals, quads, strict=True):
            glBegin(GL_QUADS)
            glNormal3f(*normal)
            for x, y, z in quad:
                glVertex3f(x, y, z)
            glEnd()

    return draw


def display_list(polygons: int) -> Draw:
    name = glGenLists(1)
    glNewList(name, GL_COMPILE)
    immediate(4 * polygons)(0)
    glEndList()
    return lambda _frame: glCallList(name)


def crossed(polygons: int) -> Draw:
    """A list of a sphere with folds, half of the polygons, and a smooth one that passes through
    all of them: a mesh that has every kind of line."""
    name = glGenLists(1)
    glNewList(name, GL_COMPILE)
    glBegin(GL_QUADS)
    for mesh in (sphere(polygons // 2, pleats=0.2), sphere(polygons // 2)):
        for nx, ny, nz, x, y, z in calls(mesh):
            glNormal3f(nx, ny, nz)
            glVertex3f(x, y, z)
    glEnd()
    glEndList()
    return lambda _frame: glCallList(name)


def buffer(polygons: int) -> Draw:
    """Interleaved normals and points in a buffer object, glDrawArrays of quads."""
    mesh = np.ascontiguousarray(sphere(polygons).reshape(-1, 6))
    store = vbo.VBO(mesh)

    def draw(_frame: int) -> None:
        with store:
            glEnableClientState(GL_VERTEX_ARRAY)
            glEnableClientState(GL_NORMAL_ARRAY)
            glNormalPointer(GL_FLOAT, 24, store)
            glVertexPointer(3, GL_FLOAT, 24, store + 12)
            glDrawArrays(GL_QUADS, 0, len(mesh))
            glDisableClientState(GL_NORMAL_ARRAY)
            glDisableClientState(GL_VERTEX_ARRAY)

    return draw


def small_list() -> int:
    """A list of a sphere of 32 quads, a fiftieth of the scene's size."""
    name = int(glGenLists(1))
    glNewList(name, GL_COMPILE)
    glPushMatrix()
    glScalef(0.02, 0.02, 0.02)
    immediate(128)(0)
    glPopMatrix()
    glEndList()
    return name


def matrices(count: int) -> Draw:
    """Push, translate, rotate and pop around every call of a small list."""
    name = small_list()
    places = sphere(count // 4)[:, 0, 3:].tolist()

    def draw(_frame: int) -> None:
        for x, y, z in places:
            glPushMatrix()
            glTranslatef(x, y, z)
            glRotatef(90.0 * x, 0.0, 1.0, 0.0)
            glCallList(name)
            glPopMatrix()

    return draw


def call_lists(count: int) -> Draw:
    """One glCallLists of many names, each a list that moves and draws a small list."""
    small = small_list()
    base = glGenLists(count)
    for i, (x, y, z) in enumerate(sphere(count)[:, 0, 3:].tolist()):
        glNewList(base + i, GL_COMPILE)
        glPushMatrix()
        glTranslatef(x, y, z)
        glCallList(small)
        glPopMatrix()
        glEndList()
    names = np.arange(base, base + count, dtype=np.uint32)
    return lambda _frame: glCallLists(names)


def turning(count: int, triangles: int) -> Draw:
    """Objects of so many triangles, a list each, side by side and each turning about itself."""
    quads = sphere(triangles // 2, 0.1)
    mesh = quads[:, (0, 1, 2, 0, 2, 3)].reshape(-1, 6)
    normals, points = (np.ascontiguousarray(mesh[:, k : k + 3]) for k in (0, 3))
    base = int(glGenLists(count))
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_NORMAL_ARRAY)
    glNormalPointer(GL_FLOAT, 0, normals)
    glVertexPointer(3, GL_FLOAT, 0, points)
    for name in range(base, base + count):
        glNewList(name, GL_COMPILE)
        glDrawArrays(GL_TRIANGLES, 0, len(mesh))
        glEndList()
    glDisableClientState(GL_NORMAL_ARRAY)
    glDisableClientState(GL_VERTEX_ARRAY)
    columns = int(np.ceil(count**0.5))
    size = 2.0 / columns

    def draw(frame: int) -> None:
        for i in range(count):
            glPushMatrix()
            glTranslatef(size * (i % columns - (columns - 1) / 2),
                         size * (i // columns - (columns - 1) / 2), 0.0)
            glScalef(*[0.45 * size] * 3)
            glRotatef(2.0 * frame + 31.0 * i, 0.3, 1.0, 0.1)
            glCallList(base + i)
            glPopMatrix()

    return draw


def fresh_lists(frame: int) -> None:
    """A list made, called and deleted, another shape in each frame."""
    name = glGenLists(1)
    glNewList(name, GL_COMPILE)
    glBegin(GL_QUADS)
    for nx, ny, nz, x, y, z in calls(sphere(100, 0.1 * np.sin(frame))):
        glNormal3f(nx, ny, nz)
        glVertex3f(x, y, z)
    glEnd()
    glEndList()
    glCallList(name)
    glDeleteLists(name, 1)


def fresh_buffers(frame: int) -> None:
    """A buffer made, drawn and deleted, another shape in each frame."""
    mesh = np.ascontiguousarray(sphere(100, 0.1 * np.sin(frame)).reshape(-1, 6))
    store = vbo.VBO(mesh)
    with store:
        glEnableClientState(GL_VERTEX_ARRAY)
        glVertexPointer(3, GL_FLOAT, 24, store + 12)
        glDrawArrays(GL_QUADS, 0, len(mesh))
        glDisableClientState(GL_VERTEX_ARRAY)
    store.delete()


def fresh_shapes(frame: int) -> None:
    """A sphere drawn in C, of a size never seen before."""
    quadric = gluNewQuadric()
    gluSphere(quadric, 0.5 + 1e-4 * frame, 12, 8)
    gluDeleteQuadric(quadric)


SCENES: dict[str, Callable[[], Draw]] = {
    "immediate, 7k vertices": lambda: immediate(7_000),
    "immediate, 40k vertices": lambda: immediate(40_000),
    "immediate, 7k, glVertex3fv of lists": lambda: vectors(7_000),
    "immediate, 7k, another shape each frame": lambda: moving(7_000),
    "1,000 glBegin/glEnd of one quad": lambda: pairs(1_000),
    "display list, 10k polygons": lambda: display_list(10_000),
    "display list, 100k polygons": lambda: display_list(100_000),
    "display list, 10k, folded and crossing": lambda: crossed(10_000),
    "buffer object, 100k polygons": lambda: buffer(100_000),
    "2,000 matrix calls, 500 glCallList": lambda: matrices(2_000),
    "glCallLists of 500 lists": lambda: call_lists(500),
    "1 object, 112,000 triangles": lambda: turning(1, 112_000),
    "10 objects, 112,000 triangles": lambda: turning(10, 11_200),
    "100 objects, 112,000 triangles": lambda: turning(100, 1_120),
    "fresh lists": lambda: fresh_lists,
    "fresh buffers": lambda: fresh_buffers,
    "fresh shapes in C": lambda: fresh_shapes,
}


def open_window() -> object:
    glfw.init()
    window = glfw.create_window(*SIZE, "benchmark", None, None)
    glfw.make_context_current(window)
    glfw.swap_interval(0)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glMatrixMode(GL_PROJECTION)
    gluPerspective(40.0, SIZE[0] / SIZE[1], 1.0, 30.0)
    glMatrixMode(GL_MODELVIEW)
    return window


def one_frame(window: object, draw: Draw, frame: int) -> float:
    """Seconds that the frame took."""
    begin = time.perf_counter()
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glLoadIdentity()
    glTranslatef(0.0, 0.0, -8.0)
    glRotatef(20.0 + 0.7 * frame, 1.0, 1.0, 0.0)
    draw(frame)
    glFinish()
    glfw.swap_buffers(window)
    return time.perf_counter() - begin


def timed(name: str, seconds: float) -> dict[str, object]:
    """The first frame and the frames after the warm-up, in seconds; and of each of these
    the time of all processors, and the vertices."""
    window = open_window()
    draw = SCENES[name]()
    warm = [one_frame(window, draw, i) for i in range(WARM)]
    gc.collect()
    times: list[float] = []
    spent = time.process_time()
    while len(times) < 5 or (sum(times) < seconds and len(times) < 400):
        times.append(one_frame(window, draw, WARM + len(times)))
        glfw.poll_events()
    spent = (time.process_time() - spent) / len(times)
    vertices = submitted(window, draw, WARM + len(times))
    return {"first": warm[0], "frames": times, "processors": spent, "vertices": vertices}


def submitted(window: object, draw: Draw, frame: int) -> float | None:
    """Vertices that one frame sends through the pipeline, whoever draws them: OpenGL's own count,
    a mean over some frames. None where it does not count."""
    if b"GL_ARB_pipeline_statistics_query" not in glGetString(GL_EXTENSIONS).split():
        return None
    query = int(glGenQueries(1)[0])
    glBeginQuery(VERTICES_SUBMITTED, query)
    for turn in range(COUNTED):
        one_frame(window, draw, frame + turn)
    glEndQuery(VERTICES_SUBMITTED)
    count = ctypes.c_uint64()
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, count)
    return count.value / COUNTED


def resident() -> int:
    """Bytes of this process that lie in memory."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096


def memory(name: str, frames: int) -> dict[str, object]:
    """Bytes in memory after each tenth of the frames."""
    window = open_window()
    draw = SCENES[name]()
    sizes = []
    for frame in range(frames):
        one_frame(window, draw, frame)
        if (frame + 1) % (frames // 10) == 0:
            gc.collect()
            sizes.append(resident())
    return {"bytes": sizes}


if __name__ == "__main__":
    what, scene, amount = sys.argv[1:]
    result = timed(scene, float(amount)) if what == "time" else memory(scene, int(amount))
    print(json.dumps(result))
