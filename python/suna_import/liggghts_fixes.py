"""liggghts_fixes.py -- the fixes of LIGGGHTS: materials, forces, outlets; which others have no
effect on the answer, and which Suna lacks. liggghts_wall_fixes.py has walls and meshes,
liggghts_insert_fixes.py insertion.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import dataclasses
import math

import numpy

from . import liggghts_heat, liggghts_insert_fixes, liggghts_wall_fixes
from .liggghts_state import Action

FLUID = "a coupled run of Suna needs no such line; alone, no fluid acts"
HARMLESS = {
    "check/timestep/gran": "too long a step is refused",
    "balance": "subdomains are balanced by themselves",
    "property/atom": "read by no law that was translated",
    "property/atom/lammps": "read by no law",
    "couple/cfd": "a coupled run of Suna needs no such line",
    "couple/cfd/force": FLUID,
    "couple/cfd/force/implicit": FLUID,
    "couple/cfd/force/accumulator": FLUID,
    "region/variable": "output",
    "executionTiming": "output",
    "contacthistory": "",
    "neighlist/mesh": "",
    "diam/max": ""}
LOST = {                        # output that no entry of the scene writes: what does it
    "print": "write { energy } has energies and momentum; in Python any text (docs/python.md)",
    "ave/time": "see averages and write { energy } in docs/output.md",
    "ave/spatial": "see averages in docs/output.md",
    "ave/histo": "make it from averages or from the particles' files",
    "ave/euler": "see averages in docs/output.md",
    "ave/euler/region": "see averages in docs/output.md",
    "ave/atom": "the particles' files have the values of the moment",
    "store/state": "the particles' files have the values of the moment",
    "massflow/mesh": "flows.csv has what passes inlets and outlets; averages in a region have the "
    "mean velocity",
    "massflow/mesh/face": "averages in a region have the mean velocity"}
LACKING = (("heat/gran/radiation", "not translated; add radiation to the scene (docs/heat.md)"),
           ("massflow/mesh/sieve", "Suna has no sieve: particles pass a wall or do not"),
           ("heat/", "Suna has no such heat; known: heat/gran, heat/gran/conduction"),
           ("chem/", "Suna has no chemistry"), ("multisphere/", "clumps with this are not translated: write shapes"),
           ("particletemplate/", "spheres only are translated"),
           ("nve/", "Suna has spheres, integrated by themselves"),
           ("sph/", "Suna has no smoothed particle hydrodynamics"),
           ("wall/sph", "Suna has no smoothed particle hydrodynamics"),
           ("break/", "Suna has no breakage"),
           ("multicontact", "Suna treats each contact by itself"),
           ("adapt", "Suna keeps the size of a particle; "
            "insert/pack of Suna reaches a solid fraction of 0.55 without growth"),
           ("scale/diameter", "Suna keeps the size of a particle"),
           ("bond/create", "bonds of this package are not translated; see bondLinear in "
            "docs/effects.md"),
           ("couple/cfd/convection", "heat exchange with the fluid is not translated; add gunn to "
            "constant/demProperties by hand"),
           ("couple/cfd/", "Suna couples no such field"),
           ("couple/pascal", "Suna has no model inside the particles"),
           ("wall/region", "give the wall as a mesh"),
           ("buoyancy", "use fluid and pressureGradient in the scene"),
           ("setforce", "Suna sets no force; frozen, driven"), ("spring", "Suna has no such force"),
           ("deform", "the domain keeps its size"),
           ("momentum", "Suna keeps momentum; the frame is fixed to the walls"),
           ("remove", "use outlets in the scene"),
           ("insert/pack/", "use insert/pack with a region"),
           ("pour", "use insert/pack or insert/stream, which replaced it"))
PAIRS = ("peratomtypepair", "atomtypepair", "matrix")
INTEGRATORS = ("nve/sphere", "nve/sphere/limit", "nve/limit", "nve/sphere/omp", "nve/nonspherical",
               "multisphere")
ON_GROUP = ("freeze", "move", "addforce", "addtorque")
KINDS = {
    "youngsModulus": "pressure",
    "characteristicVelocity": "velocity",
    "kn": "stiffness",
    "kt": "stiffness",
    "gamman": "rate",
    "gammat": "rate",
    "gamman_abs": "damping",
    "gammat_abs": "damping",
    "cohesionEnergyDensity": "energy density",
    "FluidViscosity": "viscosity",
    "k_finnie": "inverse pressure",
    "thermalConductivity": "conductivity",
    "thermalCapacity": "heat capacity",
    "youngsModulusOriginal": "pressure"}


def add(t, name, group, style, words):
    """`t`: the Translation."""
    t.fixes[name] = style
    method = METHODS.get(style)
    if group in t.unknown and (style in ON_GROUP or style in INTEGRATORS):
        t.refuse(f"group {group} was made after a run, with particles that fix insert/... has placed; the importer "
                 "does not know which. Make the group before, and insert into it, or begin another script with the "
                 "particles, from a data file (read_data)", f"fix {style}")
    if method is not None:
        method(t, name, group, words)
    elif style in INTEGRATORS:
        integrate(t, name, group, style)
    elif style in HARMLESS:
        t.harmless(HARMLESS[style])
    elif style in LOST:
        output(t, name, style, words)
    else:
        del t.fixes[name]
        text = next((text for start, text in LACKING if style.startswith(start)),
                    "the importer does not know this fix")
        t.refuse(text, f"fix {style}")


def remove(t, name):
    style = t.fixes.pop(name)
    t.insertions[:] = [i for i in t.insertions if i.fix != name or i.start < t.time]
    for insertion in t.insertions:
        if insertion.fix == name:
            insertion.end = min(insertion.end, t.time)
    t.walls.pop(name, None)
    for mesh in t.meshes.values():
        for motion in mesh.motions:
            if motion.name == name:
                motion.end = min(motion.end, t.time)
    if style == "enforce2d":
        t.flat = t.planar
    if t.heat is not None and t.heat.name == name:
        t.heat = None
    t.integrated = [row for row in t.integrated if row[0] != name]
    t.frozen = [row for row in t.frozen if row[0] != name]
    for defined in (t.forces, t.driven, t.outlets, t.gravities, t.drags):
        defined.pop(name, None)


def hold(t, name, word):
    """fix_modify integrate: a wall moved by force stops or starts here."""
    if word not in ("start", "stop"):
        t.refuse("known: start, stop", f"integrate {word}")
    moving = [(mesh, m) for mesh in t.meshes.values() if name in t.fixes for m in
              [m for m in mesh.motions if m.name == name][-1:]]
    if not moving and not t.is_faulty("fix", name):
        t.refuse(f"no wall is moved by a fix {name}", f"integrate {word}")
    for mesh, motion in moving:
        if word == "stop" and motion.end > t.time:
            motion.end = t.time if motion.start < t.time else -math.inf
        elif word == "start" and motion.end <= t.time:
            mesh.motions.append(dataclasses.replace(motion, start=t.time, end=math.inf))
    return f"the motion of the wall {word}s"


def output(t, name, style, words):
    """Says what is not written."""
    what = f'"{words[1]}", every {words[0]} steps, is not printed' if style == "print" else \
        "its values are not written"
    if style.startswith("massflow/mesh"):
        what = f"mass and number of particles through {words[words.after('mesh')]} are not counted"
        if "delete_atoms" in words and words[words.after("delete_atoms")] == "yes":
            outlet(t, name, words)
            what = "the list of particles that leave is not written"
    file = next((key for key in ("file", "append") if key in words), "")
    if file:
        what += f", nor the file {words[words.after(file)]}"
    t.report.lost(t.command.place, f"fix {style}", f"{what}; {LOST[style]}")


def outlet(t, name, words):
    """Particles behind the plane of the mesh are removed."""
    mesh = t.find(t.meshes, words[words.after("mesh")], "mesh")
    x = mesh.triangles.reshape(-1, 3)
    normal = numpy.cross(*(mesh.triangles[0][1:] - mesh.triangles[0][0]))
    normal /= numpy.linalg.norm(normal)
    if numpy.abs((x - x[0]) @ normal).max() > 1e-6*numpy.ptp(x):
        t.refuse("the mesh is not plane; give outlets in the scene", "delete_atoms yes")
    if "vec_side" in words:
        at = words.after("vec_side")
        side = t.direction(words[at:at + 3])
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
    if kind in PAIRS:
        columns, values = t.whole(values[0], 1), values[1:]
    elif kind not in ("scalar", "peratomtype", "atomtype", "vector"):
        t.refuse("known: scalar, vector, peratomtype, peratomtypepair, matrix",
                 f"property/global {kind}")
    values = [word for word in values if word != "rebuild"]
    if not values or kind in PAIRS and len(values) != columns**2:
        t.refuse(f"has {len(values)} values, not the number that {kind} needs",
                 f"property/global {what}")
    unit = KINDS.get(what, "number")
    t.properties.set(what, kind, [t.number(word, unit) for word in values], t.command.place)
    t.translated("materials, effects")


def gravity(t, name, group, words):
    if words[1] != "vector":
        t.refuse("known: vector", f"fix gravity {words[1]}")
    t.no_more(words[5:])
    t.gravities[name] = Action(group, t.number(words[0], "acceleration")*t.direction(words[2:5]), t.command.place)
    t.translated("effects/gravity")


def freeze(t, name, group, words):
    t.frozen.append((name, group))
    t.translated("frozen yes")


def move(t, name, group, words):
    if words[0] != "linear":
        t.refuse("driven particles of Suna keep one velocity; known: linear",
                 f"fix move {words[0]}")
    t.no_more(words[4:])
    if "NULL" in words[1:4]:
        t.refuse("NULL leaves the motion along this axis to the forces, but driven particles of Suna keep their whole "
                 "velocity; write 0 for an axis along which they rest", "fix move linear")
    t.driven[name] = (group, list(t.numbers(words[1:4], "velocity")))
    t.translated("driven yes")


def addforce(t, name, group, words):
    t.no_more(words[3:])
    t.forces[name] = (group, "force", t.numbers(words[:3], "force"), t.command.place)
    t.translated("forces")


def addtorque(t, name, group, words):
    t.no_more(words[3:])
    t.forces[name] = (group, "torque", t.numbers(words[:3], "torque"), t.command.place)
    t.translated("forces")


def viscous(t, name, group, words):
    if len(words) > 1:
        t.refuse("is translated with one coefficient for all particles", "fix viscous")
    t.drags[name] = Action(group, t.number(words[0], "damping"), t.command.place)
    t.translated("stokesDrag in a fluid with this coefficient, for one size")


def enforce2d(t, name, group, words):
    t.flat = True
    t.translated("domain/flat")


METHODS = {
    "property/global": property_global,
    "gravity": gravity,
    "freeze": freeze,
    "move": move,
    "addforce": addforce,
    "addtorque": addtorque,
    "viscous": viscous,
    "enforce2d": enforce2d,
    "heat/gran": liggghts_heat.conduction,
    "heat/gran/conduction": liggghts_heat.conduction,
    **liggghts_wall_fixes.METHODS,
    **liggghts_insert_fixes.METHODS}
