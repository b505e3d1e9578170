"""units.py -- the unit systems of LIGGGHTS and LAMMPS that have dimensions, in SI.

SPDX-License-Identifier: GPL-3.0-or-later
"""

BASE = {"si": (1.0, 1.0, 1.0), "cgs": (1e-2, 1e-3, 1.0),    # length [m], mass [kg], time [s]
        "micro": (1e-6, 1e-15, 1e-6), "nano": (1e-9, 1e-21, 1e-9)}

# powers of length, mass, time
POWERS = {"length": (1, 0, 0), "mass": (0, 1, 0), "time": (0, 0, 1), "number": (0, 0, 0),
          "velocity": (1, 0, -1), "acceleration": (1, 0, -2), "spin": (0, 0, -1),
          "density": (-3, 1, 0), "pressure": (-1, 1, -2), "inverse pressure": (1, -1, 2), "energy density": (-1, 1, -2),
          "force": (1, 1, -2), "torque": (2, 1, -2), "stiffness": (0, 1, -2), "damping": (0, 1, -1),
          "viscosity": (-1, 1, -1), "mass rate": (0, 1, -1), "rate": (0, 0, -1),
          "surface energy": (0, 1, -2), "conductivity": (1, 1, -3), "heat capacity": (2, 0, -2)}


class Units:
    def __init__(self, name="si"):
        self.name = name

    def si(self, kind, value):
        if self.name == "si":
            return value
        factor = 1.0
        for base, power in zip(BASE[self.name], POWERS[kind]):
            factor *= base**power
        return float(f"{value*factor:.15g}")
