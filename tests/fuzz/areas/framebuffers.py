"""Framebuffer objects, complete and not, and what is copied between them."""

from __future__ import annotations

from tests.fuzz.areas.arrays import draw
from tests.fuzz.areas.immediate import primitive
from tests.fuzz.areas.state import CLEARS
from tests.fuzz.writing import Writer, area

_CALLS = (
    "glBindFramebuffer({FRAMEBUFFER|DRAW_FRAMEBUFFER|READ_FRAMEBUFFER}, {framebuffer})",
    "glBindFramebuffer(GL.GL_FRAMEBUFFER, 0)",
    "glCheckFramebufferStatus({FRAMEBUFFER|READ_FRAMEBUFFER})",
    "glIsFramebuffer({framebuffer})",
    "glIsFramebuffer({1..5})",
    "glFramebufferTexture2D(GL.GL_FRAMEBUFFER, {COLOR_ATTACHMENT0|COLOR_ATTACHMENT1|DEPTH_ATTACHMENT}, GL.GL_TEXTURE_2D, {texture}, 0)",  # noqa: E501
    "glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, {COLOR_ATTACHMENT0|DEPTH_ATTACHMENT|DEPTH_STENCIL_ATTACHMENT}, GL.GL_RENDERBUFFER, {renderbuffer})",  # noqa: E501
    "glRenderbufferStorage(GL.GL_RENDERBUFFER, {DEPTH_COMPONENT24|RGBA8|DEPTH24_STENCIL8}, {1..64}, 48)",  # noqa: E501
    "glBindRenderbuffer(GL.GL_RENDERBUFFER, {renderbuffer})",
    "glDrawBuffers([{COLOR_ATTACHMENT0|COLOR_ATTACHMENT1|NONE|BACK}])",
    "glDrawBuffer({COLOR_ATTACHMENT0|NONE|BACK})",
    "glReadBuffer({COLOR_ATTACHMENT0|BACK|NONE})",
    "glBlitFramebuffer(0, 0, {8..40}, 20, 0, 0, 30, {8..40}, {COLOR_BUFFER_BIT|DEPTH_BUFFER_BIT|STENCIL_BUFFER_BIT}, {NEAREST|LINEAR})",  # noqa: E501
    "glGetFramebufferAttachmentParameteriv(GL.GL_FRAMEBUFFER, {COLOR_ATTACHMENT0|BACK_LEFT|DEPTH}, GL.GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE)",  # noqa: E501
    "glDeleteFramebuffers(1, [{framebuffer}])",
    "glDeleteRenderbuffers(1, [{renderbuffer}])",
    "glDeleteTextures([{texture}])",
    "glInvalidateFramebuffer(GL.GL_FRAMEBUFFER, 1, [GL.GL_DEPTH_ATTACHMENT])",
    "glGetRenderbufferParameteriv(GL.GL_RENDERBUFFER, GL.GL_RENDERBUFFER_WIDTH)",
    "glClearNamedFramebufferfv({framebuffer}, GL.GL_COLOR, 0, {v4fu})",
    "glReadPixels(0, 0, {1..30}, {1..4}, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE)",
    "glCheckNamedFramebufferStatus({framebuffer}, GL.GL_FRAMEBUFFER)",
    "glIsRenderbuffer({renderbuffer})",
    "glGenFramebuffers({1..2})",
    "glNamedFramebufferTexture({framebuffer}, GL.GL_COLOR_ATTACHMENT0, {texture}, 0)",
    "glFramebufferParameteri(GL.GL_FRAMEBUFFER, GL.GL_FRAMEBUFFER_DEFAULT_WIDTH, 16)",
    "glBlitNamedFramebuffer(0, {framebuffer}, 0, 0, 9, 9, 0, 0, 9, 9, 0x4000, GL.GL_NEAREST)",
    "glNamedFramebufferDrawBuffer({framebuffer}, {NONE|COLOR_ATTACHMENT0})",
)


@area(4)
def framebuffer(w: Writer) -> None:
    """One with attachments, drawn into."""
    if w.maybe(0.8):
        texture = w.make("texture", "GL.glGenTextures(1)")
        depth = w.make("renderbuffer", "GL.glGenRenderbuffers(1)")
        name = w.make("framebuffer", "GL.glGenFramebuffers(1)")
        steps = [
            f"GL.glBindTexture(GL.GL_TEXTURE_2D, {texture})",
            "GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGBA, 32, 32, 0, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, octets(1))",  # noqa: E501
            "GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST)",
            f"GL.glBindRenderbuffer(GL.GL_RENDERBUFFER, {depth})",
            w.fill(
                "GL.glRenderbufferStorage(GL.GL_RENDERBUFFER, {DEPTH_COMPONENT24|DEPTH24_STENCIL8}, 32, 32)"  # noqa: E501
            ),
            f"GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, {name})",
            f"GL.glFramebufferTexture2D(GL.GL_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D, {texture}, 0)",  # noqa: E501
            f"GL.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, GL.GL_DEPTH_ATTACHMENT, GL.GL_RENDERBUFFER, {depth})",  # noqa: E501
        ]
        w.say(*(step for step in steps if not w.maybe(0.03)))
        if w.maybe(0.9):
            w.say("GL.glClear(0x4500)")
    for _ in range(w.whole(1, 4)):
        kind = w.weighted({"call": 4, "primitive": 2, "draw": 1, "clear": 1})
        if kind == "call":
            w.say("GL." + w.row(_CALLS))
        elif kind == "primitive":
            primitive(w)
        elif kind == "draw":
            w.say("GL.glVertexPointer(3, GL.GL_FLOAT, 0, floats(1))", draw(w))
        else:
            w.say(w.row(CLEARS))
    if w.maybe(0.8):
        w.say("GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, 0)")
