"""liggghts_fixes.py -- the fixes of LIGGGHTS: materials, walls and meshes, insertion, forces; which others
have no effect on the answer, and which Suna lacks.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

import numpy

from .liggghts_contact import fits, read_model
from .liggghts_insertion import Distribution, Insertion, Template
from .liggghts_mesh import BadMesh, read_triangles, rotated

HARMLESS = {
    "check/timestep/gran": "too long a step is refused",
    "print": "output",
    "ave/time": "output: averages",
    "ave/spatial": "output: averages",
    "ave/histo": "output",
    "ave/euler": "output: averages",
    "ave/atom": "output",
    "ave/euler/region": "output: averages",
    "balance": "subdomains are balanced by themselves",
    "property/atom": "read by no law that was translated",
    "property/atom/lammps": "read by no law",
    "massflow/mesh": "output: averages, flows.csv",
    "massflow/mesh/face": "output: averages, flows.csv",
    "massflow/mesh/sieve": "output",
    "couple/cfd": "a coupled run of Suna needs no such line",
    "couple/cfd/force": "a coupled run of Suna needs no such line; alone, no fluid acts",
    "couple/cfd/force/implicit": "a coupled run of Suna needs no such line; alone, no fluid acts",
    "couple/cfd/force/accumulator": "a coupled run of Suna needs no such line; alone, no fluid acts",
    "store/state": "output",
    "region/variable": "output",
    "executionTiming": "output",
    "contacthistory": "",
    "neighlist/mesh": "",
     "diam/max": ""}
LACKING = (("heat/", "heat is not translated; add conduction to the scene"),
           ("chem/", "Suna has no chemistry"), ("multisphere", "Suna has spheres only"),
           ("particletemplate/", "Suna has spheres only"),
           ("nve/", "Suna has spheres, integrated by themselves"),
           ("sph/", "Suna has no smoothed particle hydrodynamics"),
           ("wall/sph", "Suna has no smoothed particle " "hydrodynamics"),
           ("mesh/surface/stress/servo", "Suna has no wall that a force moves"),
           ("mesh/surface/stress/6dof", "Suna has no wall that a force moves"),
           ("break/", "Suna has no breakage"),
           ("multicontact", "Suna treats each contact by itself"),
           ("adapt", "Suna keeps the size of a particle; "
            "insert/pack of Suna reaches a solid fraction of 0.55 without growth"),
           ("scale/diameter", "Suna keeps the size of a particle"),
           ("bond/create", "bonds of this package are not "
            "translated; see bondLinear in docs/effects.md"),
           ("couple/cfd/", "Suna couples no such field"),
           ("couple/pascal", "Suna has no model inside the particles"),
           ("wall/region", "give the wall as a mesh"),
           ("buoyancy", "use fluid and pressureGradient in the scene"),
           ("setforce", "Suna sets no force; frozen, driven"), ("spring", "Suna has no such force"),
           ("deform", "the domain keeps its size"),
           ("momentum", "Suna keeps momentum; the frame is that of the walls"),
           ("remove", "use outlets in the scene"),
           ("insert/pack/", "use insert/pack with a region"),
           ("pour", "use insert/pack or insert/stream, which replaced it"))
INTEGRATORS = ("nve/sphere", "nve/sphere/limit", "nve/limit", "nve/sphere/omp", "nve/nonspherical")
KINDS = {
    "youngsModulus": "pressure",
    "characteristicVelocity": "velocity",
    "kt": "stiffness",
    "gamman": "rate",
    "cohesionEnergyDensity": "energy density",
    "FluidViscosity": "viscosity"}
MOVES = {"linear", "rotate", "wiggle"}


def add(t, name, group, style, words):
    """`t`: the Translation."""
    t.fixes[name] = style
    method = METHODS.get(style)
    if method is not None:
        method(t, name, group, words)
    elif style in INTEGRATORS:
        integrate(t, name, group, style)
    elif style in HARMLESS:
        harmless(t, name, style, words)
    else:
        del t.fixes[name]
        text = next((text for start, text in LACKING if style.startswith(start)),
                    "the importer does not know this fix")
        t.refuse(text, f"fix {style}")


def remove(t, name):
    style = t.fixes.pop(name)
    for insertion in t.insertions:
        if insertion.name == as_name(name):
            insertion.end = min(insertion.end, t.time)
    t.walls = {key: wall for key, wall in t.walls.items() if key != name}
    for mesh in t.meshes.values():
        for motion in mesh.motions:
            if motion.name == name:
                motion.end = min(motion.end, t.time)
    if style == "gravity":
        t.gravity = None
    t.integrated = [row for row in t.integrated if row[0] != name]
    t.frozen = [row for row in t.frozen if row[0] != name]
    t.forces = {key: value for key, value in t.forces.items() if key != name}
    t.driven = {key: value for key, value in t.driven.items() if key != name}


def as_name(name, start="fix"):
    """A word of a scene."""
    name = "".join(c if c.isalnum() or c == "_" else "_" for c in name)
    return name if name[:1].isalpha() else start + name


def harmless(t, name, style, words):
    if style.startswith("massflow/mesh") and "delete_atoms" in words and \
            words[words.index("delete_atoms") + 1] == "yes":
        outlet(t, name, words)
        return
    t.harmless(HARMLESS[style])


def outlet(t, name, words):
    """Particles behind the plane of the mesh are removed."""
    mesh = t.find(t.meshes, words[words.index("mesh") + 1], "mesh")
    x = mesh.triangles.reshape(-1, 3)
    normal = numpy.cross(*(mesh.triangles[0][1:] - mesh.triangles[0][0]))
    normal /= numpy.linalg.norm(normal)
    if numpy.abs((x - x[0]) @ normal).max() > 1e-6*numpy.ptp(x):
        t.refuse("the mesh is not plane; give outlets in the scene", "delete_atoms yes")
    if "vec_side" in words:
        at = words.index("vec_side")
        side = numpy.array(t.numbers(words[at + 1:at + 4]))
        normal = normal if side @ normal > 0 else -normal
    t.outlets[name] = (x.mean(axis=0), normal, t.command.place)
    t.approximated(
        "outlets: every particle behind the plane of the mesh is removed, also beside the mesh",
        "delete_atoms yes")


def integrate(t, name, group, style):
    t.integrated.append((name, group))
    if "limit" in style:
        t.approximated("displacements are not limited; time/maxSpeed ends a run")
    else:
        t.translated("particles that no fix integrates are frozen")


# ---- materials, forces -------------------------------------------------

def property_global(t, name, group, words):
    what, kind, values = words[0], words[1], words[2:]
    if kind in ("peratomtypepair", "matrix"):
        values = values[1:]
    elif kind not in ("scalar", "peratomtype", "atomtype", "vector"):
        t.refuse(f"known: scalar, vector, peratomtype, peratomtypepair, matrix",
                 f"property/global {kind}")
    unit = KINDS.get(what, "number")
    if what == "kn":
        unit = "stiffness" if t.units.name == "si" else "number"
    t.properties.set(what, kind,
                     [t.number(word, unit) for word in values if word not in ("rebuild",)],
                     t.command.place)
    t.translated("materials, effects")


def gravity(t, name, group, words):
    if words[1] != "vector":
        t.refuse("known: vector", f"fix gravity {words[1]}")
    direction = numpy.array(t.numbers(words[2:5]))
    t.gravity = (t.number(words[0], "acceleration")*direction/numpy.linalg.norm(direction),
                 t.command.place)
    t.translated("effects/gravity")


def freeze(t, name, group, words):
    t.frozen.append((name, group))
    t.translated("frozen yes")


def move(t, name, group, words):
    if words[0] != "linear":
        t.refuse("driven particles of Suna keep one velocity; known: linear",
                 f"fix move {words[0]}")
    t.driven[name] = (group, [0.0 if word == "NULL" else t.number(word, "velocity")
                      for word in words[1:4]])
    t.translated("driven yes")


def addforce(t, name, group, words):
    t.forces[name] = (group, "force", t.numbers(words[:3], "force"), t.command.place)
    t.translated("forces")


def addtorque(t, name, group, words):
    t.forces[name] = (group, "torque", t.numbers(words[:3], "torque"), t.command.place)
    t.translated("forces")


def viscous(t, name, group, words):
    if group != "all" or len(words) > 1:
        t.refuse("known is one coefficient for all particles", "fix viscous")
    t.fluid = (t.number(words[0], "damping"), t.command.place)


def enforce2d(t, name, group, words):
    t.flat = True
    t.translated("domain/flat")


# ---- walls -------------------------------------------------------------

def wall(t, name, group, words):
    from .liggghts import Wall
    if words[0] != "model":
        t.refuse("known is wall/gran model NORMAL ...", f"fix wall/gran {words[0]}")
    model, rest = read_model(words[1:], t.command.place, "fix wall/gran", t.report)
    if t.model is None:
        t.refuse("pair_style comes before the walls")
    misfit = fits(model, t.model)
    if misfit:
        t.refuse(misfit)
    found = Wall(name, model, t.command.place)
    if rest[0] == "primitive":
        if rest[1] == "type":
            found.type, rest = int(rest[2]), rest[3:]
        else:
            found.type, rest = int(rest[1]), rest[2:]
        found.primitive = rest.pop(0)
        count = {"xplane": 1, "yplane": 1, "zplane": 1, "xcylinder": 3, "ycylinder": 3,
                 "zcylinder": 3, "general_plane": 6, "plane": 6, "general_cylinder": 7,
                 "general_cone": 8}.get(found.primitive)
        if count is None:
            t.refuse(
    "known: planes, cylinders, general_plane, general_cylinder, general_cone; give others as a mesh",
     f"primitive {found.primitive}")
        found.numbers, rest = t.numbers(rest[:count], "length"), rest[count:]
    elif rest[0] == "mesh":
        many = int(rest[rest.index("n_meshes") + 1])
        at = rest.index("meshes") + 1
        found.meshes = tuple(rest[at:at + many])
        for mesh in found.meshes:
            t.find(t.meshes, mesh, "mesh")
        rest = rest[at + many:]
    else:
        t.refuse("known: primitive, mesh", f"fix wall/gran {rest[0]}")
    while rest:
        key = rest.pop(0)
        if key == "shear":
            axis, speed = rest.pop(0), rest.pop(0)
            v = [0.0, 0.0, 0.0]
            v["xyz".index(axis)] = t.number(speed, "velocity")
            found.velocity = tuple(v)
        elif key in ("store_force", "store_force_contact", "contact_area", "heat", "track_energy"):
            t.harmless("output", key)
            rest.pop(0)
        elif key == "temperature":
            t.harmless("no law that was translated reads it", key)
            rest.pop(0)
        else:
            t.refuse("the importer does not know this word", f"fix wall/gran {key}")
    if found.meshes and found.velocity:
        t.refuse("shear is for primitive walls; surface_vel of the mesh", "shear")
    t.walls[name] = found
    t.translated("walls")


def mesh(t, name, group, words):
    from .liggghts import Mesh
    given = list(words)
    path, kind, scale, transformed = None, 0, 1.0, False
    x, velocity, spin = None, (), ()
    while given:
        key = given.pop(0)
        if key == "file":
            path = t.file(given.pop(0))
            try:
                x = read_triangles(path)*t.units.si("length", 1.0)
            except (BadMesh, ValueError, UnicodeDecodeError) as error:
                t.refuse(f"{path}: {error}", "file")
            scale = t.units.si("length", 1.0)
            transformed = path.suffix.lower() != ".stl"
        elif key == "type":
            kind = int(given.pop(0))
        elif key == "scale":
            factor = t.number(given.pop(0))
            x, scale = x*factor, scale*factor
        elif key == "move":
            shift = numpy.array(t.numbers(given[:3], "length"))
            x, transformed, given = x + shift, transformed or bool(shift.any()), given[3:]
        elif key == "rotate":
            axis, angle = t.numbers(given[1:4]), math.radians(t.number(given[5]))
            x, transformed, given = rotated(x, numpy.zeros(
                3), axis, angle), transformed or angle != 0, given[6:]
        elif key == "surface_vel":
            velocity, given = t.numbers(given[:3], "velocity"), given[3:]
        elif key == "surface_ang_vel":
            origin, axis = t.numbers(given[1:4], "length"), t.numbers(given[5:8])
            spin, given = (*origin, *axis, t.number(given[9], "spin")), given[10:]
        elif key in ("curvature", "curvature_tolerant", "heal", "verbose", "precision",
                     "min_feature_length", "temperature", "mass_temperature", "reference_point",
                     "stress", "wear", "region", "read_cell_data", "optimizeMeshSpacing"):
            value = given.pop(0)
            given = given[2:] if key == "reference_point" else given
            if key == "wear":
                t.harmless("wear is not computed; the motion of the particles is the same",
                           f"wear {value}")
            elif key in ("temperature", "mass_temperature"):
                t.harmless("no law that was translated reads it", key)
            else:
                t.harmless("edges are joined by geometry; force is in walls.csv", key)
        elif key == "element_exclusion_list":
            t.harmless("exact repeats and slivers are left out anyway", key)
            given = given[2:]
        else:
            t.refuse("the importer does not know this word", f"fix mesh/surface {key}")
    if x is None:
        t.refuse("file is missing")
    t.meshes[name] = Mesh(name, path, x, kind, t.command.place, scale, transformed, velocity, spin)
    t.translated("walls or inlet, where it is used")


def mesh_stress(t, name, group, words):
    mesh(t, name, group, words)
    t.wall_interval = True


def move_mesh(t, name, group, words):
    from .liggghts import Motion
    wall, kind, rest = t.find(t.meshes, words[1], "mesh"), words[2], words[3:]
    if kind not in MOVES:
        t.refuse(
    f"walls of Suna move by {', '.join(sorted(MOVES))}: translation at constant velocity, rotation, "
    "harmonic oscillation",
     f"move/mesh {kind}")
    if kind == "linear":
        values = t.numbers(rest[:3], "velocity")
    elif kind == "rotate":
        origin, axis = t.numbers(rest[1:4], "length"), t.numbers(rest[5:8])
        values = (*origin, *axis, 2*math.pi/t.number(rest[9], "time"))
    else:
        values = (*t.numbers(rest[1:4], "length"), 1/t.number(rest[5], "time"))
    if any(m.end > t.time for m in wall.motions):
        t.refuse(f"mesh {wall.name} has a motion already, and a wall of Suna has one at a time")
    if t.time == 0 and kind == "linear" and not any(values):
        t.harmless("at rest")
        return
    wall.motions.append(Motion(kind, values, t.time, t.command.place, name=name))
    t.translated({"linear": "motion translation", "rotate": "motion rotation",
                  "wiggle": "motion oscillation"}[kind])


# ---- insertion ---------------------------------------------------------

def template(t, name, group, words):
    kind, density, style, radius = 1, t.units.si("density", 1.0), "constant", None
    rest = words[1:]
    while rest:
        key = rest.pop(0)
        if key == "atom_type":
            kind = int(rest.pop(0))
        elif key == "density":
            if rest[0] != "constant":
                t.refuse("a material has one density; write constant", f"density {rest[0]}")
            density, rest = t.number(rest[1], "density"), rest[2:]
        elif key == "radius":
            style = rest.pop(0)
            many = {"constant": 1, "uniform": 2, "gaussian": 2, "lognormal": 2}.get(style)
            if rest[0] in ("number", "mass"):
                rest.pop(0)
            if many is None:
                t.refuse("known: constant, uniform, gaussian, lognormal", f"radius {style}")
            radius, rest = t.numbers(rest[:many], "length"), rest[many:]
            if style == "lognormal":
                radius = (radius[0] if t.units.name == "si" else
                          t.refuse("lognormal in SI units only", "radius lognormal"), radius[1])
        elif key == "volume_limit":
            rest.pop(0)
        elif key == "relative":
            rest.pop(0)
        else:
            t.refuse("the importer does not know this word", f"particletemplate/sphere {key}")
    if radius is None:
        t.refuse("radius is missing")
    t.templates[name] = Template(kind, density, style, radius, t.command.place)
    t.translated("insert: diameter, sizes")


def distribution(by_mass):
    def add(t, name, group, words):
        rows = words[2:2 + 2*int(words[1])]
        found = [t.find(t.templates, key, "particletemplate") for key in rows[0::2]]
        weights = numpy.array([t.number(word) for word in rows[1::2]])
        if by_mass:
            weights = weights/[template.mass() for template in found]
        t.distributions[name] = Distribution(found, list(weights/weights.sum()))
        t.translated("insert: sizes" if len(found) > 1 else "insert")
    return add


AMOUNTS = {
    "volumefraction_region": (
    "fraction", "number"), "particles_in_region": (
    "count", "number"), "mass_in_region": (
    "mass", "mass"), "nparticles": (
    "count", "number"), "mass": (
    "mass", "mass"), "particlerate": (
    "rate", "rate"), "massrate": (
    "mass_rate", "mass rate")}
PLACING = ("maxattempt", "ntry_mc", "warn_region", "verbose", "check_dist_from_subdomain_border",
           "parallel", "random_distribute", "compress_tags", "check_obb", "save_template",
           "extrude_length", "duration", "duration_time")


def insertion(style):
    def add(t, name, group, words):
        rest, i = list(words), Insertion(as_name(name), style, group, None, t.command.place, t.time)
        while rest:
            key = rest.pop(0)
            if key == "seed":
                i.seed = int(float(rest.pop(0)))
            elif key == "distributiontemplate":
                i.distribution = t.find(t.distributions, rest.pop(0), "particledistribution")
            elif key in AMOUNTS:
                attribute, kind = AMOUNTS[key]
                word = rest.pop(0)
                setattr(i, attribute, math.inf if word == "INF" else t.number(word, kind))
            elif key in ("insert_every", "every"):
                word = rest.pop(0)
                i.every = 0.0 if word == "once" else t.number(word)*t.step if t.step else 0.0
            elif key == "insert_every_time":
                i.every = t.number(rest.pop(0), "time")
            elif key == "start":
                i.start = max(t.time, t.time + (t.number(rest.pop(0)) - t.steps)*(t.step or 0.0))
            elif key == "vel":
                rest = velocity(t, i, rest)
            elif key == "omega":
                i.spin, rest = numpy.array(t.numbers(rest[1:4], "spin")), rest[4:]
            elif key == "region":
                i.region = t.find(t.regions, rest.pop(0), "region")
            elif key == "insertion_face":
                i.face = t.find(t.meshes, rest.pop(0), "mesh")
            elif key == "all_in":
                i.all_in = rest.pop(0) == "yes"
            elif key == "overlapcheck":
                if rest.pop(0) == "no":
                    t.approximated("Suna inserts without overlap", "overlapcheck no")
            elif key == "orientation":
                t.harmless("spheres", "orientation")
                rest = rest[5:] if rest[0] == "constant" else rest[1:]
            elif key == "set_property":
                t.harmless("no law that was translated reads it", "set_property")
                rest = rest[2:]
            elif key in PLACING:
                rest.pop(0)
            else:
                t.refuse("the importer does not know this word", f"insert/{style} {key}")
        check(t, i)
        t.insertions.append(i)
        t.translated("insert")
    return add


def velocity(t, i, rest):
    style = rest.pop(0)
    if style not in ("constant", "uniform", "gaussian"):
        t.refuse("known: constant, uniform, gaussian", f"vel {style}")
    i.velocity, rest = numpy.array(t.numbers(rest[:3], "velocity")), rest[3:]
    if style != "constant":
        i.spread, rest = numpy.array(t.numbers(rest[:3], "velocity")), rest[3:]
        if i.style == "pack":
            t.approximated(
    f"all particles of a group have the mean velocity; LIGGGHTS spreads it by {i.spread} m/s",
     f"vel {style}")
        elif style == "gaussian":
            i.spread = i.spread*math.sqrt(3)
            t.approximated("spread: uniform with the same variance", "vel gaussian")
    return rest


def check(t, i):
    if i.distribution is None:
        t.refuse("distributiontemplate is missing")
    if i.style == "stream" and i.face is None:
        t.refuse("insertion_face is missing")
    if i.style != "stream" and i.region is None:
        t.refuse("region is missing")
    if i.style != "pack" and not (i.rate or i.mass_rate):
        t.refuse("particlerate or massrate is missing")
    if i.style == "rate" and not i.region.is_shape():
        t.refuse("a stream enters in a block, cylinder or sphere; use one of these",
                 f"region {i.region.style}")


METHODS = {
    "property/global": property_global,
    "gravity": gravity,
    "freeze": freeze,
    "move": move,
    "addforce": addforce,
    "addtorque": addtorque,
    "viscous": viscous,
    "enforce2d": enforce2d,
    "wall/gran": wall,
    "mesh/surface": mesh,
    "mesh/surface/planar": mesh,
    "mesh/surface/stress": mesh_stress,
    "move/mesh": move_mesh,
    "particletemplate/sphere": template,
    "particledistribution/discrete": distribution(True),
    "particledistribution/discrete/massbased": distribution(True),
    "particledistribution/discrete/numberbased": distribution(False),
    "insert/pack": insertion("pack"),
    "insert/stream": insertion("stream"),
    "insert/rate/region": insertion("rate")}
