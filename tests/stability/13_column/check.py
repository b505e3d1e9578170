"""A column of 200 spheres at rest has the force on the floor, the overlap at the floor and the
height of statics: sums over the contacts, for Hertzian and linear springs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "200 contacts in a row: slow waves, small errors that add up"
# N; m, of the top centre without overlap
WEIGHT, TOP = 2.0538999e-2, 0.399
SUMS = (("hertz", "scene.dem", 1.25253e-5, 0.39599403592),
        ("linear", "linear.dem", 2.0539e-5, 0.396935831))


def check(c):
    for law, scene, floor, top in SUMS:
        run = c.run(scene, name=law)
        if c.runs_to_end(run):
            last = run.snapshots()[-1]
            c.near(law + ": force on the floor, N", -run.wall("floor")[-1]["fz_now"], WEIGHT,
                   1e-5*WEIGHT)
            c.near(law + ": overlap on the floor, m", 1e-3 - last[0].x[2], floor, 1e-5*floor)
            # all overlaps together, to 1e-5
            c.near(law + ": centre of the top sphere, m", last[199].x[2], top, 1e-5*(TOP - top))
