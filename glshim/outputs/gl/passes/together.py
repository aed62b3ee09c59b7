"""How the bodies of a pass touch each other, found again while they stand as they stood."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite

import numpy as np

from glshim.linework.feature_lines import EdgeLines
from glshim.linework.objects import Objects
from glshim.linework.touching import Touching, touching
from glshim.model.arrays import Doubles
from glshim.styling.passes import Pass
from glshim.styling.values import Body

_STILL = 1e-6
"""Relative change of matrices that rounding makes when only the viewer moves."""


class Together:
    """Of the passes that were drawn last."""

    def __init__(self, objects: Objects) -> None:
        self._objects = objects
        self._lines: list[EdgeLines] = []
        self._places: Doubles = np.zeros((0, 4, 4))
        self._found: list[Touching] = []

    def find(self, one: Pass) -> Mapping[int, Touching]:
        """By id of the body, of a pass of several bodies under one lens."""
        bodies = [body for body in one.bodies if _sound(body)]
        if len(bodies) < 2 or len({body.camera.affine().lens for body in bodies}) > 1:
            return {}
        tolerance = one.weld.tolerance
        lines = [self._objects.lines(body.batches, tolerance) for body in bodies]
        modelviews = [body.camera.affine().modelview for body in bodies]
        try:
            places: Doubles = np.asarray(
                np.linalg.inv(modelviews[0]) @ np.stack(modelviews), np.float64
            )
        except np.linalg.LinAlgError:
            return {}
        same = len(lines) == len(self._lines) and all(map(_is, lines, self._lines))
        if not same or not _alike(places, self._places):
            self._found = touching(list(zip(lines, modelviews, strict=True)))
            self._lines, self._places = lines, places
        return {id(body): found for body, found in zip(bodies, self._found, strict=True)}


def _sound(body: Body) -> bool:
    return all(map(isfinite, body.camera.affine().modelview.ravel().tolist()))


def _is(one: EdgeLines, other: EdgeLines) -> bool:
    return one is other


def _alike(one: Doubles, other: Doubles) -> bool:
    return bool(np.abs(one - other).max() <= _STILL * max(np.abs(one).max(), 1.0))
