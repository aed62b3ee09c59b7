"""Meshes from streams of polygons: welding, adjacency, windings, and finding them again."""
