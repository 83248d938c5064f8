"""Bad input ends in one sentence and exit code 1 on any number of ranks, without a hang.

Usage: bad_input.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import itertools
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from scene import program_and_ranks, require, sentences

TETRAHEDRA = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 5, 5, 1};
Physical Volume("film") = {1};
"""

BOX = """Point({0}) = {{{1}, 0, 0}};
l{0}[] = Extrude {{5, 0, 0}} {{ Point{{{0}}}; Layers{{1}}; }};
a{0}[] = Extrude {{0, 5, 0}} {{ Line{{l{0}[1]}}; Layers{{1}}; Recombine; }};
b{0}[] = Extrude {{0, 0, 1}} {{ Surface{{a{0}[1]}}; Layers{{1}}; Recombine; }};
"""
SIDES = """Physical Volume("film") = b1[1];
Physical Surface("bottom") = a1[1];
Physical Surface("top") = b1[0];
Physical Surface("x2_min") = b1[2];
Physical Surface("x1_max") = b1[3];
Physical Surface("x1_min") = b1[5];
"""
TWO_BODIES = BOX.format(1, 0) + BOX.format(100, 20) + SIDES + """Physical Volume("loose") = b100[1];
"""
TALL = BOX.format(1, 0) + """l2[] = Extrude {0, 0, 1} { Surface{b1[0]}; Layers{1}; Recombine; };
Physical Volume("film") = {b1[1], l2[1]};
Physical Surface("bottom") = a1[1];
Physical Surface("top") = l2[0];
Physical Surface("x1_max") = l2[3];
Physical Surface("x2_min") = {b1[2], l2[2]};
Physical Surface("x1_min") = {b1[5], l2[5]};
"""
TWO_FILMS = BOX.format(1, 0) + BOX.format(100, 20) + """
Physical Volume("film") = {b1[1], b100[1]};
Physical Surface("bottom") = {a1[1], a100[1]};
Physical Surface("top") = b1[0];
Physical Surface("other") = b100[0];
Physical Surface("x2_min") = {b1[2], b100[2]};
Physical Surface("x1_min") = {b1[5], b100[5]};
"""
STRAY = BOX.format(1, 0) + SIDES + """Point(100) = {20, 0, 0};
Point(101) = {21, 0, 0};
Line(100) = {100, 101};
Transfinite Curve {100} = 2;
Physical Curve("stray") = {100};
"""
BOW_TIE = """Point(1) = {0, 0, 0};
Point(2) = {1, 1, 0};
Point(3) = {1, 0, 0};
Point(4) = {0, 1, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Transfinite Curve {1, 2, 3, 4} = 2;
Recombine Surface {1};
b1[] = Extrude {0, 0, 1} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("film") = b1[1];
Physical Surface("bottom") = 1;
Physical Surface("top") = b1[0];
"""

# A cube, one of whose nodes lies nowhere.
LOST_NODE = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 1 "film"
$EndPhysicalNames
$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 {} 1
6 1 0 1
7 1 1 1
8 0 1 1
$EndNodes
$Elements
1
1 5 2 1 1 1 2 3 4 5 6 7 8
$EndElements
"""

# Of one that is no plane of x1 and x3, and of one that is.
FLAT = """Point(1) = {{0, 0, 0}};
line[] = Extrude {{1, 0, 0}} {{ Point{{1}}; Layers{{1}}; }};
area[] = Extrude {{{0}}} {{ Line{{line[1]}}; Layers{{1}}; Recombine; }};
Physical Surface("film") = area[1];
"""

# Faults of one file, and what the sentences, with its lines, must say.
NAMES = """subsection Mesh
  set File = {source}/meshes/box.geo
end
subsection Regions
  set Materials = film: elastomer
end
subsection Newton
  set Tolerence = 1
end
subsection Supports
  set Fixed = x1_min: u1, x9: u2
end
subsection Electrodes
  set Potential = bottom: 0, top: 1, x2_max: 2
end
subsection Temperature
  set Value = 3 V
end
subsection Output
  set Observables = lambda3, reaction
end
subsection Observables
  subsection reaction
    set At = nowhere
  end
end
"""
OF_NAMES = [(":8, section Newton", "'Tolerance'"), (":17,", "voltage"),
            (":20, section Output, entry 'Observables'", "'lambda_3'"),
            (":11, section Supports, entry 'Fixed'", "'x9'"),
            (":14, section Electrodes, entry 'Potential'", "short circuit"),
            (":24, section Observables/reaction", "'nowhere'")]

# The same of values: all are found although there is no mesh.
VALUES = """\ufeffset Dimension = 4
subsection Mesh
  set File = nothing.geo
  set Parameters = L1 5
end
subsection Regions
  set Materials = film: elastomer, film: elastomer
  set Passive = a, a,
end
subsection Electrodes
  set Potential = bottom: 0, top: one
end
subsection Supports
  set Fixed = x1_min
  set Moved = top: 1
end
subsection Temperature
  set Value = 80 C
  set Model = steaddy
end
subsection Heat
  set Convection = top: -1
  set Surroundings = top: 80 degF
end
subsection Loads
  set Force = top: 1 0
end
subsection Loading
  set Film thickness = 1,5
  set Bracket = 5
end
subsection Stepping
  set Controlled displacement = top: w3
end
subsection Newton
  set Tolerance = 1e-8
  set Tolerance = 1e-9
end
subsection Output
  set Observables = charge, charge
end
subsection Expectations
  set Relative tolerance = 2
end
"""
OF_VALUES = [(":1,", "from 2 to 3"), (":3, section Mesh", "no file"), (":4,", "`name: value"),
             (":7,", "twice"), (":11,", "'one'"), (":14,", "`name: value`"), (":15,", "u1 2.5"),
             (":18,", "20 degC"), (":19,", "'steady'"), (":22,", "at least 0"), (":23,", "degC"),
             (":26,", "3 components"), (":29,", "decimal point"), (":30,", "from 1e-12 to 1"),
             (":33,", "u1, u2, u3"), (":37,", "line 36"), (":40,", "twice"),
             (":43,", "from 0 to 1")]

# Scenes of a dimension that the mesh does not have.
PLANE = """set Dimension = 2
subsection Mesh
  set File = {file}
end
subsection Regions
  set Materials = film: elastomer
end
"""

# What is wrong, the options that make it so, and what the sentence must say. First entries that
# each rank refuses while it reads: on one rank, as the way out is that of the faults of one file.
READING = [
    ("unknown entry", ["--set", "Newton/Tolerence=1"], ["'Tolerence'", "'Tolerance'"]),
    ("unknown section", ["--set", "Newtn/Tolerance=1"], ["'Newtn'", "'Newton'"]),
    ("entry of another section", ["--set", "Newton/Film thickness=1"],
     ["'Film thickness'", "section Loading"]),
    ("wrong dimension", ["--set", "Temperature/Value=353 kPa"],
     ["'353 kPa'", "pressure", "temperature", "K"]),
    ("wrong dimension of one of several", ["--set", "Mesh/Parameters=L1: 5 mm, L3: 1 kV"],
     ["'1 kV'", "voltage", "length"]),
    ("unknown unit", ["--set", "Loading/Film thickness=40 thou"], ["'thou'", "not a unit", "mm"]),
    ("voltage where e is controlled", ["--set", "Loading/Target=18.2 kV"],
     ["command line", "Target", "'18.2 kV'", "voltage", "plain number", "Control"]),
    ("malformed value", ["--set", "Newton/Tolerance=small"],
     ["'small'", "from 1e-14 to 1e-06"]),
    ("unknown material", ["--set", "Loading/Film material=rubber"],
     ["Film material", "'rubber'", "elastomer"]),
    ("unknown law", ["--set", "Materials/elastomer/Elastic law=Foo"], ["'Foo'", "neo-Hookean"]),
    ("unknown observable", ["--set", "Output/Observables=phase"], ["'phase'", "charge"]),
    ("observable without a kind", ["--set", "Output/Observables=lambda_3, left",
                                   "--set", "Observables/left/At=top"],
     ["Output, entry 'Observables'", "'left'", "no Kind", "Observables/left", "probe"]),
    ("observable of an unknown kind", ["--set", "Output/Observables=lambda_3, left",
                                       "--set", "Observables/left/Kind=prob",
                                       "--set", "Observables/left/At=top"],
     ["Observables/left, entry 'Kind'", "'prob'", "did you mean 'probe'", "reaction"]),
    ("known observable of another kind", ["--set", "Output/Observables=lambda_3, probe",
                                          "--set", "Observables/probe/Kind=reaction",
                                          "--set", "Observables/probe/At=top"],
     ["Observables/probe, entry 'Kind'", "'reaction'", "choose another name"]),
    ("observable of an odd name", ["--set", "Output/Observables=lambda_3, left probe",
                                   "--set", "Observables/left probe/Kind=probe",
                                   "--set", "Observables/left probe/At=top"],
     ["Output, entry 'Observables'", "'left probe'", "only letters"]),
    ("negative modulus", ["--set", "Materials/elastomer/Shear modulus=-1"],
     ["Shear modulus", "-1", "positive"]),
    ("Ogden terms without an exponent", ["--set", "Materials/elastomer/Elastic law=Ogden",
                                         "--set", "Materials/elastomer/Ogden terms=one: 0.6"],
     ["Ogden terms", "each name a number", "each value a number in MPa"]),
    ("Ogden terms that soften", ["--set", "Materials/elastomer/Elastic law=Ogden",
                                 "--set", "Materials/elastomer/Shear modulus=",
                                 "--set", "Materials/elastomer/Ogden terms=-2: 0.1"],
     ["Shear modulus", "-0.1", "positive"]),
    ("unreadable force", ["--set", "Loads/Force=top: 1 0", "--set", "Loading/Stages=force 1"],
     ["Force", "'1 0'", "3 components in N"]),
    ("force of nothing", ["--set", "Loads/Force=top: 0 0 0", "--set", "Loading/Stages=force 1"],
     ["Force", "a force of 0"]),
    ("stage that goes nowhere", ["--set", "Loading/Stages=voltage 1, voltage 1"],
     ["Stages", "'voltage 1'", "there already"]),
    ("negative modulus at a wall", ["--set", "Materials/elastomer/Shear modulus=-1, 0.32",
                                    "--set", "Temperature/Model=steady", "--set", "Temperature/Fixed=top: 353"],
     ["Shear modulus", "353 K", "positive"]),
    ("relative permittivity", ["--set", "Materials/elastomer/Permittivity=4.5"],
     ["Permittivity", "vacuum", "F/m"]),
    ("amplitude without time", ["--set", "Time/Voltage amplitude=t"], ["Time", "transient"]),
    ("unreadable amplitude", ["--set", "Temperature/Model=transient",
                              "--set", "Time/Voltage amplitude=0: 0, one: 1"],
     ["Voltage amplitude", "'0: 0, one: 1'", "time: value"]),
    ("infinite amplitude", ["--set", "Temperature/Model=transient",
                            "--set", "Time/Voltage amplitude=1/t"],
     ["Voltage amplitude", "inf at t = 0"]),
]

# Energies of prm/verification/own_energy.prm, and what the sentence must say.
ENERGIES = [
    ("mu*(I3 - 3), mu: 0.05", ["'mu*(I3 - 3)'", "unknown name 'I3'", "did you mean 'I1'", "theta, mu, exp"]),
    ("0.05*(I1 - 3", ["'0.05*(I1 - 3'", "parenthesis is not closed"]),
    ("0.05*(I1 - 3) +", ["missing at its end"]),
    ("0.05*I1 I2", ["from 'I2' on"]),
    ("0.05*J^I1", ["exponent", "exp("]),
    ("mu*(I1 - 3), mu", ["'mu' has no value", "`name: value`"]),
    ("J*(I1 - 3), J: 1", ["'J' has a meaning already"]),
    ("", ["empty", "write an energy"]),
    ("-0.05*(I1 - 3 - 2*log(J))", ["-0.1", "positive"]),
    ("0.05*(I1 - 3)", ["293 K", "stress of 0.1 MPa", "add -0.1*log(J)"]),
]

# What is found once there is a mesh, or by looking for it, and faults of the command line: on any
# number of ranks.
CASES = [
    ("unknown region", ["--set", "Regions/Materials=foam: elastomer"], ["'foam'", "film"]),
    ("unknown surface", ["--set", "Supports/Fixed=x9: u1"], ["'x9'", "x1_min"]),
    ("no mesh", ["--set", "Mesh/File="], ["File", "empty", "set File"]),
    ("missing mesh", ["--set", "Mesh/File=nothing.geo"], ["nothing.geo"]),
    ("folder for a mesh", ["--set", "Mesh/File={folder}"], ["there is no file"]),
    ("text for a mesh", ["--set", "Mesh/File=README.md"], ["gmsh cannot read", "more"]),
    ("unknown mesh parameter", ["--set", "Mesh/Parameters=L9: 1"], ["'L9'", "L1, L2, L3"]),
    ("part of a cell", ["--set", "Mesh/Parameters=n1: 2.5"], ["'n1'", "2.5", "whole number"]),
    ("geometry that crashes gmsh", ["--set", "Mesh/File=meshes/membrane.geo", "--set",
                                    "Mesh/Parameters=Re: 15"], ["membrane.geo", "gmsh fails"]),
    ("geometry that ends gmsh", ["--set", "Mesh/File={folder}/exit.geo", "--set",
                                 "Mesh/Parameters="], ["exit.geo", "gmsh fails", "exited"]),
    ("no length", ["--set", "Mesh/Parameters=L1: 0"], ["Parameters", "with these"]),
    ("odd number of cells", ["--set", "Mesh/File=meshes/bilayer.geo", "--set",
                             "Mesh/Parameters=n1: 3"], ["'n1'", "multiple of 2"]),
    ("no cell", ["--set", "Mesh/Parameters=n1: 0"], ["'n1'", "at least 1"]),
    ("too many cells", ["--set", "Mesh/Refinements=12"], ["Refinements", "memory", "refine less"]),
    ("solid scene of a plane", ["--set", "Mesh/File={folder}/plane.geo", "--set",
                                "Mesh/Parameters="], ["plane.geo", "Dimension = 2"]),
    ("imperfection without shape", ["--set", "Mesh/Imperfection=0.1"], ["shape", "three"]),
    ("unreadable imperfection", ["--set", "Mesh/Imperfection=0.1",
                                 "--set", "Mesh/Imperfection shape=0; 0; sin(x4)"],
     ["shape", "'sin(x4)'", "x1,x2,x3"]),
    ("imperfection turns cells inside out", ["--set", "Mesh/Imperfection=2",
                                             "--set", "Mesh/Imperfection shape=0; 0; -x3"],
     ["Imperfection", "inverts"]),
    ("endless expectation", ["--set", "Expectations/Final values=e: 1/0"],
     ["Final values", "'1/0' is inf"]),
    ("unreadable expectation", ["--set", "Expectations/Final values=e: theta +"],
     ["Final values", "e", "'theta +'"]),
    ("reaction of an unknown surface",
     ["--set", "Output/Observables=lambda_3, reaction", "--set", "Observables/reaction/At=x9"],
     ["reaction", "'x9'", "x1_min"]),
    ("short circuit", ["--set", "Electrodes/Potential=bottom: 0, top: 1, x1_max: 1"],
     ["command line", "'x1_max'", "'bottom'", "short circuit"]),
    ("body that can move", ["--set", "Supports/Fixed=x1_min: u1, bottom: u3"],
     ["'film'", "along x2", "fix more"]),
    ("body without support", ["--set", "Mesh/File={folder}/two_bodies.geo", "--set",
                              "Mesh/Parameters=", "--set",
                              "Regions/Materials=film: elastomer, loose: elastomer"],
     ["'loose'", "another body"]),
    ("cells inside out", ["--set", "Mesh/File={folder}/bow_tie.geo", "--set", "Mesh/Parameters="],
     ["inverted", "film", "mm"]),
    ("node that lies nowhere", ["--set", "Mesh/File={folder}/nan.msh", "--set", "Mesh/Parameters="],
     ["node 5", "nan.msh", "x2 = nan"]),
    ("node at infinity", ["--set", "Mesh/File={folder}/inf.msh", "--set", "Mesh/Parameters="],
     ["node 5", "inf.msh", "x2 = inf"]),
    ("region without cells", ["--set", "Mesh/File={folder}/unmeshed.geo", "--set",
                              "Mesh/Parameters="],
     ["'film'", "unmeshed.geo", "no cells", "three dimensions"]),
    ("surface without cells", ["--set", "Mesh/File={folder}/stray.geo", "--set",
                               "Mesh/Parameters="], ["'stray'", "no cell"]),
    ("electrode of both kinds", ["--set", "Electrodes/Floating=top: 1"],
     ["Floating", "'top'", "Potential"]),
    ("no ground electrode", ["--set", "Electrodes/Potential=top: 1"], ["ground", "0"]),
    ("no driven electrode", ["--set", "Electrodes/Potential=bottom: 0"],
     ["Potential", "voltage", "multiple"]),
    ("voltage for floating electrodes only",
     ["--set", "Electrodes/Potential=bottom: 0", "--set", "Electrodes/Floating=top: 1"],
     ["Potential", "voltage", "multiple"]),
    ("charge without a floating electrode", ["--set", "Loading/Control=charge", "--set",
                                             "Loading/Target=1 nC"], ["Floating", "charge"]),
    ("ground electrode connected", ["--set", "Loading/Stages=voltage 1, disconnect bottom, "
                                    "connect bottom"], ["'bottom'", "ground", "connect"]),
    ("connected beside another", ["--set", "Loading/Stages=voltage 1, disconnect top, connect top",
                                  "--set", "Electrodes/Potential=bottom: 0, top: 1, other: 1",
                                  "--set", "Mesh/File={folder}/two_films.geo",
                                  "--set", "Mesh/Parameters="],
     ["connect top", "'other'"]),
    ("disconnected but touched", ["--set", "Electrodes/Potential=bottom: 0, top: 1, x1_max: 1",
                                  "--set", "Mesh/File={folder}/tall.geo",
                                  "--set", "Mesh/Parameters=",
                                  "--set", "Loading/Stages=voltage 1, disconnect top"],
     ["disconnect top", "touches another"]),
    ("voltage where charge is controlled",
     ["--set", "Loading/Control=charge", "--set", "Loading/Target=1 nC", "--set",
      "Electrodes/Potential=bottom: 0", "--set", "Electrodes/Floating=top: 1", "--set",
      "Loading/Stages=voltage 1"], ["voltage", "no target", "charge"]),
    ("comment in a value", ["--set", "Mesh/File=a#b.geo"], ["'#'", "comment"]),
    ("endless file name", ["--set", "Mesh/File=" + 300 * "a"], ["there is no file"]),
    ("surroundings of nothing", ["--set", "Heat/Surroundings=top: 300"], ["Heat", "Model"]),
    ("observable without a place", ["--set", "Output/Observables=lambda_3, reaction"],
     ["reaction", "'At'", "missing", "x1_min"]),
    ("free name that Output lacks", ["--set", "Observables/left/Kind=probe",
                                     "--set", "Observables/left/At=top"],
     ["section Observables/left", "does not name it", "add 'left'"]),
    ("free name without a place", ["--set", "Output/Observables=lambda_3, left",
                                   "--set", "Observables/left/Kind=probe"],
     ["section Observables/left, entry 'At'", "missing", "x1_min"]),
    ("two columns of one name", ["--set", "Output/Observables=lambda_3, seconds",
                                 "--set", "Observables/seconds/Kind=lambda_1",
                                 "--set", "Observables/seconds/From=x1_min",
                                 "--set", "Observables/seconds/To=x1_max"],
     ["section Observables/seconds", "another column 'seconds'", "choose another name"]),
    ("stretch between one surface", ["--set", "Observables/lambda_3/To=bottom"],
     ["lambda_3", "'bottom'", "between"]),
    ("force on an unknown surface", ["--set", "Loads/Force=x9: 1 0 0"], ["'x9'", "x1_min"]),
    ("force that no stage applies", ["--set", "Loads/Force=top: 0 0 1"],
     ["Force", "no stage", "force 1"]),
    ("way that no stage goes", ["--set", "Supports/Moved=top: u3 1"],
     ["Moved", "no stage", "move 1"]),
    ("component held and moved",
     ["--set", "Supports/Moved=x1_min: u1 1", "--set", "Loading/Stages=move 1, voltage 1"],
     ["Moved", "'Fixed'", "'x1_min'"]),
    ("branch of no path", ["--set", "Stepping/Branch=plus"], ["Branch", "Continuation"]),
    ("nothing to move", ["--set", "Loading/Stages=move 1"], ["Stages", "Supports", "Moved"]),
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
    ("wall below absolute zero", ["--set", "Temperature/Model=transient",
                                  "--set", "Temperature/Fixed=top: 313",
                                  "--set", "Time/Wall amplitude=-20*t"],
     ["Wall amplitude", "313 K", "at least 1 K"]),
    ("no heat capacity", ["--set", "Temperature/Model=transient",
                          "--set", "Materials/elastomer/Heat capacity=0"],
     ["Heat capacity", "positive", "transient"]),
    ("tetrahedra", ["--set", "Mesh/File={folder}/tetrahedra.geo", "--set", "Mesh/Parameters="],
     ["film", "hexahedra"]),
    ("unreadable geometry", ["--set", "Mesh/File={folder}/broken.geo"], ["broken.geo"]),
    ("unwritable output", ["--output", "/proc/thelma"], ["--output", "/proc/thelma"]),
    ("no output", ["--output", ""], ["--output", "empty"]),
    ("repeated case", ["--sweep", "Temperature/Value=273, 273"], ["Temperature.Value=273", "once"]),
    ("sweep of what is set", ["--sweep", "Temperature/Value=273",
                              "--set", "Temperature/Value=293"], ["Temperature/Value", "once"]),
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
    # Or mpirun waits for a second after the first rank that ends.
    environment = {**os.environ, "OMPI_MCA_odls_base_sigkill_timeout": "0",
                   "PRTE_MCA_odls_base_sigkill_timeout": "0"}
    done = subprocess.run(command, cwd=program.source, capture_output=True, text=True,
                          env=environment, check=False, timeout=60)
    return done.returncode, done.stderr


def check_several(program, folder, all_ranks):
    """All faults of a file at once, each with its line."""
    source = program.source.resolve()
    for scene, expected in (
            (NAMES.format(source=source), OF_NAMES), (VALUES, OF_VALUES),
            (PLANE.format(file=f"{source}/meshes/box.geo"), [(":3,", "`set Dimension = 3`")]),
            (PLANE.format(file="flat.geo"), [(":3,", "x1 and x3")])):
        (folder / "several.prm").write_text(scene, encoding="utf8")
        for ranks in all_ranks:
            code, text = complaint(program, ["--check", f"{folder}/several.prm"], ranks)
            print(f"several at once ({ranks}):\n{text.strip()}")
            require(code == 1, f"exit code {code}, not 1")
            lines = sentences(text)
            require(len(lines) == len(expected), f"{len(lines)} sentences, not {len(expected)}")
            for place, words in expected:
                require(any(place in line and words in line for line in lines),
                        f"no {place} {words}")


def check_other_file(program):
    """Of a file that is no parameter file, not every line is complained about."""
    code, text = complaint(program, ["--check", str(program.binary)], 1)
    lines = sentences(text)
    require(code == 1 and len(lines) == 21 and "more problems" in lines[-1],
            f"exit code {code}, {len(lines)} lines")
    require(text.replace("\n", "").isprintable(), "unprintable characters")


def check_energies(program, folder, all_ranks):
    """Formulas of an elastic law."""
    for (energy, words), ranks in itertools.product(ENERGIES, all_ranks):
        code, text = complaint(program, [
            "prm/verification/own_energy.prm", "--output", f"{folder}/out",
            "--set", f"Materials/elastomer/Energy={energy}"], ranks)
        print(f"energy {energy} ({ranks}): {text.strip()}")
        require(code == 1 and len(sentences(text)) == 1, f"exit code {code}, {len(sentences(text))} lines")
        for word in ["section Materials/elastomer, entry 'Energy'", *words]:
            require(word in text, f"no word of {word}")


def check_cases(program, folder, all_ranks):
    """Every case, several at a time."""
    def answer(run):
        (_, options, _), ranks = run
        arguments = ["nothing.prm"] if options is None else [
            "prm/planar_actuator.prm", "--output", f"{folder}/out",
            *[option.format(folder=folder) for option in options]]
        return complaint(program, arguments, ranks)

    runs = [*itertools.product(READING, all_ranks[:1]), *itertools.product(CASES, all_ranks)]
    with ThreadPoolExecutor(4) as pool:
        answers = list(pool.map(answer, runs))
    for ((name, _, words), ranks), (code, text) in zip(runs, answers):
        lines = sentences(text)
        print(f"{name} ({ranks}): {text.strip()}")
        require(code == 1, f"{name} on {ranks} ranks: exit code {code}, not 1")
        require(len(lines) == 1, f"{name} on {ranks} ranks: {len(lines)} lines, not one")
        for word in words:
            require(word in lines[0], f"{name} on {ranks} ranks: no word of {word}")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "tetrahedra.geo").write_text(TETRAHEDRA)
        (Path(folder) / "broken.geo").write_text("Point(1) = {0, 0\n")
        (Path(folder) / "two_bodies.geo").write_text(TWO_BODIES)
        (Path(folder) / "tall.geo").write_text(TALL)
        (Path(folder) / "two_films.geo").write_text(TWO_FILMS)
        (Path(folder) / "bow_tie.geo").write_text(BOW_TIE)
        (Path(folder) / "stray.geo").write_text(STRAY)
        for number in ("nan", "inf"):
            (Path(folder) / f"{number}.msh").write_text(LOST_NODE.format(number))
        (Path(folder) / "unmeshed.geo").write_text(
            BOX.format(1, 0) + 'Physical Volume("film") = b1[1];\nMesh 2;\n')
        (Path(folder) / "exit.geo").write_text("Exit;\n")
        (Path(folder) / "flat.geo").write_text(FLAT.format("0, 1, 0"))
        (Path(folder) / "plane.geo").write_text(FLAT.format("0, 0, 1"))
        check_several(program, Path(folder), all_ranks)
        check_other_file(program)
        check_energies(program, folder, all_ranks)
        check_cases(program, folder, all_ranks)


main()
