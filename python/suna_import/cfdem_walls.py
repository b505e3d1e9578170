"""cfdem_walls.py -- walls of a DEM script beside the patches of the mesh that they stand on.

In CFDEMcoupling the particles have walls of their own and the mesh has patches, often at the same
place. In Suna wall patches are walls of the particles, so a wall must not act twice:

    a plane on faces of wall patches            left out: the patches act
    a plane on all faces of another patch       that patch becomes a wall
    a plane or cylinder outside the mesh        left out: the patches that bound the mesh act
    triangles on faces of wall patches          left out: the patches act
    triangles on all faces of another patch     that patch becomes a wall
    triangles outside the mesh                  left out
    any other                                   stays, besides the patches

Triangles are compared at points in them, and patches at points in their faces (mesh_surfaces.py):
the largest distance is at most NEAR of the particles' diameter, and is told.

Patches that are neither walls nor coupled become outlets: a particle outside the mesh ends a run.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from typing import NamedTuple

import numpy

from .mesh_patches import COUPLED, farthest_from, on_plane, range_along, size
from .mesh_surfaces import distance, samples, triangles_of
from .scene_text import vector

TOLERANCE = 1e-3        # of the mesh's size: planes and cylinders
NEAR = 0.1              # of a diameter: triangles, whose round faces have other corners
TOUCHED = 0.05          # of a patch lies on the triangles: more than along an edge
POINTS = 20             # along the mesh's size, where surfaces are compared


class Wall(NamedTuple):
    """`kind`: plane or cylinder, with a point of it and its normal or axis, or mesh, with its
    triangles; the type of its material in the script; the line of the script."""
    name: str
    kind: str
    point: tuple
    axis: tuple
    radius: float
    material: object
    place: object
    triangles: object = None


def place_walls(walls, patches, particles, material, properties, report, place):
    """Adds walls and outlets to the properties. `particles`: their centre, they are on that side of
    planes, and their diameter; `material(type)`: its name; `place`: where outlets are said to come
    from. Returns the triangles of walls that stay, by name."""
    become, tolerance, surfaces = {}, TOLERANCE*size(patches), {}
    centre, diameter = particles
    meshes = [wall.triangles for wall in walls if wall.kind == "mesh"]
    boundary = Boundary(patches, numpy.concatenate(meshes), NEAR*diameter) if meshes else None
    for name in patches:
        properties.names.free("walls", name)        # these are the walls of the patches
    for wall in walls:
        if wall.kind == "mesh":
            if boundary.stays(wall, become, report):
                name = properties.names.free("walls", wall.name)
                properties.add("walls", f'{name} {{ type surface; material '
                               f'{material(wall.material)}; file "{name}.stl"; }}', wall.place)
                surfaces[name] = wall.triangles
            continue
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
    return surfaces


def entry(wall, centre, material):
    """Entries of the wall."""
    point = vector(wall.point)
    if wall.kind == "cylinder":
        return (f"type cylinder; material {material}; point {point}; axis {vector(wall.axis)}; "
                f"radius {wall.radius:.12g}; particles inside;")
    side = numpy.sign(numpy.dot(wall.axis, numpy.subtract(centre, wall.point))) or 1.0
    normal = vector(side*x for x in wall.axis)
    return f"type plane; material {material}; point {point}; normal {normal};"


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
    most = farthest_from(patches, point, axis/numpy.linalg.norm(axis))
    if most <= wall.radius + tolerance:
        report.approximated(wall.place, wall.name,
                            f"left out: its radius is {wall.radius:.6g} m, and the "
                            f"corners of the mesh lie within {most:.6g} m: the wall patches hold "
                            "the particles")
        return False
    report.translated(wall.place, wall.name, "walls, inside the mesh")
    return True


class Boundary:
    """The mesh's patches beside the triangles of the script's walls."""

    def __init__(self, patches, triangles, tolerance):
        self.patches, self.walls, self.tolerance = patches, triangles, tolerance
        faces = {name: triangles_of(patch.faces) for name, patch in patches.items() if patch.faces}
        self.triangles = numpy.concatenate(list(faces.values()))
        self.spacing = size(patches)/POINTS
        self.samples = {name: samples(x, self.spacing) for name, x in faces.items()}
        self.low = self.triangles.min(axis=(0, 1)) - tolerance
        self.high = self.triangles.max(axis=(0, 1)) + tolerance

    def stays(self, wall, become, report):
        """The wall is one besides the patches; else patches become it."""
        points = samples(wall.triangles, self.spacing)
        points = points[((points >= self.low) & (points <= self.high)).all(axis=1)]
        if len(points) == 0:
            report.approximated(wall.place, wall.name, "left out: it lies outside the mesh, whose "
                                "patches hold the particles or are outlets")
            return False
        away = distance(points, self.triangles, self.spacing)
        found = [name for name in self.samples if (
            self.beside(name, wall.triangles) <= self.tolerance).mean() > TOUCHED]
        if away.max() > self.tolerance:
            report.translated(wall.place, wall.name, "a wall of type surface inside the mesh: it "
                              f"is up to {away.max():.3g} m from the patches, more than "
                              f"{self.tolerance:.3g} m, {NEAR:g} diameters")
            return True
        coupled = [name for name in found if self.patches[name].type in COUPLED]
        if coupled:
            report.refuse(wall.place, wall.name, f"a wall on the coupled patch {coupled[0]}, "
                          "through which particles of Suna pass")
        found = [name for name in found if self.patches[name].type != "empty"]
        others = [name for name in found if self.patches[name].type != "wall"]
        beside = {name: self.beside(name, self.walls).max() for name in others}
        part = [name for name in others if beside[name] > self.tolerance]
        if part:
            report.translated(wall.place, wall.name, "a wall of type surface: it covers only a "
                              f"part of patch {part[0]}")
            return True
        for name in found:
            become.setdefault(name, wall)
        report.approximated(wall.place, wall.name, "patches " + ", ".join(
            f"{name} ({'becomes' if name in others else 'is already'} a wall)" for name in found) +
            f", up to {max([away.max(), *beside.values()]):.3g} m from the triangles")
        return False

    def beside(self, name, triangles):
        """Distances of a patch from triangles."""
        return distance(self.samples[name], triangles, self.spacing)
