"""liggghts_scene.py -- scenes of Suna from the stages of a script of LIGGGHTS.

Stages that follow each other are one scene as long as what changes between them has a time in a scene:
insertions that begin or end, one motion of a mesh. Another change (a wall added or removed, another
material, a second motion) begins a new scene that continues from the snapshot of the one before.

Particles, walls, motions and streams have the time of the script, so a scene of a series is that of
the whole script from its own beginning on.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import textwrap

import numpy

from ..simulation import Simulation, SunaError
from .liggghts import key
from .liggghts_contact import Need, laws
from .liggghts_fixes import as_name
from .liggghts_insertion import NOW, Template, group_entries, scatter, stream_entries
from .liggghts_mesh import write_stl
from .liggghts_particles import write_table
from .liggghts_region import AXES, Region, text, vector
from .report import CannotTranslate, WIDTH

SIDES = 96              # of a cone
LIST = 20               # particles that are written in the scene; more go to a table


# ---- stages of one scene -----------------------------------------------

def one_motion(stages):
    start, end = stages[0].start, stages[-1].end
    return all(sum(m.start < end and m.end > start for m in mesh.motions) <= 1
               for mesh in stages[0].state["meshes"].values())


def series(translation, report):
    """Lists of stages, one for each scene."""
    stages = [s for s in translation.stages if s.steps > 0] or translation.stages[-1:]
    found = []
    for stage in stages:
        last = found[-1] if found and not stage.fresh else None
        if last and last[-1].steps <= 1 and len(
            last) == 1 and key(last[0].state) != key(stage.state):
            report.harmless(last[0].place, "run",
                            "the single step before other commands is part of the scene that "
                            "follows")
            stage.start, stage.fresh = last[0].start, last[0].fresh
            found[-1] = [stage]
        elif last and key(last[0].state) == key(stage.state) and one_motion([*last, stage]):
            last.append(stage)
        else:
            found.append([stage])
    return found


# ---- one scene ---------------------------------------------------------

class SceneText:
    """Sections in the order of the manual, each entry with the line that it comes from."""
    ORDER = ("materials", "effects", "pairs", "walls", "domain", "insert", "outlets", "forces",
             "fluid", "time", "write")

    def __init__(self):
        self.sections = {name: [] for name in self.ORDER}

    def add(self, section, entry, place=None):
        self.sections[section].append((entry, "" if place is None else f"// {place}"))

    def text(self, head):
        lines = list(head) + [""]
        for name, entries in self.sections.items():
            if not entries:
                continue
            lines += [name, "{"]
            wide = min(60, max(len(entry) for entry, _ in entries))
            for entry, comment in entries:
                if len(entry) > 60 and comment:
                    lines.append(f"    {comment}")
                    lines += broken(entry)
                else:
                    lines.append(f"    {entry:{wide}}  {comment}".rstrip())
            lines.append("}")
        return "\n".join(lines) + "\n"


def broken(entry):
    """An entry over several lines, at its blanks."""
    return textwrap.wrap(entry, WIDTH, initial_indent="    ", subsequent_indent="        ",
                         break_long_words=False, break_on_hyphens=False)


def braces(name, settings):
    inner = " ".join(f"{k} {v if isinstance(v, str) else text(v)};" for k, v in settings.items())
    return f"{name} {{ {inner} }}" if inner else f"{name} {{}}"


class SceneMaker:
    """One scene of a translation. `stages`: its stages; `name`: path without .dem; `restart`: the snapshot that
    it continues from, or empty."""

    def __init__(self, translation, stages, name, restart, report):
        self.t, self.stages, self.name, self.report = translation, stages, name, report
        self.state, self.start, self.end = stages[-1].state, stages[0].start, stages[-1].end
        self.restart, self.scene = restart, SceneText()
        self.materials, self.files = {}, []
        self.box = self.state["box"]

    def refuse(self, place, word, sentence):
        self.report.refuse(place, word, sentence)

    def make(self):
        if self.state["model"] is None:
            self.refuse(self.stages[0].place, "run", "there is no pair_style gran before this line")
        self.particles = self.state["particles"]
        self.insertions = [i for i in self.state["insertions"] if i.start < self.end]
        self.find_materials()
        self.add_walls()
        self.add_domain()
        self.add_insert()
        self.add_outlets()
        self.add_forces()
        self.add_fluid()
        self.add_contacts()
        self.add_time()
        return self.scene

    # ---- materials and laws ----------------------------------------------------------------------

    def find_materials(self):
        for i in self.insertions:
            for t in i.distribution.templates:
                self.material(t.type, t.density, t.place)
        for kind, density in sorted(set(zip(self.particles.type, self.particles.density))):
            self.material(int(kind), float(density), self.particles.place)
        self.of_particles = list(self.materials)

    def material(self, kind, density=None, place=None, model=None):
        """Name of the material of a type; a wall takes one of its type, whatever its density."""
        for name, row in self.materials.items():
            if row[0] == kind and row[1] in (density, row[1] if density is None
                                             else None) and row[2] == model:
                return name
        if density is None:
            density = next((row[1] for row in self.materials.values()), 1000.0)
        name = f"type{kind}" + ("_wall" if model else "")
        others = sum(n == name or n.startswith(name + "_")
                     for n in self.materials if not n.endswith("_wall"))
        name += f"_{others + 1}" if others and name in self.materials else ""
        self.materials[name] = (kind, density, model)
        return name

    def of_key(self, key):
        return self.material(*key)

    def add_contacts(self):
        s, properties = self.scene, self.state["properties"]
        for name, (kind, density, _) in self.materials.items():
            try:
                e, nu = (self.need(properties, word, kind)
                         for word in ("youngsModulus", "poissonsRatio"))
            except Need as need:
                self.refuse(self.state["model"].place, f"property/global {need}",
                            "this property is missing")
            nu = min(nu, 0.49999)
            s.add("materials",
                  f"{name} {{ density {text(density)}; youngsModulus {text(e)}; poissonsRatio "
                  f"{text(nu)}; }}", properties.places["youngsModulus"])
        base = self.state["model"]
        names = list(self.materials)
        main = self.of_particles[0] if self.of_particles else names[0] if names else None
        if main is None:
            self.refuse(base.place, "pair_style", "there are neither particles nor walls at a run")
        common = self.laws_of(main, main)
        if self.state["gravity"] is not None:
            g, place = self.state["gravity"]
            s.add("effects", f"gravity {{ acceleration {vector(g)}; }}", place)
        for effect, settings in common.items():
            s.add("effects", braces(effect, settings), self.source(effect, base))
        for k, a in enumerate(names):
            for b in names[k:]:
                if a not in self.of_particles and b not in self.of_particles:
                    continue
                other = self.laws_of(a, b)
                differ = {e: {k: v for k, v in values.items() if common[e].get(k) != v}
                          for e, values in other.items()}
                differ = {e: values for e, values in differ.items() if values}
                if differ:
                    model = self.materials[b][2] or self.materials[a][2] or base
                    s.add("pairs", f"{a}_{b} {{ between ({a} {b}); "
                          + " ".join(braces(e, v) for e, v in differ.items()) + " }", model.place)

    def need(self, properties, name, kind):
        if not properties.has(name):
            raise Need(name)
        return properties.value(name, kind)

    def laws_of(self, a, b):
        base = self.state["model"]
        model = self.materials[a][2] or self.materials[b][2] or base
        try:
            return laws(model, base, self.state["properties"], self.materials[a][0],
                        self.materials[b][0])
        except Need as need:
            self.refuse(model.place, f"property/global {need}",
                        "the model needs this property, which the script " "does not give")
        except IndexError:
            self.refuse(model.place, "property/global",
                        f"a property has no value for types {self.materials[a][0]} "
                        f"and {self.materials[b][0]}")

    def source(self, effect, base):
        word = {"dry": "coefficientRestitution", "mindlin": "coefficientFriction",
                "linear": "coefficientFriction", "mindlinIncremental": "coefficientFriction",
                "sjkr": "cohesionEnergyDensity", "rollingConstant": "coefficientRollingFriction",
                "rollingSpring": "coefficientRollingFriction"}.get(effect)
        return self.state["properties"].places.get(word, base.place)

    # ---- walls -----------------------------------------------------------------------------------

    def landmarks(self):
        """Points where particles are or enter."""
        found = [x for x in self.particles.x]
        for i in self.insertions:
            if i.face is not None:
                found.append(i.face.triangles.mean(axis=(0, 1)))
            else:
                low, high = i.region.bounds()
                if numpy.isfinite([low, high]).all():
                    found.append((low + high)/2)
        if not found and self.box is not None:
            found.append(numpy.array(self.box).mean(axis=1))
        return numpy.array(found).reshape(-1, 3)

    def add_walls(self):
        base, made = self.state["model"], {}
        for wall in self.state["walls"].values():
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
        """1 or -1: where the particles are of a surface; distances of the landmarks from it."""
        sides = {int(s) for s in numpy.sign(distance) if s}
        if len(sides) > 1:
            self.refuse(wall.place, wall.primitive,
                        "particles are on both sides of this wall, and a wall of Suna has "
                        "one; give it as a mesh, which has two")
        return sides.pop() if sides else 1

    def add_primitive(self, wall, material):
        n, x = wall.numbers, self.landmarks()
        if wall.primitive == "general_cone":
            path = self.new_file(f"{as_name(wall.name)}.stl")
            write_stl(path, frustum(numpy.array(n[1:4]), n[0], numpy.array(n[4:7]), n[7]))
            self.report.approximated(
    wall.place, "primitive general_cone", f"{SIDES} flat faces around, at most "
    f"{max(n[0], n[7])*(1 - math.cos(math.pi/SIDES)):.2g} m inside the cone")
            self.scene.add("walls",
                           f'{as_name(wall.name, "wall")} {{ type stl; material {material}; '
                           f'file "{os.path.relpath(path)}"; }}', wall.place)
            return
        if wall.primitive in ("general_plane", "plane") or wall.primitive.endswith("plane"):
            if len(n) == 6:
                point, normal = numpy.array(n[:3]), numpy.array(n[3:])/numpy.linalg.norm(n[3:])
            else:
                normal = numpy.eye(3)[AXES[wall.primitive[0]]]
                point = n[0]*normal
            side = self.side(wall, (x - point) @ normal)
            body = f"type plane; material {material}; point {vector(point)}; normal {vector(side*normal)};"
        else:
            if wall.primitive == "general_cylinder":
                point, axis = numpy.array(n[1:4]), numpy.array(n[4:])/numpy.linalg.norm(n[4:])
            else:
                a = AXES[wall.primitive[0]]
                axis, point = numpy.eye(3)[a], numpy.zeros(3)
                point[[k for k in range(3) if k != a]] = n[1:]
            away = numpy.linalg.norm(numpy.cross(x - point, axis), axis=1)
            side = "inside" if self.side(wall, n[0] - away) > 0 else "outside"
            body = (
                f"type cylinder; material {material}; point {vector(point)}; axis {vector(axis)}; "
                f"radius {text(n[0])}; particles {side};")
            if wall.velocity and numpy.linalg.norm(numpy.cross(axis, wall.velocity)) > 0:
                self.refuse(wall.place, "shear",
                            "along the axis of a cylinder only; surface_ang_vel of a mesh turns it")
        if wall.velocity:
            body += f" surfaceVelocity {vector(wall.velocity)};"
        self.scene.add("walls", f"{as_name(wall.name, 'wall')} {{ {body} }}", wall.place)

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
            body += (
    f" surfaceRotation {{ origin {vector(mesh.spin[:3])}; axis {vector(mesh.spin[3:6])}; "
    f"omega {text(mesh.spin[6])}; }}")
        if motion:
            body += " " + self.motion(motion)
        self.scene.add("walls", f"{as_name(mesh.name, 'wall')} {{ {body} }}", mesh.place)

    def motion(self, m):
        v = m.values
        words = {
    "linear": lambda: f"type translation; velocity {vector(v)};",
    "rotate": lambda: f"type rotation; origin {vector(v[:3])}; axis {vector(v[3:6])}; omega {text(v[6])};",
    "wiggle": lambda: f"type oscillation; amplitude {vector(v[:3])}; frequency {text(v[3])};"}[
        m.kind]()
        words += f" start {text(m.start)};" if m.start > 0 else ""
        words += f" end {text(m.end)};" if math.isfinite(m.end) and m.end < self.end else ""
        return f"motion {{ {words} }}"

    def new_file(self, ending):
        path = f"{self.name}_{ending}"
        self.files.append(path)
        return path

    # ---- domain ----------------------------------------------------------------------------------

    def add_domain(self):
        if self.box is None:
            return
        limited = [k for k in range(3) if self.state["boundary"][k][0] in "pf"]
        flat = self.state["flat"]
        entries = []
        for k in range(3):
            if k in limited or flat and k == 2:
                entries.append(f"{'xyz'[k]} {vector(self.box[k])};")
        periodic = [ "xyz"[k]
            for k in range(3) if self.state["boundary"][k][0] == "p" and not (flat and k == 2)]
        if periodic:
            entries.append(f"periodic ({' '.join(periodic)});")
        if flat:
            entries.append("flat (z);")
        if len(periodic) < len(limited) and self.state["lost"] in ("ignore", "warn"):
            entries.append("leaving remove;")
        for entry in entries:
            self.scene.add("domain", entry)

    def clipped(self, region):
        """A block inside the limited axes of the domain."""
        if region.style != "block" or self.box is None:
            return region
        low, high = region.bounds()
        for k in range(3):
            if self.state["boundary"][k][0] in "pf" or not math.isfinite(low[k] + high[k]):
                low[k], high[k] = max(low[k], self.box[k][0]), min(high[k], self.box[k][1])
        values = [value for pair in zip(low, high) for value in pair]
        return Region("block", values, region.place, outside=region.outside)

    # ---- particles -------------------------------------------------------------------------------

    def is_frozen(self, group):
        moves = any(g in ("all", group) for _, g in self.state["integrated"])
        return not moves or any(g in ("all", group) for _, g in self.state["frozen"])

    def add_insert(self):
        if not self.restart:
            self.add_particles()
        for i in self.insertions:
            if i.region is not None:
                i.region = self.clipped(i.region)
            if i.style == "pack":
                self.add_packing(i)
            elif i.end > self.start:
                self.add_stream(i)

    def add_particles(self):
        p = self.particles
        groups = self.state["groups"]

        def member(g):
            return numpy.ones(len(p), bool) if g == "all" else numpy.isin(p.id, groups.get(g, ()))
        none = numpy.zeros(len(p), bool)
        frozen = ~numpy.any([none, *(member(g) for _, g in self.state["integrated"])], axis=0)
        frozen |= numpy.any([none, *(member(g) for _, g in self.state["frozen"])], axis=0)
        v, driven = p.v.copy(), none.copy()
        for g, speed in self.state["driven"].values():
            which = member(g)
            driven |= which
            v[which] = speed
        frozen &= ~driven
        rows = sorted(set(zip(p.type, p.density, frozen, driven)))
        for k, (kind, density, still, pushed) in enumerate(rows):
            which = (p.type == kind) & (p.density == density) & (frozen == still) & (
                driven == pushed)
            self.write_particles(f"particles{k + 1 if len(rows) > 1 else ''}", p.x[which],
                                 p.diameter[which], numpy.where(still, 0.0, v[which]),
                                 numpy.where(still, 0.0, p.w[which]), p.id[which],
                                 self.material(int(kind), float(density)),
                                 (" frozen yes;" if still else "") +
                                 (" driven yes;" if pushed else ""), p.place)

    def write_particles(self, name, x, d, v, w, id, material, more, place):
        if len(x) > LIST:
            path = self.new_file(name + ".csv")
            write_table(path, x, d, v, w, id)
            body = f'type table; material {material}; file "{os.path.relpath(path)}";'
        else:
            body = f"type list; material {material}; positions ({' '.join(vector(row) for row in x)}); " \
                f"diameters ({' '.join(text(value) for value in d)}); ids ({' '.join(str(k) for k in id)});"
            if v.any():
                body += f" velocities ({' '.join(vector(row) for row in v)});"
            if w.any():
                body += f" spins ({' '.join(vector(row) for row in w)});"
        self.scene.add("insert", f"{name} {{ {body}{more} }}", place)

    def add_packing(self, i):
        word = "insert/pack"
        number = i.number(self.report, word)
        at_start = i.start <= self.start and not self.restart
        frozen = self.is_frozen(i.group)
        if at_start:
            if i.region.is_shape():
                for name, body in group_entries(i, number, self.of_key, frozen):
                    self.scene.add("insert", f"{name} {{ {body} }}", i.place)
            else:
                self.scatter(i, number)
        elif i.start >= self.start and not i.every or i.start >= self.start:
            if not i.region.is_shape():
                self.refuse(i.place, f"region {i.region.style}",
                            "a packing during a run is in a block, cylinder or "
                            "sphere; use one of these")
            for name, body in stream_entries(
                i, {"rate": NOW, "count": number}, self.of_key, i.shape(), i.start, math.inf):
                self.scene.add("insert", f"{name} {{ {body} }}", i.place)
            self.report.approximated(
    i.place, word, "during a run: a stream that is due at once; random positions fill up "
    "to a third of the region, what does not fit waits for space")
        if i.every and i.end > self.start + i.every and i.region.is_shape():
            gravity = numpy.zeros(3) if self.state["gravity"] is None else self.state["gravity"][0]
            rate = i.refill_rate(number, gravity)
            end = min(i.end, self.end)
            events = math.ceil((end - i.start)/i.every - 1e-9) - 1
            if rate > 0 and events > 0:
                self.report.approximated(
    i.place,
    f"{word} insert_every",
    f"{number} at once, then {rate:.4g} 1/s as a stream: what leaves the "
    f"region in {i.every:.4g} s. LIGGGHTS fills it {events} times more and stops when the region is "
    "full; the stream goes on into free space")
                for name, body in stream_entries(i, {"rate": rate}, self.of_key, i.shape(
                ), i.start + i.every, i.end if i.end < self.end else math.inf, k0=1):
                    self.scene.add("insert", f"{name} {{ {body} }}", i.place)
            elif events > 0:
                self.report.approximated(i.place, f"{word} insert_every",
                                         "only once: nothing moves the particles out "
                                         "of the region")

    def scatter(self, i, number):
        placed = scatter(i, number)
        if len(placed) < number:
            self.report.approximated(i.place, "insert/pack",
                                     f"{len(placed)} of {number} spheres found a position in "
                                     f"{i.region.style}")
        else:
            self.report.translated(i.place, "insert/pack",
                                   f"placed by the importer in {i.region.style}")
        first = 1 + int(self.particles.id.max()) if len(self.particles) else 1
        for k, key in enumerate(sorted({key for _, _, key in placed})):
            rows = [(x, r) for x, r, other in placed if other == key]
            x, n = numpy.array([row[0] for row in rows]), len(rows)
            still = self.is_frozen(i.group)
            v = numpy.zeros((n, 3)) if still else numpy.broadcast_to(i.velocity, (n, 3))
            self.write_particles(i.name_of(k), x, numpy.array([2*row[1] for row in rows]), v,
                                 numpy.broadcast_to(i.spin, (n, 3)), numpy.arange(first, first + n),
                                 self.of_key(key), " frozen yes;" if still else "", i.place)
            first += n

    def add_stream(self, i):
        if self.is_frozen(i.group):
            self.refuse(i.place, f"insert/{i.style}",
                        "no fix nve/sphere moves these particles, and a stream of Suna " "moves")
        amounts = {"rate": i.rate, "massRate": i.mass_rate, "count": i.count, "mass": i.mass}
        if i.face is not None:
            path, scale = i.face.path, i.face.scale
            if i.face.transformed:
                path, scale = self.new_file(f"{i.face.name}.stl"), 1.0
                write_stl(path, i.face.triangles)
            where = f'surface "{os.path.relpath(path)}";' + (f" scale {text(scale)};" if scale != 1
                                                             else "")
            if not i.velocity.any():
                self.refuse(
    i.place,
    "vel",
     "particles that enter through a face need a velocity; give vel constant")
        else:
            where = i.shape()
        for name, body in stream_entries(i, amounts, self.of_key, where, i.start,
                                         i.end if i.end < self.end else math.inf):
            self.scene.add("insert", f"{name} {{ {body} }}", i.place)

    def add_outlets(self):
        for name, (point, normal, place) in self.state["outlets"].items():
            self.scene.add("outlets",
                           f"{as_name(name)} {{ point {vector(point)}; normal {vector(normal)}; }}",
                           place)

    def add_forces(self):
        for name, (group, kind, values, place) in self.state["forces"].items():
            ids = "" if group == "all" else f"ids ({' '.join(str(k) for k in self.state['groups'].get(group, ()))}); "
            if ids == "ids (); ":
                self.refuse(place, f"fix {name}",
                            f"group {group} has no particles that the script names")
            self.scene.add("forces", f"{as_name(name)} {{ {ids}{kind} {vector(values)}; }}", place)

    def add_fluid(self):
        if self.state["fluid"] is None:
            return
        gamma, place = self.state["fluid"]
        sizes = {round(2*t.range()[k], 15) for i in self.insertions
                 for t in i.distribution.templates for k in (0, 1)}
        sizes |= set(numpy.round(self.particles.diameter, 15))
        if len(sizes) != 1:
            self.refuse(place, "fix viscous",
                        "stokesDrag grows with the diameter: it is the same only for one size")
        self.scene.add("effects", "stokesDrag {}", place)
        self.scene.add("fluid", f"density 1e-6; viscosity {text(gamma/(3*math.pi*sizes.pop()))};",
                       place)

    # ---- time and output -------------------------------------------------------------------------

    def add_time(self):
        step, place = min(s.step for s in self.stages), self.stages[-1].place
        limit, why = self.limit()
        self.scene.add("time", f"end {text(max(self.end, self.start + step))};", place)
        if step <= limit:
            self.scene.add("time", f"step {text(step)};")
        else:
            self.scene.add("time", f"step auto;  // the script has {text(step)}")
            self.report.approximated(
    place,
    "timestep",
    f"auto: {limit:.3g} s ({why}), as the {step:.3g} s of the script "
    "are too long for this accuracy")
        interval = self.state["interval"]
        if interval and interval < self.end:
            self.scene.add("write", f"interval {text(interval)};")
        if self.state["wall_interval"]:
            self.scene.add("write", f"walls {text(100*step)};")

    def limit(self):
        """The longest step that the core takes: with the smallest particle of each material, far apart."""
        smallest = {}
        for i in self.insertions:
            for t in i.distribution.templates:
                name = self.material(t.type, t.density)
                smallest[name] = min(smallest.get(name, math.inf), 2*t.range()[0])
        p = self.particles
        for kind, density, d in zip(p.type, p.density, p.diameter):
            name = self.material(int(kind), float(density))
            smallest[name] = min(smallest.get(name, math.inf), d)
        if not smallest:
            return math.inf, ""
        parts = SceneText()
        for name in ("materials", "effects", "pairs", "fluid"):
            parts.sections[name] = self.scene.sections[name]
        away = 10*max(smallest.values())
        for k, (name, d) in enumerate(smallest.items()):
            parts.add(
    "insert",
    f"p{k} {{ type list; material {name}; positions (({text(away*k)} 0 {text(away)})); "
    f"diameter {text(d)}; }}")
        for name in self.materials:
            parts.add("walls",
                      f"{name} {{ type plane; material {name}; point (0 0 0); normal (0 0 1); }}")
        try:
            with Simulation(parts.text([])) as sim:
                step, limit, why = sim.setup().step
        except SunaError as error:
            self.refuse(self.stages[-1].place, "run", f"the scene is refused: {error}")
        return limit, str(why)


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


# ---- all scenes of a script --------------------------------------------

def write_scenes(translation, output, report):
    """Write the scenes; returns the names of the files and the commands that run them."""
    if translation.before is not None:
        folder = os.path.dirname(output)
        own = as_name(translation.before.path.name.removeprefix("in."))
        first = os.path.join(folder, own + ".dem")
        files, commands = write_scenes(translation.before, first, report)
        snapshot = f"{os.path.splitext(os.path.basename(files[-1]))[0]}/snapshot.dem"
    else:
        files, commands, snapshot = [], [], ""
    stem = output.removesuffix(".dem")
    groups = series(translation, report)
    made = []
    for k, stages in enumerate(groups):
        name = stem if len(groups) == 1 else f"{stem}_{k + 1}"
        restart = "" if stages[0].fresh else snapshot
        try:
            maker = SceneMaker(translation, stages, name, restart, report)
            made.append((name, restart, maker.make()))
        except CannotTranslate:
            pass
        snapshot = f"{os.path.basename(name)}/snapshot.dem"
    report.raise_refused()
    for name, restart, scene in made:
        command = f"dem run {f'-restart {restart} ' if restart else ''}{os.path.relpath(name + '.dem')}"
        head = [
    f"// {os.path.basename(name)}.dem, translated from {os.path.relpath(translation.path)} by dem import.",
    f"// Run where this was made: {command}",
     *report.comment()]
        with open(name + ".dem", "w") as file:
            file.write(scene.text(head))
        files.append(name + ".dem")
        commands.append(command)
    return files, commands
