"""Hooks on PyOpenGL and on the toolkits' frame ends; the recorded stream."""
