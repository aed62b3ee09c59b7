"""`python -m tests.golden.update`: draw the reference pictures anew. Look before you keep them."""

from __future__ import annotations

from glshim.running.headless import virtual_screen
from tests.golden.pictures import update

if __name__ == "__main__":
    with virtual_screen() as screen:
        for path in update(screen["DISPLAY"]):
            print(path)
