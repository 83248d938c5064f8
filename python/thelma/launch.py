"""How mpirun is called, by Open MPI 4 and 5 alike."""

import re


def on_ranks(mpiexec, ranks):
    """What stands before a program for so many ranks, which may be more than processors."""
    # A rank that waits leaves its processor to others. The libraries of networks would take 0.2 s
    # of each start.
    return [mpiexec, "-np", str(ranks), "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
            "--mca", "orte_execute_quiet", "1", "--mca", "mpi_yield_when_idle", "1", "--mca", "pml",
            "ob1"]


def sentences(text):
    """The lines of standard error that are the program's, without what Open MPI adds: between two
    rules of dashes after a rank's exit code (5 is never quiet), and of hwloc without /sys."""
    own = re.sub(r"^-{70,}\n.*?^-{70,}$", "", text, flags=re.DOTALL | re.MULTILINE)
    return [line for line in own.splitlines()
            if line.strip() and not line.startswith(("[hwloc/", "hwloc/"))]
