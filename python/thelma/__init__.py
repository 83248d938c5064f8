"""Thelma from Python: results of the program, and exact solutions.

    import thelma
    curve = thelma.Case(Path("output/hot")).curve()

Physics are the program's alone: a scene is a parameter file, a result is what the program wrote.
"""

import importlib

WHERE = {"Case": "study", "read_study": "study", "read_fields": "fields",
         "ThelmaError": "errors"}


def __getattr__(name):  # only when asked for: on a bare system there is no numpy yet
    if name not in WHERE:
        raise AttributeError(f"module 'thelma' has no attribute '{name}'")
    return getattr(importlib.import_module(f"thelma.{WHERE[name]}"), name)


def __dir__():
    return [*globals(), *WHERE]
