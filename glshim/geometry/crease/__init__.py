"""Creases by normals and by angle, and the quads that show them."""
