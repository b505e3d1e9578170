"""liggghts_scene_walls.py -- walls of a scene: primitives and meshes of LIGGGHTS with their motion.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import functools
import math
import os

import numpy

from .liggghts_contact import Need, fits
from .liggghts_heat import AREA
from .liggghts_mesh import write_stl
from .liggghts_region import AXES
from .scene_text import as_name, text, vector

SIDES = 96              # of a cone


class Walls:
    """Of a SceneMaker (liggghts_scene.py)."""

    @functools.cached_property
    def landmarks(self):
        """(points where particles are or enter, how far these stay inside)."""
        found = [(self.particles.x, 0.0)]
        for i in self.insertions:
            if i.face is not None:
                found.append((i.face.triangles.mean(axis=1), 0.0))
            else:
                r = min(t.range()[0] for t in i.distribution.templates) if i.all_in else 0.0
                found.append((i.region.samples(self.box), r))
        found = [(x, r) for x, r in found if len(x)]
        if not found and self.box is not None:
            found.append((numpy.array(self.box).mean(axis=1)[None], 0.0))
        return found

    def add_walls(self):
        base, made = self.state["model"], {}
        for wall in self.state["walls"].values():
            misfit = fits(wall.model, base)
            if misfit:
                self.refuse(wall.place, wall.model.word, misfit)
            model = None if wall.model.key() == base.key() else wall.model
            if wall.primitive:
                self.add_primitive(wall, self.material(wall.type, model=model))
            for name in wall.meshes:
                mesh = self.state["meshes"][name]
                if name in made and made[name] != model:
                    self.refuse(wall.place, f"meshes {name}", "this mesh has two contact models")
                if name not in made:
                    self.add_mesh(wall, mesh, self.material(mesh.type, model=model))
                made[name] = model

    def side(self, wall, distance):
        """1 or -1: where the particles are of a surface; `distance`: of points from it."""
        sides = set()
        for x, r in self.landmarks:
            low, high = distance(x).min() + r, distance(x).max() - r
            sides |= {int(s) for s in numpy.sign([low, high] if low < high else [low + high]) if s}
        if len(sides) > 1:
            self.refuse(wall.place, wall.primitive,
                        "particles are on both sides of this wall, and a wall of Suna has "
                        "one; give it as a mesh, which has two")
        return sides.pop() if sides else 1

    def add_primitive(self, wall, material):
        if wall.primitive == "general_cone":
            self.add_cone(wall, material)
            return
        body = self.plane(wall) if wall.primitive.endswith("plane") else self.cylinder(wall)
        if wall.velocity:
            body += f" surfaceVelocity {vector(wall.velocity)};"
        body += self.temperature(wall, wall.temperature)
        kind, rest = body.split(" ", 1)
        self.scene.named("walls", as_name(wall.name, "wall"),
                         f"type {kind} material {material}; {rest}", wall.place)

    def add_cone(self, wall, material):
        n = wall.numbers
        path = self.new_file(f"{wall.name}.stl")
        write_stl(path, frustum(numpy.array(n[1:4]), n[0], numpy.array(n[4:7]), n[7]))
        inside = max(n[0], n[7])*(1 - math.cos(math.pi/SIDES))
        self.report.approximated(wall.place, "primitive general_cone", f"{SIDES} flat faces "
                                 f"around, at most {inside:.2g} m inside the cone")
        self.scene.named("walls", as_name(wall.name, "wall"),
                         f'type stl; material {material}; file "{os.path.relpath(path)}";'
                         f"{self.temperature(wall, wall.temperature)}", wall.place)

    def plane(self, wall):
        n = wall.numbers
        if len(n) == 6:
            point, normal = numpy.array(n[:3]), numpy.array(n[3:])/numpy.linalg.norm(n[3:])
        else:
            normal = numpy.eye(3)[AXES[wall.primitive[0]]]
            point = n[0]*normal
        side = self.side(wall, lambda x: (x - point) @ normal)
        return f"plane; point {vector(point)}; normal {vector(side*normal)};"

    def cylinder(self, wall):
        n = wall.numbers
        if wall.primitive == "general_cylinder":
            point, axis = numpy.array(n[1:4]), numpy.array(n[4:])/numpy.linalg.norm(n[4:])
        else:
            a = AXES[wall.primitive[0]]
            axis, point = numpy.eye(3)[a], numpy.zeros(3)
            point[[(a + 1) % 3, (a + 2) % 3]] = n[1:]       # of ycylinder: z, x
        inside = self.side(wall, lambda x: n[0] - numpy.linalg.norm(numpy.cross(x - point, axis), axis=1)) > 0
        side = "inside" if inside else "outside"
        if wall.velocity and numpy.linalg.norm(numpy.cross(axis, wall.velocity)) > 0:
            self.refuse(wall.place, "shear",
                        "along the axis of a cylinder only; surface_ang_vel of a mesh turns it")
        return (f"cylinder; point {vector(point)}; axis {vector(axis)}; radius {text(n[0])}; "
                f"particles {side};")

    def add_mesh(self, wall, mesh, material):
        acting = [m for m in mesh.motions if m.start < self.end and m.end > self.start]
        motion = acting[0] if acting else None
        corners, moved = mesh.at(motion.start if motion else self.start)
        path, scale = mesh.path, mesh.scale
        if moved or mesh.transformed:
            path, scale = self.new_file(f"{mesh.name}.stl"), 1.0
            write_stl(path, corners)
        body = f'type stl; material {material}; file "{os.path.relpath(path)}";'
        body += f" scale {text(scale)};" if scale != 1 else ""
        if mesh.velocity and any(mesh.velocity):
            body += f" surfaceVelocity {vector(mesh.velocity)};"
        if mesh.spin:
            body += f" surfaceRotation {{ origin {vector(mesh.spin[:3])}; " \
                f"axis {vector(mesh.spin[3:6])}; omega {text(mesh.spin[6])}; }}"
        body += self.temperature(wall, mesh.temperature) + self.wear(mesh)
        if motion:
            body += " " + self.motion(motion)
        self.scene.named("walls", as_name(mesh.name, "wall"), body, mesh.place)

    def wear(self, mesh):
        """Entry of a wall; k_finnie [1/Pa] is coefficient/hardness."""
        if not mesh.wears:
            return ""
        properties = self.state["properties"]
        try:
            if not properties.has("k_finnie"):
                raise Need("k_finnie", "wear finnie needs it")
            found = {properties.value("k_finnie", mesh.type, self.materials[name][0]) for name in self.of_particles}
        except Need as need:
            self.refuse(mesh.place, f"property/global {need}", need.why)
        if len(found) > 1:
            self.refuse(mesh.place, "k_finnie", "a wall of Suna has one coefficient of wear for all particles; give "
                        "all types of particles the same value")
        if not found:
            return ""
        return f" wear {{ law finnie; coefficient {text(found.pop())}; hardness 1; }}"

    def temperature(self, wall, value):
        """Entry of a wall."""
        if self.state["heat"] is None or not value:
            return ""
        if wall.area != "overlap":
            self.refuse(wall.place, f"contact_area {wall.area}", AREA)
        return f" temperature {{ value {text(value)}; }}"

    def motion(self, m):
        v = m.values
        words = {"linear": lambda: f"type translation; velocity {vector(v)};",
                 "rotate": lambda: f"type rotation; origin {vector(v[:3])}; "
                 f"axis {vector(v[3:6])}; omega {text(v[6])};",
                 "wiggle": lambda: f"type oscillation; amplitude {vector(v[:3])}; "
                 f"frequency {text(v[3])};",
                 "servo": lambda: f"type servo; axis {vector(v[:3])}; force {text(v[3])}; "
                 f"maxSpeed {text(v[4])};",
                 "free": lambda: free_motion(v)}[m.kind]()
        words += f" start {text(m.start)};" if m.start > 0 else ""
        words += f" end {text(m.end)};" if math.isfinite(m.end) and m.end < self.end else ""
        return f"motion {{ {words} }}"


def free_motion(v):
    words = f"type free; axes ({' '.join(v['axes'])}); mass {text(v['mass'])};"
    if v["rotations"]:
        words += f" rotations ({' '.join(v['rotations'])}); centre {vector(v['centre'])}; inertia {vector(v['inertia'])};"
        words += f" spin {vector(v['spin'])};" if any(v["spin"]) else ""
    return words + (f" velocity {vector(v['velocity'])};" if any(v["velocity"]) else "")


def frustum(a, ra, b, rb):
    """Triangles of a cone without ends, from radius ra at a to rb at b."""
    axis = (b - a)/numpy.linalg.norm(b - a)
    u = numpy.cross(axis, numpy.eye(3)[numpy.argmin(numpy.abs(axis))])
    u /= numpy.linalg.norm(u)
    angle = 2*math.pi*numpy.arange(SIDES + 1)/SIDES
    around = numpy.cos(angle)[:, None]*u + numpy.sin(angle)[:, None]*numpy.cross(axis, u)
    low, high = a + ra*around, b + rb*around
    found = [t for k in range(SIDES) for t in (
        (low[k], low[k + 1], high[k]), (high[k], low[k + 1], high[k + 1]))]
    return [t for t in found if len({tuple(p) for p in t}) == 3]
