"""Ordinary PyOpenGL programs for figures: each shows one thing from one side, and knows nothing of
glshim."""
