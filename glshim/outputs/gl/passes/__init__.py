"""Passes over recovered meshes: meshes as textures, a stage to draw on, programs."""
