"""The part of a program that has a use for a key."""

import glfw

PAUSE = glfw.KEY_F10
