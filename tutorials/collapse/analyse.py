#!/usr/bin/env python3
"""analyse.py -- run-out and height of collapsed columns over their aspect ratio, beside measured
scalings.

    analyse.py [-store "text"]       result.csv, collapse.png (rolling.png with -rolling);
                                     with -store also stored/ and its table in results.md

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
from dem_case import OTHER, OURS, REFERENCE, Result, interval, panel, pictures, plt, \
    read_vtp, render, save, store

D, WIDTH, LENGTH = 2e-3, 0.01, 0.032


def beads(folder, place):
    """Positions of the moving beads; fixed ones are below z = 0."""
    at = read_vtp(pictures(folder)[place][1])["points"]
    return at[at[:, 2] > 0]


def run(kind, a, seed):
    """Aspect ratio, run-out and height of one run, and the deposit's profile."""
    column = beads(f"runs/settle.{kind}.{a}.{seed}", -1)
    height = 2*column[:, 2].mean()
    packing = len(column)*numpy.pi/6*D**3/(LENGTH*WIDTH*height)
    rest = beads(f"runs/{kind}.{a}.{seed}", -1)
    edges = numpy.arange(0, rest[:, 0].max() + 2*D, D)
    profile = numpy.histogram(rest[:, 0], edges)[0]*numpy.pi/6*D**3/(D*WIDTH*packing)
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
    panels = [panel(f"{time - start[0]:.2f} s", path)
              for time, path in (start, *shown[:2], shown[-1])]
    length = max(p.position[:, 0].max() for p in panels)
    top = panels[0].position[:, 2].max()
    render.draw("column.png", panels, render.box((0, 0, 0), (length, WIDTH, top)), "speed",
                numpy.sqrt(9.81*top), width=7, rows=len(panels), pixels=900)


def lajeunesse(a):
    return numpy.where(a < 3, 1.8*a, 2.3*a**(2/3))


def lube(a):
    return numpy.where(a < 1.8, 1.2*a, 1.9*a**(2/3))


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
        name = "spheres" if kind == "free" else "with resistance to rolling"
        other = lajeunesse if kind == "free" else lube
        result.add("run-out (L_end - L)/L", f"{name} a = {aspect:.2f}", float(other(aspect)), *out,
                   "1")
        result.add("height H_end/L", f"{name} a = {aspect:.2f}",
                   min(aspect, 0.65*aspect**0.4) if aspect > 1.15 else aspect, *height, "1")
    for kind in points:
        name = "spheres" if kind == "free" else "with resistance to rolling"
        picked = [found[key] for key in sorted(found) if key[0] == kind and key[1] >= 1]
        if len(picked) > 2:
            slopes = [[numpy.polyfit(numpy.log([runs[k][0] for runs in picked]),
                                     numpy.log([runs[k][place] for runs in picked]), 1)[0]
                       for k in range(min(len(runs) for runs in picked))] for place in (1, 2)]
            result.add("exponent of the run-out", f"{name} a >= 1", 0.9, *interval(slopes[0]), "1")
            result.add("exponent of H_end/L", f"{name} a >= 1", 0.4, *interval(slopes[1]), "1")
    result.write()

    figure, (left, right, deposit) = plt.subplots(1, 3, figsize=(12, 3.4))
    a = numpy.geomspace(0.3, 10, 200)
    left.loglog(a, lajeunesse(a), color=REFERENCE, label="glass beads, Lajeunesse et al. 2005")
    left.loglog(a, lube(a), color=REFERENCE, ls="--", label="sand, rice, sugar, Lube et al. 2005")
    right.loglog(a, numpy.where(a < 1.15, a, 0.65*a**0.4), color=REFERENCE, ls="--",
                 label="Lube et al. 2005")
    for kind, colour, label in (("free", OURS, "Suna, spheres"),
                                ("rolling", OTHER, "Suna, with resistance to rolling")):
        if kind in points:
            # a seed alone has no interval
            p = numpy.nan_to_num(numpy.array(points[kind]))
            left.errorbar(p[:, 0], p[:, 1], p[:, 2], fmt="o", ms=4, capsize=3, color=colour,
                          label=label)
            right.errorbar(p[:, 0], p[:, 3], p[:, 4], fmt="o", ms=4, capsize=3, color=colour,
                           label=label)
    left.set(xlabel="a", ylabel="run-out (L_end - L)/L")
    right.set(xlabel="a", ylabel="height H_end/L")
    shown = min(points, default="free")
    for (kind, a), runs in sorted(found.items()):
        if kind == shown:
            x, h = runs[0][3]
            deposit.plot(x/LENGTH, h/LENGTH, label=f"a = {runs[0][0]:.2f}")
    deposit.set(xlabel="x/L", ylabel="h/L")
    for axes in (left, right, deposit):
        axes.legend()
    figure.tight_layout()
    picture = "rolling.png" if list(points) == ["rolling"] else "collapse.png"
    save(figure, picture)
    draw(found)
    if sys.argv[1:2] == ["-store"]:
        store(sys.argv[2], picture, "column.png", **({"name": "rolling", "result": "rolling.csv"}
                                       if picture == "rolling.png" else {}))


if __name__ == "__main__":
    main()
