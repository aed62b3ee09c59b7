"""Programs of public repositories, run from a folder of checkouts that somebody made by hand.

FOLDER/OWNER+NAME is a clone of github.com/OWNER/NAME at the commit below. Modules that this Python
lacks may lie in FOLDER/site (`pip install --target FOLDER/site NAME`). What is absent is skipped,
with the reason. None of their code is in this repository.
"""

import importlib
from dataclasses import dataclass
from importlib.machinery import PathFinder
from pathlib import Path

from .catalog import HERE, Program
from .sources import Launch, SourceMissing

AFTER_GLUT = str(HERE / "apps" / "after_glut_init.py")
KEYS_FIRST = str(HERE / "apps" / "keys_first.py")


@dataclass(frozen=True, slots=True)
class Checkout:
    """A program in a repository. `script` and `folder` are paths in it; `helper` is ours, and runs
    the script with `words` before its name."""

    name: str
    repository: str
    commit: str
    script: str
    folder: str = ""  # the working folder
    module: str = ""  # that it needs
    helper: str = ""
    words: tuple[str, ...] = ()
    frames: int = 3

    def program(self) -> Program:
        """What the harness runs; `launch` says how."""
        return Program(self.name, self.repository, frames=self.frames)


TEACHING = ("dknife/2024Graphics", "2962708")

CHECKOUTS = (
    Checkout("3D room", "AhmetServet/3DRoomWithPyOpenGL", "14229ac", "src/main.py",
             module="PyQt5", helper=AFTER_GLUT),
    Checkout("robot arm", "AlessandroLauria/Robotic-Arm-3D-with-3-degree-of-freedom-PyOpenGl",
             "7654a8e", "Main.py"),
    Checkout("billiards", "Spektralzerleger/PyOpenGL-Billard", "00c6e11", "main.py"),
    Checkout("maze", "ruscoe/pyopengl-maze", "e2681b7", "maze.py"),
    Checkout("F1 race", "keven-silva/f1-race", "eeb67bb", "main.py", module="pywavefront"),
    Checkout("solar system", "SH-Jisan/solar_system", "8a10853", "main.py",
             folder="solar_system"),
    Checkout("BVH viewer", "Eunho-J/BVH-Viewer", "be09e7d", "main.py", module="PyQt5"),
    Checkout("Once Upon a Hop", "catab60/OnceUponAHop", "e57f785", "main.py",
             module="pyautogui"),
    Checkout("NomadCraft", "sg33z/NomadCraft_PyOpenGL", "fe5483c", "main.py", module="pynput"),
    Checkout("Demons & Portals", "FaisalIf/CSE423-Computer-Graphics-Project", "e0a44ac",
             "main.py", helper=KEYS_FIRST, words=("n",)),
    Checkout("tank wars", "Abrarkhan88/CSE423-project-Tank-Wars", "9fa834a", "base.py"),
    Checkout("space survival", "sabbirosa/CSE423-Project", "c7b5d03", "Space_Survival_3D.py"),
    Checkout("CSE423 game", "Khaled-Kommits/CSE423_3D-Project", "6dda38f", "main.py"),
    Checkout("wx cube", "wxWidgets/Phoenix", "40b41ccf", "GLCanvas.py",
             folder="samples/glcanvas", module="wx"),
    Checkout("Tk cube", "jonwright/pyopengltk", "a1def35", "cube.py", folder="examples",
             module="pyopengltk"),
    Checkout("SDL2 shapes", "py-sdl/py-sdl2", "4aebd3a", "opengl.py", folder="examples",
             module="sdl2"),
    Checkout("light", *TEACHING, "lightBasic3.py", folder="codes/Ex09_LightAndTexture",
             module="PyQt6"),
    Checkout("textured cow", *TEACHING, "03_Textured.py", folder="codes/Ex09_LightAndTexture",
             module="PyQt6"),
    Checkout("many cows", *TEACHING, "02_ManyMeshesWithNormals.py",
             folder="codes/Ex09_LightAndTexture", module="PyQt6"),
    Checkout("robot that moves", *TEACHING, "Ex0706_RobotMove.py",
             folder="codes/Ex_HierarchicalModels/RobotMove", module="PyQt6"),
    Checkout("two cameras", *TEACHING, "twoCameraFinal.py", folder="codes/Ex04_Camera",
             module="PyQt6"),
)


def launch(checkout: Checkout, root: Path) -> Launch:
    """How a checkout below `root` is started; SourceMissing where something is absent."""
    clone = root / checkout.repository.replace("/", "+")
    if not clone.is_dir():
        raise SourceMissing(
            f"no clone of github.com/{checkout.repository} at {checkout.commit} in {root}")
    site = root / "site"
    if checkout.module and PathFinder.find_spec(checkout.module, None) is None and (
            PathFinder.find_spec(checkout.module, [str(site)]) is None):
        raise SourceMissing(f"neither this Python nor {site} has {checkout.module}")
    folder = clone / checkout.folder
    if not (folder / checkout.script).is_file():
        raise SourceMissing(f"{clone} has no {Path(checkout.folder, checkout.script)}")
    helper = (checkout.helper, *checkout.words) if checkout.helper else ()
    script = checkout.script if helper else str(folder / checkout.script)
    return Launch((*helper, script), folder, (site,))


def starts_from(root: Path) -> dict[Program, Launch | SourceMissing]:
    """Every program with how it is started, or why not."""
    importlib.invalidate_caches()
    found: dict[Program, Launch | SourceMissing] = {}
    for checkout in CHECKOUTS:
        try:
            found[checkout.program()] = launch(checkout, root)
        except SourceMissing as reason:
            found[checkout.program()] = reason
    return found
