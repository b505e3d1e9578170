#!/usr/bin/env python3
"""evaluate.py -- speed of the beads in the spouted bed of Yue et al. (2020) beside their
measurement.

    evaluate.py [-test] [-from 1] [RUN]         RUN is runs/bed by default

Writes result.csv, speed.png, bed.png.

At six heights above the bottom, in units of the bed at rest, 200 mm:
  speed     magnitude of the mean velocity (x and z) of the beads, by number, in boxes 7 mm wide
            from the middle and 8 mm high. The measured speed has minima where the mean velocity
            changes sign, beside the spout, so it is of the mean, too. In a run of the whole bed the
            left half is mirrored first
  measured  mean of the points at the left and at the right
Bounds and their reasons:
  beads     none is lost
  exchange  1e-12, an identity
Speeds are only reported: the measurement has no interval. -test, the short form: balances only.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"shared"))
import results                      # noqa: E402

frames, averages = results.frames, results.averages
AT_REST = 0.2                                   # m
SHARES = (0.15, 0.30, 0.45, 0.60, 0.75, 0.80)
EDGES = 7e-3*numpy.arange(21)                   # m
CENTRES = 0.5*(EDGES[1:] + EDGES[:-1])
HALF = 4e-3                                     # m, of a box's height
SOURCE = "measured, Yue et al. 2020"


def measured(share):
    """Distance from the middle [m] and speed [m/s] of the points at the left and at the right, from
    the middle outwards."""
    x, speed = numpy.loadtxt(HERE/f"measured/speed_{share:.2f}.csv", delimiter=",", skiprows=2).T
    return [(numpy.sort(abs(x[side])), speed[side][numpy.argsort(abs(x[side]))])
            for side in (x < 0, x > 0)]


def sums(position, velocity, height):
    """Number of beads and sums of their velocities along x and z in each box of this height."""
    inside = abs(position[:, 2] - height) < HALF
    x, (along, up) = position[inside, 0], velocity[inside][:, (0, 2)].T
    return numpy.array([numpy.histogram(abs(x), EDGES, weights=weight)[0]
                        for weight in (numpy.ones(len(x)), numpy.sign(x)*along, up)])


def profile(rows, blocks):
    """Speed in each box, and half of its 95 % interval; rows: sums of each instant."""
    def speed(chosen):
        count, x, z = rows[chosen].sum(axis=0)
        return numpy.hypot(x, z)/numpy.maximum(count, 1)
    return averages.jackknife(speed, blocks)


def tell_speeds(table, run, start):
    listed = [row for row in frames.list_frames(run) if row[0] >= start*(1 - 1e-9)]
    if len(listed) < 10:
        sys.exit(f"evaluate: {len(listed)} instants of the record after {start:g} s (-from); "
                 "means take 10 at least")
    rows = numpy.array([[sums(*frames.read_frame(*place)[:2], share*AT_REST) for share in SHARES]
                        for _, *place in listed])
    blocks = averages.cut_blocks(len(rows), 5)
    profiles = [profile(rows[:, k], blocks) for k in range(len(SHARES))]
    for share, (speed, half) in zip(SHARES, profiles):
        (_, left), (_, right) = measured(share)
        both = 0.5*(left + right)
        for what, boxes in (("speed over the jet, 0 to 7 mm", slice(0, 1)),
                            ("speed at its edge, 7 to 14 mm", slice(1, 2)),
                            ("mean speed beside it, 28 to 84 mm", slice(4, 12))):
            table.add(f"{share:.2f}", what, both[boxes].mean(), speed[boxes].mean(),
                      half[boxes][0] if boxes.stop - boxes.start == 1 else None, "m/s", None,
                      SOURCE)
    return profiles


def tell_balance(table, run):
    counts = [len(frames.read_frame(*place)[0]) for _, *place in frames.list_frames(run)]
    table.add("balance", "beads, fewest in any instant", frames.entry(run/"settle.dem", "count"),
              min(counts), None, "", 0, "put in")
    table.add("balance", "exchange of momentum, largest relative error", 0,
              results.worst(run, "exchange error"), None, "", 1e-12, "an identity")
    table.add("balance", "largest overlap, share of a diameter", 0,
              results.worst(run, "overlap at most"), None)


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    words.add_argument("-test", action="store_true", help="the short form: balances only")
    words.add_argument("-from", dest="start", type=float, default=1, help="s, where means begin")
    words.add_argument("run", nargs="?", type=Path, default=HERE/"runs/bed")
    words = words.parse_args()
    table = results.Table()
    if not words.test:
        profiles = tell_speeds(table, words.run, words.start)
    tell_balance(table, words.run)
    table.write(HERE)
    if words.test:
        return
    with results.pictures():
        import draw
        draw.draw_speeds(HERE, SHARES, CENTRES, profiles, [measured(share) for share in SHARES])
        draw.draw_bed(HERE, words.run)


if __name__ == "__main__":
    main()
