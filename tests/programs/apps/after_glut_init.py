"""`after_glut_init.py SCRIPT`: calls glutInit, which freeglut wants before its shapes and other
GLUTs do not, and runs the script."""

import os
import runpy
import sys
from pathlib import Path

from OpenGL.GLUT import glutInit

glutInit(["program"])
sys.argv = sys.argv[1:]
sys.path[:0] = [str(Path(sys.argv[0]).resolve().parent), os.getcwd()]
runpy.run_path(sys.argv[0], run_name="__main__")
