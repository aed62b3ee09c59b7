"""Figures 9 to 14 of T. Hajagos et al. 2012 (silhouettes and creases by geometry shaders), made
again of meshes of our own."""

from __future__ import annotations

from tests.figures.table import Figure

_PIECES = ("-m", "tests.figures.programs.pieces")
_MIDDLE = (120, 0, 520, 480)

FIGURES = (
    Figure("hajagos_9", (*_PIECES, "crowd"), ("crease:width=2",)),  # many objects
    Figure("hajagos_10", (*_PIECES, "near"), ("crease:width=5",)),  # close-up
    Figure("hajagos_11", (*_PIECES, "king"), ("crease:width=4", "crease:width=10"), 2,
           crop=_MIDDLE),  # wider edges
    Figure("hajagos_12", (*_PIECES, "rook"), ("crease:width=10", "crease:width=2"), 2,
           crop=_MIDDLE),  # thinner edges
    Figure("hajagos_13", ("-m", "tests.figures.programs.head"),
           ("crease:width=3", "crease:width=3,fill=#ffffff"), 2, crop=_MIDDLE),  # a head
    Figure("hajagos_14", ("-m", "demo_apps.figure"), ("crease:width=3,fill=#ffffff",),
           frames=14),  # a raptor
)  # fmt: skip
