"""Names for the arrays of numbers that the rooms hand on: one name a type, everywhere."""

from __future__ import annotations

import numpy as np
import numpy.ma  # `np.unique` asks for it: loaded with us, not in a frame
from numpy.typing import NDArray

Floats = NDArray[np.float32]
"""What programs send and what the GPU gets."""
Doubles = NDArray[np.float64]
"""What formulas compute with."""
Matrix = NDArray[np.float64]
"""(4, 4), acting on column vectors."""
Complexes = NDArray[np.complex128]
"""Points or directions in the window, x + iy, pixels."""
Indices = NDArray[np.int32]
"""Numbers of vertices, polygons, triangles or halfedges, as index buffers hold them."""
Rows = NDArray[np.intp]
"""Rows of another array, as numpy finds them."""
Flags = NDArray[np.bool_]
Keys = NDArray[np.uint64]
"""What is sorted or compared in place of something longer."""



def within(counts: NDArray[np.integer]) -> Rows:
    """(sum of counts,) 0, 1, 2 ... of each of several runs that are so long."""
    begins = np.cumsum(counts) - counts
    return np.asarray(np.arange(int(counts.sum())) - np.repeat(begins, counts), np.intp)


# numpy's C code looks for modules of numpy's the first time that it needs them. Now they are to be
# found, whatever the program has under that name later (`glshim.system.modules`).
np.zeros((1, 1)).max(axis=1).any()
