"""Where the camera stands, and the light."""

import math
from dataclasses import dataclass, field

from OpenGL import GL, GLU

Colour = tuple[float, float, float]
BACKGROUND: Colour = (0.90, 0.92, 0.94)
ANGLE = 35.0  # vertical field of view, degrees
LIGHTS = ("beside the camera", "at the camera", "fixed to the model", "off")
SIDES = {"front": (0.0, 0.0), "right": (-90.0, 0.0), "top": (0.0, 90.0)}
TURN = 30.0  # degrees a second of the turntable
UPRIGHT = {"x": (90.0, 0.0, 0.0, 1.0), "y": (0.0, 1.0, 0.0, 0.0), "z": (-90.0, 1.0, 0.0, 0.0)}
"""By the model's axis that points up: an angle and an axis for glRotate."""


@dataclass
class View:
    """Looks at a point near the origin from a distance; angles are degrees."""

    azimuth: float = 35.0
    elevation: float = 28.0
    distance: float = 3.8
    aside: tuple[float, float] = (0.0, 0.0)  # of the model on the screen, in its units
    parallel: bool = False
    turns: bool = False
    light: str = LIGHTS[0]
    up: str = "y"  # the model's axis
    size: tuple[int, int] = (640, 480)
    grip: tuple[float, float, bool] | None = field(default=None, repr=False)

    def take(self, x: float, y: float, pans: bool) -> None:
        """A button went down there."""
        self.grip = (x, y, pans)

    def drag(self, x: float, y: float) -> None:
        if self.grip is None:
            return
        right, down = x - self.grip[0], y - self.grip[1]
        if self.grip[2]:
            unit = 2 * self.distance * math.tan(math.radians(ANGLE / 2)) / max(self.size[1], 1)
            self.aside = (self.aside[0] + unit * right, self.aside[1] - unit * down)
        else:
            self.orbit(0.4 * right, 0.4 * down)
        self.grip = (x, y, self.grip[2])

    def orbit(self, right: float, down: float) -> None:
        self.azimuth += right
        self.elevation = min(max(self.elevation + down, -90.0), 90.0)

    def zoom(self, steps: float) -> None:
        self.distance = min(max(self.distance * 0.9**steps, 1.2), 40.0)

    def look_from(self, side: str) -> None:
        self.azimuth, self.elevation = SIDES[side]

    def reset(self) -> None:
        fresh = View()
        self.azimuth, self.elevation = fresh.azimuth, fresh.elevation
        self.distance, self.aside = fresh.distance, fresh.aside

    def next_up(self) -> None:
        axes = list(UPRIGHT)
        self.up = axes[(axes.index(self.up) + 1) % len(axes)]

    def next_light(self) -> None:
        self.light = LIGHTS[(LIGHTS.index(self.light) + 1) % len(LIGHTS)]

    def apply(self, seconds: float = 0.0) -> None:
        """Set the matrices and the lights; seconds since the last frame move the turntable."""
        if self.turns:
            self.azimuth += TURN * seconds
        width, height = self.size[0], max(self.size[1], 1)
        GL.glViewport(0, 0, width, height)
        GL.glMatrixMode(GL.GL_PROJECTION)
        GL.glLoadIdentity()
        narrow = min(width / height, 1.0)  # keep the model in view in an upright window, too
        half = math.tan(math.radians(ANGLE / 2)) / narrow
        reach = 1.1 + math.hypot(*self.aside) if self.parallel else 1.1
        near, far = max(self.distance - reach, 0.05), self.distance + reach
        if self.parallel:
            up = half * self.distance
            GL.glOrtho(-up * width / height, up * width / height, -up, up, near, far)
        else:
            GLU.gluPerspective(2 * math.degrees(math.atan(half)), width / height, near, far)
        GL.glMatrixMode(GL.GL_MODELVIEW)
        GL.glLoadIdentity()
        if self.light != "fixed to the model":
            self._place_lights()
        GL.glTranslatef(*self.aside, -self.distance)
        GL.glRotatef(self.elevation, 1.0, 0.0, 0.0)
        GL.glRotatef(self.azimuth, 0.0, 1.0, 0.0)
        if self.light == "fixed to the model":
            self._place_lights()
        GL.glRotatef(*UPRIGHT[self.up])

    def _place_lights(self) -> None:
        (GL.glDisable if self.light == "off" else GL.glEnable)(GL.GL_LIGHTING)
        main = (0.0, 0.0, 1.0, 0.0) if self.light == "at the camera" else (2.0, 4.0, 3.0, 0.0)
        for light, place, bright in ((GL.GL_LIGHT0, main, 0.85),
                                     (GL.GL_LIGHT1, (-4.0, 1.0, 1.0, 0.0), 0.25)):
            GL.glEnable(light)
            GL.glLightfv(light, GL.GL_POSITION, place)
            GL.glLightfv(light, GL.GL_DIFFUSE, (bright, bright, bright, 1.0))


def set_up(background: Colour = BACKGROUND) -> None:
    """What does not change from frame to frame."""
    GL.glClearColor(*background, 1.0)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glEnable(GL.GL_COLOR_MATERIAL)
    GL.glLightModeli(GL.GL_LIGHT_MODEL_TWO_SIDE, GL.GL_TRUE)
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_SPECULAR, (0.25, 0.25, 0.25, 1.0))
    GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, 30.0)
