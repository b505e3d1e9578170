#!/usr/bin/env python3
"""evaluate.py -- height and pressure of the bed of van Wachem et al. (2001) beside their
measurements.

    evaluate.py [-test] [-from 1.5] [RUN]       RUN is runs/bed by default; writes result.csv, course.png, bed.png

Bounds and their reasons:
  height     mean over time; 15 %: the measurement is the level of a splashing surface, and its mean
             covers 2 s, five periods, in which it goes from 94 to 149 mm
  frequency  of the pressure 45 mm above the plate, upward crossings of its mean per second; 2.2 Hz
             by the four high peaks of the measured points, bound 0.5 Hz: twice the scatter of the
             periods among them and about what 3 s allow
  balance    1 %; an identity but for the momentum of the leaving air
  exchange   1e-12, an identity
Amplitudes are only reported: no known code reproduces them. -test, the short form: balances only.

References are the measured points, evaluated in the same way, with their intervals.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import sys
from pathlib import Path

import numpy

import bed as beds
import results          # in the path by bed
import series

HERE = Path(__file__).resolve().parent
PEAKS, WITHIN = 2.2, 0.5            # Hz
SOURCE = "measured, van Wachem et al. 2001"


def measured(name):
    """Time [s] and value of the measured points."""
    return numpy.loadtxt(HERE/"measured"/name, delimiter=",", skiprows=2).T


def tell_course(table, part, ours, theirs, unit, factor=1):
    """Rate, dominant frequency and standard deviation of the run over the measured
    ones."""
    rows = [("upward crossings of the mean", ours.rate, ours.rate_interval, theirs.rate,
             theirs.rate_interval, "Hz", 1),
            ("dominant frequency", ours.dominant, ours.dominant_interval, theirs.dominant,
             theirs.dominant_interval, "Hz", 1),
            ("standard deviation", ours.deviation, ours.deviation_interval, theirs.deviation,
             theirs.deviation_interval,
             unit, factor)]
    for what, value, half, reference, uncertain, of, by in rows:
        table.add(part, f"{what} (points: ± {by*uncertain:.2g})", by*reference, by*value, by*half,
                  of, None, SOURCE)


def tell_height(table, bed, start):
    rows = [(time, beds.heights(position, bed)) for time, position, _ in bed.after(start)]
    time = numpy.array([time for time, _ in rows])
    at, height = measured("height.csv")
    even = series.even(at, height)[1]
    mean, half = results.mean_of_blocks(even, 3)
    first = True
    for name in rows[0][1]:
        values = numpy.array([heights[name] for _, heights in rows])
        ours = series.course(time, values)
        value, uncertain = results.mean_of_blocks(values, ours.blocks)
        what = f"mean (points: ± {1e3*half:.2g})" if first else f"mean, {name}"
        table.add("height", what, 1e3*mean, 1e3*value, 1e3*uncertain, "mm", 0.15 if first else None,
                  SOURCE)
        if first:
            tell_course(table, "height", ours, series.course(at, height), "mm", 1e3)
            drawn = values
        first = False
    return time, drawn


def tell_pressure(table, bed, start):
    time, pressure = bed.probes()
    chosen = time >= start
    back = series.course(time[chosen], pressure[0, chosen])
    at, theirs = measured("pressure.csv")
    table.add("pressure", "frequency: crossings; points: four peaks", PEAKS, back.rate,
              back.rate_interval, "Hz", WITHIN/PEAKS, SOURCE)
    tell_course(table, "pressure", back, series.course(at, theirs), "Pa")
    for place, values in zip(("inside", "at the left wall", "at the right wall"), pressure[1:]):
        other = series.course(time[chosen], values[chosen])
        table.add("pressure", f"crossings, {place}", back.rate, other.rate, other.rate_interval,
                  "Hz", None, "at the back")
        table.add("pressure", f"standard deviation, {place}", back.deviation, other.deviation,
                  other.deviation_interval, "Pa",
                  None, "at the back")
    return time, pressure[0]


def tell_balance(table, bed, start, least):
    drop, walls, gain, weight, counts = beds.balance(bed, start)
    carried = drop + sum(walls.values())
    print(f"pressure drop {drop:.1f} Pa, walls " + ", ".join(f"{name} {value:.1f}"
        for name, value in walls.items())
          + f" Pa, gain of momentum {gain:.2f} Pa, weight {weight:.1f} Pa\n")
    table.add("balance", "pressure drop, plate and walls less the gain of momentum", weight,
              carried - gain, None, "Pa", 0.01, "weight")
    table.add("balance", "pressure drop alone", weight, drop, None, "Pa", None, "weight")
    table.add("balance", "beads, fewest in any instant", least, min(counts), None, "", 0, "put in")
    table.add("balance", "exchange of momentum, largest relative error", 0,
              results.worst(bed.run, "exchange error"), None, "", 1e-12,
              "an identity")
    table.add("balance", "largest overlap, share of a diameter", 0,
              results.worst(bed.run, "overlap at most"), None)


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    words.add_argument("-test", action="store_true", help="the short form: balances only")
    words.add_argument("-from", dest="start", type=float, default=1.5, help="s, where means begin")
    words.add_argument("run", nargs="?", type=Path, default=HERE/"runs/bed")
    words = words.parse_args()
    bed = beds.Bed(words.run)
    table = results.Table()
    least = results.frames.entry(words.run/"settle.dem", "count")
    if words.test:
        tell_balance(table, bed, 0, least)
        table.write(HERE)
        return
    if bed.times[-1] < words.start + 1:
        sys.exit(f"evaluate: the run ends at {bed.times[-1]:g} s; means begin at {words.start:g} s (-from) and take 1 s at least")
    height = tell_height(table, bed, words.start)
    pressure = tell_pressure(table, bed, words.start)
    tell_balance(table, bed, words.start, least)
    table.write(HERE)
    with results.pictures():
        import draw
        draw.draw_course(HERE, words.start, height, pressure, measured("height.csv"),
                         measured("pressure.csv"))
        draw.draw_bed(HERE, bed)


if __name__ == "__main__":
    main()
