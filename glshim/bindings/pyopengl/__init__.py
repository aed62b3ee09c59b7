"""PyOpenGL: hooks on its raw layer and wrappers, the recorder, calls by role."""
