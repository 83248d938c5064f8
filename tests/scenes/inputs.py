"""Meshes and parameter files as other programs, editors and systems write them (tests/inputs): each
gives the right answer or says what is wrong with it, with exit code 1.

Usage: inputs.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

All are the film of tests/inputs/film.prm, L = 4 mm, h = 1 mm, none of whose nodes moves at V = 1 kV.
By hand, its charge is eps L V/h and the force that holds an electrode, by Maxwell's stress,
eps/2 (V/h)^2 L; both per mm of depth.
"""

import json
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from scene import program_and_ranks, require, settings

PERMITTIVITY, LENGTH = 3.98e-5, 4.0
CHARGE = PERMITTIVITY * LENGTH
FORCE = PERMITTIVITY / 2 * LENGTH

UNICODE = {"Regions/Materials": "folie é: rubber", "Supports/Fixed": "Füße: u1 u3, 上: u1 u3",
           "Electrodes/Potential": "Füße: 0, 上: 1", "Observables/reaction/At": "上"}
# Commas and colons are separators: names with them are quoted, or have semicolons in their place.
QUOTED = {"Regions/Materials": '"film, cast": rubber',
          "Supports/Fixed": '"base: left, right": u1 u3, "lid:1": u1 u3',
          "Electrodes/Potential": 'base; left; right: 0, "lid:1": 1',
          "Observables/reaction/At": '"lid:1"'}
SOUND = {"ascii_2_2.msh": {}, "binary_2_2.msh": {}, "ascii_4_0.msh": {}, "ascii_4_1.msh": {},
         "binary_4_1.msh": {}, "partitioned.msh": {}, "orphan_nodes.msh": {},
         "sparse_tags.msh": {}, "clockwise.msh": {}, "crlf.msh": {}, "metres.geo": {},
         "with blanks/film of rubber.msh": {}, "unicode.msh": UNICODE, "second_order.msh": {},
         "in micrometres": {"Mesh/File": "micrometres.msh", "Mesh/Unit": "um"},
         "punctuated.msh": QUOTED}
SOUND_SCENES = ["crlf.prm", "byte_order_mark.prm"]

# What the sentence must say beside section and entry.
BROKEN = {"byte_order_mark.msh": "byte order mark", "utf_16.msh": "byte order mark",
          "decimal_comma.msh": "decimal points", "no_elements.msh": "no cells",
          "node_nowhere.msh": "node 2", "triangles.msh": "Cells = subdivided",
          "one_name_twice.msh": "physical surface 21",
          "curve_and_surface.msh": "physical curve 12",
          "unnamed_region.msh": "physical surface 22"}
MISUSED = {"Mesh.ScalingFactor = 1000": {"Mesh/File": "metres.geo", "Mesh/Unit": "m"},
           "not a unit of length": {"Mesh/Unit": "kV"},
           "are of order 2": {"Mesh/File": "second_order.msh",
                                                             "Mesh/Refinements": "1"},
           "too many for the memory": {"Mesh/File": "triangles.msh", "Mesh/Cells": "subdivided",
                                       "Mesh/Refinements": "14"},
           "quadratic and so curved": {"Mesh/File": "arcs.msh", "Mesh/Curved": "around x2"}}
WARNED = {"apart.msh": "2 nodes of 'film' and 'film'"}


def run(program, scene, entries, folder):
    """Exit code, output, and final values if there are any."""
    command = program.command([f"tests/inputs/{scene}", *settings(entries), "--output", folder], 1)
    done = subprocess.run(command, cwd=program.source, capture_output=True, text=True, check=False,
                          timeout=60)
    report = Path(folder) / "run.json"
    values = json.loads(report.read_text())["final_values"] if report.exists() else {}
    return done.returncode, done.stdout + done.stderr, values


def judge_sound(name, result):
    """The answer by hand."""
    code, text, values = result
    require(code == 0, f"{name}: exit code {code}: {text}")
    for column, exact in (("charge_uC", CHARGE), ("reaction_f3_N", FORCE)):
        print(f"{name}: {column} {values[column]!r}, by hand {exact!r}")
        require(abs(abs(values[column]) / exact - 1) < 1e-10, f"{name}: {column} is wrong")


def judge_broken(name, result, words):
    """One sentence."""
    code, text, _ = result
    print(f"{name}: {text.strip()}")
    require(code == 1, f"{name}: exit code {code}, not 1")
    require(len(text.strip().splitlines()) == 1, f"{name}: not one sentence")
    require(words in text, f"{name}: no word of {words}")


def main():
    program, _ = program_and_ranks(__doc__)
    meshes = [*SOUND, *BROKEN, *WARNED, *MISUSED]
    scenes = [*SOUND_SCENES, "utf_16.prm"]
    runs = [("film.prm", {"Mesh/File": name, **SOUND.get(name, {}), **MISUSED.get(name, {})}) for name in meshes]
    runs += [(name, {}) for name in scenes]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        results = dict(zip([*meshes, *scenes], pool.map(
            lambda numbered: run(program, *numbered[1], f"{folder}/{numbered[0]}"),
            enumerate(runs))))
    for name in [*SOUND, *SOUND_SCENES]:
        judge_sound(name, results[name])
    for name, words in {**BROKEN, **{words: words for words in MISUSED}, "utf_16.prm": "UTF-16"}.items():
        judge_broken(name, results[name], words)
    for name, words in WARNED.items():
        require(results[name][0] == 0 and f"warning: {words}" in results[name][1],
                f"{name}: {results[name][1]}")


main()
