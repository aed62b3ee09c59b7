"""Queries within a frame and across its end; debug messages."""

import ctypes

from OpenGL import GL
from OpenGL.GL.ARB import pipeline_statistics_query as statistics
from window import clear, swap

GL.glEnable(GL.GL_DEPTH_TEST)
heard = []


@GL.GLDEBUGPROC
def hear(*words):
    heard.append(ctypes.string_at(words[5], words[4]).decode()[:90])


GL.glEnable(GL.GL_DEBUG_OUTPUT)
GL.glEnable(GL.GL_DEBUG_OUTPUT_SYNCHRONOUS)
GL.glDebugMessageCallback(hear, None)


def strip(triangles):
    GL.glBegin(GL.GL_TRIANGLE_STRIP)
    for i in range(3 * triangles):
        GL.glVertex3f(i / (3.0 * triangles) - 0.5, i % 2 - 0.5, 0.1)
    GL.glEnd()


def counted(target, triangles, across):
    query = int(GL.glGenQueries(1)[0])
    clear()
    GL.glBeginQuery(target, query)
    strip(triangles)
    if across:
        swap()
    GL.glEndQuery(target)
    result = GL.glGetQueryObjectuiv(query, GL.GL_QUERY_RESULT)
    print(target, triangles, "across" if across else "within", int(result))
    swap()


for triangles in (1, 100):
    for across in (False, True):
        for target in (
            GL.GL_SAMPLES_PASSED, GL.GL_ANY_SAMPLES_PASSED, GL.GL_PRIMITIVES_GENERATED,
            statistics.GL_VERTICES_SUBMITTED_ARB, statistics.GL_PRIMITIVES_SUBMITTED_ARB,
            statistics.GL_VERTEX_SHADER_INVOCATIONS_ARB,
            statistics.GL_CLIPPING_INPUT_PRIMITIVES_ARB,
        ):  # fmt: skip
            counted(target, triangles, across)
print("heard", len(heard), sorted(set(heard)))
