"""A sphere in a corner rests after 10^6 steps, and three contacts carry its weight.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "three contacts with friction at once, and rest"


def check(c):
    run = c.run("scene.dem")
    if not c.runs_to_end(run):
        return
    last = run.snapshots()[-1]
    c.above("steps", last.steps, 1e6 - 1)
    c.below("kinetic energy at the end, J", last.kinetic(), 1e-16)
    weight = [last[0].mass*g for g in (-3.0, -4.0, -8.45)]
    rows = [run.wall(w)[-1] for w in ("left", "back", "floor")]
    c.below("sum of the three forces less the weight, over it",
            max(abs(sum(r[f] for r in rows) - w) for f, w in zip(("fx_now", "fy_now", "fz_now"),
                weight))/abs(weight[2]), 1e-8)
    c.equal("walls with a normal force", sum(abs(r[f]) > 0.1*abs(w)
        for r, f, w in zip(rows, ("fx_now", "fy_now", "fz_now"), weight)), 3)
    # at rest there is no slip, so friction dissipates no more; springs that grew would be cut to
    # the limit repeatedly
    taken = {round(r["time"], 3): r["lost_mindlin"] for r in run.table("energy.csv")}
    c.below("dissipation by friction from 5 s to 10 s, over all before",
            abs(taken[10.0] - taken[5.0])/taken[5.0], 1e-11)
