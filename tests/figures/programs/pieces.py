"""``pieces king``, ``rook``, ``knight``, ``near`` (the king's head) or ``crowd`` (a hundred
pieces): the chessmen of `demo_apps.06_chess` on white."""

import importlib
import sys
from itertools import cycle

from OpenGL import GL

from tests.figures.programs.stage import Vector, show

chess = importlib.import_module("demo_apps.06_chess")
VIEWS: dict[str, tuple[str, Vector, Vector, float]] = {  # what stands there, eye, target, field
    "king": ("k", (1.6, -4.6, 2.5), (0.0, 0.0, 0.86), 25.0),
    "rook": ("r", (1.2, -3.3, 2.3), (0.0, 0.0, 0.52), 25.0),
    "near": ("k", (1.3, -3.0, 2.6), (0.0, 0.0, 1.50), 14.0),
    "knight": ("n", (2.2, -3.6, 1.9), (0.0, 0.0, 0.56), 25.0),
    "crowd": ("", (6.5, -11.5, 9.5), (-0.2, -0.6, 0.1), 37.0),
}


def draw(kind: str, x: float = 0.0, y: float = 0.0, turn: float = 24.0) -> None:
    GL.glPushMatrix()
    GL.glTranslatef(x, y, 0.0)
    GL.glRotatef(turn, 0.0, 0.0, 1.0)
    chess.PIECES[kind]()
    GL.glPopMatrix()


def draw_crowd() -> None:
    """Ten by ten, kinds and turns mixed."""
    kinds = cycle("pkrnbqrpbnk")
    for row in range(10):
        for column in range(10):
            chess.material(chess.IVORY if (row + column // 2) % 2 else chess.EBONY)
            kind = next(kinds)
            draw(kind, 0.95 * (column - 4.5), 0.95 * (row - 4.5), 37.0 * (row + 3 * column))


def main() -> None:
    what = sys.argv[1]
    kind, eye, target, field = VIEWS[what]

    def draw_it() -> None:
        chess.material(chess.IVORY)
        draw_crowd() if what == "crowd" else draw(kind)

    show(draw_it, eye, target, field)


if __name__ == "__main__":
    main()
