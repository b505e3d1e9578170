"""refinement.py -- convergence study of one quantity: reference, errors, order.

A refinement series consists of levels, from coarse to fine. A level is some runs that differ only by
up to 4 % in the time step, so that contacts begin at other fractions of a step and, where the motion
is chaotic, take other paths. It has the mean m, the standard deviation s, the number of runs n, and
the size h with which the error goes to zero (the time step; the contact time).

The reference q and its uncertainty u:

  closed form   q is given; u = 0
  extrapolated  from the three finest levels of constant ratio r = h2/h1:
                p = ln((m3 - m2)/(m2 - m1))/ln r,  q = m1 - (m2 - m1)/(r^p - 1);
                u is the distance to the value from the next three levels (without a fourth: to m1),
                plus the effect of scatter on q (95 %). If the means do not converge with
                1/2 < p < 4, q = m1 and u is the larger of the last two differences.
  statistics    if scatter does not decrease with the time step as any error of it would, and is not
                small compared with the differences between levels: then it is a property of the
                scene (chaos), q = m1 and u is the 95 % confidence interval of that mean. All runs
                have the same initial state, so the result holds for that state only.

The error of a level is sqrt(mean of (value - q)^2), the error of a single run; with statistics
|m - q|, because the scatter is not an error of h, with the 95 % confidence interval of that
difference (Welch, with the smaller of the two degrees of freedom).

The observed order is the slope of ln(error) over ln(h), with its standard error; levels whose error
is not above 2 u are left out.

Source: Richardson, Phil. Trans. R. Soc. A 210 (1911) 307; the order from three grids: Roache, J.
Fluids Eng. 116 (1994) 405.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
from dataclasses import dataclass, field

import numpy
from scipy.stats import linregress, t as student

CLOSED, EXTRAPOLATED, STATISTICS = "closed form", "extrapolated", "statistics"


def half_width(values):
    """Half the 95 % confidence interval of the mean."""
    n = len(values)
    return student.ppf(0.975, n - 1)*numpy.std(values, ddof=1)/math.sqrt(n) if n > 1 else 0.0


@dataclass
class Level:
    """Values of the runs of a level, and what is derived; in the unit of the quantity."""
    size: float
    values: numpy.ndarray
    error: float = math.nan
    uncertainty: float = math.nan
    mean: float = field(init=False)
    scatter: float = field(init=False)

    def __post_init__(self):
        self.values = numpy.asarray(self.values, float)
        self.mean = self.values[0] + (self.values - self.values[0]).mean()
        self.scatter = self.values.std(ddof=1) if len(self.values) > 1 else 0.0

    @property
    def interval(self):
        return half_width(self.values)


@dataclass
class Analysis:
    """A convergence study: levels from coarse to fine, without failed ones."""
    levels: list
    reference: float = math.nan
    uncertainty: float = 0.0
    kind: str = EXTRAPOLATED
    order: float = math.nan
    order_uncertainty: float = math.nan

    def is_chaotic(self):
        """Scatter by the phases of contacts relative to the step decreases at least linearly with the
        step; here a decrease slower than its square root counts as chaotic."""
        coarse, fine = self.levels[0], self.levels[-1]
        means = [level.mean for level in self.levels]
        return (len(means) > 1
                and fine.scatter > coarse.scatter*math.sqrt(fine.size/coarse.size)
                and 4*fine.scatter > max(means) - min(means))

    def extrapolate(self, at):
        """Value, and factor of the difference of the two finer means in it, from three levels, the
        finest of them `at`; None if they do not converge."""
        third, second, first = self.levels[at - 2:at + 1]
        fine, coarse = second.mean - first.mean, third.mean - second.mean
        ratio = second.size/first.size
        if fine == 0 or coarse/fine <= 0:
            return None
        p = math.log(coarse/fine)/math.log(ratio)
        if not 0.5 < p < 4:
            return None
        weight = 1/(ratio**p - 1)
        return first.mean - fine*weight, weight

    def find_reference(self):
        last, finest = len(self.levels) - 1, self.levels[-1]
        self.kind = STATISTICS if self.is_chaotic() else EXTRAPOLATED
        self.reference, self.uncertainty = finest.mean, finest.interval
        if self.kind == STATISTICS or last == 0:
            return
        before = self.levels[-2]
        noise = math.hypot(finest.interval, before.interval)
        fine = abs(before.mean - finest.mean)
        found = self.extrapolate(last) if last >= 2 and fine > noise else None
        if not found:
            coarse = abs(self.levels[-3].mean - before.mean) if last >= 2 else 0.0
            self.uncertainty = max(fine, coarse) + finest.interval
            return
        self.reference, weight = found
        other = self.extrapolate(last - 1) if last > 2 else None
        self.uncertainty = (abs(self.reference - (other[0] if other else finest.mean))
                            + weight*noise + finest.interval)

    def find_errors(self):
        for level in self.levels:
            level.uncertainty = self.uncertainty
            if self.kind == STATISTICS:
                level.error = abs(level.mean - self.reference)
                if level is not self.levels[-1]:
                    level.uncertainty = math.hypot(level.interval, self.uncertainty)
            else:
                level.error = math.sqrt(((level.values - self.reference)**2).mean())

    def find_order(self):
        used = [level for level in self.levels if level.error > 2*level.uncertainty]
        if len(used) < 3:
            return
        fit = linregress(numpy.log([level.size for level in used]),
                         numpy.log([level.error for level in used]))
        self.order, self.order_uncertainty = fit.slope, fit.stderr


def analyze(levels, closed=None):
    """The study of these levels; `closed`: the exact value, if it is known."""
    found = Analysis(levels)
    if closed is None:
        found.find_reference()
    else:
        found.reference, found.kind = closed, CLOSED
    found.find_errors()
    found.find_order()
    return found
