"""A run that is killed at random moments, and started again each time, ends with the curve of the
uninterrupted run; so does one that is stopped by a signal or by a full disk, also on another number
of ranks; a study keeps the cases that are finished.

Usage: restart.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

The uninterrupted run is the reference. On as many ranks every number but the seconds is the same to
1e-10 and no step costs another number of iterations; on others the curve is the same to 1e-8.
"""

import csv
import json
import random
import resource
import shutil
import signal
import subprocess
import time

import numpy as np

from scene import program_and_ranks, require, side_by_side

KILLS = 50  # in all
EVERY_STEP = ["--set", "Output/Checkpoint interval=0"]
COARSE = ["--set", "Stepping/Initial step=0.2", "--set", "Stepping/Largest step=0.2"]

# What a run may be in the middle of.
SCENES = {
    "voltage": ["prm/planar_actuator.prm", "--set", "Output/Fields=every"],
    "stages": ["prm/hard/generator.prm", *COARSE, "--set", "Discretisation/Formulation=enhanced "
               "strain"],
    "arc length": ["prm/hard/snap_through.prm"],
    "charge": ["prm/hard/charge_control.prm", "--set", "Mesh/Parameters=L1: 5, L2: 5, L3: 1, "
               "n1: 1, n2: 1, n3: 1"],
    "branch": ["prm/verification/column.prm"],
    "steady temperature": ["prm/verification/thermo_electric_tube.prm", "--set",
                           "Mesh/Parameters=n1: 2, n3: 3", "--set", "Expectations/Final values="],
    "block solver": ["prm/planar_actuator.prm", "--set", "Linear solver/Solver=block", "--set",
                     "Discretisation/Formulation=mean dilatation", "--set", "Output/Fields=none"],
    "time": ["prm/heated_bending.prm", "--set", "Mesh/Parameters=L: 20, H: 1, n1: 2, n3: 8",
             "--set", "Time/Tolerance=0.5", "--set", "Output/Fields=none"],
    "time, monolithic": ["prm/hard/heat_step.prm", "--set", "Time/Coupling=monolithic", "--set",
                         "Time/Structural heat=entropy", "--set", "Time/Tolerance=0.5", "--set",
                         "Time/Initial step=0.01", "--set", "Time/Scheme=BDF2", "--set",
                         "Output/Observables=temperature_range, lambda_3, ledger"],
    "memory": ["prm/heated_bending.prm", "--set", "Mesh/Parameters=L: 20, H: 1, n1: 2, n3: 8",
               "--set", "Time/Tolerance=0.5", "--set", "Time/Structural heat=entropy", "--set",
               "Materials/elastomer/Branches=Maxwell, Maxwell", "--set",
               "Output/Observables=tip, mid_rotation, charge, temperature_range"],
    "pressure": ["prm/balloon.prm", "--set", "Output/Fields=none", "--set",
                 "Output/Observables=tip, centre, enclosed_volume, ledger"],
    "pressure in time": [
        "prm/balloon.prm", "--set", "Loading/Stages=pressure 1", "--set", "Electrodes/Potential=",
        "--set", "Regions/Passive=wall", "--set", "Temperature/Model=transient", "--set",
        "Temperature/Fixed=outer: 313", "--set", "Time/Coupling=monolithic", "--set",
        "Time/Initial step=0.1", "--set", "Discretisation/Degree=1", "--set",
        "Output/Observables=tip, centre, enclosed_volume, ledger", "--set",
        "Expectations/Final values="],
}


class Runs:
    """Starts the program and continues what it left."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = folder

    def command(self, output, arguments, ranks=1):
        """The command line that begins the run in a folder or, if it has begun, goes on."""
        if (output / "command.txt").exists():
            arguments = ["--restart", str(output)]
        else:
            arguments = [*arguments, "--output", str(output)]
        return self.program.command(arguments, ranks)

    def start(self, output, arguments, ranks=1, **options):
        """The running process."""
        return subprocess.Popen(self.command(output, arguments, ranks), cwd=self.program.source,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                **options)

    def finish(self, output, arguments, ranks=1, exit_code=0, **options):
        """Runs to the end; returns what stands on stderr."""
        with self.start(output, arguments, ranks, **options) as process:
            errors = process.communicate(timeout=120)[1]
        require(process.returncode == exit_code,
                f"{output.name}: exit code {process.returncode}, not {exit_code}: {errors}")
        return errors

    def reference(self, name, ranks=1):
        """The folder of the uninterrupted run and how long it took."""
        output = self.folder / f"{name} on {ranks}"
        begin = time.monotonic()
        if not output.exists():
            self.finish(output, SCENES[name], ranks)
        return output, time.monotonic() - begin


def table(output):
    """Numbers of curve.csv by column, without the seconds, and the events."""
    with open(output / "curve.csv", newline="", encoding="utf8") as file:
        rows = list(csv.DictReader(file))
    columns = {name: np.array([float(row[name]) for row in rows])
               for name in rows[0] if name not in ("seconds", "event")}
    return columns, [row["event"] for row in rows]


def family(column):
    """Observable and unit."""
    return column.split("_")[0], column.split("_")[-1]


def compare(name, output, reference, tolerance, work):
    """Every column, relative to its largest value; the same work too, if it is on as many ranks."""
    (found, events), (wanted, wanted_events) = table(output), table(reference)
    require(events == wanted_events, f"{name}: the events are {events}, not {wanted_events}")
    largest = 0.0
    for column, values in wanted.items():
        if column.endswith("_iterations") and not work:
            continue
        # Rounding differs on other ranks, and some forces are nothing else.
        kin = [column] if work else [c for c in wanted if family(c) == family(column)]
        scale = max(np.max(np.abs(wanted[c])) for c in kin)
        difference = np.abs(found[column] - values) / (scale if scale > 0 else 1.0)
        if column == "unstable_directions" and not work:
            # At an event an eigenvalue is zero, and rounding decides on its sign.
            difference = difference[[not event for event in events]]
        difference = np.max(difference)
        require(difference <= tolerance, f"{name}: {column} differs by {difference}")
        largest = max(largest, difference)
    reports = [json.loads((folder / "run.json").read_text()) for folder in (output, reference)]
    for entry in ["outcome", "reason", "steps"] + work * ["failed_steps", "newton_iterations",
                                                          "factorisations", "linear_iterations"]:
        require(reports[0][entry] == reports[1][entry],
                f"{name}: {entry} is {reports[0][entry]}, not {reports[1][entry]}")
    require(not list(output.glob("checkpoint*")), f"{name}: a checkpoint is left")
    return largest


def kill_until_done(runs, name, output, seconds):
    """Kills the run after random times until one comes too late; returns how many it were."""
    kills = 0
    while True:
        with runs.start(output, SCENES[name] + EVERY_STEP) as process:
            try:
                process.wait(random.uniform(0.0, 1.5 * seconds))
            except subprocess.TimeoutExpired:
                process.kill()
            killed = process.wait() == -signal.SIGKILL
        if not killed:
            require(process.returncode == 0, f"{name}: exit code {process.returncode}")
            return kills
        kills += 1


def check_kills(program, folder, name):
    """The scene's share of the kills."""
    runs = Runs(program, folder)
    reference, seconds = runs.reference(name)
    kills = rounds = 0
    largest = 0.0
    while kills < KILLS / len(SCENES):
        output = folder / f"{name}, killed {rounds}"
        kills += kill_until_done(runs, name, output, seconds)
        largest = max(largest, compare(name, output, reference, 1e-10, work=True))
        rounds += 1
    print(f"{name}: killed {kills} times in {rounds} runs, largest difference {largest:.1e}")


def wait_for_rows(process, output, rows):
    """Until curve.csv has so many, or the process has ended."""
    curve = output / "curve.csv"
    while process.poll() is None and not (curve.exists() and len(table(output)[1]) >= rows):
        time.sleep(0.002)


def stop(runs, name, output, options, number=signal.SIGTERM, ranks=1, rows=4):
    """Sends the signal once there are some rows; returns the exit code and what was said."""
    with runs.start(output, SCENES[name] + options, ranks) as process:
        wait_for_rows(process, output, rows)
        process.send_signal(number)
        errors = process.communicate(timeout=60)[1]
    return process.returncode, errors


def stopped(runs, name, label, number=signal.SIGTERM, ranks=1):
    """A folder with a run that the signal has stopped in the middle."""
    for attempt in range(10):
        output = runs.folder / f"{name}, {label} {attempt}"
        code, errors = stop(runs, name, output, [], number, ranks)
        if code != 0:
            require(code == 4, f"{name}, {label}: exit code {code}, not 4: {errors}")
            report = json.loads((output / "run.json").read_text())
            require(report["outcome"] == "stopped" and report["exit_code"] == 4,
                    f"{name}, {label}: the outcome is {report['outcome']}")
            return output
    raise RuntimeError(f"{name} is too fast to be stopped")


def check_signals_and_ranks(program, folder, name, all_ranks):
    """SIGTERM or Ctrl-C to one rank, SIGUSR1 to mpirun; from each number of ranks to each other."""
    runs = Runs(program, folder)
    alone = signal.SIGINT if name == "arc length" else signal.SIGTERM
    for before in all_ranks:
        label = f"stopped on {before}"
        number = alone if before == 1 else signal.SIGUSR1
        kept = stopped(runs, name, label, number, before)
        for after in all_ranks:
            output = folder / f"{name}, {before} to {after}"
            shutil.copytree(kept, output)
            errors = runs.finish(output, [], after)
            require(not errors, f"{name}: {errors}")
            reference, _ = runs.reference(name, after if before == after else 1)
            same = before == after == 1
            largest = compare(name, output, reference, 1e-10 if same else 1e-8, work=same)
            print(f"{name}: stopped on {before}, continued on {after} rank(s), "
                  f"largest difference {largest:.1e}")


def check_damage(program, folder):
    """With a damaged newest checkpoint the one before it serves, with none the run begins anew."""
    name = "arc length"
    runs = Runs(program, folder)
    reference, _ = runs.reference(name)
    output = folder / "damaged"
    code, _ = stop(runs, name, output, EVERY_STEP)
    require(code == 4, f"damage: exit code {code}")
    files = sorted(output.glob("checkpoint.*"), key=lambda path: path.stat().st_mtime_ns)
    require(len(files) == 2, f"there are {len(files)} checkpoints, not 2")
    for count in (1, 2):
        again = folder / f"damaged {count}"
        shutil.copytree(output, again)
        for path in files[2 - count:]:
            damaged = again / path.name
            damaged.write_bytes(damaged.read_bytes()[:-7])
        done = subprocess.run(runs.command(again, []), cwd=program.source, text=True,
                              capture_output=True, check=False, timeout=60)
        require(done.returncode == 0 and done.stdout.count("is damaged") == count,
                f"exit code {done.returncode}: {done.stdout}{done.stderr}")
        compare(f"{count} damaged", again, reference, 1e-10, work=True)


def check_full_disk(program, folder, name):
    """No file may grow any more: one sentence, exit code 4, and the last checkpoint serves."""
    runs = Runs(program, folder)
    reference, _ = runs.reference(name)
    output = folder / f"{name}, full disk"
    with runs.start(output, SCENES[name] + EVERY_STEP) as process:
        wait_for_rows(process, output, 6)
        limit = max(path.stat().st_size for path in output.glob("checkpoint.*"))
        resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (limit, limit))
        errors = process.communicate(timeout=60)[1]
    require(process.returncode == 4, f"full disk: exit code {process.returncode}, {errors}")
    require(errors.count("\n") == 1 and "free disk space" in errors, f"full disk: {errors}")
    require(not list(output.glob("*.part")), "full disk: half a file is left")
    runs.finish(output, [])
    largest = compare(name, output, reference, 1e-10, work=True)
    print(f"{name}: largest difference after a full disk {largest:.1e}")


def check_refusals(program, folder):
    """A finished run stays as it is; another scene, and nothing at all, are refused."""
    runs = Runs(program, folder)
    done, _ = runs.reference("voltage")
    before = (done / "run.json").stat().st_mtime_ns
    runs.finish(done, [])
    require((done / "run.json").stat().st_mtime_ns == before, "a finished run was run again")
    changed = stopped(runs, "stages", "changed")
    used = changed / "used.prm"
    used.write_text(used.read_text().replace("lambda_1, lambda_3", "lambda_3, lambda_1"))
    errors = runs.finish(changed, [], exit_code=1)
    require("lambda_3, lambda_1" in errors, errors)
    nothing = subprocess.run(program.command(["--restart", str(folder)], 1),
                             capture_output=True, text=True, check=False)
    require(nothing.returncode == 1 and "--output" in nothing.stderr, nothing.stderr)


def check_two_at_once(program, folder):
    """No run writes into the folder of one that goes on."""
    runs = Runs(program, folder)
    output = folder / "in use"
    with runs.start(output, SCENES["time"] + ["--set", "Time/Tolerance=0", "--set",
                                              "Time/Initial step=1e-3"]) as process:
        wait_for_rows(process, output, 2)
        errors = runs.finish(output, [], exit_code=1)
        require(str(output) in errors and errors.count("\n") == 1, errors)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
    require(process.returncode == 4, f"the first run ended with {process.returncode}")


def study_table(output):
    """study.csv without the seconds."""
    with open(output / "study.csv", newline="", encoding="utf8") as file:
        rows = list(csv.reader(file))
    kept = [i for i, name in enumerate(rows[0]) if name not in ("run_seconds", "seconds")]
    return [[row[i] for i in kept] for row in rows]


def check_study(program, folder, ranks):
    """Killed in a case: what was finished stays, and that case goes on from its checkpoint."""
    arguments = ["prm/hard/snap_through.prm", "--sweep", "Temperature/Value=293,313,333",
                 *EVERY_STEP]
    runs = Runs(program, folder)
    whole = folder / "whole study"
    runs.finish(whole, arguments, ranks)
    for number, code in ((signal.SIGKILL, -signal.SIGKILL), (signal.SIGTERM, 4)):
        output = folder / f"study {number}"
        with runs.start(output, arguments) as process:
            last = output / "Temperature.Value=333"
            wait_for_rows(process, last, 4)
            process.send_signal(number)
            process.communicate(timeout=60)
        require(process.returncode == code, f"study: exit code {process.returncode}, not {code}")
        finished = {path: path.stat().st_mtime_ns for path in output.glob("*/run.json")
                    if path.parent != last}
        require(len(finished) == 2, f"{len(finished)} cases are finished, not 2")
        runs.finish(output, [], ranks)
        require(finished == {path: path.stat().st_mtime_ns for path in finished},
                "a finished case was run again")
        require("continued after" in (last / "log.txt").read_text(), "the case began anew")
        compare("study", last, whole / last.name, 1e-10, work=True)
        found, wanted = study_table(output), study_table(whole)
        require(found == wanted, f"study.csv: {found}, not {wanted}")
    print("study: continued after SIGKILL and SIGTERM")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    random.seed(7)
    side_by_side(program, *((check_kills, name) for name in SCENES),
                 *((check_signals_and_ranks, name, all_ranks)
                   for name in ("stages", "arc length", "time", "memory")),
                 (check_study, all_ranks[-1]), (check_damage,), (check_full_disk, "stages"),
                 (check_full_disk, "time"), (check_refusals,), (check_two_at_once,))


main()
