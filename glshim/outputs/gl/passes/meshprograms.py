"""Programs of mesh shaders: a styler's texts behind the preludes that they follow."""

from __future__ import annotations

from collections.abc import Hashable

from glshim.geometry.meshshaders.poses import Keyframes, Pose
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.programs import Program, shader_text
from glshim.styling.passes import MeshShader

_DEPTH = shader_text("depth.glsl")
_MESH = shader_text("window.glsl", "mesh.glsl", "edges.glsl")


class MeshPrograms:
    """Of one context, each compiled once."""

    def __init__(self, device: ModernDevice) -> None:
        self._device = device
        self._found: dict[Hashable, Program] = {}

    def find(
        self,
        shader: MeshShader,
        pose: Pose | None = None,
        *,
        sieved: bool = False,
        planes: int = 0,
    ) -> Program:
        """The program of a shader for meshes that a pose moves, or of which a sieve leaves some,
        with so many clip planes of the app's. Raises `RenderError` with the driver's words when it
        does not compile."""
        defines = f"#define CLIP_PLANES {planes}\n" + "#define SIEVED\n" * sieved
        if isinstance(pose, Keyframes):
            defines += "#define KEYFRAMES\n"
        elif pose is not None:
            defines += f"#define BONES {len(pose.matrices)}\n"
        found = self._found.get((shader, defines))
        if found is None:
            found = self._found[shader, defines] = self.compiled(shader, stages(shader, defines))
        return found

    def compiled(self, shader: MeshShader, texts: tuple[str, str, str]) -> Program:
        """A new one from the texts of its stages."""
        return self._device.program(shader.name, *texts)


def stages(shader: MeshShader, defines: str) -> tuple[str, str, str]:
    """The texts of the vertex, the fragment and the geometry stage (empty for none)."""

    def text(stage: str, prelude: str, own: str) -> str:
        return f"#version 330\n{defines}{stage}{prelude}#line 1\n{own}"

    return (
        text("#define VERTEX_STAGE\n", _DEPTH + _MESH, shader.vertex),
        text("", _DEPTH, shader.fragment),
        text("#define GEOMETRY_STAGE\n", _DEPTH + _MESH, shader.geometry)
        if shader.geometry
        else "",
    )
