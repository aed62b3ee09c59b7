"""``glshim shot``: one frame of a program at any size, by way of a surface larger than its window.

The program draws its frame as ever. Below PyOpenGL its viewports, scissor boxes, line widths,
points and bitmaps are scaled, and what it draws into the window goes into a framebuffer object;
what it asks about them is answered as if nothing were. None of this is loaded but during a shot.
"""
