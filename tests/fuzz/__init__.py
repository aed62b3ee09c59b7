"""Random programs over all of OpenGL, run plain, under style ``none`` and under every style.

A program is a list of steps, each one line of Python (`tests.fuzz.program`); generators make it
from a seed and a number alone (`tests.fuzz.areas`). Workers play it (`tests.fuzz.stage`) and write
down what a program can see; nothing of that may differ (`tests.fuzz.compare`). What differs is made
as short as it goes (`tests.fuzz.shrink`).
"""
