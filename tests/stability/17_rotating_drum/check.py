"""The slope is steady, no particle passes the wall, and the work of the drum is dissipated by
friction and impacts.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
HARD = "simultaneous rolling, sliding and impacts on a moving wall"


def check(c):
    if c.long:                                               # the drum of 0.2 m with 1000 spheres
        radius, seconds, steady = 0.1, 12.0, 3.0
        entries = {"walls/drum/radius": radius, "insert/grains/count": 1000,
            "insert/grains/min": (-0.03, 0, -0.094), "insert/grains/max": (0.03, 0.01, -0.05)}
    else:
        radius, seconds, steady, entries = 0.022, 1.6, 0.8, {}
    run = c.run("scene.dem", dict(entries, **{"time/end": seconds}))
    if not c.runs_to_end(run):
        return
    frames = [f for f in run.snapshots() if f.time >= steady - 1e-9]
    slope = []
    for f in frames:
        x, z = (sum(p.x[a] for p in f.particles.values())/len(f.particles) for a in (0, 2))
        slope.append(math.degrees(math.atan2(-x, -z)))
    mean = sum(slope)/len(slope)
    # a drum of 22 diameters has avalanches: four seeds gave 1.2 to 3.1 degrees about 33.5 to 33.8
    c.below("standard deviation of the slope about %.1f degrees" % mean,
            (sum((s - mean)**2 for s in slope)/len(slope))**0.5, 2.0 if c.long else 4.0)
    c.below("largest distance of a surface beyond the wall, diameters",
            max(math.hypot(p.x[0], p.x[2]) + p.radius - radius for f in frames
                for p in f.particles.values())/2e-3, 0.05)
    c.equal("grains at the end", len(frames[-1].particles), len(run.snapshots()[0].particles))
    # work of the wall by its torque (walls.csv) against dissipated and stored energy (energy.csv),
    # from the start
    torque = sum(-row["ty"]*0.02*1.5707963268 for row in run.wall("drum"))
    first, last = run.table("energy.csv")[0], run.table("energy.csv")[-1]
    taken = sum(last[k] - first[k] for k in last if k.startswith(("kinetic", "gravity", "elastic",
        "lost")))
    lost = sum(last[k] - first[k] for k in last if k.startswith("lost"))
    c.below("torque times angle less dissipated and stored energy, over the dissipated energy",
            abs(torque - taken)/lost, 0.02)
