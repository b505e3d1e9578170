"""liggghts_wall_fixes.py -- walls and meshes of LIGGGHTS: fix wall/gran, mesh/surface, move/mesh.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

import numpy

from .liggghts_contact import read_model
from .liggghts_mesh import BadMesh, read_triangles, rotated
from .liggghts_state import Mesh, Motion, Wall

EDGES = "edges are joined by geometry; force is in walls.csv"
MESH_HARMLESS = {               # empty: EDGES
    "curvature": "",
    "curvature_tolerant": "",
    "heal": "",
    "verbose": "",
    "precision": "",
    "min_feature_length": "",
    "mass_temperature": "no law that was translated reads it",
    "reference_point": "",
    "stress": "",
    "region": "",
    "read_cell_data": "",
    "optimizeMeshSpacing": ""}
# shapes of wall/gran primitive: how many numbers
PRIMITIVES = {"xplane": 1, "yplane": 1, "zplane": 1, "xcylinder": 3, "ycylinder": 3,
              "zcylinder": 3, "general_plane": 6, "plane": 6, "general_cylinder": 7,
              "general_cone": 8}
MOVES = {"linear", "rotate", "wiggle"}


def wall(t, name, group, words):
    if words[0] != "model":
        t.refuse("known is wall/gran model NORMAL ...", f"fix wall/gran {words[0]}")
    model, rest = read_model(words[1:], t.command.place, "fix wall/gran", t.report)
    if model.cohesion == "sjkr2":       # the area of sjkr; twice this area between particles only
        model = model._replace(cohesion="sjkr")
    found = Wall(name, model, t.command.place, group)
    if rest[0] == "primitive":
        rest = read_primitive(t, found, rest)
    elif rest[0] == "mesh":
        rest = read_meshes(t, found, rest)
    else:
        t.refuse("known: primitive, mesh", f"fix wall/gran {rest[0]}")
    read_wall_keywords(t, found, rest)
    if found.meshes and found.velocity:
        t.refuse("is for primitive walls; give the mesh surface_vel", "shear")
    t.walls[name] = found
    t.translated("walls")


def read_primitive(t, found, rest):
    """Type, shape and numbers of a primitive; returns the words left."""
    at = 2 if rest[1] == "type" else 1
    found.type, found.primitive, rest = t.atom_type(rest[at]), rest[at + 1], rest[at + 2:]
    count = PRIMITIVES.get(found.primitive)
    if count is None:
        t.refuse("known: planes, cylinders, general_plane, general_cylinder, general_cone; give "
                 "others as a mesh", f"primitive {found.primitive}")
    found.numbers = t.numbers(rest[:count], "length")
    return rest[count:]


def read_meshes(t, found, rest):
    """Names of the meshes; returns the words left."""
    many = t.whole(rest[rest.after("n_meshes")], 1, 1000)
    at = rest.after("meshes")
    found.meshes = tuple(rest[at:at + many])
    for name in found.meshes:
        t.find(t.meshes, name, "mesh")
    return rest[at + many:]


def read_wall_keywords(t, found, rest):
    while rest:
        key = rest.pop(0)
        if key == "shear":
            axis, speed = rest.pop(0), rest.pop(0)
            v = [0.0, 0.0, 0.0]
            if axis not in ("x", "y", "z") or found.primitive == axis + "plane":
                t.refuse("must be along the plane, not along its normal", f"shear {axis}")
            v["xyz".index(axis)] = t.number(speed, "velocity")
            found.velocity = tuple(v)
        elif key in ("store_force", "store_force_contact", "heat", "track_energy"):
            t.harmless("output", key)
            rest.pop(0)
        elif key == "contact_area":
            found.area = rest.pop(0)
            if found.area == "constant":
                rest.pop(0)
            t.harmless("without heat" if t.heat is None else "", key)
        elif key == "temperature":
            found.temperature = wall_temperature(t, rest.pop(0))
        else:
            t.refuse("the importer does not know this word", f"fix wall/gran {key}")


def wall_temperature(t, word):
    t.translated("temperature of the wall, where fix heat/gran acts")
    return t.number(word)


def mesh(t, name, group, words):
    given, found = words[:], Mesh(name, None, None, 0, t.command.place)
    while given:
        key = given.pop(0)
        if key == "type":
            found.type = t.atom_type(given.pop(0))
        elif key in MESH_WORDS:
            if found.triangles is None and key != "file":
                t.refuse("must come after file", f"fix mesh/surface {key}")
            given = MESH_WORDS[key](t, found, given)
        elif key in MESH_HARMLESS:
            value = given.pop(0)
            given = given[2:] if key == "reference_point" else given
            t.harmless(MESH_HARMLESS[key] or EDGES, key)
        elif key == "element_exclusion_list":
            t.harmless("exact repeats and slivers are left out anyway", key)
            given = given[2:]
        else:
            t.refuse("the importer does not know this word", f"fix mesh/surface {key}")
    if found.triangles is None:
        t.refuse("file is missing")
    if found.spin:
        tell_spin(t, found)
    t.meshes[name] = found
    t.translated("walls or inlet, where it is used")


# ---- words of a mesh, in the order of the script; each returns the words left ------------------

def mesh_wear(t, found, rest):
    """2 k_finnie |v| |F| f(angle) dt, summed while a grain approaches: k_finnie m v^2 f for one that stops."""
    law = rest.pop(0)
    if law not in ("finnie", "off"):
        t.refuse("known: finnie, off", f"wear {law}")
    found.wears = law == "finnie"
    if found.wears:
        t.approximated("Suna adds k_finnie m v^2 f(angle) when a contact begins; LIGGGHTS sums 2 k_finnie |v| |F| "
                       "f(angle) dt while the grain approaches, the same for a grain that stops at a constant angle",
                       "wear finnie")
    return rest


def mesh_file(t, found, given):
    found.path = t.file(given[0])
    try:
        found.triangles = read_triangles(found.path)*t.units.si("length", 1.0)
    except (BadMesh, ValueError, UnicodeDecodeError) as error:
        t.refuse(f"{found.path}: {error}", "file")
    found.scale = t.units.si("length", 1.0)
    found.transformed = found.path.suffix.lower() != ".stl"
    return given[1:]


def mesh_scale(t, found, given):
    factor = t.positive(given[0])
    found.triangles, found.scale = found.triangles*factor, found.scale*factor
    return given[1:]


def mesh_move(t, found, given):
    shift = numpy.array(t.numbers(given[:3], "length"))
    found.triangles = found.triangles + shift
    found.transformed |= bool(shift.any())
    return given[3:]


def mesh_rotate(t, found, given):
    axis, angle = t.direction(given[1:4]), math.radians(t.number(given[5]))
    found.triangles = rotated(found.triangles, numpy.zeros(3), axis, angle)
    found.transformed |= angle != 0
    return given[6:]


def mesh_velocity(t, found, given):
    found.velocity = t.numbers(given[:3], "velocity")
    return given[3:]


def mesh_spin(t, found, given):
    origin, axis = t.numbers(given[1:4], "length"), t.direction(given[5:8])
    found.spin = (*origin, *axis, t.number(given[9], "spin"))
    return given[10:]


def tell_spin(t, found):
    """LIGGGHTS turns the velocity omega x r into each face and keeps its magnitude; Suna's surface
    turns as a solid, whose part along the normal does not push."""
    edges = found.triangles[:, 1:] - found.triangles[:, :1]
    normal = numpy.cross(edges[:, 0], edges[:, 1])
    normal /= numpy.maximum(numpy.linalg.norm(normal, axis=1), 1e-300)[:, None]
    v = numpy.cross(found.spin[3:6], found.triangles.mean(axis=1) - found.spin[:3])
    size = numpy.linalg.norm(v, axis=1)
    into = numpy.abs((v*normal).sum(axis=1)) > 0.1*size     # 0.1: 0.5 % of the speed along the face
    if into.any():
        t.approximated(f"{into.sum()} of {len(into)} faces are not along the rotation: there "
                       "LIGGGHTS' surface has the speed omega r along the face, Suna's its part "
                       "along the face", "surface_ang_vel")


def mesh_temperature(t, found, given):
    found.temperature = wall_temperature(t, given[0])
    return given[1:]


MESH_WORDS = {"file": mesh_file, "scale": mesh_scale, "move": mesh_move, "rotate": mesh_rotate,
              "surface_vel": mesh_velocity, "surface_ang_vel": mesh_spin,
              "temperature": mesh_temperature, "wear": mesh_wear}


def mesh_stress(t, name, group, words):
    mesh(t, name, group, words)
    t.wall_interval = True


# words of a servo that Suna does not need: how many values they have
CONTROLLER = {"com": 3, "kp": 1, "ki": 1, "kd": 1, "mode": 1, "ratio": 1}


def mesh_servo(t, name, group, words):
    """A wall that presses along its axis; the rest of the words are of the mesh."""
    given, others, axis, found = words[:], type(words)(), None, {}
    while given:
        key = given.pop(0)
        if key == "axis":
            axis, given = t.direction(given[:3]), given[3:]
        elif key in ("ctrlPV", "target_val", "vel_max"):
            found[key] = given.pop(0)
        elif key in CONTROLLER:
            given = given[CONTROLLER[key]:]
        else:
            others.append(key)
    if found.get("ctrlPV") != "force":
        t.refuse("known is ctrlPV force; for a torque see hinge in docs/walls-and-boundaries.md",
                 f"ctrlPV {found.get('ctrlPV')}")
    if axis is None or "target_val" not in found or "vel_max" not in found:
        t.refuse("needs axis, target_val and vel_max", "mesh/surface/stress/servo")
    force, speed = t.number(found["target_val"], "force"), t.positive(found["vel_max"], "velocity")
    if force == 0:
        t.refuse("a servo needs a load that is not 0", "target_val 0")
    if force < 0:           # it presses against the axis
        axis, force = -axis, -force
    mesh_stress(t, name, group, others)
    t.meshes[name].motions.append(Motion("servo", (*axis, force, speed), t.time, t.command.place,
                                         name=name))
    t.approximated("Suna's servo takes its damping from the contacts, not from kp, ki, kd or mode",
                   "mesh/surface/stress/servo")


# words of a rigid body: how many values they have
BODY = {"com": 3, "vel": 3, "angmom": 3, "mass": 1, "moi": 6, "forceflags": 3, "torqueflags": 3}


def mesh_body(t, name, group, words):
    """A wall that moves freely; the rest of the words are of the mesh."""
    given, others, found = words[:], type(words)(), {}
    while given:
        key = given.pop(0)
        if key in ("rot_flip", "suspension"):
            t.refuse("Suna's free walls have no such setting", key)
        if key in BODY:
            found[key], given = given[:BODY[key]], given[BODY[key]:]
        else:
            others.append(key)
    if not {"com", "mass", "moi"} <= set(found):
        t.refuse("needs com, mass and moi", "mesh/surface/stress/6dof")
    axes, rotations = ([a for a, flag in zip("xyz", found.get(key, "111")) if flag != "0"]
                       for key in ("forceflags", "torqueflags"))
    velocity = t.numbers(found.get("vel", ["0"]*3), "velocity")
    if not axes or any(v and a not in axes for a, v in zip("xyz", velocity)):
        t.refuse("a free wall of Suna moves along at least one axis, and is at rest along the others", "forceflags")
    if len(rotations) == 2:
        t.refuse("walls of Suna rotate about one axis or about all", "torqueflags")
    if len(rotations) == 1:
        t.approximated("the axis of rotation stays fixed in space", "torqueflags")
    unit = t.units.si("mass", 1)*t.units.si("length", 1)**2
    I = unit*numpy.array(t.numbers(found["moi"]))
    momentum = unit/t.units.si("time", 1)*numpy.array(t.numbers(found.get("angmom", ["0"]*3)))
    spin = numpy.linalg.solve(I[[[0, 3, 4], [3, 1, 5], [4, 5, 2]]], momentum)
    if t.time > 0 and (any(velocity) or any(spin)):
        t.refuse("after a run, a free wall of Suna begins at rest; leave out vel and angmom",
                 "mesh/surface/stress/6dof")
    mesh_stress(t, name, group, others)
    t.meshes[name].motions.append(Motion("free", {
        "axes": axes, "rotations": rotations, "mass": t.positive(found["mass"][0], "mass"),
        "centre": t.numbers(found["com"], "length"), "inertia": tuple(I), "velocity": velocity,
        "spin": tuple(spin)}, t.time, t.command.place, name=name))
    t.translated("motion free")


def move_mesh(t, name, group, words):
    wall, kind, rest = t.find(t.meshes, words[1], "mesh"), words[2], words[3:]
    if kind not in MOVES:
        t.refuse(f"walls of Suna move by {', '.join(sorted(MOVES))}: translation at constant "
                 "velocity, rotation, harmonic oscillation", f"move/mesh {kind}")
    if kind == "linear":
        values = t.numbers(rest[:3], "velocity")
    elif kind == "rotate":
        origin, axis = t.numbers(rest[1:4], "length"), t.direction(rest[5:8])
        values = (*origin, *axis, 2*math.pi/t.nonzero(rest[9], "time"))
    else:
        values = (*t.numbers(rest[1:4], "length"), 1/t.positive(rest[5], "time"))
    if any(m.end > t.time for m in wall.motions):
        t.refuse(f"mesh {wall.name} has a motion already, and a wall of Suna has one at a time")
    if t.time == 0 and kind == "linear" and not any(values):
        t.harmless("at rest")
        return
    wall.motions.append(Motion(kind, values, t.time, t.command.place, name=name))
    t.translated({"linear": "motion translation", "rotate": "motion rotation",
                  "wiggle": "motion oscillation"}[kind])


METHODS = {
    "wall/gran": wall,
    "mesh/surface": mesh,
    "mesh/surface/planar": mesh,
    "mesh/surface/stress": mesh_stress,
    "mesh/surface/stress/servo": mesh_servo,
    "mesh/surface/stress/6dof": mesh_body,
    "move/mesh": move_mesh}
