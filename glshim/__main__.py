"""``python -m glshim``."""

import sys

from glshim.commands.cli import main

sys.exit(main())
