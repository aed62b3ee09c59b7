"""Vertex programs that glUseProgram does not know: assembly's, and pipelines of separate stages."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from OpenGL import GL
from OpenGL.GL.ARB import vertex_program as arb

from .test_contexts import VISIBLE, cube, inked
from .world import App, run

ASSEMBLY = b"""!!ARBvp1.0
MOV result.position, vertex.position;
MOV result.color, {1, 0, 0, 1};
END
"""
VERTEX = """
#version 330 compatibility
out gl_PerVertex { vec4 gl_Position; };
void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }
"""
FRAGMENT = """
#version 330 compatibility
void main() { gl_FragColor = vec4(1, 0, 0, 1); }
"""


def assembly() -> None:
    names = np.zeros(1, "u4")
    arb.glGenProgramsARB(1, names)
    arb.glBindProgramARB(arb.GL_VERTEX_PROGRAM_ARB, int(names[0]))
    arb.glProgramStringARB(
        arb.GL_VERTEX_PROGRAM_ARB, arb.GL_PROGRAM_FORMAT_ASCII_ARB, len(ASSEMBLY), ASSEMBLY
    )
    GL.glEnable(arb.GL_VERTEX_PROGRAM_ARB)


def stage(kind: int, text: str) -> int:
    shader, program = GL.glCreateShader(kind), GL.glCreateProgram()
    GL.glShaderSource(shader, text)
    GL.glCompileShader(shader)
    GL.glProgramParameteri(program, GL.GL_PROGRAM_SEPARABLE, 1)
    GL.glAttachShader(program, shader)
    GL.glLinkProgram(program)
    assert GL.glGetProgramiv(program, GL.GL_LINK_STATUS)
    return int(program)


def pipeline(*stages: tuple[int, int, str]) -> None:
    names = np.zeros(1, "u4")
    GL.glGenProgramPipelines(1, names)
    for kind, bit, text in stages:
        GL.glUseProgramStages(names[0], bit, stage(kind, text))
    GL.glBindProgramPipeline(names[0])


STAGE = (GL.GL_VERTEX_SHADER, GL.GL_VERTEX_SHADER_BIT, VERTEX)
COLOURS = (GL.GL_FRAGMENT_SHADER, GL.GL_FRAGMENT_SHADER_BIT, FRAGMENT)
TAKEN: dict[str, tuple[Callable[[], None], Callable[[], None]]] = {
    "assembly": (assembly, lambda: GL.glDisable(arb.GL_VERTEX_PROGRAM_ARB)),
    "pipeline": (lambda: pipeline(STAGE, COLOURS), lambda: GL.glBindProgramPipeline(0)),
}
"""How it begins, and how it ends."""


@pytest.mark.parametrize("kind", TAKEN)
def test_draws_pass_through(kind: str, capfd: pytest.CaptureFixture[str]) -> None:
    begin, end = TAKEN[kind]

    def scene(app: App) -> None:
        begin()
        cube()
        end()

    plain = run(scene)
    assert plain.differences(run(scene, VISIBLE)) == {}
    assert plain.differences(run(scene, "none")) == {}


@pytest.mark.parametrize("kind", TAKEN)
def test_lines_come_back_after_it(kind: str) -> None:
    begin, end = TAKEN[kind]

    def scene(app: App) -> None:
        begin()
        end()
        cube()

    assert inked(run(scene, VISIBLE)) == inked(run(lambda app: cube(), VISIBLE)) > 30


def test_a_pipeline_without_vertices_leaves_them_to_fixed_function() -> None:
    def scene(app: App) -> None:
        pipeline(COLOURS)
        cube()

    assert inked(run(scene, VISIBLE)) > 30


def test_a_stage_that_comes_later_is_seen() -> None:
    def scene(app: App) -> None:
        pipeline(COLOURS)
        cube()
        app.asks(GL.GL_PROGRAM_PIPELINE_BINDING)
        GL.glUseProgramStages(
            GL.glGetIntegerv(GL.GL_PROGRAM_PIPELINE_BINDING), GL.GL_VERTEX_SHADER_BIT,
            stage(GL.GL_VERTEX_SHADER, VERTEX),
        )  # fmt: skip
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        cube()

    assert run(scene).differences(run(scene, VISIBLE)) == {}
