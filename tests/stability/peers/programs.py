"""programs.py -- a scene (scene.py) for each code: its deck, its run, its frames.
README.md has the translation.

    PEERS[name].there() -> why it cannot run, or None
    PEERS[name].run(scene, folder) -> Run

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import shutil
import subprocess

from scene import AXES, Frame, Run, Seen, read_dump

HERE = os.path.dirname(os.path.abspath(__file__))
LIMIT = 900                                                  # s of a run


class Peer:
    program = package = ""

    def there(self):
        return None if shutil.which(self.program) else "there is no %s (apt-get install %s)" % (self.program, self.package)

    def spend(self, words, folder, limit=LIMIT):
        try:
            done = subprocess.run(words, cwd=folder, timeout=limit, stdin=subprocess.DEVNULL,
                                  capture_output=True, text=True, errors="replace")
            status, said = done.returncode, done.stdout + done.stderr
        except subprocess.TimeoutExpired:
            status, said = 124, "did not end within %g s" % limit
        with open(os.path.join(folder, "log.run"), "w") as log:
            log.write(said)
        return status, said

    def run(self, scene, folder):
        os.makedirs(folder, exist_ok=True)
        self.write(scene, folder)
        status, said = self.spend(self.words(scene), folder)
        return Run(status, said, self.read(scene, folder))

    def read(self, scene, folder):
        return read_dump(os.path.join(folder, "frames.dump"), scene.step)


def ids(numbers):
    return " ".join("%d" % (k + 1) for k in numbers)


class Lammps(Peer):
    """pair_style granular with hertz/material, tangential mindlin, damping tsuji: the law of Suna,
    up to the fit of restitution."""
    program, package = "lmp", "lammps"
    sphere, digits = "sphere", "float %.17g"

    def words(self, scene):
        return (["mpirun", "-np", str(scene.ranks)] if scene.ranks > 1 else []) + [self.program,
            "-in", "in.txt", "-log", "none"]

    def write(self, scene, folder):
        low, high = scene.domain()
        with open(os.path.join(folder, "data.txt"), "w") as out:
            out.write("grains\n\n%d atoms\n%d atom types\n\n" % (len(scene.grains), 2))
            out.writelines("%.17g %.17g %slo %shi\n" % (low[a], high[a], n, n)
                           for n, a in AXES.items())
            out.write("\nAtoms\n\n")
            out.writelines("%d 1 %.17g %.17g %.17g %.17g %.17g\n" %
                           (k + 1, g.diameter, g.density, *g.x) for k, g in enumerate(scene.grains))
            out.write("\nVelocities\n\n")
            out.writelines("%d %.17g %.17g %.17g %.17g %.17g %.17g\n" % (k + 1, *g.v, *g.w)
                           for k, g in enumerate(scene.grains))
        if scene.triangles:
            write_stl(os.path.join(folder, "surface.stl"), scene.triangles)
        for k, p in enumerate(scene.planes):
            if p.sway and self.program == "liggghts":
                write_stl(os.path.join(folder, "wall%d.stl" % k),
                          triangle(p, 0.9*min(h - l for l, h in zip(low, high))/2.0))
        with open(os.path.join(folder, "in.txt"), "w") as out:
            out.write("\n".join(self.deck(scene)) + "\n")

    def head(self, scene):
        return ["comm_modify vel yes"]

    def deck(self, scene):
        free = [k for k, g in enumerate(scene.grains) if not g.fixed]
        skin = 0.25*max(min(g.diameter for g in scene.grains), 0.0)
        lines = ["# %s; %d steps" % (self.program, scene.steps), "units si",
                 "atom_style %s" % self.sphere, "atom_modify map array",
                 "boundary " + " ".join("p" if a in scene.periodic else "f" for a in AXES),
                 "newton off"] + self.head(scene)
        lines += ["read_data data.txt", "neighbor %.9g bin" % skin,
            "neigh_modify delay 0 every 1 check yes one 20000 page 2000000%s" %
            scene.more.get("bins", "")] + self.law(scene)
        lines += ["group free id %s" % ids(free) if len(free) < len(scene.grains)
                  else "group free union all"] if free else []
        if any(scene.gravity) and free:
            g = math.hypot(*scene.gravity)
            lines.append("fix pull free gravity %.17g vector %.17g %.17g %.17g" %
                         (g, *(c/g for c in scene.gravity)))
        for k, plane in enumerate(scene.planes):
            lines += self.plane(scene, plane, "wall%d" % k)
        if scene.triangles or self.program == "liggghts" and any(p.sway for p in scene.planes):
            lines += self.surface(scene)
        if scene.viscous:
            lines.append("fix thick free viscous %.9g" % scene.viscous)
        lines += ["fix go free nve/sphere"] if free else []
        return lines + scene.more.get(self.program, []) + [
            "timestep %.17g" % scene.step,
            "dump rows all custom %d frames.dump id x y z vx vy vz omegax omegay omegaz fx fy fz" %
            scene.looks,
            "dump_modify rows sort id format %s" % self.digits,
            "thermo %d" % max(1, scene.steps//10),
            "thermo_modify lost error norm no", "run %d" % scene.steps]

    def numbers(self, scene, wall=False, rigid=False):
        """E of `hertz/material`; at a wall E* is E/(2 - 2 nu) in this version, so E is reduced;
        rigid: twice as stiff as glass on glass."""
        shear = 2.0*scene.young/((2.0 - scene.poisson)*(1.0 + scene.poisson))                # 8 G*
        young = scene.young/(1.0 + scene.poisson) if wall else scene.young
        roll = ""
        if scene.rolling:
            roll = " rolling sds %.9g %.9g %.9g twisting marshall" % (scene.rolling["stiffness"],
                scene.rolling["viscous"], scene.rolling["share"])
        # the fit has a loss at restitution 1: no damping is set there
        free = scene.restitution == 1.0 and not scene.more.get("lammps fit")
        return "hertz/material %.17g %.17g %.17g tangential %s %.17g 1.0 %.17g%s damping %s" % (
            young*(2.0 if rigid else 1.0), 0.0 if free else scene.restitution, scene.poisson,
            scene.more.get("lammps tangential", "mindlin"), shear,
            scene.friction, roll, "velocity" if free else "tsuji")

    def law(self, scene):
        return ["pair_style granular", "pair_coeff * * " + self.numbers(scene)]

    def plane(self, scene, plane, name):
        law = "granular " + self.numbers(scene, True, plane.rigid)
        if not plane.sway:
            ends = "%.17g NULL" % plane.at if plane.side > 0 else "NULL %.17g" % plane.at
            return ["fix %s all wall/gran %s %splane %s" % (name, law, plane.axis, ends)]
        lines, moves = [], []
        for n, a in AXES.items():
            if plane.sway.amplitude[a]:
                lines.append("variable %s%s equal swiggle(0,%.17g,%.17g)" %
                             (name, n, plane.sway.amplitude[a], 1.0/plane.sway.frequency))
            moves.append("v_%s%s" % (name, n) if plane.sway.amplitude[a] else "NULL")
        at = [plane.at if n == plane.axis else 0.0 for n in AXES]
        normal = [plane.side if n == plane.axis else 0 for n in AXES]
        return lines + ["region %s plane %.17g %.17g %.17g %d %d %d side in units box move %s" %
                        (name, *at, *normal, " ".join(moves)),
                        "fix %s all wall/gran/region %s region %s" % (name, law, name)]

    def surface(self, scene):
        raise NotImplementedError("no walls of triangles in this version")


class Liggghts(Lammps):
    """model hertz tangential history: Suna's law with the same dashpot; hooke/hysteresis for
    hysteresis."""
    program = package = "liggghts"
    sphere, digits = "granular", '"%d' + 12*" %.17g" + '"'

    def head(self, scene):
        return ["communicate single vel yes"] + (["hard_particles yes"] if scene.young > 1e9
            or any(p.rigid for p in scene.planes) else [])

    def model(self, scene):
        words = "model %s tangential history" % ("hooke/hysteresis" if scene.law == "hysteresis"
            else "hertz")
        return words + (" rolling_friction epsd" if scene.rolling else "")

    def law(self, scene):
        lines = ["fix m1 all property/global youngsModulus peratomtype %.17g 1e30" % scene.young,
                 "fix m2 all property/global poissonsRatio peratomtype %.17g %.17g" %
                 (scene.poisson, scene.poisson)]
        for name, word, value in (("m3", "coefficientRestitution", scene.restitution),
                                  ("m4", "coefficientFriction", scene.friction)):
            lines.append("fix %s all property/global %s peratomtypepair 2 %s" %
                         (name, word, " ".join(4*["%.17g" % value])))
        if scene.rolling:
            for n, word, value in (("m5", "coefficientRollingFriction", scene.rolling["share"]),
                                   ("m6", "coefficientRollingViscousDamping", 0.3)):
                lines.append("fix %s all property/global %s peratomtypepair 2 %s" %
                             (n, word, " ".join(4*["%.9g" % value])))
        if scene.law == "hysteresis":
            lines.append("fix m7 all property/global characteristicVelocity scalar %.17g" %
                         self.speed_for(scene))
            for n, word in enumerate(("coefficientMaxElasticStiffness",
                    "coefficientAdhesionStiffness", "coefficientPlasticityDepth")):
                value = scene.spring[("unloading", "adhesion", "depth")[n]]
                lines.append("fix n%d all property/global %s peratomtypepair 2 %s" %
                             (n, word, " ".join(4*["%.17g" % value])))
        return lines + ["pair_style gran %s" % self.model(scene), "pair_coeff * *"]

    def speed_for(self, scene):
        """Characteristic velocity at which k is scene.spring["stiffness"], for a sphere on a plane
        or a pair, by scene.planes."""
        radius, mass, modulus = 0.5*scene.grains[0].diameter, scene.mass(0), scene.young/(2.0*(1.0 -
            scene.poisson**2))
        if not scene.planes:
            radius, mass = 0.5*radius, 0.5*mass
        base = 16.0/15.0*math.sqrt(radius)*modulus
        return math.sqrt((scene.spring["stiffness"]/base)**5*base/mass)

    def plane(self, scene, plane, name):
        kind = 2 if plane.rigid else 1
        if not plane.sway:
            return ["fix %s all wall/gran %s primitive type %d %splane %.17g" %
                    (name, self.model(scene), kind, plane.axis, plane.at)]
        return []                                            # only meshes oscillate: surface()

    def surface(self, scene):
        """All meshes: triangles and moving planes. One wall/gran has them all, as a second one is
        not allowed."""
        lines = ["fix surface all mesh/surface file surface.stl type 1%s" %
                 scene.more.get("liggghts mesh", "")] if scene.triangles else []
        names, moves = ["surface"] if scene.triangles else [], []
        for k, plane in enumerate(scene.planes):
            if plane.sway:
                names.append("mesh%d" % k)
                lines.append("fix mesh%d all mesh/surface file wall%d.stl type %d" %
                             (k, k, 2 if plane.rigid else 1))
                moves.append("fix move%d all move/mesh mesh mesh%d wiggle amplitude %.17g %.17g %.17g period %.17g" % (
                    k, k, *plane.sway.amplitude, 1.0/plane.sway.frequency))
        return lines + ["fix skin all wall/gran %s mesh n_meshes %d meshes %s" %
                        (self.model(scene), len(names), " ".join(names))] + moves


class Yade(Peer):
    """MindlinPhys_Mindlin with en, es; Luding's law for hysteresis; no numerical damping unless the
    scene has it. One process each."""
    program = package = "yade"

    def words(self, scene):
        return [self.program, "-j1", "-n", "-x", os.path.join(HERE, "yade_scene.py")]

    def write(self, scene, folder):
        job = {k: getattr(scene, k) for k in ("step", "steps", "looks", "young", "poisson",
                                              "restitution", "friction", "law", "spring", "gravity",
                                              "periodic", "rolling", "triangles")}
        job.update(box=scene.domain(), grains=[g._asdict() for g in scene.grains],
                   planes=[p._asdict() for p in scene.planes], more=scene.more.get("yade", {}),
                   viscous=bool(scene.viscous))
        for body in job["planes"]:
            body["sway"] = body["sway"] and body["sway"]._asdict()
        with open(os.path.join(folder, "job.json"), "w") as out:
            json.dump(job, out)

    def run(self, scene, folder):
        run = Peer.run(self, scene, folder)
        # the status of batch mode does not tell whether the script succeeded: it must have printed
        # it
        run.status = 0 if "\ndone" in run.said else run.status or 1
        return run


class Suna(Peer):
    """The scene for Suna, with the same step; frames from its snapshots."""
    program = "dem"

    def there(self):
        return None if os.access(os.environ.get("DEM", ""),
                                 os.X_OK) else "DEM names no program (./run sets it)"

    def words(self, scene):
        return (["mpirun", "-np", str(scene.ranks)] if scene.ranks > 1
                else []) + [os.environ["DEM"], "run", "scene.dem"]

    def write(self, scene, folder):
        self.order = sorted(range(len(scene.grains)), key=lambda k: scene.grains[k][:2] +
                            (scene.grains[k].fixed,))
        groups = {}
        for k in self.order:
            g = scene.grains[k]
            groups.setdefault((g.diameter, g.density, g.fixed), []).append(g)
        densities = sorted({g.density for g in scene.grains})
        more = scene.more.get("suna", {})
        lines = ["materials { %s rigid { density 1; youngsModulus 1e30; poissonsRatio 0.3; } }" %
                 " ".join(
            "m%d { density %.17g; youngsModulus %.17g; poissonsRatio %.17g; }" %
            (n, d, scene.young, scene.poisson) for n, d in enumerate(densities))]
        lines += ["effects { %s %s }" % (self.law(scene), more.get("effects", "")),
                  self.planes(scene)]
        low, high = scene.domain()
        if scene.box:
            lines.append("domain { min (%.17g %.17g %.17g); max (%.17g %.17g %.17g); %s }" % (
                *low, *high, "periodic (%s);" % " ".join(scene.periodic) if scene.periodic else ""))
        lines.append("insert {")
        for n, ((diameter, density, fixed), members) in enumerate(groups.items()):
            with open(os.path.join(folder, "places%d" % n), "w") as out:
                out.write("x y z vx vy vz wx wy wz\n" + "".join(" ".join("%.17g" % c
                    for c in g.x + g.v + g.w) + "\n" for g in members))
            lines.append('g%d { type table; file "places%d"; material m%d; diameter %.17g; %s }' % (
                n, n, densities.index(density), diameter, "frozen yes;" if fixed else ""))
        lines += ["}", more.get("top", ""), "time { end %.17g; step %.17g; %s }" %
                  (scene.end, scene.step, more.get("time", "")),
                  'write { interval %.17g; folder "out"; vtk no; snapshot all; profile no; }' %
                  (scene.looks*scene.step)]
        if scene.triangles:
            write_stl(os.path.join(folder, "surface.stl"), scene.triangles)
        with open(os.path.join(folder, "scene.dem"), "w") as out:
            out.write("\n".join(lines) + "\n")

    def law(self, scene):
        words = "gravity { acceleration (%.17g %.17g %.17g); }" % tuple(scene.gravity) if any(scene.gravity) else ""
        if scene.law == "hysteresis":
            return words + " hookeHysteresis { stiffness %.17g; unloading %.17g; adhesion %.17g; plasticDepth %.17g; } linear { friction %.17g; ratio 1; }" % (
                *(scene.spring[k] for k in ("stiffness", "unloading", "adhesion", "depth")),
                scene.friction)
        words += " hertz { impactSpeed %.9g; } dry { restitution %.17g; } %s { friction %.17g; }" % (
            scene.impact, scene.restitution, scene.more.get("suna law", "mindlin"), scene.friction)
        return words + (" rollingSpring { friction %.9g; damping 0.3; } twistingSpring { friction %.9g; damping 0.3; }" % (
            scene.rolling["share"], scene.friction) if scene.rolling else "")

    def planes(self, scene):
        lines = []
        for k, p in enumerate(scene.planes):
            at = tuple(p.at if n == p.axis else 0.0 for n in AXES)
            normal = tuple(p.side if n == p.axis else 0 for n in AXES)
            sway = "motion { type oscillation; amplitude (%.17g %.17g %.17g); frequency %.17g; }" % (*p.sway.amplitude, p.sway.frequency) if p.sway else ""
            lines.append("p%d { type plane; %s point (%.17g %.17g %.17g); normal (%d %d %d); %s }" %
                         (k, "material %s;" % ("rigid" if p.rigid else "m0"), *at, *normal, sway))
        if scene.triangles:
            lines.append('surface { type stl; material m0; file "surface.stl"; }')
        return "walls { %s }" % "\n".join(lines) if lines else ""

    def read(self, scene, folder):
        from results import Run as Own                        # the readers of ../results.py
        own, frames = object.__new__(Own), []
        own.folder = folder
        for s in own.snapshots():
            frames.append(Frame(s.time, {self.order[k]: Seen(p.x, p.v, p.w, tuple(
                c + p.mass*g for c, g in zip(p.columns.get("force", (0.0, 0.0, 0.0)),
                                             scene.gravity))) for k, p in s.particles.items()}))
        return frames


def triangle(plane, half):
    """One large triangle of a plane around the projection of the origin: no seam there."""
    corners = []
    for u, v in ((-half, -half), (half, -half), (0.0, half)):
        x = [u, v]
        x.insert(AXES[plane.axis], plane.at)
        corners.append(x)
    return [corners]


def write_stl(path, triangles):
    with open(path, "w") as out:
        out.write("solid surface\n")
        for t in triangles:
            out.write("facet normal 0 0 1\nouter loop\n" +
                "".join("vertex %.17g %.17g %.17g\n" % tuple(x) for x in t) + "endloop\nendfacet\n")
        out.write("endsolid surface\n")


PEERS = {"liggghts": Liggghts(), "lammps": Lammps(), "yade": Yade(), "suna": Suna()}
