"""Programs of mesh shaders: a styler's texts behind the preludes that they follow."""

from __future__ import annotations

from collections.abc import Hashable
from importlib.resources import files
from typing import Any

import moderngl

from glshim.errors import RenderError
from glshim.geometry.meshshaders.poses import Keyframes, Pose
from glshim.outputs.gl.device.programs import Program
from glshim.styling.passes import MeshShader

_SHADERS = files("glshim.outputs.gl") / "shaders"
_MESH = "".join(
    (_SHADERS / name).read_text("utf-8") for name in ("window.glsl", "mesh.glsl", "edges.glsl")
)
_DEPTH = (_SHADERS / "depth.glsl").read_text("utf-8")


class MeshPrograms:
    """Of one context (a moderngl one), each compiled once."""

    def __init__(self, context: Any) -> None:
        self._context = context
        self._found: dict[Hashable, Program] = {}

    def find(
        self,
        shader: MeshShader,
        pose: Pose | None = None,
        *,
        sieved: bool = False,
        planes: int = 0,
        varyings: tuple[str, ...] = (),
    ) -> Program:
        """The program of a shader for meshes that a pose moves, or of which a sieve leaves some,
        with so many clip planes of the app's. varyings: what transform feedback shall capture.
        Raises `RenderError` with the driver's words when it does not compile."""
        defines = f"#define CLIP_PLANES {planes}\n" + "#define SIEVED\n" * sieved
        if isinstance(pose, Keyframes):
            defines += "#define KEYFRAMES\n"
        elif pose is not None:
            defines += f"#define BONES {len(pose.matrices)}\n"
        key = (shader, defines, varyings)
        found = self._found.get(key)
        if found is None:
            found = self._found[key] = self._compiled(shader, defines, varyings)
        return found

    def _compiled(self, shader: MeshShader, defines: str, varyings: tuple[str, ...]) -> Program:
        def text(stage: str, prelude: str, own: str) -> str:
            return f"#version 330\n{defines}{stage}{prelude}#line 1\n{own}"

        geometry = None
        if shader.geometry:
            geometry = text("#define GEOMETRY_STAGE\n", _DEPTH + _MESH, shader.geometry)
        try:
            made = self._context.program(
                vertex_shader=text("#define VERTEX_STAGE\n", _DEPTH + _MESH, shader.vertex),
                geometry_shader=geometry,
                fragment_shader=None if varyings else text("", _DEPTH, shader.fragment),
                varyings=varyings,
            )
        except moderngl.Error as error:
            raise RenderError(f"shader {shader.name!r} does not compile: {error}") from error
        return Program(made)
