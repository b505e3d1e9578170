"""cfdem_script.py -- what a coupled case needs of the DEM script of CFDEMcoupling: materials, contact
laws, walls, particles.

    dem = read_dem_script(Path("DEM/in.liggghts_run"), Path("ErgunTestMPI"), report)
    dem.add_laws(properties), dem.walls, dem.add_particles(properties)

The script is executed by liggghts.py. Steps, outputs, end of the run and domain come from the
OpenFOAM case. Where the script reads a restart file, liggghts.py finds the script that writes
it; its groups are inserted, and -settle runs for as long as that script.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from pathlib import Path

import numpy

from .cfdem_walls import Wall
from .liggghts import Translation
from .liggghts_contact import Need, laws
from .liggghts_insertion import group_entries, stream_entries
from .liggghts_particles import single_particles
from .liggghts_state import acting
from .report import HARMLESS, REFUSED, TRANSLATED, Place
from .scene_text import as_name, braces, text
from .units import BASE, Units

PRIMITIVES = {"plane": 1, "cylinder": 3}
AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}
# words of a script that the case decides: what is to be said of them
DECIDED = {"timestep": (HARMLESS, "time/step auto: 1/20 of the contact time"),
           "run": (TRANSLATED, "endTime of controlDict"),
           "create_box": (HARMLESS, "the mesh is the domain"),
           "boundary": (TRANSLATED, "particles are periodic where the mesh is cyclic"),
           "dump": (HARMLESS, "particles are written with the fields"),
           "thermo_modify": (HARMLESS, "outlets"),
           "fix couple/cfd": (HARMLESS, "the solver moves the particles"),
           "fix couple/cfd/force": (HARMLESS, "the exchange is implicit"),
           "fix couple/cfd/force/implicit": (HARMLESS, "the exchange is implicit"),
           "fix couple/cfd/force/accumulator": (HARMLESS, "the exchange is implicit")}


def read_dem_script(path, top, report):
    return DemScript(path, top, report)


class CoupledScript(Translation):
    """A script whose numbers stay in its units, which the mesh and the fields beside it use, too."""

    speed = 1.0         # 1 m/s in these units

    def do_units(self, words):
        super().do_units(words)
        if self.units.name != "si":
            self.report.rows.pop()
            named = ": read cm for m, g for kg in logs and tables" if words[0] == "cgs" else \
                ", whatever logs and tables name"
            self.approximated("all numbers stay in these units, as in CFD" + named,
                              f"units {words[0]}")
            length, _, time = BASE[words[0]]
            self.units, self.speed = Units(), time/length


class DemScript:
    def __init__(self, path, top, report):
        self.path, self.top, self.report = path, top, report
        own = type(report)()
        self.t = CoupledScript(path, own).read()
        report.rows += [self.decided(row._replace(place=self.place(row.place))) for row in own.rows]
        report.raise_refused()
        self.state = self.t.stages[-1].state
        self.step = self.t.step
        self.settle = self.t.before.time if self.t.before else None
        self.places = {row.word: row.place for row in report.rows}
        self.periodic = self.places.get("boundary") if "p" in self.t.boundary else None
        if self.state["model"] is None:
            report.refuse(Place(self.path.name), "pair_style", "is missing")
        self.refuse_others()
        self.walls = [one for wall in self.state["walls"].values() for one in self.wall(wall)]
        self.densities = self.find_densities()

    def place(self, place):
        """The file as seen from the case."""
        file = Path(place.file).resolve()
        if not file.exists():
            file = self.path.parent/place.file
        inside = file.is_relative_to(self.top)
        return Place(str(file.relative_to(self.top)) if inside else place.file, place.line)

    @staticmethod
    def decided(row):
        kind, said = DECIDED.get(row.word, (row.kind, row.text))
        return row if row.kind == REFUSED else row._replace(kind=kind, text=said)

    def refuse(self, place, word, sentence):
        self.report.refuse(self.place(place), word, sentence)

    def refuse_others(self):
        """What scenes have and coupled cases do not."""
        if self.state["heat"] is not None:
            self.refuse(self.state["heat"].place, "fix heat/gran", "heat is not translated in "
                        "coupled cases; add conduction and gunn to constant/demProperties by hand")
        for fix in acting(self.state):
            if fix.group != "all":
                self.refuse(fix.place, f"group {fix.group}", "in coupled cases it acts on all particles; write all")
        for name, sentence in (("forces", "forces on chosen particles"),
                               ("driven", "driven particles"),
                               ("frozen", "frozen particles beside others"),
                               ("drags", "a viscosity of its own, beside the fluid")):
            if self.state[name]:
                self.report.refuse(Place(self.path.name), name,
                                   f"{sentence}: coupled cases have none")
        if any(group != "all" for _, group in self.state["integrated"]):
            self.report.refuse(Place(self.path.name), "fix nve/sphere", "integrates a group of the "
                               "particles only; apply it to all")

    # ---- walls -----------------------------------------------------------------------------------

    def wall(self, wall):
        base = self.state["model"]
        if wall.model[:5] != base[:5]:
            self.refuse(wall.place, "fix wall/gran",
                        "walls of coupled cases have the laws of the particles")
        if wall.meshes:
            return [self.mesh(self.state["meshes"][name]) for name in wall.meshes]
        if wall.velocity:
            self.refuse(wall.place, "fix wall/gran shear",
                        "write surfaceVelocity of the patch under walls")
        axis, shape = wall.primitive[:1], wall.primitive[1:]
        if shape not in PRIMITIVES or axis not in AXES:
            self.refuse(wall.place, f"primitive {wall.primitive}", "known are xplane, xcylinder "
                        "and the same for y and z")
        axis = AXES[axis]
        if shape == "plane":
            point, radius = tuple(wall.numbers[0]*x for x in axis), 0.0
        else:
            (radius, a, b), x = wall.numbers, axis.index(1)
            point = ((0.0, a, b), (b, 0.0, a), (a, b, 0.0))[x]
        return [Wall(as_name(wall.name), shape, point, axis, radius, wall.type,
                     self.place(wall.place))]

    def mesh(self, mesh):
        if mesh.motions:
            self.refuse(mesh.motions[0].place, "fix move/mesh", "walls that move are not "
                        "translated in coupled cases; write walls { NAME { type surface; file; "
                        "motion { } } }")
        if mesh.velocity and any(mesh.velocity) or mesh.spin:
            self.refuse(mesh.place, "surface_vel", "write surfaceVelocity or surfaceRotation of "
                        "the patch under walls")
        return Wall(as_name(mesh.name), "mesh", (), (), 0.0, mesh.type, self.place(mesh.place),
                    mesh.triangles)

    # ---- laws ------------------------------------------------------------------------------------

    def types(self):
        kind, values = self.state["properties"].values.get("youngsModulus", ("", ()))
        return max(1, len(values))

    def material(self, kind):
        return "grains" if self.types() == 1 else f"type{kind}"

    def find_densities(self):
        found = {}
        for clump in (t for i in self.state["insertions"] for t in i.distribution.templates if t.shape):
            self.refuse(clump.place, "particletemplate/multisphere", "clumps of a coupled case are not translated; "
                        "write shapes in constant/demProperties")
        rows = [(t.type, t.density, t.place) for i in self.state["insertions"]
                for t in i.distribution.templates]
        p = self.state["particles"]
        rows += [(int(kind), float(density), p.place) for kind, density in zip(p.type, p.density)]
        for kind, density, place in rows:
            if found.setdefault(kind, density) != density:
                self.refuse(place, f"density {density:g}", f"particles of type {kind} have "
                            f"{found[kind]:g}, too; give them types of their own")
        if not found:
            self.report.refuse(Place(self.path.name), "insert/pack", "the script has no "
                               "particles: neither insertion nor create_atoms, nor a data or "
                               "restart file")
        return found

    def pair(self, i, j):
        """{effect: its text} of a contact of these types."""
        model = self.state["model"]
        try:
            found = laws(model, model, self.state["properties"], i, j)
        except Need as error:
            self.refuse(model.place, f"property/global {error}", error.why)
        if "hertz" in found and self.t.speed != 1:
            found["hertz"].setdefault("impactSpeed", self.t.speed)      # its default is 1 m/s
        return {name: braces(name, settings) for name, settings in found.items()}

    def add_laws(self, properties):
        given, model = self.state["properties"], self.place(self.state["model"].place)
        for name in ("youngsModulus", "poissonsRatio"):
            if not given.has(name):
                self.report.refuse(Place(self.path.name), f"property/global {name}", "is missing")
        first = next(iter(self.densities.values()))
        place = self.place(given.places["youngsModulus"])
        for kind in range(1, self.types() + 1):
            properties.add("materials", f"{self.material(kind)} {{ density "
                           f"{text(self.densities.get(kind, first))}; youngsModulus "
                           f"{text(given.value('youngsModulus', kind))}; poissonsRatio "
                           f"{text(given.value('poissonsRatio', kind))}; }}", place)
        usual = self.pair(1, 1)
        for entry in usual.values():
            properties.add("effects", entry, model)
        for i in range(1, self.types() + 1):
            for j in range(i, self.types() + 1):
                other = [entry for name, entry in self.pair(i, j).items() if entry != usual[name]]
                if other:
                    properties.add("pairs", f"types{i}and{j} {{ between ({self.material(i)} "
                                   f"{self.material(j)}); {' '.join(other)} }}", model)

    # ---- particles -------------------------------------------------------------------------------

    def add_particles(self, properties, folder):
        """`folder`: of the case, for tables."""
        frozen = not self.state["integrated"]

        def material(key):
            return self.material(key[0])

        for i in self.state["insertions"]:
            place, word = self.place(i.place), f"fix insert/{i.style}"
            if i.region is not None and not i.region.is_shape():
                self.report.refuse(place, f"region {i.region.style}", "known are block, cylinder "
                                   "and sphere")
            if i.style == "pack" and i.every == 0:
                entries = group_entries(i, i.numbers(self.report, word, self.t.box), material,
                                        frozen)
                # off the mesh's boundary: the walls are its patches
                entries = [(name, entry.replace("inside walls;", "inside mesh;"))
                           for name, entry in entries]
            elif i.style == "rate":
                amounts = {"rate": i.rate, "massRate": i.mass_rate, "count": i.count,
                           "mass": i.mass}
                entries = stream_entries(i, amounts, material, i.shape(), i.start, i.end)
            else:
                self.report.refuse(place, word, "known are insert/pack once and "
                                   "insert/rate/region; let particles enter by a stream through a "
                                   "patch")
            for name, entry in entries:
                properties.named("insert", name, entry, place)
        self.add_placed(properties, folder, frozen)
        if self.settle is not None:
            place = self.places.get("read_restart")
            properties.add("start", 'snapshot "settled.dem";', place)
            properties.add("time", f"end {text(self.settle)}; untilQuiet {{ kinetic 1e-4; "
                                   f"}}", place)
            self.report.approximated(place, "read_restart",
                                     "-settle of the solver lets the inserted particles "
                                     f"settle in the mesh, for at most {self.settle:g} s")

    def add_placed(self, properties, folder, frozen):
        """Particles of create_atoms and of data files."""
        p, still = self.state["particles"], " frozen yes;" if frozen else ""
        for kind in sorted(set(p.type.tolist())):
            of = p.type == kind
            name = f"placed{kind}"
            table = f"constant/{name}.csv"
            entries = single_particles(self.material(kind), folder/table, table, p.x[of], p.diameter[of],
                                       p.v[of], p.w[of], p.id[of])
            properties.named("insert", name, entries + still, self.place(p.place))

    def amounts(self):
        """(mean cube of the diameter, number, centre) of each group."""
        rows = []
        for i in self.state["insertions"]:
            corners = i.region.bounds() if i.region is not None else i.face.triangles.reshape(-1, 3)
            low, high = numpy.min(corners, axis=0), numpy.max(corners, axis=0)
            number = i.count if numpy.isfinite(i.count) else 1.0
            rows.append((i.distribution.mean(lambda t: 8*t.mean_cube()), number, (low + high)/2))
        p = self.state["particles"]
        rows += [(d**3, 1.0, x) for d, x in zip(p.diameter, p.x)]
        return rows

    @property
    def diameter(self):
        """Of the mean volume."""
        rows = self.particles()
        return (sum(n*cube for cube, n, _ in rows)/sum(n for _, n, _ in rows))**(1/3)

    @property
    def centre(self):
        return self.particles()[0][2]

    def particles(self):
        rows = self.amounts()
        if not rows:
            self.report.refuse(Place(self.path.name), "particles", "the script inserts none, and "
                               "names no restart file of a script that does")
        return rows
