"""English."""

from .reported import LOCALE

__all__ = ["LOCALE"]
