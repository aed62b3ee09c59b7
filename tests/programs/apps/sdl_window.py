"""SDL2 by ctypes."""

import sdl2
import toolkit_scene

sdl2.SDL_Init(sdl2.SDL_INIT_VIDEO)
window = sdl2.SDL_CreateWindow(b"SDL", 0, 0, 300, 200, sdl2.SDL_WINDOW_OPENGL)
context = sdl2.SDL_GL_CreateContext(window)
for _ in range(60):
    toolkit_scene.draw(300, 200)
    sdl2.SDL_GL_SwapWindow(window)
    sdl2.SDL_PumpEvents()
sdl2.SDL_Quit()
