"""A run on 4 ranks (-long: 2 and 3, too) has the positions and velocities of a run on one.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
HARD = "several ranks crossed quickly, with contact history"


def check(c):
    one = c.run("scene.dem", name="one")
    if not c.runs_to_end(one):
        return
    frames = one.snapshots()
    c.holds("the two spheres collide", any(f[0].v[0] < 0.0 for f in frames), str(frames[-1][0].v))
    c.holds("the bond exists at the end", (2, 3) in [(low, high)
        for low, high, memory in frames[-1].rows if any(memory.values())], str(frames[-1].rows[:5]))
    for n in (2, 3, 4) if c.thorough else (4,):
        run = c.run("scene.dem", ranks=n, name="on%d" % n)
        if c.runs_to_end(run):
            off = max(max(math.dist(p.x, g[k].x)/0.1, math.dist(p.v, g[k].v)/50.0)
                      for f, g in zip(frames, run.snapshots()) for k, p in f.particles.items())
            c.below("%d ranks: largest difference of positions and velocities, relative" % n, off,
                    1e-12)
            c.equal("%d ranks: fingerprint" % n, run.hash, one.hash)
