"""Wrong values are refused in one sentence that names the entry; the limits of ranges are accepted.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
HARD = "zero, negative, not a number, beyond the range"
REFUSED = [("insert/two/diameter", ("0", "-2e-3", "nan", "inf")),
           ("materials/glass/density", ("0", "-2500", "nan", "inf")),
           ("materials/glass/youngsModulus", ("0", "-1e7", "nan", "inf")),
           ("materials/glass/poissonsRatio", ("0.5", "-0.1", "nan")),
           ("effects/dry/restitution", ("1.01", "-0.1", "nan")),
           ("effects/mindlin/friction", ("-0.3", "nan")),
           ("effects/gravity/acceleration", ("(0 0 nan)", "(0 0 -inf)")),
           ("insert/two/velocity", ("(nan 0 0)", "(0 inf 0)")),
           ("insert/two/positions", ("((0 0 nan) (0.01 0 0.01))",)),
           ("time/end", ("nan", "-1", "0")), ("time/step", ("0", "-1e-6", "nan"))]
ACCEPTED = [("effects/dry/restitution", "0"), ("effects/dry/restitution", "1"),
            ("effects/mindlin/friction", "0"),
         ("materials/glass/poissonsRatio", "0"), ("materials/glass/poissonsRatio", "0.499")]


def names_entry(err, path, value):
    """The sentence has the name of the entry and the number given, in any notation."""
    first = float(value.strip("()").split()[0]) if value[0] != "(" else None
    numbers = [float(x) for x in re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?", err)]
    return err.count("\n") == 1 and path.split("/")[-1] in err and (first is None
        or first in numbers or "nan" in err or "inf" in err)


def check(c):
    good, all_of = 0, 0
    for path, values in REFUSED:
        for value in values:
            all_of += 1
            run = c.run("scene.dem", {path: value})
            named = names_entry(run.err, path, value)
            clean = not os.path.exists(os.path.join(run.folder, "out"))
            good += run.status == 1 and named and clean
            if not (run.status == 1 and named and clean):
                c.holds("%s %s" % (path, value), False, "status %d: %s" % (run.status, run.err))
    c.equal("refused in one sentence that names the entry, nothing written", good, all_of)
    c.equal("limits of ranges accepted", sum(c.run("scene.dem", {path: value}).status == 0
                                             for path, value in ACCEPTED), len(ACCEPTED))
