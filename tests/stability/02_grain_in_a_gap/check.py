"""A grain among large spheres neither sticks nor hovers, and leaves a groove at the expected time.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
HARD = "friction springs of two and more simultaneous contacts"


def longest(frames, still):
    most = now = 0
    for a, b in zip(frames, frames[1:]):
        now = now + 1 if still(a, b) else 0
        most = max(most, now)
    return most


def check(c):
    run = c.run("pocket.dem", {}, name="pocket")
    if c.runs_to_end(run):
        frames = run.snapshots()
        grain = [f[3] for f in frames[1:]]
        c.above("pocket: steps", frames[-1].steps, 1e6 - 1)
        # hovering: at rest without a contact between two outputs; sticking: at the same position
        # after half a period of the floor
        c.equal("pocket: outputs at which it rests without a force",
                sum(max(map(abs, p.columns["force"])) == 0.0 and max(map(abs, p.v)) < 1e-6
                                                                      for p in grain), 0)
        c.below("pocket: consecutive outputs at one position",
                longest(grain, lambda a, b: math.dist(a.x, b.x) < 1e-6), 1)
        # the floor's is 0.31; a dozen impacts at once
        c.below("pocket: largest speed, m/s", max(math.hypot(*p.v) for p in grain), 5.0)
    run = c.run("groove.dem", {}, name="groove")
    if c.runs_to_end(run):
        way, g = 0.05, 9.81*math.sin(math.radians(10.0))
        # inertia 2/5 m R^2 over (R/sqrt 2)^2
        wanted = (2.0*way/(g/(1.0 + 2.0/5.0*2.0)))**0.5
        frames = run.snapshots()
        late = next(k for k, f in enumerate(frames) if f[0].x[0] > way)
        a, b = frames[late - 1], frames[late]
        share = (way**0.5 - a[0].x[0]**0.5)/(b[0].x[0]**0.5 - a[0].x[0]**0.5)     # x goes with t^2
        c.near("groove: time over analytic time", (a.time + share*(b.time - a.time))/wanted, 1.0,
               0.05)
