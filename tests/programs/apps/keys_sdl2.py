"""Draws when a window is exposed, and says which keys it gets."""

import ctypes

import sdl2
import toolkit_scene
from sdl2 import SDL_WaitEvent

sdl2.SDL_Init(sdl2.SDL_INIT_VIDEO)
window = sdl2.SDL_CreateWindow(b"keys", 0, 0, 320, 240, sdl2.SDL_WINDOW_OPENGL)
context = sdl2.SDL_GL_CreateContext(window)
event = sdl2.SDL_Event()
while SDL_WaitEvent(ctypes.byref(event)):
    if event.type == sdl2.SDL_WINDOWEVENT and event.window.event == sdl2.SDL_WINDOWEVENT_EXPOSED:
        toolkit_scene.angle = 20
        toolkit_scene.draw(320, 240)
        sdl2.SDL_GL_SwapWindow(window)
    elif event.type in (sdl2.SDL_KEYDOWN, sdl2.SDL_KEYUP):
        name = sdl2.SDL_GetKeyName(event.key.keysym.sym).decode()
        if event.type == sdl2.SDL_KEYDOWN:
            print("key", name.upper() if len(name) > 1 else name, flush=True)
        elif name.startswith("F") and name != "F8":
            print("released", name, flush=True)
        if event.key.keysym.sym == sdl2.SDLK_ESCAPE:
            break
sdl2.SDL_Quit()
