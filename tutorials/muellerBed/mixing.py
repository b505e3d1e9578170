"""mixing.py -- quantities that compare runs with parcels: Lacey's index of mixing, means with
intervals, processor time. Used by parcels.py here and in tutorials/drum.

Source: Lacey, J. Appl. Chem. 4 (1954) 257.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re

import numpy

import averages

SECONDS = {"s": 1, "min": 60, "h": 3600}


def lacey(position, upper, cell):
    """M = (s0^2 - s^2)/(s0^2 - sr^2) of the particles marked `upper`, in square cells of this width:
    s^2 the variance of their fraction c, weighted by the particles of the cells, s0^2 = c (1 - c)
    unmixed, sr^2 = s0^2/n at random with n particles a cell; 0 unmixed, 1 random. position: two
    columns [m]."""
    _, index, n = numpy.unique(numpy.floor(position/cell), axis=0, return_inverse=True,
                               return_counts=True)
    fraction = numpy.bincount(index.ravel(), weights=upper)/n
    c = upper.mean()
    unmixed = c*(1 - c)
    spread = (n*(fraction - c)**2).sum()/n.sum()
    return (unmixed - spread)/(unmixed - unmixed*len(n)/n.sum())


def blocks(times, values, start, block):
    """Mean from `start` on and half of its 95 % interval, from blocks of this length [s]."""
    later = times >= start - 1e-9
    number = ((times[later] - start + 1e-9)/block).astype(int)
    means = [values[later][number == k].mean() for k in range(int(number.max()) + 1)
             if (number == k).sum() > 1]
    half = averages.student(len(means) - 1)*numpy.std(means, ddof=1)/len(means)**0.5
    return numpy.mean(means), half


def processor_time(log, profile="profile"):
    """Seconds that the last line of this profile names; not a number where the run has not ended."""
    found = re.findall(rf"^{profile}: wall clock .*, processor ([\d.]+) (s|min|h)\b", log, re.MULTILINE)
    return float(found[-1][0])*SECONDS[found[-1][1]] if found else numpy.nan
