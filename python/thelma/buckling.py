"""The buckling field of an imperfect layer from its curve, after Southwell.

Near the buckling field e_cr the deflection w follows (doc/theory.md, eq. 50)

    w = (e/e_cr)^2 (w + w_0) - b w^3,

with w_0 the part of the imperfection that looks like the buckling mode and b the curvature of the
path behind the bifurcation. Divided by w this is linear in 1/e_cr^2, w_0/e_cr^2 and b: least
squares over the states with small w give them, on both sides of the bifurcation and of the layer.
"""

import numpy as np


def buckling_field(e, deflection, thickness):
    """e_cr from the fields e and the deflections of a curve; all lengths in one unit."""
    e, w = np.asarray(e), np.asarray(deflection)
    near = (w != 0) & (np.abs(w) < thickness / 2)
    if np.count_nonzero(near) < 4:
        raise ValueError("fewer than four states with a deflection below half the thickness")
    e2, w = e[near] ** 2, w[near]
    terms = np.column_stack([e2, e2 / w, -w**2])
    return np.linalg.lstsq(terms, np.ones_like(w), rcond=None)[0][0] ** -0.5
