"""Where mechc keeps what it would make again. Imported ahead of the compiler: it needs nothing."""

import os
import sys


def folder() -> str:
    """Return the folder; '' where nothing is to be kept.

    ``MECHC_CACHE`` names it, empty for none; otherwise it is where the system has caches.
    """
    if (named := os.environ.get("MECHC_CACHE")) is not None:
        return os.path.abspath(named) if named else ""
    home = os.path.expanduser("~")
    usual = {"win32": "AppData/Local", "darwin": "Library/Caches"}.get(sys.platform, ".cache")
    base = os.environ.get("XDG_CACHE_HOME", "")
    base = base if os.path.isabs(base) else os.path.join(home, usual)
    return os.path.join(base, "mechc") if os.path.isabs(base) else ""
