"""Spheres that fill a cup and rest stay at rest: no creep, no jitter, no energy.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "thousands of sticking contacts for a long time"
R, G = 1e-3, 9.81
SETTLE, STEPS = 0.4, {False: 10000, True: 1000000}


def height(frame):
    return sum(p.x[2] for p in frame.particles.values())/len(frame.particles)


def check(c):
    run = c.run("scene.dem", {"time/end": SETTLE, "write/interval": SETTLE, "write/energy": SETTLE,
                              "time/step": 1e-5, "effects/dry/restitution": 0.2}, name="settle")
    if not c.runs_to_end(run):
        return
    last = run.path("snapshot_000001.dem")
    end = SETTLE + 1e-5*STEPS[c.long]
    run = c.run("scene.dem", {"time/end": end, "write/interval": (end - SETTLE)/10,
        "write/energy": (end - SETTLE)/10, "time/step": 1e-5}, restart=last, name="rest")
    if not c.runs_to_end(run):
        return
    frames = run.snapshots()
    c.above("steps at rest", frames[-1].steps - frames[0].steps, 0.9*STEPS[c.long])
    c.below("displacement of the centre of mass, R", max(abs(height(f) - height(frames[0]))
        for f in frames)/R, 1e-6)
    c.below("largest speed, m/s", max(sum(v*v for v in p.v)**0.5 for f in frames
                                      for p in f.particles.values()), 1e-8)
    energy = run.energy("kinetic", "elastic", "gravity")
    held = max(row["elastic_hertz"] for row in run.table("energy.csv"))
    # energy.csv has twelve digits of each column
    c.below("largest growth of the energy between outputs, over the elastic energy",
            max(b - a for a, b in zip(energy, energy[1:]))/held, 1e-9)
