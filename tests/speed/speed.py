#!/usr/bin/env python3
"""speed.py -- million particle-steps per second of processor time, of Suna and of another code on
the same bed.

    speed.py SCENE ... --dem DEM --bed BED [--against PEER] [--exe PATH] [--runs 3] [--steps N]
    speed.py all ...                    every scene against every peer that has its law; the lines are added to stored/speed.txt, too
    speed.py table                      what was stored last, as a table
    speed.py SCENE ... --compare        no clock: kinetic energy, contacts, overlap in both codes after the steps of small beds

DEM and BED are the program dem and the one made of bed.c. Both codes start from the same text of
particles, take the same step and have the same laws (README.md has what differs), on one
core. They take turns; the medians are printed, and the smallest and the largest ratio of a turn. The
other code runs with the fastest of several settings of its search, found first. Its time is that of
the process less that of a run of no steps, which reads and lists; Suna's begins after a first step.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import collections
import datetime
import os
import shutil
import statistics
import subprocess
import sys

from peers import PEERS, Run
from scenes import BEDS, FULL, HERE, SCENES, box, state, suna

STORED = os.path.join(HERE, "stored", "speed.txt")


# ---- arguments -----------------------------------------------------------------------------------

def arguments():
    p = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    p.add_argument("--against", choices=[*PEERS, "none"], default="")
    p.add_argument("--exe", help="another build of the peer's program")
    p.add_argument("--runs", type=int, default=3)
    p.add_argument("--steps", type=int, default=0,
                   help="0: those of the scene, a fifth of them with yade")
    p.add_argument("--compare", action="store_true")
    p.add_argument("--dem", required=True)
    p.add_argument("--bed", required=True)
    p.add_argument("scene", nargs="+", choices=sorted(SCENES) + ["all", "table"])
    a = p.parse_args()
    if a.exe and not a.against:
        sys.exit("speed: --exe names a peer's program; say which peer with --against")
    if a.exe and not os.access(a.exe, os.X_OK):
        sys.exit(f"speed: --exe {a.exe} is no program")
    if a.runs < 1 or a.steps < 0:
        sys.exit(f"speed: --runs {a.runs} and --steps {a.steps} are at least 1 and 0")
    return a


def program(a, name):
    """Path of a peer's program; ends the benchmark when there is none."""
    found = a.exe or shutil.which(PEERS[name].program)
    if not found:
        sys.exit(f"speed: there is no {PEERS[name].program}; install it (apt-get install {PEERS[name].package}), or say --against none")
    return os.path.abspath(found)


def default_peer(scene):
    """The first peer that has the law."""
    return next((name for name in PEERS if scene["law"] in PEERS[name].laws), "none")


# ---- a scene -------------------------------------------------------------------------------------

def measure_peer(a, name, peer, turn):
    """Data of a line, runs alternating with Suna: rates of both, memory, kinetic energy, the
    setting chosen."""
    scene, p = SCENES[name], PEERS[peer]
    path, particles = state(a.dem, a.bed, name, scene)
    folder = os.path.join(BEDS, f"{peer}-{name}")
    os.makedirs(folder, exist_ok=True)
    p.set_up(folder, particles, scene)
    steps = a.steps or (scene["steps"]//5 if peer == "yade" else scene["steps"])
    run = Run(a.bed, program(a, peer), folder, scene, None, steps)
    tries = p.tries(scene)
    times = [p.run(run._replace(setting=t, steps=max(steps//3, 1)))[0] for t in tries]
    run = run._replace(setting=tries[times.index(min(times))])
    ours, theirs, most = [], [], 0
    for _ in range(a.runs):
        ours.append(turn(path, steps))
        seconds, most = p.run(run)
        if seconds <= 0.0:
            sys.exit(f"speed: {steps} steps of {name} take {peer} no more time than reading; give more --steps")
        theirs.append(1e-6*len(particles)*steps/seconds)
    energy = p.energy(folder)
    return ours, theirs, (most - p.empty(run))/len(particles), energy, run.setting


def measure(a, name, peer):
    """The line of a scene."""
    scene = SCENES[name]
    path, particles = state(a.dem, a.bed, name, scene)
    n, result = len(particles), []

    def turn(path, steps):
        result[:] = suna(a.bed, scene, path, steps)
        return 1e-6*n*steps/result[0]

    steps = a.steps or (scene["steps"]//5 if peer == "yade" else scene["steps"])
    line = f"{name} N={n} steps={steps} suna "
    if peer == "none":
        ours = [turn(path, steps) for _ in range(a.runs)]
        line += (f"{statistics.median(ours):.2f} Mps/s (min {min(ours):.2f} max {max(ours):.2f}) bytes/particle {result[1]/n:.0f}"
                 f" kinetic {result[2]:.4g} J")
    else:
        ours, theirs, most, energy, setting = measure_peer(a, name, peer, turn)
        ratio = [u/v for u, v in zip(ours, theirs)]
        label = os.path.basename(a.exe) if a.exe else peer
        line += (f"{statistics.median(ours):.2f} Mps/s {label} {statistics.median(theirs):.2f} Mps/s (skin {setting[0]:g} d {setting[1]})"
                 f" ratio {statistics.median(ratio):.2f} (min {min(ratio):.2f} max {max(ratio):.2f})"
                 f" bytes/particle {result[1]/n:.0f} {most:.0f} kinetic {result[2]:.4g} {energy:.4g} J")
    bonds = f", bonds {result[6]/n:.2f}" if result[6] else ""
    return f"{line} contacts {result[3]/n:.2f}{bonds} a particle, rebuilds {result[4]:.0f} prunes {result[5]:.0f}"


# ---- the same physics ----------------------------------------------------------------------------

def overlaps(rows, scene):
    """Contacts between particles and with the floor, and their mean overlap [m]; rows: diameter, x,
    y, z."""
    widths = (scene["copies"]*scene["width"], scene["width"])
    found = [0.5*r[0] - r[3] for r in rows if r[3] < 0.5*r[0]]
    cells, size = collections.defaultdict(list), max(r[0] for r in rows)
    many = [max(int(w/size), 1) for w in widths]
    for k, r in enumerate(rows):
        cells[tuple(int(r[1 + i]/widths[i]*many[i]) % many[i] for i in (0, 1)) +
              (int(r[3]//size),)].append(k)
    for (i, j, k), here in cells.items():
        near = {((i + u) % many[0], (j + v) % many[1], k + w) for u in (-1, 0, 1)
                for v in (-1, 0, 1) for w in (-1, 0, 1)}
        for other in [m for cell in near for m in cells.get(cell, ())]:
            for m in here:
                if m < other:
                    apart = [rows[m][c] - rows[other][c] for c in (1, 2, 3)]
                    apart[:2] = [d - w*round(d/w) for d, w in zip(apart, widths)]
                    depth = 0.5*(rows[m][0] + rows[other][0]) - sum(d*d for d in apart)**0.5
                    found += [depth] if depth > 0.0 else []
    return len(found), sum(found)/max(len(found), 1)


def compare(a, name, peer):
    """Kinetic energy, contacts, mean overlap, bonds: each for Suna and the peer."""
    scene, p = SCENES[name], PEERS[peer]
    path, particles = state(a.dem, a.bed, name, scene)
    folder = os.path.join(BEDS, f"{peer}-{name}")
    os.makedirs(folder, exist_ok=True)
    p.set_up(folder, particles, scene)
    steps, last = a.steps or scene["steps"], os.path.join(folder, "suna.txt")
    result = suna(a.bed, scene, path, steps, end=last)
    p.run(Run(a.bed, program(a, peer), folder, scene, p.tries(scene)[len(p.tries(scene))//2 - 1],
              steps))
    with open(last) as text:
        ours = overlaps([[float(word) for word in line.split()[1:5]] for line in text], scene)
    theirs = overlaps(p.end(folder), scene)
    return (f"{name} N={len(particles)} steps={steps} {peer} kinetic {result[2]:.5g} {p.energy(folder):.5g} J contacts {ours[0]} {theirs[0]}"
            f" overlap {1e6*ours[1]:.4g} {1e6*theirs[1]:.4g} um bonds {result[6]:.0f} {p.bonds(folder)}")


# ---- main program --------------------------------------------------------------------------------

def said(command):
    out = subprocess.run(command, capture_output=True, text=True, cwd=HERE).stdout.splitlines()
    return out[0].strip() if out else ""


def heading():
    """Date, commit, machine, programs of the lines that follow."""
    model = "unknown processor"
    with open("/proc/cpuinfo") as text:
        for line in text:
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
    commit = said(["git", "describe", "--always", "--dirty=+"]) or "no commit"
    versions = [f"{p.package} {said(['dpkg-query', '-W', '-f', '${Version}', p.package])}"
                for p in (PEERS["liggghts"], PEERS["lammps"], PEERS["yade"])]
    return (f"# {datetime.date.today()} commit {commit}; {os.cpu_count()} cores of {model}, load {os.getloadavg()[0]:.1f} before;"
            f" {said(['cc', '--version'])}; {', '.join(versions)}")


def store(line):
    print(line, flush=True)
    os.makedirs(os.path.dirname(STORED), exist_ok=True)
    with open(STORED, "a") as out:
        out.write(line + "\n")


def everything(a):
    store(heading())
    for name in FULL:
        for peer in [p for p in PEERS if a.against in ("", p)]:
            # half a minute before YADE's first step with 50 000 spheres is enough
            if SCENES[name]["law"] in PEERS[peer].laws and not (peer == "yade"
                    and name in ("settled100k", "settled300k")):
                store(measure(a, name, peer))


def table():
    """The lines of the last heading, as markdown."""
    with open(STORED) as text:
        last = text.read().split("# ")[-1].splitlines()
    print(f"{last[0]}\n\n| scene | Suna | other | ratio (least, largest) | bytes a particle |\n|---|---|---|---|---|")
    for line in last[1:]:
        words = line.split()
        at = words.index("ratio")
        search = " ".join(words[words.index("(skin") + 1:at]).rstrip(")")
        memory = words.index("bytes/particle")
        print(f"| `{words[0]}` | {words[4]} | {words[6]} {words[7]} ({search}) | {words[at + 1]} ({words[at + 3]}, {words[at + 5].rstrip(')')})"
              f" | {words[memory + 1]}; {words[memory + 2]} |")


def main():
    a = arguments()
    if a.scene == ["table"]:
        return table()
    if a.scene == ["all"]:
        return everything(a)
    for name in a.scene:
        if name in ("all", "table"):
            sys.exit(f"speed: {name} stands alone")
        peer = a.against or default_peer(SCENES[name])
        if peer != "none" and SCENES[name]["law"] not in PEERS[peer].laws:
            sys.exit(f"speed: {peer} has no law like that of {name}; {default_peer(SCENES[name])} has")
        print(compare(a, name, peer) if a.compare else measure(a, name, peer), flush=True)
    return None


if __name__ == "__main__":
    main()
