"""`keys_first.py KEYS SCRIPT`: runs a GLUT program and gives it key presses as its loop begins, to
leave its menu."""

import os
import runpy
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from OpenGL import GLUT

keys, sys.argv = sys.argv[1], sys.argv[2:]
sys.path[:0] = [str(Path(sys.argv[0]).resolve().parent), os.getcwd()]
register, loop = GLUT.glutKeyboardFunc, GLUT.glutMainLoop
pressed: list[Callable[..., Any]] = []


def glut_keyboard_func(function: Callable[..., Any]) -> Any:
    pressed[:] = [function]
    return register(function)


def glut_main_loop() -> Any:
    for key in keys:
        for function in pressed:
            function(key.encode(), 10, 10)
    return loop()


GLUT.glutKeyboardFunc, GLUT.glutMainLoop = glut_keyboard_func, glut_main_loop
runpy.run_path(sys.argv[0], run_name="__main__")
