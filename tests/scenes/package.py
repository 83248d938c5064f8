"""What is installed works: the program on its scenes, the completion, the man page.

Usage: package.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import os
import re
import subprocess
import tempfile
from pathlib import Path

from scene import program_and_ranks, require


def options_in(text):
    """The long options that a text names."""
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text.replace("\\-", "-")))


def completions(script, binary, *words):
    """What the shell offers for the last word."""
    line = " ".join(f"'{word}'" for word in words)
    commands = (f"source {script}; compopt() {{ :; }}; COMP_WORDS=(thelma {line}); "
                f"COMP_CWORD={len(words)}; _thelma; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    path = f"{binary.parent}:{os.environ['PATH']}"
    done = subprocess.run(["bash", "-c", commands], capture_output=True, text=True, check=True,
                          env={**os.environ, "PATH": path})
    return done.stdout.split("\n")[:-1]


def main():
    """Installs into a folder and uses what is there."""
    program, _ = program_and_ranks(__doc__)
    build = Path(program.binary).resolve().parents[1]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run(["cmake", "--install", build, "--prefix", folder], check=True,
                       stdout=subprocess.DEVNULL)
        binary, share = folder / "bin/thelma", folder / "share"
        scene = share / "thelma/prm/planar_actuator.prm"
        subprocess.run([binary, "--check", scene], check=True)

        subprocess.run([binary, scene, "--output", folder / "run"], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([folder / "bin/thelma-report", folder / "run", "--no-shapes"], check=True)
        require((folder / "run/report.html").is_file(), "no report")

        known = options_in(subprocess.run([binary, "--help"], capture_output=True, text=True,
                                          check=True).stdout)
        manual = options_in((share / "man/man1/thelma.1").read_text())
        require(manual == known, f"man page and --help differ by {manual ^ known}")
        script = share / "bash-completion/completions/thelma"
        offered = set(completions(script, binary, "--"))
        require(offered == known, f"completion and --help differ by {offered ^ known}")
        require(f"{scene}" in completions(script, binary, f"{scene.parent}/planar"),
                "no completion of a parameter file")
        entries = completions(script, binary, "--set", "Temperature/")
        require('"Temperature/Value=' in entries, f"no completion of an entry: {entries}")
        print(f"{len(known)} options, {len(entries)} entries of the section Temperature")


main()
