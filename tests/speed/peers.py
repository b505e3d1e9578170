"""peers.py -- the beds of scenes.py in LIGGGHTS, LAMMPS and YADE: their input, their runs, their
output.

A peer has: program, package (Debian's), laws {law of a scene: its own}, tries(scene) (settings of
its search to choose the fastest of), set_up(folder, particles, scene), run(run) -> processor time
of the steps [s], most memory of the process [bytes], and after it energy(folder) -> kinetic energy
[J], end(folder) -> the final positions as rows of diameter, x, y, z, bonds(folder). README.md lists
where laws differ.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import json
import math
import os
import shutil

import scenes

DENSITY, YOUNG, POISSON, RESTITUTION, FRICTION = 2500.0, 5e6, 0.25, 0.9, 0.3    # of equal.dem
ROLLING = 0.1                                                                   # of rolling.dem
LOSS = -math.log(RESTITUTION)/math.hypot(math.log(RESTITUTION), math.pi)
# of bonded.dem
BOND = dict(normal=5e9, shear=2e9, radius=0.5e-3, stiffness=2500.0, ratio=0.4, reach=1.02)
SKINS = (0.02, 0.04, 0.08, 0.15, 0.25)                    # of the mean diameter

def young(scene):
    return scene.get("young", YOUNG)


Run = collections.namedtuple("Run", "bed exe folder scene setting steps")


class Lammps:
    """LAMMPS with its fastest granular law, gran/hertz/history."""
    program, package = "lmp", "lammps"
    laws = {"equal": "gran/hertz/history", "sizes": "gran/hertz/history",
            "ratio": "gran/hertz/history"}
    grids, digits = ("bin", "multi"), "float %.12g"

    def tries(self, scene):
        """One grid of cells, or for different sizes also one for each class of size."""
        return [(skin, style) for style in (self.grids if "classes" in scene else ("bin",))
                for skin in SKINS]

    def set_up(self, folder, particles, scene):
        """The data file."""
        top = max(float(p[4]) + 2.0*float(p[1]) for p in particles) + 0.01
        with open(os.path.join(folder, "data.txt"), "w") as out:
            out.write(f"spheres\n\n{len(particles)} atoms\n1 atom types\n\n0 {scene['copies']*scene['width']!r} xlo xhi\n"
                      f"0 {scene['width']!r} ylo yhi\n-0.001 {top} zlo zhi\n\nAtoms\n\n")
            out.writelines(f"{int(p[0]) + 1} 1 {p[1]} {DENSITY} {p[2]} {p[3]} {p[4]}\n"
                           for p in particles)
            out.write("\nVelocities\n\n")
            out.writelines(f"{int(p[0]) + 1} {' '.join(p[5:11])}\n" for p in particles)

    def head(self):
        return ["atom_style sphere", "comm_modify vel yes"]

    def search(self, r):
        skin, style = r.setting
        lines = [f"neighbor {skin*r.scene['mean']} {style}",
                 "neigh_modify delay 0 one 20000 page 2000000"]
        if style == "multi":
            ends = " ".join(f"{e}" for e in (*r.scene["classes"], 4.04e-3))
            lines += [f"neigh_modify collection/interval {len(r.scene['classes']) + 1} {ends}",
                      "comm_modify mode multi vel yes"]
        return lines

    def law(self, scene):
        """The same springs; its dashpot is another law, set to the coefficient of Suna's at 1/600
        of a diameter of 1 mm."""
        modulus, shear = young(scene)/(2.0*(1.0 - POISSON**2)), young(scene)/(4.0*(2.0 -
            POISSON)*(1.0 + POISSON))
        mass, radius = DENSITY*math.pi/6.0*1e-9/2.0, 0.25e-3
        area = math.sqrt(radius*1e-3/600.0)
        damping = 2.0*math.sqrt(5.0/6.0)*LOSS*math.sqrt(2.0*modulus*area*mass)/(mass*area)
        numbers = f"{4.0/3.0*modulus} {8.0*shear} {damping} {damping} {FRICTION} 1"
        return [f"pair_style gran/hertz/history {numbers}", "pair_coeff * *",
                "fix pull all gravity 9.81 vector 0 0 -1",
                f"fix floor all wall/gran hertz/history {numbers} zplane 0.0 NULL"]

    def write_input(self, r, steps):
        lines = ["units si", "atom_modify map array", "boundary p p f", "newton off"]
        lines += self.head() + ["read_data data.txt"] + self.search(r) + self.law(r.scene)
        lines += [f"timestep {r.scene['step']}", "fix go all nve/sphere",
                  "compute turn all erotate/sphere",
                  "thermo_style custom step ke c_turn", f"thermo {max(steps, 1)}",
                  "thermo_modify norm no lost ignore", f"run {steps}",
                  f"write_dump all custom end.txt id diameter x y z modify format {self.digits}"]
        with open(os.path.join(r.folder, "in.txt"), "w") as out:
            out.write("\n".join(lines) + "\n")

    def run(self, r):
        """The time of the process less a run without steps, which reads and makes lists."""
        self.write_input(r, 0)
        rest, _ = scenes.spent(r.bed, [r.exe, "-in", "in.txt"], r.folder, "log.rest")
        self.write_input(r, r.steps)
        whole, most = scenes.spent(r.bed, [r.exe, "-in", "in.txt"], r.folder, "log.run")
        return whole - rest, most

    def empty(self, r):
        """Memory of a process without particles."""
        with open(os.path.join(r.folder, "in.txt"), "w") as out:
            out.write("units si\n")
        return scenes.spent(r.bed, [r.exe, "-in", "in.txt"], r.folder, "log.empty")[1]

    def energy(self, folder):
        """Kinetic energy [J] of its last line of numbers, translation and rotation."""
        energy = math.nan
        with open(os.path.join(folder, "log.run")) as log:
            for line in log:
                words = line.split()
                if len(words) in (3, 4) and words[0].isdigit():
                    energy = float(words[1]) + float(words[2])
        return energy

    def end(self, folder):
        with open(os.path.join(folder, "end.txt")) as text:
            rows = [line.split() for line in text]
        return [[float(word) for word in row[1:5]] for row in rows if len(row) == 5
                and row[0].isdigit()]

    def bonds(self, _):
        return 0


class LammpsGranular(Lammps):
    """LAMMPS with the law of Suna, dashpot included, pair_style granular; slower."""
    laws = {"equal": "granular", "sizes": "granular", "ratio": "granular"}

    def restitution(self):
        """Restitution at which its fit to Tsuji's damping (0.053 for 0.9, exact 0.075) gives the
        coefficient of Suna (bisection)."""
        fit = (1.2728, -4.2783, 11.087, -22.348, 27.467, -18.022, 4.8218)
        exact, low, high = 2.0*math.sqrt(1.25)*LOSS, 0.0, 1.0
        for _ in range(60):
            e = 0.5*(low + high)
            low, high = (e, high) if sum(c*e**k for k, c in enumerate(fit)) > exact else (low, e)
        return low

    def law(self, scene):
        shear = 2.0*young(scene)/((2.0 - POISSON)*(1.0 + POISSON))                # 8 G*
        words = "hertz/material {} {} {} tangential mindlin {} 1.0 {} damping tsuji"
        numbers = (self.restitution(), POISSON, shear, FRICTION)
        # its E* with a wall is E/(2 - 2 nu); so E is less there
        return ["pair_style granular", "pair_coeff * * " + words.format(young(scene), *numbers),
                "fix pull all gravity 9.81 vector 0 0 -1",
                "fix floor all wall/gran granular " + words.format(young(scene)/(1.0 + POISSON),
                    *numbers) + " zplane 0.0 NULL"]


class Liggghts(Lammps):
    """One grid only: with `neighbor ... multi` LIGGGHTS 3.8.0 takes granular styles, lists no pair
    and lets spheres pass each other."""
    program = package = "liggghts"
    laws = {"equal": "hertz", "sizes": "hertz", "ratio": "hertz", "hysteresis": "hooke/hysteresis",
            "rolling": "hertz", "hopper": "hertz"}
    grids, digits = ("bin",), '"%d %.12g %.12g %.12g %.12g"'

    def head(self):
        return ["atom_style granular", "communicate single vel yes"]

    def law(self, scene):
        model = f"model {self.laws[scene['law']]} tangential history"
        lines = [f"fix m1 all property/global youngsModulus peratomtype {young(scene)}",
                 f"fix m2 all property/global poissonsRatio peratomtype {POISSON}",
                 f"fix m3 all property/global coefficientRestitution peratomtypepair 1 {RESTITUTION}",
                 f"fix m4 all property/global coefficientFriction peratomtypepair 1 {FRICTION}"]
        options, mesh = "", []
        if scene["law"] == "rolling":
            model += " rolling_friction epsd2"
            lines += [f"fix m5 all property/global coefficientRollingFriction peratomtypepair 1 {ROLLING}"]
        if scene["law"] == "hopper":
            mesh = [f"fix cone all mesh/surface file {scenes.write_hopper(os.path.join(scenes.BEDS, 'hopper.stl'))} type 1",
                    f"fix hopper all wall/gran {model} mesh n_meshes 1 meshes cone"]
        if scene["law"] == "hysteresis":
            options = " tangential_damping off"
            lines += ["fix m5 all property/global characteristicVelocity scalar 1",
                      "fix m6 all property/global coefficientMaxElasticStiffness peratomtypepair 1 2",
                      "fix m7 all property/global coefficientAdhesionStiffness peratomtypepair 1 0.5",
                      "fix m8 all property/global coefficientPlasticityDepth peratomtypepair 1 0.05"]
        return lines + [f"pair_style gran {model}{options}", "pair_coeff * *",
                        "fix pull all gravity 9.81 vector 0 0 -1",
                        f"fix floor all wall/gran {model} primitive type 1 zplane 0.0{options}"] + mesh


class Yade:
    """YADE on one thread; timed within yade_bed.py, as reading twenty thousand spheres takes longer
    than some runs."""
    program = package = "yade"
    laws = {"equal": "MindlinPhys_Mindlin", "sizes": "MindlinPhys_Mindlin",
            "bonded": "CohFrictPhys_CohesionMoment"}

    def tries(self, scene):
        """verletDist, by which each bound is wider, half a skin; 0.25 d is near the default, half
        the smallest radius."""
        return [(skin, "bounds") for skin in (0.08, 0.2, 0.5)]

    def set_up(self, folder, particles, scene):
        with open(os.path.join(folder, "data.txt"), "w") as out:
            out.writelines(" ".join(p) + "\n" for p in particles)
        shutil.copy(os.path.join(scenes.HERE, "yade_bed.py"), folder)

    def job(self, r, steps, particles):
        job = dict(particles=particles, steps=steps, step=r.scene["step"],
                   x=r.scene["copies"]*r.scene["width"], y=r.scene["width"],
                   verlet=0.5*r.setting[0]*r.scene["mean"], density=DENSITY, young=young(r.scene),
                   poisson=POISSON, friction=FRICTION,
                   damping=math.sqrt(5.0/6.0)*LOSS)
        if r.scene["law"] == "bonded":
            area = math.pi*BOND["radius"]**2
            polar = 0.5*area*BOND["radius"]**2
            job.update(young=BOND["stiffness"]/BOND["radius"], ratio=BOND["ratio"],
                       bond=dict(kn=BOND["normal"]*area, ks=BOND["shear"]*area,
                                 kr=0.5*BOND["normal"]*polar, ktw=BOND["shear"]*polar,
                                 reach=BOND["reach"]))
        with open(os.path.join(r.folder, "job.json"), "w") as out:
            json.dump(job, out)

    def done(self, folder):
        with open(os.path.join(folder, "log.run")) as text:
            for line in text:
                if line.startswith("done "):
                    return [float(word) for word in line.split()[1:]]
        raise SystemExit(f"speed: yade did not finish; see {folder}/log.run")

    def call(self, r, log):
        return scenes.spent(r.bed, [r.exe, "-j1", "-n", "-x", "yade_bed.py"], r.folder, log)

    def run(self, r):
        self.job(r, r.steps, True)
        most = self.call(r, "log.run")[1]
        return self.done(r.folder)[0], most

    def empty(self, r):
        self.job(r, 0, False)
        return self.call(r, "log.empty")[1]

    def energy(self, folder):
        return self.done(folder)[1]

    def bonds(self, folder):
        return int(self.done(folder)[2])

    def end(self, folder):
        with open(os.path.join(folder, "end.txt")) as text:
            return [[float(word) for word in line.split()[1:5]] for line in text]


PEERS = {"liggghts": Liggghts(), "lammps": Lammps(), "lammps-granular": LammpsGranular(),
         "yade": Yade()}
