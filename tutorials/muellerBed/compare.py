#!/usr/bin/env python3
"""compare.py -- the bubbling bed beside the magnetic-resonance measurements of Mueller et al.
2008/2009.

    compare.py [-from 1] [-slab 2] [-gauss] [CASE]    tables and pictures of a run; CASE is this
                                                      folder by default
    compare.py --selfcheck                            averages with known results, as TAP

Reads the record of the beads, the pressure at plate and top, the forces on walls and the log of the
solver. Writes into CASE
    result.csv      a row a quantity: rms difference from the measured points, their spread,
                    95 % interval of rms
    profiles.csv    the profiles with their 95 % intervals
    profiles.png pressure.png bed.png

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import collections
import csv
import re
import sys
from pathlib import Path

import numpy

import averages
import frames
import series

HERE = Path(__file__).resolve().parent
WIDTH, DEPTH = 0.044, 0.010                         # m, of the bed
DIAMETER = 1.2e-3                                   # m, of a bead
EDGES = numpy.linspace(0, WIDTH, 23)                # m, 22 boxes of 2 mm
CENTRES = 0.5*(EDGES[1:] + EDGES[:-1])
FRIT = 186.2                                        # Pa, of Allrun -frit at 0.9 m/s
# s, a few bubbles: blocks know little of each other
BLOCK = 0.25

# quantity, height [mm], unit, and results of other codes at the same points: DPMFoam of OpenFOAM
# v1912 (number mean, the same boxes, 3.9 s, E = 1.2e5 Pa) and sediFoam (its published profiles)
ROWS = [
    ("voidFraction", 16.4, "1", 0.036, 0.089),
    ("voidFraction", 31.2, "1", 0.135, 0.147),
    ("velocity", 15.0, "m/s", 0.042, 0.021),
    ("velocity", 25.0, "m/s", 0.056, 0.024),
    ("velocity", 35.0, "m/s", 0.065, 0.091),
]

# at 0.6 m/s: the simulation of Mueller et al., and sediFoam, both as published
SLOW_ROWS = [
    ("voidFraction", 16.4, "1", 0.073, 0.027),
    ("voidFraction", 31.2, "1", 0.073, 0.057),
]

Experiment = collections.namedtuple("Experiment", "folder others rows")
FAST = Experiment("measured", ("DPMFoam", "sediFoam"), ROWS)
SLOW = Experiment("measured/slow", ("Mueller", "sediFoam"), SLOW_ROWS)


def has_option(case, name):
    """Has Allrun written this entry into system/options?"""
    options = Path(case)/"system"/"options"
    return options.exists() and re.search(rf"\b{name}\b", options.read_text()) is not None


def experiment(case):
    """Reference of the run: Allrun writes the air's velocity when it is not 0.9 m/s."""
    return SLOW if has_option(case, "speed") else FAST


class Profile:
    """One quantity at one height: raw sums of each frame, then its mean and its distance from the
    measured points. Gaussian: a slice whose profile over the height is Gaussian instead of boxes."""

    def __init__(self, quantity, height, unit, half, folder=FAST.folder, gaussian=False):
        self.quantity, self.height, self.unit = quantity, height, unit
        self.half, self.gaussian = half, gaussian
        self.low, self.high = height*1e-3 - half, height*1e-3 + half
        path = HERE/folder/f"{quantity}_{height:g}mm.csv"
        self.measured = numpy.loadtxt(path, delimiter=",", skiprows=2).T
        self.sums = []

    def add(self, position, velocity, diameter):
        if self.gaussian:
            solid, *moving = averages.slice_sums(position, velocity, numpy.pi/6*diameter**3, EDGES,
                                                 self.height*1e-3, self.half)
            self.sums.append((1 - solid/DEPTH,) if self.quantity == "voidFraction" else moving)
        elif self.quantity == "voidFraction":
            solid = averages.solid_volume(position, 0.5*diameter, EDGES, self.low, self.high)
            self.sums.append((1 - solid/(numpy.diff(EDGES)*DEPTH*(self.high - self.low)),))
        else:
            self.sums.append(averages.velocity_sums(position, velocity, EDGES, self.low, self.high))

    def average(self, blocks):
        """Means, their intervals, and the difference from the measurement."""
        sums = [numpy.array(column) for column in zip(*self.sums)]
        mean = averages.velocity_by_number if self.quantity == "velocity" else averages.mean_in_time

        def of(function):
            return lambda chosen: function(*(column[chosen] for column in sums))

        def distance(function):
            return lambda chosen: averages.rms(self.difference(of(function)(chosen)))

        self.profile, self.interval = averages.jackknife(of(mean), blocks)
        self.rms, self.rms_interval = averages.jackknife(distance(mean), blocks)
        self.bias = self.difference(self.profile).mean()
        self.spread = self.measured[1].std()
        self.noise = averages.rms(self.interval)
        if self.quantity == "velocity":
            self.in_time = of(averages.velocity_in_time)(numpy.concatenate(blocks))
            self.rms_in_time = averages.rms(self.difference(self.in_time))

    def difference(self, profile):
        return averages.difference(CENTRES, profile, self.measured)


# ---- a run ---------------------------------------------------------------------------------------

def read_profiles(case, start, half, gaussian):
    """Profiles with the sums of all frames from `start` on, the frames' times, blocks, and the sum of d^3 of
    the beads [m3]."""
    against = experiment(case)
    profiles = [Profile(quantity, height, unit, half, against.folder, gaussian)
                for quantity, height, unit, *_ in against.rows]
    listed = frames.list_frames(case)
    if not listed:
        sys.exit(f"compare: no record of beads in {case}/postProcessing/dem; run ./Allrun first")
    end = listed[-1][0]
    start = min(start, 0.5*end)
    chosen = [frame for frame in listed if frame[0] > start*(1 + 1e-9)]
    if len(chosen) < 4:
        sys.exit(f"compare: {len(chosen)} instants after {start:g} s are too few for an interval; run 0.1 s or more")
    cubes = 0                                       # m3, sum of d^3
    for _, *place in chosen:
        beads = frames.read_frame(*place, by_volume=True)
        cubes = (beads[2]**3).sum()
        for profile in profiles:
            profile.add(*beads)
    times = numpy.array([frame[0] for frame in chosen])
    blocks = averages.cut_blocks(len(times), max(4, int(round((end - start)/BLOCK))))
    for profile in profiles:
        profile.average(blocks)
    return profiles, times, len(blocks), cubes


def mean_of(time, values, start):
    """Mean after `start` with its interval."""
    chosen = values[time > start*(1 + 1e-9)]
    blocks = averages.cut_blocks(len(chosen), max(4, int(round((time[-1] - start)/BLOCK))))
    return averages.jackknife(lambda c: chosen[c].mean(), blocks)


class Balance:
    """Forces that carry the beads, over the cross-section of the bed [Pa]."""

    def __init__(self, case, start, cubes):
        air = frames.entry(case/"constant/transportProperties", "rho")
        beads = frames.entry(case/"constant/demProperties", "density")
        area = WIDTH*DEPTH
        # less buoyancy, as p is without rho g
        self.weight = cubes*numpy.pi/6*(beads - air)*9.81/area

        self.time, plate, *_ = frames.read_columns(case, "platePressure", "surfaceFieldValue.dat")
        _, top, *_ = frames.read_columns(case, "topPressure", "surfaceFieldValue.dat")
        self.drop = air*(plate - top) - (FRIT if has_option(case, "frit") else 0)
        self.mean, self.interval = mean_of(self.time, self.drop, start)
        chosen = self.time > start*(1 + 1e-9)
        self.course = series.course(self.time[chosen], self.drop[chosen])

        rows = frames.read_table(case, "dem", "walls.csv")
        force = {name: numpy.array([(row["time[s]"], row["fz[N]"]) for row in rows
                                    if row["wall"] == name], float).T
                 for name in dict.fromkeys(row["wall"] for row in rows)}
        self.walls = {name: mean_of(time, -z/area, start) for name, (time, z) in force.items()}


def read_log(case):
    """The profile at the end of the solver's log, and its largest errors."""
    path = case/"log.demPimpleFoam"
    text = path.read_text(errors="replace") if path.exists() else ""

    def last(pattern, default=numpy.nan):
        found = re.findall(pattern, text)
        return float(found[-1]) if found else default

    def worst(pattern, choose):
        found = [float(value) for value in re.findall(pattern, text)]
        return choose(found) if found else numpy.nan

    number = r"([-+0-9.eE]+)"
    return {
        "wall": last(rf"ClockTime = {number} s"),
        "processor": last(rf"ExecutionTime = {number} s"),
        "fluid": last(rf"time spent on fluid {number} s"),
        "particles": last(rf"time spent on fluid .* particles {number} s"),
        "transfer": last(rf"time spent on fluid .* exchange {number} s"),
        "exchange": worst(rf"exchange error {number}", max),
        "overlap": worst(rf"overlap at most {number}", max),
        "void": worst(rf"void fraction at least {number}", min),
    }


# ---- output --------------------------------------------------------------------------------------

def write_result(case, profiles, balance, log, seconds):
    with open(case/"result.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["quantity", "height_mm", "rms", "spread", "ci95", "unit"])
        for p in profiles:
            out.writerow([p.quantity, p.height, f"{p.rms:.4f}", f"{p.spread:.4f}",
                          f"{p.rms_interval:.4f}", p.unit])
        # not a profile: rms is the value itself, spread its reference
        out.writerow(["pressureDrop", 0, f"{balance.mean:.2f}", f"{balance.weight:.2f}",
                      f"{balance.interval:.2f}", "Pa"])
        course = balance.course
        out.writerow(["pressureDeviation", 0, f"{course.deviation:.2f}", 0,
                      f"{course.deviation_interval:.2f}", "Pa"])
        if course.periods > 1:                  # one period has no scatter
            out.writerow(["pressureCrossings", 0, f"{course.rate:.3f}", 0,
                          f"{course.rate_interval:.3f}", "Hz"])
            out.writerow(["pressureDominant", 0, f"{course.dominant:.3f}", 0,
                          f"{course.dominant_interval:.3f}", "Hz"])
        out.writerow(["averagedTime", 0, f"{seconds:.2f}", 0, 0, "s"])
        out.writerow(["wallTime", 0, f"{log['wall']:.0f}", 0, 0, "s"])
        out.writerow(["processorTime", 0, f"{log['processor']:.0f}", 0, 0, "s"])
    with open(case/"profiles.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["quantity", "height_mm", "x_mm", "value", "ci95", "time_mean", "unit"])
        for p in profiles:
            for k, x in enumerate(CENTRES):
                plain = p.in_time[k] if p.quantity == "velocity" else p.profile[k]
                out.writerow([p.quantity, p.height, f"{1e3*x:.1f}", f"{p.profile[k]:.5f}",
                              f"{p.interval[k]:.5f}",
                              f"{plain:.5f}", p.unit])


def report(profiles, against, times, blocks, balance, log):
    print(f"\n{len(times)} frames, {times[0]:g} .. {times[-1]:g} s, {blocks} blocks\n")
    first, second = against.others
    print(f"rms difference from the measured points     95 %            of the measured        {first:>8s}  {second:>8s}")
    print("quantity       height            rms      interval    bias    spread    profile's 95 %     rms       rms")
    for p, (*_, one, other) in zip(profiles, against.rows):
        print(f"{p.quantity:13s} {p.height:5.1f} mm {p.rms:14.3f}    +-{p.rms_interval:6.3f}  {p.bias:+7.3f}  {p.spread:7.3f}"
              f"        +-{p.noise:6.3f}  {one:10.3f} {other:9.3f}")
    plain = ", ".join(f"{p.rms_in_time:.3f}" for p in profiles if p.quantity == "velocity")
    if plain:
        print(f"\nvelocity: mean over beads; with the plain mean over time the rms is {plain} m/s")
    carried = balance.mean + sum(mean for mean, _ in balance.walls.values())
    walls = ", ".join(f"{name} {mean:.1f} +- {interval:.1f}"
                      for name, (mean, interval) in balance.walls.items())
    print(f"pressure drop {balance.mean:.1f} +- {balance.interval:.1f} Pa, walls carry {walls} Pa, together {carried:.1f} Pa; "
          f"weight of the beads {balance.weight:.1f} Pa")
    course = balance.course
    print(f"pressure drop: standard deviation {course.deviation:.1f} +- {course.deviation_interval:.1f} Pa, upward crossings of "
          f"its mean {course.rate:.2f} +- {course.rate_interval:.2f} Hz ({course.periods} periods), dominant frequency "
          f"{course.dominant:.2f} +- {course.dominant_interval:.2f} Hz ({course.blocks} blocks)")
    print(f"exchange of momentum: largest relative error {log['exchange']:.1e}; largest overlap {100*log['overlap']:.2f} % of d, "
          f"least void fraction in a cell {log['void']:.3f}")
    print(f"wall time {log['wall']:.0f} s: fluid {log['fluid']:.0f} s, particles {log['particles']:.0f} s, "
          f"exchange {log['transfer']:.0f} s\n")


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    words.add_argument("-from", dest="start", type=float, default=1.0,
                       help="s, where averages begin (at most half of the run)")
    words.add_argument("-slab", type=float, default=2.0, help="mm, half the height of the boxes")
    words.add_argument("-gauss", action="store_true",
                       help="a Gaussian slice, half as high at -slab, instead of boxes")
    words.add_argument("--selfcheck", action="store_true",
                       help="averages with known results, as TAP")
    words.add_argument("case", nargs="?", type=Path, default=HERE)
    words = words.parse_args()
    if words.selfcheck:
        import selfcheck
        sys.exit(selfcheck.run())

    profiles, times, blocks, cubes = read_profiles(words.case, words.start, 1e-3*words.slab,
                                                    words.gauss)
    balance = Balance(words.case, min(words.start, 0.5*times[-1]), cubes)
    log = read_log(words.case)
    write_result(words.case, profiles, balance, log, times[-1] - min(words.start, 0.5*times[-1]))
    report(profiles, experiment(words.case), times, blocks, balance, log)
    try:
        import plots
    except ImportError as reason:
        print(f"compare: no pictures ({reason})")
        return
    plots.draw_all(words.case, profiles, CENTRES, balance)


if __name__ == "__main__":
    main()
