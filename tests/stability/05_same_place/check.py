"""Two centres at one position: a direction is chosen, forces are finite, ranks agree.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "no direction between two centres"


def check(c):
    run = c.run("scene.dem")
    if c.runs_to_end(run):
        mid = run.snapshots()[1]
        c.equal("centres apart, m", max(abs(a - b) for a, b in zip(mid[0].x, mid[1].x)), 0.0)
        force = [mid[k].columns["force"] for k in (0, 1)]
        size = sum(f*f for f in force[0])**0.5
        c.holds("a force, finite", 0.0 < size < 1e300, str(force))
        c.below("sum of both over the force", max(abs(a + b) for a, b in zip(*force))/size, 1e-10)
        c.equal("4 ranks, fingerprint", c.run("scene.dem", ranks=4).hash, run.hash)
    run = c.run("scene.dem", {"time/maxOverlap": 0.5}, name="watched")
    c.holds("with the default limit it is stopped, both named",
            run.status != 0 and "particles 0 and 1" in run.err and "overlap" in run.err, run.err)
    both = "((0.001 0.001 0.001) (0.001 0.001 0.001))"
    said = [c.run("scene.dem", {"insert/pair/positions": both}, ranks=n, name="start%d" % n)
            for n in (1, 4)]
    c.holds("at one position at the start: refused, both named",
            said[0].status != 0 and "0 and 1" in said[0].err, said[0].err)
    c.holds("... and on 4 ranks", said[1].status != 0 and said[0].err.strip() in said[1].err,
            said[1].err)
