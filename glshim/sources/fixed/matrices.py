"""The matrix that a call stands for, in numpy."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from glshim.driver.arguments import real_of
from glshim.model.arrays import Matrix
from glshim.model.transforms import (
    column_major,
    frustum,
    orthographic,
    rotation,
    scaling,
    translation,
)
from glshim.spec.matrices import MatrixCall, Operation

_FORMULAS: Mapping[Operation, Callable[..., Matrix]] = {
    Operation.IDENTITY: lambda: np.eye(4),
    Operation.TRANSLATE: translation,
    Operation.SCALE: scaling,
    Operation.ROTATE: rotation,
    Operation.ORTHO: orthographic,
    Operation.FRUSTUM: frustum,
    Operation.COLUMNS: column_major,
    Operation.ROWS: lambda values: column_major(values).T,
}


def matrix_of(call: MatrixCall, args: Sequence[Any]) -> Matrix:
    """(4, 4) of a call's arguments; sixteen numbers come as one sequence. Raises ArithmeticError,
    TypeError or ValueError where they make no matrix."""
    given = args if call.element and len(args) == 1 else [real_of(each) for each in args]
    if call.operation is Operation.FRUSTUM and min(given[4:]) <= 0.0:
        raise ValueError("a distance is not positive")
    with np.errstate(all="ignore"):  # an app may turn by nothing around nothing
        return _FORMULAS[call.operation](*given)
