"""selfcheck.py -- averages with known results; prints TAP. Run by compare.py --selfcheck.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import tempfile
from pathlib import Path

import numpy

import averages
import compare
import frames
import series

RADIUS = 0.5*compare.DIAMETER


def check_cap():
    """A sphere cut by a plane in x, and by one in z: the volume of a cap, pi h^2 (3 r - h)/3."""
    worst = 0
    for height in (0.1, 0.5, 1.0, 1.7):
        h = height*RADIUS
        cap = numpy.pi*h**2*(3*RADIUS - h)/3
        edges = numpy.array([-RADIUS + h, 1.0])
        sphere = numpy.zeros((1, 3))
        rest = averages.solid_volume(sphere, RADIUS, edges, -1, 1)[0]
        worst = max(worst, abs(rest + cap - 4/3*numpy.pi*RADIUS**3))
        above = averages.solid_volume(sphere, RADIUS, numpy.array([-1.0, 1.0]), -RADIUS + h, 1)[0]
        worst = max(worst, abs(above + cap - 4/3*numpy.pi*RADIUS**3))
    # of r^3: Gauss over z meets the kink where discs begin to be cut
    return worst/RADIUS**3, 2e-3


def check_lattice():
    """A lattice of known solid fraction with any shift: each box has that fraction."""
    pitch = numpy.array([2.0, 10/7, 4/3])*1e-3
    solid = numpy.pi/6*compare.DIAMETER**3/pitch.prod()
    worst = 0
    for shift in ((0, 0, 0), (0.31, 0.4, 0.17), (0.5, 0.2, 0.77)):
        n = [numpy.arange(-2, 26), numpy.arange(7), numpy.arange(-2, 40)]
        lattice = (numpy.stack(numpy.meshgrid(*n, indexing="ij"), axis=-1).reshape(-1, 3) +
                   shift)*pitch
        volume = averages.solid_volume(lattice, RADIUS, compare.EDGES, 14.4e-3, 18.4e-3)
        void = 1 - volume/(2e-3*compare.DEPTH*4e-3)
        worst = max(worst, numpy.abs(void - (1 - solid)).max())
    return worst, 1e-3


def check_slice():
    """A dense even cloud of beads with v = 2 + z/mm: solid fraction and mean velocity of a Gaussian
    slice are those at its height."""
    z = numpy.arange(-20e-3, 60e-3, 1e-5)
    position = numpy.stack([numpy.full(len(z), 7e-3), 0*z, z], axis=1)
    velocity = numpy.stack([0*z, 0*z, 2 + 1e3*z], axis=1)
    # 0.4 of a box of 2 mm by 10 mm
    volume = numpy.full(len(z), 0.4*1e-5*2e-3*compare.DEPTH)
    solid, count, total = averages.slice_sums(position, velocity, volume, compare.EDGES, 16.4e-3, 2e-3)
    box = numpy.argmax(count)
    return (abs(solid[box]/compare.DEPTH - 0.4) + abs(total[box]/count[box] - 18.4)
            + abs(count.sum() - count[box])), 1e-6


def check_means():
    """Three slow beads, then a fast one: 2.5 m/s by number, 4 m/s in time."""
    count, total = numpy.array([[3.0], [1.0]]), numpy.array([[3.0], [7.0]])
    by_number, in_time = averages.velocity_by_number(count, total), averages.velocity_in_time(count,
        total)
    return abs(by_number[0] - 2.5) + abs(in_time[0] - 4), 1e-12


def check_distance():
    """A profile through the measured points is at 0, one 0.1 above them at 0.1."""
    worst = 0
    rows = [(row, against.folder) for against in (compare.FAST, compare.SLOW)
            for row in against.rows]
    for (quantity, height, unit, *_), folder in rows:
        x, value = compare.Profile(quantity, height, unit, 2e-3, folder).measured
        worst = max(worst, averages.rms(averages.difference(x, value, (x, value))),
                    abs(averages.rms(averages.difference(x, value + 0.1, (x, value))) - 0.1))
    return worst, 1e-12


def check_interval():
    """The jackknife of a mean is the classical interval, t s/sqrt n; t(7) = 2.3646, t(31) =
    2.0395."""
    values = numpy.random.default_rng(5).normal(size=8)
    _, half = averages.jackknife(lambda chosen: values[chosen].mean(), averages.cut_blocks(8, 8))
    classical = 2.364624*values.std(ddof=1)/8**0.5
    return abs(half/classical - 1) + abs(averages.student(31)/2.039513 - 1), 2e-3


def check_reading():
    """A record is read back as written; after a restart the later file counts; a truncated block
    does not."""
    def block(time, value):
        beads = numpy.zeros(3, frames.BEAD)
        beads["position"][:, 2] = value
        beads["velocity"][:] = [1, 2, value]
        beads["diameter"] = 0.5*value
        return numpy.array([(time, 3)], frames.HEAD).tobytes() + beads.tobytes()

    with tempfile.TemporaryDirectory() as folder:
        for start, text in (("0", block(0.1, 1) + block(0.2, 2)),
                            ("0.1", block(0.2, 3) + block(0.3, 4)[:-1])):
            at = Path(folder)/"postProcessing/dem"/start
            at.mkdir(parents=True)
            (at/"particles.bin").write_bytes(text)
        found = [(time, *(column[2] for column in frames.read_frame(*place)))
                 for time, *place in frames.list_frames(folder)]
    good = len(found) == 2 and all(
        time == t and x.tolist() == [0, 0, value] and v.tolist() == [1, 2, value]
        and d == 0.5*value for (time, x, v, d), t, value in zip(found, (0.1, 0.2), (1, 3)))
    return 0 if good else 1, 0.5


def check_course():
    """A noisy wave of 2.2 Hz, 8 high: its rate within its interval, its spectrum's peak and its
    deviation, 8/sqrt 2."""
    time = numpy.arange(0, 10, 4e-4)
    noise = numpy.random.default_rng(3).normal(size=len(time))
    found = series.course(time, 50 + 8*numpy.sin(2*numpy.pi*2.2*time + 1) + 0.5*noise)
    inside = abs(found.rate - 2.2) < found.rate_interval < 0.1
    return (abs(found.rate/2.2 - 1) + abs(found.dominant/2.2 - 1) +
            abs(found.deviation*2**0.5/8 - 1)
            + (0 if inside and found.periods == 21 else 1)), 0.03


def check_periods():
    """Periods of 0.4 and 0.6 s in turn, evenly many: 2 a second, with the interval of their
    mean."""
    crossing = numpy.cumsum([0.0] + [0.4, 0.6]*8)
    periods = numpy.diff(crossing)
    rate, interval = series.rate_of(crossing)
    half = averages.student(15)*periods.std(ddof=1)/4
    return abs(rate - 2) + abs(interval/(4*half) - 1), 1e-9


def run():
    checks = [check_cap, check_lattice, check_slice, check_means, check_distance, check_interval, check_reading,
              check_course, check_periods]
    bad = 0
    for number, check in enumerate(checks, 1):
        error, limit = check()
        verdict = "ok" if error <= limit else "not ok"
        bad += error > limit
        claim = " ".join(check.__doc__.split())
        print(f"{verdict} {number} - averages: {claim} ({error:.1e})")
    print(f"1..{len(checks)}")
    return int(bad > 0)
