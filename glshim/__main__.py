"""``python -m glshim``."""

import sys

from glshim.cli import main

sys.exit(main())
