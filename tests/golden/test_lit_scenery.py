"""The tones of surfaces as programs light them, or do not (`lit_scenery`)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np
import pytest
from OpenGL import GL

from tests.golden import lit_scenery, restyled, scenery
from tests.golden.restyled import Picture


@pytest.fixture(scope="module", autouse=True)
def window() -> Iterator[None]:
    with restyled.window():
        yield


def shown(scene: Callable[[], None], style: str = "", frames: int = 1) -> Picture:
    return restyled.shown(partial(scenery.draw, scene), style, frames)


LEFT, RIGHT = (150, 110), (150, 290)


@pytest.mark.parametrize("style", ["cartoon", "technical:light=app"])
def test_what_looks_away_from_the_lamps_is_dark(style: str) -> None:
    """By the normal that the program sends: GL lights one side of a surface."""
    plain, found = shown(lit_scenery.sheets), shown(lit_scenery.sheets, style)
    assert plain[LEFT].sum() > 2 * plain[RIGHT].sum()
    assert found[LEFT].sum() > 1.25 * found[RIGHT].sum()


@pytest.mark.parametrize("style", ["cartoon", "technical:light=app"])
def test_where_both_sides_are_lit_so_are_they(style: str) -> None:
    found = shown(lit_scenery.sheets_of_two_sides, style)
    assert np.abs(found[LEFT] - found[RIGHT]).max() <= 1


@pytest.mark.parametrize("mode", lit_scenery.FOGS)
@pytest.mark.parametrize("style", ["cartoon", "technical", "fins:fill=cel"])
def test_fog_lies_over_light(mode: str, style: str) -> None:
    """As much of each surface is seen as in plain; on paper, the sky's fog is paper."""
    pictures = {
        (fog, how): shown(partial(lit_scenery.in_fog, fog), how).astype(float)
        for fog in (mode, None)
        for how in ("", style)
    }
    mist = 255 * np.array(lit_scenery.MIST)
    seen, paint = pictures[mode, ""] - mist, pictures[None, ""] - mist
    share = ((seen * paint).sum(axis=2) / np.maximum((paint * paint).sum(axis=2), 1.0))[..., None]
    behind = np.full(3, 255.0) if style == "technical" else mist
    wanted = share * pictures[None, style] + (1.0 - share) * behind
    ground = np.s_[5:225, 250:395]
    off = np.abs(pictures[mode, style] - wanted)[ground].max(axis=2)
    assert share[ground].min() < 0.05
    assert share[ground].max() > 0.3
    assert (off > 5).mean() < 0.01


@pytest.mark.parametrize("way", lit_scenery.FLOORS)
def test_a_chequered_floor_keeps_its_cheques(way: str) -> None:
    """However its diffuse colours come: within primitives, within lists, of one face or both."""
    floor = np.s_[5:120, 100:300]
    for style in ("cartoon", "technical"):
        found = shown(partial(lit_scenery.floor, way), style)[floor]
        plain = shown(partial(lit_scenery.floor, "drawn-tracked"), style)[floor]
        assert np.ptp(plain.reshape(-1, 3), axis=0).min() > 50
        assert np.abs(found - plain).max() <= (24 if way.startswith("list") else 2)


def test_what_shows_the_materials_of_lists_is_put_back() -> None:
    """Lamps from all sides for a moment: a program finds its own."""
    def lamps() -> list[float]:
        names = GL.GL_AMBIENT, GL.GL_DIFFUSE, GL.GL_SPECULAR, GL.GL_POSITION, GL.GL_SPOT_CUTOFF
        found = [GL.glGetLightfv(GL.GL_LIGHT0 + k, name) for k in range(8) for name in names]
        state = (GL.GL_LIGHT_MODEL_AMBIENT, GL.GL_MODELVIEW_MATRIX, GL.GL_MATRIX_MODE,
                 GL.GL_NORMALIZE, *(GL.GL_LIGHT0 + k for k in range(8)))  # fmt: skip
        found += [GL.glGetFloatv(name) for name in state]
        return np.concatenate([np.ravel(each) for each in found]).tolist()

    def scene() -> None:
        lit_scenery.floor("list-diffuse")
        seen.append(lamps())

    seen: list[list[float]] = []
    shown(scene)
    shown(scene, "cartoon")
    assert seen[0] == seen[1]


@pytest.mark.parametrize("style", ["cartoon", "technical", "poster"])
def test_colours_without_light_stay_as_they_are(style: str) -> None:
    plain, found = (shown(lit_scenery.without_light, each) for each in ("", style))
    for x in (105, 200, 295):
        face = np.s_[130:150, x - 10 : x + 10]
        seen, meant = found[face].mean(axis=(0, 1)), plain[face].mean(axis=(0, 1))
        assert (seen >= 0.8 * meant - 2).all()
        assert np.ptp(seen / seen.max() - meant / meant.max()) < 0.03


@pytest.mark.parametrize("style", ["cartoon", "technical"])
def test_colours_are_those_of_the_lamps(style: str) -> None:
    """Textures, too: a style's white light would turn yellow to white."""
    red, green, blue = shown(lit_scenery.under_a_yellow_lamp, style)[130, 200]
    assert abs(red - green) < 0.1 * red
    assert blue < 0.5 * red


def test_there_is_no_hatching_where_there_is_no_light() -> None:
    """Ink as even as the colours; what is lit beside it is hatched."""
    for style in ("pen_and_ink", "woodcut", "engraving"):
        found = shown(lit_scenery.without_light, style).sum(axis=2)
        faces = [found[130:150, x - 10 : x + 10] for x in (105, 200, 295)]
        assert max(np.ptp(face) for face in faces) < 60
        assert faces[0].mean() < faces[1].mean() - 60  # red is darker than yellow
        lit = shown(lit_scenery.sheets, style).sum(axis=2)[120:180, 260:320]
        assert np.ptp(lit) > 300


@pytest.mark.parametrize("style", ["technical", "sketch", "hiddenline"])
@pytest.mark.parametrize("lit", [True, False])
def test_white_glass_is_seen_on_white_paper(style: str, lit: bool) -> None:
    """By its outline: a ball beside all else."""
    found = shown(partial(lit_scenery.white_glass, lit), style).sum(axis=2)
    rim = found[150, 320:345]
    assert rim.min() < np.median(rim) - 150


def test_about_a_picture_there_is_paper() -> None:
    """In the first frame, too."""
    found, later = (
        shown(lit_scenery.on_a_picture_with_a_margin, "technical", frames) for frames in (1, 2)
    )
    assert np.abs(found - later).max() < 8
    assert found[:8].min() > 225
    assert np.abs(found[200, 60] - (40, 140, 60)).max() < 8


@pytest.mark.parametrize("style", ["cartoon", "technical"])
def test_what_lamps_make_white_together_is_white(style: str) -> None:
    """Not green, which both of them have."""
    plain, found = (shown(lit_scenery.between_lamps, each)[150, 200] for each in ("", style))
    assert np.ptp(plain) < 0.1 * plain.max()
    assert np.ptp(found) < 0.25 * found.max()


def test_text_on_a_panel_is_on_one_side_of_it() -> None:
    """White on a panel through which bright lines are seen: not black here and there."""
    panel = partial(lit_scenery.on_a_panel, (0.0, 0.75, 0.45, 0.5))
    found = shown(panel, "blueprint")[:, 45:195].sum(axis=2)
    ground = np.median(found[160:175])
    for row in (179, 194, 209, 224):
        line = max(found[row - 2 : row + 3], key=lambda some: np.abs(some - ground).mean())
        assert (line > ground).mean() > 0.99
