"""Thelma from Python: scenes, runs, results, materials (doc/python.md).

    import thelma
    film = thelma.Scene("prm/planar_actuator.prm", {"Temperature/Value": 353})
    curve = film.run("output/hot").curve()

Physics are the program's alone: a scene is a parameter file, a result is what the program wrote.
"""

import importlib

WHERE = {"Scene": "scene", "Case": "study", "read_study": "study", "read_fields": "fields",
         "MaterialPoint": "material_point", "ThelmaError": "errors"}


def __getattr__(name):  # only when asked for: on a bare system there is no numpy yet
    if name not in WHERE:
        raise AttributeError(f"module 'thelma' has no attribute '{name}'")
    return getattr(importlib.import_module(f"thelma.{WHERE[name]}"), name)


def __dir__():
    return [*globals(), *WHERE]
