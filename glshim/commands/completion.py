"""``glshim completion``: what a shell loads so that Tab completes commands, options and styles."""

from __future__ import annotations

import argparse
from typing import ClassVar

from glshim.commands.candidates import candidates, words_of
from glshim.commands.command import Command

_SHELLS = {
    "bash": """\
# In ~/.bashrc: eval "$(glshim completion bash)"
_glshim() {
    local IFS=$'\\n'
    COMPREPLY=($(glshim completion --of "${COMP_LINE:0:$COMP_POINT}" --word "$2" 2>/dev/null))
    [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *[:=] ]] && compopt -o nospace
}
complete -o default -F _glshim glshim
""",
    "zsh": """\
# In ~/.zshrc, after compinit: eval "$(glshim completion zsh)"
_glshim() {
    local -a whole begun
    local each
    for each in ${(f)"$(glshim completion --of "${(j: :)${(@q)words[1,CURRENT]}}" 2>/dev/null)"}; do
        if [[ $each == *[:=] ]]; then begun+=($each); else whole+=($each); fi
    done
    if (( ! $#whole && ! $#begun )); then _files; return; fi
    compadd -Q -- $whole
    compadd -Q -S '' -- $begun
}
compdef _glshim glshim
""",
    "fish": """\
# In ~/.config/fish/config.fish: glshim completion fish | source
complete -c glshim -n 'test (count (commandline -opc)) -eq 1' -f
complete -c glshim -a '(glshim completion --of (commandline -cp | string collect) 2>/dev/null)'
""",
}


class Completion(Command):
    """Exit status 0."""

    name: ClassVar[str] = "completion"
    help: ClassVar[str] = "print a script for shell completion: bash, zsh or fish"
    usage: ClassVar[str | None] = "glshim completion [-h] {bash,zsh,fish}"

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        what = parser.add_mutually_exclusive_group(required=True)
        what.add_argument("shell", nargs="?", choices=_SHELLS, help="the shell to print it for")
        # What these scripts call: the command line up to the cursor, and its last word as the
        # shell parts words.
        what.add_argument("--of", metavar="LINE", help=argparse.SUPPRESS)
        parser.add_argument("--word", help=argparse.SUPPRESS)

    def run(self, asked: argparse.Namespace) -> int:
        if asked.of is None:
            print(_SHELLS[asked.shell], end="")
            return 0
        words = words_of(asked.of)
        # Bash parts words at colons and equals signs, too.
        done = len(words[-1]) - len(asked.word) if asked.word is not None else 0
        for each in candidates(asked.root, words):
            print(each[max(done, 0) :])
        return 0
