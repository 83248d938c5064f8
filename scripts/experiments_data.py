"""Published tests of the acrylic VHB, for scripts/experiments. Nominal stresses in kPa, Celsius, 1/s, kV."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Source:
    """Where numbers are from."""

    short: str
    full: str


HOSSAIN = Source("Hossain et al. 2012",
                 "Hossain, Vu and Steinmann, *Comput. Mater. Sci.* 59 (2012) 65")
WANG = Source("Wang et al. 2016",
              "Wang, Decker, Henann and Chester, *J. Mech. Phys. Solids* 95 (2016) 213")
LIAO = Source("Liao et al. 2019", "Liao, Hossain, Yao, Mehnert and Steinmann, *Int. J. Non-Linear Mech.* (2019)")
ALKHOURY = Source("Alkhoury et al. 2022", "Alkhoury, Chester and co-workers, *Int. J. Solids Struct.* (2022), "
                  "doi 10.1016/j.ijsolstr.2022.111523")
MEHNERT = Source("Mehnert et al. 2021", "Mehnert, Hossain and Steinmann (2021)")

# Peak at lambda = 2.5 by rate, VHB 4910.
HOSSAIN_STRETCH = 2.5
HOSSAIN_PEAKS = {0.01: 42.9, 0.03: 49.5, 0.05: 54.7}

# Peak at lambda = 4 by rate and temperature, VHB 4905.
LIAO_STRETCH = 4.0
LIAO_CELSIUS = (-20, 0, 20, 40, 60, 80)
LIAO_PEAKS = {0.1: (2600, 269.9, 117.3, 99.2, 75.1, 69.9),
              0.03: (1109, 182, 95.3, 79.2, 65.5, 62.2)}

# VHB 4910: peak at lambda = 2 and 0.1 /s, and the stress left at lambda = 3.5 after an hour.
ALKHOURY_STRETCH, ALKHOURY_RATE = 2.0, 0.1
ALKHOURY_PEAKS = {0: 386, 24: 108, 40: 84, 50: 74, 60: 70}
RELAXED_STRETCH, RELAXED_AFTER = 3.5, 3600.0
ALKHOURY_RELAXED = {0: 79.6, 40: 80.1, 50: 76.2, 60: 71.9}

# Stress at lambda = 2.95 and 0.2 /s by temperature and voltage.
MEHNERT_STRETCH, MEHNERT_RATE = 2.95, 0.2
MEHNERT_STRESSES = {23: {0: 117.6, 6: 107.9}, 50: {0: 72.2, 6: 64.5}}

# Relative permittivity of VHB near 0.1 Hz by temperature.
PERMITTIVITIES = {0: 4.907, 20: 4.732, 40: 4.599, 80: 4.442}
