"""A band brake whose band grips by itself: from some coefficient on nothing turns the drum."""

TEXT = """
param mu = {mu}
pivot O at (0 mm, 0 mm)
pivot C at (0 mm, -250 mm)
link OG
link ACBH
OG = 200 mm @ 0 deg
CA = 60 mm @ 180 deg
CB = 20 mm @ 0 deg
CH = 350 mm @ 0 deg
rope A, O along y, B along -y
torque M on OG
force P at H along y
friction rope O mu wrap -180 deg drum 400 mm on OG
{asked}
"""


def gripping_brake(mu: str, asked: str) -> str:
    """Return the description with its coefficient, a range behind it, and what is asked for."""
    return TEXT.format(mu=mu, asked=asked)
