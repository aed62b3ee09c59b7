"""Categories of styles, by which galleries filter them."""

from __future__ import annotations

from glshim.styling.composite import Composite
from glshim.styling.protocol import Styler

CATEGORIES = {
    "lines": "lines over the program's own picture",
    "paint": "surfaces painted or lit anew",
    "paper": "a ground in place of the program's background",
    "effects": "fur, shadows",
}
"""All that stylers of ours have, with what each says."""
_PAINTS = ("paint", "colours", "cel", "lit", "wash")
"""Words of surfaces, fills and tones that repaint what the program drew."""


def categories_of(styler: Styler) -> tuple[str, ...]:
    """Those that a style declares, or what its paper and its surfaces say; none for the program's
    own picture."""
    if isinstance(styler, Composite):
        found = [each for part in styler.parts for each in categories_of(part)]
        return tuple(dict.fromkeys(found))
    if styler.categories or not styler.wants_polygons:
        return styler.categories
    paper = getattr(styler, "paper", None)
    looks = (styler.surface, getattr(styler, "fill", "app"), getattr(styler, "tone", "app"))
    paints = any(
        look in _PAINTS if isinstance(look, str) else look not in (None, paper) for look in looks
    )
    words = ("paint",) if paints else ()
    if isinstance(paper, tuple):
        words = (*words, "paper")
    return words or ("lines",)
