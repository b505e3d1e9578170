#!/usr/bin/env python3
"""analyse.py -- run-out and height of collapsed columns over their aspect ratio, beside measured
scalings.

    analyse.py [-store "text"]       result.csv, collapse.png (rolling.png with -rolling,
                                     walls.png with -walls, none with -causes); with -store also stored/ and its table
                                     in results.md

Height    of the deposit h(x): volume of the beads in slices of one diameter, over slice and solid
          fraction of the column at rest
Run-out   where h, seen from the back wall, falls below one diameter for good; single beads that
          roll on do not count
Column    its length L at rest; its height is 2 <z>, as for an even column
Interval  95 % of independent runs (seeds)

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import numpy
from dem_case import OTHER, OURS, POINTS, REFERENCE, Result, below, interval, panel, panels, pictures, \
    plain_ticks, read_vtp, render, save, shades, store

D, LENGTH = 2e-3, 0.032
WIDTH = 0.01                                        # m, of the channel
WIDE = 0.03                                         # m, with -causes
NAMES = {"free": "spheres", "rolling": "with resistance to rolling", "walls": "between walls",
         "back": "rough back wall", "gate": "gate lifted at 1 m/s", "wide": "walls 15 d apart"}


def beads(folder, place):
    """Positions of the moving beads; fixed ones are below z = 0."""
    at = read_vtp(pictures(folder)[place][1])["points"]
    return at[at[:, 2] > 0]


def run(kind, a, seed):
    """Aspect ratio, run-out and height of one run, and the deposit's profile."""
    column = beads(f"runs/settle.{kind}.{a}.{seed}", -1)
    height = 2*column[:, 2].mean()
    width = WIDE if kind == "wide" else WIDTH
    packing = len(column)*numpy.pi/6*D**3/(LENGTH*width*height)
    rest = beads(f"runs/{kind}.{a}.{seed}", -1)
    edges = numpy.arange(0, rest[:, 0].max() + 2*D, D)
    profile = numpy.histogram(rest[:, 0], edges)[0]*numpy.pi/6*D**3/(D*width*packing)
    low = numpy.flatnonzero(profile < D)[0]
    # between the last slice above a diameter and the first below
    above = profile[low - 1] if low else profile[0]
    end = edges[low] + 0.5*D - D*(D - profile[low])/max(above - profile[low], 1e-12) if low else 0.0
    return height/LENGTH, (end - LENGTH)/LENGTH, profile[:3].mean()/LENGTH, (edges[:-1] + 0.5*D,
        profile)


def draw(runs):
    """The tallest column of spheres, or the only one: at the start, while it falls, at its end."""
    kind, a = max(runs)
    start = pictures(f"runs/settle.{kind}.{a:g}.1")[-1]
    shown = pictures(f"runs/{kind}.{a:g}.1")
    instants = [panel(f"{time - start[0]:.2f} s", path)
                for time, path in (start, *shown[:2], shown[-1])]
    length = max(p.position[:, 0].max() for p in instants)
    top = instants[0].position[:, 2].max()
    render.draw("column.png", instants, render.box((0, 0, 0), (length, WIDTH, top)), "speed",
                numpy.sqrt(9.81*top), width=7, rows=len(instants), pixels=900)


def lajeunesse(a):
    return numpy.where(a < 3, 1.8*a, 2.3*a**(2/3))


def lube(a):
    return numpy.where(a < 1.8, 1.2*a, 1.9*a**(2/3))


def lube_height(a):
    return numpy.where(a < 1.15, a, 0.65*a**0.4)


def profile(runs):
    """The deposit's mean height over all seeds and over four slices: slices of one bead scatter."""
    length = max(len(h) for _, _, _, (_, h) in runs)
    mean = numpy.mean([numpy.pad(h, (0, length - len(h))) for _, _, _, (_, h) in runs], axis=0)
    mean = numpy.pad(mean, (0, -length % 4)).reshape(-1, 4).mean(axis=1)
    return (4*numpy.arange(len(mean)) + 2)*D, mean


def draw_scalings(points, found, picture):
    figure, (left, right, deposit) = panels(3, 12)
    # each law up to its kink and from there on
    for axes, law, kink, dashes, label in (
            (left, lajeunesse, 3, "-", "glass beads, Lajeunesse et al. 2005"),
            (left, lube, 1.8, "--", "sand, rice, sugar, Lube et al. 2005"),
            (right, lube_height, 1.15, "--", "sand, rice, sugar, Lube et al. 2005")):
        for part, a in enumerate((numpy.geomspace(0.3, 0.999*kink), numpy.geomspace(kink, 10))):
            axes.loglog(a, law(a), color=REFERENCE, ls=dashes, lw=1.2, label=None if part else label)
    for kind, colour, label in (("free", OURS, "Suna, mean of three seeds, 95 % interval"),
                                ("rolling", OTHER, "Suna with resistance to rolling, 95 % interval"),
                                ("walls", OTHER, "Suna between walls, 95 % interval")):
        if kind in points:
            # a seed alone has no interval
            p = numpy.nan_to_num(numpy.array(points[kind]))
            for axes, value, half in ((left, p[:, 1], p[:, 2]), (right, p[:, 3], p[:, 4])):
                axes.errorbar(p[:, 0], value, half, marker="o", color=colour, label=label, **POINTS)
    left.set(xlabel="aspect ratio a: height over length L", ylabel="run-out over length L")
    right.set(xlabel="aspect ratio a: height over length L", ylabel="final height over length L")
    plain_ticks(left.yaxis, (0.5, 1, 2, 5, 10))
    plain_ticks(right.yaxis, (0.3, 0.5, 1, 1.5))
    for axes in (left, right):
        plain_ticks(axes.xaxis, (0.5, 1, 2, 4, 8))
    shown = [runs for (kind, _), runs in sorted(found.items()) if kind == min(points, default="free")]
    for runs, colour in zip(shown, shades(len(shown))):
        x, h = profile(runs)
        deposit.plot(x/LENGTH, h/LENGTH, color=colour, label=f"a = {numpy.mean([r[0] for r in runs]):.2g}")
    deposit.set(xlabel="distance from the back wall over L", ylabel="height of the deposit over L",
                xlim=(0, None), ylim=(0, None))
    deposit.legend()
    below(figure, left, columns=3)
    save(figure, picture)


def main():
    found = {}
    for folder in sorted(Path("runs").glob("*.*.*")):
        if folder.is_dir() and not folder.name.startswith("settle"):
            kind, rest = folder.name.split(".", 1)
            a, seed = rest.rsplit(".", 1)
            found.setdefault((kind, float(a)), []).append(run(kind, a, seed))
    result = Result()
    points = {}
    for (kind, a), runs in sorted(found.items()):
        aspect = numpy.mean([r[0] for r in runs])
        out, height = interval([r[1] for r in runs]), interval([r[2] for r in runs])
        points.setdefault(kind, []).append((aspect, *out, *height))
        name = NAMES[kind]
        other = lube if kind == "rolling" else lajeunesse
        result.add("run-out (L_end - L)/L", f"{name} a = {aspect:.2f}", float(other(aspect)), *out,
                   "1")
        result.add("height H_end/L", f"{name} a = {aspect:.2f}",
                   min(aspect, 0.65*aspect**0.4) if aspect > 1.15 else aspect, *height, "1")
    for kind in points:
        name = NAMES[kind]
        picked = [found[key] for key in sorted(found) if key[0] == kind and key[1] >= 1]
        if len(picked) > 2:
            slopes = [[numpy.polyfit(numpy.log([runs[k][0] for runs in picked]),
                                     numpy.log([runs[k][place] for runs in picked]), 1)[0]
                       for k in range(min(len(runs) for runs in picked))] for place in (1, 2)]
            result.add("exponent of the run-out", f"{name} a >= 1", 0.9, *interval(slopes[0]), "1")
            result.add("exponent of H_end/L", f"{name} a >= 1", 0.4, *interval(slopes[1]), "1")
    result.write()
    if not {"free", "rolling", "walls"} & points.keys():
        if sys.argv[1:2] == ["-store"]:
            store(sys.argv[2], name="causes", result="causes.csv")
        return

    variant = next(iter(points)) if "free" not in points else None
    picture = f"{variant or 'collapse'}.png"
    draw_scalings(points, found, picture)
    draw(found)
    if sys.argv[1:2] == ["-store"]:
        store(sys.argv[2], picture, *([] if variant else ["column.png"]),
              **({"name": variant, "result": f"{variant}.csv"} if variant else {}))


if __name__ == "__main__":
    main()
