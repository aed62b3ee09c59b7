"""Raskar 2001, sections 2.1 and 2.2, to the letter, in numpy and immediate mode.

Every polygon alone and in the order of sending: a front-facing one is drawn, and black quads are
attached to its sides at the threshold angle; a back-facing one is enlarged and drawn black. Depth
alone decides (GL_LESS). Nothing else is done: no neighbours, no bounds, no clipping, no smoothing.
Perspective projections only.

    silhouette  P_k + w z sin(a) (V.C)/(V.N) (E x N)           the polygon of all these, 2n corners
    ridge       P_k + w z sin(a) (V.C)/(V.N_ij) Q_ij            a quad on each side
                N_ij = -N cos t + (E x N) sin t,  Q_ij = -N sin t - (E x N) cos t

with V from the viewer to the corner P_k, E along the side, N outwards, C the camera's axis, z the
depth of P_k, a the angle between V and E, t the threshold, and w the width in pixels over the
focal length in pixels.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from OpenGL import GL

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from tests import look

_AXIS = np.array([0.0, 0.0, -1.0])


def draw(
    items: Sequence[tuple[PolygonBatch, Camera]],
    *,
    silhouette_width: float | None = None,
    quad_width: float | None = None,
    ridge_angle: float = 120.0,
    shade: tuple[float, float, float] = (0.8, 0.8, 0.8),
) -> None:
    """Draw items into the current framebuffer. Widths in pixels (None: no such lines), the angle
    in degrees; quad_width is that of one quad."""
    GL.glDepthFunc(GL.GL_LESS)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    for batch, camera in items:
        GL.glViewport(*camera.viewport)
        GL.glMatrixMode(GL.GL_PROJECTION)
        GL.glLoadMatrixd(np.ascontiguousarray(camera.projection.T))
        GL.glMatrixMode(GL.GL_MODELVIEW)
        focal = camera.projection[1, 1] * camera.viewport[3] / 2
        turn, shift = camera.modelview[:3, :3], camera.modelview[:3, 3]
        for polygon in look.polygons_of(batch):
            corners = batch.positions[polygon].astype(float) @ turn.T + shift
            corners = corners[np.abs(corners - np.roll(corners, 1, axis=0)).max(axis=1) > 1e-9]
            spokes = corners - corners.mean(axis=0)
            normal = _unit(np.cross(spokes, np.roll(spokes, -1, axis=0)).sum(axis=0))
            if normal @ corners[0] < 0:
                _fill(corners, shade)
                if quad_width is not None:
                    for quad in ridge_quads(corners, normal, quad_width / focal, ridge_angle):
                        _fill(quad, (0, 0, 0))
            elif silhouette_width is not None:
                _fill(enlarged(corners, normal, silhouette_width / focal), (0, 0, 0))


def enlarged(corners: np.ndarray, normal: np.ndarray, w: float) -> np.ndarray:
    """(2n, 3) corners of the enlarged polygon, eye space (section 2.1)."""
    found = []
    for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        along = _unit(end - start)
        outwards = np.cross(along, normal)
        found += [p + _travel(p, along, normal, w) * outwards for p in (start, end)]
    return np.array(found)


def ridge_quads(
    corners: np.ndarray, normal: np.ndarray, w: float, angle: float
) -> list[np.ndarray]:
    """The quads (4, 3) on each side of a polygon, at an angle in degrees, eye space (2.2)."""
    cosine, sine = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    quads = []
    for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        along = _unit(end - start)
        outwards = np.cross(along, normal)
        own = -normal * cosine + outwards * sine
        down = -normal * sine - outwards * cosine
        far = [p + _travel(p, along, own, w) * down for p in (start, end)]
        quads.append(np.array([start, end, far[1], far[0]]))
    return quads


def _travel(point: np.ndarray, along: np.ndarray, normal: np.ndarray, w: float) -> float:
    """``w z sin(a) (V.C)/(V.N)`` in eye units."""
    sight = _unit(point)
    sine = np.sqrt(max(1.0 - (sight @ along) ** 2, 0.0))
    return float(w * -point[2] * sine * (sight @ _AXIS) / max(abs(sight @ normal), 1e-12))


def _fill(corners: np.ndarray, shade: tuple[float, float, float]) -> None:
    GL.glColor3f(*shade)
    GL.glBegin(GL.GL_POLYGON)
    for corner in corners:
        GL.glVertex3d(*corner)
    GL.glEnd()


def _unit(vector: np.ndarray) -> np.ndarray:
    return vector / max(np.linalg.norm(vector), 1e-300)
