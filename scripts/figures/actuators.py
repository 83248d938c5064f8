"""Further actuators, deformed: a balloon, a stack, a gripper, a membrane (doc/actuators.md)."""

import numpy as np
from thelma import plotting
from figures import bodies, render, shapes

WIDTH = 4.0  # mm, of a finger
POTENTIAL = "potential  (kV)"


def whole(body, *normals):
    """The body and its mirror images at planes through the origin."""
    for normal in normals:
        body = bodies.together(body, body.mirrored(normal))
    return body


def outline(scene, body):
    """The sharp edges of the body without voltage."""
    scene.add_edges(body.grid(deformed=False), 0.8, 1.2, 50, color=(0.6, 0.6, 0.6))


def row(states, path, scene_of, colormap, scale, label, pixels_per_mm):
    """A picture of every state beside each other."""
    with render.display():
        pictures = [scene_of(state).picture(pixels_per_mm) for state in states]
    titles = [f"$e = {state.row['e']:.3g}$,  {state.row['voltage_kV']:.2f} kV" for state in states]
    figure, axes = shapes.sheet([pictures], [titles])
    shapes.bar(figure, axes, colormap, scale, label)
    plotting.save(figure, path)


def balloon(folder, path):
    """Half of the balloon, cut open, with its outline before."""
    states = shapes.load_states(folder / "figures/balloon")
    for state in states:
        body = state.body
        outwards = body.points / np.maximum(np.linalg.norm(body.points, axis=1), 1e-9)[:, None]
        body.fields["u_r"] = np.sum(outwards * body.u, axis=1)
    scale = shapes.limits(states, "u_r")

    def scene_of(state):
        scene = render.Scene((-0.45, -1.0, 0.35), (0, 0, 1))
        body = whole(state.body, 0, 2)
        scene.add_body(body, "u_r", shapes.DEFLECTION, scale, render.EDGES)
        outline(scene, body)
        return scene

    row(states, path, scene_of, shapes.DEFLECTION, scale, r"$u_r$  (mm)", 11)


def stack(folder, path):
    """The whole stack, of which a quarter was computed."""
    states = shapes.load_states(folder / "figures/stack")
    scale = shapes.limits(states, "phi")

    def scene_of(state):
        scene = render.Scene((0.45, -1.0, 0.4), (0, 0, 1))
        body = whole(state.body, 1, 2)
        scene.add_body(body, "phi", shapes.POTENTIAL, scale, render.EDGES)
        outline(scene, body)
        return scene

    row(states, path, scene_of, shapes.POTENTIAL, scale, POTENTIAL, 38)


def gripper(folder, path):
    """Both fingers and the line of the palm."""
    states = shapes.load_states(folder / "figures/gripper", WIDTH)
    scale = shapes.limits(states, "phi")

    def scene_of(state):
        scene = render.Scene((0.25, -1.0, 0.3), (0, 0, 1))
        for body in (state.body, state.body.mirrored(0)):
            scene.add_body(body, "phi", shapes.POTENTIAL, scale, render.NO_EDGES)
            scene.add_edges(body.grid(), 0.6, feature_angle=50)
        end = state.body.points[:, 0].max() + 1
        scene.add_polyline([(-end, WIDTH, 0), (end, WIDTH, 0)], (0.3, 0.3, 0.3), 3.0)
        return scene

    row(states, path, scene_of, shapes.POTENTIAL, scale, POTENTIAL, 16)


def membrane(folder, path):
    """The upper film from above; circles: the edge of the electrode, before (grey) and now."""
    states = shapes.load_states(folder / "figures/membrane")
    for state in states:
        body = state.body
        outwards = body.points[:, :2] / np.maximum(np.hypot(*body.points[:, :2].T), 1e-9)[:, None]
        body.fields["u_r"] = np.sum(outwards * body.u[:, :2], axis=1)
    scale = shapes.limits(states, "u_r")

    def scene_of(state):
        scene = render.Scene((0, 0, 1), (0, 1, 0))
        scene.add_body(whole(state.body, 0, 1), "u_r", shapes.DEFLECTION, scale, render.NO_EDGES)
        for radius, color in ((5.0, (0.7, 0.7, 0.7)), (5.0 + state.row["tip_u1_mm"], (1, 1, 1))):
            angle = np.linspace(0, 2 * np.pi, 200)
            scene.add_polyline(np.column_stack([radius * np.cos(angle), radius * np.sin(angle),
                                                np.full_like(angle, 1.0)]), color)
        return scene

    row(states, path, scene_of, shapes.DEFLECTION, scale, r"$u_r$  (mm)", 15)
