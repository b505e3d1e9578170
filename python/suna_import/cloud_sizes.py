"""cloud_sizes.py -- distributions of diameters of OpenFOAM's clouds.

    sizes(d, by, report)        "diameter 2.5e-3;", or "sizes { type ...; by ...; ... }"

The formulas follow OpenFOAM v1912, src/lagrangian/distributionModels:

    normal          density exp(-((x - expectation)/variance)^2): its deviation is variance/sqrt(2)
    RosinRammler    1 - exp(-((x - minValue)/d)^n)
    massRosinRammler    (x/d)^n has a gamma distribution of shape 1 + 3/n
    exponential     density exp(-lambda x)
    general         piecewise linear density
    multiNormal     sum of strength exp(-((x - expectation)/variance)^2/2)

all between minValue and maxValue. Those that Suna lacks become CLASSES diameters at the quantiles
(i + 1/2)/CLASSES.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

CLASSES = 40
FINE = 20001        # points at which a density is integrated


def cumulative(density, low, high):
    """Diameters and the fraction below them, between low and high."""
    x = numpy.linspace(low, high, FINE)
    y = numpy.maximum(density(x), 0.0)
    total = numpy.concatenate(([0.0], numpy.cumsum(0.5*(y[1:] + y[:-1]))))
    return x, total/total[-1]


def density(kind, d):
    """The density of this distribution, with its limits; None: not known."""
    low, high = d.number("minValue", 0.0), d.number("maxValue", numpy.inf)
    if kind == "RosinRammler":
        size, n = d.number("d"), d.number("n")
        def value(x):
            t = (x - low)/size
            with numpy.errstate(divide="ignore"):
                y = t**(n - 1)*numpy.exp(-t**n)
            return numpy.where(numpy.isfinite(y), y, y[1] if len(y) > 1 else 0)
    elif kind == "massRosinRammler":
        size, n = d.number("d"), d.number("n")
        def value(x):
            return (x/size)**(n + 2)*numpy.exp(-(x/size)**n)
    elif kind == "exponential":
        rate = d.number("lambda")
        def value(x):
            return numpy.exp(-rate*(x - low))
    elif kind == "multiNormal":
        inner = d.sub("distribution") if "distribution" in d else d
        parts = [inner.numbers(name, inner.list(name))
                 for name in ("expectation", "variance", "strength")]
        def value(x):
            return sum(s*numpy.exp(-0.5*((x - mu)/sigma)**2) for mu, sigma, s in zip(*parts))
    elif kind == "general":
        rows = numpy.array([d.numbers("distribution", row, 2, "pair of numbers")
                            for row in d.list("distribution")])
        if len(rows) < 2:
            d.refuse("distribution", "needs two rows or more")
        low, high = rows[0, 0], rows[-1, 0]
        def value(x):
            return numpy.interp(x, rows[:, 0], rows[:, 1])
    else:
        return None
    return value, low, high


def distribution(d, report):
    """Kind of d's sizeDistribution and the dictionary of its numbers."""
    kind = d.word("type")
    inner = d.sub(kind + "Distribution")
    return kind, inner if inner.entries else d


def sizes(d, by, report):
    """Entry of an insertion; `by`: number or volume, of which the distribution is one."""
    kind, d_in = distribution(d, report)
    place, word = d.where("type"), d.full("type") + " " + kind
    if kind == "fixedValue":
        report.translated(place, word, "diameter")
        return f"diameter {d_in.number('value'):.12g};"
    if kind == "uniform":
        report.translated(place, word, "sizes uniform")
        return (f"sizes {{ type uniform; by {by}; min {d_in.number('minValue'):.12g}; "
                f"max {d_in.number('maxValue'):.12g}; }}")
    if kind == "normal":
        report.translated(place, word, "sizes normal; OpenFOAM's variance is sqrt(2) deviations")
        return (f"sizes {{ type normal; by {by}; mean {d_in.number('expectation'):.12g}; "
                f"deviation {d_in.number('variance')/numpy.sqrt(2):.12g}; "
                f"min {d_in.number('minValue'):.12g}; max {d_in.number('maxValue'):.12g}; }}")
    diameters = classes(kind, d_in, report, place, word)
    report.approximated(place, word, f"{CLASSES} diameters at equal steps of its cumulative "
                        f"curve; the largest is {diameters[-1]:.4g} m")
    text = " ".join(f"{x:.6g}" for x in diameters)
    return f"sizes {{ type list; by {by}; diameters ({text}); weights ({'1 '*CLASSES}); }}"


def classes(kind, d, report, place, word, count=CLASSES):
    found = density(kind, d)
    if found is None:
        report.refuse(place, word, "Suna has uniform, normal and logNormal sizes, lists and "
                      "tables; give its classes as type general")
    value, low, high = found
    if not numpy.isfinite(high) or not high > low:
        d.refuse("maxValue", "is not above minValue")
    x, below = cumulative(value, low, high)
    return numpy.interp((numpy.arange(count) + 0.5)/count, below, x)


def diameters(d, count, report):
    """Diameters of `count` particles of a list, in a random order that is the same each time."""
    kind, d_in = distribution(d, report)
    if kind == "fixedValue":
        return None
    place, word = d.where("type"), d.full("type") + " " + kind
    if kind == "uniform":
        x = numpy.linspace(d_in.number("minValue"), d_in.number("maxValue"), count + 1)
        x = 0.5*(x[1:] + x[:-1])
    elif kind == "normal":
        mean, width = d_in.number("expectation"), d_in.number("variance")
        low, high = d_in.number("minValue"), d_in.number("maxValue")
        x, below = cumulative(lambda y: numpy.exp(-((y - mean)/width)**2), low, high)
        x = numpy.interp((numpy.arange(count) + 0.5)/count, below, x)
    else:
        x = classes(kind, d_in, report, place, word, count)
    report.approximated(place, word, "the quantiles of the distribution in a random order, where "
                        "OpenFOAM draws each diameter: the same distribution, other particles")
    return numpy.random.default_rng(1).permutation(x)
