"""Viscoelastic films against their exact histories: stretched, left to relax, charged until they
pull in, at once or after a delay.

    viscoelastic.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import functools
import json
import math
from dataclasses import replace

import numpy as np

from scene import program_and_ranks, require, settings, side_by_side, validated
from thelma import viscoelastic_exact as exact

K = exact.STIFF  # kPa
PEAK = 2.5
ELEMENTS = (("selective reduced", 1), ("mean dilatation", 1), ("enhanced strain", 1),
            ("mean dilatation", 2))


@functools.lru_cache
def tension(rate):
    """A triangle of the stretch of VHB 4910."""
    return exact.uniaxial(exact.vhb(5.85, K=K), rate, PEAK)


def element(formulation, degree):
    """The entries that choose it."""
    return {"Discretisation/Formulation": formulation, "Discretisation/Degree": str(degree)}


def triangle(rate):
    """The entries of a cycle, up to the peak and back."""
    time = (PEAK - 1) / rate
    return {"Time/End": repr(2 * time), "Time/Motion amplitude": f"0: 0, {time!r}: 1, {2 * time!r}: 0"}


def history(program, folder, entries, *columns, ranks=1):
    """Columns of a run of the strip after time 0, that of the time first."""
    curve = program.run("relaxation", folder / "run", *settings(entries), ranks=ranks).curve(
        "time_s", *columns)
    in_time = np.concatenate([[False], np.diff(curve["time_s"]) > 0])
    return [curve[name][in_time] for name in ("time_s", *columns)]


def stretch(program, folder, entries, ranks=1):
    """Times and stresses in kPa of a run of the strip."""
    times, forces = history(program, folder, entries, "reaction_f1_N", ranks=ranks)
    return times, 1e3 * forces


def check_cycle(program, folder, rate, formulation, degree, ranks):
    """Every state of a cycle at the default tolerance, and the work that is lost in it."""
    times, stresses = stretch(program, folder, {**triangle(rate), **element(formulation, degree)}, ranks)
    test = tension(rate)
    peak = test.stress(test.times[1])
    worst = max(abs(s - test.stress(t)) for t, s in zip(times, stresses)) / peak
    top = stresses[np.argmin(abs(times - test.times[1]))]
    print(f"{formulation}, degree {degree}, {ranks} rank(s), {rate} /s: {len(times)} steps, peak {top:.3f} kPa "
          f"(exact {peak:.3f}), largest error {worst:.1e} of it")
    validated("relaxation", f"stress in a cycle at {rate} /s, {formulation}, degree {degree}",
              "exact, homogeneous", worst)
    require(worst < 2e-3, f"a stress is off by {worst}")


def check_order(program, folder, scheme, order):
    """The stress at the peak, by steps of one length."""
    test, rate = tension(0.05), 0.05
    errors = []
    for n in (40, 80, 160):
        time = (PEAK - 1) / rate
        times, stresses = stretch(program, folder, {
            "Time/End": repr(time), "Time/Motion amplitude": f"0: 0, {time!r}: 1", "Time/Scheme": scheme,
            "Time/Initial step": repr(time / n), "Time/Strain tolerance": "0"})
        require(len(times) == n, f"{len(times)} steps, not {n}")
        errors.append(abs(stresses[-1] / test.stress(times[-1]) - 1))
    orders = [math.log2(a / b) for a, b in zip(errors, errors[1:])]
    print(f"{scheme}: errors {' '.join(f'{error:.2e}' for error in errors)}, orders "
          f"{' '.join(f'{one:.2f}' for one in orders)}")
    require(abs(orders[-1] - order) < 0.2, f"not of order {order}")


def dissipated(test, end):
    """Energy in kPa that flow dissipates while a strip keeps its stretch from time 0 on."""
    times = np.concatenate([[0], np.geomspace(1e-9 * end, end, 20001)])
    film, x, powers = test.film, math.log(test.stretches[0]), []
    for t in times:
        a = test.values(t)[0]
        w = film.elastic_strain(x, film.lateral(x, a), a)
        powers.append(sum(film.G / (3 * film.tau) * (np.exp(2 * w) - np.exp(-w))**2))
    return float(np.sum(np.diff(times) * (np.array(powers[1:]) + powers[:-1]) / 2))


def check_relaxation(program, folder):
    """A strip stretched at once relaxes over five decades of time, in few steps, and makes heat of what its
    branches have stored."""
    end, film = 1e3, exact.vhb(5.85, K=K)
    times, forces, heats = history(program, folder, {
        "Stepping/Static states": "instantaneous", "Time/Motion amplitude": "1", "Time/End": repr(end),
        "Time/Initial step": "0.01", "Output/Observables": "lambda_1, reaction, ledger"},
        "reaction_f1_N", "ledger_dissipated_mJ")
    stresses = 1e3 * forces
    test = exact.stretched(film, (0, end), (PEAK, PEAK))
    heat = 1e-3 * dissipated(test, end)
    error = heats[-1] / heat - 1
    print(f"dissipated {heats[-1]:.6f} mJ (exact {heat:.6f}, error {error:.1e})")
    validated("relaxation", "dissipated over five decades", "exact, homogeneous", error)
    require(abs(error) < 1e-3, f"what is dissipated is off by {error}")
    known = [test.stress(t) for t in times]
    worst = max(abs(stresses / known - 1))
    print(f"relaxation to {end} s in {len(times)} steps, the first after {times[0]:.4f} s: {stresses[0]:.2f} to "
          f"{stresses[-1]:.2f} kPa, largest relative error {worst:.1e}")
    validated("relaxation", "stress over five decades", "exact, homogeneous", worst)
    require(len(times) < 60, "too many steps")
    require(worst < 1e-3, f"a stress is off by {worst}")


def pull_in(program, folder, scene, entries):
    """Time, e and lambda_3 of the last state of a run that is to pull in, and the sentence."""
    case = program.run(scene, folder / "run", *settings(entries))
    curve = case.curve("time_s", "e", "lambda_3", "event")
    require(curve["event"][-1] == "pull-in", "no pull-in")
    reason = json.loads((folder / "run" / "run.json").read_text())["reason"]
    return curve["time_s"][-1], curve["e"][-1], curve["lambda_3"][-1], reason


def check_rate(program, folder, rate, formulation, degree):
    """Pull-in of the free film under a voltage that rises at `rate` sqrt(G/eps) H per second."""
    time, _, thickness, reason = pull_in(program, folder, "pull_in_rate", {
        "Time/Voltage amplitude": f"{rate}*t", "Time/End": repr(2 / rate), **element(formulation, degree)})
    path = exact.ramped(exact.vhb(K=K), rate * math.sqrt(exact.G_VHB))
    error = time / path.t - 1
    print(f"{formulation}, degree {degree}, ramp {rate} /s: {reason}; phi* {rate * time:.5f} (exact "
          f"{path.field / math.sqrt(exact.G_VHB):.5f}), lambda_3 {thickness:.4f} ({path.thickness:.4f})")
    validated("pull_in_rate", f"field at pull-in, ramp {rate} /s, {formulation}, degree {degree}",
              "exact, homogeneous", error)
    require(abs(error) < 2e-3, f"the pull-in is off by {error}")


def check_delay(program, folder, field):
    """Pull-in of a film under a field in units of that of its equilibrium."""
    time, *_, reason = pull_in(program, folder, "delayed_pull_in", {
        "Loading/Target": repr(field * exact.UNIT_FIELD), "Time/End": "50"})
    known = exact.held(exact.unit_film(K=1e3), field * exact.UNIT_FIELD, 100).t
    print(f"e = {field}: {reason} (exact {known:.5f}, error {time / known - 1:.1e})")
    validated("delayed_pull_in", f"delay at {field} e_c", "exact, homogeneous", time / known - 1)
    require(abs(time / known - 1) < 2e-3, f"the delay is off by {time / known - 1}")


def check_adiabatic(program, folder, coupling, tolerance):
    """An insulated strip that is stretched and released warms: all its energies are entropic, so that
    c ln(theta/theta_0) is its work at the reference temperature over theta_0, lost or stored. Solved
    for one after the other, the fields are apart by an extrapolation over a step."""
    capacity, theta_0, rate = 1e-3, 293, 0.05  # MPa/K: a thousandth of that of rubber
    test = tension(rate)
    missing = []
    for n in (60, 120, 240):
        time = (PEAK - 1) / rate
        times, thetas, energy, entropy, heats = history(program, folder, {
            **triangle(rate), "Time/Initial step": repr(time / n), "Time/Strain tolerance": "0",
            "Time/Tolerance": "0", "Time/Structural heat": "entropy", "Time/Coupling": coupling,
            "Temperature/Model": "transient", "Temperature/Value": str(theta_0),
            "Materials/VHB/Heat capacity": str(capacity),
            "Output/Observables": "lambda_1, reaction, ledger", "Output/Fields": "none"},
            "theta_K", "ledger_energy_missing_mJ", "ledger_entropy_missing_mJ_per_K", "ledger_dissipated_mJ")
        known = [theta_0 * math.exp(1e-3 * test.work(t) / (capacity * theta_0)) for t in times]
        missing.append((max(abs(thetas - known)), abs(energy[-1]), abs(entropy[-1])))
        warmest, dissipated_mJ = max(thetas), heats[-1]
    orders = [math.log2(a / b) for a, b in zip(missing[-2], missing[-1])]
    print(f"{coupling}: the strip warms to {warmest:.3f} K (exact {max(known):.3f}), dissipates {dissipated_mJ:.5f} mJ; "
          f"errors of temperature, energy, entropy {' '.join(f'{m:.1e}' for m in missing[-1])}, orders "
          f"{' '.join(f'{one:.2f}' for one in orders)}")
    validated("relaxation, insulated", f"temperature in a cycle, {coupling}", "exact, homogeneous", missing[-1][0])
    require(missing[-1][0] < tolerance * (warmest - theta_0), "the temperature is off")
    require(min(orders) > 1.6, "not of second order")


def check_never(program, folder):
    """Below the pull-in of its equilibrium the film comes to rest."""
    curve = program.run("delayed_pull_in", folder / "run", *settings({
        "Loading/Target": repr(0.99 * exact.UNIT_FIELD), "Loading/Expected end": "target",
        "Time/End": "1000"})).curve("time_s")
    require(curve["time_s"][-1] == 1000, "the film did not reach the end")


def check_fast(program, folder, number):
    """Near the limit of its equilibrium a film comes to rest in it, however short its relaxation time,
    however long the first step and whether the voltage jumps at the start or later."""
    draw = np.random.default_rng(number)
    film = replace(exact.unit_film(K=1e3), branches=())
    field = (1 - 10**draw.uniform(-3, -1)) * exact.instantaneous_limit(film).field
    start = draw.uniform(0.1, 5)
    entries = {
        "Materials/VHB/Branch 1/Relaxation time": repr(10**draw.uniform(-9, -2)),
        "Time/Initial step": repr(10**draw.uniform(-2, 1)), "Time/End": "30",
        "Time/Strain tolerance": str(draw.choice(["0", "1e-3", "1e-2"])),
        "Time/Scheme": str(draw.choice(["BDF2", "backward Euler"])),
        "Time/Voltage amplitude": str(draw.choice(
            ["1", f"t > {start}", f"0.5 + 0.5*(t > {start})", f"0: 0, {start}: 0, {start + 1e-6}: 1, 30: 1"])),
        "Loading/Target": repr(field), "Loading/Expected end": "target", **element(*ELEMENTS[number % 4])}
    curve = program.run("delayed_pull_in", folder / "run", *settings(entries)).curve("lambda_3")
    error = curve["lambda_3"][-1] / exact.at_once(film, field).thickness - 1
    print(f"{', '.join(value for value in entries.values())}: error of lambda_3 at rest {error:.1e}")
    require(abs(error) < 1e-6, f"lambda_3 at rest is off by {error}")


def check_jump(program, folder, number):
    """A film that has crept, whose voltage jumps past what it bears at once, pulls in at the jump;
    after one to a little less it creeps on first."""
    draw = np.random.default_rng(100 + number)
    tau, start = 10**draw.uniform(-0.5, 1), draw.uniform(0.01, 9)
    low = draw.uniform(0, 0.8) * exact.UNIT_FIELD
    film = replace(exact.unit_film(K=1e3), branches=(exact.Branch(1.0, tau),))
    charged = exact.held(film, low, start + 1)
    limit = exact.raised(charged, start).field
    entries = {"Materials/VHB/Branch 1/Relaxation time": repr(tau), "Time/Strain tolerance": "1e-5",
               "Time/Initial step": repr(10**draw.uniform(-4, 0)),
               "Time/Scheme": str(draw.choice(["BDF2", "backward Euler"])), **element(*ELEMENTS[number % 4])}
    for part in (draw.uniform(1.01, 2), 0.95):
        high = part * limit
        now = {**entries, "Loading/Target": repr(high), "Time/End": "100",
               "Time/Voltage amplitude": f"{low / high!r} + {1 - low / high!r}*(t > {start!r})"}
        time, field, _, reason = pull_in(program, folder, "delayed_pull_in", now)
        print(f"{', '.join(now.values())}: {reason}")
        if part > 1:
            print(f"  exact {start:.5f} s, e = {limit:.6f}, error {field / limit - 1:.1e}")
            require(abs(time - start) < 2e-7 and abs(field - limit) < 1e-4 * high, "not where it pulls in")
        else:
            delay = exact.held_after(exact.raised(charged, start, high), 200).t
            print(f"  exact {start + delay:.5f} s, error {time - start - delay:.1e} s")
            require(abs(time - start - delay) < 5e-3 * delay, "not when it pulls in")


def check_limits(program, folder):
    """Static pull-in with relaxed branches, and with branches that had no time."""
    for states, film in (("relaxed", exact.equilibrium_limit), ("instantaneous", exact.instantaneous_limit)):
        case = program.run("delayed_pull_in", folder / states, *settings({
            "Stepping/Static states": states, "Loading/Target": "1.5", "Time/Analysis": "automatic"}))
        low, high = case.pull_in()
        known = film(exact.unit_film(K=1e3)).field
        print(f"{states}: pull-in between e = {low:.6f} and {high:.6f} (exact {known:.6f})")
        require(low - 1e-6 < known < high + 1e-6, f"the pull-in at {known} is outside")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    cycles = [(check_cycle, 0.03, *one, 1) for one in ELEMENTS]
    cycles += [(check_cycle, rate, "mean dilatation", 1, ranks)
               for rate in (0.01, 0.05) for ranks in all_ranks]
    ramps = [(check_rate, rate, *ELEMENTS[1]) for rate in (0.1, 1)]
    ramps += [(check_rate, 1, *one) for one in (ELEMENTS[0], ELEMENTS[2], ELEMENTS[3])]
    side_by_side(program, *cycles, (check_order, "backward Euler", 1), (check_order, "BDF2", 2),
                 (check_relaxation,), *ramps, *((check_delay, e) for e in (1.02, 1.1, 1.3, 1.4)),
                 (check_never,), *((check_fast, number) for number in range(12)),
                 *((check_jump, number) for number in range(8)), (check_limits,),
                 (check_adiabatic, "staggered", 2e-2), (check_adiabatic, "monolithic", 1e-4))


if __name__ == "__main__":
    main()
