"""scene.py -- a scene of spheres and planes in code-independent form, and the results of a run.

    s = Scene(step=1e-6, end=0.01, every=1e-4, friction=0.5, gravity=(0, 0, -9.81))
    s.grain(2e-3, (0, 0, 1.1e-3), v=(0, 0, -1))       its number is its index in s.grains
    s.plane("z", 0.0, +1)                             grains are above z = 0
    run = programs.PEERS["yade"].run(s, folder)
    run.frames[k].time, .grains[number].x .v .w .f    f: sum of all forces [N], weight included

Laws: "hertz" is Hertz and Mindlin with viscous damping for a restitution; "hysteresis" is Walton
and Braun's with linear springs. Settings for one code only are in `more`, {program: its text}. All
in SI units.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import math
import os

Grain = collections.namedtuple("Grain", "diameter density x v w fixed")
Plane = collections.namedtuple("Plane", "axis at side sway rigid")
# a sin(2 pi f t), a vector
Sway = collections.namedtuple("Sway", "amplitude frequency")
Seen = collections.namedtuple("Seen", "x v w f")
AXES = {"x": 0, "y": 1, "z": 2}


class Scene:
    """step, end, every: seconds; box: (low, high) of a domain, periodic along its axes where
    `periodic` names them."""

    def __init__(self, **k):
        self.step, self.end, self.every = k.pop("step"), k.pop("end"), k.pop("every")
        self.young, self.poisson = k.pop("young", 1e7), k.pop("poisson", 0.3)
        self.restitution, self.friction = k.pop("restitution", 0.9), k.pop("friction", 0.3)
        self.law, self.spring = k.pop("law", "hertz"), k.pop("spring", {})
        self.gravity, self.periodic, self.box = k.pop("gravity", (0.0, 0.0, 0.0)), k.pop("periodic",
            ""), k.pop("box", None)
        self.rolling, self.viscous, self.ranks, self.more = k.pop("rolling", None), k.pop("viscous",
            0.0), k.pop("ranks", 1), k.pop("more", {})
        self.impact = k.pop("impact", 1.0)                  # m/s, for springs that need it
        self.grains, self.planes, self.triangles = [], [], []
        if k:
            raise TypeError("a scene has no %s" % ", ".join(k))

    @property
    def steps(self):
        return round(self.end/self.step)

    @property
    def looks(self):
        """Steps between two frames."""
        return max(1, round(self.every/self.step))

    def grain(self, diameter, x, v=(0.0, 0.0, 0.0), w=(0.0, 0.0, 0.0), density=2500.0, fixed=False):
        self.grains.append(Grain(diameter, density, tuple(map(float, x)), tuple(map(float, v)),
                                 tuple(map(float, w)), fixed))

    def plane(self, axis, at, side, sway=None, rigid=False):
        self.planes.append(Plane(axis, at, side, sway, rigid))

    def mass(self, number):
        g = self.grains[number]
        return g.density*math.pi/6.0*g.diameter**3

    def domain(self, margin=5e-3):
        """Bounds of the scene: the box, or the region of the trajectories."""
        if self.box:
            return self.box
        reach = max((max(map(abs, g.v)) for g in self.grains),
                    default=0.0)*self.end + 0.5*9.81*self.end**2*any(self.gravity)
        reach = margin + min(reach, 0.3) + max(g.diameter for g in self.grains)
        return (tuple(min(g.x[a] for g in self.grains) - reach for a in range(3)),
                tuple(max(g.x[a] for g in self.grains) + reach for a in range(3)))


class Frame:
    def __init__(self, time, grains):
        self.time, self.grains = time, grains

    def kinetic(self, scene):
        return sum(0.5*scene.mass(k)*(dot(g.v, g.v) + 0.1*scene.grains[k].diameter**2*dot(g.w, g.w))
                   for k, g in self.grains.items()
                   if not scene.grains[k].fixed)


class Run:
    """status 0 for a run that ended properly; said: all that the program printed; frames."""

    def __init__(self, status, said, frames):
        self.status, self.said, self.frames = status, said, frames
        self.last = frames[-1] if frames else None

    def complaint(self):
        """The line with the error, for the column `how`."""
        lines = [line.strip() for line in self.said.splitlines() if line.strip()]
        for word in ("ERROR:", "ERROR", "Error", "what():", "dem:"):
            for line in lines:
                if line.startswith(word):
                    return line[:150]
        return lines[-1][:150] if lines else "no word"

    def finite(self):
        return bool(self.frames) and all(abs(c) < 1e300 for f in self.frames
                                         for g in f.grains.values() for c in g.x + g.v)


def read_dump(path, step):
    """Frames of a dump with rows id x y z vx vy vz wx wy wz fx fy fz, the format of LAMMPS and
    LIGGGHTS; ids from 1."""
    frames, rows, time = [], None, 0.0
    if not os.path.exists(path):
        return frames
    with open(path) as file:
        lines = iter(file)
        for line in lines:
            if line.startswith("ITEM: TIMESTEP"):
                time, rows = float(next(lines))*step, {}
                frames.append(Frame(time, rows))
            elif rows is not None and not line.startswith("ITEM") and len(line.split()) == 13:
                n = [float(word) for word in line.split()]
                rows[int(n[0]) - 1] = Seen(tuple(n[1:4]), tuple(n[4:7]), tuple(n[7:10]),
                                           tuple(n[10:13]))
    return frames


def dot(a, b):
    return sum(x*y for x, y in zip(a, b))


def size(a):
    return dot(a, a)**0.5
