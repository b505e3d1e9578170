"""cases.py -- run the cases of this folder, each a folder NN_name with scenes and a check.py, and
print the results.

A check.py has HARD (the difficulty of the case) and check(c), which runs scenes and compares their
output files:

    run = c.run("scene.dem", {"effects/dry/restitution": 0.9}, ranks=4)
                                                         the scene with entries changed, in a separate folder
    c.near("restitution", e, 0.9, 0.01)                  a row: result, expected value, tolerance
    c.below("speed, m/s", v, 1e-8)                       a row: not above this limit
    c.holds("refused by name", "glass" in run.err, run.err)
                                                         a row: true or false, with the text found

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import concurrent.futures
import importlib.util
import math
import os
import shutil
import sys
import time
import traceback

import fluid            # noqa: F401, for the checks: it sets a signal handler, which a thread may not
from results import Run
from tap import claim, finish

HERE = os.path.dirname(os.path.abspath(__file__))

AT_ONCE = 2


class Row:
    def __init__(self, what, wanted, measured, margin, good):
        self.what, self.wanted, self.measured, self.margin, self.good = what, wanted, measured, margin, good


def times(ratio):
    """Tolerance over deviation, as text."""
    return "exact" if math.isinf(ratio) else "-" if math.isnan(ratio) else ("%.1fx" if ratio < 10
        else "%.0fx" if ratio < 1e4 else "%.0ex") % ratio


def fits(tolerance, off):
    return tolerance/off if off > 0.0 else math.inf


class Case:
    def __init__(self, folder, options):
        self.folder, self.dem, self.long, self.ranks_limit = os.path.join(HERE,
            folder), options.dem, options.long, 120
        # ./Alltest -long: more ranks, not the long forms
        self.thorough = self.long or bool(os.environ.get("SUNA_LONG"))
        self.number, self.name = folder[:2] if folder[:2].isdigit() else "--", folder.lstrip("0123456789_").replace("_", " ")
        self.work = os.path.join(options.work, folder)
        self.rows, self.runs, self.hard = [], 0, ""
        shutil.rmtree(self.work, ignore_errors=True)
        os.makedirs(self.work)

    # ---- runs ------------------------------------------------------------------------------------

    def place(self, name):
        """A file or folder in the case's own place, for what a check makes itself."""
        return os.path.join(self.work, name)

    def places(self, name, columns, rows):
        """A table `places` in the folder of a run, which its scene inserts."""
        os.makedirs(self.place(name), exist_ok=True)
        with open(os.path.join(self.place(name), "places"), "w") as file:
            file.write(columns + "\n" + "".join(" ".join("%.17g" % x for x in row) + "\n" for row in rows))

    def run(self, scene, entries=None, ranks=1, restart=None, name=None, limit=None):
        """Run a scene of this folder with some entries changed, beside what it says in files
        written there."""
        self.runs += 1
        folder = self.place(name or "run%d" % self.runs)
        os.makedirs(folder, exist_ok=True)
        command = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
        command += [self.dem, "run"] + (["-restart", restart] if restart else [])
        for path, value in (entries or {}).items():
            command += ["-set", path, number(value)]
        command.append(os.path.join(self.folder, scene))
        return Run(folder, command, limit or (3000 if self.long else 300))

    def command(self, words, limit=3000):
        """Any other program, in the case's own place."""
        return Run(self.work, words, limit)

    # ---- rows ------------------------------------------------------------------------------------

    def near(self, what, measured, wanted, tolerance):
        off = abs(measured - wanted)
        self.rows.append(Row(what, "%.8g +- %.3g" % (wanted, tolerance), "%.9g" % measured,
                             fits(tolerance, off), off <= tolerance))

    def below(self, what, measured, limit):
        good = measured <= limit                             # False for what is not a number
        self.rows.append(Row(what, "<= %.3g" % limit, "%.4g" % measured, fits(limit, measured),
                             good))

    def above(self, what, measured, limit):
        self.rows.append(Row(what, ">= %.3g" % limit, "%.4g" % measured, fits(measured, limit),
                             measured >= limit))

    def equal(self, what, measured, wanted):
        good = measured is not None and measured == wanted   # None: neither run gave a fingerprint
        self.rows.append(Row(what, "%s" % (wanted,), "%s" % (measured,), math.inf if good else 0.0,
                             good))

    def holds(self, what, good, seen=""):
        self.rows.append(Row(what, "yes", "yes" if good else "no: " +
                             seen.strip()[-300:].replace("\n", " / "), math.nan, bool(good)))

    def skip(self, what, why):
        self.rows.append(Row(what + " # SKIP " + why, "", "", math.nan, True))

    def runs_to_end(self, run):
        """Most checks need a run that ended well; what it said otherwise becomes a row."""
        if run.status != 0:
            self.holds("runs to its end", False, run.err or run.out)
        return run.status == 0


def number(value):
    if isinstance(value, (tuple, list)):
        return "(" + " ".join(number(v) for v in value) + ")"
    return repr(value) if isinstance(value, float) else str(value)


def load(folder):
    spec = importlib.util.spec_from_file_location("check_" + folder,
        os.path.join(HERE, folder, "check.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def do(folder, options):
    case = Case(folder, options)
    start = os.times()
    try:
        module = load(folder)
        case.hard = module.HARD
        module.check(case)
    # a check that breaks is a check that fails
    except Exception:
        case.holds("the check itself", False, traceback.format_exc(limit=-2))
    if not case.rows:
        case.holds("measures something", False)
    case.spent = sum(os.times()[2:4]) - sum(start[2:4])
    return case


def chosen(words):
    folders = sorted(f for f in os.listdir(HERE) if os.path.exists(os.path.join(HERE, f,
        "check.py")))
    picked = [f for f in folders if not words or any(w.isdigit() and w.zfill(2) == f[:2]
        or not w.isdigit() and w in f for w in words)]
    if not picked:
        sys.exit("no case %s; there are: %s" % (" ".join(words), " ".join(folders)))
    return picked


def report(case):
    for row in case.rows:
        what = "%s %s: %s" % (case.number, case.name, row.what)
        if "# SKIP" not in what:
            what += " | %s | %s | %s" % (row.wanted, row.measured.replace("#", ""), times(row.margin))
        claim(what, row.good)


def tightest(case):
    """The row that fails, or else the one with the least margin."""
    return min(case.rows, key=lambda r: (r.good, math.inf if math.isnan(r.margin) else r.margin))


def table(cases):
    print("#\n# no case                  what is hard                                         its tightest row: criterion, measured, margin")
    for case in cases:
        row, good = tightest(case), sum(r.good for r in case.rows)
        print("# %s %-21s %-52s %s: %s, %s, %s; %d of %d passed" %
              (case.number, case.name, case.hard, row.what, row.wanted, row.measured,
                                                                    times(row.margin), good, len(case.rows)))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("case", nargs="*")
    parser.add_argument("-long", "--long", action="store_true")
    parser.add_argument("-keep", "--keep")
    parser.add_argument("--dem", required=True)
    parser.add_argument("--work", required=True)
    options = parser.parse_args()
    if options.keep:
        options.work = os.path.abspath(options.keep)
    cases, began = [], time.time()
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        for case in pool.map(lambda f: do(f, options), chosen(options.case)):
            report(case)
            cases.append(case)
    failed = sum(not r.good for c in cases for r in c.rows)
    table(cases)
    used = os.times()
    print("# %.0f s of processor, %.0f s of clock" % (used[2] + used[3], time.time() - began))
    print("# %d passed, %d failed" % (sum(len(c.rows) for c in cases) - failed, failed))
    finish()


if __name__ == "__main__":
    main()
