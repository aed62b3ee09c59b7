"""Rows of vectors: what the formulas say again and again."""

from __future__ import annotations

import numpy as np

from glshim.model.arrays import Doubles


def dot(u: Doubles, v: Doubles) -> Doubles:
    """(N,) products of rows (N, k)."""
    return np.asarray(np.einsum("ij,ij->i", u, v))


def unit(vectors: Doubles) -> Doubles:
    """(N, k) rows of length one; zero stays zero."""
    return np.asarray(vectors / np.maximum(np.sqrt(dot(vectors, vectors)), 1e-300)[:, None])


def cross(u: Doubles, v: Doubles) -> Doubles:
    """(N, 3) as numpy has it, without its checks."""
    out = np.empty_like(u)
    out[:, 0] = u[:, 1] * v[:, 2] - u[:, 2] * v[:, 1]
    out[:, 1] = u[:, 2] * v[:, 0] - u[:, 0] * v[:, 2]
    out[:, 2] = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    return out
