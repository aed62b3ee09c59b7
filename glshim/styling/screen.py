"""Shaders over whole windows."""

from __future__ import annotations

from glshim.styling.glsl import glsl

SCREEN = glsl(__file__, "screen.vert")
"""The vertex shader of passes over element ``screen``: one triangle over the viewport."""
