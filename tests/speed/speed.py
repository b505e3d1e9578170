#!/usr/bin/env python3
"""speed.py -- million particle-steps per second of processor time, of Suna and of another code on the same bed.

    speed.py SCENE ... --dem DEM --bed BED [--against liggghts|lammps|none] [--runs 3] [--steps N]

DEM and BED are the program dem and the one made of bed.c. Both codes start from the same text of particles, take the same step and
have the same laws (README.md tells what differs), on one core. They take turns; the medians are told, and the least and the largest
ratio of a turn. The other code runs with the best of several skins, found first. Its time is that of the process less that of a run
of no steps, which reads and lists; Suna's counts its first lists.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import math
import os
import shutil
import statistics
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
BEDS = os.path.join(HERE, "beds")

DENSITY, YOUNG, POISSON, RESTITUTION, FRICTION = 2500.0, 5e6, 0.25, 0.9, 0.3    # of equal.dem

# scene: bed settled once, physics, width along x and y, copies along x, random speed added, step, steps, mean diameter;
# where it is not that of the bed's file: number of spheres and height of the box that they fall from
SCENES = {
    "settled20k": dict(bed="Equal", physics="equal", width=0.025, copies=1, speed=0.0, step=2e-6, steps=2000, mean=1e-3),
    "settled100k": dict(bed="Equal", physics="equal", width=0.025, copies=5, speed=0.0, step=2e-6, steps=400, mean=1e-3),
    "settled300k": dict(bed="Equal", physics="equal", width=0.025, copies=15, speed=0.0, step=2e-6, steps=200, mean=1e-3),
    "agitated20k": dict(bed="Equal", physics="equal", width=0.025, copies=1, speed=0.7, step=2e-6, steps=2000, mean=1e-3),
    "sizes50k": dict(bed="Sizes", physics="sizes", width=0.06, copies=1, speed=0.0, step=2e-6, steps=600, mean=1.6e-3),
    "small": dict(bed="Equal", physics="equal", width=0.01, copies=1, speed=0.5, step=2e-6, steps=500, mean=1e-3, spheres=500, height=0.006),
    "hysteresis20k": dict(bed="Hysteresis", physics="hysteresis", width=0.025, copies=1, speed=0.0, step=2e-6, steps=2000, mean=1e-3),
}
SKINS = (0.02, 0.04, 0.08, 0.15, 0.25)                    # of the mean diameter
PACKAGE = {"liggghts": ("liggghts", "liggghts"), "lammps": ("lmp", "lammps")}    # program, package of Debian


def spent(bed, command, folder, log):
    """Processor time [s] and most memory [bytes] of a command; ends the benchmark when it fails."""
    path = os.path.join(folder, log)
    with open(path, "w") as out:
        status = subprocess.run([bed, "spend"] + command, cwd=folder, stdout=out, stderr=subprocess.STDOUT).returncode
    if status:
        sys.exit(f"speed: {' '.join(command)} failed; see {path}")
    with open(path) as text:
        return [float(word) for word in text.read().splitlines()[-1].split()[1:]]


def box(scene):
    """Entries of the domain's sides."""
    return [("domain/x", f"(0 {scene['copies']*scene['width']!r})"), ("domain/y", f"(0 {scene['width']!r})")]


# ---- beds ------------------------------------------------------------------------------------------------------------

def settled(dem, bed, scene):
    """The snapshot of a bed at rest, made when it is not there yet."""
    folder = os.path.join(BEDS, f"{scene['physics']}{scene.get('spheres', '')}")
    snapshot = os.path.join(folder, "settled", "snapshot.dem")
    if not os.path.exists(os.path.join(folder, "done")):
        os.makedirs(folder, exist_ok=True)
        print(f"# settling {scene['physics']} (once)", flush=True)
        other = []
        if "spheres" in scene:
            for entry, value in box(scene) + [("insert/bed/count", str(scene["spheres"])),
                                              ("insert/bed/max", f"({scene['width']!r} {scene['width']!r} {scene['height']!r})")]:
                other += ["-set", entry, value]
        spent(bed, [dem, "run"] + other + [os.path.join(HERE, f"settle{scene['bed']}.dem")], folder, "log.settle")
        open(os.path.join(folder, "done"), "w").close()
    return snapshot


def state(dem, bed, name, scene):
    """The text of particles that a scene starts from, and the particles."""
    path = os.path.join(BEDS, name + ".txt")
    if not os.path.exists(path):
        snapshot = settled(dem, bed, scene)
        with open(path + ".part", "w") as out:
            subprocess.run([bed, "state", os.path.join(HERE, scene["physics"] + ".dem"), snapshot, str(scene["copies"]),
                            repr(scene["width"]), repr(scene["speed"])], stdout=out, check=True)
        os.rename(path + ".part", path)
    with open(path) as text:
        return path, [line.split() for line in text]


# ---- Suna ------------------------------------------------------------------------------------------------------------

def suna(bed, scene, path, steps):
    """Processor time, bytes, kinetic energy, contacts, rebuilds, prunes."""
    told = subprocess.run([bed, "run", os.path.join(HERE, scene["physics"] + ".dem"), path, repr(scene["step"]), str(steps)]
                          + [word for entry in box(scene) for word in entry], capture_output=True, text=True)
    if told.returncode:
        sys.exit(told.stderr)
    return [float(word) for word in told.stdout.split()]


# ---- the others ------------------------------------------------------------------------------------------------------

def write_data(path, particles, scene):
    """The data file that LIGGGHTS and LAMMPS read."""
    top = max(float(p[4]) + 2.0*float(p[1]) for p in particles) + 0.01
    with open(path, "w") as out:
        out.write(f"spheres\n\n{len(particles)} atoms\n1 atom types\n\n0 {scene['copies']*scene['width']!r} xlo xhi\n"
                  f"0 {scene['width']!r} ylo yhi\n-0.001 {top} zlo zhi\n\nAtoms\n\n")
        out.writelines(f"{int(p[0]) + 1} 1 {p[1]} {DENSITY} {p[2]} {p[3]} {p[4]}\n" for p in particles)
        out.write("\nVelocities\n\n")
        out.writelines(f"{int(p[0]) + 1} {' '.join(p[5:11])}\n" for p in particles)


def liggghts_laws(scene):
    model = "model hertz tangential history"
    lines = [f"fix m1 all property/global youngsModulus peratomtype {YOUNG}",
             f"fix m2 all property/global poissonsRatio peratomtype {POISSON}",
             f"fix m3 all property/global coefficientRestitution peratomtypepair 1 {RESTITUTION}",
             f"fix m4 all property/global coefficientFriction peratomtypepair 1 {FRICTION}"]
    if scene["physics"] == "hysteresis":
        model = "model hooke/hysteresis tangential history"
        lines += ["fix m5 all property/global characteristicVelocity scalar 1",
                  "fix m6 all property/global coefficientMaxElasticStiffness peratomtypepair 1 2",
                  "fix m7 all property/global coefficientAdhesionStiffness peratomtypepair 1 0.5",
                  "fix m8 all property/global coefficientPlasticityDepth peratomtypepair 1 0.05"]
    return lines + [f"pair_style gran {model}", "pair_coeff * *", "fix pull all gravity 9.81 vector 0 0 -1",
                    f"fix floor all wall/gran {model} primitive type 1 zplane 0.0"]


def lammps_laws(_):
    """gran/hertz/history: the same stiffnesses; its dashpot is another law, set to do what ours does at 1/600 of a diameter."""
    modulus, shear = YOUNG/(2.0*(1.0 - POISSON**2)), YOUNG/(4.0*(2.0 - POISSON)*(1.0 + POISSON))
    mass, radius = DENSITY*math.pi/6.0*1e-9/2.0, 0.25e-3
    beta = -math.log(RESTITUTION)/math.hypot(math.log(RESTITUTION), math.pi)
    area = math.sqrt(radius*1e-3/600.0)
    damping = 2.0*math.sqrt(5.0/6.0)*beta*math.sqrt(2.0*modulus*area*mass)/(mass*area)
    numbers = f"{4.0/3.0*modulus} {8.0*shear} {damping} {damping} {FRICTION} 1"
    return [f"pair_style gran/hertz/history {numbers}", "pair_coeff * *", "fix pull all gravity 9.81 vector 0 0 -1",
            f"fix floor all wall/gran hertz/history {numbers} zplane 0.0 NULL"]


def write_input(peer, folder, scene, skin, steps):
    granular = peer == "liggghts"
    lines = ["units si", f"atom_style {'granular' if granular else 'sphere'}", "atom_modify map array", "boundary p p f",
             "newton off", "communicate single vel yes" if granular else "comm_modify vel yes", "read_data data.txt",
             f"neighbor {skin*scene['mean']} bin", "neigh_modify delay 0"]
    lines += liggghts_laws(scene) if granular else lammps_laws(scene)
    lines += [f"timestep {scene['step']}", "fix go all nve/sphere", "compute turn all erotate/sphere",
              "thermo_style custom step ke c_turn" + ("" if granular else " nbuild"), f"thermo {max(steps, 1)}",
              "thermo_modify norm no" + (" lost ignore" if granular else ""), f"run {steps}"]
    with open(os.path.join(folder, "in.txt"), "w") as out:
        out.write("\n".join(lines) + "\n")


def peer_run(bed, peer, folder, scene, skin, steps):
    """Processor time and most memory of the whole process."""
    write_input(peer, folder, scene, skin, steps)
    return spent(bed, [shutil.which(PACKAGE[peer][0]), "-in", "in.txt"], folder, "log.run")


def peer_energy(folder):
    """Kinetic energy [J] of its last line of numbers, translation and rotation."""
    energy = math.nan
    with open(os.path.join(folder, "log.run")) as log:
        for line in log:
            words = line.split()
            if len(words) in (3, 4) and words[0].isdigit():
                energy = float(words[1]) + float(words[2])
    return energy


def best_skin(bed, peer, folder, scene, steps):
    none = peer_run(bed, peer, folder, scene, SKINS[0], 0)[0]
    time = {skin: peer_run(bed, peer, folder, scene, skin, steps)[0] - none for skin in SKINS}
    return min(time, key=time.get)


# ---- a scene ---------------------------------------------------------------------------------------------------------

def middle(values):
    return statistics.median(values)


def measure(a, name):
    scene = SCENES[name]
    path, particles = state(a.dem, a.bed, name, scene)
    n, steps = len(particles), a.steps or scene["steps"]
    work = 1e-6*n*steps
    ours, theirs, ratio, told, energy, skin = [], [], [], None, None, None

    folder = os.path.join(BEDS, a.against)
    other = a.against != "none" and not (a.against == "lammps" and scene["physics"] == "hysteresis")
    if other:
        os.makedirs(folder, exist_ok=True)
        write_data(os.path.join(folder, "data.txt"), particles, scene)
        skin = best_skin(a.bed, a.against, folder, scene, max(steps//3, 1))
    for _ in range(a.runs):
        told = suna(a.bed, scene, path, steps)
        ours.append(work/told[0])
        if other:
            rest, _ = peer_run(a.bed, a.against, folder, scene, skin, 0)
            whole, most = peer_run(a.bed, a.against, folder, scene, skin, steps)
            theirs.append(work/(whole - rest))
            ratio.append(ours[-1]/theirs[-1])
            energy = peer_energy(folder)
    line = f"{name} N={n} steps={steps} suna {middle(ours):.2f} Mps/s"
    if other:
        with open(os.path.join(folder, "in.txt"), "w") as out:
            out.write("units si\n")
        _, empty = spent(a.bed, [shutil.which(PACKAGE[a.against][0]), "-in", "in.txt"], folder, "log.run")
        line += (f" {a.against} {middle(theirs):.2f} Mps/s (skin {skin:g} d) ratio {middle(ratio):.2f}"
                 f" (min {min(ratio):.2f} max {max(ratio):.2f}) bytes/particle {told[1]/n:.0f} {(most - empty)/n:.0f}"
                 f" kinetic {told[2]:.4g} {energy:.4g} J")
    else:
        line += f" (min {min(ours):.2f} max {max(ours):.2f}) bytes/particle {told[1]/n:.0f} kinetic {told[2]:.4g} J"
    print(f"{line} contacts {told[3]/n:.2f} a particle, rebuilds {told[4]:.0f} prunes {told[5]:.0f}", flush=True)


def main():
    p = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    p.add_argument("--against", choices=["liggghts", "lammps", "none"], default="liggghts")
    p.add_argument("--runs", type=int, default=3)
    p.add_argument("--steps", type=int, default=0, help="0: those of the scene")
    p.add_argument("--dem", required=True)
    p.add_argument("--bed", required=True)
    p.add_argument("scene", nargs="+", choices=sorted(SCENES))
    a = p.parse_args()
    if a.against != "none" and not shutil.which(PACKAGE[a.against][0]):
        sys.exit(f"speed: there is no {PACKAGE[a.against][0]}; install it (apt-get install {PACKAGE[a.against][1]}), or say --against none")
    for name in a.scene:
        measure(a, name)


if __name__ == "__main__":
    main()
