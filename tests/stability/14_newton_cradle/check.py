"""A row of equal spheres has the final speeds of an independent integration.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "many simultaneous contacts of one impact"
LEAVE = {("linear", 3): (-0.130263, 0.150218, 0.980045), ("hertz", 3): (-0.07095, 0.0764, 0.99455),
         ("linear", 5): (-0.132277, -0.075329, -0.031014, 0.296205, 0.942416),
         ("hertz", 5): (-0.071083, -0.030273, -0.014463, 0.12704, 0.988778),
         ("linear", 10): (-0.132277, -0.075412, -0.054662, -0.043572, -0.036558, -0.031584,
                          -0.021266, 0.078752, 0.438893, 0.877686),
         ("hertz", 10): (-0.071083, -0.030273, -0.015833, -0.008885, -0.005126, -0.002986,
                         -0.001738, 0.002671, 0.147385, 0.985867)}


def check(c):
    for (law, n), speeds in LEAVE.items():
        row = "(" + " ".join("(%.17g 0 0)" % (2e-3*k) for k in range(n - 1)) + ")"
        run = c.run("scene.dem" if law == "hertz" else "linear.dem", {"insert/row/positions": row},
                    name="%s%d" % (law, n))
        if c.runs_to_end(run):
            last = run.snapshots()[-1]
            c.below("%s, %d spheres: largest deviation of a speed, over the impact speed" %
                    (law, n),
                    max(abs(last[k].v[0] - v) for k, v in enumerate(speeds)), 0.005)
