"""The directive `api`: a list of public names of glshim, each with its docstring.

    ```{api}
    install
    uninstall
    ```

In plain Markdown the reader sees the names. Every name of `glshim.__all__` is in one list.
"""

from __future__ import annotations

import inspect
from collections import Counter
from typing import ClassVar

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective
from sphinx.util.inspect import TypeAliasForwardRef

import glshim

LOG = logging.getLogger(__name__)
LISTED: Counter[str] = Counter()
"""How often each name was listed: every build reads all pages."""


class Api(SphinxDirective):
    """Autodoc for each name, by what it is."""

    has_content: ClassVar[bool] = True

    def run(self) -> list[nodes.Node]:
        lines = ["```{eval-rst}"]
        for name in map(str.strip, self.content):
            LISTED[name] += 1
            if name in glshim.__all__:
                lines += directive(name)
            else:
                LOG.warning("%s is no public name", name, location=self.get_location())
        parsed = nodes.container()
        source = self.get_source_info()[0]
        self.state.nested_parse(StringList([*lines, "```"], source), self.content_offset, parsed)
        return parsed.children


def directive(name: str) -> list[str]:
    """The lines of reStructuredText that document a public name."""
    value = getattr(glshim, name)
    if isinstance(value, type) and issubclass(value, Exception):
        return [f".. autoexception:: glshim.{name}", ""]
    if inspect.isclass(value):
        return [f".. autoclass:: glshim.{name}", "   :members:", ""]
    if callable(value) and not hasattr(value, "__origin__"):
        return [f".. autofunction:: glshim.{name}", ""]
    home = glshim._HOME_OF[name]  # only there it has a docstring
    hidden = ["   :no-value:"] if isinstance(value, str) else []  # the text of a shader
    return [f".. autodata:: {home}.{name}", *hidden, ""]


def shorten(
    _app: Sphinx, _kind: str, _name: str, _value: object, _options: object,
    signature: str | None, returns: str | None,
) -> tuple[str | None, str | None]:  # fmt: skip
    """What `autodoc-process-signature` calls: a signature that Sphinx can set parameter by
    parameter."""
    return signature and signature.replace("<factory>", "{}"), returns


def every_name_once(_app: Sphinx, _env: BuildEnvironment) -> None:
    """What `env-check-consistency` calls."""
    for name in glshim.__all__:
        if LISTED[name] != 1:
            LOG.warning("%s is in %d lists of the API reference, not in one", name, LISTED[name])


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("api", Api)
    # Sphinx writes an alias within a union with its class.
    TypeAliasForwardRef.__repr__ = lambda self: self.name
    app.connect("autodoc-process-signature", shorten)
    app.connect("env-check-consistency", every_name_once)
    return {"parallel_read_safe": False, "parallel_write_safe": True}
