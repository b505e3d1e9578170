#!/usr/bin/env python3
"""analyse.py -- temperatures at three depths of a heated bed over time, beside the measured ones.

    analyse.py [-store TEXT]      result.csv, bed.png, heating.png; -store keeps them in stored/

A sensor is the mean of the spheres within two diameters of the middle of the box and one diameter
of the depth below the lid. The reference is a straight line through the points after 3400 s, at
3995 s.

The conductivity of the bed is k of the semi-infinite solid with a lid of constant temperature,

    T - T_0 = (T_lid - T_0) erfc(z/(2 sqrt(k t/(rho c)))),    rho c = 0.58 x 7747 x 464 J/(m3 K)

fitted by least squares to all points of the three depths after 400 s, of the measurement and of the
run alike (Carslaw and Jaeger 1959, 2.5).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import functools
import sys
from pathlib import Path

import numpy
from scipy import optimize, special

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from dem_case import MEASURED, OURS, Result, interval, panels, plt, read_table, render, save, \
    store     # noqa: E402
import spheres     # noqa: E402

D, LID, DEPTHS, END = 6.4e-3, 0.2, (0.040, 0.060, 0.073), 3995.0    # m, m, m, s
START, HOT, CAPACITY = 20.0, 53.0, 0.58*7747*464                      # C, C, J/(m3 K)


@functools.lru_cache(maxsize=None)
def tables(folder):
    """Particles of each output, and the time since the lid is hot [s]."""
    found = [read_table(path) for path in sorted(Path(folder).glob("particles_*.csv"))]
    start = read_table(Path(folder)/"energy.csv")["since"][0]
    return [(t["time"][0] - start, t) for t in found]


def middle(table):
    return [0.5*(table[axis].min() + table[axis].max()) for axis in "xy"]


def sensor(table, depth):
    x, y = middle(table)
    near = (abs(table["x"] - x) < 2*D) & (abs(table["y"] - y) < 2*D) \
        & (abs(LID - depth - table["z"]) < D)
    return table["temperature"][near].mean() - 273.15


def history(folder):
    """Times, and temperatures [C] of the sensors in columns."""
    rows = [(time, *(sensor(table, depth) for depth in DEPTHS)) for time, table in tables(folder)]
    return numpy.array([(0.0, *[20.0]*len(DEPTHS))] + rows)


def at_end(curve):
    return [numpy.interp(END, curve[:, 0], curve[:, 1 + k]) for k in range(len(DEPTHS))]


def slope(folder, depth):
    """Change of the temperature with depth at the end [K/m], over a diameter."""
    _, table = tables(folder)[-1]
    return (sensor(table, depth + D/2) - sensor(table, depth - D/2))/D


def conductivity(depth, time, temperature):
    """Of a semi-infinite solid with these temperatures [W/(m K)]."""
    late = time > 400
    share = (temperature[late] - START)/(HOT - START)

    def error(k):
        return special.erfc(depth[late]/(2*numpy.sqrt(k[0]*time[late]/CAPACITY))) - share

    return optimize.least_squares(error, [0.3]).x[0]


def measured_conductivity():
    table = read_table("measured/beaulieu2020.csv")
    return conductivity(table["depth_m"], table["t_s"], table["T_C"])


def computed_conductivity(curve):
    return conductivity(numpy.repeat(DEPTHS, len(curve)), numpy.tile(curve[:, 0], len(DEPTHS)),
                        curve[:, 1:].T.ravel())


def measured(depth):
    table = read_table("measured/beaulieu2020.csv")
    here = table["depth_m"] == depth
    time, value = table["t_s"][here], table["T_C"][here]
    late = time > 3400
    return time, value, numpy.polyval(numpy.polyfit(time[late], value[late], 1), END)


def solid_fraction(table):
    """Of the spheres between 40 and 160 mm, in the box."""
    inner = (table["z"] > 0.04) & (table["z"] < 0.16)
    area = numpy.prod([numpy.ptp(table[axis]) + D for axis in "xy"])
    return inner.sum()*numpy.pi/6*D**3/(0.12*area)


def draw_bed(folder):
    """The bed at the end, cut through its middle, coloured by temperature."""
    _, table = tables(folder)[-1]
    at = numpy.column_stack([table[axis] for axis in "xyz"])
    behind = at[:, 1] > middle(table)[1]
    lines = render.box(at.min(axis=0) - D/2, at.max(axis=0) + D/2)
    camera = spheres.axes(render.FRONT, (0, 0, 1))
    ends = numpy.concatenate([line @ camera.T for line in lines])[:, :2]
    window = (*ends.min(axis=0), *ends.max(axis=0))
    scale = 500/(window[2] - window[0])
    levels, colours = plt.Normalize(20, 53), plt.cm.inferno
    picture = spheres.draw(at[behind], table["diameter"][behind]/2,
                           colours(levels(table["temperature"][behind] - 273.15))[:, :3],
                           window, scale, render.FRONT)
    figure, axes = plt.subplots(figsize=(3.4, 4.6))
    axes.imshow(picture, extent=(window[0], window[2], window[1], window[3]),
                interpolation="antialiased")
    axes.axis("off")
    bar = figure.colorbar(plt.cm.ScalarMappable(levels, colours), ax=axes, shrink=0.6, pad=0.02)
    bar.set_label("temperature [°C]", fontsize=8)
    save(figure, "bed.png", dpi=160)


def main():
    result = Result()
    folders = sorted(Path("runs").glob("heat.?"))
    curves = [history(folder) for folder in folders]
    finals = numpy.array([at_end(curve) for curve in curves])
    for k, depth in enumerate(DEPTHS):
        result.add("temperature after 3995 s", f"{1e3*depth:.0f} mm below the lid",
                   measured(depth)[2], *interval(finals[:, k]), "C")
    for k, depth in enumerate(DEPTHS):
        result.add("change over a radius of depth", f"{1e3*depth:.0f} mm below the lid", None,
                   *interval([abs(slope(folder, depth))*D/2 for folder in folders]), "K")
    for name, what in (("dark", "without radiation"), ("contacts", "without gas and radiation")):
        for folder in sorted(Path("runs").glob(f"{name}.?")):
            for k, depth in enumerate(DEPTHS):
                result.add(f"the same {what}", f"{1e3*depth:.0f} mm below the lid",
                           None, at_end(history(folder))[k], None, "C")
    result.add("conductivity of the bed", "from all depths", measured_conductivity(),
               *interval([computed_conductivity(curve) for curve in curves]), "W/(m K)")
    result.add("solid fraction", "40 to 160 mm", 0.58,
               *interval([solid_fraction(tables(folder)[-1][1]) for folder in folders]), "1")
    heat = [read_table(folder/"energy.csv") for folder in folders]
    result.add("heat from the lid", "in the run", None,
               *interval([table["heat_walls"][-1] for table in heat]), "J")
    result.add("heat unaccounted for", "over that from the lid", 0,
               max(abs(table["residual"]/table["heat_walls"][-1]).max() for table in heat), None,
               "1")
    result.write()

    figure, (axes,) = panels(1, 5.8, 3.8)
    for k, depth in enumerate(DEPTHS):
        time, value, _ = measured(depth)
        axes.plot(time, value, label=None if k else "measured, Beaulieu 2020", **{**MEASURED, "ms": 3})
        for n, curve in enumerate(curves):
            axes.plot(curve[:, 0], curve[:, 1 + k], color=OURS, lw=1.3,
                      label=None if k or n else f"Suna, {len(curves)} packing{'s'*(len(curves) > 1)}")
        axes.annotate(f"{1e3*depth:.0f} mm deep", (4040, finals[:, k].mean()), fontsize=8,
                      va="center", annotation_clip=False)
    axes.set(xlabel="time since the lid is hot [s]", ylabel="temperature [°C]", xlim=(0, 4020),
             ylim=(19, 34.5))
    axes.legend()
    save(figure, "heating.png")
    draw_bed(folders[0])
    if sys.argv[1:2] == ["-store"]:
        store(sys.argv[2], "bed.png", "heating.png")


if __name__ == "__main__":
    main()
