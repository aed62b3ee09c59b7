"""glshim: restyles unmodified PyOpenGL programs."""
