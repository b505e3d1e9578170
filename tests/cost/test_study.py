"""test_study.py -- evaluation of a refinement series, and of a study of two. Prints TAP.

- A smooth series returns the value, the order and the errors it was made from.
- If the scatter is a property of the scene, the 95 % interval contains the true value in 95 of 100
  series.
- If the means do not converge, no value is claimed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

from suna_cost.best_buy import best_buy
from suna_cost.refinement import CLOSED, EXTRAPOLATED, STATISTICS, Level, analyze
from suna_cost.study import Level as StudyLevel, Run, Series, Study
from tap import finish, run_tests

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


def by_hand():
    """a study of two series: order 2, limit 1, the best buy, and the error that no step removes"""
    def series(name, exact, sizes, value, **more):
        levels = [StudyLevel(f"{h:g}", h, 0.1*h if exact else 0.1, [Run(10, 8/h, {"drop": value(h)})])
                  for h in sizes]
        return Series(name, "by hand", exact=exact, levels=levels, base=sizes.index(1), **more)
    interval = series("interval", True, [4, 2, 1, 0.5, 0.25], lambda h: 1 + 0.008*h*h, entry="deltaT")
    mesh = series("mesh", False, [8, 4, 2, 1], lambda h: 1.01 + 0.1*h)
    study = Study("case", "", 1.0, 0.01, {"drop": "Pa"}, series=[interval, mesh])
    study.evaluate()
    found = interval.analysis["drop"]
    assert abs(found.order - 2) < 1e-4 and abs(found.reference - 1) < 1e-6
    assert abs(interval.levels[0].error["drop"] - 0.128) < 1e-6
    assert best_buy(study).startswith(
        "the case as it is, step 0.1 s: drop, the worst, is within 0.8 %"), best_buy(study)
    assert "no step removes the error of mesh: drop is 10 % off" in best_buy(study), best_buy(study)


if __name__ == "__main__":
    run_tests(smooth, scattered, chaotic, error_and_scatter, given, diverging, by_hand)
    finish()
