"""Every fixed-function script of PyOpenGL-Demo, beyond the list that the tests hold."""

from .catalog import DEMO, Program, demo
from .sources import unpacked

OPENS = ("glutCreateWindow", "import maintest", "NeHeGL", "OpenGL.Tk", "pygame.display.set_mode")
DRAWS = ("glBegin", "glCallList", "glDrawArrays", "glDrawElements", "glutSolid", "glutWire",
         "glMap", "gluSphere", "gluNurbs", "gle", "glRect")
OWN_SHADERS = ("glUseProgram", "glUseProgramObjectARB", "shaders.compile")


def every_demo() -> tuple[Program, ...]:
    """Scripts that open a window and draw with the fixed-function GL."""
    root = unpacked(DEMO) / "OpenGL_Demo"
    found = []
    for script in sorted(root.rglob("*.py")):
        text = script.read_text(errors="replace")
        if not any(word in text for word in OPENS) or any(word in text for word in OWN_SHADERS):
            continue
        if script.name != "__init__.py" and any(word in text for word in DRAWS):
            found.append(demo(str(script.relative_to(root))))
    return tuple(found)
