"""Damaged parameter files, geometries and meshes end in sentences and exit code 1, or are sound.

Usage: fuzz_input.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

Most damaged parameter files are read in process (tests/unit/application/input.cc); here the program is started.
"""

import concurrent.futures
import random
import re
import subprocess
import tempfile
from pathlib import Path

from scene import program_and_ranks, require, sentences

LIMIT = 60  # s; a sound one takes a third of a second
SEED = 3
SMALL = ("0", "1", "2", "3", "7", "27", "99", "-1")  # a geometry takes larger ones at their word
LARGE = (*SMALL, "1e9", "4294967297", "-9223372036854775808")
BYTES = "\t\n\\#=:;,/'\"%${}()[]<>-+.e0129azAZ*"
CONDITIONS = {  # what the geometries need to be scenes
    "box.geo": "planar_actuator.prm", "bilayer_plane.geo": "bending_actuator_plane.prm",
    "pump_layer.geo": "buckling_pump_quarter.prm",
}


def damaged(text, rng, numbers=SMALL):
    """The text with a few letters or numbers changed, removed, repeated or inserted."""
    for _ in range(rng.randint(1, 3)):
        at = rng.randrange(len(text))
        kind = rng.randrange(6)
        if kind == 0:
            text = text[:at] + rng.choice(BYTES) + text[at + 1:]
        elif kind > 3:
            number = rng.choice(list(re.finditer(r"\d+", text)))
            text = text[:number.start()] + rng.choice(numbers) + text[number.end():]
        elif kind == 1:
            text = text[:at] + text[at + rng.randint(1, 30):]
        elif kind == 2:
            begin = rng.randrange(len(text))
            text = text[:at] + text[begin:begin + rng.randint(1, 60)] + text[at:]
        else:
            text = text[:at] + rng.choice(BYTES) * rng.randint(1, 3) + text[at:]
    return text


def box_mesh(n=2):
    """A .msh (2.2) of n^3 cells with the groups of meshes/box.geo."""
    index = {}
    for k in range(n + 1):
        for j in range(n + 1):
            for i in range(n + 1):
                index[i, j, k] = len(index) + 1
    ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
    sides = {"x1_min": (0, 0), "x1_max": (0, n), "x2_min": (1, 0), "x2_max": (1, n),
             "bottom": (2, 0), "top": (2, n)}
    elements = []
    for tag, (axis, at) in enumerate(sides.values(), 1):
        for a in range(n):
            for b in range(n):
                corners = []
                for da, db in ring:
                    place = [a + da, b + db]
                    place.insert(axis, at)
                    corners.append(index[tuple(place)])
                elements.append((3, tag, corners))
    for i, j, k in [(i, j, k) for i in range(n) for j in range(n) for k in range(n)]:
        elements.append((5, 7, [index[i + di, j + dj, k + dk]
                                for dk in (0, 1) for di, dj in ring]))
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "7"]
    lines += [f'2 {tag} "{name}"' for tag, name in enumerate(sides, 1)] + ['3 7 "film"']
    lines += ["$EndPhysicalNames", "$Nodes", str(len(index))]
    lines += [f"{number} {5 * i / n} {5 * j / n} {k / n}" for (i, j, k), number in index.items()]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{number} {kind} 2 {tag} {tag} {' '.join(map(str, corners))}"
              for number, (kind, tag, corners) in enumerate(elements, 1)]
    return "\n".join(lines + ["$EndElements", ""])


def verdict(program, arguments, name):
    """Checks the file; what went wrong, or an empty string, and whether it was refused."""
    command = program.command(["--check", *arguments], 1)
    try:
        done = subprocess.run(command, cwd=program.source, capture_output=True, check=False,
                              timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return f"{name}: no end within {LIMIT} s", False
    lines = sentences(done.stderr.decode(errors="replace"))
    if done.returncode == 0 and not lines:
        return "", False
    clean = all(line.startswith("thelma: ") and "internal error" not in line for line in lines)
    if done.returncode == 1 and lines and clean:
        return "", True
    return f"{name}: exit code {done.returncode}\n" + "\n".join(lines[:20]), False


def jobs(program, folder):
    """Arguments and name of every check."""
    rng = random.Random(SEED)
    scenes = sorted((program.source / "prm").glob("*.prm"))
    for n in range(20):
        scene = rng.choice(scenes)
        text = re.sub(r"\.\./meshes", str(program.source / "meshes"), scene.read_text())
        path = folder / f"{n}.prm"
        path.write_text(damaged(text, rng))
        yield [str(path)], path
    geometries = [(program.source / "meshes" / name, scene) for name, scene in CONDITIONS.items()]
    for n in range(60):
        geometry, scene = geometries[n % len(geometries)]
        path = folder / f"{n}.geo"
        path.write_text(damaged(geometry.read_text(), rng))
        yield [f"prm/{scene}", "--set", f"Mesh/File={path}"], path
    for n in range(40):
        path = folder / f"{n}.msh"
        path.write_text(damaged(box_mesh(), rng, LARGE))
        yield ["prm/planar_actuator.prm", "--set", f"Mesh/File={path}", "--set",
               "Mesh/Parameters="], path


def main():
    """All of them, two at a time."""
    program, _ = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        sound = folder / "sound.msh"
        sound.write_text(box_mesh())
        trouble, _ = verdict(program, ["prm/planar_actuator.prm", "--set", f"Mesh/File={sound}",
                                       "--set", "Mesh/Parameters="], sound)
        require(not trouble, trouble)
        work = list(jobs(program, folder))
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            results = list(pool.map(lambda job: verdict(program, *job), work))
        for (_, path), (trouble, _) in zip(work, results):
            if trouble:
                print(trouble, path.read_text(), sep="\n")
        require(not any(trouble for trouble, _ in results), "see above")
        refused = sum(was_refused for _, was_refused in results)
        print(f"{len(results)} damaged files: {refused} refused, the others still sound")


main()
