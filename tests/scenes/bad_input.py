"""Bad input ends in one sentence and exit code 1 on any number of ranks, without a hang.

Usage: bad_input.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import subprocess
import tempfile
from pathlib import Path

from scene import program_and_ranks, require

TETRAHEDRA = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 5, 5, 1};
Physical Volume("film") = {1};
"""

# What is wrong, the options that make it so, and what the sentence must say.
CASES = [
    ("unknown entry", ["--set", "Newton/Tolerence=1"], ["'Tolerence'", "Tolerance"]),
    ("unknown section", ["--set", "Newtn/Tolerance=1"], ["'Newtn'", "Newton"]),
    ("malformed value", ["--set", "Newton/Tolerance=small"], ["'small'", "Double"]),
    ("unknown region", ["--set", "Regions/Materials=foam: elastomer"], ["'foam'", "film"]),
    ("unknown surface", ["--set", "Supports/Fixed=x9: u1"], ["'x9'", "x1_min"]),
    ("unknown material", ["--set", "Loading/Film material=rubber"], ["'rubber'", "elastomer"]),
    ("unknown law", ["--set", "Materials/elastomer/Elastic law=Foo"], ["'Foo'", "neo-Hookean"]),
    ("unknown observable", ["--set", "Output/Observables=phase"], ["'phase'", "charge"]),
    ("missing mesh", ["--set", "Mesh/File=nothing.geo"], ["nothing.geo"]),
    ("unknown mesh parameter", ["--set", "Mesh/Parameters=L9: 1"], ["'L9'", "L1, L2, L3"]),
    ("imperfection without shape", ["--set", "Mesh/Imperfection=0.1"], ["shape", "three"]),
    ("unreadable imperfection", ["--set", "Mesh/Imperfection=0.1",
                                 "--set", "Mesh/Imperfection shape=0; 0; sin(x4)"],
     ["shape", "'sin(x4)'", "x1,x2,x3"]),
    ("imperfection turns cells inside out", ["--set", "Mesh/Imperfection=2",
                                             "--set", "Mesh/Imperfection shape=0; 0; -x3"],
     ["Imperfection", "inside out"]),
    ("unreadable expectation", ["--set", "Expectations/Final values=e: theta +"],
     ["Final values", "e", "'theta +'"]),
    ("reaction of an unknown surface",
     ["--set", "Output/Observables=lambda_3, reaction", "--set", "Observables/reaction/At=x9"],
     ["reaction", "'x9'", "x1_min"]),
    ("negative modulus", ["--set", "Materials/elastomer/Shear modulus=-1"],
     ["Shear modulus", "-1", "positive"]),
    ("no ground electrode", ["--set", "Electrodes/Potential=top: 1"], ["ground", "0"]),
    ("unreadable force", ["--set", "Loads/Force=top: 1 0", "--set", "Loading/Stages=force 1"],
     ["Force", "'1 0'", "3 components"]),
    ("force on an unknown surface", ["--set", "Loads/Force=x9: 1 0 0"], ["'x9'", "x1_min"]),
    ("no force to apply", ["--set", "Loading/Stages=force 1"], ["Stages", "Loads", "Force"]),
    ("controlled displacement that is held",
     ["--set", "Stepping/Controlled displacement=bottom: u3",
      "--set", "Stepping/Continuation=automatic"], ["Controlled displacement", "bottom", "free"]),
    ("controlled displacement without a path",
     ["--set", "Stepping/Controlled displacement=top: u3"],
     ["Controlled displacement", "Continuation"]),
    ("convection into nowhere", ["--set", "Temperature/Model=transient",
                                 "--set", "Heat/Convection=top: 1"],
     ["'top'", "Convection", "Surroundings"]),
    ("steady heat without a wall", ["--set", "Temperature/Model=steady"],
     ["Fixed", "steady", "convection"]),
    ("heat without a field", ["--set", "Heat/Flux=top: 1"], ["Heat", "Model"]),
    ("source in an unknown region", ["--set", "Temperature/Model=transient",
                                     "--set", "Heat/Source=foam: 1"], ["Source", "'foam'", "film"]),
    ("amplitude without time", ["--set", "Time/Voltage amplitude=t"], ["Time", "transient"]),
    ("unreadable amplitude", ["--set", "Temperature/Model=transient",
                              "--set", "Time/Voltage amplitude=0: 0, one: 1"],
     ["Voltage amplitude", "'0: 0, one: 1'", "time: value"]),
    ("tetrahedra", ["--set", "Mesh/File={folder}/tetrahedra.geo", "--set", "Mesh/Parameters="],
     ["film", "hexahedra"]),
    ("unreadable geometry", ["--set", "Mesh/File={folder}/broken.geo"], ["broken.geo"]),
    ("unwritable output", ["--output", "/proc/thelma"], ["--output", "/proc/thelma"]),
    ("repeated case", ["--sweep", "Temperature/Value=273, 273"], ["Temperature.Value=273", "once"]),
    ("malformed ranks per case", ["--ranks-per-case", "two"], ["--ranks-per-case", "'two'"]),
    ("too many ranks per case", ["--sweep", "Temperature/Value=273", "--ranks-per-case", "9"],
     ["--ranks-per-case", "9", "mpirun"]),
    ("missing study", ["@nothing.study"], ["nothing.study", "@"]),
    ("unknown option", ["--frobnicate"], ["--frobnicate", "--sweep"]),
    ("missing file", None, ["nothing.prm"]),
]


def complaint(program, options, ranks):
    """Exit code and standard error of a run that is expected to fail at once."""
    command = program.command(options, ranks)
    done = subprocess.run(command, cwd=program.source, capture_output=True, text=True,
                          check=False, timeout=60)
    return done.returncode, done.stderr


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "tetrahedra.geo").write_text(TETRAHEDRA)
        (Path(folder) / "broken.geo").write_text("Point(1) = {0, 0\n")
        for name, options, words in CASES:
            arguments = ["nothing.prm"] if options is None else [
                "prm/planar_actuator.prm", "--output", f"{folder}/out",
                *[option.format(folder=folder) for option in options]]
            for ranks in all_ranks:
                code, text = complaint(program, arguments, ranks)
                # Open MPI's hwloc speaks up where /sys is not mounted.
                lines = [line for line in text.splitlines()
                         if line.strip() and not line.startswith("[hwloc/")]
                print(f"{name} ({ranks}): {text.strip()}")
                require(code == 1, f"{name} on {ranks} ranks: exit code {code}, not 1")
                require(len(lines) == 1, f"{name} on {ranks} ranks: {len(lines)} lines, not one")
                for word in words:
                    require(word in lines[0], f"{name} on {ranks} ranks: no word of {word}")


main()
