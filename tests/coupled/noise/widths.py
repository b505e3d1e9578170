#!/usr/bin/env python3
"""widths.py -- errors of the kernel's width at the ends of a bed, of one sphere and in noise.

    ./widths.py              all of it; 3 minutes of processor time
    ./widths.py -store       writes widths.csv; docs/kernels.md has the table and the plot

bed     An even lattice of solid fraction 0.5 fills a duct 15 or 8 diameters high over a plate of
        inflow; gas flows through it. Missing part of Ergun's pressure drop.
alone   One sphere falls obliquely through liquid at Re 0.1 and 1, without and with ownWake:
        its speed over the law's, less 1 (Schiller and Naumann).
towed   The scene `sphere` of study.py: noise of the drag in time.
packed  Gas flows through a fixed random bed that fills a duct: rms of the difference between
        neighboring cells over the mean, of solid fraction, pressure gradient, velocity.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parent)]
import oblique
import study
from case import *
from study import BED, D, Scene, commit, ergun, gas_enters, machine, patch_mean, sphere

KERNELS = {"linear": "kernel linear;", "3": "", "2": "width 2;", "1.5": "width 1.5;",
           "3, law 1": "lawWidth 1;", "2, law 1": "width 2; lawWidth 1;", "1.5, law 1": "width 1.5; lawWidth 1;"}
SPACING = 1.0154                        # of the bed's layers [d]: solid fraction 0.5
AIR = 1.5e-5                            # m2/s


def even(name, cell, entries, layers=15, run=True):
    """The even bed, in cells of `cell` times the spacing."""
    case = Scene(f"even-{name}")
    side, n, height = 8*SPACING*D, 8//cell, 2*layers
    places = (np.mgrid[0:layers, 0:8, 0:8].reshape(3, -1).T[:, ::-1] + 0.5)*SPACING*D
    case.box((side, side, height*SPACING*D), (n, n, height//cell),
             {"inlet": ("patch", "z-"), "outlet": ("patch", "z+"), "sides": ("wall", "x- x+ y- y+")})
    gas_enters(case, "(0 0 0.3)")
    case.dictionary("constant/demProperties",
                    BED % (D, f"type list; positions ({' '.join(map(vector, places))});")
                    + f"coupling {{ rho 1.2; {entries} }}")
    case.controls(8e-3, 1e-3, functions=patch_mean("under", "inlet"), nu=AIR)
    if run:
        case.run("demPimpleFoam")
    return case


def missing(case, layers=15):
    """Part of Ergun's pressure drop that the even bed lacks."""
    closed = ergun(math.pi/6/SPACING**3, 0.3, 1.2, AIR)*layers*SPACING*D
    return 1 - 1.2*case.series("under", "surfaceFieldValue.dat")[-1, 1]/closed


def bed(entries):
    return [(f"bed of {layers} d, cells of {cell} d: drop missing", missing(even("bed", cell, entries, layers), layers))
            for layers in (15, 8) for cell in (2, 1)]


def fall(cell, Re, entries):
    """Speed over the law's, mean of the second half of the way."""
    case = Scene("fall")
    travel, step = (2, 0.1) if Re < 1 else (6, 0.25*cell)
    oblique.prepare(case, entries, cell, Re, travel, step)
    case.run("demPimpleFoam")
    return oblique.mean(case)


def alone(entries):
    return [(f"one sphere, cells of {cell} d, Re {Re}, ownWake {own}: speed too large",
             fall(cell, Re, f"{entries} ownWake {own};") - 1)
            for own in ("no", "yes") for cell in (1, 2) for Re in (0.1, 1)]


def towed(entries):
    study.KERNELS["width"] = entries
    return [("towed sphere, cells of 2 d: noise in time", sphere("width", (2.5e-3,))[0][1])]


def packed(entries):
    rows = []
    for cell in (2, 1):
        case, n = Scene("packed"), 4//cell
        case.duct((12*D, 12*D, 32*D), (3*n, 3*n, 8*n), 0.3, start=0.3)
        case.solve(1e-3, 4e-3, AIR, BED % (
            D, "type random; solidFraction 0.55; min (0 0 0); max (0.012 0.012 0.032);")
            + f"coupling {{ rho 1.2; {entries} }}")
        inside = [f.reshape(8*n, 3*n, 3*n)[n:-n] for f in (
            1 - case.field("0.004/voidFraction"), case.field("0.004/gradP")[:, 2], case.field("0.004/U")[:, 2])]
        for what, field in zip(("solid fraction", "pressure gradient", "velocity"), inside):
            steps = np.concatenate([np.diff(field, axis=k).ravel() for k in range(3)])
            rows.append((f"packed bed, cells of {cell} d: {what}, neighboring cells",
                         math.sqrt(np.mean(steps**2))/abs(field.mean())))
    return rows


def main():
    table = {name: dict(row for scene in (bed, alone, towed, packed) for row in scene(entries))
             for name, entries in KERNELS.items()}
    quantities = list(table["3"])
    if "-store" in sys.argv:
        with open(Path(__file__).resolve().parent/"widths.csv", "w", newline="") as file:
            file.write(f"# ./widths.py -store, {time.strftime('%-d %B %Y')}, one core of {machine()}, "
                       f"OpenFOAM {os.environ.get('WM_PROJECT_VERSION', '')}, commit {commit()}\n")
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["quantity", *KERNELS])
            writer.writerows([quantity, *(f"{table[name][quantity]:.4f}" for name in KERNELS)]
                             for quantity in quantities)
    for quantity in quantities:
        print(f"{quantity}: " + ", ".join(f"{name} {100*table[name][quantity]:.1f} %" for name in KERNELS))


if __name__ == "__main__":
    main()
