"""Strong adhesion: the motion is bounded, gains no energy and keeps its momentum.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "a slope of -100 k: the attraction grows with the overlap"


def check(c):
    # fast enough to stick: at 0.1 m/s the pair separates again, as the plastic overlap is small
    pair = [(-1.001e-3, 0, 0, 0.4, 0.05, -0.02), (1.001e-3, 2e-4, 0, -0.2, 0.05, -0.02)]
    block = [(2e-3*i, 2e-3*j, 2e-3*k, 0.1 - 150.0*2e-3*(i - 2), 0.05 - 150.0*2e-3*(j - 2),
              -0.02 - 150.0*2e-3*(k - 1.5))
             for i in range(5) for j in range(5) for k in range(4)]
    for what, places, seconds in (("pair", pair, 0.1), ("100", block, 0.1 if c.long else 0.02)):
        c.places(what, "x y z vx vy vz", places)
        run = c.run("scene.dem", {"time/end": seconds, "write/interval": seconds/10,
                                  "write/energy": seconds/100}, name=what)
        if not c.runs_to_end(run):
            continue
        first, last = run.snapshots()[0], run.snapshots()[-1]
        inner = run.energy("kinetic", "elastic")
        c.above(what + ": steps", last.steps, 1e6*seconds - 1)
        c.below(what + ": largest growth of kinetic and elastic energy, of the first",
                max(b - a for a, b in zip(inner, inner[1:]))/inner[0], 1e-3)
        start = first.momentum()
        c.below(what + ": change of momentum, relative",
                max(abs(a - b) for a, b in zip(start, last.momentum()))/max(map(abs, start)), 1e-10)
        at = [p.x for p in last.particles.values()]
        touching = sum(1 for i, x in enumerate(at) for y in at[:i]
                       if sum((a - b)**2 for a, b in zip(x, y)) < 2e-3**2)
        c.above(what + ": contacts at the end", touching, len(places) - 1.5)
