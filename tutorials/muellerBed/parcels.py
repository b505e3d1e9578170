#!/usr/bin/env python3
"""parcels.py -- the bubbling bed with single beads and with parcels: height, pressure drop, mixing,
cost.

    parcels.py [-from 0.6] CASE ...     runs of Allrun -parcels; a table in Markdown

Height    of the center of mass, and below which 95 % of the mass is; means over time, with 95 % of
          blocks of 0.15 s
Pressure  between plate and top, likewise
Mixing    Lacey's index (mixing.py) of the beads in the upper half at the start, in cells of 11 mm:
          where the means begin, in the middle, at the end
Cost      from the log: processor time of the solver, of the particles and of the exchange

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import re
from pathlib import Path

import numpy

import frames
from mixing import blocks, lacey, processor_time

BLOCK, CELL = 0.15, 0.011


def read_ids(path, at):
    with open(path, "rb") as file:
        file.seek(at)
        count = numpy.fromfile(file, frames.HEAD, 1)[0]["count"]
        return numpy.fromfile(file, frames.BEAD, count)["id"].argsort()


def row(case, start):
    times, centre, top, upper, mixed = [], [], [], None, []
    for time, path, at in frames.list_frames(case):
        position, _, _ = frames.read_frame(path, at)
        position = position[read_ids(path, at)]
        z = position[:, 2]
        upper = (z > numpy.median(z)).astype(float) if upper is None else upper
        times.append(time)
        centre.append(z.mean())
        top.append(numpy.quantile(z, 0.95))
        mixed += [lacey(position[:, [0, 2]], upper, CELL)]
    times = numpy.array(times)
    at = [abs(times - time).argmin() for time in (start, 0.5*(start + times[-1]), times[-1])]
    plate, above = (frames.read_columns(case, name, "surfaceFieldValue.dat")
                    for name in ("platePressure", "topPressure"))
    density = frames.entry(Path(case)/"constant/transportProperties", "rho")
    log = (Path(case)/"log.demPimpleFoam").read_text()
    of = {name: float(seconds) for name, seconds in
          re.findall(r"^    (\w+) +[\d.]+ % +[\d.e+-]+ s +([\d.e+-]+) s$", log.split(
              "profile of fluid and coupling")[-1], re.MULTILINE)}
    return (len(upper), *blocks(times, numpy.array(centre), start, BLOCK),
            *blocks(times, numpy.array(top), start, BLOCK),
            *blocks(plate[0], density*(plate[1] - above[1]), start, BLOCK), times[at], numpy.array(mixed)[at],
            processor_time(log, "profile of fluid and coupling"), of["particles"])


def main():
    options = argparse.ArgumentParser()
    options.add_argument("-from", dest="start", type=float, default=0.6)
    options.add_argument("case", nargs="+")
    given = options.parse_args()
    print("| case | parcels | centre [mm] | 95 % below [mm] | pressure drop [Pa] | mixing at [s] "
          "| processor [s] | of particles [s] |")
    print("|---|---|---|---|---|---|---|---|")
    for case in given.case:
        n, c, dc, t, dt, p, dp, times, mixed, seconds, particles = row(case, given.start)
        mixing = ", ".join(f"{m:.2f} at {time:.2f}" for m, time in zip(mixed, times))
        print(f"| {Path(case).name} | {n} | {1e3*c:.1f} ± {1e3*dc:.1f} | {1e3*t:.1f} ± {1e3*dt:.1f} "
              f"| {p:.1f} ± {dp:.1f} | {mixing} | {seconds:.0f} | {particles:.1f} |")


if __name__ == "__main__":
    main()
