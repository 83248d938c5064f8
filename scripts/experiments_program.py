"""The finite element program on the tests of scripts/experiments: one cell of prm/relaxation.prm."""

import subprocess
import tempfile
from pathlib import Path

import experiments_data as data
import experiments_model as model
from thelma import study

ROOT = Path(__file__).resolve().parents[1]
SCENE = ROOT / "prm/relaxation.prm"
BULK = 1e3  # MPa, beside which the stiffest branch is soft


class ProgramError(Exception):
    """One sentence for the user."""


def material_section(material, name="VHB"):
    """A .prm section."""
    c_0, c_1 = (1e-6 * model.VACUUM * c for c in model.permittivity_law())  # pF/m in N/kV^2
    entries = {"Elastic law": "Arruda-Boyce", "Shear modulus": f"{material.G:.5g} kPa",
               "Locking stretch": f"{material.locking:g}", "Bulk modulus": f"{BULK:g} MPa",
               "Permittivity": f"{c_0:.5g}, {c_1:.5g}", "Reference temperature": f"{model.THETA_R:g}",
               "Branches": ", ".join(["Maxwell"] * len(material.moduli))}
    if material.shift == "Arrhenius":
        shift = {"Activation energy": f"{1e3 * material.constants[0]:.5g}"}
    else:
        shift = {"WLF constants": ", ".join(f"{constant:.5g}" for constant in material.constants)}
    lines = [f"subsection {name}", *section(entries, "  ")]
    for i, (G, tau) in enumerate(zip(material.moduli, material.times), 1):
        branch = {"Modulus": f"{G:.5g} kPa", "Relaxation time": f"{tau:.5g}", "Shift": material.shift,
                  **shift, "Shift temperature": f"{model.THETA_R:g}"}
        lines += [f"  subsection Branch {i}", *section(branch, "    "), "  end"]
    return "\n".join([*lines, "end"])


def section(entries, indent):
    """Lines `set NAME = VALUE`."""
    width = max(map(len, entries))
    return [f"{indent}set {name:{width}} = {value}" for name, value in entries.items()]


def scene(material):
    """prm/relaxation.prm with another material."""
    head, rest = SCENE.read_text(encoding="utf8").split("  subsection VHB\n")
    tail = rest.split("\n  end\n", 1)[1]
    body = "\n".join("  " + line for line in material_section(material).splitlines())
    return f"{head}{body}\n{tail}"


def run(program, text, entries):
    """The curve of a scene."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.prm"
        path.write_text(text, encoding="utf8")
        entries = {"Mesh/File": str(ROOT / "meshes/box.geo"), **entries}
        options = [word for entry in entries.items() for word in ("--set", "=".join(entry))]
        done = subprocess.run([str(program), str(path), *options, "--output", f"{folder}/run"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode:
            raise ProgramError(f"{program} ended with exit code {done.returncode}: {done.stdout[-500:]}")
        return study.Case(Path(folder) / "run").curve("time_s", "lambda_1", "reaction_f1_N")


def motion(test):
    """The entries of a stretch, and of the time that it is held."""
    times = test.knots[0]
    moved = ", ".join(f"{t!r}: {min(i, 1)}" for i, t in enumerate(times))
    return {"Supports/Moved": f"x1_max: u1 {test.stretch - 1!r}", "Time/End": repr(times[-1]),
            "Time/Motion amplitude": moved}


def temperature(celsius):
    """The entries of a temperature."""
    return {"Temperature/Value": repr(model.CELSIUS + celsius)}


def last(curve):
    """Its last nominal stress in kPa."""
    return 1e3 * float(curve["reaction_f1_N"][-1])


def voltage(kilovolts):
    """The entries of the voltage over the thickness of the assumed film, on the cell of 1 mm; switched on
    with the motion."""
    return {"Regions/Passive": "", "Electrodes/Potential": "bottom: 0, top: 1", "Loading/Control": "voltage",
            "Loading/Target": repr(kilovolts / model.THICKNESS), "Loading/Stages": "voltage 1, move 1",
            "Stepping/Static states": "instantaneous"}


def compute(program, fit):
    """What the document and the figures show of the program."""
    rates = {}
    for rate in data.HOSSAIN_PEAKS:
        curve = run(program, SCENE.read_text(encoding="utf8"),
                    motion(model.Test(data.HOSSAIN_STRETCH, rate)))
        rates[f"{rate:g}"] = [[round(float(l), 6), round(1e3 * float(f), 4)]
                              for l, f in zip(curve["lambda_1"], curve["reaction_f1_N"])]
    text = scene(fit.material)
    points = [fit.scale(point.source) * last(run(program, text, {**motion(point.test),
                                                               **temperature(point.celsius)}))
              for point in model.fitted_points()]
    fields = {f"{celsius}": {f"{kV}": round(last(run(program, text, {
        **motion(model.FIELD_TEST), **temperature(celsius), **(voltage(kV) if kV else {})})), 4)
        for kV in stresses} for celsius, stresses in data.MEHNERT_STRESSES.items()}
    return {"rates": rates, "points": [round(value, 4) for value in points], "fields": fields}
