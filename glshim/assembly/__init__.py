"""Recorded stream to polygons."""
