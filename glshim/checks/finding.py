"""What a check finds."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from glshim.styling.protocol import Styler


class Fault(Exception):
    """What is wrong with a styler; the cause, if any, is the exception that showed it."""

    def __init__(self, wrong: str, advice: str) -> None:
        super().__init__(wrong)
        self.advice = advice


@dataclass(frozen=True, slots=True)
class Check:
    """One thing that a styler keeps to."""

    title: str
    """What holds, in the words of the report."""
    run: Callable[[Styler], str | None]
    """Raises `Fault` where it does not; otherwise perhaps a figure for the report."""


@dataclass(frozen=True, slots=True)
class Finding:
    """How a check went."""

    title: str
    wrong: str = ""
    """What is wrong; empty where the check holds."""
    advice: str = ""
    """What to do about it."""
    figure: str = ""
    """What was measured."""

    def __str__(self) -> str:
        if not self.wrong:
            return f"ok    {self.title}{': ' if self.figure else ''}{self.figure}"
        return f"WRONG {self.title}: {self.wrong}\n      {self.advice}"


def finding(check: Check, styler: Styler) -> Finding:
    """Run a check; what it lets through is a finding, too."""
    try:
        figure = check.run(styler)
    except Fault as fault:
        return Finding(check.title, _line(fault), fault.advice)
    except Exception as error:  # somebody's styler may raise anything
        wrong = f"it raises {type(error).__name__}: {_line(error)}{where(error)}"
        return Finding(
            check.title, wrong, "fix the exception: a styler that raises is switched off"
        )
    return Finding(check.title, figure=figure or "")


def where(error: BaseException) -> str:
    """The innermost place of an exception's traceback outside glshim itself, or nothing."""
    import traceback
    from pathlib import Path

    here = str(Path(__file__).parent.parent)
    frames = [f for f in traceback.extract_tb(error.__traceback__) if here not in f.filename]
    return f" ({frames[-1].filename}:{frames[-1].lineno})" if frames else ""


def _line(error: BaseException) -> str:
    return " ".join(str(error).split())
