"""The programs that others wrote, as data: where each comes from and how it is started."""

import re
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).parent
DEMO = "PyOpenGL-Demo"


@dataclass(frozen=True, slots=True)
class Program:
    """One program, run unmodified. `source` is a key of `sources`, "pygame" or "ours"."""

    name: str
    source: str
    script: str = ""  # a path inside the source's folder, or `-m module`
    arguments: tuple[str, ...] = ()
    home: str = ""  # a folder whose files lie in the program's home
    frames: int = 3
    inked: bool = True  # whether the raskar style is to leave lines on it

    @property
    def slug(self) -> str:
        return re.sub(r"\W+", "_", self.name.removesuffix(".py"))


def demo(path: str, inked: bool = True) -> Program:
    return Program(path, DEMO, f"OpenGL_Demo/{path}", inked=inked)


DEMO_PROGRAMS = (
    demo("GLUT/gears.py"),
    demo("GLUT/glutplane.py"),
    demo("GLUT/molehill.py"),
    demo("redbook/scene.py"),
    demo("redbook/teapots.py"),
    demo("redbook/movelight.py"),  # its window has no depth buffer
    demo("NeHe/lesson5.py"),
    demo("NeHe/lesson6.py"),
    demo("NeHe/lesson12.py"),
    demo("NeHe/lesson18.py"),
    demo("NeHe/lesson26.py"),
    demo("proesch/colorCube/colorCube.py"),
    demo("proesch/bezier/bezier.py"),
    demo("proesch/nurbs/nurbs.py"),
    demo("GLE/helix.py"),
)

OTHERS = (
    Program("Planet3D", "Planet3D", str(HERE / "apps" / "solar_system.py")),
    Program("phalcopulse", "phalcopulse", str(HERE / "apps" / "bouncing_ball.py")),
    Program("pygame/glcube", "pygame", str(HERE / "apps" / "glcube_fixed.py")),
    Program("pygame/glcube, core profile", "pygame", "-m pygame.examples.glcube", inked=False),
    Program("dxf2gcode", "dxf2gcode", "usr/bin/dxf2gcode", (str(HERE / "apps" / "plate.dxf"),),
            home=str(HERE / "apps" / "dxf2gcode_home"), frames=1),
)

OLD_MANNERS = (
    Program("old_windows", "ours", str(HERE / "apps" / "old_windows.py"), frames=6),
    Program("cad_views", "ours", str(HERE / "apps" / "cad_views.py")),
    Program("effects", "ours", str(HERE / "apps" / "effects.py")),
    Program("raw_threads", "ours", str(HERE / "apps" / "raw_threads.py"), frames=4),
    Program("loader_thread", "ours", str(HERE / "apps" / "loader_thread.py"), frames=4),
)

TOOLKITS = tuple(
    Program(name, source, str(HERE / "apps" / f"{name}.py"), frames=frames)
    for name, source, frames in (
        ("qt_widgets", "dxf2gcode", 1),  # which brings PyQt5 and the libraries that it needs
        ("tk_frame", "pyopengltk", 1),
        ("togl_views", "Togl", 4),
        ("opengl_tk", "Togl", 3),
        ("sdl_window", "PySDL2", 4),
        ("pyglet_window", "pyglet", 4),
        ("wx_canvas", "wx", 1),
    )
)

OURS = tuple(
    Program(f"demo_apps/{name}", "ours", f"-m demo_apps.{name}")
    for name in ("01_gears", "02_solar_system", "03_robot_arm", "04_molecule", "05_terrain",
                 "06_chess", "07_cad_part", "08_figure", "09_gcode", "10_textured_room",
                 "island", "cloth", "flag", "blob", "bending_arm", "viewer")
)

PROGRAMS = DEMO_PROGRAMS + OTHERS + OLD_MANNERS + TOOLKITS + OURS
