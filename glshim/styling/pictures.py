"""Pictures that strokes are drawn with, and the files that options name."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from glshim.errors import StyleError, shown
from glshim.system.modules import OURS_ALONE
from glshim.system.reading import require_regular

_MOST = 4096
"""Pixels a side that every driver takes; larger pictures are made smaller."""
_MOST_PIXELS = 64 << 20
"""Pixels of a file, at most."""
_FORMATS = ("PNG", "JPEG", "WEBP", "GIF", "BMP", "TIFF", "PPM", "TGA")
"""Those that Pillow reads by itself: for some others it runs programs."""
_COLOURLESS = 8
"""Difference between channels up to which a picture is grey."""


@dataclass(frozen=True, slots=True, eq=False)
class Image:
    """A picture that strokes are drawn with. Compared by identity: keep it."""

    pixels: NDArray[np.uint8]
    """(H, W, 4) red, green, blue, alpha (straight), the first row on top. Columns run along a
    stroke and repeat, rows across it, the last one inside a silhouette."""


def read_image(path: str) -> Image:
    """A picture file as `stroke_pixels`: the same `Image` again until the file changes.

    Raises `StyleError` when there is none, or Pillow cannot read it.
    """
    try:
        stamp = require_regular(path)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise StyleError(f"there is no picture '{shown(path, 300)}': {reason}") from error
    return _read(path, stamp.st_mtime_ns, stamp.st_size)


@lru_cache(maxsize=16)
def _read(path: str, _changed: int, _size: int) -> Image:
    try:
        with OURS_ALONE:  # Pillow loads its modules for files now
            return Image(stroke_pixels(_rgba(path)))
    except Exception as error:  # Pillow's decoders raise nearly anything
        reason = "no picture that Pillow knows" if _unknown(error) else " ".join(str(error).split())
        raise StyleError(f"cannot read {path!r} as a picture: {reason}") from error


def _rgba(path: str) -> NDArray[np.uint8]:
    """Pixels (H, W, 4), of a large picture fewer than it has."""
    from PIL import Image as Pillow

    with Pillow.open(path, formats=_FORMATS) as picture:
        if picture.width * picture.height > _MOST_PIXELS:
            raise ValueError(f"it has more than {_MOST_PIXELS >> 20} million pixels")
        shrink = max(1.0, max(picture.size) / _MOST)
        whole = picture.convert("RGBA")
        if shrink > 1.0:
            size = (max(int(side / shrink), 1) for side in picture.size)
            whole = whole.resize((next(size), next(size)))
        return np.asarray(whole)


def _unknown(error: Exception) -> bool:
    return type(error).__name__ == "UnidentifiedImageError"


def stroke_pixels(rgba: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """What a picture (H, W, 4) means as a stroke: of a grey one darkness is ink, in white, to be
    multiplied by a colour; one in colours keeps them, and its alpha is ink."""
    channels = rgba[..., :3].astype(np.int32)
    seen = rgba[..., 3] > 0
    spread = channels.max(axis=2) - channels.min(axis=2)
    if (spread[seen] > _COLOURLESS).any():
        return np.array(rgba)
    pixels = np.full(rgba.shape, 255, np.uint8)
    darkness = (255 - channels.mean(axis=2)) * rgba[..., 3] / 255.0
    pixels[..., 3] = np.rint(darkness).astype(np.uint8)
    return pixels


def is_coloured(image: Image) -> bool:
    """Whether an image that `read_image` gave has colours of its own."""
    return bool((image.pixels[..., :3] < 255).any())
