"""Clocks and luck that stand still: whatever a program asks for the time or for a random number, it
gets the same in two runs, and everything else as ever."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

CLOCKS = """
import time, datetime
from datetime import date, datetime as taken
from time import localtime, strftime
class Own(taken): pass
zone = datetime.timezone(datetime.timedelta(hours=5))
def look():
    return [
        time.time(), time.time_ns(), time.monotonic(), time.perf_counter(), time.process_time(),
        time.thread_time(), time.clock_gettime(time.CLOCK_REALTIME), time.ctime(), time.asctime(),
        tuple(localtime()), tuple(time.gmtime()), strftime("%c"), time.strftime("%H:%M:%S"),
        taken.now(), taken.now(zone), taken.now(tz=zone), taken.utcnow(), taken.today(),
        datetime.datetime.now(), date.today(), datetime.date.today(), Own.now(), Own.today(),
        taken.now(datetime.timezone.utc).isoformat(),
    ]
"""
LUCK = """
import random, numpy
from random import Random, random as taken
from numpy.random import default_rng, RandomState, SeedSequence, PCG64, Generator
def look():
    found = [taken(), random.randint(0, 10**9), random.random(), Random().random(),
             Random().random(), numpy.random.rand(), numpy.random.randint(10**9)]
    found += [default_rng().random(), default_rng(None).random(), RandomState().rand(),
              SeedSequence().entropy, Generator(PCG64()).random(),
              numpy.random.Generator(numpy.random.Philox()).integers(10**9)]
    random.seed(); numpy.random.seed()
    return [*found, random.random(), numpy.random.rand()]
"""
LATE = """
import time
moments = look()
time.sleep(3600.5)
later = look()
print(moments, later)
print([name for name, a, b in zip(range(99), moments, later) if a == b])
"""


def run(program: str, **variables: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", program],
        env={**os.environ, "PYTHONHASHSEED": "0", "GLSHIM_STYLE": "none",
             "GLSHIM_STILL": "1", **variables},
        capture_output=True, text=True, timeout=20, check=False,
    )  # fmt: skip
    assert done.stderr == ""
    return done.stdout


@pytest.mark.parametrize("names", [CLOCKS, LUCK], ids=["clocks", "luck"])
def test_two_runs_are_the_same(names: str) -> None:
    first = run(names + LATE)
    assert first == run(names + LATE)
    same = first.splitlines()[-1]
    # A clock moves with sleep, but for the day; luck goes on.
    assert same == ("[19, 20]" if names is CLOCKS else "[]")


def test_clocks_stand_until_something_moves_them() -> None:
    assert run(CLOCKS + "a = look(); sum(range(10**6)); print(a == look())") == "True\n"


def test_each_unseeded_generator_is_another() -> None:
    program = """
from random import Random
from numpy.random import default_rng
print(len({Random().random() for _ in range(50)} | {default_rng().random() for _ in range(50)}))
"""
    assert run(program) == "100\n"


def test_what_a_program_seeds_is_as_ever() -> None:
    program = """
import random, numpy
print(random.Random(7).random(), random.Random("text").random(), random.Random(x=7).random())
random.seed(7); numpy.random.seed(7); print(random.random(), numpy.random.rand())
print(numpy.random.default_rng(7).random(), numpy.random.RandomState(7).rand(),
      numpy.random.default_rng(numpy.random.SeedSequence(7)).random())
"""
    if sys.version_info < (3, 11):
        program = program.replace("x=7", "7")
    plain = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=20, check=True
    ).stdout
    assert run(program) == plain


def test_the_zone_is_the_systems() -> None:
    program = "import time, datetime as d; print(*time.localtime()[3:5], d.datetime.now().hour)"
    assert run(program, TZ="UTC") == "12 26 12\n"
    assert run(program, TZ="Asia/Kolkata") == "17 56 17\n"
    assert run(program, TZ="EST5EDT") == "8 26 8\n"


def test_times_that_are_told_are_as_ever() -> None:
    program = """
import time, datetime as d
print(time.gmtime(0)[:6], time.strftime("%Y", time.gmtime(0)), time.asctime(time.gmtime(0)))
print(time.gmtime(None) == time.gmtime(), time.ctime(0) == time.asctime(time.localtime(0)))
print(repr(d.datetime(2001, 2, 3, 4, 5)), d.datetime.fromtimestamp(0, d.timezone.utc))
print(d.datetime.strptime("2001-02-03", "%Y-%m-%d"), d.datetime.fromisoformat("2001-02-03"))
print(d.datetime(2001, 2, 3) + d.timedelta(1), d.datetime.combine(d.date(2001, 2, 3), d.time(4)))
"""
    assert run(program, TZ="UTC").splitlines() == [
        "(1970, 1, 1, 0, 0, 0) 1970 Thu Jan  1 00:00:00 1970",
        "True True",
        "datetime.datetime(2001, 2, 3, 4, 5) 1970-01-01 00:00:00+00:00",
        "2001-02-03 00:00:00 2001-02-03 00:00:00",
        "2001-02-04 00:00:00 2001-02-03 04:00:00",
    ]


@pytest.mark.parametrize("way", ["here", "in C"])
def test_instances_of_datetime_are_of_either_kind(way: str) -> None:
    program = """
import copy, datetime as d, functools, pickle, sys
import numpy
value = d.datetime(2001, 2, 3) if WAY == "here" else numpy.datetime64("2001-02-03T00:00:00").item()
class Own(d.datetime): pass
assert isinstance(value, d.datetime) and isinstance(value, d.date) and isinstance(value, object)
assert not isinstance(value, Own) and not isinstance(d.date(2001, 2, 3), d.datetime)
assert isinstance(Own(2001, 2, 3), d.datetime) and issubclass(Own, d.datetime)
assert issubclass(type(value), d.datetime) and issubclass(d.datetime, d.date)
assert not issubclass(type(value), Own) and not issubclass(d.date, d.datetime)
assert value == d.datetime(2001, 2, 3) == Own(2001, 2, 3) and hash(value) == hash(Own(2001, 2, 3))
assert repr(value) == "datetime.datetime(2001, 2, 3, 0, 0)", repr(value)
for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
    assert pickle.loads(pickle.dumps(value, protocol)) == value
assert copy.deepcopy(value) == value == copy.copy(value)
assert type(Own.now()) is Own and type(d.datetime.now()) is d.datetime
assert numpy.array([value], "datetime64[s]")[0] == numpy.datetime64("2001-02-03")
@functools.singledispatch
def kind(value): return "other"
@kind.register
def _(value: d.date): return "date"
assert kind(value) == "date"
assert WAY == "in C" or type(value + d.timedelta(1)) is type(value.replace(day=4)) is d.datetime
print("as ever")
"""
    assert run(program.replace("WAY", repr(way))) == "as ever\n"


def test_what_keeps_secrets_is_left_alone() -> None:
    # In hexadecimal: one of the bytes may be a space.
    told = "os.urandom(8).hex(), secrets.token_hex(), uuid.uuid4()"
    program = f"import os, secrets, uuid; print({told})"
    first, again = run(program).split(), run(program).split()
    assert all(one != other for one, other in zip(first, again, strict=True))
