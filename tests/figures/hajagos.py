"""Figures 9 to 14 of B. Hajagos et al. 2012 (silhouettes and creases by geometry shaders), made
again of meshes of our own."""

from __future__ import annotations

from tests.figures.table import Figure

_PIECES = ("-m", "tests.figures.programs.pieces")
_MIDDLE = (120, 0, 520, 480)


def _lines(width: int) -> str:
    return f"crease:crease_width={width},silhouette_width={width}"


FIGURES = (
    Figure("hajagos_9", (*_PIECES, "crowd"), (_lines(2),)),  # many objects
    Figure("hajagos_10", (*_PIECES, "near"), (_lines(5),)),  # close-up
    Figure("hajagos_11", (*_PIECES, "king"), (_lines(4), _lines(10)), 2,
           crop=_MIDDLE),  # wider edges
    Figure("hajagos_12", (*_PIECES, "rook"), (_lines(10), _lines(2)), 2,
           crop=_MIDDLE),  # thinner edges
    Figure("hajagos_13", ("-m", "tests.figures.programs.head"),
           (_lines(3), _lines(3) + ",fill=#ffffff"), 2, crop=_MIDDLE),  # a head
    Figure("hajagos_14", ("-m", "demo_apps.08_figure"), (_lines(3) + ",fill=#ffffff",),
           frames=14),  # a raptor
)  # fmt: skip
