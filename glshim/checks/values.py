"""Checks of stylers as values, without a window: options, draws, purity."""

from __future__ import annotations

import dataclasses
import pickle
import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np

from glshim.checks import layers
from glshim.checks.finding import Check, Fault
from glshim.errors import StyleError
from glshim.model.batch import PolygonBatch
from glshim.styling.fromfile import shortcoming
from glshim.styling.lines import Shader
from glshim.styling.options import Option, options_of
from glshim.styling.passes import MeshShader, shown_needs
from glshim.styling.pictures import Image
from glshim.styling.protocol import SURFACES, BackFaces, Layer, Lines, Pass, Styler

_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_UNIFORM = re.compile(r"\buniform\s+(?:(?:lowp|mediump|highp)\s+)?(\w+)\s+([^;]+);")
_NAME = re.compile(r"\w+")
_GIVEN = ("ridge_turn", "valley_turn")
"""Uniforms that `Lines` give the shaders of their media."""
_PRELUDES = ("depth", "line", "window", "mesh", "edges")


def _is_a_styler(styler: Styler) -> None:
    make = type(styler)
    wrong = shortcoming(make)
    if wrong:
        raise Fault(wrong, "see docs/guide/writing_a_styler.md")
    try:
        styler.glshim_check = 1  # type: ignore[attr-defined]
    except dataclasses.FrozenInstanceError:
        pass
    else:
        raise Fault("it can be changed", "write @dataclass(frozen=True)")
    if not (make() == make() and hash(make()) == hash(make())):
        raise Fault("two of the same options are not equal", "leave __eq__ and __hash__ alone")
    if pickle.loads(pickle.dumps(styler)) != styler:
        raise Fault("a pickled copy is not equal to it", "keep everything in options")


def _options_are_described(styler: Styler) -> None:
    make = type(styler)
    for option in options_of(make):
        if not option.help.strip():
            raise Fault(f"option {option.name} has no help", "describe it: help=...")
        if option.kind in ("number", "integer") and (option.low is None or option.high is None):
            raise Fault(f"option {option.name} has no range", "give it low=... and high=...")
        for value in (option.default, getattr(styler, option.name)):
            _reads_back(option, value)
        if option.kind in ("number", "integer"):
            for edge in (option.low, option.high):
                _take(styler, option, edge)
            for beyond in (option.low - 1.0, option.high + 1.0, float("nan")):  # type: ignore[operator]
                _refuse(make, option, beyond)
        elif option.kind == "switch":
            _refuse(make, option, "perhaps")
        else:
            _refuse(make, option, "#no such word")


def _reads_back(option: Option, value: Any) -> None:
    again = option.parse(option.show(value))
    same = again == value
    if isinstance(value, tuple):  # a colour, as #rrggbb
        same = bool(np.allclose(again, value, rtol=0.0, atol=0.5 / 255))
    elif isinstance(value, float):
        same = bool(np.isclose(again, value, rtol=1e-5, atol=0.0))
    if not same:
        raise Fault(
            f"{option.name}={option.show(value)} is read back as {again!r}, not {value!r}",
            "leave values as option() stores them: do not change them in __post_init__",
        )


def _take(styler: Styler, option: Option, value: Any) -> Styler:
    changed = replace(styler, **{option.name: value})
    if getattr(changed, option.name) != value:
        raise Fault(
            f"{option.name}={value} becomes {getattr(changed, option.name)!r}",
            "leave values as option() stores them: do not change them in __post_init__",
        )
    return changed


def _refuse(make: type[Styler], option: Option, value: Any) -> None:
    try:
        make(**{option.name: value})
    except StyleError:
        return
    raise Fault(
        f"{option.name}={value} is taken, although only {option.allowed} is allowed",
        "call super().__post_init__() where you have one of your own",
    )


def _draws_are_plain(styler: Styler) -> None:
    surface = styler.surface
    if not (surface in SURFACES or (isinstance(surface, tuple) and len(surface) == 3)):
        raise Fault(f"its surface is {surface!r}", f"give {', '.join(SURFACES)} or a colour")
    drawn = draws_of(styler, layers.usual())
    if not styler.wants_polygons and drawn:
        raise Fault("it draws, although it wants no polygons", "leave wants_polygons as it is")


def _draws_are_pure(styler: Styler) -> None:
    layer, other = layers.usual(), layers.odd()["an open surface"]
    first = draws_of(styler, layer)
    draws_of(styler, other)
    again, copy = draws_of(styler, layer), draws_of(replace(styler), layer)
    if not (_same(first, again) and _same(first, copy)):
        triples = zip(first, again, copy, strict=False)
        same = [_same(one, second) and _same(one, third) for one, second, third in triples]
        which = f"number {same.index(False) + 1}" if False in same else "their count"
        raise Fault(
            f"the same layer gave other draws a second time ({which} of {len(first)})",
            "use nothing but the layer and the options: no counters, no clock, no random numbers "
            "without a seed, and keep one Image",
        )


def _same(one: Any, other: Any) -> bool:
    """Equal in what a draw depends on: cameras by their content, for a styler may make its own;
    batches and images by identity, by which what was made of them is found again."""
    if one is other:
        return True
    if type(one) is not type(other) or isinstance(one, (PolygonBatch, Image)):
        return False
    if isinstance(one, np.ndarray):
        return np.array_equal(one, other, equal_nan=one.dtype.kind == "f")
    if isinstance(one, Mapping):
        return one.keys() == other.keys() and all(_same(one[key], other[key]) for key in one)
    if isinstance(one, (list, tuple)):
        return len(one) == len(other) and all(map(_same, one, other))
    if dataclasses.is_dataclass(one):
        names = (field.name for field in dataclasses.fields(one))
        return all(_same(getattr(one, name), getattr(other, name)) for name in names)
    return bool(one == other)


def _the_layer_stays(styler: Styler) -> None:
    layer = layers.usual()
    before = [_arrays(part) for part in layer.items]
    draws_of(styler, layer)
    for part, copies in zip(layer.items, before, strict=True):
        for name, array in _arrays(part).items():
            if not np.array_equal(array, copies[name], equal_nan=array.dtype.kind == "f"):
                raise Fault(f"it changes the layer's {name}", "work on a copy: numpy.array(...)")


def _arrays(part: tuple[Any, Any]) -> dict[str, np.ndarray[Any, Any]]:
    return {
        f"{type(owner).__name__}.{name}": np.array(value)
        for owner in part
        for name in type(owner).__slots__
        if isinstance(value := getattr(owner, name), np.ndarray)
    }


def _odd_layers(styler: Styler) -> str:
    odd = layers.odd()
    for what, layer in odd.items():
        try:
            draws_of(styler, layer)
        except Fault as fault:
            raise Fault(f"{what}: {fault}", fault.advice) from fault
        except Exception as error:
            raise Fault(
                f"{what} makes it raise {type(error).__name__}: {error}",
                "programs send such data: skip what cannot be drawn",
            ) from error
    return f"{len(odd)} kinds"


def _every_option(styler: Styler) -> str:
    tried = variants(styler)
    for text, variant in tried:
        try:
            draws_of(variant, layers.usual())
        except Fault as fault:
            raise Fault(f"with {text} {fault}", fault.advice) from fault
        except Exception as error:
            raise Fault(
                f"with {text} it raises {type(error).__name__}: {error}",
                "refuse in __post_init__ (StyleError) what cannot be drawn, or draw it",
            ) from error
    return f"{len(tried)} settings"


def _uniforms_match(styler: Styler) -> None:
    """Of the shader texts themselves: drivers drop uniforms that come to nothing."""
    shaders = files("glshim.outputs.gl") / "shaders"
    preludes = ((shaders / f"{name}.glsl").read_text("utf-8") for name in _PRELUDES)
    reserved = {name for text in preludes for name in _declared(text)}
    tried = [
        (f" (with {text})" if text else "", draw, _own(draw))
        for text, variant in [("", styler), *variants(styler)]
        for draw in draws_of(variant, layers.usual())
        if isinstance(draw, (Lines, Pass))
    ]
    # Several shaders may be given the same uniforms, although not each has them all.
    shared = {name for _, _, declared in tried for name in declared}
    for when, draw, declared in tried:
        _uniforms_of(draw, declared, shared, reserved, when)


def _own(draw: Lines | Pass, *, all_stages: bool = True) -> dict[str, str]:
    """The uniforms that the shader of a draw declares in its own texts: types by name."""
    shader = shader_of(draw)
    texts = [shader.vertex, getattr(shader, "geometry", "")]
    if all_stages:
        texts.append(shader.fragment)
    return {name: kind for text in texts for name, kind in _declared(text).items()}


def _used(draw: Lines | Pass) -> set[str]:
    """The words that stand more than once in a text of the shader: declared, and used."""
    shader = shader_of(draw)
    texts = (shader.vertex, getattr(shader, "geometry", ""), shader.fragment)
    return {word for text in texts for word in _repeated(text)}


@cache
def _repeated(text: str) -> frozenset[str]:
    """The words that stand more than once in a text."""
    counted = Counter(_NAME.findall(_COMMENT.sub(" ", text)))
    return frozenset(word for word, count in counted.items() if count > 1)


def _uniforms_of(
    draw: Lines | Pass, declared: Mapping[str, str], shared: set[str], reserved: set[str], when: str
) -> None:
    what = f"shader {shader_of(draw).name!r}"
    uniforms = _uniforms(draw)
    for name in uniforms:
        if name in reserved:
            raise Fault(
                f"{what} is given a uniform {name!r}{when}, which is glshim's own",
                "call yours something else",
            )
        if name not in shared:
            raise Fault(
                f"{what} is given a uniform {name!r}{when} that it does not have",
                f"declare it, or leave it out: it declares {', '.join(declared) or 'none'}",
            )
    if isinstance(draw, Pass):
        for name in sorted(shown_needs(draw.shader) - frozenset(draw.shader.needs or ())):
            raise Fault(
                f"{what} reads {name}, which its needs do not name",
                f'add it: MeshShader(..., needs={{"{name}", ...}})',
            )
    colours = not isinstance(draw, Pass) or draw.state.writes_colour
    used = _used(draw)
    for name, kind in _own(draw, all_stages=colours).items():
        given = name in uniforms or name in reserved or name in _GIVEN or "ampler" in kind
        if name in used and not given:
            raise Fault(
                f"{what} declares a uniform {name!r}{when} that no draw sets",
                "give it in uniforms: what is not set may be anything",
            )


@cache
def _declared(text: str) -> Mapping[str, str]:
    """The uniforms of a GLSL text: types by name."""
    found: dict[str, str] = {}
    for kind, names in _UNIFORM.findall(_COMMENT.sub(" ", text)):
        for name in names.split(","):
            word = _NAME.search(name)
            if word:
                found[word[0]] = kind
    return found


def draws_of(styler: Styler, layer: Layer) -> list[Any]:
    """What a styler draws, looked through: plain values all. Raises `Fault`."""
    drawn = styler.draws(layer)
    try:
        found = list(drawn)
    except TypeError as error:
        if drawn is not None and hasattr(drawn, "__iter__"):
            raise
        raise Fault(f"draws() gives {drawn!r}", "yield draws, or return a list of them") from error
    for one in found:
        if not isinstance(one, (Lines, Pass, BackFaces)):
            raise Fault(f"it draws {one!r}", "give Lines, Pass and BackFaces alone")
        for name, value in _uniforms(one).items():
            try:
                finite = bool(np.isfinite(np.asarray(value, float)).all())
            except (TypeError, ValueError):
                finite = False
            if not finite:
                raise Fault(
                    f"uniform {name} is {value!r}", "give numbers, or tuples of them: finite ones"
                )
    return found


def shader_of(draw: Lines | Pass) -> Shader | MeshShader:
    """What lines or elements are drawn with."""
    return draw.shader if isinstance(draw, Pass) else draw.medium.shader


def _uniforms(one: Lines | Pass | BackFaces) -> Mapping[str, Any]:
    if isinstance(one, BackFaces):
        return {}
    uniforms = one.uniforms if isinstance(one, Pass) else one.medium.uniforms
    if not isinstance(uniforms, Mapping):
        raise Fault(f"its uniforms are {uniforms!r}", "give a dict of values by name")
    return uniforms


def variants(styler: Styler) -> list[tuple[str, Styler]]:
    """The styler with one option after the other set to what it is not, as texts and values."""
    found = []
    for option in options_of(type(styler)):
        now = getattr(styler, option.name)
        values: tuple[Any, ...]
        if option.kind == "switch":
            values = (not now,)
        elif option.kind in ("number", "integer"):
            values = (option.low, option.high)
        else:
            values = option.choices + (((0.2, 0.4, 0.6),) if "colour" in option.kind else ())
        if option.follows:  # the same code as for what it follows, which takes them all
            values = values[-1:]
        for value in values:
            if value is not None and value != now:
                text = f"{option.name}={option.show(value)}"
                found.append((text, _take(styler, option, value)))
    return found


CHECKS = (
    Check("it is a frozen dataclass with a name and a method draws", _is_a_styler),
    Check("options have help and a range, and are read back as they are shown",
          _options_are_described),
    Check("draws are plain values", _draws_are_plain),
    Check("equal layers give equal draws", _draws_are_pure),
    Check("the layer is left as it was", _the_layer_stays),
    Check("odd layers are drawn", _odd_layers),
    Check("every setting is drawn", _every_option),
    Check("uniforms are those that the shaders declare", _uniforms_match),
)  # fmt: skip
