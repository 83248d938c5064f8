"""The page: one HTML file with everything in it."""

import json
import math
from datetime import datetime
from html import escape
from pathlib import Path

from thelma import plotting
from thelma import stability
from thelma.plotting import matplotlib
from reporting import data, ends

# The browser itself refuses whatever is not in the page.
POLICY = ("default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; "
          "img-src data:")
HERE = Path(__file__).resolve().parent
NOT_DRAWN = ("event",)
SHOWN_FIRST = ("lambda_3", "tip_u1_mm", "centre_u1_mm", "mid_rotation_deg", "lambda_1")
DRIVEN = {"voltage": "voltage_kV", "charge": "charge_uC"}
ABSCISSAS = ("e", "voltage_kV", "time_s", "load", "step")


def html(directory, runs, shapes, not_drawn=""):
    """The text of the page; `not_drawn` says why there are no shapes."""
    title = f"Thelma: {directory.resolve().name}"
    sections = [summary(runs), curves(runs), final_values(runs), gallery(runs, shapes, not_drawn), convergence(runs),
                estimates(runs), parameters(runs), timings(runs), provenance(directory, runs)]
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">\n'
            f'<link rel="icon" href="data:,">\n<title>{escape(title)}</title>\n'
            f"<style>\n{(HERE / 'page.css').read_text()}</style></head><body>\n"
            f"<h1>{escape(title)}</h1>\n" + "\n".join(sections)
            + f"\n<script>\n{(HERE / 'chart.js').read_text()}</script></body></html>\n")


def table(header, rows):
    """An HTML table; numbers to the right."""
    def cell(value, tag="td"):
        text = f"{value:.6g}" if isinstance(value, float) else str(value)
        kind = ' class="n"' if isinstance(value, (int, float)) else ""
        return f"<{tag}{kind}>{escape(text)}</{tag}>"

    head = "".join(cell(name, "th") for name in header)
    body = "".join(f"<tr>{''.join(cell(value) for value in row)}</tr>\n" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>\n{body}</tbody></table>"


def section(title, content):
    """A part of the page, or nothing."""
    return f"<section><h2>{escape(title)}</h2>\n{content}\n</section>" if content else ""


def bracket(pull_in):
    """Its two ends, with one digit more than it takes to tell them apart."""
    if not pull_in:
        return ""
    low, high = pull_in["e_below"], pull_in["e_above"]
    if low == high:  # the limit point of a path
        return f"{low:.6g}"
    digits = next((n for n in range(5, 17) if f"{low:.{n}g}" != f"{high:.{n}g}"), 16) + 1
    return f"{low:.{digits}g} to {high:.{digits}g}"


def ending(run):
    """How a run ended and why; what ends it before its target, as Loading/Until, is a reason."""
    if run.unfinished:
        return "unfinished; continue with thelma --restart" if run.columns else "not begun"
    name, reason = run.report.get("outcome"), run.report.get("reason")
    if reason and (name == "target reached" or reason.startswith(name)):
        return reason
    return ": ".join(filter(None, (name, reason))) or run.case.outcome


def three_digits(seconds):
    """Of a wall time, which varies by more from run to run."""
    return float(f"{seconds:.3g}")


def summary(runs):
    """How each run ended."""
    rows = []
    for run in runs:
        report = run.report
        code = "" if run.unfinished else report.get("exit_code", run.case.exit_code)
        seconds = three_digits(report["seconds"]) if "seconds" in report else ""
        rows.append((run.label, code, ending(run), bracket(report.get("pull_in")),
                     report.get("steps", ""), seconds))
    counts = ((sum(run.failed for run in runs), "not as expected"),
              (sum(run.unfinished for run in runs), "not ended"))
    words = f"{len(runs)} run{'s' if len(runs) > 1 else ''}, " + (
        ", ".join(f"{n} {what}" for n, what in counts if n) or "all as expected") + "."
    head = ("run", "exit code", "outcome", "pull-in between e", "steps", "seconds")
    kept = [i for i, name in enumerate(head)
            if name != "pull-in between e" or any(row[i] for row in rows)]
    return section("Outcome", f"<p>{words}</p>" + table(
        [head[i] for i in kept], [[row[i] for i in kept] for row in rows]))


def color(index, count):
    """Cold to hot in the order of the study."""
    return matplotlib.colors.to_hex(plotting.COLD_TO_HOT(index / max(count - 1, 1)))


def series(runs):
    """What the script draws."""
    result = []
    for index, run in enumerate(runs):
        events = run.columns.get("event", [])
        numbers = {name: values for name, values in run.columns.items()
                   if name not in NOT_DRAWN and values and not isinstance(values[0], str)}
        if not numbers:
            continue
        rows = len(next(iter(numbers.values())))
        events = events or [""] * rows
        unstable = [value or 0 for value in numbers.get("unstable_directions", [0] * rows)]
        result.append({"label": run.label, "color": color(index, len(runs)), "columns": numbers,
                       "events": events,
                       "unstable": stability.unstable_pieces(unstable, events)})
    return result


def chart(identity, drawn, x, y, options=""):
    """A place for the script to draw in, with its data."""
    text = json.dumps({"series": drawn, "x": x, "y": y}).replace("</", "<\\/")
    return (f'<div class="chart" id="{identity}"{options}></div>\n'
            f'<script type="application/json" data-for="{identity}">{text}</script>')


def first_of(names, known):
    """The first name that is known, else the first known one."""
    return next((name for name in names if name in known), next(iter(known)))


def varies(drawn, name):
    """Whether a column changes along any curve."""
    return any(len({value for value in one["columns"].get(name, []) if value is not None}) > 1
               for one in drawn)


def observed(drawn):
    """Columns that are results."""
    return [name for one in drawn for name in one["columns"]
            if "/" not in name and name not in (*ABSCISSAS, "theta_K")]


def driven(runs, known):
    """Columns of what Loading/Control drives, if that is not e."""
    changed = next((run.changed for run in runs if run.changed), [])
    control = next((value for entry, value, *_ in changed if entry == "Loading/Control"), "")
    return [name for name in known if control in DRIVEN and name.endswith(DRIVEN[control])]


def curves(runs):
    """Any column against any other."""
    drawn = series(runs)
    if not drawn:
        return ""
    known = {name: None for one in drawn for name in one["columns"]}
    x = first_of([name for name in ("time_s", *driven(runs, known), *ABSCISSAS)
                  if varies(drawn, name)], known)
    y = first_of((*SHOWN_FIRST, *observed(drawn)), known)
    hint = ("<p>Solid: stable. Dashed: unstable. Circle: limit point or pull-in; square: bifurcation. "
            "Drag to zoom, double-click to see everything, hover for numbers, click a run in the "
            "legend to hide it.</p>")
    if any(run.plane for run in runs):
        hint += "<p>In plane strain charges, energies and forces are per mm of depth.</p>"
    return section("Curves", hint + chart("curves", drawn, x, y, ' data-choose="yes"'))


def final_values(runs):
    """The last row of every run over what was swept."""
    lasts = [(run.case.swept, {name: values[-1] for name, values in one["columns"].items()})
             for run in runs if run.case.swept for one in series([run])]
    drawn, x = ends.curves(lasts)
    if not drawn:
        return ""
    drawn = [{**one, "color": color(i, len(drawn))} for i, one in enumerate(drawn)]
    y = first_of((*SHOWN_FIRST, *observed(drawn)), drawn[0]["columns"])
    return section("Final values", "<p>The last row of every run, however it ended, over what was "
                   "swept.</p>" + chart("ends", drawn, x, y, ' data-choose="yes" data-marks="yes"'))


def gallery(runs, shapes, not_drawn):
    """Deformed bodies, or why there are none."""
    if not_drawn:
        return section("Deformed shapes", f"<p>Not drawn: {escape(not_drawn)}</p>")
    words = "Contact is not modelled: parts that would touch overlap."
    if any(run.plane for run in runs):
        words += (" Plane sections, which are in plane strain, are drawn as bars a fifth of their "
                  "length deep.")
    figures = "".join(
        f'<figure><img alt="deformed shape, {escape(label)}" '
        f'src="data:image/png;base64,{png}"><figcaption><b>{escape(label)}</b><br>{escape(words)}'
        "</figcaption></figure>\n" for label, (png, words) in shapes.items())
    return section("Deformed shapes", figures and f"<p>{words}</p>"
                   f'<div class="gallery n{min(len(shapes), 3)}">{figures}</div>')


def convergence(runs):
    """Newton's iterations and the size of the steps."""
    drawn = [one for one in series(runs) if "newton_iterations" in one["columns"]]
    if not drawn:
        return ""
    numbers = [(run.label, run.report.get("steps", 0), run.report.get("failed_steps", 0),
                run.report.get("newton_iterations", 0), run.report.get("factorisations", 0))
               for run in runs if run.report]
    head = ("run", "steps", "failed steps", "Newton iterations", "factorisations")
    return section("Convergence", chart("convergence", drawn, "step", "newton_iterations",
                                        ' data-choose="yes" data-marks="yes"')
                   + (table(head, numbers) if numbers else ""))


def estimates(runs):
    """What --estimate found."""
    rows = [(run.label, name, value, *(("no limit", "") if math.isnan(error) else
                                       (error, f"{100 * abs(error / value):.2g} %" if value else "")))
            for run in runs for name, value, error in run.estimates]
    if not rows:
        return section("Error estimates", "<p>None: run with <code>--estimate</code> to have the "
                       "error of every number.</p>")
    return section("Error estimates", table(("run", "quantity", "value", "error", "relative"), rows))


def parameters(runs):
    """Entries that are not at their default, with those that differ between runs first."""
    known = [run for run in runs if run.changed]
    entries = {entry: (default, unit) for run in known for entry, _, default, unit in run.changed}
    values = {entry: [dict((e, v) for e, v, *_ in run.changed).get(entry, default) for run in known]
              for entry, (default, _) in entries.items()}
    varied = {entry: v for entry, v in values.items() if data.common(v) is None}
    shared = [(entry, v[0], *entries[entry]) for entry, v in values.items() if entry not in varied]
    text = ""
    if varied:
        head = [f"{entry} ({entries[entry][1]})" if entries[entry][1] else entry for entry in varied]
        text += "<h3>Different between the runs</h3>" + table(
            ("run", *head), [(run.label, *(v[i] for v in varied.values()))
                             for i, run in enumerate(known)])
    if shared:
        text += ("<h3>The same in all runs</h3>" if varied else "") + table(
            ("entry", "value", "default", "unit"), shared)
    if text and (unknown := [run.label for run in runs if not run.changed]):
        text += ("<p>Without parameters, because of bad input or not begun: "
                 f"{escape('; '.join(unknown))}.</p>")
    return section("Parameters changed from their default", text)


def timings(runs):
    """Seconds of each phase."""
    phases = {name: None for run in runs for name in run.report.get("seconds_per_phase", {})}
    rows = [(run.label, three_digits(run.report["seconds"]),
             *(three_digits(run.report["seconds_per_phase"].get(name, 0)) for name in phases),
             run.report.get("ranks", 1), run.report.get("cells", ""),
             sum(run.report.get("unknowns", {}).values()))
            for run in runs if "seconds_per_phase" in run.report]
    head = ("run", "seconds", *phases, "ranks", "cells", "unknowns")
    return section("Timings", rows and table(head, rows))


def provenance(directory, runs):
    """How it was started, what was modelled, and the versions."""
    reports = [run.report for run in runs if run.report]
    lines = dict.fromkeys(line for report in reports for line in report.get("modelled", []))
    versions = dict.fromkeys(f"{name} {version}" for report in reports
                             for name, version in report.get("versions", {}).items())
    scenes = dict.fromkeys(report["scene"] for report in reports if report.get("scene"))
    started = data.command(directory)
    items = [f"started by: {started}"] if started else []
    items += [f"scene: {scene}" for scene in scenes] + list(lines) + list(versions)
    items.append(f"this page: {datetime.now().isoformat(' ', 'minutes')}")
    return section("Model and versions",
                   "<ul>" + "".join(f"<li>{escape(item)}</li>" for item in items) + "</ul>")
