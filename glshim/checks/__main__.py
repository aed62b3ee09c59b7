"""``python -m glshim.checks STYLE``: the report, in a process of its own, since a shader can take
its driver, and so its process, down."""

from __future__ import annotations

import sys

from glshim.checks import values, window
from glshim.checks.finding import Finding, finding
from glshim.errors import EnvironmentFault, GlshimError
from glshim.notices import say
from glshim.styling import texts
from glshim.styling.composite import Composite


def main(text: str) -> int:
    """Print a line a check; 0 where all hold."""
    try:
        styler = texts.parse_style(text)
    except GlshimError as error:
        advice = "fix this; the remaining checks were skipped"
        print(Finding("it can be loaded", str(error), advice))
        return 1
    if isinstance(styler, Composite):
        print(Finding("it can be loaded", f"{text} is several styles", "check each by itself"))
        return 1
    print(Finding("it can be loaded", figure=f"style {styler.name}"))
    wrong = 0
    for check in values.CHECKS:
        wrong += _report(finding(check, styler))
    if wrong:
        print("fix these; the checks in a window were skipped")
        return 1
    try:
        with window.window():
            pass
    except EnvironmentFault as error:
        say(str(error))
        return 2
    for check in window.CHECKS:
        wrong += _report(finding(check, styler))
    return 1 if wrong else 0


def _report(found: Finding) -> int:
    print(found, flush=True)
    return 1 if found.wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
