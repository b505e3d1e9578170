#!/usr/bin/env python3
"""evaluate.py -- flux of grains over the Shields number, and the threshold of motion.

    evaluate.py                writes result.csv and shields.png

Shields number  stress on the bed over (rho_p - rho) g d. The stress is the one in the clear liquid under the lid.
flux            volume of grains per width and time over U d, with U = (rho_p - rho) g d^2/(18 mu) Stokes' velocity;
                the mean of the last 0.7 of each interval
threshold       where the flux crosses 0.01 U d: one grain in a hundred of a dense layer, with Stokes' velocity

References
  0.12    laminar shear: Charru, Mouilleron and Eiff, J. Fluid Mech. 519 (2004) 55; Ouriemi, Aussillous, Medale, Peysson
          and Guazzelli, Phys. Fluids 19 (2007) 061706, 0.12 +- 0.03; from memory, without their text at hand
Bounds:
  flux at rest   flux under the slowest lid, 1 % of the one under the fastest: the coupling itself must not move the bed
  exchange       1e-12, an identity

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"shared"))
import results                      # noqa: E402
import side                         # noqa: E402

NAMES = {"bed": "kernel of 2 diameters", "narrow": "kernel of 1 diameter"}       # runs
D, EXCESS, G, MU = 5.8e-4, 200, 9.81, 5e-3      # m, kg/m3, m/s2, Pa s
AREA, HEIGHT = 0.0116*0.00464, 0.00696          # m2, m
STOKES = EXCESS*G*D**2/(18*MU)
LITTLE = 0.01                                   # of the flux, at the threshold
CELLS, LAYERS = 160, 12                         # of the mesh: in a layer


def lid(run):
    """Ends of the intervals and speeds of the lid [s, m/s]."""
    rows = re.findall(r"\(([-+0-9.e]+) \(([-+0-9.e]+) ", (run/"constant/lid").read_text())
    return numpy.array(rows, float)[1::2]


def shields(run, time, speed):
    """From the velocity in the uppermost cells."""
    folder = next(path for path in side.times(run) if abs(float(path.name) - time) < 1e-6)
    velocity = results.field(folder/"U")[-CELLS:, 0].mean()
    return MU*(speed - velocity)/(0.5*HEIGHT/LAYERS)/(EXCESS*G*D)


def fluxes(run):
    """Shields number and flux of each interval."""
    times, _, velocities = results.record(run)
    flux = velocities[:, :, 0].sum(axis=1)*math.pi/6*D**3/AREA/(STOKES*D)
    rows, before = [], 0
    for time, speed in lid(run):
        within = (times > before + 0.3*(time - before)) & (times < time + 1e-9)
        rows.append((shields(run, time, speed), flux[within].mean()))
        before = time
    return numpy.array(rows)


def threshold(rows):
    """Shields number at which the flux is LITTLE, by logarithmic interpolation; None if it is not crossed."""
    rows = rows[numpy.argsort(rows[:, 0])]
    for (low, less), (high, more) in zip(rows, rows[1:]):
        if less < LITTLE <= more:
            part = (LITTLE - less)/(more - less) if less <= 0 else math.log(LITTLE/less)/math.log(more/less)
            return low + part*(high - low)
    return None


def draw(all_rows):
    from style import GREY, OTHER, OURS, REFERENCE, below, panels, save

    figure, (axis,) = panels(1)
    axis.axvspan(0.09, 0.15, color=REFERENCE, alpha=0.2, lw=0, label="measured threshold, 0.12 ± 0.03")
    for (name, rows), colour in zip(all_rows.items(), (OURS, OTHER)):
        axis.plot(*rows[rows[:, 1] > 0].T, "o-", color=colour, label=f"Suna, {name}")
    axis.axhline(LITTLE, color=GREY, lw=0.8, label=f"flux at the threshold, {LITTLE:g} U d")
    axis.set(xlabel="Shields number", ylabel="flux of grains over U d (U: Stokes' velocity)", yscale="log",
             ylim=(1e-4, 3), xlim=(0, None))
    below(figure, columns=1)
    save(figure, HERE/"shields.png")


def main():
    table, all_rows, found = results.Table(), {}, {}
    for folder, name in NAMES.items():
        run = HERE/"runs"/folder
        if not run.exists():
            continue
        rows = all_rows[name] = fluxes(run)
        for number, flux in rows:
            table.add(name, f"flux at a Shields number of {number:.3f}", 0, flux)
        if len(rows) > 3:
            found[name] = threshold(rows)
            table.add(name, "threshold of motion", 0.12, found[name], source="Charru et al. 2004, Ouriemi et al. 2007")
            slowest, fastest = rows[numpy.argmin(rows[:, 0])], rows[numpy.argmax(rows[:, 0])]
            table.add(name, "flux at rest over the largest", 0, abs(slowest[1])/fastest[1], allowed=0.01,
                      source="no shear")
        table.add(name, "exchange of momentum, largest relative error", 0, results.worst(run, "exchange error"),
                  allowed=1e-12, source="identity")
    table.write(HERE)
    if found:
        print("Threshold of motion: Shields number " + ", ".join(f"{value:.2f} ({name})" for name, value in found.items())
              + "; measured 0.12 ± 0.03")
    with results.pictures():
        draw(all_rows)


if __name__ == "__main__":
    main()
