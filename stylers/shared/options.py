"""Options that several styles have: what surfaces look like, and what lines are drawn with."""

from __future__ import annotations

from math import degrees
from typing import Any

from glshim.model.dihedral import GRAIN
from glshim.styling.protocol import Colour, option
from glshim.styling.textures import MADE


def colour(what: str) -> Any:
    """The colour of some lines: black unless it is given."""
    return option("#000000", help=f"colour of {what}")


def fill(what: str = "the surfaces") -> Any:
    """``fill``: `Styler.surface`."""
    return option(
        "app",
        help=f"{what}: as the app drew them, none, or flat in a colour",
        choices=("app", "none"),
        colour=True,
    )


def texture(lines: str) -> Any:
    """``texture``: of lines, a word for those that have it; see `glshim.styling.textures.made`."""
    return option(
        "none",
        help=f"what {lines} are drawn with; dark is ink in a grey picture, others keep colours",
        choices=("none", *MADE),
        picture=True,
    )


def texture_length(line: str) -> Any:
    """``texture_length``, of a line."""
    return option(
        0.0,
        help=f"length of {line} after which the texture repeats; 0: what suits it",
        low=0.0,
        high=4096.0,
        unit="px",
    )


def textures() -> Any:
    """``textures``: between `Styler.surface` ``paint`` and ``colours``."""
    return option(
        "app", help="the app's textures, or its colours alone", choices=("app", "off")
    )


def shade_unlit() -> Any:
    """``shade_unlit``, for `stylers.shared.shading.by_light`."""
    return option(
        "auto",
        help="what the app draws without lights: shaded by a light behind the viewer's shoulder, "
        "left as it is, or (auto) shaded where nothing is lit by the app, if it has no textures",
        choices=("auto", "off", "head"),
    )


def crease_angle(default: float) -> Any:
    """``crease_angle``."""
    return option(
        default, help="creases are where polygons turn by at least this", low=0.0, high=180.0,
        unit="degrees",
    )  # fmt: skip


def folds(crease_angle: float) -> tuple[float, float]:
    """The ridge angle and the valley angle, degrees, of edges whose polygons turn by at least a
    crease angle to either side: it includes its own folds, as a valley angle does not."""
    return 180.0 - crease_angle, max(180.0 + crease_angle - 2.0 * degrees(GRAIN), 180.0)


def tolerance(default: float = 1e-5) -> Any:
    """``tolerance``: of mesh recovery; what rounding parts is one, unless the default is 0."""
    return option(
        default, help="distance in object units at which corners are one vertex", low=0.0, high=1e6
    )


def paper(default: Colour) -> Any:
    """``paper``: see `stylers.shared.tones.tone_passes`."""
    return option(
        default, help="what is behind the surfaces: as the app drew it, or paper of a colour",
        choices=("app",), colour=True,
    )  # fmt: skip


def intersections() -> Any:
    """``intersections``, for `stylers.shared.intersections.crossings`."""
    return option(
        "auto",
        help="lines where polygons pass through each other, which costs drawing all of them twice; "
        "auto: of what has at most 20,000 polygons",
        choices=("auto", "on", "off"),
    )


def boil() -> Any:
    """``boil``, of what is drawn by hand."""
    return option(
        0.0, help="new motions of the hand a second; 0: it holds still", low=0.0, high=60.0
    )


def seed() -> Any:
    """``seed``, of what is drawn by hand."""
    return option(0, help="each draws with other motions", low=0, high=999)
