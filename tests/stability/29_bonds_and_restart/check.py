"""Blocks bonded across periodic faces break, are saved and continue on any number of ranks with the
same bits (tests/parallel/bonded.dem).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
HARD = "bonds through faces and ranks, some broken, saved and read"
SCENE = os.path.join("..", "..", "parallel", "bonded.dem")


def check(c):
    files = {"write/folder": "out", "write/snapshot": "all"}
    whole = c.run(SCENE, files, name="whole")
    if not c.runs_to_end(whole):
        return
    broken = open(whole.path("bonds.csv")).read()
    half = whole.path("snapshot_000001.dem")
    c.above("bonds that broke", broken.count("\n") - 1, 100)
    c.above("bonds that broke before the snapshot", sum(row["time"] < 0.006
        for row in whole.table("bonds.csv")), 10)
    for n in (1, 2, 4) if c.thorough else (1, 4):
        if n > 1:
            run = c.run(SCENE, files, ranks=n, name="on%d" % n)
            c.equal("whole on %d ranks, fingerprint" % n, run.hash, whole.hash)
            c.holds("... the same bonds broke", run.status == 0
                    and open(run.path("bonds.csv")).read() == broken, run.err)
        run = c.run(SCENE, files, ranks=n, restart=half, name="again%d" % n)
        c.equal("from halfway on %d, fingerprint" % n, run.hash, whole.hash)
