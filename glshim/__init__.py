"""glshim restyles unmodified PyOpenGL programs: silhouettes, ridges and other ink lines.

::

    import glshim
    glshim.install("raskar:ridges=off")   # before or after the program has imported PyOpenGL
    glshim.uninstall()

    with glshim.style("raskar", ridge_width=4) as s:   # for a part of the program
        draw_scene()
        picture = s.image()               # (height, width, 3) uint8

Names are loaded when first used, so that importing the package costs next to nothing.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:  # the same once more, for those who check types
    from glshim.errors import EnvironmentFault as EnvironmentFault
    from glshim.errors import GlshimError as GlshimError
    from glshim.errors import RenderError as RenderError
    from glshim.errors import StyleError as StyleError
    from glshim.errors import UnknownNameError as UnknownNameError
    from glshim.geometry.crease.creases import Criterion as Criterion
    from glshim.geometry.meshshaders.edge_mesh import BOUNDARY as BOUNDARY
    from glshim.geometry.meshshaders.edge_mesh import CONTOUR as CONTOUR
    from glshim.geometry.meshshaders.edge_mesh import MARKED as MARKED
    from glshim.geometry.meshshaders.edge_mesh import RIDGE as RIDGE
    from glshim.geometry.meshshaders.edge_mesh import VALLEY as VALLEY
    from glshim.geometry.meshshaders.poses import Keyframes as Keyframes
    from glshim.geometry.meshshaders.poses import Skin as Skin
    from glshim.geometry.meshshaders.sieve import CREASE as CREASE
    from glshim.geometry.meshshaders.sieve import SMOOTH as SMOOTH
    from glshim.model.batch import PolygonBatch as PolygonBatch
    from glshim.model.boxes import Box as Box
    from glshim.model.boxes import overlap as overlap
    from glshim.model.boxes import without as without
    from glshim.model.camera import Camera as Camera
    from glshim.model.dihedral import GRAIN as GRAIN
    from glshim.model.dihedral import crease_limits as crease_limits
    from glshim.model.fog import Fog as Fog
    from glshim.model.lights import Light as Light
    from glshim.model.lights import Lighting as Lighting
    from glshim.pipeline import install as install
    from glshim.pipeline import uninstall as uninstall
    from glshim.running.restyling import Restyling as Restyling
    from glshim.running.restyling import style as style
    from glshim.styling.fixed import BackFaces as BackFaces
    from glshim.styling.glsl import glsl as glsl
    from glshim.styling.lines import Draw as Draw
    from glshim.styling.lines import Expansion as Expansion
    from glshim.styling.lines import Lines as Lines
    from glshim.styling.lines import Medium as Medium
    from glshim.styling.lines import Shader as Shader
    from glshim.styling.media.hand import brush as brush
    from glshim.styling.media.hand import hand as hand
    from glshim.styling.media.hand import outlines as outlines
    from glshim.styling.media.hand import pencil as pencil
    from glshim.styling.media.hand import pictured as pictured
    from glshim.styling.media.hand import reseeded as reseeded
    from glshim.styling.media.ink import STROKE as STROKE
    from glshim.styling.media.ink import TRACE as TRACE
    from glshim.styling.media.ink import Hidden as Hidden
    from glshim.styling.media.ink import dashes as dashes
    from glshim.styling.media.ink import ink as ink
    from glshim.styling.options import Option as Option
    from glshim.styling.options import option as option
    from glshim.styling.options import options_of as options_of
    from glshim.styling.passes import HEADLIGHT as HEADLIGHT
    from glshim.styling.passes import Actions as Actions
    from glshim.styling.passes import MeshShader as MeshShader
    from glshim.styling.passes import Pass as Pass
    from glshim.styling.passes import Primitives as Primitives
    from glshim.styling.passes import Sieve as Sieve
    from glshim.styling.passes import State as State
    from glshim.styling.passes import Stencil as Stencil
    from glshim.styling.passes import Weld as Weld
    from glshim.styling.passes import bodies as bodies
    from glshim.styling.pictures import Image as Image
    from glshim.styling.pictures import is_coloured as is_coloured
    from glshim.styling.pictures import read_image as read_image
    from glshim.styling.protocol import Styler as Styler
    from glshim.styling.renamed import Renamed as Renamed
    from glshim.styling.renamed import takes_old_names as takes_old_names
    from glshim.styling.screen import SCREEN as SCREEN
    from glshim.styling.texts import parse_style as parse_style
    from glshim.styling.textures import MADE as MADE
    from glshim.styling.textures import TEXTURES as TEXTURES
    from glshim.styling.textures import made as made
    from glshim.styling.textures.brushes import BRUSHES as BRUSHES
    from glshim.styling.textures.fields import Doubles as Doubles
    from glshim.styling.textures.fields import even as even
    from glshim.styling.textures.fields import noise as noise
    from glshim.styling.values import Body as Body
    from glshim.styling.values import Colour as Colour
    from glshim.styling.values import Layer as Layer
    from glshim.styling.values import Place as Place
    from glshim.styling.values import Uniform as Uniform
    from glshim.styling.wishes import Choice as Choice
    from glshim.styling.wishes import Features as Features
    from glshim.styling.wishes import Pattern as Pattern

_HOMES = {
    "glshim.errors": "EnvironmentFault GlshimError RenderError StyleError UnknownNameError",
    "glshim.geometry.crease.creases": "Criterion",
    "glshim.geometry.meshshaders.edge_mesh": "BOUNDARY CONTOUR MARKED RIDGE VALLEY",
    "glshim.geometry.meshshaders.poses": "Keyframes Skin",
    "glshim.geometry.meshshaders.sieve": "CREASE SMOOTH",
    "glshim.model.batch": "PolygonBatch",
    "glshim.model.boxes": "Box overlap without",
    "glshim.model.camera": "Camera",
    "glshim.model.dihedral": "crease_limits GRAIN",
    "glshim.model.fog": "Fog",
    "glshim.model.lights": "Light Lighting",
    "glshim.pipeline": "install uninstall",
    "glshim.running.restyling": "Restyling style",
    "glshim.styling.fixed": "BackFaces",
    "glshim.styling.glsl": "glsl",
    "glshim.styling.lines": "Draw Expansion Lines Medium Shader",
    "glshim.styling.media.hand": "brush hand outlines pencil pictured reseeded",
    "glshim.styling.media.ink": "dashes Hidden ink STROKE TRACE",
    "glshim.styling.options": "Option option options_of",
    "glshim.styling.passes": "Actions bodies HEADLIGHT MeshShader Pass "
        "Primitives Sieve State Stencil Weld",
    "glshim.styling.pictures": "Image is_coloured read_image",
    "glshim.styling.protocol": "Styler",
    "glshim.styling.renamed": "Renamed takes_old_names",
    "glshim.styling.screen": "SCREEN",
    "glshim.styling.texts": "parse_style",
    "glshim.styling.textures": "MADE made TEXTURES",
    "glshim.styling.textures.brushes": "BRUSHES",
    "glshim.styling.textures.fields": "Doubles even noise",
    "glshim.styling.values": "Body Colour Layer Place Uniform",
    "glshim.styling.wishes": "Choice Features Pattern",
}  # fmt: skip
"""The public names by the module that each is loaded from."""
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names.split()}

__version__ = "0.1.0"
__all__ = list(_HOME_OF)


def __getattr__(name: str) -> object:
    if name not in _HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    value = getattr(import_module(_HOME_OF[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
