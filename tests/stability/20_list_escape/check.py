"""No contact is missed: the same bits as with all pairs tested in each step, and as many contacts
as counted over all pairs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re
HARD = "the age of the neighbor list when speeds differ by a factor of 100"
SIDE = 0.034


def touching(frame):
    """All pairs that overlap, also through faces, cell by cell."""
    n, cells = 16, {}
    for p in frame.particles.values():
        cells.setdefault(tuple(int(x/SIDE*n) % n for x in p.x), []).append(p)
    count = 0
    for (i, j, k), here in cells.items():
        for a in (-1, 0, 1):
            for b in (-1, 0, 1):
                for d in (-1, 0, 1):
                    for q in cells.get(((i + a) % n, (j + b) % n, (k + d) % n), ()):
                        for p in here:
                            if p.id < q.id:
                                way = [y - x - SIDE*round((y - x)/SIDE) for x, y in zip(p.x, q.x)]
                                count += sum(w*w for w in way) < (p.radius + q.radius)**2
    return count


def check(c):
    run = c.run("scene.dem", name="tuned")
    if not c.runs_to_end(run):
        return
    c.above("steps", run.snapshots()[-1].steps, 1e4)
    c.equal("all pairs within two diameters in each step, fingerprint",
        c.run("scene.dem", {"neighbours/outerSkin": 2, "neighbours/innerSkin": 2}, name="all").hash,
        run.hash)
    reported = [int(n) for n in re.findall(r"(\d+) contacts", run.out)]
    found = [touching(f) for f in run.snapshots()][-len(reported):]
    c.equal("contacts at %d outputs, counted over all pairs" % len(found), reported, found)
    c.above("contacts counted", sum(found), 50)
