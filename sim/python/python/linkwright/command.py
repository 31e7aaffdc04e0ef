"""The command ``sim``, with the shipped mechanisms."""

import sys

from ._linkwright import main as _main


def main() -> int:
    """Execute the command line of this process, and give its exit status. Signals are handled as the command needs it from then
    on, so this is for a process of its own."""
    return _main(["sim", *sys.argv[1:]])
