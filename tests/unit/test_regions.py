"""Regions of colour, from what the app says to the marked edges between them."""

from functools import partial

import numpy as np
import pytest
from OpenGL import GL

from glshim.geometry.meshshaders.edge_mesh import MARKED, edge_mesh, features
from glshim.geometry.recovery.mesh import mesh
from glshim.geometry.recovery.meshes import Meshes
from glshim.model.batch import Wanted, join
from glshim.sources.fixed import immediate
from glshim.sources.fixed.current import colour
from glshim.sources.fixed.immediate import reversed_winding, scaled
from glshim.spec.attributes import BY_NAME, decode
from glshim.spec.constants import GL_QUADS as QUADS
from tests import look

assemble = partial(immediate.assemble, wanted=Wanted(colours=True))
assemble_many = partial(immediate.assemble_many, wanted=Wanted(colours=True))
RED, GREEN = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)


def said(name: str, *values: float) -> bytes:
    row = BY_NAME[name]
    return row.pack.pack(*values, row.tag)


def square(x: float, *, before: bytes = b"", between: bytes = b"") -> bytes:
    """A quad from x to x + 1, with something said before it and before its last corner."""
    corners = [(x, 0, 0), (x + 1, 0, 0), (x + 1, 1, 0), (x, 1, 0)]
    parts = [said("glVertex3f", *corner) for corner in corners]
    return before + b"".join(parts[:3]) + between + parts[3]


def test_a_polygon_has_the_colour_of_all_its_corners():
    red, green = said("glColor3f", *RED), said("glColor4f", *GREEN, 1.0)
    one = assemble(QUADS, square(0, before=red) + square(1) + square(2, before=green))
    first, second, third = one.regions
    assert first == second != third and first > 0 and third > 0
    assert assemble(QUADS, square(0, before=red, between=green)).regions.tolist() == [0]
    assert assemble(QUADS, square(0)).regions is None
    # Three components are opaque; a half transparent red is another colour.
    same = assemble(QUADS, square(0, before=said("glColor4f", *RED, 1.0)))
    assert same.regions[0] == first
    assert assemble(QUADS, square(0, before=said("glColor4f", *RED, 0.5))).regions[0] != first


def test_regions_go_along_with_their_polygons():
    red, green = said("glColor3f", *RED), said("glColor3f", *GREEN)
    streams = [(QUADS, square(0, before=red)), (QUADS, square(1, before=green)),
               (QUADS, square(2, before=red) + square(3, before=green))]  # fmt: skip
    many = assemble_many(streams)
    a, b, c, d = many.regions
    assert a == c != b == d
    for moved in (scaled(many, 2.0, None), reversed_winding(many), join([many, many])):
        assert moved.regions[:4].tolist() == [a, b, c, d]
    plain = look.cube()
    assert join([plain, many]).regions.tolist() == [0] * 6 + [a, b, c, d]


def test_marked_edges_lie_between_known_colours_that_differ():
    red, green = said("glColor3f", *RED), said("glColor3f", *GREEN)
    row = square(0) + square(1, before=red) + square(2) + square(3, before=green)
    found = mesh(assemble(QUADS, row))
    edges = edge_mesh(found)
    bits = features(edges.indices, found.positions, np.array((0, 0, 9.0, 1)), (2.0, 2.0))
    marked = edges.rows[(bits & MARKED) > 0]
    assert len(marked) == 1
    assert found.positions[found.edges[marked[0]]][:, 0].tolist() == [3.0, 3.0]


def test_a_mesh_in_other_colours_is_another_mesh():
    red, green = said("glColor3f", *RED), said("glColor3f", *GREEN)
    meshes = Meshes()
    one = meshes.find(assemble(QUADS, square(0, before=red) + square(1)))
    other = meshes.find(assemble(QUADS, square(0, before=red) + square(1, before=green)))
    assert not one.marked.any() and other.marked.sum() == 1


@pytest.mark.gl
@pytest.mark.parametrize("lit", [False, True])
@pytest.mark.parametrize("tracking", [False, True])
def test_the_colour_that_a_primitive_begins_with(lit, tracking):
    """The current colour, or the material's where lighting has no other."""
    with look.window(64, 64):
        GL.glColor4f(0.25, 0.5, 0.75, 1.0)
        GL.glMaterialfv(GL.GL_FRONT, GL.GL_DIFFUSE, (0.1, 0.2, 0.3, 0.4))
        (GL.glEnable if lit else GL.glDisable)(GL.GL_LIGHTING)
        if tracking:
            GL.glEnable(GL.GL_COLOR_MATERIAL)
        values = decode(colour())[1][0]
    wanted = (0.1, 0.2, 0.3, 0.4) if lit and not tracking else (0.25, 0.5, 0.75, 1.0)
    assert np.allclose(values, wanted)


def test_nobody_pays_who_did_not_ask():
    red, green = said("glColor3f", *RED), said("glColor3f", *GREEN)
    streams = [(QUADS, square(0, before=red)), (QUADS, square(1, before=green))]
    assert immediate.assemble_many(streams).regions is None
    assert not mesh(immediate.assemble(QUADS, streams[0][1] + streams[1][1])).marked.any()
