#!/usr/bin/env python3
"""analyse.py -- slope of the heaps on the plate over friction and rolling resistance, beside Zhou
et al. (2002).

    analyse.py [-store "text"]       result.csv, repose.png; with -store also stored/ and the table of results.md

Height    volume of the spheres in slices of one diameter, over slice and a solid fraction of 0.57
          (1 % of it shifts the slope by 0.3 degrees at 25 degrees)
Slope     straight line through each flank, from two diameters inside the edge of the plate to four
          fifths of the top
Interval  95 %, both flanks of each run (seed)

Zhou, Xu, Yu, Zulli, Powder Technol. 125 (2002) 45:

    angle = 68.61 f^0.27 f_w^0.22 r^0.06 r_w^0.12 d^-0.2 degrees

with d and the levers of rolling resistance r (between spheres) and r_w (at the plate) in mm;
r = 0.25 d and r_w = 0.5 d times our coefficient.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import numpy
from dem_case import OURS, POINTS, REFERENCE, Result, below, interval, panel, panels, pictures, plain_ticks, \
    read_vtp, render, save, shades, store

D, EDGE, PACKING = 5e-3, 0.1, 0.57


def zhou(friction, rolling, d=5.0):
    return 68.61*friction**0.49*(0.25*d*rolling)**0.06*(0.5*d*rolling)**0.12*d**-0.2


def flanks(folder, spheres=1):
    """Slopes of both flanks [degrees], and the profile; each particle has this many spheres."""
    columns = read_vtp(pictures(folder)[-1][1])
    at = columns["points"][(columns["points"][:, 2] > 0) & (abs(columns["points"][:, 0]) < EDGE)]
    depth = 0.0125 if len(at) and at[:, 1].max() < 0.0126 else 0.02
    edges = numpy.linspace(-EDGE, EDGE, 41)
    x = 0.5*(edges[1:] + edges[:-1])
    height = numpy.histogram(at[:, 0], edges)[0]*numpy.pi/6*D**3/spheres/(D*depth*PACKING)
    smooth = numpy.convolve(height, [0.25, 0.5, 0.25], "same")
    top = smooth.max()
    peak = x[smooth > 0.8*top]
    slopes = []
    for side, inner in ((-1, peak.min()), (1, peak.max())):
        on = (side*x < EDGE - 2*D) & (side*x > side*inner)
        slopes.append(numpy.degrees(numpy.arctan(-side*numpy.polyfit(x[on], height[on], 1)[0])))
    return slopes, (x, height)


def draw(runs):
    """The heaps of the smallest and the largest friction, one above the other."""
    heaps = [panel(f"friction {friction:g}, resistance to rolling {rolling:g}",
                    pictures(f"runs/{friction:g}-{rolling:g}.1")[-1][1])
              for friction, rolling in (min(runs), max(runs))][:len(runs)]
    depth = max(p.position[:, 1].max() for p in heaps)
    heaps = [render.Panel(p.title, *(x[p.position[:, 2] > 0] for x in p[1:])) for p in heaps]
    render.draw("heap.png", heaps, render.box((-EDGE, 0, 0), (EDGE, depth, 0.06)), "plain",
                width=6, rows=len(heaps), pixels=800)


def profile(runs):
    """Mean of all seeds and of both sides of the heap: the distance from its middle, the height."""
    x = runs[0][1][0]
    height = numpy.mean([h for _, (_, h) in runs], axis=0)
    half = len(x)//2
    return x[-half:], 0.5*(height[-half:] + height[:half][::-1])


def draw_slopes(rows, found):
    figure, (left, middle, right) = panels(3, 12, width_ratios=(1, 1, 1.3))
    for axes, name, vary, fixed, at in ((left, "friction (resistance to rolling 0.04)", 0, 1, 0.04),
                                        (middle, "resistance to rolling (friction 0.4)", 1, 0, 0.4)):
        chosen = rows[rows[:, fixed] == at]
        if len(chosen):
            c = numpy.geomspace(0.8*chosen[:, vary].min(), 1.2*chosen[:, vary].max(), 50)
            axes.plot(c, zhou(c, at) if vary == 0 else zhou(at, c), color=REFERENCE, lw=1.2,
                      label="fit to measurements, Zhou et al. 2002")
            axes.errorbar(chosen[:, vary], chosen[:, 2], chosen[:, 3], marker="s", color=OURS,
                          label="Suna, mean and 95 % interval", **POINTS)
            axes.set(xlabel=name, ylabel="slope [degrees]", ylim=(0, None), xscale="log" if vary else "linear")
            if vary:
                plain_ticks(axes.xaxis, chosen[:, vary])
    heaps = sorted(found.items(), key=lambda item: numpy.mean(numpy.concatenate([s for s, _ in item[1]])))
    for ((friction, rolling), runs), colour in zip(heaps, shades(len(heaps))):
        x, height = profile(runs)
        right.plot(1e3*x, 1e3*height, color=colour, label=f"friction {friction:g}, rolling {rolling:g}")
    right.set(xlabel="distance from the middle [mm]", ylabel="height of the heap [mm]", xlim=(0, None),
              ylim=(0, None))
    right.legend()
    below(figure, left, columns=2)
    save(figure, "repose.png")


def main():
    found = {}
    for folder in sorted(Path("runs").glob("*-*.?")):
        if folder.is_dir() and not folder.name.startswith("fill"):
            point, seed = folder.name.rsplit(".", 1)
            friction, rolling = map(float, point.split("-"))
            found.setdefault((friction, rolling), []).append(flanks(folder))
    result = Result()
    rows = []
    for (friction, rolling), runs in sorted(found.items()):
        angle = interval(numpy.concatenate([slopes for slopes, _ in runs]))
        rows.append((friction, rolling, *angle))
        result.add("slope of the heap", f"friction {friction:g} rolling {rolling:g}",
                   zhou(friction, rolling), *angle, "degrees")
    wet = [flanks(folder) for folder in sorted(Path("runs").glob("wet.?")) if folder.is_dir()]
    if wet:
        dry = found[(0.6, 0.04)]
        result.add("slope of the heap", "wet friction 0.6 rolling 0.04",
                   numpy.mean([slopes for slopes, _ in dry]),
                   *interval(numpy.concatenate([slopes for slopes, _ in wet])), "degrees")
        spheres = [numpy.mean([height.sum() for _, (_, height) in runs]) for runs in (wet, dry)]
        result.add("spheres that stay", "wet over dry", None, spheres[0]/spheres[1], None, "1")
    clumps = [flanks(folder, 2) for folder in sorted(Path("runs").glob("clumps.?")) if folder.is_dir()]
    if clumps and (0.4, 0.01) in found:
        round_ = numpy.mean([slopes for slopes, _ in found[(0.4, 0.01)]])
        result.add("slope of the heap", "clumps friction 0.4 rolling 0.01", round_,
                   *interval(numpy.concatenate([slopes for slopes, _ in clumps])), "degrees")
    rows = numpy.array(rows)
    for name, vary, fixed, at, reference in (("friction", 0, 1, 0.04, 0.49),
                                             ("resistance to rolling", 1, 0, 0.4, 0.18)):
        chosen = rows[rows[:, fixed] == at]
        if len(chosen) > 1:
            exponent = numpy.polyfit(numpy.log(chosen[:, vary]), numpy.log(chosen[:, 2]), 1)[0]
            # at the two ends of the line
            low, high = chosen[0], chosen[-1]
            ci95 = numpy.hypot(low[3]/low[2], high[3]/high[2])/numpy.log(high[vary]/low[vary])
            result.add("exponent of the slope over " + name, "all points", reference, exponent,
                       ci95, "1")
    result.write()

    draw_slopes(rows, found)
    draw(found)
    if sys.argv[1:2] == ["-store"]:
        store(sys.argv[2], "repose.png", "heap.png")


if __name__ == "__main__":
    main()
