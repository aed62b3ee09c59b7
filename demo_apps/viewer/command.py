"""The command line of the viewer."""

import argparse
import sys
import time
from collections.abc import Sequence

from PIL import ImageColor

from ..shapes import SHAPES
from .loading import Loading
from .models import FILES, ModelError, load
from .prepare import Ready, prepared
from .view import BACKGROUND, UPRIGHT, Colour
from .window import AT_ONCE, Window

DEFAULT = "gear"


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="viewer", description="Show a model; h lists the keys.")
    parser.add_argument("model", nargs="?", default=DEFAULT, metavar="MODEL",
                        help=f"a built-in shape ({', '.join(SHAPES)}; default: {DEFAULT}) or a "
                             f"file ({', '.join(FILES)})")
    parser.add_argument("--up", choices=tuple(UPRIGHT),
                        help="the model's axis that points up (default: z for STL, y for others)")
    parser.add_argument("--background", type=colour, default=BACKGROUND, metavar="COLOUR",
                        help="a colour name or #rrggbb")
    parser.add_argument("--wait", action="store_true",
                        help="open the window once the model is loaded, so that the first frame "
                             "shows it")
    asked = parser.parse_args(arguments)
    try:
        show(asked.model, wait=asked.wait, up=asked.up, background=asked.background)
    except ModelError as fault:
        print(f"viewer: {fault}", file=sys.stderr)
        return 2
    return 0


def colour(text: str) -> Colour:
    """A colour's name, #rgb or #rrggbb."""
    try:
        red, green, blue = ImageColor.getrgb(text)[:3]
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a colour: give a name, such as white, or #rrggbb") from None
    return red / 255, green / 255, blue / 255


def show(name: str, *, wait: bool, up: str | None = None,
         background: Colour = BACKGROUND) -> None:
    """Open a window and draw until it is closed. A small file is there at the first frame."""
    model: Ready | None = None
    loading: Loading | None = None
    if name in SHAPES:
        model = prepared(load(name))
    else:
        loading = Loading(name)
        model = first(loading, None if wait else AT_ONCE)
    try:
        window = Window(name, up, background)
    except ModelError:
        if loading is not None:
            loading.stop()
        raise
    if model is None:
        window.loading = loading
    else:
        window.show(name, model)
        if wait and window.coming is not None:
            window.send_all()
    window.run()


def first(loading: Loading, seconds: float | None) -> Ready | None:
    """The model, if it comes in so many seconds; None: however long it takes."""
    end = None if seconds is None else time.monotonic() + seconds
    while end is None or time.monotonic() < end:
        model = loading.poll(0.02)
        if model is not None:
            return model
    return None
