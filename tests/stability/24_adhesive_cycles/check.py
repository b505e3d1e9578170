"""Small cycles of an attractive contact take work and give none, and its history is bounded.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
HARD = "history that is reduced during adhesion"
START = 4e-5                                                 # m, overlap


def check(c):
    # to the branch of adhesion: first the whole displacement, to find the lowest force
    whole = c.run("scene.dem", {"time/end": 0.039}, name="whole")
    if not c.runs_to_end(whole):
        return
    rows = whole.wall("plate")
    low = min(range(len(rows)), key=lambda k: -rows[k]["fz_now"])
    for what, later in (("at the strongest attraction", 0.0), ("beyond it", 0.003)):
        begin = round(rows[low]["time"] + later, 4)
        depth = START - 1e-3*begin
        name = what.replace(" ", "_")
        there = c.run("scene.dem", {"time/end": begin, "write/interval": begin}, name=name)
        cycle, cycles = 0.01, 100 if c.long else 20
        end = begin + cycles*cycle
        move = "{ type oscillation; amplitude (0 0 %.17g); frequency %.17g; phase %.17g; }" % (0.01*depth, 1.0/cycle, -2.0*math.pi*begin/cycle)
        # the plate goes on from where it stands
        run = c.run("cycles.dem", {"walls/plate/motion/amplitude": (0, 0, 0.01*depth),
                                   "walls/plate/motion/phase": -2.0*math.pi*begin/cycle,
                                   "time/end": end, "write/interval": 1.0,
                                   "write/walls": cycle/100},
                    restart=there.path("snapshot_000001.dem"), name=name + "_cycles")
        if not c.runs_to_end(run):
            continue
        rows2 = [r for r in run.wall("plate") if r["time"] > begin - 1e-9]
        way = [0.01*depth*math.sin(2.0*math.pi*(r["time"] - begin)/cycle) for r in rows2]
        force = [r["fz_now"] for r in rows2]                                     # on the plate
        work = []
        for k in range(cycles - 1):
            at = range(100*k, 100*(k + 1))
            work.append(-sum(0.5*(force[i] + force[i + 1])*(way[i + 1] - way[i]) for i in at))
        c.holds(what + ": the contact attracts", force[50] > 0.0,
                "force on the plate %g N" % force[50])
        scale = max(map(abs, force))*0.02*depth
        c.below(what + ": work gained in a cycle, over force times displacement",
                max(-w for w in work)/scale, 1e-9)
        memory = run.snapshots()[-1].rows[0][2]["largest_overlap"]
        c.below(what + ": overlap in the history over the largest overlap", memory/START, 1.0)
