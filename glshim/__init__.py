"""glshim restyles unmodified PyOpenGL programs: silhouettes, ridges and other ink lines.

::

    import glshim
    glshim.install("raskar:ridges=off")   # before or after the program has imported PyOpenGL
    glshim.uninstall()

Names are loaded when first used, so that importing the package costs next to nothing.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from glshim.errors import (
        EnvironmentFault,
        GlshimError,
        RenderError,
        StyleError,
        UnknownNameError,
    )
    from glshim.geometry.crease.creases import Criterion
    from glshim.geometry.meshshaders.poses import Keyframes, Skin
    from glshim.model.batch import PolygonBatch
    from glshim.model.camera import Camera
    from glshim.pipeline import install, uninstall
    from glshim.styling.fixed import BackFaces
    from glshim.styling.lines import Draw, Expansion, Lines, Medium, Shader
    from glshim.styling.passes import (
        HEADLIGHT,
        MeshShader,
        Pass,
        Primitives,
        Sieve,
        State,
        Stencil,
        Weld,
        bodies,
    )
    from glshim.styling.pictures import Image, read_image
    from glshim.styling.protocol import Option, Styler, option, options_of
    from glshim.styling.texts import parse_style
    from glshim.styling.values import Body, Colour, Layer, Uniform
    from glshim.styling.wishes import Choice, Features, Pattern

_HOMES = {
    "glshim.pipeline": ("install", "uninstall"),
    "glshim.styling.texts": ("parse_style",),
    "glshim.model.batch": ("PolygonBatch",),
    "glshim.model.camera": ("Camera",),
    "glshim.geometry.crease.creases": ("Criterion",),
    "glshim.geometry.meshshaders.poses": ("Keyframes", "Skin"),
    "glshim.styling.fixed": ("BackFaces",),
    "glshim.styling.lines": ("Draw", "Expansion", "Lines", "Medium", "Shader"),
    "glshim.styling.passes": (
        "HEADLIGHT",
        "MeshShader",
        "Pass",
        "Primitives",
        "Sieve",
        "State",
        "Stencil",
        "Weld",
        "bodies",
    ),
    "glshim.styling.pictures": ("Image", "read_image"),
    "glshim.styling.protocol": ("Option", "Styler", "option", "options_of"),
    "glshim.styling.values": ("Body", "Colour", "Layer", "Uniform"),
    "glshim.styling.wishes": ("Choice", "Features", "Pattern"),
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
    "HEADLIGHT",
    "BackFaces",
    "Body",
    "Camera",
    "Choice",
    "Colour",
    "Criterion",
    "Draw",
    "EnvironmentFault",
    "Expansion",
    "Features",
    "GlshimError",
    "Image",
    "Keyframes",
    "Layer",
    "Lines",
    "Medium",
    "MeshShader",
    "Option",
    "Pass",
    "Pattern",
    "PolygonBatch",
    "Primitives",
    "RenderError",
    "Shader",
    "Sieve",
    "Skin",
    "State",
    "Stencil",
    "StyleError",
    "Styler",
    "Uniform",
    "UnknownNameError",
    "Weld",
    "bodies",
    "install",
    "option",
    "options_of",
    "parse_style",
    "read_image",
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
