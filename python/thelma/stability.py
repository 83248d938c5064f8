"""Which parts of a curve are unstable."""

EVENTS = ("limit point", "bifurcation")  # a bifurcation may be a `double` one


def unstable_pieces(unstable, events=None):
    """For every piece between two rows of a curve, whether it is unstable. `unstable` are the rows'
    numbers of unstable directions. At a limit point or bifurcation, an entry of `events`, that number
    is either side's: there the piece's other end decides."""
    rows = [bool(number) and number == number for number in unstable]  # nan is unknown
    critical = [event.endswith(EVENTS) for event in (events if events is not None else [""] * len(rows))]
    pieces = []
    for i in range(len(rows) - 1):
        ends = [rows[j] for j in (i, i + 1) if not critical[j]]
        pieces.append(any(ends) if ends else rows[i] and rows[i + 1])
    return pieces


def parts(pieces):
    """(first row, last row, unstable) of the longest parts that are alike."""
    parts, begin = [], 0
    for i, unstable in enumerate(pieces):
        if i + 1 == len(pieces) or pieces[i + 1] != unstable:
            parts.append((begin, i + 1, unstable))
            begin = i + 1
    return parts
