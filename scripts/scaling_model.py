"""What more ranks than a machine has would do with the block solver: a model of one iteration.

Work shrinks with the ranks. What does not: halos, which neighbours exchange before every product
with a matrix, reductions, which all ranks take part in, and multigrid's coarsest level, which is
collected, solved with factors and sent back. Work and iterations are measured (doc/scaling.csv); sizes of halos follow from
the geometry of the partition and come near the measured ones; the network is assumed."""

from math import log2

LATENCY, BANDWIDTH = 2e-6, 1e10  # s and bytes/s of a usual network of a cluster
COARSEST = 1e-3  # s: 2000 unknowns, collected, solved with factors, sent back
NEIGHBOURS = 8
LEVELS, DEGREE = 4, 2  # of multigrid and its smoother
# A level smooths from zero, takes a residual, goes down and up and smooths again.
EXCHANGES_PER_CYCLE = LEVELS * (DEGREE - 1 + 1 + 2 + DEGREE)
# Four blocks of the tangent, three sums over the cells with pressures, two cycles.
EXCHANGES, OF_SINGLES = 4 + 3, 2 * EXCHANGES_PER_CYCLE
UNKNOWNS_PER_NODE = 3.5  # potential in half of the body


def ghost_share(unknowns, ranks):
    """Nodes that a rank needs of others, over its own: of a cube's six faces each is shared by two
    ranks, and one of them owns it; in a slender body cut across it is one face of the section."""
    if ranks == 1:
        return 0.0
    own = unknowns / ranks / UNKNOWNS_PER_NODE
    cube = 3 * own ** (2 / 3) / own
    section = (unknowns / UNKNOWNS_PER_NODE / 80) ** (2 / 3) * 4  # of 1 x 4 x 20: nodes of 1 x 4
    return min(cube, section / own)


def seconds(unknowns, ranks, work, iterations):
    """Of one iteration: (work, halos, reductions, coarsest level); `work` is s per unknown on one
    rank. The j-th iteration takes j + 1 scalar products."""
    own = unknowns / ranks
    if ranks == 1:
        return work * own, 0.0, 0.0, 0.0
    wait, byte = NEIGHBOURS * LATENCY, ghost_share(unknowns, ranks) * own / BANDWIDTH
    halos = EXCHANGES * (wait + 8 * byte) + OF_SINGLES * (wait + 4 * byte)
    reductions = (iterations / 2 + 1) * log2(ranks) * LATENCY
    return work * own, halos, reductions, 2 * COARSEST


def table(unknowns, work, iterations):
    """Lines of the document."""
    lines = ["| ranks | unknowns of a rank | ghosts | work ms | ghosts ms | reductions ms | "
             "coarsest level ms | iteration ms | efficiency |", "|" + "---|" * 9]
    alone = sum(seconds(unknowns, 1, work, iterations))
    for ranks in (1, 2, 8, 32, 128):
        parts = seconds(unknowns, ranks, work, iterations)
        lines.append(
            f"| {ranks} | {unknowns / ranks:.0f} | {ghost_share(unknowns, ranks):.3f} | "
            + " | ".join(f"{1e3 * part:.2f}" for part in parts)
            + f" | {1e3 * sum(parts):.1f} | {alone / ranks / sum(parts):.2f} |")
    return lines
