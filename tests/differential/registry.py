"""The scenes by name: each file of scenes adds its own."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from .world import App, Outcome, Scene, run

SCENES: dict[str, Scene] = {}


def scene(function: Scene) -> Scene:
    """Decorator: register a scene under its function's name."""
    return add(function.__name__, function)


def add(name: str, function: Scene) -> Scene:
    """Register a scene under a name."""
    assert name not in SCENES, name
    SCENES[name] = function
    return function


@cache
def plain(name: str) -> Outcome:
    """What a scene shows without glshim."""
    return run(SCENES[name])


def each(values: dict[str, object]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Decorator: one scene a value, which the function gets after the app."""

    def register(function: Callable[..., None]) -> Callable[..., None]:
        for name, value in values.items():

            def bound(app: App, value: object = value) -> None:
                function(app, value)

            add(f"{function.__name__}-{name}", bound)
        return function

    return register
