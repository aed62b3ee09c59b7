"""Contexts of EGL without a display, in place of those that a toolkit would make for its windows.

They draw into pbuffers, which nobody sees; what is presented is what is drawn.
"""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

# From egl.h and eglext.h.
EGL_NONE, EGL_TRUE = 0x3038, 1
EGL_PLATFORM_SURFACELESS_MESA = 0x31DD
EGL_OPENGL_API, EGL_OPENGL_ES_API = 0x30A2, 0x30A0
EGL_SURFACE_TYPE, EGL_PBUFFER_BIT = 0x3033, 0x0001
EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_OPENGL_ES2_BIT = 0x3040, 0x0008, 0x0004
EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE = 0x3024, 0x3023, 0x3022, 0x3021
EGL_DEPTH_SIZE, EGL_STENCIL_SIZE = 0x3025, 0x3026
EGL_SAMPLE_BUFFERS, EGL_SAMPLES = 0x3032, 0x3031
EGL_WIDTH, EGL_HEIGHT = 0x3057, 0x3056
EGL_CONTEXT_MAJOR_VERSION, EGL_CONTEXT_MINOR_VERSION = 0x3098, 0x30FB
EGL_CONTEXT_OPENGL_PROFILE_MASK = 0x30FD
CORE, COMPATIBILITY = 1, 2

Attributes = Mapping[int, int]


@dataclass(slots=True)
class Pbuffer:
    """A context and what it draws into."""

    context: int
    surface: int
    config: int
    size: tuple[int, int]


class Pbuffers:
    """EGL's display without a screen, and what is made on it."""

    def __init__(self) -> None:
        """Raises `OSError` where there is none to be had."""
        self._egl = egl = ctypes.CDLL("libEGL.so.1")
        for name in ("eglGetPlatformDisplay", "eglCreateContext", "eglCreatePbufferSurface",
                     "eglGetProcAddress"):  # fmt: skip
            getattr(egl, name).restype = ctypes.c_void_p
        self._display = egl.eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, None, None)
        if not self._display or not egl.eglInitialize(ctypes.c_void_p(self._display), None, None):
            raise OSError("EGL gives no display without a screen")

    def make(
        self, size: tuple[int, int], wanted: Attributes, context: Attributes,
        share: Pbuffer | None = None, *, embedded: bool = False,
    ) -> Pbuffer | None:  # fmt: skip
        """wanted: sizes of the buffers; what cannot be had is left out. context: its version and
        profile. embedded: of OpenGL ES. None where there is none to be had."""
        self._egl.eglBindAPI(EGL_OPENGL_ES_API if embedded else EGL_OPENGL_API)
        kind = EGL_OPENGL_ES2_BIT if embedded else EGL_OPENGL_BIT
        config = self._config({**wanted, EGL_RENDERABLE_TYPE: kind})
        if not config:
            return None
        made = self._egl.eglCreateContext(
            ctypes.c_void_p(self._display), ctypes.c_void_p(config),
            ctypes.c_void_p(share.context if share is not None else None), _listed(context),
        )  # fmt: skip
        return Pbuffer(made, self._surface(config, size), config, size) if made else None

    def make_current(self, pbuffer: Pbuffer | None) -> bool:
        """None: nothing is current any more."""
        surface = ctypes.c_void_p(pbuffer.surface if pbuffer is not None else None)
        context = ctypes.c_void_p(pbuffer.context if pbuffer is not None else None)
        return bool(
            self._egl.eglMakeCurrent(ctypes.c_void_p(self._display), surface, surface, context)
        )

    def resize(self, pbuffer: Pbuffer, size: tuple[int, int]) -> None:
        """What was drawn is lost. The caller makes it current again."""
        if size != pbuffer.size:
            self._drop(pbuffer.surface)
            pbuffer.surface, pbuffer.size = self._surface(pbuffer.config, size), size

    def destroy(self, pbuffer: Pbuffer) -> None:
        """Of one that is current only what nobody uses any more."""
        self._egl.eglDestroyContext(
            ctypes.c_void_p(self._display), ctypes.c_void_p(pbuffer.context)
        )
        self._drop(pbuffer.surface)

    def address(self, name: bytes) -> int:
        """Of a function of OpenGL; 0 where there is none."""
        return self._egl.eglGetProcAddress(name) or 0

    def _config(self, wanted: Attributes) -> int:
        least = {
            EGL_SURFACE_TYPE: EGL_PBUFFER_BIT, EGL_RED_SIZE: 8, EGL_GREEN_SIZE: 8,
            EGL_BLUE_SIZE: 8, **wanted,
        }  # fmt: skip
        config, count = ctypes.c_void_p(), ctypes.c_int()
        for left_out in ((), (EGL_SAMPLE_BUFFERS, EGL_SAMPLES), (EGL_STENCIL_SIZE,),
                         (EGL_DEPTH_SIZE,), (EGL_ALPHA_SIZE,)):  # fmt: skip
            for name in left_out:
                least.pop(name, None)
            found = self._egl.eglChooseConfig(
                ctypes.c_void_p(self._display), _listed(least), ctypes.byref(config), 1,
                ctypes.byref(count),
            )  # fmt: skip
            if found and count.value:
                return config.value or 0
        return 0

    def _surface(self, config: int, size: tuple[int, int]) -> int:
        wanted = {EGL_WIDTH: max(size[0], 1), EGL_HEIGHT: max(size[1], 1)}
        made: int | None = self._egl.eglCreatePbufferSurface(
            ctypes.c_void_p(self._display), ctypes.c_void_p(config), _listed(wanted)
        )
        return made or 0

    def _drop(self, surface: int) -> None:
        self._egl.eglDestroySurface(ctypes.c_void_p(self._display), ctypes.c_void_p(surface))


@cache
def pbuffers() -> Pbuffers:
    """Those of this process. Raises `OSError`."""
    return Pbuffers()


def _listed(attributes: Attributes) -> Any:
    """As EGL reads them."""
    words = [word for pair in attributes.items() for word in pair]
    return (ctypes.c_int * (len(words) + 1))(*words, EGL_NONE)
