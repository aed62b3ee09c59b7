"""Numpy references of shaders that no run of glshim needs: tests hold the GPU to them."""
