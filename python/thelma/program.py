"""Where the finite element program is."""

import os
import shutil
from pathlib import Path

from thelma.errors import ThelmaError

CHECKOUT = Path(__file__).resolve().parents[2]


def find(given=None):
    """The one that is given or named by THELMA, that of the checkout, or the installed one."""
    given = given or os.environ.get("THELMA")
    if given:
        if not os.access(given, os.X_OK) or Path(given).is_dir():
            raise ThelmaError(f"there is no program {given}; scripts/setup builds it")
        return Path(given).resolve()
    built = CHECKOUT / "build/bin/thelma"
    if os.access(built, os.X_OK):
        return built
    installed = shutil.which("thelma")
    if not installed:
        raise ThelmaError("the program thelma is not found; build it with scripts/setup, or name it in the "
                          "environment variable THELMA")
    return Path(installed)
