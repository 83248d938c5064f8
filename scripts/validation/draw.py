"""What all kinds of scenes draw alike."""

import numpy as np

from validation.material import Material

LAWS = ("neo-Hookean", "neo-Hookean", "Gent", "Mooney-Rivlin")


def log_uniform(rng, low, high):
    """A number whose logarithm is uniform."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def material(rng, elastic=None):
    """A rubber at a temperature."""
    elastic = elastic or str(rng.choice(LAWS))
    parameter = {"Gent": log_uniform(rng, 15, 120),
                 "Mooney-Rivlin": float(rng.uniform(0.1, 0.7))}.get(elastic, 0.0)
    theta, alpha = temperature(rng), expansion(rng)
    if rng.random() < 0.4:  # the default laws of temperature
        return Material(elastic, parameter, K=56.552, alpha=alpha, theta=theta)
    mu = log_uniform(rng, 0.01, 0.5)
    eps = (2e-5, 6e-6) if rng.random() < 0.3 else (float(rng.uniform(2.5e-5, 5e-5)),)
    return Material(elastic, parameter, (mu,), eps, mu * log_uniform(rng, 500, 2000), alpha, theta=theta)


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
    name = m.elastic + (f" {m.parameter:.3g}" if m.parameter else "")
    return f"{name}, mu {m.mu:.3g} MPa, K/mu {m.K / m.mu:.0f}, alpha {m.alpha:.1e}, {m.theta:g} K"
