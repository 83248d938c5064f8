"""Elastic and dielectric laws of doc/theory.md (eqs. 5 to 14, 9 to 16), written anew for numpy.

Elastic laws are in units of the shear modulus and without the volumetric energy; a law's parameter is
a number or a tuple:

    Gent: J_m; Mooney-Rivlin: m; Yeoh: (c_2, c_3, ...);
    Ogden: ((alpha, its share of the shear modulus), ...);
    fibres: (k_1/mu, k_2, angle, ...), in degrees in the x1-x2 plane.

Numbers may be complex with tiny imaginary parts.
"""

import numpy as np

VACUUM = 8.8541878e-6  # N/kV^2


def of_invariants(name, parameter, first):
    """Twice the derivatives of W by I_1 and I_2."""
    x = first - 3
    if name == "Gent":
        return parameter / (parameter - x), 0.0
    if name == "Mooney-Rivlin":
        return 1 - parameter, parameter
    if name == "Yeoh":
        return sum((n + 1) * c * x**n for n, c in enumerate((1.0, *parameter))), 0.0
    return 1.0, 0.0  # neo-Hookean, which is the rubber between fibres too


def moduli(parameter):
    """Ogden's (alpha, mu)."""
    return [(alpha, 2 * share / alpha) for alpha, share in parameter]


def fibres(parameter):
    """(unit vector, force by x = |A n|^2 - 1) of each family."""
    k_1, k_2, *angles = parameter
    return [(np.array([np.cos(angle), np.sin(angle), 0.0]),
             lambda x: 2 * k_1 * x * np.exp(k_2 * x**2) if np.real(x) > 0 else 0 * x)
            for angle in np.radians(angles)]


def slopes(name, parameter, a):
    """dW/da_i of three principal stretches (first index)."""
    if name == "Ogden":
        return [sum(mu * (a_i**alpha - 1) for alpha, mu in moduli(parameter)) / a_i for a_i in a]
    first = a[0] ** 2 + a[1] ** 2 + a[2] ** 2
    w_1, w_2 = of_invariants(name, parameter, first)
    at_rest = sum(of_invariants(name, parameter, 3.0)) + of_invariants(name, parameter, 3.0)[1]
    result = [(w_1 + w_2 * (first - a_i**2)) * a_i - at_rest / a_i for a_i in a]
    for n, force in fibres(parameter) if name == "fibres" else ():
        pull = force(sum(n[i]**2 * a[i]**2 for i in range(3)) - 1)
        result = [result[i] + pull * n[i]**2 * a[i] for i in range(3)]
    return result


def stress(name, parameter, A):
    """dW/dA."""
    C, inverse = A.T @ A, np.linalg.inv(A).T
    if name == "Ogden":
        return sum(mu * (A @ power(C, alpha / 2 - 1) - inverse) for alpha, mu in moduli(parameter))
    w_1, w_2 = of_invariants(name, parameter, np.trace(C))
    at_rest = sum(of_invariants(name, parameter, 3.0)) + of_invariants(name, parameter, 3.0)[1]
    result = (w_1 + w_2 * np.trace(C)) * A - w_2 * A @ C - at_rest * inverse
    for n, force in fibres(parameter) if name == "fibres" else ():
        result = result + force(n @ C @ n - 1) * np.outer(A @ n, n)
    return result


def power(C, q):
    """C^q; its imaginary part by Daleckii and Krein's divided differences."""
    c, V = np.linalg.eigh(C.real)
    f = c**q
    difference, middle = c[:, None] - c, (c[:, None] + c) / 2
    near = np.abs(difference) < 1e-5 * middle
    slope = np.where(near, q * middle**(q - 1), (f[:, None] - f) / np.where(near, 1.0, difference))
    real = (V * f) @ V.T
    return real + 1j * V @ (slope * (V.T @ C.imag @ V)) @ V.T if np.iscomplexobj(C) else real


def aligned(x):
    """3 L(x)/x and 6 ln(sinh x/x)/x^2 of Langevin's L."""
    if abs(x) < 0.1:
        z = x * x
        return (1 - z / 15 + 2 * z**2 / 315 - z**3 / 1575 + 2 * z**4 / 31185,
                1 - z / 30 + 2 * z**2 / 945 - z**3 / 6300)
    return 3 * (1 / np.tanh(x) - 1 / x) / x, 6 * (x + np.log((1 - np.exp(-2 * x)) / (2 * x))) / x**2


def field_energy(name, parameter, eps, square):
    """Phi and e = 2 dPhi/d(g.g) of a law -J Phi of the true field's square."""
    if name != "saturating":
        return eps / 2 * square, eps
    chi = eps - VACUUM
    ratio, mean = aligned(3 * chi * np.sqrt(square) / parameter)
    return square / 2 * (VACUUM + chi * mean), VACUUM + chi * ratio


def field_slopes(name, parameter, eps, l, E):
    """-dpsi_d/dlambda_i with a nominal field E along lambda_3, of three stretches."""
    J = l[0] * l[1] * l[2]
    if name == "electrostrictive":
        c_1, c_2 = parameter
        k = 1 + c_1 * (l[2]**2 - 1) + c_2 * (l[0]**2 + l[1]**2 + l[2]**2 - 3)
        half = eps / 2 * E**2 * l[0] * l[1] / l[2]  # -psi_d is k times this
        return [half * (k / l[0] + 2 * c_2 * l[0]), half * (k / l[1] + 2 * c_2 * l[1]),
                half * (-k / l[2] + 2 * (c_1 + c_2) * l[2])]
    Phi, e = field_energy(name, parameter, eps, (E / l[2])**2)
    return [J * Phi / l[0], J * Phi / l[1], J * Phi / l[2] - J * e * E**2 / l[2]**3]


def field_stress(name, parameter, eps, F, E):
    """What the field adds to P, and D."""
    G, J = np.linalg.inv(F).T, np.linalg.det(F)
    g = G @ E
    d, square = G.T @ g, g @ g
    if name == "electrostrictive":
        c_1, c_2 = parameter
        k = 1 - c_1 + c_2 * (np.trace(F.T @ F) - 3)
        Q = k * square + c_1 * E @ E
        return eps * J * (k * np.outer(g, d) - Q / 2 * G - c_2 * square * F), eps * J * (k * d + c_1 * E)
    Phi, e = field_energy(name, parameter, eps, square)
    return J * (e * np.outer(g, d) - Phi * G), J * e * d
