"""What each GL entry point means to the shim, as data. A new GL function is a row here.

Every name that PyOpenGL knows has exactly one role: the row whose pattern matches it whole, or
PASS when no row does. ``tests/contract/test_roles.py`` holds that no name is claimed twice, that no
row is dead, and that nothing that draws, clears or reads back slips into PASS unseen.
"""

from __future__ import annotations

import re
from enum import Enum
from functools import cache


class Role(Enum):
    """The meaning of an entry point."""

    PASS = "not touched: the app calls the driver as ever"
    BEGIN = "opens a primitive"
    END = "closes a primitive"
    ATTRIBUTE = "a vertex or an attribute of one, recorded (signatures: spec/attributes.py)"
    IN_PRIMITIVE = "legal inside a primitive, not recorded: what was recorded so far goes first"
    NORMAL = "the same, and sets the normal (signatures: spec/attributes.py)"
    MATERIAL = "the same, and sets a material"
    ARRAY_ELEMENT = "the same, and takes one vertex from the arrays"
    EVALUATION = "the same, and evaluates vertices"
    ARRAY_DRAW = "draws from client arrays or buffers (signatures: spec/draws.py)"
    OPAQUE_DRAW = "draws something we do not restyle"
    RECT = "draws one axis-parallel rectangle (signatures: spec/draws.py)"
    EVALUATOR_MESH = "draws an evaluated grid (its maps: spec/draws.py)"
    BITMAP = "writes the ones of a bitmap in one colour: text"
    PIXELS = "writes pixels without polygons"
    LIST_OPEN = "opens a display list"
    LIST_CLOSE = "closes a display list"
    LIST_CALL = "runs the display list of a name"
    LISTS_CALL = "runs display lists, whose names are in an array"
    LIST_FORGET = "deletes display lists"
    MATRIX = "changes the current matrix (how: spec/matrices.py)"
    MATRIX_MODE = "chooses which matrix is current"
    MATRIX_PUSH = "keeps the current matrix"
    MATRIX_POP = "puts the kept matrix back"
    ENABLE = "turns a switch on"
    COLOUR_MATERIAL = "says which materials follow the current colour"
    DISABLE = "turns a switch off"
    WINDING = "says which winding is the front"
    DEPTH_MASK = "says whether depth is written"
    POLYGON_MODE = "says whether polygons are filled"
    ATTRIB_PUSH = "keeps groups of state"
    ATTRIB_POP = "puts kept groups of state back"
    CLEAR = "clears the buffers of a mask: the depth of a layer ends"
    CLEAR_BUFFER = "clears one buffer, taken for both colour and depth"
    READ_PIXELS = "reads pixels back: the layer must be in them, but for a few that are for picking"
    READBACK = "reads the picture back another way: the layer must be in it"
    TARGET = "turns drawing to another framebuffer: the layer ends"
    READ_IMAGE = "reads a texture's image back to the app"
    FLUSH = "glFlush, glFinish: the end of a frame in a single-buffered window"
    BUFFER_WRITE = "changes what the buffer object bound to a target holds"
    NAMED_BUFFER_WRITE = "changes what the buffer object of a name holds"
    BUFFERS_WRITE = "changes what some buffer objects hold"
    CLIP_PLANE = "sets a user clip plane"
    QUERY_OPEN = "begins to count what is drawn"
    CONDITION_OPEN = "lets what is drawn depend on a query"
    CONDITION_CLOSE = "lets it depend on nothing"
    RENDER_MODE = "lets the driver write what is drawn into the app's memory, or no more"
    OTHER_PROGRAM = "has to do with vertex programs that are not glUseProgram's"

    __hash__ = object.__hash__
    """Members are one each: Enum's own is written in Python and costs each hooked call."""


INSIDE = frozenset(
    (Role.IN_PRIMITIVE, Role.NORMAL, Role.MATERIAL, Role.ARRAY_ELEMENT, Role.EVALUATION)
)
"""Legal inside a primitive and not recorded."""
MATERIAL_TYPES = {"glMaterialfv": "f", "glMaterialiv": "i"}
"""Calls of MATERIAL that set colours, and the type of their numbers."""
LIST_CALLS = frozenset((Role.LIST_CALL, Role.LISTS_CALL))
LIST_BRACKETS = frozenset((Role.LIST_OPEN, Role.LIST_CLOSE))
POLYGON_DRAWS = frozenset((Role.ARRAY_DRAW, Role.RECT, Role.EVALUATOR_MESH, *LIST_CALLS))
"""Draw polygons that we can know."""
OTHER_DRAWS = frozenset((Role.BITMAP, Role.PIXELS, Role.OPAQUE_DRAW))
BUFFER_WRITES = frozenset((Role.BUFFER_WRITE, Role.NAMED_BUFFER_WRITE, Role.BUFFERS_WRITE))
CONDITIONS = frozenset((Role.CONDITION_OPEN, Role.CONDITION_CLOSE))
IN_LISTS = frozenset(
    (
        Role.MATRIX, Role.MATRIX_MODE, Role.MATRIX_PUSH, Role.MATRIX_POP, Role.ENABLE,
        Role.DISABLE, Role.WINDING, Role.DEPTH_MASK, Role.POLYGON_MODE, Role.ATTRIB_PUSH,
        Role.ATTRIB_POP, Role.COLOUR_MATERIAL,
    )
)  # fmt: skip
"""Followed only while a display list is open; else the driver is asked."""
READERS = frozenset((Role.READBACK, Role.READ_IMAGE, Role.TARGET))
"""They read the picture, or turn to another one."""
RENEWALS = frozenset((Role.CLEAR, Role.CLEAR_BUFFER, Role.TARGET, Role.LIST_OPEN))
"""When a new context at an old one's address is looked out for: a program that draws comes by."""
WATCHED = (
    POLYGON_DRAWS | OTHER_DRAWS | LIST_BRACKETS | BUFFER_WRITES | CONDITIONS
    | {
        Role.LIST_FORGET, Role.CLEAR, Role.CLEAR_BUFFER, Role.READ_PIXELS, Role.READ_IMAGE,
        Role.READBACK, Role.TARGET, Role.CLIP_PLANE, Role.OTHER_PROGRAM,
    }
)  # fmt: skip
"""Told to whoever follows the app's draws."""
PICTURE_CALLS = frozenset(
    (Role.CLEAR, Role.CLEAR_BUFFER, Role.READ_PIXELS, Role.READ_IMAGE, Role.FLUSH)
)
"""Begin a picture, read one back, or have it finished: all that is heard of a frame that no window
shows."""


ROWS: tuple[tuple[Role, str], ...] = (
    (Role.BEGIN, r"glBegin"),
    (Role.END, r"glEnd"),
    (Role.ATTRIBUTE, r"glVertex[234][dfis]v?"),
    (Role.ATTRIBUTE, r"glNormal3[df]v?"),
    (Role.ATTRIBUTE, r"glColor[34](d|f|ub)v?"),
    (Role.ATTRIBUTE, r"glTexCoord[1234][dfis]v?"),
    (Role.ATTRIBUTE, r"glEdgeFlagv?"),
    (Role.IN_PRIMITIVE, r"glVertex[234](b|h|x)v?(OES|NV)|glVertexP[234]uiv?"),
    (Role.IN_PRIMITIVE, r"glColor[34](b|s|i|us|ui)v?|glColor[34](h|x)v?(OES|NV)|glColorP[34]uiv?"),
    (Role.IN_PRIMITIVE, r"glTexCoord[1234](b|h|x)v?(OES|NV)|glTexCoordP[1234]uiv?"),
    (Role.IN_PRIMITIVE, r"gl(Color|TexCoord)(?!\w*Normal)\w*Vertex\w*SUN"),
    (Role.IN_PRIMITIVE, r"glReplacementCode(?!\w*Normal)\w+SUN|glPrimitiveRestart(NV|IndexNV)?"),
    (Role.IN_PRIMITIVE, r"glMultiTexCoord(\d|P\d)\w+"),
    (Role.IN_PRIMITIVE, r"glSecondaryColor(3|P3)\w+|glFogCoord[dfhx]v?(EXT|NV|OES)?"),
    (Role.IN_PRIMITIVE, r"glIndex(d|f|i|s|ub|x)v?(OES)?|glVertexAttribs?(I|L|P|)\d\w*"),
    (Role.IN_PRIMITIVE, r"glVertexStream\d\w+ATI|glVertexWeight[fh]v?(EXT|NV)|glWeight\w+ARB"),
    (Role.MATERIAL, r"glMaterial(f|i|x)v?(OES)?"),
    (Role.IN_PRIMITIVE, r"glTangent3\w+EXT|glBinormal3\w+EXT"),
    (Role.NORMAL, r"glNormal3[bis]v?|glNormal3(h|x)v?(OES|NV)|glNormalP3uiv?"),
    (Role.NORMAL, r"gl\w*Normal3f\w*SUN"),
    (Role.ARRAY_ELEMENT, r"glArrayElement(EXT)?"),
    (Role.EVALUATION, r"glEvalCoord\d\w+|glEvalPoint[12]"),
    (Role.ARRAY_DRAW, r"glDrawArrays(EXT)?|glMultiDrawArrays(EXT)?"),
    (Role.ARRAY_DRAW, r"glDraw(Range)?Elements(BaseVertex|EXT)?"),
    (Role.ARRAY_DRAW, r"glMultiDrawElements(EXT|BaseVertex)?"),
    (Role.OPAQUE_DRAW, r"glDraw(Arrays|Elements)(Indirect|Instanced)\w*"),
    (Role.OPAQUE_DRAW, r"glMulti(Mode)?Draw\w+(Indirect|IBM|APPLE)\w*"),
    (Role.OPAQUE_DRAW, r"glDrawTransformFeedback\w*|glDraw(Range)?ElementArray\w+"),
    (Role.OPAQUE_DRAW, r"glDrawMesh\w+|glDrawTextureNV|glDrawCommands\w+|glDrawVkImageNV"),
    (Role.OPAQUE_DRAW, r"gl(Stencil|Cover|StencilThenCover)\w+Path\w*NV|glRectxv?OES"),
    (Role.RECT, r"glRect[dfis]v?"),
    (Role.EVALUATOR_MESH, r"glEvalMesh[12]"),
    (Role.BITMAP, r"glBitmap(xOES)?"),
    (Role.PIXELS, r"glDrawPixels"),
    (Role.OPAQUE_DRAW, r"glCopyPixels"),
    (Role.LIST_OPEN, r"glNewList"),
    (Role.LIST_CLOSE, r"glEndList"),
    (Role.LIST_CALL, r"glCallList"),
    (Role.LISTS_CALL, r"glCallLists"),
    (Role.LIST_FORGET, r"glDeleteLists"),
    (Role.MATRIX, r"gl(Load|Mult)(Transpose)?Matrix[dfx](ARB|OES)?|glLoadIdentity"),
    (Role.MATRIX, r"gl(Rotate|Scale|Translate)[dfx](OES)?|gl(Ortho|Frustum)[fx]?(OES)?"),
    (Role.MATRIX_MODE, r"glMatrixMode"),
    (Role.MATRIX_PUSH, r"glPushMatrix"),
    (Role.MATRIX_POP, r"glPopMatrix"),
    (Role.ENABLE, r"glEnable"),
    (Role.DISABLE, r"glDisable"),
    (Role.WINDING, r"glFrontFace"),
    (Role.COLOUR_MATERIAL, r"glColorMaterial"),
    (Role.DEPTH_MASK, r"glDepthMask"),
    (Role.POLYGON_MODE, r"glPolygonMode"),
    (Role.ATTRIB_PUSH, r"glPushAttrib"),
    (Role.ATTRIB_POP, r"glPopAttrib"),
    (Role.CLEAR, r"glClear"),
    (Role.CLEAR_BUFFER, r"glClearBuffer(fi|fv|iv|uiv)|glClearNamedFramebuffer\w+"),
    (Role.READ_PIXELS, r"glReadn?Pixels(ARB|KHR)?"),
    (Role.READ_IMAGE, r"glGetn?TexImage(ARB)?|glGetTexture(Sub)?Image(EXT)?|glGetMultiTexImageEXT"),
    (Role.READBACK, r"glCopy(Multi)?Tex(ture)?(Sub)?Image[123]D(EXT)?"),
    (Role.READBACK, r"glAccum(xOES)?|glBlit(Named)?Framebuffer\w*|glCopyImageSubData(NV)?"),
    (Role.READBACK, r"glCopy(Color(Sub)?Table|ConvolutionFilter\dD)\w*"),
    (Role.TARGET, r"glBindFramebuffer(EXT)?|glDrawBuffers?(ARB|ATI)?"),
    (Role.TARGET, r"glFramebufferDrawBuffers?EXT"),
    (Role.FLUSH, r"glFlush|glFinish"),
    (Role.BUFFER_WRITE, r"glBuffer(Sub)?(Data|Storage)(ARB|EXT)?"),
    (Role.BUFFER_WRITE, r"gl(Unm|M)apBuffer(Range)?(ARB|EXT)?"),
    (Role.BUFFER_WRITE, r"glClearBuffer(Sub)?Data(EXT)?|glFlushMappedBufferRange(APPLE|EXT)?"),
    (Role.NAMED_BUFFER_WRITE, r"glNamedBuffer(Sub)?(Data|Storage)(ARB|EXT)?"),
    (Role.NAMED_BUFFER_WRITE, r"gl(Unm|M)apNamedBuffer(Range)?(ARB|EXT)?"),
    (Role.NAMED_BUFFER_WRITE, r"glClearNamedBuffer(Sub)?Data(EXT)?"),
    (Role.NAMED_BUFFER_WRITE, r"glFlushMappedNamedBufferRange(EXT)?"),
    (Role.BUFFERS_WRITE, r"glDeleteBuffers(ARB)?"),
    (Role.BUFFERS_WRITE, r"glCopy(Named)?BufferSubData"),  # the first argument is read from
    (Role.BUFFERS_WRITE, r"glInvalidateBuffer(Sub)?Data|gl(Begin|End)TransformFeedback(NV|EXT)?"),
    (Role.CLIP_PLANE, r"glClipPlane[fx]?(OES|IMG)?"),
    (Role.RENDER_MODE, r"glRenderMode"),
    (Role.QUERY_OPEN, r"glBeginQuery(Indexed|ARB|EXT)?|glBeginOcclusionQueryNV"),
    (Role.CONDITION_OPEN, r"glBeginConditionalRender(NV)?"),
    (Role.CONDITION_CLOSE, r"glEndConditionalRender(NV)?"),
    (Role.OTHER_PROGRAM, r"glBindProgram(ARB|NV|Pipeline(EXT)?)|glBindVertexShaderEXT"),
    (Role.OTHER_PROGRAM, r"glProgramStringARB|glLoadProgramNV"),
)  # fmt: skip

KNOWN_PASS = re.compile(
    r"glDrawBuffer\w+|glReadBuffer\w*|glRead(Instruments)\w*|glCopyPathNV|glClear(Color|Depth|Stencil"
    r"|Index|Accum|TexSubImage|TexImage|TexSubImage)\w*|gl(Begin|End)(ConditionalRenderNVX|Query|OcclusionQuery|Perf|Fragment"
    r"|VertexShader|Video)\w*|glFinish\w+|glFlush\w+|glMapGrid\w*|glMap[12]\w+|glMap(Control|Param"
    r"|Vertex|Object|Texture)\w+|glUnmap(Object|Texture)\w+|glVertex(Binding|Blend|Format|Pointer"
    r"|Weight|Attrib|Array)\w*|glMulti(Tex|cast)\w+|glBuffer(Address|Attach|Page|Parameter|Storage)\w+"
    r"|glEval(Maps|uate)\w+|glArrayObject\w+"
)
"""Names that look as if they drew, cleared or read back, and were weighed: PASS is right."""


@cache
def role_of(name: str) -> Role:
    """The role of a GL entry point by its C name."""
    for role, pattern in ROWS:
        if re.fullmatch(pattern, name):
            return role
    return Role.PASS
