"""liggghts_insertion.py -- templates, distributions and insertion of LIGGGHTS as groups and
streams.

    insert/pack at the start, once       a group of type random: count, mass or solid fraction
    insert/pack later, once              a stream that is due at once, with a limit of count or mass
    insert/pack every k steps            the first packing, then a stream with the mean rate below
    insert/stream                        a stream through the face (surface)
    insert/rate/region                   a stream in the region

Weights of particledistribution/discrete are by mass, of /numberbased by number; they are converted
with the mean mass of each template. One material of Suna has one density, so a distribution over
several types or densities becomes several groups, each with its fraction.

A packing repeated every T refills what has left the region, at most all of it: with speed v and
acceleration g along the way of length H the mean rate is N min(1, (v T + g T^2/2)/H)/T.

LIGGGHTS places at random without pushing and gives up after a number of trials: a packing has as
many spheres as it would have placed (liggghts_packing.py).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
from dataclasses import dataclass, field

import numpy

from .liggghts_packing import SAFE, count_placed
from .scene_text import text, vector

BINS = 20               # of a continuous distribution in a mixture
TRIALS = 400            # of a sphere that the importer places
MOST_FILLED = 100       # volume of the spheres over the region: more is a mistake
NOW = 1e9               # 1/s, rate of a packing that is due at once


class Base:
    """The words that all templates share: atom type and density."""

    def __init__(self, t):
        self.t, self.type, self.density = t, 1, t.units.si("density", 1.0)

    def others(self, rest):
        """The other words, each with the list of those behind it, from which the caller takes what belongs to it."""
        while rest:
            key = rest.pop(0)
            if not self.takes(key, rest):
                yield key, rest

    def takes(self, key, rest):
        """Is it one of them? Then its value is taken from `rest`."""
        if key in ("atom_type", "material"):
            self.type = self.t.atom_type(rest.pop(0))
        elif key == "density":
            if rest[0] != "constant":
                self.t.refuse("a material has one density; write constant", f"density {rest[0]}")
            self.density = self.t.positive(rest[1], "density")
            del rest[:2]
        else:
            return False
        return True


@dataclass
class Template:
    type: int
    density: float
    style: str              # constant, uniform, gaussian, lognormal
    radius: tuple           # of the style
    place: object
    shape: str = ""         # of a clump: liggghts_clumps.py

    def mean_cube(self):
        """E[r^3]"""
        a = self.radius
        return {"constant": lambda: a[0]**3,
                "uniform": lambda: (a[1]**4 - a[0]**4)/(4*(a[1] - a[0])),
                "gaussian": lambda: a[0]*(a[0]**2 + 3*a[1]**2),
                "lognormal": lambda: math.exp(3*a[0] + 4.5*a[1]**2)}[self.style]()

    def volume(self):
        return 4/3*math.pi*self.mean_cube()

    def mass(self):
        return self.density*self.volume()

    def range(self):
        a = self.radius
        return {"constant": lambda: (a[0], a[0]), "uniform": lambda: a,
                "gaussian": lambda: (a[0] - 3*a[1], a[0] + 3*a[1]),
                "lognormal": lambda: (math.exp(a[0] - 3*a[1]),
                                      math.exp(a[0] + 3*a[1]))}[self.style]()

    def draw(self, random, n):
        """Radii."""
        a, (low, high) = self.radius, self.range()
        if self.style == "constant":
            return numpy.full(n, a[0])
        if self.style == "uniform":
            return random.uniform(a[0], a[1], n)
        r = random.normal(a[0], a[1], n) if self.style == "gaussian" else random.lognormal(a[0],
                                                                                           a[1], n)
        return numpy.clip(r, low, high)


@dataclass
class Distribution:
    templates: list
    weights: list           # by number, sum 1

    def by_material(self):
        """(type, density), its fraction of the number, its part of the distribution."""
        found = {}
        for template, weight in zip(self.templates, self.weights):
            found.setdefault((template.type, template.density, template.shape), []).append((template, weight))
        return [(key[:2], sum(w for _, w in rows), Distribution(
            [t for t, _ in rows], [w for _, w in rows])) for key, rows in found.items()]

    def by_size(self):
        """by_material with each template apart, the largest first: their numbers are exact, as in
        LIGGGHTS."""
        order = sorted(range(len(self.weights)), key=lambda k: -self.templates[k].mean_cube())
        return [((self.templates[k].type, self.templates[k].density), self.weights[k],
                 Distribution([self.templates[k]], [self.weights[k]])) for k in order]

    def mean(self, of):
        return sum(w*of(t) for t, w in zip(self.templates, self.weights))/sum(self.weights)

    def largest(self):
        return max(t.range()[1] for t in self.templates)

    def sizes(self):
        """Entries of a group."""
        if self.templates[0].shape:
            return f"shape {self.templates[0].shape};"
        if all(t.style == "constant" for t in self.templates):
            if len({t.radius for t in self.templates}) == 1:
                return f"diameter {text(2*self.templates[0].radius[0])};"
            rows = [(2*t.radius[0], w) for t, w in zip(self.templates, self.weights)]
        elif len(self.templates) == 1:
            t, a = self.templates[0], self.templates[0].radius
            return "sizes { " + {
                "uniform": f"type uniform; min {text(2*a[0])}; max {text(2*a[1])};",
                "gaussian": f"type normal; mean {text(2*a[0])}; deviation {text(2*a[1])};",
                "lognormal": f"type logNormal; median {text(2*math.exp(a[0]))}; "
                f"deviation {text(a[1])};",
            }[t.style] + " by number; }"
        else:
            rows = []
            for t, w in zip(self.templates, self.weights):
                many = 1 if t.style == "constant" else BINS
                r = numpy.sort(t.draw(numpy.random.default_rng(1), 1000*many)
                               ).reshape(many, -1).mean(axis=1)
                rows += [(2*x, w/many) for x in r]
        return (f"sizes {{ type list; by number; diameters ({' '.join(text(d) for d, _ in rows)}); "
                f"weights ({' '.join(text(w) for _, w in rows)}); }}")

    def draw(self, random, n):
        """Radii, and (type, density) of each."""
        which = random.choice(len(self.weights), n, p=numpy.array(self.weights)/sum(self.weights))
        r = numpy.empty(n)
        for k, t in enumerate(self.templates):
            r[which == k] = t.draw(random, int((which == k).sum()))
        return r, [(self.templates[k].type, self.templates[k].density) for k in which]


@dataclass
class Insertion:
    """A fix insert/..., in SI and s."""
    fix: str
    name: str                       # in the scene
    style: str                      # pack, stream, rate
    group: str
    distribution: Distribution
    place: object
    start: float
    end: float = math.inf
    every: float = 0.0              # 0: once
    every_steps: float = 0.0        # in steps of `step`, as long as this is None
    start_step: float = None
    step: float = None              # s, at the first run
    seed: int = 1
    velocity: numpy.ndarray = field(default_factory=lambda: numpy.zeros(3))
    spread: numpy.ndarray = field(default_factory=lambda: numpy.zeros(3))
    spin: numpy.ndarray = field(default_factory=lambda: numpy.zeros(3))
    region: object = None
    face: object = None             # a mesh
    count: float = math.inf
    mass: float = math.inf
    fraction: float = 0.0           # of the region's volume
    rate: float = 0.0               # 1/s
    mass_rate: float = 0.0          # kg/s
    all_in: bool = False
    tries: int = 50                 # maxattempt: trials for each sphere of a packing
    off_border: bool = True         # a radius away from the faces of the box
    limits: numpy.ndarray = None    # of the domain, low and high; infinite where it grows
    temperature: float = 0.0        # K; 0: as in fix heat/gran
    scalars: str = ""               # entries of particle scalars
    orientation: str = " orientation (1 0 0 0);"        # of clumps

    # ---- amounts ---------------------------------------------------------------------------------

    def numbers(self, report, word, box):
        """Particles of a packing of each size (by_size), as many as LIGGGHTS can place in its
        `box`."""
        if not numpy.isfinite(self.region.bounds()).all():
            report.refuse(self.place, f"region {self.region.style}", "has no limits; intersect it with a block")
        one, space = self.distribution.mean(Template.volume), self.region.volume()
        n = self.count
        if self.fraction:
            n = self.fraction*space/one
        elif math.isinf(n):
            n = self.mass/self.distribution.mean(Template.mass)
        if not 0 < n*one < MOST_FILLED*space:
            report.refuse(self.place, word, f"{n:.4g} spheres of {one:.4g} m3 in a region of "
                          f"{space:.4g} m3; check the amount, the radius and the region")
        parts = self.distribution.by_size()
        wanted = split(max(1, round(n)), [share for _, share, _ in parts])
        if n*one < SAFE*space or self.has_clumps():
            return wanted
        radii = [part.mean(Template.mean_cube)**(1/3) for _, _, part in parts]
        corners = None if box is None or not self.off_border else numpy.array(box).T
        placed = count_placed(wanted, radii, self.region, self.all_in, self.tries, corners)
        if sum(placed) < sum(wanted):
            if not sum(placed):
                report.refuse(self.place, word, "no sphere fits into the region")
            report.approximated(
                self.place, word, f"{sum(wanted)} spheres fill {n*one/space:.2f} of the region. "
                f"LIGGGHTS gives up after {self.tries} trials for each, with about {sum(placed)} "
                "spheres in place, the largest ones first: these are inserted; give count in the "
                "scene for all of them (up to a solid fraction of 0.55)")
        return placed

    def has_clumps(self):
        return any(t.shape for t in self.distribution.templates)

    def refill_rate(self, number, gravity):
        """1/s, see the head of this file."""
        speed, g = numpy.linalg.norm(self.velocity), numpy.linalg.norm(gravity)
        along = self.velocity if speed > 0 else gravity
        size = numpy.linalg.norm(along)
        if size == 0:
            return 0.0
        along = along/size
        t = self.every
        way = speed*t + max(0.0, float(gravity @ along) if g else 0.0)*t*t/2
        return number*min(1.0, way/self.region.extent(along))/t

    # ---- entries of the scene --------------------------------------------------------------------

    def motion(self):
        found = self.orientation if self.has_clumps() else ""
        if self.velocity.any():
            found += f" velocity {vector(self.velocity)};"
        if self.spin.any():
            found += f" spin {vector(self.spin)};"
        return found

    def shape(self):
        """Entries of the region; spheres that may stick out have room for it, but not in walls, nor outside
        the domain."""
        if self.all_in or self.region.thickness() > 2*self.distribution.largest()*4:
            return self.region.entries()
        return self.region.entries(self.distribution.largest(), self.limits)



def split(total, shares):
    """Whole numbers with the sum `total`, in proportion to the shares."""
    ends = numpy.round(numpy.cumsum(shares)/sum(shares)*total).astype(int)
    return numpy.diff(numpy.concatenate([[0], ends]))


def group_entries(insertion, numbers, material_of, frozen):
    """(name, text) of the groups of a packing at the start; `numbers`: of each size."""
    parts = insertion.distribution.by_size()
    found = []
    state = " frozen yes;" if frozen else insertion.motion()
    for k, (n, (key, _, part)) in enumerate(zip(numbers, parts)):
        if n:
            found.append((insertion.name,
                          f"type random; count {n}; material {material_of(key)}; {part.sizes()} "
                          f"{insertion.shape()} inside walls; seed {insertion.seed % 1000003 + k};"
                          f"{state}{insertion.scalars}"))
    return found


def stream_entries(insertion, amounts, material_of, where, start, end, k0=0):
    """(name, text) of streams. `amounts`: rate or massRate, count or mass limit."""
    parts = insertion.distribution.by_material()
    total_mass = sum(share*part.mean(Template.mass) for _, share, part in parts)
    found = []
    for k, (key, share, part) in enumerate(parts):
        by_mass = share*part.mean(Template.mass)/total_mass
        words = []
        for name, value in amounts.items():
            if math.isfinite(value) and value > 0:
                value *= by_mass if name in ("massRate", "mass") else share
                words.append(f"{name} {max(1, round(value)) if name == 'count' else text(value)};")
        found.append((insertion.name + ("_refill" if k0 else ""),
                      f"type stream; {' '.join(words)} material {material_of(key)}; "
                      f"{part.sizes()} {where}{insertion.motion()}{insertion.scalars}" +
                      (f" spread {vector(insertion.spread)};" if insertion.spread.any() else "") +
                      (f" start {text(start)};" if start > 0 else "") +
                      (f" end {text(end)};" if math.isfinite(end) else "")
                      + f" seed {insertion.seed % 1000003 + k + 17*k0};"))
    return found


def scatter(insertion, number):
    """Positions without overlap in any region, radii, (type, density) of each: random sequential
    addition, the largest first."""
    random = numpy.random.default_rng(insertion.seed)
    r, keys = insertion.distribution.draw(random, number)
    order = numpy.argsort(-r, kind="stable")
    low, high = insertion.region.bounds()
    cell = 2*r.max()
    grid, placed = {}, []
    directions = numpy.array([[x, y, z] for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)
                              if x or y or z], float)
    directions /= numpy.linalg.norm(directions, axis=1)[:, None]
    for k in order:
        points = random.uniform(low, high, (TRIALS, 3))
        points = points[insertion.region.contains(points)]
        for x in points:
            if insertion.all_in and not insertion.region.contains(x + r[k]*directions).all():
                continue
            at = numpy.floor(x/cell).astype(int)
            near = [p for dx in (-1, 0, 1) for dy in (-1, 0, 1) for dz in (-1, 0, 1)
                    for p in grid.get((at[0] + dx, at[1] + dy, at[2] + dz), ())]
            if all(((x - y)**2).sum() >= (r[k] + s)**2 for y, s in near):
                grid.setdefault(tuple(at), []).append((x, r[k]))
                placed.append((x, r[k], keys[k]))
                break
    return placed
