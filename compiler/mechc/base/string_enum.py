"""Kinds that are words: what :class:`enum.StrEnum` means, without its cost.

:mod:`enum` makes each member by way of a descriptor and looks for aliases and flags: a class of a
hundred kinds took a sixtieth of a compilation. Here a member is a string with a name.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Self

if TYPE_CHECKING:
    from enum import StrEnum as Word
else:

    class _Making(type):
        """Makes a class of the words in its body: each string with a public name is a member."""

        _members: dict[str, str]

        def __new__(cls, name: str, bases: tuple[type, ...], body: dict[str, Any]) -> Self:
            made = super().__new__(cls, name, bases, {"__slots__": (), **body})
            words = {n: word for n, word in body.items() if type(word) is str and n[0] != "_"}
            made._members = {word: _member(made, n, word) for n, word in words.items()}
            return made

        def __call__(cls, word: str) -> str:
            """Return the member that is a word."""
            if word not in cls._members:
                raise ValueError(f"{word!r} is no {cls.__name__}")
            return cls._members[word]

        def __iter__(cls) -> Iterator[str]:
            return iter(cls._members.values())

    def _member(of: type, name: str, word: str) -> str:
        member = str.__new__(of, word)
        member.name = name
        setattr(of, name, member)
        return member

    class Word(str, metaclass=_Making):
        """A base of kinds, each of which is a word.

        >>> class Side(Word):
        ...     LEFT = "left"
        ...     RIGHT = "right"
        >>> Side.LEFT, Side("right") is Side.RIGHT, Side.LEFT == "left", f"{Side.LEFT}"
        (<Side.LEFT: 'left'>, True, True, 'left')
        >>> [(side.name, side.value) for side in Side]
        [('LEFT', 'left'), ('RIGHT', 'right')]
        """

        __slots__ = ("name",)

        @property
        def value(self) -> str:
            """The word itself."""
            return str.__str__(self)

        def __repr__(self) -> str:
            return f"<{type(self).__name__}.{self.name}: {self.value!r}>"

        def __reduce__(self) -> tuple[type, tuple[str]]:
            return type(self), (self.value,)


__all__ = ["Word"]
