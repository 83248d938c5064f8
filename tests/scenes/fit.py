"""thelma-fit: synthetic tests, integrated by an independent code, give their parameters back; published tests of VHB
are fitted as well as by that code; intervals of confidence hold what is known; bad input gets a sentence.

    fit.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import csv
import subprocess
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from homogeneous_exact import Test
from scene import program_and_ranks, require, validated
from thelma import viscoelastic_exact as exact
from thelma.fitting.data import read_all
from thelma.fitting.fit import fit as least_squares
import experiments_data as data
import experiments_model as model

SHEAR, BRANCHES, K = 15.36, ((26.06, 0.6074), (10.83, 61.25)), 1.5e4  # kPa, s
SCENE = """subsection Regions
  set Materials = film: VHB
end
subsection Materials
  subsection VHB
    set Elastic law     = Arruda-Boyce
    set Shear modulus   = {0} kPa  # free
    set Locking stretch = 5.85
    set Bulk modulus    = 15 MPa
    set Permittivity    = 4.25e-5
    set Branches        = Maxwell, Maxwell
    subsection Branch 1
      set Modulus         = {1} kPa  # free
      set Relaxation time = {2}      # free from 0.01 to 100
    end
    subsection Branch 2
      set Modulus         = {3} kPa  # free
      set Relaxation time = {4} min  # free
    end
  end
end
"""
WLF = """subsection Regions
  set Materials = film: VHB
end
subsection Materials
  subsection VHB
    set Elastic law           = Arruda-Boyce
    set Shear modulus         = 12 kPa  # free
    set Locking stretch       = 5.85
    set Bulk modulus          = 1000 MPa
    set Permittivity          = 4.25e-5
    set Reference temperature = 293.15
    set Branches              = Maxwell, Maxwell, Maxwell
{}  end
end
"""


def synthetic(folder):
    """Twelve tests: cycles and relaxation in three modes, in one file; the true parameters."""
    film = exact.Film(exact.ArrudaBoyce(SHEAR, 5.85), tuple(exact.Branch(*one) for one in BRANCHES), K=K)
    path = folder / "synthetic.csv"
    lines = ["# integrated by DOP853", "test, mode, time_min, stretch, temperature_degC, stress_MPa"]
    for mode in ("uniaxial", "pure shear", "equibiaxial"):
        for kind in (0.01, 0.1, 1.0, "relax"):
            if kind == "relax":
                rows = [(0, 1, 293, 0), (1, 2, 293, 0), *((1 + t, 2, 293, 0) for t in np.geomspace(0.1, 1000, 30))]
            else:
                up = [(s * 1.2 / kind, 1 + 1.2 * s, 293, 0) for s in np.linspace(0, 1, 20)]
                rows = up + [(2.4 / kind - t, *rest) for t, *rest in reversed(up[:-1])]
            stresses = Test(film, mode, np.array(rows, float)).in_time()
            for (t, stretch, theta, _), stress in zip(rows, stresses):
                lines.append(f"{mode} {kind}, {mode}, {t / 60!r}, {float(stretch)!r}, {theta - 273.15!r}, "
                             f"{1e-3 * stress if t else ''!r}".replace("''", ""))
    path.write_text("\n".join(lines) + "\n")
    return path


def fit(program, *arguments, exit_code=0):
    """What scripts/fit prints."""
    done = subprocess.run([sys.executable, str(program.source / "scripts/fit"), *map(str, arguments), "--program",
                           program.binary], text=True, capture_output=True, check=False)
    require(done.returncode == exit_code, f"exit code {done.returncode}: {done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def parameters(folder):
    """Name -> (value, low, high)."""
    with open(folder / "parameters.csv", newline="", encoding="utf8") as file:
        return {row["parameter"]: tuple(float(row[name]) for name in ("value", "low", "high"))
                for row in csv.DictReader(file)}


def check_synthetic(program, folder):
    """Five parameters, from starting values that are off by factors, from twelve curves."""
    table, scene = synthetic(folder), folder / "start.prm"
    scene.write_text(SCENE.format(30, 10, 2, 30, 0.3))
    started = time.perf_counter()
    print(fit(program, scene, table, "--output", folder / "found"))
    seconds = time.perf_counter() - started
    found = parameters(folder / "found")
    known = {"Shear modulus": SHEAR, "Branch 1/Modulus": BRANCHES[0][0], "Branch 1/Relaxation time": BRANCHES[0][1],
             "Branch 2/Modulus": BRANCHES[1][0], "Branch 2/Relaxation time": BRANCHES[1][1] / 60}
    require(found.keys() == known.keys(), f"{list(found)}")
    worst = max(abs(found[name][0] / value - 1) for name, value in known.items())
    print(f"12 curves, 5 parameters: {seconds:.1f} s, largest error {worst:.1e}")
    validated("fit", "five parameters from twelve synthetic curves", "exact, homogeneous", worst)
    require(worst < 1e-6, f"a parameter is off by {worst}")
    require(seconds < 60, f"{seconds} s")
    # The fitted scene reads back, and is not free any more.
    text = (folder / "found/scene.prm").read_text()
    require("free" not in text and "no parameter is free" in fit(program, folder / "found/scene.prm", table,
                                                                 exit_code=1), "the fitted scene is free")
    section = (folder / "found/material.prm").read_text()
    require(section.startswith("subsection VHB\n") and section.endswith("\nend\n"), section)
    require((folder / "found/fit.png").stat().st_size > 1e4, "no figure")


def check_confidence(program, folder):
    """Of 20 samples of noise, most intervals of 95 % hold the true modulus of a neo-Hookean film."""
    stretches, random, held = np.linspace(1.1, 3, 15), np.random.default_rng(1), 0
    film = exact.Film(exact.NeoHookean(20.0), K=2e4)
    scene = folder / "neo.prm"
    scene.write_text("subsection Regions\n  set Materials = film: rubber\nend\nsubsection Materials\n  subsection "
                     "rubber\n    set Shear modulus = 1 kPa # free\n    set Bulk modulus = 20 MPa\n  end\nend\n")
    stress = Test(film, "uniaxial", np.array([(0, l, 293, 0) for l in stretches])).relaxed()
    for _ in range(20):
        noisy = stress + 0.5 * random.standard_normal(len(stress))
        (folder / "noisy.csv").write_text("stretch,stress_kPa\n" + "".join(
            f"{l},{p}\n" for l, p in zip(stretches, noisy)))
        found = least_squares(program.binary, scene, read_all([folder / "noisy.csv"]))
        (low,), (high,) = found.low, found.high
        # Linear in the modulus: a regression through the origin, with Student's t for 14.
        slope = stress / 20
        best = np.sum(slope * noisy) / np.sum(slope**2)
        width = 2.14479 * np.sqrt(np.sum((noisy - best * slope)**2) / 14 / np.sum(slope**2))
        require(abs(low - best + width) < 0.01 * width and abs(high - best - width) < 0.01 * width,
                f"interval {low} to {high}, of a regression {best} +- {width}")
        held += low < 20 < high
    print(f"{held} of 20 intervals hold the true modulus")
    require(held >= 17, f"only {held} of 20")


def peaks(path):
    """The published peaks of VHB 4905 as a CSV file: two rows each, of which the first is not measured."""
    lines = ["test, time_s, stretch, temperature_degC, stress_kPa"]
    for point in model.fitted_points():
        if point.set == model.LIAO:
            name = f"{point.test.rate} per s at {point.celsius} C"
            for t, stretch, stress in zip(*point.test.knots, ("", point.stress)):
                lines.append(f"{name}, {t!r}, {stretch}, {point.celsius}, {stress}")
    path.write_text("\n".join(lines) + "\n")


def check_published(program, folder):
    """Equilibrium, three branches and their shift from the peaks of VHB 4905, beside the stored fit of
    scripts/experiments to the same numbers, which uses incompressible histories of another code."""
    fits, _ = model.read(program.source / "doc/experiments.json")
    stored, = (one for one in fits if one.name.endswith("VHB 4905 alone"))
    scene, table = folder / "vhb.prm", folder / "vhb.csv"
    branches = "".join(f"""    subsection Branch {i}
      set Modulus           = {modulus} kPa  # free
      set Relaxation time   = {tau}  # free
      set Shift             = WLF
      set WLF constants     = 6, 110  # free as WLF
      set Shift temperature = 293.15
    end
""" for i, (modulus, tau) in enumerate(((1000, 0.1), (50, 10), (10, 1000)), 1))
    scene.write_text(WLF.format(branches))
    peaks(table)
    started = time.perf_counter()
    print(fit(program, scene, table, "--output", folder / "vhb"))
    print(f"{time.perf_counter() - started:.1f} s")
    found = parameters(folder / "vhb")
    with open(folder / "vhb/stresses.csv", newline="", encoding="utf8") as file:
        rows = [row for row in csv.DictReader(file) if row["measured"]]
    own = model.rms([float(row["fitted"]) / float(row["measured"]) - 1 for row in rows])
    points = [point for point in model.fitted_points() if point.set == model.LIAO]
    known = model.rms([stored.model(point) / point.stress - 1 for point in points])
    print(f"rms {100 * own:.2f} %, of the stored fit {100 * known:.2f} %")
    require(own < 1.001 * known, "not as good as the stored fit")
    material = model.Material(found["Shear modulus"][0], tuple(found[f"Branch {i}/Modulus"][0] for i in (1, 2, 3)),
                              tuple(found[f"Branch {i}/Relaxation time"][0] for i in (1, 2, 3)), "WLF",
                              (found["WLF [1]"][0], found["WLF [2]"][0]))
    worst = max(abs(float(row["fitted"]) / point.test.stress(material.film(point.celsius)) - 1)
                for row, point in zip(rows, points))
    validated("fit", "peaks of VHB 4905 by the fitted material", "exact, homogeneous, incompressible", worst)
    require(worst < 2e-3, f"the fitted material has stresses that are off by {worst}")


def check_complaints(program, folder):
    """One sentence for what a user can mend."""
    scene, table = folder / "bad.prm", folder / "bad.csv"
    good = SCENE.format(30, 10, 2, 30, 0.3)
    rows = "stretch,stress_kPa,time_s\n1,0,0\n2,30,10\n2,25,20\n2,24,30\n2,23,40\n2,22,50\n"
    for text, csv_text, sentence in (
            (good, rows.replace("stress_kPa", "stress"), "the column stress has no unit; write stress_kPa"),
            (good, rows.replace("stress_kPa", "stres_kPa"), "unknown column 'stres_kPa'; did you mean 'stress'?"),
            (good, rows.replace("stress_kPa", "stress_kV"), "is a voltage but must be a pressure"),
            (good, rows.replace("2,25,20", "2,25"), "bad.csv:4: 2 cells in place of 3"),
            (good, rows.replace("2,25,20", ",25,20"), "bad.csv:4, column stretch is empty"),
            (good, rows.replace("2,25,20", "2,x,20"), "'x' is no number"),
            (good, rows.replace("2,25,20", "2,25,2"), "test 'bad', row 3: the time is before"),
            (good, "stretch,stress_kPa,mode\n2,1,uniaxal\n" * 1, "cannot be found from 1 stresses"),
            (good, "stretch,stress_kPa\n", "it has no data"),
            (good, rows.splitlines()[0] + "\n1,0,0\n", "the test 'bad' has no stress"),
            (good.replace("# free", "#"), rows, "no parameter is free; write `# free`"),
            (good.replace("# free from 0.01 to 100", "# free from 10 to 100"), rows, "is not between the bounds"),
            (good.replace("# free from 0.01 to 100", "# free between 10"), rows, "is not understood; write `# free`"),
            (good.replace("Arruda-Boyce", "Arruda-Boyce # free"), rows, "only numbers can be free"),
            (good.replace("film: VHB", "film: VHB # free"), rows, "only a material can be fitted"),
            (good.replace("30 kPa", "-30 kPa"), rows, "entry 'Shear modulus': the value is -0.03"),
            (good.replace("Locking stretch", "Looking stretch"), rows, "did you mean 'Locking stretch'?")):
        scene.write_text(text)
        table.write_text(csv_text)
        said = fit(program, scene, table, "--output", folder / "bad", exit_code=1)
        require(sentence in said and len(said.splitlines()) == 1, f"not '{sentence}': {said}")
    scene.write_text(good)
    table.write_text("stretch,stress_kPa\n1,0\n1.5,15\n2,30\n2.5,42\n3,55\n4,90\n")  # at rest: no branch is felt
    said = fit(program, scene, table, "--output", folder / "bad")
    require("do not determine Branch 1/Modulus, Branch 1/Relaxation time, Branch 2/Modulus, " in said, said)
    require("cannot read this parameter file" in fit(program, folder / "nowhere.prm", table, exit_code=1), "no file")
    require("cannot read these test data" in fit(program, scene, folder / "nowhere.csv", exit_code=1), "no data")
    scene.write_text(good)
    table.write_text(rows)
    other = folder / "other.csv"
    other.write_text(rows.replace("kPa", "MPa"))
    require("stress is in MPa and kPa" in fit(program, scene, table, other, exit_code=1), "two units")
    require("both are named 'bad'" in fit(program, scene, table, table, exit_code=1), "one name twice")


def main():
    """All of it, in one process each."""
    program, _ = program_and_ranks(__doc__)
    program = replace(program, binary=str(Path(program.binary).resolve()), source=program.source.resolve())
    with tempfile.TemporaryDirectory() as name:
        for check in (check_complaints, check_synthetic, check_confidence, check_published):
            check(program, Path(name))


main()
