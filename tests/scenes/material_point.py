"""thelma --material-point: stresses of homogeneous tests against exact ones, and what it says of bad requests.

    material_point.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import json
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

from homogeneous_exact import Test
from scene import program_and_ranks, require, validated
from thelma import viscoelastic_exact as exact
from thelma.errors import ThelmaError
from thelma.material_point import MaterialPoint

TOLERANCE = 1e-8  # of the largest stress
EPS = 4.25e-2  # kPa/(kV/mm)^2
THETA_0 = 293.0
HOT = exact.Branch(26.06, exact.arrhenius(0.6074, 50e3, THETA_0)), exact.Branch(10.83, exact.wlf(
    61.25, 5.0, 100.0, THETA_0))
VHB = exact.vhb(5.85, K=exact.STIFF, eps=EPS)
FILMS = {
    "VHB": (VHB, """
    set Elastic law     = Arruda-Boyce
    set Shear modulus   = 15.36 kPa
    set Locking stretch = 5.85
    set Bulk modulus    = 15.36 MPa
    set Permittivity    = 4.25e-5
    set Branches        = Maxwell, Maxwell, Maxwell
    subsection Branch 1
      set Modulus         = 26.06 kPa
      set Relaxation time = 0.6074
    end
    subsection Branch 2
      set Modulus         = 26.53 kPa
      set Relaxation time = 6.56
    end
    subsection Branch 3
      set Modulus         = 10.83 kPa
      set Relaxation time = 61.25
    end"""),
    "warm": (exact.Film(exact.Gent(20.0, 50.0), HOT, K=2e4, eps=EPS, alpha=2e-4), """
    set Elastic law       = Gent
    set Shear modulus     = 20 kPa
    set Gent limit        = 50
    set Bulk modulus      = 20 MPa
    set Permittivity      = 4.25e-5
    set Thermal expansion = 2e-4
    set Branches          = Maxwell, Maxwell
    subsection Branch 1
      set Modulus           = 26.06 kPa
      set Relaxation time   = 0.6074
      set Shift             = Arrhenius
      set Activation energy = 50e3
    end
    subsection Branch 2
      set Modulus         = 10.83 kPa
      set Relaxation time = 61.25
      set Shift           = WLF
      set WLF constants   = 5, 100
    end"""),
}


def scene(folder):
    """A parameter file with both materials, and a section that no material has."""
    path = folder / "materials.prm"
    sections = "".join(f"  subsection {name}{text}\n  end\n" for name, (_, text) in FILMS.items())
    path.write_text("subsection Mesh\n  set File = nowhere.geo\nend\nsubsection Regions\n  set Materials = a: VHB, "
                    f"b: warm\nend\nsubsection Materials\n{sections}end\n")
    return path


def request(name, mode, rows, in_time=True):
    """The program's test of rows (t, stretch, theta, e)."""
    time_s, stretch, theta, field = np.array(rows, float).T.tolist()
    columns = {"stretch": {"values": stretch}, "temperature": {"unit": "K", "values": theta},
               "field": {"unit": "kV/mm", "values": field}}
    if in_time:
        columns["time"] = {"unit": "s", "values": time_s}
    return {"name": name, "mode": mode, "columns": columns, "stress unit": "kPa"}


def cycle(rate, peak, theta=THETA_0, field=0.0, n=20, hold=0.0):
    """Rows of a triangle, held at its peak for a while."""
    rise = (peak - 1) / rate
    up = [(rise * s, 1 + (peak - 1) * s, theta, field) for s in np.linspace(0, 1, n)]
    down = [(2 * rise + hold - t, stretch, *rest) for t, stretch, *rest in reversed(up)]
    return up + down


def tests():
    """(title, material, mode, rows, in time)."""
    for rate in (0.01, 0.05, 1.0):
        yield f"cycle at {rate} /s", "VHB", "uniaxial", cycle(rate, 2.5), True
    yield "two rows", "VHB", "uniaxial", [(0, 1, THETA_0, 0), (300, 4, THETA_0, 0)], True
    relax = [(0, 1, THETA_0, 0), (0, 2, THETA_0, 0), *((t, 2, THETA_0, 0) for t in np.geomspace(0.01, 500, 16))]
    for mode in ("uniaxial", "pure shear", "equibiaxial"):
        yield f"relaxation, {mode}", "VHB", mode, relax, True
        yield f"equilibrium, {mode}", "warm", mode, [(0, stretch, 330.0, 1.0) for stretch in
                                                     np.linspace(0.7, 3.0, 12)], False
        heated = [(t, stretch, THETA_0 + 40 * t / 100, 4 * min(1, t / 20)) for t, stretch, *_ in
                  cycle(0.03, 2.0, hold=20.0)]
        yield f"heated, charged cycle, {mode}", "warm", mode, heated, True
    cold = [(t, stretch, 263.0, 0.0) for t, stretch, *_ in cycle(0.1, 2.0)]
    yield "cold cycle", "warm", "uniaxial", [(0, 1, THETA_0, 0), *cold], True


def check_exact(point):
    """Every test."""
    for title, material, mode, rows, in_time in tests():
        started = time.perf_counter()
        (values,), = point.stresses([request(title, mode, rows, in_time)], material=material)
        seconds = time.perf_counter() - started
        test = Test(FILMS[material][0], mode, np.array(rows, float))
        known = test.in_time() if in_time else test.relaxed()
        error = np.max(np.abs(values - known)) / np.max(np.abs(known))
        print(f"{material}, {title}: {len(rows)} rows, largest stress {np.max(np.abs(known)):.3f} kPa, error "
              f"{error:.1e} of it, {1e3 * seconds:.1f} ms")
        validated("material point", f"stress, {material}, {title}", "exact, homogeneous", error)
        require(error < TOLERANCE, f"off by {error}")


def check_complaints(point):
    """Clear sentences, after each of which the program goes on."""
    rows = [(0, 1, THETA_0, 0), (1, 2, THETA_0, 0)]
    good = request("pull", "uniaxial", rows)

    def changed(column, **what):
        return {**good, "columns": {**good["columns"], column: {**good["columns"][column], **what}}}

    for tests, sets, material, sentence in (
            ([good], [()], "", "name the one that is tested"),
            ([good], [()], "VBH", "unknown material 'VBH'; did you mean 'VHB'?"),
            ([{**good, "mode": "uniaxal"}], [()], "VHB", "did you mean 'uniaxial'?"),
            ([changed("stretch", values=[1, -2])], [()], "VHB", "row 2: the stretch is -2 but must be positive"),
            ([changed("time", values=[1, 0])], [()], "VHB", "the time is before that of the row above"),
            ([changed("time", values=[1])], [()], "VHB", "the columns stretch and time are not of one length"),
            ([changed("temperature", unit="kPa")], [()], "VHB", "is a pressure but must be a temperature"),
            ([changed("temperature", values=[-300, 20], unit="degC")], [()], "VHB", "above absolute zero"),
            ([changed("field", values=[0, 90])], [()], "VHB", "test 'pull', row 2: no stable equilibrium"),
            ([good], [["Materials/VHB/Shear modulus=-1"]], "VHB", "must be positive"),
            ([good], [["Materials/VHB/Shear modulos=1"]], "VHB", "did you mean 'Shear modulus'?"),
            ([good], [["Shear modulus"]], "VHB", "is not of the form Section/Entry=value")):
        answer, = point.stresses(tests, sets, material)
        require(isinstance(answer, ThelmaError) and sentence in str(answer), f"not '{sentence}': {answer}")
    answers = point.stresses([good], [(), ["Materials/VHB/Shear modulus=-1"], ()], "VHB")
    require(answers[0] == answers[2] and isinstance(answers[1], ThelmaError), f"{answers}")
    point.process.stdin.write("{\n")
    point.process.stdin.flush()
    require("not understood" in json.loads(point.process.stdout.readline())["error"], "no JSON, no sentence")


def check_ranks(program, path, ranks):
    """One rank answers; a scene that cannot be read ends all with one sentence."""
    done = subprocess.run(program.command(["--material-point", str(path)], ranks), text=True, check=False,
                          input='{"tests": []}\n', capture_output=True, cwd=program.source)
    answers = [json.loads(line) for line in done.stdout.splitlines()]
    require(done.returncode == 0 and len(answers) == 1, f"{done.returncode}, {done.stdout}, {done.stderr}")
    bad = path.with_name("bad.prm")
    bad.write_text(path.read_text().replace("Gent limit", "Gent limut"))
    done = subprocess.run(program.command(["--material-point", str(bad)], ranks), text=True, check=False,
                          input="", capture_output=True, cwd=program.source)
    require(done.returncode == 1 and done.stderr.count("unknown entry 'Gent limut'") == 1, f"{done.returncode}, {done.stderr}")


def main():
    """All of it."""
    program, ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as name:
        path = scene(Path(name))
        with MaterialPoint(Path(program.binary).resolve(), path) as point:
            check_exact(point)
            check_complaints(point)
        for n in ranks:
            check_ranks(program, path, n)


main()
