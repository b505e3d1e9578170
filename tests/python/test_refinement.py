"""test_refinement.py -- evaluation of a refinement series. Prints TAP.

- A smooth series returns the value, the order and the errors it was made from.
- If the scatter is a property of the scene, the 95 % interval contains the true value in 95 of 100
  series.
- If the means do not converge, no value is claimed.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import numpy

from tap import finish, run_tests

from suna_cost.refinement import CLOSED, EXTRAPOLATED, STATISTICS, Level, analyze

TRUTH, MANY = 3.0, 400


def make(number=0, c=0.0, p=1.0, phase=0.0, own=0.0, runs=5, levels=5, closed=None):
    """Values TRUTH + c h^p + phase h x + own y, x and y random in -1 .. 1."""
    random = numpy.random.default_rng([7, number])
    made = []
    for k in range(levels):
        h = 2.0/2**k
        x, y = random.uniform(-1, 1, (2, runs))
        made.append(Level(h, TRUTH + c*h**p + phase*h*x + own*y))
    return analyze(made, closed)


def smooth():
    """a smooth series: value, order, errors, no uncertainty"""
    for p in (1.0, 1.5, 2.0, 2.5):
        found = make(c=0.2, p=p, runs=3)
        assert found.kind == EXTRAPOLATED
        assert abs(found.reference - TRUTH) < 1e-12         # round-off
        assert abs(found.order - p) < 1e-9
        assert abs(found.levels[0].error - 0.2*2**p) < 1e-12
        assert found.uncertainty < 1e-12 and found.order_uncertainty < 1e-9


def scattered():
    """0.2 h and a scatter of 0.05 h: the true value is within the uncertainty in 95 %"""
    found = [make(k, c=0.2, phase=0.05) for k in range(MANY)]
    assert sum(x.kind == EXTRAPOLATED for x in found) >= 390
    assert sum(abs(x.reference - TRUTH) <= x.uncertainty for x in found) >= 380


def chaotic():
    """scatter that stays is a property of the scene; its interval holds the true value"""
    found = [make(1000 + k, own=0.1) for k in range(MANY)]
    assert sum(x.kind == STATISTICS for x in found) >= 380
    # 380 +- 3 times sqrt(400 0.95 0.05)
    assert sum(abs(x.reference - TRUTH) <= x.uncertainty for x in found) >= 367
    assert sum(x.levels[1].error <= x.levels[1].uncertainty for x in found) >= 367


def error_and_scatter():
    """an error of 1 larger than a scatter of 0.1 is reported"""
    first = make(5, c=0.5, own=0.1, runs=8).levels[0]
    assert abs(first.error - 1) < first.uncertainty + 0.1 and first.error > first.uncertainty


def given():
    """a closed form has no uncertainty; errors are differences from it"""
    found = make(c=0.1, p=2.0, runs=2, levels=3, closed=TRUTH)
    assert found.kind == CLOSED and found.uncertainty == 0
    assert abs(found.levels[2].error - 0.1*0.25) < 1e-12


def diverging():
    """alternating means: the finest level, the last difference, no order"""
    found = analyze([Level(4.0/2**k, [k % 2, k % 2]) for k in range(3)])
    assert found.reference == 0 and found.uncertainty >= 1 and numpy.isnan(found.order)


if __name__ == "__main__":
    run_tests(smooth, scattered, chaotic, error_and_scatter, given, diverging)
    finish()
