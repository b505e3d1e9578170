"""best_buy.py -- the best buy in one sentence: the longest step whose worst quantity is within the
target error. The longest is the cheapest, and no noise of the measured times can change the choice.

"Within" includes the uncertainty: error + uncertainty <= target. If no level satisfies that,

  - levels at which only statistical (chaotic) quantities exceed the target, with errors not above
    their uncertainty, are reported as not distinguishable from the finest level: a finer step would
    not help, a longer window or more runs would;
  - else a step is extrapolated with the observed order p of the quantity that is worst at the
    finest level, error ~ h^p, and its processor time with time ~ 1/h.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

from .refinement import STATISTICS


def percent(x, digits=2):
    return f"{100*x:.{digits}g} %"


def longest(series, fits):
    found = [level for level in series.levels if fits(level)]
    return max(found, key=lambda level: level.step) if found else None


def is_indistinct(study, series, level):
    """All quantities that exceed the target are statistical, with errors not above their
    uncertainty."""
    return bool(level.runs and level.worst) and all(
        error + level.uncertainty[q] <= study.target
        or (series.analysis[q].kind == STATISTICS and error <= level.uncertainty[q])
        for q, error in level.error.items() if math.isfinite(error))


def of_base(study, series):
    base = series.levels[series.base]
    return (f"; the {study.noun} as it is has {percent(base.bound()[0])}"
            if base.runs and base.worst else "")


def entry(study, series, level):
    above = ", above the limit: with time/force yes" if level.step > study.limit*(1 + 1e-9) else ""
    return f"{series.entry} {level.step:.4g} s ({level.name} of the {study.noun}'s{above})"


def chosen(study, series, level):
    bound, of = level.bound()
    within = f"{of}, the worst, is within {percent(bound)}, target {percent(study.target, 3)}"
    if level is series.levels[series.base]:
        text = f"the {study.noun} as it is, step {level.step:.4g} s: {within}"
    else:
        text = (f"{entry(study, series, level)}: {within}, for {series.times(level):.3g} times the "
                "processor time" + of_base(study, series))
    p = series.analysis[of].order
    return text + (f", half the error costs {2**(1/p):.3g} times the time (order {p:.2g})"
                   if p > 0.2 else "")


def indistinct(study, series, level):
    bound, of = level.bound()
    return (f"{entry(study, series, level)}, for {series.times(level):.3g} times the processor time, "
            f"cannot be distinguished from the finest level: within {percent(bound)} ({of}, the "
            f"worst), the scatter of {study.runs} chaotic runs of this window; to resolve "
            f"{percent(study.target, 3)} use a longer -window or more -runs")


def none(study, series, finest):
    bound, of = finest.bound()
    text = (f"no level is within {percent(study.target, 3)}: {of or 'nothing'} has {percent(bound)} "
            f"at the finest, step {finest.step:.4g} s")
    p = series.analysis[of].order if of else math.nan
    if p > 0.2:
        ratio = (bound/study.target)**(1/p)
        text += (f"; by its order of {p:.2g} a step of {finest.step/ratio:.3g} s would be, for "
                 f"{series.times(finest)*ratio:.3g} times the processor time of the {study.noun} as "
                 "it is")
    return text + of_base(study, series)


def other_errors(study):
    """Errors that do not depend on the step."""
    text = ""
    for series in study.series:
        base = series.levels[series.base] if series.base >= 0 else None
        if not base or series.exact or series.paired or not base.runs:
            continue
        large = {q: error for q, error in base.error.items()
                 if error > base.uncertainty[q] and error > study.target}
        if large:
            of = max(large, key=large.get)
            what = "softness" if series.parameter == "stiffness" else series.parameter
            text += (f"; no step removes the error of {what}: {of} is {percent(large[of])} off"
                     + (" hard spheres" if what == "softness" else ""))
    return text


def effects(study, series):
    """The effects without which no quantity changes by more than the target, and their processor
    time."""
    idle = [level for level in series.levels[:series.base]
            if level.bound()[0] <= study.target]
    if not idle:
        return (f"each effect changes something by more than {percent(study.target, 3)}, or the "
                "scatter of chaotic runs is larger than that")
    saved = max(0.0, sum(1 - series.times(level) for level in idle))
    return (f"without {', '.join(level.name for level in idle)} nothing changes by more than "
            f"{percent(study.target, 3)} in this window, each alone; together they take "
            f"{percent(saved)} of the processor time")


def choose(study):
    """The best level of the first series: ("within", level); ("indistinct", level); ("none", the
    finest that ran)."""
    series = study.series[0]
    for how, fits in (("within", lambda level: level.bound()[0] <= study.target),
                      ("indistinct", lambda level: is_indistinct(study, series, level))):
        found = longest(series, fits)
        if found:
            return how, found
    return "none", next((level for level in reversed(series.levels) if level.runs),
                        series.levels[0])


UNTOUCHED = "no contact happened in this window; take a longer -window, or -restart from a settled state"


def best_buy(study):
    if study.untouched:
        return "none; " + UNTOUCHED
    first = study.series[0] if study.series else None
    if first and first.parameter == "effects":
        return effects(study, first)
    if not first or not first.exact:
        what = "steps (-series step)" if study.noun == "scene" else "intervals (-series interval)"
        return f"needs the series of {what}"
    how, level = choose(study)
    text = {"within": chosen, "indistinct": indistinct, "none": none}[how](study, first, level)
    return text + other_errors(study)
