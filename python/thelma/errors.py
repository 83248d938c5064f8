"""What the user can mend."""


class ThelmaError(Exception):
    """One sentence for the user."""
