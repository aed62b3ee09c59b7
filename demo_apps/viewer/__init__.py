"""A model viewer: `python -m demo_apps.viewer [MODEL]`.

MODEL is a built-in shape or an OBJ, PLY, STL or glTF file; h in its window lists the keys. glfw
opens the window; display lists of fixed-function OpenGL draw.
"""

from .models import FILES, ModelError, load

__all__ = ["FILES", "ModelError", "load", "main"]


def main(arguments: "list[str] | None" = None) -> int:
    """The command; its exit status."""
    from .command import main as run  # OpenGL: the process that loads models has no use for it

    return run(arguments)
