"""Every fixed-function script of PyOpenGL-Demo, beyond the list that the tests hold."""

from .catalog import DEMO, Program, demo
from .sources import unpacked

# Libraries, set-up scripts and programs that want a toolkit or input of their own.
LEFT_OUT = ("__init__.py", "setup.py", "shader", "Shader")
DRAWS = ("glBegin", "glVertex", "glCallList", "glDrawArrays", "glDrawElements", "glutSolid",
         "glMap", "gluSphere", "gluNurbsSurface", "gle")


def every_demo() -> tuple[Program, ...]:
    """Scripts that draw with the fixed-function GL and start a main loop."""
    root = unpacked(DEMO) / "OpenGL_Demo"
    found = []
    for script in sorted(root.rglob("*.py")):
        if any(word in script.name for word in LEFT_OUT):
            continue
        text = script.read_text(errors="replace")
        if "__main__" in text or "MainLoop" in text or "mainloop" in text:
            if "glUseProgram" in text or not any(word in text for word in DRAWS):
                continue
            found.append(demo(str(script.relative_to(root))))
    return tuple(found)
