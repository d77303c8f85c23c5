"""What joints hold: the points and the bodies that most kinds of them have in common."""


class OnePoint:
    """A joint that holds one point."""

    __slots__ = ()
    point: str

    @property
    def points(self) -> tuple[str, ...]:
        """Return the points that it holds."""
        return (self.point,)


class OnGround:
    """A joint with the ground, which names no body."""

    __slots__ = ()

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the bodies that it names."""
        return ()


class OnLink:
    """A joint that names one body."""

    __slots__ = ()
    link: str

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the bodies that it names."""
        return (self.link,)
