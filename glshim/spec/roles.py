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
    ARRAY_DRAW = "draws from client arrays or buffers (signatures: spec/draws.py)"
    OPAQUE_DRAW = "draws something we do not restyle"
    RECT = "draws one axis-parallel rectangle"
    EVALUATOR_MESH = "draws an evaluated grid"
    PIXELS = "writes pixels without polygons"
    LIST_OPEN = "opens a display list"
    LIST_CLOSE = "closes a display list"
    LIST_CALL = "runs display lists"
    LIST_FORGET = "deletes display lists"
    MATRIX = "changes a matrix; followed while a display list is open"
    SWITCH = "switches what lines depend on; followed while a display list is open"
    CLEAR = "clears buffers: the depth of a layer ends"
    READBACK = "reads the picture back: the layer must be in it"
    TARGET = "turns drawing to another framebuffer: the layer ends"
    FLUSH = "glFlush, glFinish: the end of a frame in a single-buffered window"
    BUFFER_WRITE = "changes what a buffer object holds"
    CLIP_PLANE = "sets a user clip plane"


ROWS: tuple[tuple[Role, str], ...] = (
    (Role.BEGIN, r"glBegin"),
    (Role.END, r"glEnd"),
    (Role.ATTRIBUTE, r"glVertex[234][dfis]v?"),
    (Role.ATTRIBUTE, r"glNormal3[df]v?"),
    (Role.ATTRIBUTE, r"glColor[34](d|f|ub)v?"),
    (Role.ATTRIBUTE, r"glTexCoord[1234][dfis]v?"),
    (Role.ATTRIBUTE, r"glEdgeFlagv?"),
    (Role.IN_PRIMITIVE, r"glVertex[234](b|h|x)v?(OES|NV)|glVertexP[234]uiv?"),
    (Role.IN_PRIMITIVE, r"glNormal3[bis]v?|glNormal3(h|x)v?(OES|NV)|glNormalP3uiv?"),
    (Role.IN_PRIMITIVE, r"glColor[34](b|s|i|us|ui)v?|glColor[34](h|x)v?(OES|NV)|glColorP[34]uiv?"),
    (Role.IN_PRIMITIVE, r"glTexCoord[1234](b|h|x)v?(OES|NV)|glTexCoordP[1234]uiv?"),
    (Role.IN_PRIMITIVE, r"gl(Color|Normal|TexCoord)\w*Vertex\w*SUN"),
    (Role.IN_PRIMITIVE, r"glReplacementCode\w+SUN|glPrimitiveRestart(NV|IndexNV)?"),
    (Role.IN_PRIMITIVE, r"glMultiTexCoord(\d|P\d)\w+"),
    (Role.IN_PRIMITIVE, r"glSecondaryColor(3|P3)\w+|glFogCoord[dfhx]v?(EXT|NV|OES)?"),
    (Role.IN_PRIMITIVE, r"glIndex(d|f|i|s|ub|x)v?(OES)?|glVertexAttribs?(I|L|P|)\d\w*"),
    (Role.IN_PRIMITIVE, r"glVertexStream\d\w+ATI|glVertexWeight[fh]v?(EXT|NV)|glWeight\w+ARB"),
    (Role.IN_PRIMITIVE, r"glMaterial(f|i|x)v?(OES)?|glArrayElement(EXT)?"),
    (Role.IN_PRIMITIVE, r"glEvalCoord\d\w+|glEvalPoint[12]"),
    (Role.IN_PRIMITIVE, r"glTangent3\w+EXT|glBinormal3\w+EXT"),
    (Role.ARRAY_DRAW, r"glDrawArrays(EXT)?|glMultiDrawArrays(EXT)?"),
    (Role.ARRAY_DRAW, r"glDraw(Range)?Elements(BaseVertex|EXT)?"),
    (Role.ARRAY_DRAW, r"glMultiDrawElements(EXT|BaseVertex)?"),
    (Role.OPAQUE_DRAW, r"glDraw(Arrays|Elements)(Indirect|Instanced)\w*"),
    (Role.OPAQUE_DRAW, r"glMulti(Mode)?Draw\w+(Indirect|IBM|APPLE)\w*"),
    (Role.OPAQUE_DRAW, r"glDrawTransformFeedback\w*|glDraw(Range)?ElementArray\w+"),
    (Role.OPAQUE_DRAW, r"glDrawMesh\w+|glDrawTextureNV|glDrawCommands\w+|glDrawVkImageNV"),
    (Role.OPAQUE_DRAW, r"gl(Stencil|Cover|StencilThenCover)\w+Path\w*NV"),
    (Role.RECT, r"glRect[dfis]v?|glRectxv?OES"),
    (Role.EVALUATOR_MESH, r"glEvalMesh[12]"),
    (Role.PIXELS, r"glBitmap(xOES)?|glDrawPixels|glCopyPixels"),
    (Role.LIST_OPEN, r"glNewList"),
    (Role.LIST_CLOSE, r"glEndList"),
    (Role.LIST_CALL, r"glCallLists?"),
    (Role.LIST_FORGET, r"glDeleteLists"),
    (Role.MATRIX, r"gl(Load|Mult)(Transpose)?Matrix[dfx](ARB|OES)?|glLoadIdentity|glMatrixMode"),
    (Role.MATRIX, r"glPushMatrix|glPopMatrix|gl(Rotate|Scale|Translate)[dfx](OES)?"),
    (Role.MATRIX, r"gl(Ortho|Frustum)[fx]?(OES)?"),
    (Role.SWITCH, r"gl(En|Dis)able|glFrontFace|glDepthMask|glPolygonMode|gl(Push|Pop)Attrib"),
    (Role.CLEAR, r"glClear|glClearBuffer(fi|fv|iv|uiv)|glClearNamedFramebuffer\w+"),
    (Role.READBACK, r"glReadn?Pixels(ARB|KHR)?|glCopy(Multi)?Tex(ture)?(Sub)?Image[123]D(EXT)?"),
    (Role.READBACK, r"glAccum(xOES)?|glBlit(Named)?Framebuffer\w*|glCopyImageSubData(NV)?"),
    (Role.READBACK, r"glCopy(Color(Sub)?Table|ConvolutionFilter\dD)\w*"),
    (Role.TARGET, r"glBindFramebuffer(EXT)?|glDrawBuffers?(ARB|ATI)?"),
    (Role.TARGET, r"glFramebufferDrawBuffers?EXT"),
    (Role.FLUSH, r"glFlush|glFinish"),
    (Role.BUFFER_WRITE, r"gl(Named)?Buffer(Sub)?(Data|Storage)(ARB|EXT)?"),
    (Role.BUFFER_WRITE, r"glCopy(Named)?BufferSubData"),
    (Role.BUFFER_WRITE, r"gl(Unm|M)ap(Named)?Buffer(Range)?(ARB|EXT)?"),
    (Role.BUFFER_WRITE, r"glClear(Named)?Buffer(Sub)?Data(EXT)?"),
    (Role.BUFFER_WRITE, r"glFlushMapped(Named)?BufferRange(APPLE|EXT)?|glDeleteBuffers(ARB)?"),
    (Role.BUFFER_WRITE, r"glInvalidateBuffer(Sub)?Data|gl(Begin|End)TransformFeedback(NV|EXT)?"),
    (Role.CLIP_PLANE, r"glClipPlane[fx]?(OES|IMG)?"),
)  # fmt: skip

KNOWN_PASS = re.compile(
    r"glDrawBuffer\w+|glReadBuffer\w*|glRead(Instruments)\w*|glCopyPathNV|glClear(Color|Depth|Stencil"
    r"|Index|Accum|TexSubImage|TexImage|TexSubImage)\w*|gl(Begin|End)(ConditionalRender|Query|OcclusionQuery|Perf|Fragment"
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
