"""Where each pixel of a frame is in another: clip coordinates of one as a picture of the other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from OpenGL import GL
from OpenGL.GL import shaders

from tests import look
from tests.coherence.subjects import Frame, triangles

_VERTEX = """#version 120
varying vec4 there;
varying float number;
void main() { gl_Position = gl_Vertex; there = gl_MultiTexCoord0; number = gl_MultiTexCoord1.x; }
"""
_FRAGMENT = """#version 120
varying vec4 there;
varying float number;
void main() { gl_FragColor = vec4(0.5 * there.xyz / there.w + 0.5, number); }
"""
NEAR = 2e-3
"""Share of the depth that is left by which places may be behind what is drawn there."""


@dataclass(frozen=True)
class Motion:
    """From one frame to another, pixels with the first row at the bottom."""

    there: np.ndarray
    """(H, W, 2) x and y of each pixel centre in the other frame, NaN where no surface is."""
    depth: np.ndarray
    """(H, W) and its depth there."""
    body: np.ndarray
    """(H, W) the number of its batch, 0 for none."""
    seen: np.ndarray
    """(H, W) whether it is in the other frame's window and not hidden there."""


class Carrier:
    """Draws motions in the current window."""

    def __init__(self, width: int, height: int) -> None:
        self._size = width, height
        self._program = shaders.compileProgram(
            shaders.compileShader(_VERTEX, GL.GL_VERTEX_SHADER),
            shaders.compileShader(_FRAGMENT, GL.GL_FRAGMENT_SHADER),
        )
        self._framebuffer = GL.glGenFramebuffers(1)
        self._colour = GL.glGenTextures(1)
        depth = GL.glGenRenderbuffers(1)
        GL.glBindTexture(GL.GL_TEXTURE_2D, self._colour)
        GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGBA32F, width, height, 0, GL.GL_RGBA,
                        GL.GL_FLOAT, None)  # fmt: skip
        GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST)
        GL.glBindTexture(GL.GL_TEXTURE_2D, 0)
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, self._framebuffer)
        GL.glFramebufferTexture2D(GL.GL_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D,
                                  self._colour, 0)  # fmt: skip
        GL.glBindRenderbuffer(GL.GL_RENDERBUFFER, depth)
        GL.glRenderbufferStorage(GL.GL_RENDERBUFFER, GL.GL_DEPTH_COMPONENT24, width, height)
        GL.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, GL.GL_DEPTH_ATTACHMENT,
                                     GL.GL_RENDERBUFFER, depth)  # fmt: skip
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, 0)

    def motion(self, frame: Frame, other: Frame, depth: np.ndarray) -> Motion:
        """Of a frame to another one, whose depth (H, W) is given. Of batches whose polygons are
        not the same nothing is known."""
        width, height = self._size
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, self._framebuffer)
        GL.glUseProgram(self._program)
        GL.glDisable(GL.GL_BLEND)
        GL.glEnable(GL.GL_DEPTH_TEST)
        GL.glClearColor(0.0, 0.0, 0.0, 0.0)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        for number, (item, then) in enumerate(zip(frame, other, strict=True), 1):
            GL.glViewport(*item[1].viewport)
            at = item[0].corners[triangles(item[0])].ravel()
            here = _clip(item, at)
            same = np.array_equal(item[0].corners, then[0].corners)
            there = _clip(then, at) if same else np.full_like(here, np.nan)
            tags = np.zeros((len(here), 4), np.float32)
            tags[:, 0] = number
            GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
            GL.glVertexPointer(4, GL.GL_FLOAT, 0, here)
            for unit, rows in ((GL.GL_TEXTURE0, there), (GL.GL_TEXTURE1, tags)):
                GL.glClientActiveTexture(unit)
                GL.glEnableClientState(GL.GL_TEXTURE_COORD_ARRAY)
                GL.glTexCoordPointer(4, GL.GL_FLOAT, 0, rows)
            GL.glDrawArrays(GL.GL_TRIANGLES, 0, len(here))
        for unit in (GL.GL_TEXTURE1, GL.GL_TEXTURE0):
            GL.glClientActiveTexture(unit)
            GL.glDisableClientState(GL.GL_TEXTURE_COORD_ARRAY)
        GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
        GL.glUseProgram(0)
        raw = GL.glReadPixels(0, 0, width, height, GL.GL_RGBA, GL.GL_FLOAT)
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, 0)
        found = np.asarray(raw, np.float32).reshape(height, width, 4)
        body = np.rint(found[..., 3]).astype(int)
        x, y, w, h = frame[0][1].viewport
        there = found[..., :2].astype(float) * (w, h) + (x, y)
        there[body == 0] = np.nan
        behind = found[..., 2]
        return Motion(there, behind, body, _seen(there, behind, depth))


def _clip(item: tuple, at: np.ndarray) -> np.ndarray:
    batch, camera = item
    points = np.concatenate((batch.positions[at].astype(float), np.ones((len(at), 1))), axis=1)
    return np.ascontiguousarray(points @ (camera.projection @ camera.modelview).T, np.float32)


def _seen(there: np.ndarray, behind: np.ndarray, depth: np.ndarray) -> np.ndarray:
    height, width = depth.shape
    with np.errstate(invalid="ignore"):
        x, y = there[..., 0], there[..., 1]
        sound = (x > 1) & (y > 1) & (x < width - 2) & (y < height - 2)
    column, row = (np.where(sound, at, 1).astype(int) for at in (x, y))
    farthest = np.max(
        [depth[row + j, column + i] for i in (-1, 0, 1) for j in (-1, 0, 1)], axis=0
    )
    return sound & (behind <= farthest + NEAR * (1.0 - farthest) + 1e-6)


def draw_base(frame: Frame, corner_colours: list[np.ndarray], surface: object) -> None:
    """The program's picture with a style's surface: colours, one colour, or depth alone."""
    for (batch, camera), given in zip(frame, corner_colours, strict=True):
        at = triangles(batch).ravel()
        GL.glViewport(*camera.viewport)
        GL.glDepthRange(*camera.depth_range)
        GL.glMatrixMode(GL.GL_PROJECTION)
        GL.glLoadMatrixd(np.ascontiguousarray(camera.projection.T))
        GL.glMatrixMode(GL.GL_MODELVIEW)
        GL.glLoadMatrixd(np.ascontiguousarray(camera.modelview.T))
        if surface == "none":
            GL.glColorMask(0, 0, 0, 0)
        flat = isinstance(surface, tuple)
        shades = np.broadcast_to(np.asarray(surface), given.shape) if flat else given
        points = np.ascontiguousarray(batch.positions[batch.corners[at]], np.float32)
        paints = np.ascontiguousarray(shades[at], np.float32)
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glEnableClientState(GL.GL_COLOR_ARRAY)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, points)
        GL.glColorPointer(3, GL.GL_FLOAT, 0, paints)
        GL.glDrawArrays(GL.GL_TRIANGLES, 0, len(points))
        GL.glDisableClientState(GL.GL_COLOR_ARRAY)
        GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
        GL.glColorMask(1, 1, 1, 1)


def clear(shade: float) -> None:
    look.clear((shade, shade, shade))
