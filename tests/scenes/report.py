"""scripts/report in a browser: no error, no network, curves that zoom and tell their numbers.

Usage: report.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from scene import program_and_ranks, require, study

SCRIPT = str(Path(__file__).resolve().parents[2] / "scripts/report")

# What a user does, done to the page; the answers become attributes of its body.
ACTIONS = """<script>
window.addEventListener("load", () => {
  const chart = document.getElementById("curves"), svg = chart.querySelector("svg");
  const at = (name, x, y) => {
    const box = svg.getBoundingClientRect(), inside = { bubbles: true,
      clientX: box.left + x * box.width, clientY: box.top + y * box.height };
    svg.dispatchEvent(new PointerEvent(name, inside));
  };
  const axis = () => [...svg.querySelectorAll("text")].map(t => t.textContent).join(" ");
  const [, x, y] = chart.querySelector(".curve").getAttribute("d").match(/L([\\d.]+) ([\\d.]+)/);
  at("pointermove", x / svg.viewBox.baseVal.width, y / svg.viewBox.baseVal.height);
  document.body.dataset.hover = chart.querySelector(".tip").textContent;
  const whole = axis();
  at("pointerdown", 0.4, 0.2); at("pointermove", 0.6, 0.6); at("pointerup", 0.6, 0.6);
  document.body.dataset.zoomed = axis() !== whole;
  svg.dispatchEvent(new MouseEvent("dblclick"));
  document.body.dataset.restored = axis() === whole;
  const choice = chart.querySelector("select[data-axis=y]");
  choice.value = "voltage_kV"; choice.dispatchEvent(new Event("change"));
  document.body.dataset.chosen = axis().includes("voltage (kV)");
});
</script>"""


def browse(browser, page):
    """The document after its scripts have run, and what the browser's console said."""
    command = [browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
               "--disable-dev-shm-usage", f"--user-data-dir={page.parent}/browser",
               "--virtual-time-budget=5000", "--dump-dom", page.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    console = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    return done.stdout, console


def check(browser, folder, curves, dashed):
    """Makes and loads the page of a folder; requires so many curves, of which some are dashed."""
    subprocess.run([SCRIPT, str(folder)], check=True)
    text = (folder / "report.html").read_text()
    addresses = set(re.findall(r"https?://[^\"'\s)]+", text)) - {"http://www.w3.org/2000/svg"}
    require(not addresses, f"the page names {addresses}")
    require("data:image/png;base64," in text, "there is no deformed shape")
    if browser is None:
        return
    page = folder / "used.html"
    page.write_text(text.replace("</body>", ACTIONS + "</body>"))
    document, console = browse(browser, page)
    require(not console, f"the console says {console}")
    drawn = document[document.index('id="curves"'):document.index('id="convergence"')]
    found = re.findall(r'<path class="curve( unstable)?"', drawn)
    require(len(found) >= curves, f"{len(found)} curves, not {curves}")
    require(any(found) == dashed, f"unstable parts dashed: {any(found)}, not {dashed}")
    for answer in ("zoomed", "restored", "chosen"):
        require(f'data-{answer}="true"' in document, f"the chart is not {answer}")
    require(re.search(r'data-hover="[^"]*e: [\d.]+', document), "nothing told where one points")
    print(f"{folder.name}: {len(found)} curves, {len(text) // 1024} kB")


def page_of(folder):
    """The text of the page without pictures."""
    subprocess.run([SCRIPT, str(folder), "--no-shapes"], check=True)
    return (folder / "report.html").read_text()


def check_bad_case(program, folder):
    """One case of bad input leaves the others' parameters as they are."""
    program.run("planar_actuator", folder, "--sweep", "Temperature/Value=273,-5,353", exit_code=1)
    text = page_of(folder)
    different = text[text.index("Different between the runs"):text.index("The same in all runs")]
    require(re.findall(r"<th>(.*?)</th>", different) == ["run", "Temperature/Value (K)"],
            f"other entries differ: {different}")
    require("not begun" in text and "Temperature = -5" in text, "not a word of the bad case")


def chart_data(text, identity):
    """What the script of the page draws there."""
    found = re.search(rf'data-for="{identity}">(.*?)</script>', text)
    require(found, f"there is no chart of {identity}")
    return json.loads(found[1])


def check_final_values(folder):
    """Over the entry that was swept, as the last rows of the curves say."""
    data = chart_data((folder / "report.html").read_text(), "ends")
    require(data["x"] == "Temperature/Value", f"drawn over {data['x']}")
    columns = data["series"][0]["columns"]
    require(columns["Temperature/Value"] == [293, 353], f"over {columns['Temperature/Value']}")
    tips = [float(study.read_columns(path / "curve.csv", ("tip_u1_mm",))["tip_u1_mm"][-1])
            for path in sorted(folder.glob("*=*"))]
    require(columns["tip_u1_mm"] == tips, f"{columns['tip_u1_mm']} for {tips}")


def draws_without_display():
    """Whether VTK does not mind a display that does not exist."""
    from vtkmodules.vtkCommonCore import vtkVersion
    return (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) >= (9, 6)


def check_colours(folder):
    """Another field, one that does not exist, and no display to draw on."""
    subprocess.run([SCRIPT, str(folder), "--field", "phi"], check=True)
    require(re.search(r"colours: phi from 0 .* kV", (folder / "report.html").read_text()), "no phi")
    done = subprocess.run([SCRIPT, str(folder), "--field", "psi"], capture_output=True, text=True, check=True)
    require("'psi'" in done.stderr and "D, E, J, P, phi," in done.stderr, done.stderr)
    with tempfile.TemporaryDirectory() as bare:
        (Path(bare) / "python3").symlink_to(sys.executable)
        for display, words in ((None, "Xvfb"), (":987", "DISPLAY")):
            environment = {"PATH": bare, **({"DISPLAY": display} if display else {})}
            subprocess.run([SCRIPT, str(folder)], check=True, env=environment, stderr=subprocess.DEVNULL)
            text = (folder / "report.html").read_text()
            if display and draws_without_display():
                require("Not drawn: " not in text and "data:image/png" in text, "not drawn")
            else:
                require("Not drawn: " in text and words in text, f"not a word of {words}")


def check_narrow_bracket(folder):
    """The ends of a bracket can be told apart."""
    path = next(folder.glob("*=273/run.json"))
    report = json.loads(path.read_text())
    report["pull_in"] = {"e_below": 0.6634453629, "e_above": 0.6634453651}
    path.write_text(json.dumps(report))
    require("0.663445363 to 0.663445365" in page_of(folder), "the bracket is rounded away")


def check_killed(folder):
    """Of a study killed before a case ended, what has begun is shown; if nothing has, one sentence
    says so."""
    for path in (folder / "study.csv", *folder.glob("*/run.json")):
        path.unlink()
    text = page_of(folder)
    require("3 runs, 3 not ended." in text and "<td>not begun</td>" in text,
            "not a word of the kill")
    require('id="curves"' in text, "the curves that there are are not shown")
    for path in folder.glob("*/curve.csv"):
        path.unlink()
    done = subprocess.run([SCRIPT, str(folder)], capture_output=True, text=True, check=False)
    require(done.returncode == 1 and "start it again" in done.stderr, f"no remedy: {done.stderr}")


def check_pressure(program, folder):
    """Where only a pressure changes, the curves are drawn against the load."""
    program.run("balloon", folder, "--set", "Loading/Stages=pressure 0.5", "--set",
                "Expectations/Final values=")
    require(chart_data(page_of(folder), "curves")["x"] == "load", "not drawn against the load")


def check_control(program, folder):
    """Where the charge is driven, the curves are drawn against it."""
    program.run("hard/charge_control", folder)
    require(chart_data(page_of(folder), "curves")["x"].endswith("charge_uC"), "not against the charge")


def main():
    """A path through instabilities, a study, a run with estimates."""
    program, _ = program_and_ranks(__doc__)
    browser = shutil.which("chromium")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        program.run("hard/pull_in_loop", folder / "path")
        check(browser, folder / "path", 2, True)
        require("target reached" not in (folder / "path/report.html").read_text(),
                "Loading/Until is called the target")
        program.run("bending_actuator_plane", folder / "study", "--sweep",
                    "Temperature/Value=293,353", "--set", "Output/Fields=last")
        check(browser, folder / "study", 2, False)
        check_final_values(folder / "study")
        check_colours(folder / "study")
        program.run("bending_actuator_plane", folder / "estimate", "--estimate", "--set",
                    "Loading/Target=0.3")
        check(browser, folder / "estimate", 1, False)
        text = (folder / "estimate/report.html").read_text()
        require("tip_u1_mm" in text, "no estimates")
        require("plane strain" in text and "per mm of depth" in text, "not a word of the plane")
        require("started by: thelma" in text and "--estimate" in text, "no command line")
        check_bad_case(program, folder / "bad")
        check_narrow_bracket(folder / "bad")
        check_killed(folder / "bad")
        check_pressure(program, folder / "pressure")
        check_control(program, folder / "charge")
    if browser is None:
        print("SKIPPED: no Chromium to load the pages; all else is as it should be")
        sys.exit(77)


main()
