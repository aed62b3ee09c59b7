"""What was seen of a program: a file of JSON, whole at any time."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field
from typing import Any

VARIABLE = "GLSHIM_REPORT"
"""Set by `glshim doctor` for the program that it starts: the folder that findings go to, a file a
process."""
BEGIN = b'{"glshim": '
"""How the files begin."""


@dataclass(slots=True)
class Findings:
    """Counts since the program began."""

    opengl: str = ""
    """Version and renderer of the first context."""
    frame_ends: dict[str, int] = field(default_factory=dict)
    """By toolkit, or by what ended them."""
    calls: dict[str, dict[str, int]] = field(default_factory=dict)
    """By role, in words, and by name."""
    polygons: dict[str, int] = field(default_factory=dict)
    """With lines, by path."""
    carried: int = 0
    """Draws whose polygons carry lines."""
    passed: dict[str, int] = field(default_factory=dict)
    """Draws of polygons that carry none, by why."""
    others: int = 0
    """Draws of lines, points and pixels."""
    refused: list[str] = field(default_factory=list)
    """Why nothing can be styled in some contexts."""
    added: int = 0
    """Draws of the style's."""
    why: str = ""
    """Why no line is drawn, if none is, and what to do."""

    def text(self) -> str:
        """As JSON."""
        return json.dumps({"glshim": 1, **asdict(self)})

    @classmethod
    def of_text(cls, text: str) -> Findings:
        """From JSON. Raises ValueError."""
        values: dict[str, Any] = json.loads(text)
        values.pop("glshim")
        return cls(**values)

    @property
    def frames(self) -> int:
        """Frame ends, of all kinds."""
        return sum(self.frame_ends.values())
