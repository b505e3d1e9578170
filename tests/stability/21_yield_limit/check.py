"""Force and slope of unloading do not jump where yielding ends.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "a law that changes its branch at one overlap"
LIMIT = 5.0/4.0*0.02*2e-3                                    # m, d_lim = k_m/(k_m - k) phi 2 R


def check(c):
    seen = []
    for off in (-1e-12, 0.0, 1e-12):
        run = c.run("scene.dem", {"insert/ball/positions": "((0 0 %.17g))" %
                                  (1e-3 - LIMIT*(1.0 + off))})
        if not c.runs_to_end(run):
            return
        rows = run.wall("plate")
        f = [-r["fz_now"] for r in rows]
        seen.append((f[0], (f[0] - f[9])/(1e-3*(rows[9]["time"] - rows[0]["time"]))))
    # twelve digits of a force; a tenth of it is left
    c.near("slope of unloading, N/m", seen[1][1], 5000.0, 1e-6*5000.0)
    for what, k in (("force", 0), ("slope", 1)):
        for side, n in (("below", 0), ("above", 2)):
            c.below("%s, just %s the limit: difference, relative" % (what, side),
                    abs(seen[n][k]/seen[1][k] - 1.0), 1e-9)
