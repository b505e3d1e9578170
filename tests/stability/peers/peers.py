"""peers.py -- cases of tests/stability in other codes, by the same criteria. Called by run; results:
docs/results.md.

    peers.py [CASE|PEER ...] [-keep FOLDER]       a case by number or a part of its name

Prints a line a measured number: `case | peer | criterion | measured | pass or fail | how`, then a
line a case.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import shutil
import sys
import tempfile
import time
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import coupled                                               # noqa: E402
import grains                                                # noqa: E402
import pairs                                                 # noqa: E402
import programs                                              # noqa: E402
import triangles                                             # noqa: E402

CASES = [("01 size ratio", grains.size_ratio, grains.CODES),
    ("02 grain in a gap", grains.gap, grains.CODES), ("03 fast impact", grains.fast, grains.CODES),
         ("04 overlap at start", grains.overlap, grains.CODES),
         ("05 same place", grains.same_place, grains.CODES),
         ("07 restitution 0 and 1", grains.ends, grains.CODES),
         ("08 corner", grains.corner, grains.CODES), ("09 triangles", triangles.flat,
             ("liggghts", "suna")), ("10 degenerate triangles", triangles.faults,
                                     ("liggghts", "suna")),
         ("11 static pile", grains.pile, grains.CODES),
         ("12 ratcheting", grains.ratchet, grains.CODES),
         ("13 column", grains.column, grains.CODES), ("14 newton cradle", grains.cradle,
             grains.CODES),
         ("15 slip reversal", grains.reversal, grains.CODES),
         ("16 spin sign", grains.spin, grains.CODES),
         ("18 cyclic wrap", pairs.wrap, grains.CODES),
         ("20 list escape", pairs.escape, grains.CODES),
         ("22 strong sticking", pairs.sticking, ("liggghts", "yade", "suna")),
         ("23 no hysteresis", pairs.elastic, ("liggghts", "yade", "suna")),
         ("30 small stokes", coupled.small_stokes, ("dpmfoam",)),
         ("31 light particles", coupled.light, ("dpmfoam",)),
         ("32 packing", coupled.packing, ("dpmfoam",)), ("33 cell sizes", coupled.cell_sizes,
             ("dpmfoam",)),
         ("35 moving fraction", coupled.moving, ("dpmfoam",)),
         ("37 coupling interval", coupled.interval, ("dpmfoam",))]


class Foam:
    """Its cases are in coupled.py."""

    def there(self):
        return None if shutil.which("DPMFoam") and os.environ.get("WM_PROJECT_DIR") else "there is no DPMFoam (source ../../../coupling/setup/environment)"


PEERS = dict(programs.PEERS, dpmfoam=Foam())


class Case:
    """Rows of one case in one code."""

    def __init__(self, name, peer, work):
        self.name, self.peer, self.work, self.rows = name, peer, os.path.join(work,
            name.replace(" ", "_"), peer), []

    def row(self, what, measured, good, how=""):
        self.rows.append(good)
        how = how.replace("|", "/").replace("\n", " ").replace(HERE + os.sep,
            "").replace(self.work + os.sep, "")
        print(" | ".join((self.name, self.peer, what, measured, "pass" if good else "fail", how)),
              flush=True)

    def place(self, name):
        return os.path.join(self.work, name)

    def start(self, scene, name="run"):
        return PEERS[self.peer].run(scene, os.path.join(self.work, name))

    def ended(self, run):
        """Most criteria need a run that ended well, with finite numbers; else the outcome is a
        row."""
        if run.status or len(run.frames) < 2:
            self.row("runs to its end", "status %d" % run.status, False, run.complaint())
        elif not run.finite():
            self.row("finite places and speeds", "not a number", False, "runs on with it")
        return not run.status and len(run.frames) > 1 and run.finite()

    def run(self, scene, name="run"):
        run = self.start(scene, name)
        return run if self.ended(run) else None

    def near(self, what, measured, wanted, tolerance, how=""):
        self.row("%s = %.8g +- %.3g" % (what, wanted, tolerance), "%.7g" % measured,
                 abs(measured - wanted) <= tolerance, how)

    def below(self, what, measured, limit, how=""):
        self.row("%s <= %.3g" % (what, limit), "%.4g" % measured, measured <= limit, how)

    def above(self, what, measured, limit, how=""):
        self.row("%s >= %.3g" % (what, limit), "%.4g" % measured, measured >= limit, how)

    def holds(self, what, good, how=""):
        self.row(what, "yes" if good else "no", bool(good), how)


def chosen(words):
    """Cases and codes named by the arguments; all of a kind if none is named."""
    peers = [w for w in words if w in PEERS]
    picked = [w for w in words if w not in PEERS]
    cases = [c for c in CASES if not picked or any(w.zfill(2) == c[0][:2] if w.isdigit()
        else w in c[0] for w in picked)]
    if not cases:
        sys.exit("no case %s; there are: %s" % (" ".join(picked), ", ".join(c[0] for c in CASES)))
    return cases, peers or list(PEERS)


def do(name, check, peer, work):
    case = Case(name, peer, work)
    try:
        check(case)
    except NotImplementedError as none:
        print(" | ".join((name, peer, "-", "-", "skip", "it cannot express it: %s" % none)),
              flush=True)
        return None
    # a check that raises an exception is reported as a failure
    except Exception:
        case.row("the check itself", "no", False,
                 traceback.format_exc(limit=-1).strip().splitlines()[-1])
    return case.rows


def main(words):
    keep = None
    if "-keep" in words:
        at = words.index("-keep")
        keep, words = os.path.abspath(words[at + 1]), words[:at] + words[at + 2:]
    work = keep or tempfile.mkdtemp()
    cases, peers = chosen(words)
    table = []
    for name, check, able in cases:
        marks = []
        for peer in (p for p in peers if p in able):
            missing = PEERS[peer].there()
            if missing:
                print(" | ".join((name, peer, "-", "-", "skip", missing)), flush=True)
                continue
            began = time.time()
            rows = do(name, check, peer, work)
            if rows:
                marks.append("%s %d of %d, %.0f s" % (peer, sum(rows), len(rows),
                    time.time() - began))
        table.append("# %s: %s" % (name, "; ".join(marks) or "none"))
    print("\n".join(table))
    if not keep:
        shutil.rmtree(work)


if __name__ == "__main__":
    main(sys.argv[1:])
