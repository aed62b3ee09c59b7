"""Pictures of P. Rideout, "Silhouette Extraction" (2010), made again: the steps and the dragon."""

from __future__ import annotations

from tests.figures.table import Figure

TORUS = ("-m", "tests.figures.programs.torus")
DRAGON = ("-m", "demo_apps.08_figure")
_BARE = "fins:half_width=7,joints=none"

FIGURES = (
    Figure("rideout_old_school", TORUS, ("two_pass:width=7,smooth=off", "two_pass:width=7"), 2),
    Figure(
        "rideout_steps",  # no anti-aliasing, anti-aliasing, spine test, gaps filled
        TORUS,
        (
            f"{_BARE},tip=0,spine=off",
            f"{_BARE},spine=off",
            _BARE,
            "fins:half_width=7,joints=overhang",
        ),
        2,
    ),
    Figure("rideout_surfaces", TORUS, ("fins:fill=lit", "fins:fill=cel"), 2),
    Figure("rideout_dragon", DRAGON, ("fins:half_width=3,fill=cel",), frames=14),
)
