"""What each draw buffer has of its own is as the program left it, with a style's surface, too."""

from __future__ import annotations

import glfw
import numpy as np
import pytest
from OpenGL import GL

from .world import prepare, styled, window


@pytest.mark.parametrize("style", ["raskar", "hiddenline", "two_pass:fill=#ff8000"])
def test_draw_buffers_keep_their_own(style: str) -> None:
    with styled(style), window() as handle:
        prepare()
        GL.glEnablei(GL.GL_BLEND, 0)
        GL.glBlendEquationi(3, GL.GL_MAX)
        GL.glColorMaski(2, True, False, True, False)
        GL.glRectf(-0.5, -0.5, 0.5, 0.5)
        glfw.swap_buffers(handle)
        assert [GL.glIsEnabledi(GL.GL_BLEND, i) for i in range(4)] == [1, 0, 0, 0]
        equations = [int(GL.glGetIntegeri_v(GL.GL_BLEND_EQUATION_RGB, i)) for i in range(4)]
        assert equations == [GL.GL_FUNC_ADD] * 3 + [GL.GL_MAX]
        mask = np.zeros(4, np.uint8)
        GL.glGetBooleani_v(GL.GL_COLOR_WRITEMASK, 2, mask)
        assert mask.tolist() == [1, 0, 1, 0]
