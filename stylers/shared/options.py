"""Options that several styles have: what surfaces look like, and what lines are drawn with."""

from __future__ import annotations

from math import degrees
from typing import Any

from glshim.model.dihedral import GRAIN
from glshim.styling.protocol import Colour, option
from glshim.styling.textures import TEXTURES


def width(default: float, lines: str = "all lines", *, high: float = 64.0) -> Any:
    """``width``, of all lines."""
    return option(default, help=f"width of {lines}", low=0.5, high=high, unit="px")


def inner(default: float) -> Any:
    """``inner``, of what draws outlines in `width`."""
    return option(
        default, help="width of lines inside the outlines, as a share of width", low=0.05, high=1.0
    )


def ink(default: str, lines: str = "all lines") -> Any:
    """``ink``, of all lines."""
    return option(default, help=f"colour of {lines}")


def texture(default: str = "none", lines: str = "all lines") -> Any:
    """``texture``: a word for those that have it; see `glshim.styling.textures.made`."""
    return option(
        default,
        help=f"texture of {lines}; in a grey picture dark is ink, others keep their colours",
        choices=("none", *TEXTURES),
        picture=True,
    )


def texture_length() -> Any:
    """``texture_length``."""
    return option(
        0.0, help="length after which a texture repeats; 0: a length that suits the texture",
        low=0.0, high=4096.0, unit="px",
    )  # fmt: skip


def dash() -> Any:
    """``dash``, of all lines."""
    return option(
        0.0, help="length of a dash and the gap after it; 0: solid lines", low=0.0, high=256.0,
        unit="px",
    )  # fmt: skip


def fill(what: str = "surfaces") -> Any:
    """``fill``: `Styler.surface`."""
    return option(
        "app",
        help=f"{what}: as the program draws them (app), not drawn (none), or in one colour",
        choices=("app", "none"),
        colour=True,
    )


def paint() -> Any:
    """``paint``, of what is lit anew."""
    return option(
        "app", help="colour of the surfaces: the program's own (app), or one colour",
        choices=("app",), colour=True,
    )  # fmt: skip


def textures() -> Any:
    """``textures``: between `Styler.surface` ``paint`` and ``colours``."""
    return option(
        "app", help="the program's textures (app), or its colours without them (off)",
        choices=("app", "off"),
    )  # fmt: skip


def shade_unlit() -> Any:
    """``shade_unlit``, for `stylers.shared.shading.by_light`."""
    return option(
        "auto",
        help="shading of surfaces that the program draws without lights: a light behind the viewer "
        "(head), none (off), or a little of head where the program lights nothing (auto)",
        choices=("auto", "off", "head"),
    )


def gloss(default: float) -> Any:
    """``gloss``."""
    return option(
        default, help="exponent of highlights; higher is smaller and sharper", low=1.0, high=1000.0
    )


def highlight(default: float) -> Any:
    """``highlight``."""
    return option(
        default, help="brightness of highlights on curved, shiny surfaces", low=0.0, high=1.0
    )


def crease_angle(default: float) -> Any:
    """``crease_angle``."""
    return option(
        default, help="smallest bend drawn as a crease; a flat surface bends by 0",
        low=0.0, high=180.0, unit="degrees",
    )  # fmt: skip


def ridge_angle() -> Any:
    """``ridge_angle``, of the papers, where `crease_angle` is not enough."""
    return option(
        120.0, follows="crease_angle", help="largest dihedral angle of a ridge; auto: 180 minus "
        "crease_angle", low=0.0, high=360.0, unit="degrees",
    )  # fmt: skip


def valley_angle() -> Any:
    """``valley_angle``."""
    return option(
        240.0, follows="crease_angle", help="a valley has a larger dihedral angle; auto: 180 plus "
        "crease_angle", low=0.0, high=360.0, unit="degrees",
    )  # fmt: skip


def folds(crease_angle: float) -> tuple[float, float]:
    """The ridge angle and the valley angle, degrees, of edges whose polygons turn by at least a
    crease angle to either side: it includes its own folds, as a valley angle does not."""
    return 180.0 - crease_angle, max(180.0 + crease_angle - 2.0 * degrees(GRAIN), 180.0)


def tolerance(default: float = 1e-5) -> Any:
    """``tolerance``: of mesh recovery; what rounding parts is one, unless the default is 0."""
    return option(
        default, help="vertex merge distance, in object units", low=0.0, high=1e6
    )


def paper(default: Colour | str) -> Any:
    """``paper``: see `stylers.shared.tones.tone_passes`."""
    return option(
        default, help="background: as the program draws it (app), or paper of one colour",
        choices=("app",), colour=True,
    )  # fmt: skip


def own_ink() -> Any:
    """``own_ink``: `Styler.gathers_ink`."""
    return option(
        "auto",
        help="keep text and lines of the program readable: darker or lighter where they would "
        "vanish (auto: where the style brings paper)", choices=("auto", "on", "off"),
    )  # fmt: skip


def intersections(default: str = "auto") -> Any:
    """``intersections``, for `stylers.shared.intersections.looked_for`."""
    return option(
        default,
        help="draw lines where polygons pass through each other; slow on large scenes (auto: up to "
        "20,000 polygons)",
        choices=("auto", "on", "off"),
    )


def hidden(*more: str) -> Any:
    """``hidden``."""
    return option(
        "none", help="lines behind surfaces", choices=("none", "dashed", "dimmed", *more)
    )


def hidden_share(default: float, when: str = "") -> Any:
    """``hidden_share``."""
    return option(
        default, help=f"opacity of hidden lines that are dashed or solid{when}", low=0.0, high=1.0
    )


def opacity(default: float) -> Any:
    """``opacity``, of strokes that lie over each other."""
    return option(default, help="opacity of a single stroke", low=0.02, high=1.0)


def repeats(default: int, most: int) -> Any:
    """``strokes``, of what is drawn by hand."""
    return option(default, help="strokes per line, drawn over each other", low=1, high=most)


def jitter(default: float) -> Any:
    """``jitter``, of what is drawn by hand."""
    return option(
        default, help="distance by which strokes wander off their line", low=0.0, high=32.0,
        unit="px",
    )  # fmt: skip


def overshoot(default: float) -> Any:
    """``overshoot``, of what is drawn by hand."""
    return option(
        default, help="distance by which strokes run past their ends", low=0.0, high=64.0, unit="px"
    )


def boil() -> Any:
    """``boil``, of what is drawn by hand."""
    return option(0.0, help="jitter changes per second; 0: static", low=0.0, high=60.0)


def seed() -> Any:
    """``seed``, of what is drawn by hand."""
    return option(0, help="random seed of the strokes", low=0, high=999)
