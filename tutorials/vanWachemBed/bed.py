"""bed.py -- results of a run of this bed: heights, pressures, and the forces that carry the beads.

Height   of an instant, from the beads alone: the bed is cut into columns of 5 mm over its whole
         depth and these into boxes of 4 mm. The level of a column is where its solid fraction falls
         through 0.1 for the last time on the way up, interpolated between the middles of the boxes;
         the height is the mean over the columns. At 0.1 the beads cover half of the view through
         this depth: 1 - exp(-3/2 0.1 8/1.545) = 0.54
Balance  pressure drop, plate and walls carry weight less buoyancy, the gain of momentum of the
         beads and of the gas, all from means over the time between two instants of the record

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"shared"))
import results                      # noqa: E402

frames = results.frames
DIAMETER, G = 1.545e-3, 9.81
COLUMN, BOX, SHARE = 5e-3, 4e-3, 0.1
VOLUME = math.pi/6*DIAMETER**3


class Bed:
    """A run: its size from the mesh, its materials from the dictionaries."""

    def __init__(self, run):
        self.run = Path(run)
        corners = re.findall(r"\(\s*([\d.]+)\s+([\d.]+)\s+([\d.]+)\s*\)\n",
                             (self.run/"system/blockMeshDict").read_text())
        self.width, self.depth, self.top = numpy.array(corners, float).max(axis=0)*1e-3
        self.air = frames.entry(self.run/"constant/transportProperties", "rho")
        self.beads = frames.entry(self.run/"constant/demProperties", "density")
        self.listed = frames.list_frames(self.run)
        if not self.listed:
            sys.exit(f"evaluate: no record of beads in {run}; run ./Allrun first")
        self.times = numpy.array([time for time, *_ in self.listed])

    @property
    def area(self):
        return self.width*self.depth

    def weight(self, count):
        """Pa, less buoyancy."""
        return count*VOLUME*(self.beads - self.air)*G/self.area

    def after(self, start):
        """Times, positions and velocities of the instants from `start` on."""
        for time, *place in self.listed:
            if time >= start*(1 - 1e-9):
                yield (time, *frames.read_frame(*place)[:2])

    def patch(self, name):
        """Times and the mean pressure of a patch, Pa."""
        time, p, *_ = frames.read_columns(self.run, name, "surfaceFieldValue.dat")
        return time, self.air*p

    def probes(self):
        """Times and the pressures 45 mm above the plate, Pa: back, inside, left, right."""
        time, *p = frames.read_columns(self.run, "pressure", "p")
        return time, self.air*numpy.array(p)


# ---- height --------------------------------------------------------------------------------------

def levels(position, bed, share=SHARE):
    """Level of each column [m], 0 for one without beads."""
    columns, boxes = max(1, round(bed.width/COLUMN)), int(bed.top/BOX)
    count, *_ = numpy.histogram2d(position[:, 0], position[:, 2], (columns, boxes),
                                  ((0, bed.width), (0, boxes*BOX)))
    solid = numpy.pad(count*VOLUME/(bed.area/columns*BOX), ((0, 0), (0, 1)))
    full = solid > share
    last = boxes - numpy.argmax(full[:, ::-1], axis=1)
    rows = numpy.arange(columns)
    below, above = solid[rows, last], solid[rows, numpy.minimum(last + 1, boxes)]
    with numpy.errstate(invalid="ignore", divide="ignore"):
        level = BOX*(last + 0.5 + numpy.where(below > above, (below - share)/(below - above), 0))
    return numpy.where(full.any(axis=1), level, 0)


def heights(position, bed):
    """The height of an instant by its definition and by others, by name."""
    z = position[:, 2]
    return {"share 0.1": levels(position, bed).mean(), "share 0.05": levels(position, bed,
        0.05).mean(),
            "share 0.2": levels(position, bed, 0.2).mean(),
            "95 % of the beads below": numpy.percentile(z, 95),
            "99 % of the beads below": numpy.percentile(z, 99),
            "twice the mean height of the beads": 2*z.mean(),
            "the highest bead": z.max()}


# ---- balance -------------------------------------------------------------------------------------

def balance(bed, start):
    """(drop, walls, gain, weight) [Pa] as means from the first instant of the record after `start`
    to its last; of each wall what beads press on it downwards; gain, momentum of beads and gas per
    time and area; and how many beads, least and most."""
    instants = [(time, len(velocity), velocity[:, 2].sum())
                for time, _, velocity in bed.after(start)]
    (first, _, before), (last, count, behind) = instants[0], instants[-1]
    time, drop = bed.patch("platePressure")
    _, top = bed.patch("topPressure")
    chosen = (time > first*(1 + 1e-9)) & (time <= last*(1 + 1e-9))
    steps = numpy.diff(time, prepend=time[0])[chosen]
    drop = ((drop - top)[chosen]*steps).sum()/steps.sum()

    rows = [row for row in frames.read_table(bed.run, "dem", "walls.csv")
            if first*(1 + 1e-9) < float(row["time[s]"]) <= last*(1 + 1e-9)]
    walls = {name: -numpy.mean([float(row["fz[N]"]) for row in rows
                                if row["wall"] == name])/bed.area
             for name in dict.fromkeys(row["wall"] for row in rows)}

    beads = bed.beads*VOLUME*(behind - before)/bed.area
    # the superficial flow is the same at each height
    gas = bed.air*bed.top*(frames.plate_speed(bed.run, last) - frames.plate_speed(bed.run, first))
    return drop, walls, (beads + gas)/(last - first), bed.weight(count), {n for _, n, _ in instants}
