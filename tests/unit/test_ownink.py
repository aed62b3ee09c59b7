"""Text and lines of programs whose frame ends nobody knows."""

from __future__ import annotations

from glshim.sources.following.ownink import OwnInk, Run


def waiting(own: OwnInk) -> OwnInk:
    own.run = Run(0, held=False, tested=False)
    return own


def test_what_is_cleared_before_any_picture_was_shown_is_lost() -> None:
    own = waiting(OwnInk())
    own.cleared(colour=False)
    assert not own.lost
    own.cleared(colour=True)
    assert own.lost
    own.shown()
    assert not own.lost


def test_once_a_picture_was_shown_a_clear_loses_nothing() -> None:
    own = OwnInk()
    own.shown()
    waiting(own).cleared(colour=True)
    assert not own.lost


def test_without_ink_a_clear_loses_nothing() -> None:
    own = OwnInk()
    own.cleared(colour=True)
    assert not own.lost
