"""Frames of scenes of ordinary programs, restyled in this process."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np
import pygame
from numpy.typing import NDArray
from OpenGL import GL

import glshim
from tests.golden.scenery import HEIGHT, WIDTH

Picture = NDArray[np.int_]


@contextmanager
def window() -> Iterator[None]:
    """Of the scenes' size."""
    pygame.display.init()
    pygame.display.set_mode((WIDTH, HEIGHT), pygame.OPENGL | pygame.DOUBLEBUF)
    yield
    pygame.display.quit()


def shown(draw: Callable[[], None], style: str = "", frames: int = 1) -> Picture:
    """(height, width, 3) of 0..255, the last frame of the window, from below upwards."""
    width, height = pygame.display.get_window_size()
    if style:
        glshim.install(style)
    try:
        for _ in range(frames - 1):
            draw()
            pygame.display.flip()
        draw()
        pixels = GL.glReadPixels(0, 0, width, height, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
        pygame.display.flip()
    finally:
        glshim.uninstall()
    return np.frombuffer(pixels, np.uint8).reshape(height, width, 3).astype(int)
