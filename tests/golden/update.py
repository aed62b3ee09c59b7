"""`python -m tests.golden.update`: draw the reference pictures anew. Look before you keep them."""

from __future__ import annotations

from tests.golden.pictures import update
from tests.programs.screen import virtual_screen

if __name__ == "__main__":
    with virtual_screen() as display:
        for path in update(display):
            print(path)
