"""The Python that has the packages: the one that runs or, failing that, the system's own."""

import importlib.util
import os
import sys
from pathlib import Path

SYSTEM = "/usr/bin/python3"  # what scripts/packages.txt names is for this one


def require(*modules):
    """Goes on with the system's Python, or ends with one sentence, where a module is missing."""
    missing = [module for module in modules if not importlib.util.find_spec(module)]
    if not missing:
        return
    if sys.executable != SYSTEM and os.access(SYSTEM, os.X_OK):
        os.execv(SYSTEM, [SYSTEM, *sys.argv])
    sys.exit(f"{Path(sys.argv[0]).name}: {sys.executable} has no {' and no '.join(missing)}; on "
             f"Debian: apt-get install {' '.join(f'python3-{module}' for module in missing)}")
