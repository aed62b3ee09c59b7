"""A model in display lists: one for each of its surfaces, of very large ones several."""

import numpy as np
from OpenGL import GL, GLU

from .prepare import Ready, Surface

CLAY = (0.72, 0.70, 0.66)
PIECE = 2_000_000  # polygons of one list: the fewer lists, the faster all that looks into them
MODES = {3: GL.GL_TRIANGLES, 4: GL.GL_QUADS}


class Sent:
    """What of a model lies with OpenGL. `send` makes one more list."""

    def __init__(self, model: Ready) -> None:
        self.model = model
        self._lists: list[int] = []
        self._textures: list[int] = []
        self._pieces = [(surface, polygons[i : i + PIECE]) for surface in model.surfaces
                        for polygons in surface.polygons for i in range(0, len(polygons), PIECE)]
        self._texture_of: dict[int, int] = {}

    @property
    def share(self) -> float:
        return len(self._lists) / max(len(self._pieces), 1)

    def send(self) -> None:
        """One piece."""
        if self.share < 1.0:
            surface, polygons = self._pieces[len(self._lists)]
            texture = self._texture(surface)
            name = int(GL.glGenLists(1))
            GL.glNewList(name, GL.GL_COMPILE)
            draw(surface, polygons, texture)
            GL.glEndList()
            self._lists.append(name)

    def draw(self) -> None:
        for name in self._lists:
            GL.glCallList(name)

    def delete(self) -> None:
        for name in self._lists:
            GL.glDeleteLists(name, 1)
        if self._textures:
            GL.glDeleteTextures(self._textures)
        self._lists, self._textures = [], []

    def _texture(self, surface: Surface) -> int:
        if surface.picture is None:
            return 0
        if id(surface) not in self._texture_of:
            self._texture_of[id(surface)] = textured(surface.picture)
            self._textures.append(self._texture_of[id(surface)])
        return self._texture_of[id(surface)]


def draw(surface: Surface, polygons: "np.ndarray", texture: int) -> None:
    """Indexed arrays: what a display list takes in."""
    GL.glColor3f(*CLAY)
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
    # Of the vertices those that the piece needs: a list takes in whole arrays where it is told to.
    rows, index = np.unique(polygons, return_inverse=True)
    GL.glVertexPointerf(surface.positions[rows])
    GL.glNormalPointerf(surface.normals[rows])
    if surface.colours is not None:
        GL.glEnableClientState(GL.GL_COLOR_ARRAY)
        GL.glColorPointerf(surface.colours[rows])
    if texture and surface.places is not None:
        GL.glEnable(GL.GL_TEXTURE_2D)
        GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
        GL.glEnableClientState(GL.GL_TEXTURE_COORD_ARRAY)
        GL.glTexCoordPointerf(surface.places[rows])
    GL.glDrawElementsui(MODES[polygons.shape[1]], index.astype(np.uint32).ravel())
    if texture:
        GL.glDisable(GL.GL_TEXTURE_2D)
    for array in (GL.GL_TEXTURE_COORD_ARRAY, GL.GL_COLOR_ARRAY, GL.GL_NORMAL_ARRAY,
                  GL.GL_VERTEX_ARRAY):
        GL.glDisableClientState(array)


def textured(picture: "np.ndarray") -> int:
    """A texture with mipmaps of a picture (height, width, 4) uint8, first row on top."""
    name = int(GL.glGenTextures(1))
    GL.glBindTexture(GL.GL_TEXTURE_2D, name)
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_LINEAR_MIPMAP_LINEAR)
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
    height, width = picture.shape[:2]
    GLU.gluBuild2DMipmaps(GL.GL_TEXTURE_2D, GL.GL_RGBA, width, height, GL.GL_RGBA,
                          GL.GL_UNSIGNED_BYTE, np.ascontiguousarray(picture[::-1]))
    GL.glBindTexture(GL.GL_TEXTURE_2D, 0)
    return name


