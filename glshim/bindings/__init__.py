"""How a program speaks OpenGL. A binding gives every call by its role."""
