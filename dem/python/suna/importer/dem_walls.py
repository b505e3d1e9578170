"""dem_walls.py -- walls of a DEM script beside the patches of the mesh that they stand on.

In CFDEMcoupling the particles have walls of their own and the mesh has patches, often at the same
place. In Suna wall patches are walls of the particles, so a wall must not act twice:

    a plane on faces of wall patches            left out: the patches act
    a plane on all faces of another patch       that patch becomes a wall
    a plane or cylinder outside the mesh        left out: the patches that bound the mesh act
    any other                                   stays, besides the patches

Patches that are neither walls nor coupled become outlets: a particle outside the mesh ends a run.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from typing import NamedTuple

import numpy

from .mesh_patches import COUPLED, on_plane, range_along, range_around, size

TOLERANCE = 1e-3        # of the mesh's size


class Wall(NamedTuple):
    """`kind`: plane or cylinder; a point of it; normal or axis; the type of its material in the
    script; the line of the script."""
    name: str
    kind: str
    point: tuple
    axis: tuple
    radius: float
    material: object
    place: object


def place_walls(walls, patches, centre, material, properties, report, place):
    """Adds walls and outlets to the properties. `centre`: of the particles, which are on that side
    of planes; `material(type)`: its name; `place`: where outlets are said to come from."""
    become, tolerance = {}, TOLERANCE*size(patches)
    for name in patches:
        properties.names.free("walls", name)        # these are the walls of the patches
    for wall in walls:
        if (plane if wall.kind == "plane" else cylinder)(wall, patches, become, tolerance, report):
            properties.named("walls", wall.name, entry(wall, centre, material(wall.material)),
                             wall.place)
    for name, wall in become.items():
        properties.add("walls", f"{name} {{ material {material(wall.material)}; }}", wall.place)
    for patch in patches.values():
        if patch.name in become:
            continue
        if patch.type == "wall" and walls and material(1) != material(2):
            properties.add("walls", f"{patch.name} {{ material {material(walls[0].material)}; }}",
                           walls[0].place)
        elif patch.type in ("patch", "mappedPatch"):
            properties.add("outlets", f"{patch.name} {{ patch {patch.name}; }}", place)
            report.approximated(place, f"patch {patch.name}", "an outlet: particles that pass it "
                                "are removed; there they go on outside the mesh without fluid")
        elif patch.type in ("symmetry", "symmetryPlane"):
            report.refuse(place, f"patch {patch.name} ({patch.type})", "particles need a wall "
                          "there; name one in the DEM script")


def entry(wall, centre, material):
    """Entries of the wall."""
    point = " ".join(f"{x:.12g}" for x in wall.point)
    if wall.kind == "cylinder":
        axis = " ".join(f"{x:g}" for x in wall.axis)
        return (f"type cylinder; material {material}; point ({point}); axis ({axis}); "
                f"radius {wall.radius:.12g}; particles inside;")
    side = numpy.sign(numpy.dot(wall.axis, numpy.subtract(centre, wall.point))) or 1.0
    normal = " ".join(f"{int(side)*x:g}" for x in wall.axis)
    return f"type plane; material {material}; point ({point}); normal ({normal});"


def plane(wall, patches, become, tolerance, report):
    point, normal = numpy.array(wall.point), numpy.array(wall.axis)
    found = on_plane(patches, point, normal, tolerance)
    low, high = range_along(patches, point, normal)
    coupled = [name for name in found if patches[name].type in COUPLED]
    if coupled:
        report.refuse(wall.place, wall.name, f"a wall on the coupled patch {coupled[0]}, through "
                      "which particles of Suna pass")
    if found:
        others = [name for name in found if patches[name].type != "wall"]
        for name in others:
            if found[name]:
                become[name] = wall
        if not all(found[name] for name in others):
            return True
        report.translated(wall.place, wall.name, "patches " + ", ".join(
            f"{name} ({'becomes' if name in others else 'is already'} a wall)" for name in found))
        for name in found:
            become.setdefault(name, wall)
        return False
    if low > -tolerance or high < tolerance:
        report.approximated(wall.place, wall.name, "left out: it lies outside the mesh, whose "
                            "patches hold the particles or are outlets")
        return False
    report.translated(wall.place, wall.name, "walls, inside the mesh")
    return True


def cylinder(wall, patches, become, tolerance, report):
    point, axis = numpy.array(wall.point), numpy.array(wall.axis, float)
    least, most = range_around(patches, point, axis/numpy.linalg.norm(axis))
    if most <= wall.radius + tolerance:
        report.approximated(wall.place, wall.name,
                            f"left out: its radius is {wall.radius:.6g} m, and the "
                            f"corners of the mesh lie within {most:.6g} m: the wall patches hold "
                            "the particles")
        return False
    report.translated(wall.place, wall.name, "walls, inside the mesh")
    return True
