"""``python -m linkwright`` is the command ``sim``."""

import sys

from .command import main

sys.exit(main())
