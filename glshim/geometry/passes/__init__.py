"""What passes over meshes decide: the numpy references of their shaders, and sieves before them."""
