"""Films whose permittivity depends on deformation or saturates, and parameters in tables, against
exact homogeneous states; what lies outside a table.

    dielectrics.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

The exact states are stationary points of the energy of a film with stretches lambda_1 = lambda_2 and
lambda_3 in a nominal field E, written here in stretches and differentiated with complex steps.
"""

import json
import re
import subprocess
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator
from scipy.optimize import minimize_scalar, root

from scene import program_and_ranks, require, sentences, settings, side_by_side, validated
from thelma import planar_exact

VACUUM = 8.8541878e-6  # N/kV^2
K, THETA_0, AREA = 56.552, 293.0, 25.0  # MPa, K, mm^2
STEP = 1e-40  # of complex derivatives
ROWS = (263.0, 280.0, 293.0, 320.0, 353.0)  # K
MU_ROWS = (0.11, 0.075, 0.0566, 0.034, 0.023)  # MPa
EPS_ROWS = (4.2e-5, 4.1e-5, 3.98e-5, 3.9e-5, 3.9e-5)  # N/kV^2


def ideal(eps, stretches, square):
    """Energy of a true field per volume of the deformed film."""
    return eps / 2 * square


def electrostrictive(c_1, c_2):
    """Zhao and Suo's permittivity with squared stretches; the field is along lambda_3."""
    def energy(eps, stretches, square):
        l_1, l_3 = stretches
        return eps / 2 * (1 + c_1 * (l_3**2 - 1) + c_2 * (2 * l_1**2 + l_3**2 - 3)) * square
    return energy


def saturating(p_s):
    """Langevin's dipoles beside the vacuum."""
    def energy(eps, stretches, square):
        chi = eps - VACUUM
        x = 3 * chi * np.sqrt(square) / p_s
        return VACUUM / 2 * square + p_s**2 / (3 * chi) * np.log(np.sinh(x) / x)
    return energy


@dataclass(frozen=True)
class Film:
    """A neo-Hookean film."""

    energy: object  # of the true field
    theta: float = THETA_0
    alpha: float = 0.0
    mu: float = planar_exact.Material().mu(THETA_0)
    eps: float = 3.98e-5

    def psi(self, l_1, l_3, field):
        """Energy per reference volume."""
        s, J = np.exp(-self.alpha * (self.theta - THETA_0)), l_1**2 * l_3
        x = np.log(s**3 * J)
        elastic = self.mu / 2 * (s**2 * (2 * l_1**2 + l_3**2) - 3 - 2 * x) + K / 2 * x**2
        return (self.theta / THETA_0 * elastic
                - J * self.energy(self.eps, (l_1, l_3), (field / l_3) ** 2))

    def slopes(self, l_1, l_3, field):
        """Derivatives of psi with respect to the stretches and the field."""
        here = np.array([l_1, l_3, field], dtype=complex)
        return np.array([self.psi(*(here + 1j * STEP * unit)).imag / STEP for unit in np.eye(3)])

    def unit_field(self):
        """Nominal field of e = 1."""
        return np.sqrt(self.mu / self.eps)

    def state(self, e, near):
        """(lambda_1, lambda_3, charge in uC) in equilibrium at e, near a lambda_3."""
        field = e * self.unit_field()
        found = root(lambda x: self.slopes(*x, field)[:2] / self.mu, (near**-0.5, near), tol=1e-14)
        require(np.abs(found.fun).max() < 1e-9, f"no exact state at e = {e}")
        return (*found.x, -AREA * self.slopes(*found.x, field)[2])

    def field_at(self, l_3):
        """The e at which the film has this lambda_3."""
        unit = self.unit_field()
        found = root(lambda x: self.slopes(x[0], l_3, x[1] * unit)[:2] / self.mu, (l_3**-0.5, 0.6),
                     tol=1e-14)
        return found.x[1] if np.abs(found.fun).max() < 1e-9 else -np.inf

    def pull_in(self):
        """The largest e."""
        return -minimize_scalar(lambda l_3: -self.field_at(l_3), method="bounded",
                                bounds=(0.45, 0.9), options={"xatol": 1e-9}).fun


def table(values):
    """An entry."""
    return ", ".join(f"{theta}: {value}" for theta, value in zip(ROWS, values))


def in_tables(energy, theta):
    """A film whose parameters at theta are those of tables, and its entries."""
    film = Film(energy, theta, 1.8e-4, float(PchipInterpolator(ROWS, MU_ROWS)(theta)),
                float(PchipInterpolator(ROWS, EPS_ROWS)(theta)))
    return film, {"Shear modulus": table(MU_ROWS), "Permittivity": table(EPS_ROWS),
                  "Thermal expansion": "1.8e-4"}


def of_law(law, entry, value):
    """The entries of a dielectric law."""
    return {"Dielectric law": law, entry: value}


FALLING = of_law("electrostrictive", "Electrostriction", "0, -0.02")
ALONG = of_law("electrostrictive", "Electrostriction", "0.3, 0.02")
LIMITED = of_law("saturating", "Saturation polarisation", "2 mC/m^2")
FILMS = {
    "permittivity that falls with stretch": (Film(electrostrictive(0, -0.02)), FALLING),
    "electrostriction along the field": (Film(electrostrictive(0.3, 0.02)), ALONG),
    "saturating": (Film(saturating(2e-3)), LIMITED),
    "tables": in_tables(ideal, 310.0),
    "tables, at the row 280 K": in_tables(ideal, 280.0),
}
for law_name, (law_energy, law_entries) in {
        "electrostrictive": (electrostrictive(0.3, 0.02), ALONG),
        "saturating": (saturating(2e-3), LIMITED)}.items():
    hot, entries_of_tables = in_tables(law_energy, 340.0)
    FILMS[f"{law_name}, tables"] = (hot, {**entries_of_tables, **law_entries})


def check_film(program, folder, name, ranks):
    """Every state of the path to pull-in, the pull-in, and the energy that is stored."""
    film, entries = FILMS[name]
    case = program.run("planar_actuator", folder, *settings(
        {**{f"Materials/elastomer/{entry}": value for entry, value in entries.items()},
         "Temperature/Value": f"{film.theta}", "Expectations/Final values": "",
         "Output/Fields": "none", "Output/Observables": "lambda_3, charge, ledger",
         "Loading/Bracket": "1e-5", "Stepping/Largest step": "0.02"}), ranks=ranks)
    below, above = case.pull_in()
    limit = film.pull_in()
    curve = case.curve("e", "lambda_3", "charge_uC", "ledger_energy_missing_mJ",
                       "ledger_electrode_work_mJ")
    errors, charges = [], []
    for e, l_3, charge in zip(curve["e"], curve["lambda_3"], curve["charge_uC"]):
        if 0 < e < 0.999 * limit:
            exact = film.state(e, l_3)
            errors.append(abs(l_3 - exact[1]))
            charges.append(abs(charge / exact[2] - 1))
    missing = abs(curve["ledger_energy_missing_mJ"][-1] / curve["ledger_electrode_work_mJ"][-1])
    print(f"{ranks} rank(s), {name}: {len(errors)} states, lambda_3 off by {max(errors):.1e}, charge by "
          f"{max(charges):.1e}; pull-in in [{below:.6f}, {above:.6f}], exact {limit:.6f}; "
          f"{missing:.1e} of the work is missing")
    validated("planar_actuator", f"lambda_3, {name}", "exact, homogeneous", max(errors))
    validated("planar_actuator", f"charge, {name}", "exact, homogeneous", max(charges))
    validated("planar_actuator", f"pull-in e, {name}", "exact, homogeneous",
              (below + above) / 2 / limit - 1)
    require(len(errors) > 5 and max(errors) < 1e-8, f"{name}: lambda_3 is off by {max(errors)}")
    require(max(charges) < 1e-8, f"{name}: the charge is off by {max(charges)}")
    require(below - 1e-8 <= limit <= above + 1e-8, f"{name}: pull-in is not in the bracket")
    require(missing < 1e-3, f"{name}: {missing} of the work is missing")


STEADY = {"Temperature/Model": "steady"}


def slab(program, folder, end, entries, exit_code=0, ranks=1):
    """A slab with a wall at 353 K whose shear modulus ends at another temperature."""
    return program.run("verification/slab_heating", folder, *settings(
        {"Output/Fields": "none", "Materials/elastomer/Shear modulus": f"293: 0.05, {end}: 0.02", **entries}),
        exit_code=exit_code, ranks=ranks)


def check_ends_of_tables(program, folder):
    """A table may end at the wall; a source that heats beyond it leads to no state, where the points
    of the last cell are at its end."""
    source = {"Heat/Source": "film: 64"}
    at_wall = slab(program, folder / "wall", 353, STEADY).curve("probe_theta_K")["probe_theta_K"][-1]
    heated = slab(program, folder / "wide", 410, {**STEADY, **source}).curve(
        "probe_theta_K")["probe_theta_K"][-1]
    require(abs(at_wall - 353) < 1e-9 and abs(heated - 403) < 1e-8, f"{at_wall} K and {heated} K")
    print(f"tables to 353 K and 410 K: {at_wall:.6f} K, {heated:.6f} K")


def check_leaving_a_table(program, folder, all_ranks, entries):
    """A run whose body gets hotter than a table ends with the table, its range and the temperature, after the
    states before, alike on all ranks."""
    reasons = []
    for ranks in all_ranks:
        case = slab(program, folder / f"{ranks}", 354, {"Heat/Source": "film: 64", **entries}, 3, ranks)
        last = case.curve("theta_max_K")["theta_max_K"][-1] if not entries else None
        reasons.append(json.loads((folder / f"{ranks}/run.json").read_text())["reason"])
        print(f"{ranks} rank(s), table to 354 K: {reasons[-1]}")
        require(last is None or 353.9 < last < 354.1, f"the last state is at {last} K")
    sentence = re.search(r"section Materials/elastomer, entry 'Shear modulus': the table is from 293 to 354 K, without "
                         r"the (\S+) K of a point in the body; add rows that reach it", reasons[0])
    require(sentence and float(sentence[1]) > 354, "the sentence does not name the table and the temperature")
    require(len(set(reasons)) == 1, "the reasons differ")


def check_errors(program, folder):
    """Temperatures that are known beforehand."""
    for scene, entries, words in (
            ("planar_actuator", {"Temperature/Value": "400"},
             ("'Shear modulus'", "from 293 to 350 K", "400 K of Temperature/Value")),
            ("planar_actuator", {"Materials/elastomer/Reference temperature": "290"},
             ("'Shear modulus'", "290 K of Reference temperature")),
            ("verification/slab_heating", STEADY, ("'Shear modulus'", "353 K of Temperature/Fixed"))):
        command = program.command([f"prm/{scene}.prm", *settings(
            {"Materials/elastomer/Shear modulus": "293: 0.05, 350: 0.02", **entries}), "--output",
            str(folder / "refused")], 1)
        done = subprocess.run(command, cwd=program.source, capture_output=True, text=True, check=False)
        text = " ".join(sentences(done.stderr))
        print(text)
        require(done.returncode == 1, f"exit code {done.returncode}")
        require(all(word in text for word in words), f"not {words}")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    films = [(check_film, name, ranks) for name in FILMS for ranks in all_ranks]
    side_by_side(program, *films, (check_ends_of_tables,), (check_errors,),
                 (check_leaving_a_table, all_ranks, {}), (check_leaving_a_table, all_ranks, STEADY))


main()
