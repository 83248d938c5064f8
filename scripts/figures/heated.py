"""The bending actuator heated in time: its rotation, its temperatures and its shapes."""

from thelma import bending_exact
from thelma import plotting
from thelma import study
from figures import render, shapes
from thelma.plotting import DASHED, GREY, plt

COLUMNS = ("time_s", "mid_rotation_deg", "theta_K", "theta_min_K", "theta_max_K", "e")


def last_case(folder):
    """The longest run of the study."""
    return study.read_study(folder / "figures/heated_bending")[-1]


def warm_rotation(case, table):
    """Rotation of mid-length in degrees when all of the body has the temperature of its wall."""
    material, wall = case.material(), float(table["theta_max_K"][-1])
    start = float(table["theta_K"][0])
    e = float(table["e"][-1]) * material.field(1.0, start) / material.field(1.0, wall)
    circle = bending_exact.circles(material, wall, [e])[0]
    return circle.rotation(shapes.LENGTH / shapes.LAYER / 2)


def history(folder, path):
    """Rotation and temperatures over time."""
    case = last_case(folder)
    table = case.curve(*COLUMNS)
    later = table["time_s"] > 0
    time = table["time_s"][later]
    figure, (turn, heat) = plt.subplots(1, 2, figsize=(8.2, 3.6), constrained_layout=True)
    turn.plot(time, table["mid_rotation_deg"][later], color=plotting.COLD_TO_HOT(0.5))
    turn.axhline(warm_rotation(case, table), color=GREY, linestyle=DASHED, linewidth=1.0)
    turn.set_ylabel("rotation at mid-length  (°)")
    turn.legend(handles=[plotting.line("exact, warm throughout", linestyle=DASHED)],
                frameon=False, loc="center left")
    for name, label, color in (("theta_max_K", "highest", 0.95), ("theta_K", "mean", 0.5),
                               ("theta_min_K", "lowest", 0.05)):
        heat.plot(time, table[name][later], color=plotting.COLD_TO_HOT(color), label=label)
    heat.set_ylabel(r"temperature  $\theta$  (K)")
    heat.legend(frameon=False, loc="lower right")
    for panel, name in ((turn, "(a)"), (heat, "(b)")):
        panel.set_xscale("log")
        panel.set_xlim(time[-1] / 4e3, time[-1])
        panel.set_xlabel(r"time  $t$  (s)")
        panel.set_title(name, loc="left", fontsize=11)
    plotting.save(figure, path)


def moments(folder, path):
    """Shapes at the ends of all runs, coloured by temperature."""
    states = shapes.load_states(folder / "figures/heated_bending", shapes.WIDTH)
    scale = shapes.limits(states, "theta")
    pictures = []
    with render.display():
        for state in states:
            scene = render.Scene(*shapes.FROM_THE_SIDE)
            scene.add_body(state.body, "theta", plotting.COLD_TO_HOT, scale, render.NO_EDGES)
            scene.add_edges(state.body.grid(), 0.6, feature_angle=50)
            pictures.append(scene.picture(16))
    titles = [f"{state.case.curve('time_s')['time_s'][-1]:g} s" for state in states]
    half = (len(states) + 1) // 2
    rows = [pictures[:half], pictures[half:]] if len(states) > 1 else [pictures]
    figure, axes = shapes.sheet(rows, [titles[:half], titles[half:]])
    shapes.bar(figure, axes, plotting.COLD_TO_HOT, scale, r"$\theta$  (K)")
    plotting.save(figure, path)
