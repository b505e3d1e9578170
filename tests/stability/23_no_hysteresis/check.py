"""Parameters that give zero denominators in the formulas give an elastic spring.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "k_m - k = 0 and phi = 0 in denominators"


def check(c):
    for what, unloading, depth in (("k_m = k, phi = 0", 1, 0), ("k_m = k, phi = 0.05", 1, 0.05),
                                   ("k_m = 5 k, phi = 0", 5, 0)):
        out = []
        for phase in range(16):
            run = c.run("scene.dem", {"effects/hookeHysteresis/unloading": unloading,
                                      "effects/hookeHysteresis/plasticDepth": depth,
                                      "insert/ball/positions": "((0 0 %.17g))" %
                                      (1.05e-3 + 8e-7*phase/16.0)})
            if not c.runs_to_end(run):
                return
            last = run.snapshots()[-1]
            out.append(last[0].v[2] if last.finite() else float("nan"))
        c.near(what + ": restitution, mean of 16 phases", sum(out)/16, 1.0, 1e-4)
