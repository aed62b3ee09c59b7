"""Ordinary PyOpenGL programs that never import glshim, and the viewer."""
