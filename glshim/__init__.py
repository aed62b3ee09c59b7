"""glshim restyles unmodified PyOpenGL programs: silhouettes, ridges and other ink lines.

::

    import glshim
    glshim.install("raskar:ridges=off")   # before or after the program has imported PyOpenGL
    glshim.uninstall()

Names are loaded when first used, so that importing the package costs next to nothing.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from glshim.assembly.batch import PolygonBatch
    from glshim.errors import (
        EnvironmentFault,
        GlshimError,
        RenderError,
        StyleError,
        UnknownNameError,
    )
    from glshim.geometry.camera import Camera
    from glshim.geometry.poses import Keyframes, Skin
    from glshim.options import parse_style
    from glshim.pipeline import install, uninstall
    from glshim.styling.passes import Body, MeshShader, Pass, State, Stencil, bodies
    from glshim.styling.protocol import Colour, Draw, Layer, Shader, Styler, option

_HOMES = {
    "glshim.pipeline": ("install", "uninstall"),
    "glshim.options": ("parse_style",),
    "glshim.assembly.batch": ("PolygonBatch",),
    "glshim.geometry.camera": ("Camera",),
    "glshim.geometry.poses": ("Keyframes", "Skin"),
    "glshim.styling.passes": ("Body", "MeshShader", "Pass", "State", "Stencil", "bodies"),
    "glshim.styling.protocol": ("Colour", "Draw", "Layer", "Shader", "Styler", "option"),
    "glshim.errors": (
        "EnvironmentFault",
        "GlshimError",
        "RenderError",
        "StyleError",
        "UnknownNameError",
    ),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}

__version__ = "0.1.0"
__all__ = [
    "Body",
    "Camera",
    "Colour",
    "Draw",
    "EnvironmentFault",
    "GlshimError",
    "Keyframes",
    "Layer",
    "MeshShader",
    "Pass",
    "PolygonBatch",
    "RenderError",
    "Shader",
    "Skin",
    "State",
    "Stencil",
    "StyleError",
    "Styler",
    "UnknownNameError",
    "bodies",
    "install",
    "option",
    "parse_style",
    "uninstall",
]


def __getattr__(name: str) -> object:
    if name not in _HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    value = getattr(import_module(_HOME_OF[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
