#!/usr/bin/env python3
"""analyse.py -- velocity across the bed of a drum, slope of its surface and torque, beside
measurements and the balance of angular momentum.

    analyse.py [-store "text"]       result.csv, drum.png; with -store also stored/ and the table of results.md

All come from the means over blocks of time (block1.csv ...) and from walls.csv; intervals are 95 %
from these blocks.

Surface   where the solid fraction falls through 0.3, column by column; a straight line through the
          middle half of the drum's width
Velocity  along that slope, on the normal to it through the axis; of the mass in cells of one bead
Torque    of the beads on the drum; in steady motion it equals the lever of their weight, M g x_c
Turning   angular momentum of the beads about the axis, over the same beads fixed to the drum

Measured: measured/alizadeh2013.csv, and 27 degrees for the slope, Alizadeh et al., AIChE J. 59
(2013) 1894.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import numpy
from dem_case import GREY, MEASURED, OURS, POINTS, Result, below, interval, panel, panels, pictures, \
    plain_ticks, read_table, render, save, store

G = 9.81


class Block:
    """Means over a block of time on the cells of a slice; x to the right, z up, the bottom of the
    drum moves to the left."""

    def __init__(self, path):
        rows = read_table(path)
        self.x, self.z = numpy.unique(rows["x"]), numpy.unique(rows["z"])
        order = numpy.lexsort((rows["z"], rows["x"]))
        grid = lambda name: rows[name][order].reshape(len(self.x), len(self.z))
        self.solid, self.density, self.vx, self.vz = map(grid,
            ("solidFraction", "bulkDensity", "velocityX", "velocityZ"))
        self.there = bool(self.density.sum() > 0)

    def surface(self, radius):
        """Slope [rad], down to the right, and height at the axis."""
        points = []
        for x, solid in zip(self.x, self.solid):
            high = numpy.flatnonzero(solid > 0.3)
            if abs(x) < 0.5*radius and len(high) and high[-1] + 1 < len(self.z):
                k = high[-1]
                points.append((x, self.z[k] + (solid[k] - 0.3)/(solid[k] -
                    solid[k + 1])*(self.z[1] - self.z[0])))
        slope, at_axis = numpy.polyfit(*numpy.array(points).T, 1)
        return -numpy.arctan(slope), at_axis

    def velocity(self, angle, depths):
        """Downward velocity along the slope, at these depths below the axis on its normal."""
        x, z = -numpy.sin(angle)*depths, -numpy.cos(angle)*depths
        along = self.density*(self.vx*numpy.cos(angle) - self.vz*numpy.sin(angle))
        mass = self.sample(self.density, x, z)
        return numpy.where(mass > 100, self.sample(along, x, z)/numpy.maximum(mass, 1e-9),
                           numpy.nan)

    def sample(self, field, x, z):
        step = self.x[1] - self.x[0]
        i, k = (x - self.x[0])/step, (z - self.z[0])/step
        a, b = numpy.clip(i.astype(int), 0, len(self.x) - 2), numpy.clip(k.astype(int), 0,
            len(self.z) - 2)
        p, q = i - a, k - b
        return ((1 - p)*(1 - q)*field[a, b] + p*(1 - q)*field[a + 1, b] +
                (1 - p)*q*field[a, b + 1] + p*q*field[a + 1, b + 1])

    def centre(self):
        return (self.density*self.x[:, None]).sum()/self.density.sum()

    def turning(self, omega):
        x, z = self.x[:, None], self.z[None, :]
        return (self.density*(z*self.vx - x*self.vz)).sum()/(self.density*(x*x + z*z)).sum()/omega


def read_blocks(folder):
    found = [Block(path) for path in sorted(Path(folder).glob("block*.csv"))]
    return [block for block in found if block.there]


def torques(folder, spans):
    """Mean torque of the beads on the drum in spans of time."""
    rows = read_table(f"{folder}/walls.csv")
    walls = len(numpy.unique(rows["wall"]))                     # the shell and its ribs
    return numpy.array([walls*rows["ty"][(rows["time"] > low + 1e-9) & (rows["time"] < high +
        1e-9)].mean() for low, high in spans])


def share_of_lever(folder, found, spans, beads):
    """Torque over M g x_c, block by block."""
    mass = beads*numpy.pi/6*0.003**3*2500
    return interval(torques(folder, spans)/(mass*G*numpy.array([block.centre()
        for block in found])))


def large(result):
    radius, omega, spans = 0.12, 1.214749, [(1.1 + 0.5*k, 1.6 + 0.5*k) for k in range(4)]
    found = read_blocks("runs/large")
    angles = numpy.array([block.surface(radius)[0] for block in found])
    y, measured = numpy.loadtxt("measured/alizadeh2013.csv", delimiter=",", skiprows=2).T[::-1]
    order = numpy.argsort(y)
    y, measured = y[order], -measured[order]
    each = numpy.array([block.velocity(angle, -y) for block, angle in zip(found, angles)])
    result.add("slope of the surface", "240 mm at 11.6 turns a minute", 27.0,
               *interval(numpy.degrees(angles)), "degrees")
    off = each - measured
    result.add("velocity: rms difference from the measured",
               f"their spread {measured.std():.3f} m/s", None,
               *interval(numpy.sqrt(numpy.nanmean(off**2, axis=1))), "m/s")
    still = [y[numpy.flatnonzero(u > 0)[0]] for u in each]
    result.add("depth below the axis where nothing moves along the slope", "240 mm",
               1e3*-y[numpy.flatnonzero(measured > 0)[0]],
               *interval(-1e3*numpy.array(still)), "mm")
    result.add("velocity at the wall", "y = -113 mm", measured[0], *interval(each[:, 0]), "m/s")
    result.add("torque over M g x_c", "240 mm", 1.0, *share_of_lever("runs/large", found, spans,
        7536), "1")
    depths = numpy.linspace(0.02, 0.119, 120)
    profiles = numpy.array([block.velocity(angle, depths) for block, angle in zip(found, angles)])
    return (y, measured), depths, profiles, found, angles, omega


def small(result):
    rows = []
    for folder in sorted(Path("runs").glob("small.*"), key=lambda path: path.name):
        if not folder.is_dir():
            continue
        froude = float(folder.name.split(".", 1)[1])
        omega = numpy.sqrt(froude*G/0.05)
        found = read_blocks(folder)
        beads = 1400 if (folder/"block4.csv").exists() and len(found) == 4 else 1000
        spans = [(1 + 0.5*k, 1.5 + 0.5*k) for k in range(4)][:len(found)]
        where = f"100 mm Fr {froude:g}"
        if froude < 0.3:
            angle = interval([numpy.degrees(block.surface(0.05)[0]) for block in found])
            result.add("slope of the surface", where, None, *angle, "degrees")
            rows.append((froude, *angle))
        result.add("turning", where, None, *interval([block.turning(omega) for block in found]),
                   "1")
        if froude < 1:
            result.add("torque over M g x_c", where, 1.0,
                       *share_of_lever(folder, found, spans, beads), "1")
        mass = beads*numpy.pi/6*0.003**3*2500
        result.add("power over M g R w", where, None, *interval(-torques(folder,
            spans)/(mass*G*0.05)), "1")
        if (folder/"energy.csv").exists():
            balance = read_table(folder/"energy.csv")
            result.add("largest residual of the energy balance over the drum's work", where, 0.0,
                       abs(balance["residual"]).max()/balance["work_walls"].max(), None, "1")
    return numpy.array(rows)


def draw():
    """The small drum at the lowest speed, at its end."""
    folder = sorted(Path("runs").glob("small.*[0-9]"))
    if folder:
        turn = numpy.linspace(0, 2*numpy.pi, 200)
        rims = [numpy.stack([0.05*numpy.cos(turn), numpy.full(200, y), 0.05*numpy.sin(turn)], axis=1)
                for y in (0.012, 0)]
        render.draw("bed.png", [panel("", pictures(folder[0])[-1][1])], rims, "speed", 0.1,
                    width=4, pixels=600)


def draw_profile(large_drum, rows):
    figure, (left, middle, right) = panels(3, 12, 3.6, width_ratios=(1.2, 1, 0.8))
    if large_drum:
        (y, measured), depths, profiles, found, angles, omega = large_drum
        left.plot(measured, 1e3*y, label="measured, particle tracking, Alizadeh et al. 2013", **MEASURED)
        left.plot(profiles.mean(axis=0), -1e3*depths, color=OURS, label="Suna")
        left.plot(-omega*depths, -1e3*depths, color=GREY, lw=1, ls="--", label="turning with the drum")
        left.set(xlabel="velocity down along the slope [m/s]", ylabel="distance from the axis, normal\nto the surface [mm]")
        middle.grid(False)
        solid = numpy.mean([block.solid for block in found], axis=0)
        shade = middle.pcolormesh(1e3*found[0].x, 1e3*found[0].z, solid.T, cmap="Greys", vmin=0, vmax=0.7)
        figure.colorbar(shade, ax=middle, label="solid fraction", shrink=0.7)
        middle.plot(*[120*f(numpy.linspace(0, 2*numpy.pi, 200)) for f in (numpy.cos, numpy.sin)],
                    color=GREY, lw=1)
        slope, at_axis = numpy.mean([block.surface(0.12) for block in found], axis=0)
        x = numpy.array([-60, 60])
        middle.plot(x, 1e3*at_axis - numpy.tan(slope)*x, color=OURS)
        middle.set(aspect="equal", xlabel="x [mm]", ylabel="z [mm]",
                   title=f"surface at {numpy.degrees(slope):.1f} degrees")
    if len(rows):
        right.errorbar(rows[:, 0], rows[:, 1], numpy.nan_to_num(rows[:, 2]), marker="s", color=OURS,
                       label="Suna, drum of 100 mm, mean and 95 % interval", **POINTS)
        right.set(xscale="log", xlabel="Froude number", ylabel="slope of the surface [degrees]")
        plain_ticks(right.xaxis, rows[:, 0])
    below(figure, columns=2)
    save(figure, "drum.png")


def main():
    result = Result()
    found = None
    if Path("runs/large").is_dir():
        found = large(result)
    rows = small(result)
    result.write()
    draw_profile(found, rows)
    draw()
    if sys.argv[1:2] == ["-store"]:
        store(sys.argv[2], "drum.png", "bed.png")


if __name__ == "__main__":
    main()
