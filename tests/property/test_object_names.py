"""Names of objects: random programs that make, name, ask for and delete objects of every kind are
answered under a style as without it. More: ``python -m tests.property.object_names N [SEED]``."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from glshim.styling import registry
from tests import sweep

from .object_names import difference

MANY = 60 if sweep.FULL else 6
SEEDS = range(1000 * sweep.SEED, 1000 * sweep.SEED + MANY)
STYLES = ("raskar", *registry.names(), *registry.looks())


def style_of(seed: int) -> str:
    """Each seed another."""
    return ("none", "raskar")[seed % 2] if seed % 3 else STYLES[seed // 3 % len(STYLES)]


@pytest.mark.parametrize("seed", SEEDS)
def test_in_a_compatibility_profile(seed: int) -> None:
    assert difference(seed, style_of(seed)) is None


@pytest.mark.parametrize("seed", SEEDS[: MANY // 2])
def test_in_contexts_that_share(seed: int) -> None:
    assert difference(seed, "raskar" if seed % 2 else style_of(seed), windows=2) is None


@pytest.mark.parametrize("seed", SEEDS[: MANY // 3])
def test_in_core_profiles(seed: int) -> None:
    assert difference(seed, "raskar", core=True, windows=1 + seed % 2) is None


@pytest.mark.skipif(sys.platform != "linux", reason="Mesa alone can be told to give names again")
def test_with_a_driver_that_gives_the_least_name_that_is_free() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "tests.property.object_names", str(MANY), str(SEEDS[0])],
        env={**os.environ, "force_gl_names_reuse": "true"}, capture_output=True, text=True,
        timeout=600, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.startswith(f"{MANY} programs, no difference; names are given again")


def test_a_difference_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    from glshim.bindings.pyopengl import names

    monkeypatch.setattr(names.objects.Space, "given", lambda *_: [77] * 64)
    found = (difference(seed, "raskar") for seed in range(12))
    assert any(each is not None for each in found)
