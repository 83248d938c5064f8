"""A slab with both faces stepped from 293 to 353 K: its Fourier series (doc/theory.md, eq. 41)."""

import math

START, WALL = 293.0, 353.0  # K
THICKNESS, CAPACITY, CONDUCTIVITY = 1.0, 1.92, 0.16
DIFFUSION_TIME = THICKNESS**2 * CAPACITY / (math.pi**2 * CONDUCTIVITY)  # 1.216 s


def mid_temperature(time):
    """Temperature in the middle."""
    series = sum((-1)**k / (2 * k + 1) * math.exp(-(2 * k + 1)**2 * time / DIFFUSION_TIME)
                 for k in range(2000))
    return WALL - (WALL - START) * 4 / math.pi * series
