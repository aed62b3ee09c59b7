"""State of the fixed function: switches, lights, fog, stencil, stacks, matrices, clears."""

from __future__ import annotations

from tests.fuzz.writing import Writer, area

SWITCHES = (
    "LIGHTING", "LIGHT0", "LIGHT1", "COLOR_MATERIAL", "CULL_FACE", "DEPTH_TEST", "DEPTH_TEST",
    "BLEND", "FOG", "NORMALIZE", "RESCALE_NORMAL", "POLYGON_OFFSET_FILL", "POLYGON_OFFSET_LINE",
    "CLIP_PLANE0", "CLIP_PLANE1", "TEXTURE_GEN_S", "TEXTURE_GEN_T", "POLYGON_STIPPLE",
    "LINE_STIPPLE", "SCISSOR_TEST", "STENCIL_TEST", "ALPHA_TEST", "TEXTURE_1D", "TEXTURE_2D",
    "TEXTURE_3D", "TEXTURE_CUBE_MAP", "LINE_SMOOTH", "POINT_SMOOTH", "POLYGON_SMOOTH", "DITHER",
    "COLOR_LOGIC_OP", "AUTO_NORMAL", "MAP2_VERTEX_3", "COLOR_SUM", "MULTISAMPLE",
    "SAMPLE_ALPHA_TO_COVERAGE", "RASTERIZER_DISCARD", "PRIMITIVE_RESTART", "DEPTH_CLAMP",
    "VERTEX_PROGRAM_TWO_SIDE", "PROGRAM_POINT_SIZE", "FRAMEBUFFER_SRGB", "POINT_SPRITE",
    "TEXTURE_CUBE_MAP_SEAMLESS", "PRIMITIVE_RESTART_FIXED_INDEX", "INDEX_LOGIC_OP",
    "DEBUG_OUTPUT_SYNCHRONOUS", "SAMPLE_SHADING", "VERTEX_ARRAY",
)  # fmt: skip
_SWITCH = "{" + "|".join(SWITCHES) + "}"
SETTINGS = (
    "glShadeModel({FLAT|SMOOTH})", "glFrontFace({CW|CCW})", "glCullFace({@TriangleFace})",
    "glPolygonMode({@TriangleFace}, {FILL|LINE|POINT|FILL})", "glDepthMask({flag})",
    "glDepthFunc({@DepthFunction})", "glDepthFunc({LESS|LEQUAL})", "glDepthRange({2u})",
    "glBlendFunc({@BlendingFactor}, {@BlendingFactor})", "glBlendEquation({@BlendEquationModeEXT})",
    "glBlendFuncSeparate({@BlendingFactor}, {@BlendingFactor}, {ONE|ZERO}, {ONE|ZERO})",
    "glBlendColor({4u})", "glAlphaFunc({@AlphaFunction}, {u})", "glStencilMask({0..255})",
    "glStencilFunc({@StencilFunction}, {0..4}, {0..255})",
    "glStencilOp({@StencilOp}, {@StencilOp}, {@StencilOp})",
    "glStencilFuncSeparate({@TriangleFace}, {@StencilFunction}, 1, 255)",
    "glStencilMaskSeparate({@TriangleFace}, {0..255})",
    "glColorMask({flag}, {flag}, {flag}, {flag})", "glColorMaski({0..2}, {flag}, {flag}, 1, 1)",
    "glLogicOp({@LogicOp})", "glScissor({-2..30}, {0..20}, {0..50}, {-1..40})",
    "glViewport({-5..10}, {0..10}, {20..80}, {10..60})", "glLineWidth({r 0.5 1.0 3.0 -1.0 0.0})",
    "glPointSize({r 0.5 1.0 4.0 0.0})", "glLineStipple({0..4}, {0..65535})",
    "glPolygonOffset({2r})", "glPolygonStipple(octets()[:128])",
    "glFogf({FOG_DENSITY|FOG_START|FOG_END}, {r 0.5 4.0 6.0})",
    "glFogi(GL.GL_FOG_MODE, {LINEAR|EXP|EXP2|FLAT})", "glFogfv(GL.GL_FOG_COLOR, {v4fu})",
    "glFogi(GL.GL_FOG_COORD_SRC, {FOG_COORD|FRAGMENT_DEPTH})",
    "glLightfv({LIGHT0|LIGHT1}, {AMBIENT|DIFFUSE|SPECULAR|POSITION}, {v4f})",
    "glLightf(GL.GL_LIGHT0, {SPOT_CUTOFF|SPOT_EXPONENT|LINEAR_ATTENUATION}, {r 0.0 1.0 30.0})",
    "glLightfv(GL.GL_LIGHT0, GL.GL_SPOT_DIRECTION, {v3f})",
    "glLightModeli({LIGHT_MODEL_TWO_SIDE|LIGHT_MODEL_LOCAL_VIEWER}, {0..1})",
    "glLightModeli(GL.GL_LIGHT_MODEL_COLOR_CONTROL, {SINGLE_COLOR|SEPARATE_SPECULAR_COLOR})",
    "glLightModelfv(GL.GL_LIGHT_MODEL_AMBIENT, {v4fu})",
    "glMaterialfv({@TriangleFace}, {AMBIENT|DIFFUSE|SPECULAR|EMISSION}, {v4fu})",
    "glMaterialf({@TriangleFace}, GL.GL_SHININESS, {r 0.0 30.0 128.0})",
    "glColorMaterial({@TriangleFace}, {@ColorMaterialParameter})",
    "glClipPlane({CLIP_PLANE0|CLIP_PLANE1}, {v4d})", "glHint({@HintTarget}, {@HintMode})",
    "glClearColor({4u})", "glClearDepth({r 0.0 0.5 1.0})", "glClearStencil({0..3})",
    "glProvokingVertex({@VertexProvokingMode})", "glSampleCoverage({u}, {0..1})",
    "glClampColor({CLAMP_READ_COLOR|CLAMP_VERTEX_COLOR}, {@ClampColorModeARB})",
    "glPrimitiveRestartIndex({0..12})",
    "glPointParameterf({POINT_SIZE_MIN|POINT_SIZE_MAX}, {r 0.0 2.0})",
    "glDrawBuffer({@DrawBufferMode})", "glDrawBuffer({BACK|FRONT|FRONT_AND_BACK|NONE})",
    "glReadBuffer({BACK|FRONT|NONE|AUX0})",
    "glClipControl({LOWER_LEFT|UPPER_LEFT}, {NEGATIVE_ONE_TO_ONE|ZERO_TO_ONE})",
    "glTexGeni({S|T}, GL.GL_TEXTURE_GEN_MODE, {OBJECT_LINEAR|EYE_LINEAR|SPHERE_MAP})",
    "glTexGenfv({S|T|R}, {OBJECT_PLANE|EYE_PLANE}, {v4f})",
    "glTexEnvi(GL.GL_TEXTURE_ENV, GL.GL_TEXTURE_ENV_MODE, {MODULATE|DECAL|REPLACE|BLEND|ADD})",
    "glTexEnvfv(GL.GL_TEXTURE_ENV, GL.GL_TEXTURE_ENV_COLOR, {v4fu})",
    "glActiveTexture(GL.GL_TEXTURE0 + {0..3})", "glActiveTexture({TEXTURE0|TEXTURE9|TEXTURE20})",
    "glEnablei(GL.GL_BLEND, {0..2})", "glDisablei(GL.GL_SCISSOR_TEST, {0..2})",
    "glViewportIndexedf({0..2}, 1.5, 2.5, 30.0, 20.0)", "glScissorIndexed({0..2}, 1, 2, 30, 20)",
    "glDepthRangeIndexed({0..2}, {2u})", "glMinSampleShading({u})", "glListBase({0..3})",
    "glPatchParameteri(GL.GL_PATCH_VERTICES, {1..4})", "glClearIndex({r})", "glIndexMask({0..255})",
    "glClearAccum({4u})", "glShadeModel({SMOOTH|FLAT})",
)  # fmt: skip
"""Calls that set state."""
TRANSFORMATIONS = (
    "GL.glTranslatef({3r -0.5 0.0 0.25})", "GL.glTranslated({3r -0.5 0.0 0.25})",
    "GL.glRotatef({r 30.0 90.0 200.0}, {3r})", "GL.glRotated({r 30.0 -60.0}, {3r})",
    "GL.glScalef({3r 0.5 1.0 -1.0 1.5})", "GL.glScaled({3r 0.5 1.0})", "GL.glLoadIdentity()",
    "GL.glMultMatrixf({matrix})", "GL.glMultMatrixd({matrix})", "GL.glLoadMatrixf({matrix})",
    "GL.glLoadMatrixd({matrix})", "GL.glMultTransposeMatrixf({matrix})",
    "GL.glLoadTransposeMatrixd({matrix})", "GL.glOrtho(-1, 1, -1, 1, {r -1 0}, {r 1 9 0})",
    "GL.glFrustum(-1, 1, -0.75, 0.75, {r 1 2 0}, 20)", "GLU.gluLookAt({3r}, 0, 0, -1, 0, 1, 0)",
    "GLU.gluPerspective({r 30 60}, 1.3, {r 0.5 1 0}, 20)", "GLU.gluOrtho2D({4r})",
    "GLU.gluPickMatrix(10, 10, {r 5 0}, 5, [0, 0, 64, 48])",
)  # fmt: skip
_STACKS = (
    "GL.glPushAttrib({@AttribMask})", "GL.glPushAttrib(GL.GL_ALL_ATTRIB_BITS)",
    "GL.glPopAttrib()", "GL.glPushClientAttrib({@ClientAttribMask})", "GL.glPopAttrib()",
    "GL.glPopClientAttrib()", "GL.glPushMatrix()", "GL.glPopMatrix()",
    "[GL.glPushAttrib(GL.GL_CURRENT_BIT) for _ in range(3)]",
    "[GL.glPushAttrib(GL.GL_ENABLE_BIT) for _ in range(16)]",
    "[GL.glPushAttrib(GL.GL_ENABLE_BIT) for _ in range(15)]",
    "[GL.glPushMatrix() for _ in range(31)]", "[GL.glPushMatrix() for _ in range(32)]",
    "[GL.glPushClientAttrib(1) for _ in range(16)]", "GL.glPushClientAttrib(3)",
)  # fmt: skip
CLEARS = (
    "GL.glClear(0x4100)", "GL.glClear(0x4100)", "GL.glClear(0x100)", "GL.glClear(0x4000)",
    "GL.glClear(0x4500)", "GL.glClear(0x400)", "GL.glClear(0)", "GL.glClear(0xFFFF)",
    "GL.glClear(-1)", "GL.glClear({@ClearBufferMask})",
    "GL.glClearBufferfv(GL.GL_COLOR, {0..1}, {v4fu})",
    "GL.glClearBufferfv(GL.GL_DEPTH, 0, {v1fu})",
    
    "GL.glClearBufferiv(GL.GL_STENCIL, 0, {v1i})",
    "GL.glClearBufferfi(GL.GL_DEPTH_STENCIL, 0, {u}, 1)",
)  # fmt: skip
QUESTIONS = (
    "GL.glGetError()", "GL.glGetError()", "GL.glGetFloatv({@GetPName})",
    "GL.glGetDoublev({@GetPName})", "GL.glGetIntegerv({@GetPName})",
    "GL.glGetBooleanv({@GetPName})", "GL.glGetInteger64v({@GetPName})",
    "GL.glGetFloatv({MODELVIEW_MATRIX|VIEWPORT|CURRENT_COLOR|COLOR_CLEAR_VALUE})",
    "GL.glGetIntegerv({MATRIX_MODE|DEPTH_TEST|LIST_INDEX|ATTRIB_STACK_DEPTH|DRAW_BUFFER})",
    "GL.glGetIntegerv({POLYGON_MODE|RENDER_MODE|CURRENT_PROGRAM|TEXTURE_BINDING_2D})",
    "GL.glGetLightfv(GL.GL_LIGHT0, {@LightParameter})",
    "GL.glGetMaterialfv({FRONT|BACK}, {@MaterialParameter})", "GL.glGetString({@StringName})",
    f"GL.glIsEnabled({_SWITCH})", "GL.glGetClipPlane(GL.GL_CLIP_PLANE0)", "look()",
    "GL.glIsEnabled({@EnableCap})", "GL.glGetStringi(GL.GL_EXTENSIONS, {0..5})",
)  # fmt: skip


@area(8)
def switch(w: Writer) -> None:
    """glEnable and glDisable."""
    for _ in range(w.whole(1, 4)):
        w.say(w.row((f"GL.glEnable({_SWITCH})", f"GL.glEnable({_SWITCH})",
                     f"GL.glDisable({_SWITCH})", "GL.glEnable({@EnableCap})")))  # fmt: skip


def setting(w: Writer) -> str:
    """One call that sets state; all of them may be compiled."""
    return "GL." + w.row(SETTINGS)


@area(8)
def settings(w: Writer) -> None:
    """Some of them."""
    for _ in range(w.whole(1, 4)):
        w.say(setting(w))


@area(5)
def matrices(w: Writer) -> None:
    """Transformations, modes and stacks."""
    if w.maybe(0.3):
        w.say(w.fill("GL.glMatrixMode({MODELVIEW|MODELVIEW|PROJECTION|TEXTURE|COLOR})"))
    if w.maybe(0.4):
        w.call("glPushMatrix")
    for _ in range(w.whole(1, 3)):
        w.say(w.row(TRANSFORMATIONS))
    if w.maybe(0.3):
        w.call("glPopMatrix")
    if w.maybe(0.5):
        w.call("glMatrixMode", "GL.GL_MODELVIEW")


@area(4)
def stacks(w: Writer) -> None:
    """Attribute stacks, sometimes full or empty."""
    w.say(w.row(_STACKS))


@area(3)
def clear(w: Writer) -> None:
    """glClear and its kin."""
    w.say(w.row(CLEARS))


@area(4)
def questions(w: Writer) -> None:
    """What a program asks."""
    w.say(w.row(QUESTIONS))
