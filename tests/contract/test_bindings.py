"""What every binding gives, and that whoever hears it knows none in particular."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

import pytest

from glshim.bindings.base import Binding, PrimitiveStream, Watcher
from glshim.sources.following.follower import Follower

from .test_layers import ROOT, imports, is_below, sources

BINDINGS = sorted(path.parent.name for path in (ROOT / "glshim/bindings").glob("*/__init__.py"))


def of_binding(name: str) -> Binding:
    """The one object in a binding's own module that is one."""
    found = vars(import_module(f"glshim.bindings.{name}.binding"))
    (binding,) = (each for key, each in found.items() if key == name.upper())
    return binding  # type: ignore[no-any-return]


def members(protocol: type) -> set[str]:
    return {n for kind in protocol.__mro__[:-2] for n in vars(kind) if not n.startswith("_")}


def test_there_is_one() -> None:
    assert "pyopengl" in BINDINGS


@pytest.mark.parametrize("name", BINDINGS)
def test_a_binding_gives_all_that_it_should(name: str) -> None:
    binding = of_binding(name)
    assert [m for m in members(Binding) if not hasattr(binding, m)] == []
    assert [m for m in members(PrimitiveStream) if not hasattr(binding.stream, m)] == []


def test_the_follower_hears_all_that_bindings_tell() -> None:
    assert {"begin", "before", "after_shape"} <= members(Watcher)
    assert [m for m in members(Watcher) if not callable(getattr(Follower, m, None))] == []


def foreign(paths: list[Path], allowed: tuple[str, ...]) -> list[str]:
    return [
        f"{path.relative_to(ROOT)}: {module}"
        for path in paths
        for module in imports(path)
        if is_below(module, "glshim.bindings") and not any(is_below(module, a) for a in allowed)
    ]


def test_sources_know_no_binding() -> None:
    assert foreign(sources("glshim/sources"), ("glshim.bindings.base",)) == []


def test_the_composition_root_takes_bindings_whole() -> None:
    whole = tuple(f"glshim.bindings.{name}.binding" for name in BINDINGS)
    assert foreign([ROOT / "glshim" / "pipeline.py"], ("glshim.bindings.base", *whole)) == []
