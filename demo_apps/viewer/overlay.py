"""What lies over the picture: text on panels, a bar, axes. Pillow draws text into textures."""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import zip_longest

import numpy as np
from OpenGL import GL
from PIL import Image, ImageDraw, ImageFont

INK, GROUND = (0.10, 0.13, 0.18, 1.0), (1.0, 1.0, 1.0, 0.86)
BAR = (0.20, 0.45, 0.75, 1.0)
MARGIN, COLUMN = 10, 16
POINTS = 14
AXES = {"x": (0.85, 0.2, 0.2), "y": (0.15, 0.6, 0.2), "z": (0.2, 0.35, 0.9)}


class Overlay:
    """Draws in pixels, the origin at the upper left corner, inside `over`."""

    def __init__(self) -> None:
        try:
            self._font = ImageFont.load_default(POINTS)
        except TypeError:  # Pillow before 10.1 has its font in one size
            self._font = ImageFont.load_default()
        self._texts: dict[str, tuple[int, int, int]] = {}
        self._size = (1, 1)

    @contextmanager
    def over(self, size: tuple[int, int]) -> Iterator[None]:
        """Two dimensions over the window; the state of three comes back afterwards."""
        self._size = size
        GL.glPushAttrib(GL.GL_ENABLE_BIT | GL.GL_COLOR_BUFFER_BIT | GL.GL_CURRENT_BIT
                        | GL.GL_POLYGON_BIT | GL.GL_LIGHTING_BIT)
        GL.glPolygonMode(GL.GL_FRONT_AND_BACK, GL.GL_FILL)
        for capability in (GL.GL_DEPTH_TEST, GL.GL_LIGHTING, GL.GL_CULL_FACE):
            GL.glDisable(capability)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
        for mode in (GL.GL_PROJECTION, GL.GL_MODELVIEW):
            GL.glMatrixMode(mode)
            GL.glPushMatrix()
            GL.glLoadIdentity()
        GL.glOrtho(0.0, size[0], size[1], 0.0, -1.0, 1.0)
        yield
        for mode in (GL.GL_PROJECTION, GL.GL_MODELVIEW):
            GL.glMatrixMode(mode)
            GL.glPopMatrix()
        GL.glPopAttrib()

    def panel(self, text: str, *, top: bool = True) -> None:
        """Lines of text on a ground, in the upper or the lower left corner; tabs part columns."""
        _, width, height = self._text(text)
        y = MARGIN if top else self._size[1] - height - 3 * MARGIN
        self._box(MARGIN, y, width + 2 * MARGIN, height + 2 * MARGIN, GROUND)
        self._write(text, 2 * MARGIN, y + MARGIN)

    def table(self, text: str) -> None:
        """A panel of lines that stand in two halves beside each other where the window is low."""
        _, _, height = self._text(text)
        lines = text.split("\n")
        if height + 4 * MARGIN > self._size[1]:
            half = (len(lines) + 1) // 2
            pairs = zip_longest(lines[:half], lines[half:], fillvalue="\t")
            text = "\n".join("\t".join(pair) for pair in pairs)
        self.panel(text)

    def bar(self, text: str, share: float | None) -> None:
        """How far something is, at the foot of the window; None where nobody knows."""
        _, _, height = self._text(text)
        width = self._size[0] - 4 * MARGIN
        y = self._size[1] - height - 5 * MARGIN
        self._box(MARGIN, y, self._size[0] - 2 * MARGIN, height + 4 * MARGIN, GROUND)
        self._write(text, 2 * MARGIN, y + MARGIN)
        foot = y + height + 2 * MARGIN
        self._box(2 * MARGIN, foot, width, MARGIN // 2, (0.8, 0.8, 0.8, 1.0))
        if share is not None:
            self._box(2 * MARGIN, foot, width * min(share, 1.0), MARGIN // 2, BAR)

    def axes(self, modelview: "np.ndarray") -> None:
        """The directions of x, y and z in the lower right corner."""
        length = 34.0
        x, y = self._size[0] - length - 2 * MARGIN, self._size[1] - length - 2 * MARGIN
        GL.glLineWidth(2.0)
        for axis, (name, colour) in enumerate(AXES.items()):
            right, up = modelview[0, axis], modelview[1, axis]
            GL.glColor3f(*colour)
            GL.glBegin(GL.GL_LINES)
            GL.glVertex2f(x, y)
            GL.glVertex2f(x + length * right, y - length * up)
            GL.glEnd()
            self._write(name, x + (length + 8) * right - 4, y - (length + 8) * up - 9, colour)
        GL.glLineWidth(1.0)

    def _box(self, x: float, y: float, width: float, height: float,
             colour: tuple[float, ...]) -> None:
        GL.glColor4f(*colour)
        GL.glRectf(x, y, x + width, y + height)

    def _write(self, text: str, x: float, y: float, ink: tuple[float, ...] = INK) -> None:
        texture, width, height = self._text(text)
        x, y = round(x), round(y)
        GL.glEnable(GL.GL_TEXTURE_2D)
        GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
        GL.glColor4f(*(*ink, 1.0)[:4])
        GL.glBegin(GL.GL_QUADS)
        for right, down in ((0, 0), (0, 1), (1, 1), (1, 0)):
            GL.glTexCoord2f(right, down)
            GL.glVertex2f(x + right * width, y + down * height)
        GL.glEnd()
        GL.glBindTexture(GL.GL_TEXTURE_2D, 0)
        GL.glDisable(GL.GL_TEXTURE_2D)

    def _text(self, text: str) -> tuple[int, int, int]:
        """A texture of a text, its width and its height."""
        if text not in self._texts:
            if len(self._texts) > 64:  # times and shares pass by
                GL.glDeleteTextures([name for name, _, _ in self._texts.values()])
                self._texts.clear()
            self._texts[text] = self._made(text)
        return self._texts[text]

    def _made(self, text: str) -> tuple[int, int, int]:
        rows = [line.split("\t") for line in text.split("\n")]
        columns = ["\n".join(cells) for cells in zip_longest(*rows, fillvalue="")]
        probe = ImageDraw.Draw(Image.new("L", (1, 1)))
        boxes = [probe.multiline_textbbox((0, 0), column, self._font, spacing=6)
                 for column in columns]
        width = sum(int(box[2]) + 1 for box in boxes) + COLUMN * (len(boxes) - 1)
        height = max(int(box[3]) + 1 for box in boxes)
        picture = Image.new("L", (width, height), 0)
        x = 0
        for column, box in zip(columns, boxes, strict=True):
            ImageDraw.Draw(picture).multiline_text((x, 0), column, 255, self._font, spacing=6)
            x += int(box[2]) + 1 + COLUMN
        name = int(GL.glGenTextures(1))
        GL.glBindTexture(GL.GL_TEXTURE_2D, name)
        for parameter in (GL.GL_TEXTURE_MIN_FILTER, GL.GL_TEXTURE_MAG_FILTER):
            GL.glTexParameteri(GL.GL_TEXTURE_2D, parameter, GL.GL_NEAREST)
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
        GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_ALPHA, width, height, 0, GL.GL_ALPHA,
                        GL.GL_UNSIGNED_BYTE, np.asarray(picture))
        GL.glBindTexture(GL.GL_TEXTURE_2D, 0)
        return name, width, height
