#!/usr/bin/env python3
"""evaluate.py -- Nusselt numbers of hot spheres in a bed of larger beads beside the measured law.

    evaluate.py [-test]         reads runs/*; writes result.csv, nusselt.png, bed.png

The measured law, Collier, Hayhurst, Richardson and Scott (2004), in air:

    Nu = 2 + 0.90 Re^0.62 (ds/db)^0.2,   Re = rho U ds/mu

  U        superficial velocity, at most the minimum fluidisation velocity
  ds, db   diameters of the hot sphere and of the beads

As in the experiment, h follows from the rate at which a sphere of temperature T cools in air of the
inlet's temperature:

    h = -m c/(pi ds^2) d ln(T - T_in)/dt,   Nu = h ds/k

from 0.2 s on in a bed at rest, from 1 s on in a moving bed. Times at which a sphere is within two
bead diameters of the plate are left out: bubbles have not formed there. Intervals are over the
spheres of a size. Properties of air come from constant/transportProperties, in run and law.

Minimum fluidisation is where a U + b U^2, fitted to the pressure drops of the runs at rest, equals
the bed's weight less buoyancy.

Bounds and their reasons:
  wakao     Nu of this law for packed beds, 30 %: less than the spread of the three laws
  own law   at rest, Nu with temperature and velocity of the air at the sphere equals the law in
            use; 5 %: the velocity is interpolated between cells of 2.5 beads
  exponent  of Nu over U above minimum fluidisation, 0 by the measured law; 0.15
  heat, exchange: identities, see coolingBed
The other two laws and conduction are only reported.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import itertools
import math
import re
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"shared"))
import results                      # noqa: E402

frames = results.frames
LAWS = ("wakao", "gunn", "ranzMarshall")
OTHERS = {"wide": "bed of 150 x 150 x 120 mm", "fine": "cells of 6 mm"}      # by the names of runs
G = 9.81                            # m/s2


def measured(velocity, ds, db, nu):
    return 2 + 0.90*(velocity*ds/nu)**0.62*(ds/db)**0.2


def own_law(name, velocity, void, ds, nu, prandtl):
    """Nu of an effect; `velocity` superficial."""
    re_, root = velocity*ds/nu, prandtl**(1/3)
    if name == "wakao":
        return 2 + 1.1*re_**0.6*root
    if name == "ranzMarshall":
        return 2 + 0.6*(re_/void)**0.5*root
    return ((7 - 10*void + 5*void**2)*(1 + 0.7*re_**0.2*root)
            + (1.33 - 2.4*void + 1.2*void**2)*re_**0.7*root)


def column(path):
    """Numbers of a field of particles or cells, one row each; of a uniform one, one row."""
    text = path.read_text()
    found = re.search(r"^\s*(?:internalField\s+nonuniform List<\w+>\s*)?\d+\s*\n?\((.*?)\n\)",
                      text[text.index("// * *"):], re.MULTILINE | re.DOTALL)
    if not found:
        found = re.search(r"(?:\d+\{|uniform )(.*?)[;}]", text[text.index("// * *"):])
    rows = found.group(1).strip().split("\n")
    return numpy.array([row.replace("(", " ").replace(")", " ").split() for row in rows], float)


def interpolated(field, places, low, high, counts):
    """Values at these places of a field of cells [z, y, x, component], linear between their
    middles."""
    at = (places - low)/(high - low)*counts - 0.5
    base = numpy.floor(at).astype(int)
    part, values = at - base, 0
    for corner in itertools.product((0, 1), repeat=3):
        cell = numpy.clip(base + corner, 0, counts - 1)
        weight = numpy.prod(numpy.where(numpy.array(corner) == 1, part, 1 - part), axis=1)
        values = values + weight[:, None]*field[cell[:, 2], cell[:, 1], cell[:, 0]]
    return values


class Run:
    """A run: what its dictionaries say, and its spheres over time."""

    def __init__(self, run):
        self.run, entry = Path(run), frames.entry
        text = (self.run/"constant/demProperties").read_text()
        self.law = next(name for name in LAWS if re.search(rf"^ +{name} ", text, re.MULTILINE))
        self.conducts = bool(re.search(r"^ +conduction +\{", text, re.MULTILINE))
        self.moves = bool(re.search(r"frozen +no;", text))
        self.other = OTHERS.get(self.run.name.split("-")[0], "")
        self.plain = not self.conducts and not self.other
        self.part = ", ".join(filter(None, (self.law, "conduction" if self.conducts else "", self.other)))
        self.speed = entry(self.run/"0/U", "speed")
        air = self.run/"constant/transportProperties"
        self.rho, self.nu, self.kappa = (entry(air, name) for name in ("rho", "nu", "kappa"))
        self.prandtl = self.rho*self.nu*entry(air, "Cp")/self.kappa
        self.cold = entry(self.run/"0/T", "cold")
        block = re.search(r"bronze\s*\{(.*?)\}", text, re.DOTALL).group(1)
        self.bronze, self.capacity = (float(re.search(rf"{name} +([\d.]+);", block).group(1))
                                      for name in ("density", "heatCapacity"))
        self.glass = float(re.search(r"glass\s*\{\s*density +([\d.]+);", text).group(1))
        mesh = (self.run/"system/blockMeshDict").read_text()
        corners = re.findall(r"\(\s*([\d.]+)\s+([\d.]+)\s+([\d.]+)\s*\)\n", mesh)
        self.high = numpy.array(corners, float).max(axis=0)*1e-3
        self.cells = numpy.array(re.search(r"^cells +\((.*?)\)", mesh, re.MULTILINE)
                                 .group(1).split(), int)
        self.read_spheres()

    def cell_field(self, folder, name):
        values = column(folder/name)
        if len(values) == 1:
            values = numpy.repeat(values, numpy.prod(self.cells), axis=0)
        return values.reshape(*self.cells[::-1], -1)

    def read_spheres(self):
        folders = sorted((float(path.parents[2].name), path.parent) for path in
                         self.run.glob("[0-9]*/lagrangian/particles/temperature"))
        if not folders:
            sys.exit(f"evaluate: no times in {self.run}; run ./Allrun first")
        self.time = numpy.array([time for time, _ in folders])
        self.folders = [folder for _, folder in folders]
        rows = []
        for folder in self.folders:
            ids, material = column(folder/"id")[:, 0], column(folder/"material")[:, 0]
            order = numpy.argsort(ids)
            hot = order[material[order] == 0]           # bronze, the first material
            place = column(folder/"positions")[:, :3]
            fields = folder.parent.parent
            void = self.cell_field(fields, "voidFraction")
            velocity = column(folder/"U")
            if len(velocity) == 1:
                velocity = numpy.repeat(velocity, len(ids), axis=0)
            slip = interpolated(self.cell_field(fields, "U"), place[hot], 0*self.high, self.high,
                                self.cells) - velocity[hot]
            at = interpolated(void, place[hot], 0*self.high, self.high, self.cells)[:, 0]
            rows.append((column(folder/"temperature")[hot, 0], place[hot, 2], at,
                         at*numpy.linalg.norm(slip, axis=1),
                         column(folder/"fluidTemperature")[hot, 0]))
        self.temperature, self.height, self.void, self.slip, self.air = \
            (numpy.array([row[k] for row in rows]) for k in range(5))
        diameter = column(self.folders[0]/"d")
        diameter = numpy.resize(diameter[:, 0], len(ids))
        ids = column(self.folders[0]/"id")[:, 0]
        material = column(self.folders[0]/"material")[:, 0]
        order = numpy.argsort(ids)
        self.ds = diameter[order[material[order] == 0]]
        self.db = diameter[material != 0].mean()
        # full layers of the bed at rest: above the plate's, below the surface
        layers = void.mean(axis=(1, 2, 3)) if not self.moves else numpy.zeros(0)
        self.bed = layers[1:][layers[1:] < layers.min() + 0.05].mean() if len(layers) else None
        volume = math.pi/6*diameter**3
        density = numpy.where(material == 0, self.bronze, self.glass)
        self.weight = numpy.sum(volume*(density - self.rho))*G/(self.high[0]*self.high[1])

    def drop(self):
        """Pressure drop [Pa], mean of the second half."""
        time, p = frames.read_columns(self.run, "plate", "surfaceFieldValue.dat")
        return self.rho*p[time > 0.5*time[-1]].mean()

    def chosen(self, start):
        """Intervals of time that count, of each sphere [interval, sphere]."""
        clear = self.height > 2*self.db
        return (self.time[:-1] > start - 1e-9)[:, None] & clear[1:] & clear[:-1]

    def nusselt(self, start, local=False):
        """Nu of each interval and sphere; `local`: with the air's temperature at the sphere."""
        step = numpy.diff(self.time)[:, None]
        rate = -numpy.diff(numpy.log(self.temperature - self.cold), axis=0)/step
        if local:
            own = (self.temperature - self.air)/(self.temperature - self.cold)
            rate = rate/(0.5*(own[1:] + own[:-1]))
        return rate*self.bronze*self.capacity*self.ds**2/6/self.kappa

    def of_size(self, ds, values, chosen):
        """Mean over time for each sphere of a size that counts for half a second at least (or a
        quarter of the run), then mean and interval over the spheres."""
        step = numpy.diff(self.time)[:, None]*chosen
        means = [numpy.sum(values[:, k]*step[:, k])/numpy.sum(step[:, k])
                 for k in numpy.flatnonzero(abs(self.ds/ds - 1) < 1e-6)
                 if step[:, k].sum() > min(0.5, 0.25*self.time[-1])]
        return results.mean_of(means) if means else (numpy.nan, None)

    def name(self, lifting):
        return f"{self.speed/lifting:.2f} Umf"


def minimum_fluidisation(runs):
    """Velocity [m/s] at which the pressure drop of the bed at rest is its weight."""
    still = {run.speed: run.drop() for run in runs if not run.moves}
    speed, drop = (numpy.array(values) for values in zip(*still.items()))
    weight = runs[0].weight
    if len(speed) == 1:                 # the short form: Ergun's ratio of the terms at e = 0.4
        run = next(run for run in runs if not run.moves)
        linear = 150*0.6*run.nu/(1.75*run.db)
        b = drop[0]/(speed[0]*(speed[0] + linear))
        a = b*linear
    else:
        a, b = numpy.linalg.lstsq(numpy.stack([speed, speed**2], axis=1), drop, rcond=None)[0]
    return (math.sqrt(a*a + 4*b*weight) - a)/(2*b)


def carrying(run, void):
    """Superficial velocity [m/s] at which Ergun's gradient is the weight of a bed of this void
    fraction."""
    linear = 150*(1 - void)*run.nu/run.db
    square = 1.75
    weight = void**3*run.db*(run.glass/run.rho - 1)*G
    return (math.sqrt(linear**2 + 4*square*weight) - linear)/(2*square)


def start_of(run, short):
    return 1.0 if run.moves else 0.1 if short else 0.2


def report_spheres(table, runs, lifting, short):
    """Nu of all runs over the measured law; returns (run, ds, Nu, interval)."""
    found = []
    for run in runs:
        start = start_of(run, short)
        for ds in sorted(set(run.ds)):
            value, half = run.of_size(ds, run.nusselt(start), run.chosen(start))
            law = measured(min(run.speed, lifting), ds, run.db, run.nu)
            held = 0.3 if run.law == "wakao" and run.plain else None
            table.add(run.part, f"Nu of {1e3*ds:g} mm at {run.name(lifting)}", law, value, half, "", held,
                      "measured law, Collier et al. 2004")
            found.append((run, ds, value, half))
    return found


def report_exponents(table, found):
    """d ln Nu/d ln U between the slowest and the fastest run with wakao."""
    plain = [row for row in found if row[0].law == "wakao" and row[0].plain]
    for moves, words in ((False, "below"), (True, "above")):
        for ds in sorted({row[1] for row in plain}):
            rows = sorted((row for row in plain if row[1] == ds and row[0].moves == moves),
                          key=lambda row: row[0].speed)
            if len(rows) < 2:
                continue
            (a, _, low, below), (b, _, high, above) = rows[0], rows[-1]
            width = math.log(b.speed/a.speed)
            value = math.log(high/low)/width
            half = math.hypot((below or 0)/low, (above or 0)/high)/width
            law = 0 if moves else math.log(measured(b.speed, ds, b.db, b.nu)
                                           / measured(a.speed, ds, a.db, a.nu))/width
            table.add("wakao", f"exponent of Nu over U {words} Umf, {1e3*ds:g} mm", law, value, half, "",
                      0.15 if moves else None, "measured law, Collier et al. 2004")


def report_own_law(table, runs, short):
    """At rest: Nu with temperature and velocity of the air at the sphere over the law's own."""
    for law in LAWS:
        ratios, speeds, warmth = [], [], []
        for run in (run for run in runs if run.law == law and not run.moves and run.plain):
            start = start_of(run, short)
            chosen, here = run.chosen(start), run.nusselt(start, local=True)
            own = own_law(law, run.slip[1:], run.void[1:], run.ds, run.nu, run.prandtl)
            ratios += [run.of_size(ds, here/own, chosen)[0] for ds in sorted(set(run.ds))]
            speeds += [run.of_size(ds, run.slip[1:]/run.speed, chosen)[0] for ds in sorted(set(run.ds))]
            warm = (run.air - run.cold)/(run.temperature - run.cold)
            warmth += [run.of_size(ds, warm[1:], chosen)[0] for ds in sorted(set(run.ds))]
        if ratios:
            table.add("own law", f"{law}: Nu over the law's own at the sphere, mean of the beds at rest", 1,
                      numpy.mean(ratios), None, "", 0.05, "the law")
    if speeds:
        table.add("own law", "superficial velocity at the spheres over its value at the plate, at rest", 1,
                  numpy.mean(speeds), None)
        table.add("own law", "warmth of the air there over the sphere's, both over the inlet's, at rest", 0,
                  numpy.mean(warmth), None)


def report_bed(table, runs, lifting):
    still = next(run for run in runs if not run.moves)
    archimedes = G*still.db**3*(still.glass/still.rho - 1)/still.nu**2
    wen = (math.sqrt(33.7**2 + 0.0408*archimedes) - 33.7)*still.nu/still.db
    table.add("bed", "minimum fluidisation velocity Umf, by the pressure drop at rest", wen, lifting, None,
              "m/s", None, "Wen and Yu 1966")
    table.add("bed", "void fraction at rest, layers from 10 mm to the surface", 0.4, still.bed, None)
    for run in runs:
        if run.moves and run.law == "wakao" and run.plain:
            chosen = run.chosen(1.0)
            late = run.time[1:] > 1.0
            table.add("bed", f"mean void fraction at the spheres at {run.name(lifting)}", still.bed,
                      run.void[1:][chosen].mean(), None)
            table.add("bed", f"superficial slip velocity there at {run.name(lifting)}; reference: Umf",
                      lifting, run.slip[1:][chosen].mean(), None, "m/s")
            dense = chosen & (run.void[1:] < 0.5)
            if dense.any():
                table.add("bed", "the same where the void fraction is below 0.5; reference: Ergun",
                          carrying(run, run.void[1:][dense].mean()), run.slip[1:][dense].mean(), None,
                          "m/s", None, "Ergun's, that carries a bed of the mean void fraction there")
                table.add("bed", "void fraction there", still.bed, run.void[1:][dense].mean(), None)
            table.add("bed", f"fraction of time near the plate, left out, at {run.name(lifting)}", 0,
                      1 - chosen[late].mean(), None)
            table.add("bed", f"pressure drop over weight at {run.name(lifting)}", 1,
                      run.drop()/run.weight, None)


def report_balance(table, runs):
    number = r"([-+0-9.eE]+)"
    kept, exchange = [], []
    for run in runs:
        log = (run.run/"log.demPimpleFoam").read_text(errors="replace")
        rows = numpy.array(re.findall(rf"^Suna: heat fluid {number} particles {number} owed {number} "
                                      rf"sum {number} received {number} J$", log, re.MULTILINE), float)
        given = run.bronze*run.capacity*math.pi/6*numpy.sum(run.ds**3*(run.temperature[0]
                                                                        - run.temperature[-1]))
        kept.append(numpy.ptp(rows[:, 3] - rows[:, 4])/given)
        exchange.append(results.worst(run.run, "exchange error"))
    table.add("balance", "heat of air and particles less what came, change over what the spheres lost", 0,
              max(kept), None, "", 1e-6, "an identity")
    table.add("balance", "exchange of momentum and heat, largest relative error", 0, max(exchange),
              None, "", 1e-12, "an identity")
    table.add("balance", "largest overlap, fraction of a diameter", 0,
              max(results.worst(run.run, "overlap at most") for run in runs), None)


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    words.add_argument("-test", action="store_true", help="the short form: beds at rest")
    words = words.parse_args()
    runs = [Run(path.parent.parent) for path in sorted(HERE.glob("runs/*/0/U"))]
    if not runs:
        sys.exit("evaluate: no runs; run ./Allrun first")
    runs.sort(key=lambda run: (LAWS.index(run.law), run.conducts, run.other, run.speed))
    lifting = minimum_fluidisation(runs)
    table = results.Table()
    found = report_spheres(table, runs, lifting, words.test)
    report_exponents(table, found)
    report_own_law(table, runs, words.test)
    report_bed(table, runs, lifting)
    report_balance(table, runs)
    table.write(HERE)
    if words.test:
        return
    with results.pictures():
        import draw
        draw.draw_nusselt(HERE, table.rows)
        draw.draw_bed(HERE, runs)


if __name__ == "__main__":
    main()
