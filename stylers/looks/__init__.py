"""Looks: style files that come with glshim, and are asked for by their bare names.

Those of McGuire & Hughes 2004, figures 1 and 7, and others over the other styles.
"""

from functools import cache
from pathlib import Path


@cache
def looks() -> dict[str, Path]:
    """The style files by name, sorted."""
    return {path.stem: path for path in sorted(Path(__file__).parent.glob("*.toml"))}
