"""Edges of polygons and meshes: which sides meet, and how they fold."""
