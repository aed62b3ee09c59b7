"""The command line: ``glshim run|view|gallery|shot|styles ...``, or ``python -m glshim``.

Exit status: the program's own under ``run`` and ``view``; 2 for a command that makes no sense (a
style, a number, a screen that is not there), before any window opens.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence

from glshim.commands import gallery, shot
from glshim.control import keys
from glshim.errors import GlshimError
from glshim.notices import say
from glshim.running import launch
from glshim.styling import texts

DEFAULT_STYLE = "raskar"
VIEWER = "demo_apps.viewer"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command; its exit status."""
    asked = _parser().parse_args(arguments)
    try:
        status: int = asked.command(asked)
    except GlshimError as error:
        say(str(error))
        return 2
    return status


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="glshim", description="Restyle unmodified PyOpenGL programs with ink lines."
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    running = argparse.ArgumentParser(add_help=False)
    running.add_argument(
        "--style",
        default=DEFAULT_STYLE,
        help="NAME, NAME:key=value,key=value or FILE.toml (default: %(default)s)",
    )
    running.add_argument(
        "--keys", metavar="KEYS", help="keys while it runs: on, off or ACTION=KEY,ACTION=KEY"
    )
    running.add_argument("--frames", metavar="N", help="end with status 0 after N frames")
    running.add_argument(
        "--capture", metavar="OUT%03d.png", help="write each frame as presented, from number 1"
    )
    running.add_argument(
        "--headless", action="store_true", help="run on a virtual screen of its own (Xvfb)"
    )

    run = commands.add_parser(
        "run",
        parents=[running],
        help="run a program, restyled",
        usage="glshim run [options] (SCRIPT | -m MODULE) [ARGS...]",
    )
    what = run.add_mutually_exclusive_group(required=True)
    what.add_argument("-m", dest="module", nargs=argparse.REMAINDER, help="run a module")
    what.add_argument("script", nargs="?", help="the program, as python takes it")
    run.add_argument("arguments", nargs=argparse.REMAINDER, help="the program's own")
    run.set_defaults(command=_run)

    view = commands.add_parser("view", parents=[running], help="look at a model, restyled")
    view.add_argument("model", nargs="?", help="OBJ, PLY, STL, glTF file or a built-in shape")
    view.set_defaults(command=_view)

    gallery.add_command(commands)
    shot.add_command(commands, DEFAULT_STYLE)

    styles = commands.add_parser("styles", help="list the styles and their options")
    styles.add_argument("names", nargs="*", metavar="NAME", help="only these")
    styles.set_defaults(command=_styles)

    check = commands.add_parser("check-style", help="try a style against what all styles keep to")
    check.add_argument("style", metavar="STYLE", help="a name, FILE.toml or my_style.py:MyStyle")
    check.add_argument("--headless", action="store_true", help="draw on a virtual screen")
    check.set_defaults(command=_check_style)

    doctor = commands.add_parser("doctor", help="say what is here and what will not work")
    doctor.add_argument("--headless", action="store_true", help="look at GL on a virtual screen")
    doctor.add_argument(
        "--startup-cost", action="store_true", help="measure what glshim adds to Python's start"
    )
    doctor.set_defaults(command=_doctor)
    return parser


def _run(asked: argparse.Namespace) -> int:
    program = ["-m", *asked.module] if asked.module else [asked.script, *asked.arguments]
    return _launch(program, asked)


def _view(asked: argparse.Namespace) -> int:
    if asked.keys is None and keys.KEYS not in os.environ:
        asked.keys = "on"
    # Frames that are counted or written are to show the model, not that it is on its way.
    wait = ["--wait"] if asked.frames is not None or asked.capture is not None else []
    return _launch(["-m", VIEWER, *wait, *([asked.model] if asked.model else [])], asked)


def _launch(program: list[str], asked: argparse.Namespace) -> int:
    return launch.run(program, variables_for(asked), headless=asked.headless)


def variables_for(asked: argparse.Namespace) -> dict[str, str]:
    """The flags as the variables that the program's start reads, checked here and now."""
    texts.parse_style(asked.style)
    variables = {texts.STYLE: texts.anchored(asked.style, os.getcwd())}
    if asked.keys is not None:
        keys.parse_keys(asked.keys)
        variables[keys.KEYS] = asked.keys
    if asked.frames is not None:
        variables[texts.FRAMES] = str(texts.parse_frames(asked.frames))
    if asked.capture is not None:
        variables[texts.CAPTURE] = texts.parse_capture(asked.capture)
    return variables


def _styles(asked: argparse.Namespace) -> int:
    from glshim.styling import registry

    for name in asked.names or (*registry.names(), *registry.looks()):
        is_look = name in registry.looks()
        print(texts.describe_look(name) if is_look else texts.describe(registry.load(name)))
    return 0


def _check_style(asked: argparse.Namespace) -> int:
    from glshim.commands.check_style import check_style

    return check_style(asked.style, headless=asked.headless)


def _doctor(asked: argparse.Namespace) -> int:
    from glshim.commands import doctor

    if asked.startup_cost:
        return doctor.print_startup_cost()
    return doctor.print_report(headless=asked.headless)


if __name__ == "__main__":
    sys.exit(main())
