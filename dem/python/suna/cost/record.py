"""record.py -- totals over all particles from the record of a coupled run, one line for each time.

  time[s],particles,height[m],level[m],kinetic[m2/s2],diameter[m]

  height     of the centre of volume, against gravity                       [m]
  level      95 % of the volume lies below it                               [m]
  kinetic    kinetic energy of translation over mass, for equal densities   [m2/s2]
  diameter   of a sphere of the mean volume                                 [m]

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

from ..files import read_record
from .scene import Refused


def totals(beads, up):
    d = beads["diameter"].astype(float)
    volume = d**3
    height = beads["position"].astype(float) @ up
    if not len(d):
        return 0.0, 0.0, 0.0, 0.0
    order = numpy.argsort(height)
    below = numpy.cumsum(volume[order])
    level = height[order][min(numpy.searchsorted(below, 0.95*volume.sum()), len(d) - 1)]
    kinetic = 0.5*(volume*(beads["velocity"].astype(float)**2).sum(axis=1)).sum()/volume.sum()
    return ((volume*height).sum()/volume.sum(), level, kinetic,
            numpy.cbrt(volume.mean()))


def report_record(arguments):
    if len(arguments) != 4:
        raise Refused("dem cost -record takes a file and gravity; see dem cost -help")
    g = numpy.array(arguments[1:], float)
    up = -g/numpy.linalg.norm(g) if g.any() else g
    print("time[s],particles,height[m],level[m],kinetic[m2/s2],diameter[m]")
    for time, beads in read_record(arguments[0]):
        print(f"{time:.9g},{len(beads)}," + ",".join(f"{x:.9g}" for x in totals(beads, up)))
