"""What is installed works: the program on its scenes, the completion, the man page.

Usage: package.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import os
import re
import shutil
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


def check_links(folder):
    """Every link of a document to another file."""
    documents = list(folder.rglob("*.md"))
    for document in documents:
        text = re.sub(r"```.*?```", "", document.read_text(), flags=re.DOTALL)
        for link in re.findall(r"\]\((?!https?:|#)([^)\s#]+)", text):
            require((document.parent / link).exists(), f"{document.relative_to(folder)} links to {link}")
    require(len(documents) > 10, f"{len(documents)} documents")


def check_tools(source):
    """What cpack reads first: it stops where a tool is missing."""
    done = subprocess.run([shutil.which("cmake"), "-P", source / "package/tools.cmake"], text=True,
                          capture_output=True, check=False, env={"PATH": "/nowhere"})
    require(done.returncode != 0 and "install" in done.stderr and "file dpkg-dev" in done.stderr,
            f"not a word of the missing tools: {done.stderr}")


def check_debian_package(build, folder):
    """The .deb unpacked into a bare folder runs there and knows on what it depends. Installed by apt
    in a bare system it is by scripts/try-on, which needs root and the network."""
    if not all(map(shutil.which, ("dpkg-deb", "dpkg-shlibdeps", "file"))):
        print("no .deb is made: file or dpkg-dev is missing")
        return
    subprocess.run(["cpack", "-G", "DEB", "-B", folder], cwd=build, check=True,
                   stdout=subprocess.DEVNULL)
    package, = folder.glob("*.deb")
    needs = subprocess.run(["dpkg-deb", "-f", package, "Depends"], capture_output=True, text=True,
                           check=True).stdout
    for library in ("deal.ii", "gmsh", "mumps", "openmpi"):
        require(library in needs, f"the package does not depend on {library}: {needs}")
    bare = folder / "bare"
    subprocess.run(["dpkg-deb", "-x", package, bare], check=True)
    subprocess.run([bare / "usr/bin/thelma", bare / "usr/share/thelma/prm/planar_actuator.prm",
                    "--output", folder / "bare run"], check=True, stdout=subprocess.DEVNULL)
    require((folder / "bare run/run.json").exists(), "the program of the package left no results")


def main():
    """Installs into a folder and uses what is there."""
    program, _ = program_and_ranks(__doc__)
    check_tools(program.source)
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
        subprocess.run([folder / "bin/thelma-report", folder / "run"], check=True)
        page = (folder / "run/report.html").read_text()
        require("data:image/png;base64," in page or "Not drawn: " in page, "no pictures, and no reason")
        done = subprocess.run([folder / "bin/thelma-fit", folder / "none.prm", __file__], capture_output=True, text=True,
                              check=False)
        require(done.returncode == 1 and done.stderr.startswith("fit: "), f"thelma-fit: {done.stderr}")
        check_links(share / "doc")
        check_debian_package(build, folder)

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
