"""The derivation in steps, read off the plan: what the report and the terminal print."""

TYPE_CHECKING = False
if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"equal_sides", "equilibrium", "friction"}
    __getattr__ = waiting(__name__, SELDOM)
