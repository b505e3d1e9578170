#!/usr/bin/env python3
"""evaluate.py -- the mean temperature of the bed over time beside closed forms, and the heat
balance.

    evaluate.py [-test] [-from 0.5] [RUN]       RUN is runs/bed by default; writes result.csv, temperature.csv,
                                                cooling.png, bed.png

Closed forms, with M c of all beads and C = rho Cp u A of the air, u(t) at the plate:
  perfect   air leaves at the mean temperature of the beads:     M c dT/dt = -C (T - T_in)
  fastest   air leaves as hot as the hottest bead, T_0:          M c dT/dt = -C (T_0 - T_in)
  slowest   air beyond minimum fluidisation passes unheated in bubbles, the rest leaves at T:
                                                                 M c dT/dt = -C u_mf/u (T - T_in)
u_mf is for the run's own drag law and void fraction, from the log.

Bounds and their reasons:
  rate      heat that beads lose over C (T - T_in), means of 0.1 s, from 0.5 s on; 10 %: air that
            passes in bubbles leaves colder, a hot top of the bed lets it leave hotter
  fastest   no run may cool the beads faster: the second law
  heat      sum of fluid and beads less what came through patches, over what the beads lost; 1e-6:
            the tolerance for T and the 12 digits of the log
  exchange  1e-12, an identity
The spread of the temperatures and the conduction through the plate are only reported. -test, the
short form: the rate at rest (5 %), before the bed bubbles, and balances.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import csv
import math
import re
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"shared"))
import results                      # noqa: E402

frames = results.frames
WINDOW = 0.1                        # s, of the rate
ZERO = 273.15                       # K


class Run:
    """A run: what its dictionaries say, and its log."""

    def __init__(self, run):
        self.run = Path(run)
        entry = frames.entry
        text = (self.run/"settle.dem").read_text()
        self.count = int(re.search(r"count (\d+);", text).group(1))
        self.hot = float(re.search(r"temperature ([\d.]+);", text).group(1))
        self.diameter = entry(self.run/"settle.dem", "diameter")
        beads = self.run/"constant/demProperties"
        self.capacity = (self.count*math.pi/6*self.diameter**3*entry(beads, "density")
                         * entry(beads, "heatCapacity"))            # J/K
        air = self.run/"constant/transportProperties"
        self.cold = entry(self.run/"0/T", "cold")
        corners = re.findall(r"\(\s*([\d.]+)\s+([\d.]+)\s+([\d.]+)\s*\)\n",
                             (self.run/"system/blockMeshDict").read_text())
        self.width, self.depth, self.top = numpy.array(corners, float).max(axis=0)*1e-3
        # W/K at 1 m/s
        self.air = entry(air, "rho")*entry(air, "Cp")*self.width*self.depth
        self.read_log()

    def read_log(self):
        path = self.run/"log.demPimpleFoam"
        if not path.exists():
            sys.exit(f"evaluate: no {path}; run ./Allrun first")
        log = path.read_text(errors="replace")
        number = r"([-+0-9.eE]+)"
        rows = re.findall(rf"^Time = {number}$.*?^Suna: heat fluid {number} particles {number} "
                          rf"owed {number} sum {number} received {number} J$", log,
                          re.MULTILINE | re.DOTALL)
        if not rows:
            sys.exit(f"evaluate: no heat in {path}; the effects of constant/demProperties need gunn, "
                     "ranzMarshall or wakao")
        self.time, self.fluid, self.beads, _, self.sum, self.received = numpy.array(rows, float).T
        self.mean = self.beads/self.capacity
        found = re.search(rf"and at {number} m/s with \w+ for a bed of void fraction", log)
        self.lifting = float(found.group(1)) if found else numpy.nan
        self.lost = self.capacity*self.hot - self.beads             # J

    def blown(self, time, limit=math.inf):
        """Integral of C dt [J/K] from 0 to these times, of the speed up to `limit`."""
        fine = numpy.linspace(0, self.time[-1], 20001)
        u = numpy.minimum(frames.plate_speed(self.run, fine), limit)
        whole = numpy.concatenate([[0], numpy.cumsum(0.5*(u[1:] + u[:-1])*numpy.diff(fine))])
        return self.air*numpy.interp(time, fine, whole)

    def closed(self, time):
        """Mean temperatures [K] by the closed forms."""
        rise, share = self.hot - self.cold, self.blown(time)/self.capacity
        return {"perfect": self.cold + rise*numpy.exp(-share),
                "fastest": self.hot - rise*share,
                "slowest": self.cold + rise*numpy.exp(-self.blown(time, self.lifting)/self.capacity)}

    def rate(self, window):
        """Middles of windows [s], and in each the heat that beads lose over C (T - T_in). What the plate
        conducts, which the closed forms do not have, is not counted as lost."""
        edges = numpy.arange(0, self.time[-1]*(1 + 1e-9), window)
        time = numpy.concatenate([[0], self.time])
        mean = numpy.concatenate([[self.hot], self.mean])
        lost = numpy.concatenate([[0], self.lost - self.conducted()])
        # by perfect exchange at the run's own mean temperature
        middles = 0.5*(time[1:] + time[:-1])
        taken = numpy.concatenate([[0], numpy.cumsum(
            (0.5*(mean[1:] + mean[:-1]) - self.cold)*self.air*frames.plate_speed(self.run, middles)*numpy.diff(time))])
        ours, theirs = (numpy.diff(numpy.interp(edges, time, values)) for values in (lost, taken))
        return 0.5*(edges[1:] + edges[:-1]), ours/theirs

    def exit(self):
        """Times and temperature of the leaving air [K], weighted by its flux."""
        return frames.read_columns(self.run, "exit", "surfaceFieldValue.dat")

    def conducted(self):
        """Heat that the plate's cold boundary value took by conduction [J], over time: what left through
        patches less what the leaving air took with it."""
        at, warm = self.exit()
        taken = self.air*frames.plate_speed(self.run, at)*(warm - self.cold)*numpy.diff(at, prepend=0)
        return -self.received - numpy.interp(self.time, at, numpy.cumsum(taken))

    def folders(self):
        """Times at which the beads were written, with their folders."""
        found = [(float(path.parts[-4]), path.parent) for path in
                 self.run.glob("[0-9]*/lagrangian/particles/temperature")]
        return sorted(found)


def column(path):
    """Numbers of a field of particles, one row per particle."""
    text = path.read_text()
    begin = text.index("\n(\n", text.index("FoamFile")) + 3
    body = text[begin:text.rindex("\n)")].replace("(", " ").replace(")", " ")
    rows = body.count("\n") + 1
    return numpy.array(body.split(), float).reshape(rows, -1)


def beads_of(folder):
    """Positions [m] and temperatures [K] of the beads of a time folder."""
    return column(folder/"positions")[:, :3], column(folder/"temperature")[:, 0]


def tell_cooling(table, run, start):
    end = run.time[-1]
    closed = {name: values[0] for name, values in run.closed(numpy.array([end])).items()}
    name = "air leaves at the mean of the beads"
    middle, rate = run.rate(WINDOW)
    chosen = rate[middle > start]
    mean, half = results.mean_of_blocks(chosen, max(3, min(8, len(chosen)//5)))
    table.add("cooling", f"rate of heat loss relative to perfect exchange, from {start:g} s", 1, mean,
              half, "", 0.1, name)
    table.add("cooling", f"mean temperature of the beads at {end:g} s", closed["perfect"] - ZERO,
              run.mean[-1] - ZERO, None, "C", None, name)
    table.add("cooling", "the same, fastest: air leaves as hot as the hottest bead",
              closed["fastest"] - ZERO, run.mean[-1] - ZERO, None, "C", None, "closed form")
    table.add("cooling", f"the same, slowest: {run.lifting:g} m/s of the air is heated",
              closed["slowest"] - ZERO, run.mean[-1] - ZERO, None, "C", None, "closed form")
    share = run.blown(end)/run.capacity
    table.add("cooling", "heat given off", 1 - math.exp(-share),
              run.lost[-1]/(run.capacity*(run.hot - run.cold)), None, "", None, name)
    at, warm = run.exit()
    late = (at > start) & (at <= end)
    if late.any():
        bed = numpy.interp(at[late], run.time, run.mean)
        values = (warm[late] - run.cold)/(bed - run.cold)
        value, half = results.mean_of_blocks(values, max(3, min(8, len(chosen)//5)))
        table.add("cooling", f"rise of the leaving air over the mean bead's, from {start:g} s", 1,
                  value, half, "", None, name)
    folders = [row for row in run.folders() if row[0] <= end*(1 + 1e-9)]
    if folders:
        time, folder = folders[-1]
        _, temperature = beads_of(folder)
        table.add("cooling", f"standard deviation among the beads at {time:g} s", 0, temperature.std(),
                  None, "K")
        table.add("cooling", "the same over the mean's height over the cold air", 0,
                  temperature.std()/(temperature.mean() - run.cold), None)


def tell_rest(table, run):
    """The short form: the bed has not begun to bubble, and all air passes through it."""
    end = run.time[-1]
    middle, rate = run.rate(0.25*end)
    table.add("cooling", "rate of heat loss relative to perfect exchange, last quarter", 1, rate[-1],
              None, "", 0.05, "air leaves at the mean of the beads")


def tell_balance(table, run):
    """Heat as the log has it; of the fluid since the first step, as its start is not told there."""
    kept = run.sum - run.received
    table.add("balance", "heat of fluid and beads less what came, change over what the beads lost", 0,
              numpy.ptp(kept)/run.lost[-1], None, "", 1e-6, "an identity")
    # air that enters later and air that is there at the start becomes as hot as the beads at most
    most = (run.blown(run.time) + run.fluid[0]/run.cold)*(run.hot - run.cold)
    plate = run.conducted()
    table.add("balance", "beads' heat beyond air of their first temperature, over what they lost", 0,
              max(0, (run.lost - most - plate).max())/run.lost[-1], None, "", 1e-6, "second law")
    table.add("balance", "heat conducted back through the plate over what the beads lost", 0,
              plate[-1]/run.lost[-1], None)
    table.add("balance", "exchange of momentum and heat, largest relative error", 0,
              results.worst(run.run, "exchange error"), None, "", 1e-12, "an identity")
    counts = {int(n) for n in re.findall(r"^Suna: (\d+) particles, \d+ DEM steps",
              (run.run/"log.demPimpleFoam").read_text(errors="replace"), re.MULTILINE)}
    table.add("balance", "beads, fewest in any step", run.count, min(counts), None, "", 0, "put in")
    table.add("balance", "largest overlap, share of a diameter", 0,
              results.worst(run.run, "overlap at most"), None)


def write_course(run):
    """temperature.csv: instants 0.1 s apart."""
    steps = numpy.arange(0, run.time[-1]*(1 + 1e-9), WINDOW)
    own = numpy.interp(steps, numpy.concatenate([[0], run.time]),
                       numpy.concatenate([[run.hot], run.mean]))
    closed = run.closed(steps)
    with open(HERE/"temperature.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["time[s]", "beads[C]", *(f"{name}[C]" for name in closed)])
        for k, time in enumerate(steps):
            out.writerow([f"{time:.1f}", f"{own[k] - ZERO:.3f}",
                          *(f"{values[k] - ZERO:.3f}" for values in closed.values())])


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    words.add_argument("-test", action="store_true", help="the short form: balances and the bed at rest")
    words.add_argument("-from", dest="start", type=float, default=0.5, help="s, where means begin")
    words.add_argument("run", nargs="?", type=Path, default=HERE/"runs/bed")
    words = words.parse_args()
    run = Run(words.run)
    table = results.Table()
    if words.test:
        tell_rest(table, run)
    else:
        if run.time[-1] < words.start + 5*WINDOW:
            sys.exit(f"evaluate: the run ends at {run.time[-1]:g} s; means begin at {words.start:g} s "
                     f"(-from) and take {5*WINDOW:g} s at least")
        tell_cooling(table, run, words.start)
        write_course(run)
    tell_balance(table, run)
    table.write(HERE)
    if words.test:
        return
    with results.pictures():
        import draw
        draw.draw_cooling(HERE, run, WINDOW)
        draw.draw_bed(HERE, run)


if __name__ == "__main__":
    main()
