"""Russian: the terms of the theory of mechanisms and of theoretical mechanics."""

from .reported import LOCALE

__all__ = ["LOCALE"]
