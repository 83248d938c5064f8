"""How mpirun is called, by Open MPI 4 and 5 alike."""


def on_ranks(mpiexec, ranks):
    """What stands before a program for so many ranks, which may be more than processors."""
    # Open MPI 4 has no word to say after a rank's exit code; 5 always has. A rank that waits leaves
    # its processor to others. The libraries of networks would take 0.2 s of each start.
    return [mpiexec, "-np", str(ranks), "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
            "--mca", "orte_execute_quiet", "1", "--mca", "mpi_yield_when_idle", "1", "--mca", "pml",
            "ob1"]
