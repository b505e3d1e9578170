#!/usr/bin/env python3
"""compare.py -- the cost of a given error in Suna and LIGGGHTS: three scenes, over a series of time
steps.

    compare.py [damped oblique bed] [--turns 2] [--dem DEM] [--bed BED]

Both codes start from the same table of spheres with the same laws. Each turn runs the whole series
in Suna (dem cost) and then in LIGGGHTS, with the same numbers of steps in each run of a level.
suna_cost evaluates both, each against its own limit or the closed form. LIGGGHTS' time
is its process's less a run without steps (the minimum of three); its skin is the fastest of four.
Suna's time covers its steps. BED: tests/speed/bed.c, built, which reads the settled bed. Results go
to ../stored/peers.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import csv
import datetime
import math
import pathlib
import random
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parents[3]/"python"))
from suna_cost.report import write_table            # noqa: E402
from suna_cost.study import Level, Run, Series, Study            # noqa: E402

RUNS, SAMPLES, LEVELS = 3, 32, (2, 1, 0.5, 0.25, 0.125)
PLANES = ("zplane 0.0", "xplane 0.0", "xplane 0.008", "yplane 0.0", "yplane 0.008")
# restitution; walls; gravity [m/s2]; window [s]; samples; closed form, as a fraction of the initial
# kinetic energy
SCENES = {
    "damped": dict(restitution=0.8, walls=(), gravity=0.0, window=4e-4, looks=1, of="kinetic",
                   kept=0.8**2),
    "oblique": dict(restitution=0.9, walls=PLANES[:1], gravity=0.0, window=4e-4, looks=1,
                    of="kinetic,rotation", kept=None),
    "bed": dict(restitution=0.5, walls=PLANES, gravity=19.62, window=0.02, looks=SAMPLES,
                of="kinetic,rotation", kept=None),
}


def run(command, folder, log):
    """A command's output into a file; processor time of it [s]."""
    def spent():
        use = resource.getrusage(resource.RUSAGE_CHILDREN)
        return use.ru_utime + use.ru_stime
    before = spent()
    with open(folder/log, "w") as out:
        if subprocess.run(command, cwd=folder, stdout=out, stderr=subprocess.STDOUT).returncode:
            sys.exit(f"compare: {' '.join(map(str, command))} failed; see {folder/log}")
    return spent() - before


# ---- the spheres ---------------------------------------------------------------------------------

def lattice(n):
    """Positions 3 mm apart."""
    side = math.ceil(n**0.5)
    return [(3e-3*(k % side), 3e-3*(k//side)) for k in range(n)]


def spheres(name, a, folder):
    """Rows x y z vx vy vz wx wy wz. Gaps are spread over a step of the coarsest level."""
    random.seed(1)
    if name == "damped":
        rows = []
        for x, y in lattice(16000):
            gap = 2e-5 + 1e-5*random.random()
            rows += [(x, y, 0, 0.5, 0, 0, 0, 0, 0), (x + 1e-3 + gap, y, 0, -0.5, 0, 0, 0, 0, 0)]
        return rows
    if name == "oblique":
        return [(x, y, 0.5e-3 + 2e-5 + 5e-6*random.random(), 0.5, 0, -0.5, 0, 0, 0)
                for x, y in lattice(32000)]
    run([a.dem, "run", HERE.parent/"settle.dem"], folder, "log.settle")
    text = (HERE.parent/"settle.dem").read_text().splitlines()
    (folder/"as.dem").write_text("\n".join(line for line in text
        if line.split()[0] not in ("insert", "time", "write")) + "\n")
    run([a.bed, "state", "as.dem", "settled/snapshot.dem", "1", "0.008", "0"], folder, "state.txt")
    return [tuple(map(float, line.split()[2:]))
            for line in (folder/"state.txt").read_text().splitlines()]


def write(rows, folder):
    """The table for Suna, the data file for LIGGGHTS."""
    low, high = [min(r[k] for r in rows) - 5e-3 for k in range(3)], [max(r[k] for r in rows) + 5e-3
        for k in range(3)]
    low[2], high[2] = -1e-3, max(high[2], 0.03)
    with open(folder/"spheres.csv", "w") as out:
        out.write("x,y,z,vx,vy,vz,wx,wy,wz\n")
        out.writelines(",".join(repr(v) for v in r) + "\n" for r in rows)
    with open(folder/"data.txt", "w") as out:
        out.write(f"spheres\n\n{len(rows)} atoms\n1 atom types\n\n" +
                  "".join(f"{low[k]} {high[k]} {c}lo {c}hi\n" for k, c in enumerate("xyz")))
        out.write("\nAtoms\n\n" + "".join(f"{i + 1} 1 1e-3 2500 {r[0]!r} {r[1]!r} {r[2]!r}\n"
                                          for i, r in enumerate(rows)))
        out.write("\nVelocities\n\n" + "".join(f"{i + 1} {' '.join(repr(v) for v in r[3:])}\n"
                                               for i, r in enumerate(rows)))


# ---- the codes -----------------------------------------------------------------------------------

def rows_of(path):
    with open(path) as file:
        return [r for r in csv.DictReader(file) if r["series"] == "step"]


def suna(name, a, folder):
    """dem cost on the scene; the rows of its table."""
    scene = SCENES[name]
    run([a.dem, "cost", "-series", "step", "-runs", str(RUNS), "-of", scene["of"], "-budget", "1e6",
         "-folder", "suna", f"{name}.dem"], folder, "log.suna")
    return rows_of(folder/"suna/cost.csv")


def deck(scene, folder, steps, looks, skin):
    text = (HERE/"spheres.in").read_text()
    walls = [f"fix w{k} all wall/gran model hertz tangential history primitive type 1 {p} tangential_damping off" for k, p in enumerate(scene["walls"])]
    if scene["gravity"]:
        walls.append(f"fix down all gravity {scene['gravity']} vector 0 0 -1")
    words = {"SKIN": repr(skin), "RESTITUTION": repr(scene["restitution"]),
             "WALLS": "\n".join(walls), "EVERY": str(max(steps//looks, 1)),
             "STEPS": str(steps), "STEP": repr(scene["window"]/max(steps, 1))}
    lines = text.splitlines()
    for word, value in words.items():
        lines = [line if line.startswith("#") else line.replace(word, value) for line in lines]
    (folder/"in.txt").write_text("\n".join(lines) + "\n")


def liggghts_rest(scene, folder, skin):
    """Processor time of a run of no steps [s]."""
    deck(scene, folder, 0, 1, skin)
    return min(run(["liggghts", "-in", "in.txt", "-log", "none"], folder, "log.rest")
               for _ in range(3))


def liggghts_once(scene, folder, steps, skin, rest):
    """Processor time of the steps [s], kinetic and rotational energy [J], means of the samples."""
    deck(scene, folder, steps, scene["looks"], skin)
    whole = run(["liggghts", "-in", "in.txt", "-log", "none"], folder, "log.liggghts")
    printed = [line.split() for line in (folder/"log.liggghts").read_text().splitlines()]
    printed = [(float(w[1]), float(w[2])) for w in printed if len(w) == 3 and w[0].isdigit()
               and int(w[0]) > 0]
    if len(printed) != scene["looks"]:
        sys.exit(f"compare: {len(printed)} samples instead of {scene['looks']}; see {folder/'log.liggghts'}")
    turn = sum(t[1] for t in printed)/len(printed)
    return whole - rest, sum(t[0] for t in printed)/len(printed) + turn, turn


def liggghts(name, folder, steps_of, skin):
    """The same series; its rows."""
    scene = SCENES[name]
    rest = liggghts_rest(scene, folder, skin)
    series = Series("step", "time step as in Suna", exact=True, base=LEVELS.index(1))
    for size, own in zip(LEVELS, steps_of):
        level = Level(f"{size:g}", size, scene["window"]/own)
        apart = max(1, round(0.08*own/scene["looks"]/(RUNS - 1)))*scene["looks"]
        for k in range(RUNS):
            steps = own + apart*(k - (RUNS - 1)//2)
            seconds, kinetic, turn = liggghts_once(scene, folder, steps, skin, rest)
            level.runs.append(Run(steps, max(seconds, 1e-6), {"kinetic": kinetic, "rotation": turn}))
        series.levels.append(level)
    study = Study("case", "", scene["window"], 0.01, dict.fromkeys(scene["of"].split(","), "J"),
                  series=[series])
    study.evaluate()
    write_table(study, folder/"liggghts.csv")
    return rows_of(folder/"liggghts.csv")


def fastest(name, folder, steps):
    """The skin [m] with which LIGGGHTS is fastest."""
    skins = (5e-5, 1e-4, 2e-4, 4e-4)
    scene = SCENES[name]
    return min(skins, key=lambda skin: liggghts_once(scene, folder, steps, skin,
        liggghts_rest(scene, folder, skin))[0])


# ---- comparison ----------------------------------------------------------------------------------

def errors(name, rows, quantity, start):
    """[(level, error, seconds)]; against the closed form where there is one."""
    kept = SCENES[name]["kept"]
    own = [r for r in rows if r["quantity"] == quantity]
    return [(float(r["level"]), abs(float(r["mean"])/(kept*start) - 1) if kept
             else float(r["error"]), float(r["processor[s]"])) for r in own]


def price(points, error):
    """Time at an error: linear in the logarithms between levels, extrapolated from the nearest two;
    nan where errors do not decrease."""
    p = [(math.log(e), math.log(t)) for _, e, t in points if e > 0]
    for (e0, t0), (e1, t1) in zip(p, p[1:]):
        if e1 < e0 and (math.log(error) >= e1 or (e1, t1) == p[-1]):
            return math.exp(t0 + (t1 - t0)*(math.log(error) - e0)/(e1 - e0))
    return math.nan


def compare(name, a, folder, out):
    shutil.copy(HERE/f"{name}.dem", folder)
    rows = spheres(name, a, folder)
    write(rows, folder)
    start = sum(0.5*2500*math.pi/6e9*(r[3]**2 + r[4]**2 + r[5]**2) for r in rows)
    turns, skin = [], None
    for _ in range(a.turns):
        ours = suna(name, a, folder)
        if skin is None:
            looks = SCENES[name]["looks"]
            steps_of = [looks*round(SCENES[name]["window"]/looks/float(next(r for r in ours
                if float(r["level"]) == g)["step[s]"])) for g in LEVELS]
            skin = fastest(name, folder, steps_of[2])
        turns.append((ours, liggghts(name, folder, steps_of, skin)))
    print(f"{name}: {len(rows)} spheres, LIGGGHTS with a skin of {skin:g} m", file=out)
    for quantity in SCENES[name]["of"].split(","):
        both = [[errors(name, rows, quantity, start) for rows in turn] for turn in turns]
        print(f"  {quantity:10} level  Suna error  time        LIGGGHTS error  time        time for Suna's error  share", file=out)
        for k, level in enumerate(LEVELS):
            share = [own[k][2]/price(other, own[k][1]) for own, other in both]
            middle = [statistics.median(t[c][k][2] for t in both) for c in (0, 1)]
            print(f"  {'':10} {level:<6g} {100*both[0][0][k][1]:8.3g} %  {middle[0]:.3g} s  {'':4} {100*both[0][1][k][1]:8.3g} %  {'':4} {middle[1]:.3g} s"
                  f"  {'':8} {middle[0]/statistics.median(share):.3g} s  {'':8} {statistics.median(share):.2f} ({min(share):.2f} to {max(share):.2f})", file=out)
    out.flush()
    shutil.copy(folder/"liggghts.csv", HERE.parent/f"stored/peers/{name}.liggghts.csv")
    shutil.copy(folder/"suna/cost.csv", HERE.parent/f"stored/peers/{name}.suna.csv")


def main():
    p = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    p.add_argument("scene", nargs="*", default=list(SCENES))
    p.add_argument("--turns", type=int, default=2)
    p.add_argument("--dem", default=HERE.parents[3]/"dem/build/dem", type=pathlib.Path)
    p.add_argument("--bed", default=HERE.parents[3]/"dem/build/bed", type=pathlib.Path)
    a = p.parse_args()
    (HERE.parent/"stored/peers").mkdir(parents=True, exist_ok=True)
    commit = subprocess.run(["git", "-C", HERE, "rev-parse", "--short", "HEAD"],
                            capture_output=True, text=True).stdout.strip()
    print(f"compare.py {' '.join(a.scene)} --turns {a.turns}, {datetime.date.today():%-d %B %Y}, one core of a busy machine, commit {commit}", flush=True)
    for name in a.scene:
        if name not in SCENES:
            sys.exit(f"compare: no scene {name}; there are {', '.join(SCENES)}")
        with tempfile.TemporaryDirectory() as folder:
            compare(name, a, pathlib.Path(folder), sys.stdout)


if __name__ == "__main__":
    main()
