"""e = 0 leaves almost no speed, with linear and Hertzian springs; e = 1 loses none in 10^4 bounces.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "the limits of restitution"


def check(c):
    for law, scene, limit in (("hooke", "hooke.dem", 1e-3), ("hertz", "scene.dem", 0.02)):
        run = c.run(scene)
        if c.runs_to_end(run):
            # 25 contact times later: separated, or still in slow recovery
            last = run.snapshots()[-1][0]
            c.below("e = 0, %s: rebound speed over impact speed" % law, abs(last.v[2]),
                    limit)
            c.below("e = 0, %s: overlap left, over the radius" % law,
                    max(1e-3 - last.x[2], 0.0)/1e-3, 1e-3)
    run = c.run("box.dem")
    if c.runs_to_end(run):
        frames = run.snapshots()
        mass = frames[0][0].mass
        start = frames[0].kinetic()
        # impulse of the six walls over 2 m v of a bounce at the largest possible speed, sqrt(2
        # E/m): a lower bound of the number of bounces
        apart = [f for f in frames if alone(f)]
        passes = sum(abs(row["fx"]) + abs(row["fy"]) + abs(row["fz"])
            for row in run.table("walls.csv"))*frames[-1].time/(2.0*mass*(2.0*start/mass)**0.5)
        c.above("e = 1: bounces off walls", passes, 1e4)
        c.above("e = 1: outputs without contacts", len(apart), 10)
        c.below("e = 1: largest drift of kinetic energy",
                max(abs(f.kinetic()/start - 1.0) for f in apart), 1e-4)


def alone(frame):
    return all(max(map(abs, p.columns["force"])) == 0.0 for p in frame.particles.values())
