#!/usr/bin/env python3
"""analyse.py -- discharged mass over time, and the rate over the width of the slot, beside Anand et
al. and Beverloo's law.

    analyse.py [-store "text"]       result.csv, silo.png; with -store also stored/ and the table of results.md

Rate          straight line through the discharged mass from 0.15 s to 0.45 s after the opening
              (0.1 s to 0.25 s in the short form): the flow is steady, the slot still covered
Interval      95 %, from five blocks of that time in each run (seed), taken together
Beverloo      W = C rho_b sqrt(g) b (w - k d)^1.5 for a slot w wide and b deep, C = 1.03, k = 1.4
              (Brown and Richards 1970; Nedderman, Statics and Kinematics of Granular Materials,
              1992); rho_b of the lower 40 mm of the bed before the opening
Anand et al.  measured/anand2008.csv: their simulation of this bin, slot and bead, Chem. Eng. Sci.
              63 (2008) 5821

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import numpy
from dem_case import GREY, MEASURED, OTHER, OURS, POINTS, REFERENCE, Result, interval, panels, read_table, \
    save, store

D, DEPTH, WIDTH, BEADS = 2.24e-3, 0.0056, 0.12544, 6790
MASS = numpy.pi/6*D**3*2500
C, K = 1.03, 1.4


def discharge(folder):
    """Time since the opening and discharged mass [kg]."""
    rows = read_table(f"{folder}/flows.csv")
    return rows["time"] - 0.4, rows["mass"]


def rate(folder):
    """kg/s, and the same in five blocks of the time."""
    t, m = discharge(folder)
    span = (0.15, 0.45) if t[-1] > 0.5 else (0.1, t[-1])
    chosen = (t > span[0] - 1e-9) & (t < span[1] + 1e-9)
    steps = numpy.diff(m[chosen])/numpy.diff(t[chosen])
    return numpy.polyfit(t[chosen], m[chosen], 1)[0], steps


def anand():
    """The steady part of the published curve: from 20 to 60 g."""
    t, m = numpy.loadtxt("measured/anand2008.csv", delimiter=",", skiprows=2).T
    chosen = (m > 20) & (m < 64)
    return t, m, numpy.polyfit(t[chosen], m[chosen], 1)[0]


def beverloo(width, bulk, c=C, k=K):
    return c*bulk*numpy.sqrt(9.81)*DEPTH*(width - k*D)**1.5


def draw(found, bulk, soft, measured):
    time, mass, published = measured
    figure, (left, right) = panels(2, 9.5)
    left.plot(time, mass, label="simulation, Anand et al. 2008, slot of 11.2 d", **MEASURED)
    for (kind, width), folders in sorted(found.items()):
        t, m = discharge(folders[0])
        left.plot(t, 1e3*m, color={8: OTHER, 11.2: OURS, 15: GREY}.get(width, "k"), lw=1.5,
                  ls="--" if kind == "stiff" else "-",
                  label=f"Suna, slot of {width:g} d" + (", E = 3e7 Pa" if kind == "stiff" else ""))
    left.set(xlabel="time since the opening [s]", ylabel="discharged mass [g]", xlim=(0, 1.2), ylim=(0, None))
    w = numpy.linspace(3, 17, 100)*D
    right.plot(w/D, 1e3*beverloo(w, bulk), color=REFERENCE, lw=1.2, label="Beverloo's law, C 1.03, k 1.4")
    right.plot(11.2, published, label="simulation, Anand et al. 2008", **{**MEASURED, "ms": 7})
    right.errorbar(soft[:, 0]/D, 1e3*soft[:, 1], 1e3*soft[:, 2], marker="s", color=OURS,
                   label="Suna, mean and 95 % interval", **POINTS)
    right.set(xlabel="width of the slot over diameter w/d", ylabel="discharge rate [g/s]", xlim=(0, 17),
              ylim=(0, None))
    left.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2))
    right.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2))
    save(figure, "silo.png")


def main():
    result = Result()
    found = {}
    for folder in sorted(Path("runs").glob("s*.*.*")):
        if folder.is_dir():
            kind, rest = folder.name.split(".", 1)
            width, seed = rest.rsplit(".", 1)
            found.setdefault((kind, float(width)), []).append(folder)
    bulk = read_bulk()
    time, mass, published = anand()
    rates = {}
    for (kind, width), folders in sorted(found.items()):
        each = [rate(folder) for folder in folders]
        mean = interval(numpy.concatenate([[block.mean() for block in numpy.array_split(steps, 5)]
                                           for _, steps in each]))
        rates[kind, width] = mean
        where = f"slot of {width:g} d" + (" at E = 3e7 Pa" if kind == "stiff" else "")
        if width == 11.2:
            result.add("rate (Anand et al.)", where, published, 1e3*mean[0], 1e3*mean[1], "g/s")
        result.add("rate (Beverloo's law)", where, 1e3*beverloo(width*D, bulk), 1e3*mean[0],
                   1e3*mean[1], "g/s")
    soft = numpy.array([(width*D, *value) for (kind, width), value in sorted(rates.items())
                        if kind == "soft"])
    if len(soft) > 2:
        # W^(2/3) is linear in w: its zero is k d, its slope gives C
        slope, start = numpy.polyfit(soft[:, 0], soft[:, 1]**(2/3), 1)
        k, c = -start/slope/D, slope**1.5/(bulk*numpy.sqrt(9.81)*DEPTH)
        result.add("k of (w - k d)^1.5", "through the three slots", K, k, None, "1")
        result.add("C", "with that k", C, c, None, "1")
    result.write()

    draw(found, bulk, soft, (time, mass, published))
    if sys.argv[1:2] == ["-store"]:
        store(sys.argv[2], "silo.png")


def read_bulk():
    """Bulk density of the bed at rest, from the means of fill.dem over its lower 40 mm."""
    return numpy.mean([read_table(path)["bulkDensity"].mean()
                       for path in Path("runs").glob("fill.*/bed.csv")])


if __name__ == "__main__":
    main()
