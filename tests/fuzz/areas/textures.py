"""Textures, samplers and what is read back from them."""

from __future__ import annotations

from tests.fuzz.writing import Writer, area

_IMAGES = (
    "glTexImage2D(GL.GL_TEXTURE_2D, {0..1}, {RGBA8|RGB|RGBA|LUMINANCE|ALPHA8|RGBA32F|R8|SRGB8_ALPHA8}, {1..8}, 8, 0,"  # noqa: E501
    " {RGB|RGBA|RED|LUMINANCE}, {UNSIGNED_BYTE|UNSIGNED_SHORT|BYTE}, octets({0..3}))",
    "glTexImage2D(GL.GL_TEXTURE_2D, 0, 4, 4, 4, 0, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, octets(2).tobytes())",  # noqa: E501
    "glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGB, 4, 4, 0, GL.GL_RGB, GL.GL_FLOAT, floats(2)[:80].tolist())",  # noqa: E501
    "glTexImage1D(GL.GL_TEXTURE_1D, 0, GL.GL_RGBA, 8, 0, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, octets(1))",  # noqa: E501
    "glTexImage3D(GL.GL_TEXTURE_3D, 0, GL.GL_RGBA, 4, 4, 2, 0, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, octets(1))",  # noqa: E501
    "glTexImage2D(GL.GL_TEXTURE_CUBE_MAP_POSITIVE_X + {0..5}, 0, GL.GL_RGB, 4, 4, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, octets(3))",  # noqa: E501
    "glTexSubImage2D(GL.GL_TEXTURE_2D, 0, {0..2}, {0..2}, {0..4}, 2, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, octets(4))",  # noqa: E501
    "glTexStorage2D(GL.GL_TEXTURE_2D, {1..2}, GL.GL_RGBA8, 8, 8)",
    "glTextureStorage2D({texture}, 1, GL.GL_RGBA8, 4, 4)",
    "glTextureSubImage2D({texture}, 0, 0, 0, 2, 2, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, octets(2))",
    "glCopyTexImage2D(GL.GL_TEXTURE_2D, 0, {RGB|RGBA}, {0..9}, 0, 16, 16, 0)",
    "glCopyTexSubImage2D(GL.GL_TEXTURE_2D, 0, 0, 0, {0..9}, 4, 4, 4)",
    "glGenerateMipmap(GL.GL_TEXTURE_2D)",
    "glClearTexImage({texture}, 0, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, octets(1))",
    "glTexImage2D({@TextureTarget}, 0, {@InternalFormat}, 4, 4, 0, {@PixelFormat}, {@PixelType}, octets(7))",  # noqa: E501
)
_SETTINGS = (
    "glTexParameteri({TEXTURE_2D|TEXTURE_1D|TEXTURE_CUBE_MAP}, {TEXTURE_MIN_FILTER|TEXTURE_MAG_FILTER}, {NEAREST|LINEAR|NEAREST_MIPMAP_NEAREST})",  # noqa: E501
    "glTexParameteri(GL.GL_TEXTURE_2D, {TEXTURE_WRAP_S|TEXTURE_WRAP_T}, {REPEAT|CLAMP|CLAMP_TO_EDGE|MIRRORED_REPEAT})",  # noqa: E501
    "glTexParameterf(GL.GL_TEXTURE_2D, {TEXTURE_PRIORITY|TEXTURE_LOD_BIAS|TEXTURE_MAX_LOD}, {u})",
    "glTexParameterfv(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_BORDER_COLOR, {v4fu})",
    "glTexParameteri(GL.GL_TEXTURE_2D, {@TextureParameterName}, {0..2})",
    "glTexParameteri({@TextureTarget}, GL.GL_GENERATE_MIPMAP, 1)",
    "glTexEnvi(GL.GL_TEXTURE_ENV, {COMBINE_RGB|SRC0_RGB|OPERAND0_RGB}, {MODULATE|ADD|TEXTURE|PRIMARY_COLOR|SRC_COLOR})",  # noqa: E501
    "glTexEnvi(GL.GL_POINT_SPRITE, GL.GL_COORD_REPLACE, {flag})",
    "glTextureParameteri({texture}, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST)",
    "glPrioritizeTextures(1, [{texture}], [0.5])",
    "glActiveTexture(GL.GL_TEXTURE0 + {0..2})",
    "glActiveTexture(GL.GL_TEXTURE0)",
    "glBindTextureUnit({0..2}, {texture})",
    "glBindTextures(0, 1, [{texture}])",
    "glBindSampler({0..2}, {sampler})",
    "glSamplerParameteri({sampler}, {TEXTURE_WRAP_S|TEXTURE_MIN_FILTER}, {REPEAT|NEAREST|CLAMP_TO_EDGE})",  # noqa: E501
)
_QUESTIONS = (
    "glGetTexImage(GL.GL_TEXTURE_2D, {0..1}, GL.GL_RGBA, {UNSIGNED_BYTE|FLOAT})",
    "glIsTexture({texture})",
    "glGetTexLevelParameteriv(GL.GL_TEXTURE_2D, 0, {TEXTURE_WIDTH|TEXTURE_INTERNAL_FORMAT|TEXTURE_RED_SIZE})",  # noqa: E501
    "glGetTexParameteriv(GL.GL_TEXTURE_2D, {TEXTURE_MIN_FILTER|TEXTURE_WRAP_S})",
    "glIsTexture({1..9})",
    "glAreTexturesResident([{texture}])",
    "glGetTexParameterfv({@TextureTarget}, {@GetTextureParameter})",
    "glGetTexEnviv(GL.GL_TEXTURE_ENV, GL.GL_TEXTURE_ENV_MODE)",
    "glGetIntegerv(GL.GL_TEXTURE_BINDING_2D)",
    "glGenTextures({1..3})",
    "glGenTextures(2)",
    "glCreateTextures({@TextureTarget}, {0..2})",
    "glIsSampler({sampler})",
    "glDeleteTextures([{texture}])",
    "glDeleteTextures(1, [{texture}])",
    "glDeleteTextures([{1..9}, 0])",
    "glDeleteSamplers(1, [{sampler}])",
)


@area(5)
def textured(w: Writer) -> None:
    """A texture, and what is done with it."""
    if w.maybe(0.6):
        w.make(
            "texture",
            w.pick(
                (
                    "GL.glGenTextures(1)",
                    "GL.glGenTextures(1)",
                    "int(GL.glGenTextures(1))",
                    "GL.glCreateTextures(GL.GL_TEXTURE_2D, 1)",
                )
            ),
        )
    elif w.maybe(0.3):
        w.names.setdefault("texture", []).append(str(w.pick((1, 2, 7, 12, 1000))))
    if w.maybe(0.15):
        w.make("sampler", "GL.glGenSamplers(1)")
    w.say(
        w.fill(
            "GL.glBindTexture({TEXTURE_2D|TEXTURE_2D|TEXTURE_2D|TEXTURE_1D|TEXTURE_3D|TEXTURE_CUBE_MAP}, {texture})"  # noqa: E501
        )
    )
    if w.maybe(0.5):
        w.say(
            "GL.glEnable(GL.GL_TEXTURE_2D)",
            "GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST)",
        )
    for _ in range(w.whole(1, 4)):
        w.say("GL." + w.row(_IMAGES, _SETTINGS, _QUESTIONS))
