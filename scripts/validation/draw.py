"""What all kinds of scenes draw alike."""

from dataclasses import replace

import numpy as np

from validation.material import Material

LAWS = ("neo-Hookean", "neo-Hookean", "Gent", "Mooney-Rivlin", "Yeoh", "Ogden")


def log_uniform(rng, low, high):
    """A number whose logarithm is uniform."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def material(rng, elastic=None):
    """A rubber at a temperature."""
    elastic = elastic or str(rng.choice(LAWS))
    parameter = {"Gent": log_uniform(rng, 15, 120), "Mooney-Rivlin": float(rng.uniform(0.1, 0.7)),
                 "Yeoh": (float(rng.uniform(-0.004, 0.01)), log_uniform(rng, 2e-5, 3e-4)),
                 "Ogden": ogden_terms(rng)}.get(elastic, 0.0)
    theta, alpha = temperature(rng), expansion(rng)
    if rng.random() < 0.4:  # the default laws of temperature
        return Material(elastic, parameter, K=56.552, alpha=alpha, theta=theta)
    mu = log_uniform(rng, 0.01, 0.5)
    eps = (2e-5, 6e-6) if rng.random() < 0.3 else (float(rng.uniform(2.5e-5, 5e-5)),)
    return Material(elastic, parameter, (mu,), eps, mu * log_uniform(rng, 500, 2000), alpha, theta=theta)


def ogden_terms(rng):
    """(exponent, share of the shear modulus) of three terms."""
    stiff, inverse = float(rng.uniform(0.01, 0.05)), float(rng.uniform(0, 0.15))
    return ((float(rng.uniform(1.5, 2.2)), 1 - stiff - inverse), (float(rng.uniform(3.5, 5)), stiff),
            (-float(rng.uniform(1, 2.5)), inverse))


def with_fibres(rng, m):
    """The same rubber between two families in the x1-x2 plane, as far to both sides of x1."""
    angle = float(rng.uniform(15, 75))
    return replace(m, elastic="fibres",
                   parameter=(log_uniform(rng, 0.1, 5), float(rng.uniform(0, 0.3)), angle, -angle))


def polarised(rng, m):
    """The same rubber with a dielectric that is not ideal."""
    if rng.random() < 0.5:
        return replace(m, dielectric="electrostrictive",
                       electric=(float(rng.uniform(-0.1, 0.2)), float(rng.uniform(-0.02, 0.03))))
    # Of what ideal dipoles have at the field that makes e = 1.
    return replace(m, dielectric="saturating", electric=log_uniform(rng, 1, 10) * m.eps * of_one(m))


def temperature(rng):
    """Half at the reference, where nothing expands."""
    return 293.0 if rng.random() < 0.3 else float(round(rng.uniform(273, 353)))


def expansion(rng):
    """alpha in 1/K."""
    return 0.0 if rng.random() < 0.3 else log_uniform(rng, 1e-6, 3e-4)


def of_one(m):
    """The field that makes e = 1, in kV/mm."""
    return float(np.sqrt(m.mu / m.eps))


def told(m):
    """A material in a few words."""
    numbers = " ".join(f"{number:.3g}" for number in np.ravel(m.parameter) if number)
    name = f"{m.elastic} {numbers}".strip() + ("" if m.dielectric == "ideal" else
                                               f", {m.dielectric} {np.array2string(np.array(m.electric), precision=3)}")
    return f"{name}, mu {m.mu:.3g} MPa, K/mu {m.K / m.mu:.0f}, alpha {m.alpha:.1e}, {m.theta:g} K"
