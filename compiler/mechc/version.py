"""The version of mechc."""

VERSION = "0.1.0"
