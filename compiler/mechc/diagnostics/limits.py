"""Words for limits (E8xx): input that is refused before it can take long. Exit status 4."""

from .diagnostic import Words, coded


@coded("E801")
def file_too_large(size: int, limit: int) -> Words:
    """A description is larger than any that a person would write.

    The largest mechanism of the library has some hundred lines; the limit is far above
    that. A file of this size is a mistake (a drawing, a log), and reading it to the end
    would only delay saying so.
    """
    message = f"the description has {size:,} bytes, and the limit is {limit:,}"
    return Words(None, message, "is this the right file?")
