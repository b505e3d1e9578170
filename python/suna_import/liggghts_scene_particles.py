"""liggghts_scene_particles.py -- particles of a scene: single ones, packings and streams.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os

import numpy

from .liggghts_insertion import NOW, group_entries, scatter, stream_entries
from .liggghts_mesh import write_stl
from .liggghts_particles import single_particles
from .liggghts_region import Region
from .scene_text import text


class Groups:
    """Of a SceneMaker (liggghts_scene.py)."""

    def is_frozen(self, group):
        moves = any(g in ("all", group) for _, g in self.state["integrated"])
        return not moves or any(g in ("all", group) for _, g in self.state["frozen"])

    def add_insert(self):
        if not self.restart:
            self.add_particles()
        for clump in {t.shape: t for i in self.insertions for t in i.distribution.templates if t.shape}.values():
            self.scene.add("shapes", f"{clump.shape} {{ {clump.entry()} }}", clump.place)
        for i in self.insertions:
            heat = self.state["heat"]
            i.scalars = f" temperature {text(i.temperature or heat.temperature)};" if heat else ""
            if i.region is not None:
                i.region = self.clipped(i.region)
            if i.style == "pack":
                self.add_packing(i)
            elif i.end > self.start:
                self.add_stream(i)

    def member(self, group):
        """Which single particles are in a group."""
        p = self.particles
        return numpy.ones(len(p), bool) if group == "all" else numpy.isin(
            p.id, self.state["groups"].get(group, ()))

    def states(self):
        """Velocity and spin of the single particles, which are driven, which frozen."""
        p, none = self.particles, numpy.zeros(len(self.particles), bool)
        integrated, frozen = (numpy.any([none, *(self.member(g) for _, g in self.state[name])], axis=0)
                              for name in ("integrated", "frozen"))
        v, w, moves = p.v.copy(), p.w, (p.v != 0).any(axis=1) | (p.w != 0).any(axis=1)
        driven = frozen & integrated & moves        # without force, a particle keeps its velocity
        for g, speed in self.state["driven"].values():
            which = self.member(g)
            driven |= which
            v[which] = speed
        if (moves & ~integrated & ~driven).any():
            self.refuse(p.place, "velocity", "particles that no fix integrates have a velocity, which contacts of "
                        "LIGGGHTS feel; set it to 0, or drive them by fix move linear")
        return v, w, driven, (frozen | ~integrated) & ~driven

    def add_particles(self):
        p = self.particles
        v, w, driven, frozen = self.states()
        rows = sorted(set(zip(p.type, p.density, frozen, driven)))
        for k, (kind, density, still, pushed) in enumerate(rows):
            which = (p.type == kind) & (p.density == density) & (frozen == still) & (
                driven == pushed)
            self.write_particles(f"particles{k + 1 if len(rows) > 1 else ''}", p.x[which],
                                 p.diameter[which], numpy.where(still, 0.0, v[which]),
                                 numpy.where(still, 0.0, w[which]), p.id[which],
                                 self.material(int(kind), float(density)),
                                 (" frozen yes;" if still else "") +
                                 (" driven yes;" if pushed else ""), p.place,
                                 self.temperatures(p.temperature[which]))

    def temperatures(self, own):
        """Of single particles: their own ones or the initial one; None without heat."""
        heat = self.state["heat"]
        return None if heat is None else numpy.where(own > 0, own, heat.temperature)

    def write_particles(self, name, x, d, v, w, id, material, more, place, temperature=None):
        path = self.new_file(name + ".csv")
        body = single_particles(material, path, os.path.relpath(path), x, d, v, w, id, temperature)
        self.scene.named("insert", name, body + more, place)

    def add_packing(self, i):
        if self.is_frozen(i.group) and (i.velocity.any() or i.spin.any() or i.start > self.start):
            self.refuse(i.place, "insert/pack", "frozen particles of Suna are at rest, and there at the beginning; leave "
                        "out vel, omega and start, or read them from a data file (read_data)")
        if any(g in ("all", i.group) for g, _ in self.state["driven"].values()):
            self.refuse(i.place, "fix move", "drives particles of create_atoms and read_data only; give the group in "
                        "the scene driven yes and its velocity")
        numbers = i.numbers(self.report, "insert/pack", self.box)
        number = sum(numbers)
        if i.start <= self.start and not self.restart:
            self.add_packing_at_start(i, numbers)
        elif i.start >= self.start:
            self.add_packing_later(i, number)
        if i.every and i.end > self.start + i.every and i.region.is_shape():
            self.add_refill(i, number)

    def add_packing_at_start(self, i, numbers):
        if not i.region.is_shape():
            self.scatter(i, sum(numbers))
            return
        for name, body in group_entries(i, numbers, self.of_key, self.is_frozen(i.group)):
            self.scene.named("insert", name, body, i.place)

    def add_packing_later(self, i, number):
        if not i.region.is_shape():
            self.refuse(i.place, f"region {i.region.style}", "a packing that begins during a run "
                        "needs a block, cylinder or sphere")
        self.add_streams(i, {"rate": NOW, "count": number}, i.shape(), i.start, math.inf)
        self.report.approximated(i.place, "insert/pack", "during a run: a stream that is due at "
                                 "once; random positions fill up to a third of the region, what "
                                 "does not fit waits for space")

    def add_refill(self, i, number):
        """The packings after the first: a stream with their mean rate."""
        gravity = numpy.zeros(3) if self.state["gravity"] is None else self.state["gravity"][0]
        rate = i.refill_rate(number, gravity)
        events = math.ceil((min(i.end, self.end) - i.start)/i.every - 1e-9) - 1
        if events <= 0:
            return
        if rate <= 0:
            self.report.approximated(i.place, "insert/pack insert_every", "only once: nothing "
                                     "moves the particles out of the region")
            return
        self.report.approximated(
            i.place, "insert/pack insert_every",
            f"{number} at once, then {rate:.4g} 1/s as a stream: what leaves the region in "
            f"{i.every:.4g} s. LIGGGHTS fills it {events} times more and stops when the region "
            "is full; the stream goes on into free space")
        self.add_streams(i, {"rate": rate}, i.shape(), i.start + i.every, self.end_of(i), k0=1)

    def add_streams(self, i, amounts, where, start, end, k0=0):
        for name, body in stream_entries(i, amounts, self.of_key, where, start, end, k0):
            self.scene.named("insert", name, body, i.place)

    def end_of(self, i):
        return i.end if i.end < self.end else math.inf

    def scatter(self, i, number):
        if i.has_clumps():
            self.refuse(i.place, f"region {i.region.style}", "clumps are inserted in a block, cylinder or sphere; use "
                        "one of these")
        placed = scatter(i, number)
        if len(placed) < number:
            self.report.approximated(i.place, "insert/pack",
                                     f"{len(placed)} of {number} spheres found a position in "
                                     f"{i.region.style}")
        else:
            self.report.translated(i.place, "insert/pack",
                                   f"placed by the importer in {i.region.style}")
        first = 1 + int(self.particles.id.max()) if len(self.particles) else 1
        for key in sorted({key for _, _, key in placed}):
            rows = [(x, r) for x, r, other in placed if other == key]
            x, n = numpy.array([row[0] for row in rows]), len(rows)
            still = self.is_frozen(i.group)
            v = numpy.zeros((n, 3)) if still else numpy.broadcast_to(i.velocity, (n, 3))
            self.write_particles(i.name, x, numpy.array([2*row[1] for row in rows]), v,
                                 numpy.broadcast_to(i.spin, (n, 3)), numpy.arange(first, first + n),
                                 self.of_key(key), " frozen yes;" if still else "", i.place,
                                 self.temperatures(numpy.full(n, i.temperature)))
            first += n

    def add_stream(self, i):
        if self.is_frozen(i.group):
            self.refuse(i.place, f"insert/{i.style}",
                        "no fix nve/sphere integrates these particles, but particles of a stream move in Suna")
        amounts = {"rate": i.rate, "massRate": i.mass_rate, "count": i.count, "mass": i.mass}
        where = i.shape() if i.face is None else self.surface(i)
        self.add_streams(i, amounts, where, i.start, self.end_of(i))

    def surface(self, i):
        """The face that a stream enters through."""
        path, scale = i.face.path, i.face.scale
        if i.face.transformed:
            path, scale = self.new_file(f"{i.face.name}.stl"), 1.0
            write_stl(path, i.face.triangles)
        if not i.velocity.any():
            self.refuse(i.place, "vel",
                        "particles that enter through a face need a velocity; give vel constant")
        return f'surface "{os.path.relpath(path)}";' + \
            (f" scale {text(scale)};" if scale != 1 else "")

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
