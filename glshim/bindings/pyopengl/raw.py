"""Hooks on PyOpenGL's raw layer, where from-imports, aliases and late installation all end up.

Every raw GL function is an instance of its own subclass of ``_NullFunctionPointer`` whose ``load``
puts the ctypes call on the class. We follow ``load`` and put a hook in its place, so the object
that apps hold stays the same. Wrappers (``glVertex3fv``) and lazy wrappers (``glBegin``) are
classes of their own too. GLU, GLUT and GLE functions are plain ctypes objects: their ``__class__``
is swapped for a subclass that calls the hook.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from threading import RLock
from typing import Any

from glshim.bindings.imports import after_import

Call = Callable[..., Any]
Maker = Callable[[Call], Call]
"""Given the original call, makes the hook. Wrapper makers get and give calls with ``self``."""
Matcher = Callable[[str], Maker | None]
"""Gives the maker of a name, None for names that it leaves alone."""


def _nothing(name: str) -> Maker | None:
    return None


class _Slot:
    """One class of PyOpenGL's that carries a call for a GL name."""

    __slots__ = ("cls", "found", "hooked", "now", "original", "over", "static")

    def __init__(self, cls: type, original: Call, *, static: bool) -> None:
        self.cls = cls
        self.found = vars(cls).get("__call__")
        self.original = original
        self.static = static
        self.over: Maker | None = None
        """What stands around the hook, or around the original where there is none."""
        self.hooked: dict[int, tuple[Maker, Call]] = {}
        self.now: Maker | None = None

    def _set(self, call: Any) -> None:
        type.__setattr__(self.cls, "__call__", call)

    def sink(self, maker: Maker) -> None:
        """Have the maker's hook below what is carried, and below all that will be."""
        self.original, self.found = maker(self.original), None
        self.hooked.clear()
        self.put(self.now)

    def put(self, maker: Maker | None) -> None:
        """Carry the maker's hook, or the original again."""
        self.now = maker
        if maker is None and self.over is None:
            if self.static:
                self._set(self.found or staticmethod(self.original))
            elif "__call__" in vars(self.cls):
                del self.cls.__call__
            return
        hook = self.original if maker is None else self._made(maker, self.original)
        if self.over is not None:
            hook = self.over(hook)
        self._set(staticmethod(hook) if self.static else hook)

    def _made(self, maker: Maker, original: Call) -> Call:
        if id(maker) not in self.hooked:
            self.hooked[id(maker)] = (maker, maker(original))
        return self.hooked[id(maker)][1]


class _StandIn:
    """Of a function pointer of PyOpenGL's that is loading: takes what that puts on the class of the
    pointer. So another thread that calls it finds it unloaded, or hooked, but nothing between."""

    def __init__(self, pointer: Any) -> None:
        self._pointer, self._class = pointer, type("Loaded", (), {})

    @property  # type: ignore[misc]
    def __class__(self) -> type:
        return self._class

    def __getattr__(self, name: str) -> Any:
        return getattr(self._pointer, name)


class RawLayer:
    """Which hook each GL name carries now. One instance: :data:`RAW`."""

    def __init__(self) -> None:
        self._raw: dict[str, list[_Slot]] = {}
        self._wrappers: dict[str, list[_Slot]] = {}
        self._raw_makers: dict[str, Maker] = {}
        self._wrapper_makers: dict[str, Maker] = {}
        self.matchers: list[Matcher] = []
        self._undo: list[Callable[[], None]] = []
        self._installed = False
        self._below: list[Matcher] = []
        self._sunk: set[tuple[type, int]] = set()
        """What is below already, by class: it outlives an installation."""
        self._over: Matcher = _nothing
        self._loading = RLock()

    @property
    def installed(self) -> bool:
        """Whether calls may be hooked: :meth:`hook_over` needs no more than itself."""
        return self._installed

    def install(self) -> None:
        """Follow PyOpenGL: what it has loaded already and what it will load."""
        self._installed = True
        self._follow()

    def _follow(self) -> None:
        if self._undo:
            return
        from OpenGL.platform import baseplatform

        pointer = baseplatform._NullFunctionPointer
        load = pointer.load

        def follow(this: Any) -> Any:
            cls = type(this)
            with self._loading:
                if "__call__" in vars(cls):  # meanwhile, in another thread
                    return vars(cls)["__call__"].__func__
                stand_in = _StandIn(this)
                loaded = load(stand_in)
                call = vars(stand_in.__class__).get("__call__")
                if loaded is not None and call is not None:
                    self._adopt(cls, call)
                    this.resolved = True
            return loaded

        pointer.load = follow
        self._undo.append(lambda: setattr(pointer, "load", load))
        for cls in _subclasses(pointer):
            if "__call__" in vars(cls) and cls is not baseplatform._DeprecatedFunctionPointer:
                self._adopt(cls, vars(cls)["__call__"])
        # Not imported here: at start-up PyOpenGL is in the middle of its own imports.
        after_import("OpenGL.wrapper", lambda module: self._follow_wrappers(module.Wrapper))
        after_import(
            "OpenGL.lazywrapper", lambda module: self._follow_wrappers(module._LazyWrapper)
        )

    def hook_over(self, matcher: Matcher | None) -> None:
        """Stand around calls and their hooks, whoever else hooks them or not; None: no more.
        matcher: what makes, of a call of that name, the one around it, if there is one."""
        self._over = matcher or _nothing
        if matcher is not None:
            self._follow()
        for name, slots in self._raw.items():
            over = self._over(name)
            for slot in slots:
                if over is not None or slot.over is not None:  # others' hooks stay where they are
                    slot.over = over
                    slot.put(self._raw_makers.get(name))
        self._leave()

    def hook_below(self, matcher: Matcher) -> None:
        """Change calls below every hook, now and when they load, and for good. matcher: what makes
        the hook of a name, if it has one."""
        self._below.append(matcher)
        for slots in self._raw.values():
            for slot in slots:
                self._sink(slot, matcher)

    def _sink(self, slot: _Slot, matcher: Matcher) -> None:
        maker = matcher(slot.cls.__name__)
        place = slot.cls, id(matcher)
        if maker is not None and place not in self._sunk:
            self._sunk.add(place)
            slot.sink(maker)

    def _follow_wrappers(self, base: Any) -> None:
        if not self._undo:  # uninstalled before the import came
            return

        def follow(cls: Any, /, **named: Any) -> None:
            super(base, cls).__init_subclass__(**named)
            self._adopt_wrapper(cls, base.__call__)

        base.__init_subclass__ = classmethod(follow)
        self._undo.append(lambda: delattr(base, "__init_subclass__"))
        for cls in _subclasses(base):
            self._adopt_wrapper(cls, base.__call__)

    def _adopt(self, cls: type, call: Any) -> None:
        """A function of GL's, which `call` makes, is loaded."""
        slot = _Slot(cls, call.__func__ if isinstance(call, staticmethod) else call, static=True)
        slot.found = call
        for matcher in self._below:
            self._sink(slot, matcher)
        slot.over = self._over(cls.__name__)
        self._raw.setdefault(cls.__name__, []).append(slot)
        slot.put(self._raw_maker(cls.__name__))

    def _adopt_wrapper(self, cls: type, original: Call) -> None:
        slot = _Slot(cls, original, static=False)
        self._wrappers.setdefault(cls.__name__, []).append(slot)
        maker = self._wrapper_makers.get(cls.__name__)
        if maker is not None:
            slot.put(maker)

    def _raw_maker(self, name: str) -> Maker | None:
        maker = self._raw_makers.get(name)
        if maker is None:
            for matcher in self.matchers:
                maker = matcher(name)
                if maker is not None:
                    self._raw_makers[name] = maker
                    break
        return maker

    def original(self, name: str) -> Call | None:
        """PyOpenGL's own raw call of that name, past any hook; None when it has not loaded it."""
        slots = self._raw.get(name)
        return slots[0].original if slots else None

    def hook(self, name: str, maker: Maker | None) -> None:
        """Hook every raw object of that name, now and when it loads; None unhooks."""
        if maker is None:
            self._raw_makers.pop(name, None)
        else:
            self._raw_makers[name] = maker
        for slot in self._raw.get(name, ()):
            slot.put(maker)

    def hook_wrapper(self, name: str, maker: Maker | None) -> None:
        """Hook PyOpenGL's Python wrapper of that name (array conversion, glBegin's bookkeeping)."""
        if maker is None:
            self._wrapper_makers.pop(name, None)
        else:
            self._wrapper_makers[name] = maker
        for slot in self._wrappers.get(name, ()):
            slot.put(maker)

    def hook_matching(self, matcher: Matcher) -> None:
        """Hook every name for which the matcher gives a maker, now and when it loads."""
        self.matchers.append(matcher)
        for name in list(self._raw):
            if name not in self._raw_makers:
                maker = matcher(name)
                if maker is not None:
                    self.hook(name, maker)

    def unhook_matching(self, matcher: Matcher) -> None:
        """Undo :meth:`hook_matching`."""
        self.matchers.remove(matcher)
        for name in list(self._raw_makers):
            if matcher(name) is self._raw_makers[name]:
                self.hook(name, None)

    def uninstall(self) -> None:
        """Leave PyOpenGL as it was found, but for what `hook_over` put around its calls, and
        `hook_below` below them."""
        self._raw_makers.clear()
        self._wrapper_makers.clear()
        self.matchers.clear()
        for slots in (*self._raw.values(), *self._wrappers.values()):
            for slot in slots:
                if slot.hooked:
                    slot.put(None)
        self._installed = False
        self._leave()

    def _leave(self) -> None:
        """Follow no more, where nobody needs it."""
        if self._installed or self._over is not _nothing or self._below:
            return
        self._raw.clear()
        self._wrappers.clear()
        while self._undo:
            self._undo.pop()()


def _subclasses(base: type) -> Iterator[type]:
    cls: type
    for cls in base.__subclasses__():
        yield cls
        yield from _subclasses(cls)


RAW = RawLayer()


_TYPES = ("_flags_", "_restype_", "_argtypes_")


def hook_function(function: Any, hook: Call | None) -> None:
    """Make a ctypes function object call the hook, in place, so that early from-imports follow.

    ``hook=None`` gives the object its own class back. The original stays callable through
    :func:`original_call`.
    """
    cls: Any = type(function)
    if getattr(cls, "_glshim_original", None) is not None:
        function.__class__ = cls._glshim_original
        cls = type(function)
    if hook is None:
        return
    _replace_call(function, hook, _glshim_original=cls)


def hook_function_below(function: Any, maker: Maker) -> None:
    """Make a ctypes function object call the maker's hook below any `hook_function`, for good."""
    _replace_call(function, maker(_called_as(type(function), function)))


def _replace_call(function: Any, hook: Call, **more: Any) -> None:
    cls: Any = type(function)
    body = {
        # A library's own functions have no types on their class, but on themselves.
        **{name: getattr(cls, name) for name in _TYPES if hasattr(cls, name)},
        **more,
        "__call__": lambda _self, /, *args, **_named: hook(*args),  # ctypes ignores keywords
    }
    function.__class__ = type(cls.__name__, (cls,), body)


def original_call(function: Any) -> Call:
    """A call of the ctypes function object that goes past its hook."""
    return _called_as(getattr(type(function), "_glshim_original", type(function)), function)


def _called_as(cls: Any, function: Any) -> Call:
    """A call of the function as what it was before its class was replaced by one below this."""
    if "__call__" in vars(cls):  # a hook below
        return lambda *args: cls.__call__(function, *args)
    parameters = getattr(cls, "_argtypes_", None)
    # A class converts arguments as ctypes did when it was made: ours may do otherwise.
    former = cls(ctypes.cast(function, ctypes.c_void_p).value)

    def call(*args: Any) -> Any:
        if function.argtypes is not parameters:  # it has its own
            return cls.__call__(function, *args)
        if former.restype is not function.restype:
            former.restype = function.restype
        return checked(function, former(*args), args)

    return call


def checked(function: Any, result: Any, args: tuple[Any, ...]) -> Any:
    """What ctypes makes of the result of a call with these arguments."""
    check = function.errcheck
    if check is None:
        return result
    found = check(result, function, args)
    return result if found is args else found


def own_class(function: Any) -> Any:
    """The class of a ctypes function object, below all hooks."""
    cls: Any = type(function)
    while "__call__" in vars(cls):
        cls = cls.__base__
    return cls
