"""simulation.py -- a simulation of the core: scene, advance, particles as numpy arrays.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import signal
import threading
from pathlib import Path

import numpy

from ._library import ffi, lib
from .files import write_vtp


class SunaError(Exception):
    """What the core refuses or cannot do: its sentence."""


# entries of a scene that belong to the program dem
PROGRAM = ("time/end", "time/untilQuiet", "time/pauseAtRest", "time/maxCreated", "write", "coupling",
           "accuracy")


def check(status):
    if status:
        raise SunaError(ffi.string(lib.dem_error_text()).decode())


def as_text(value):
    """A value of an entry in the dictionary syntax: yes and no, vectors in brackets."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, str):
        return value
    if isinstance(value, Path):
        return f'"{value}"'
    if numpy.iterable(value):
        return "(" + " ".join(as_text(x) for x in value) + ")"
    return repr(float(value)) if isinstance(value, (float, numpy.floating)) else str(value)


def as_scene(entries, indent=""):
    """A dict as text: a dict in it is a group, all else an entry. Text stays as it is, so that a
    file name needs its quotation marks: '"wall.stl"'."""
    lines = []
    for name, value in entries.items():
        if isinstance(value, dict):
            lines += [f"{indent}{name}", indent + "{", as_scene(value, indent + "    ") +
                      indent + "}"]
        else:
            lines.append(f"{indent}{name} {as_text(value)};")
    return "".join(line + "\n" for line in lines)


def column(pointer, n, width=1, stride=None, owner=None):
    """Numbers of the library as a read-only array n or n x width, without a copy."""
    kind = {"double": numpy.float64, "int64_t": numpy.int64,
            "uint16_t": numpy.uint16}[re.match(r"(\w+)", ffi.typeof(pointer).item.cname)[0]]
    size = numpy.dtype(kind).itemsize
    stride = stride or width*size
    if n == 0 or pointer == ffi.NULL:
        return numpy.empty((0, width) if width > 1 else 0, kind)
    raw = numpy.frombuffer(ffi.buffer(pointer, (n - 1)*stride + width*size), numpy.uint8)
    array = numpy.ndarray((n, width) if width > 1 else (n,), kind, raw,
                          strides=(stride, size) if width > 1 else (stride,))
    array.flags.writeable = False
    return array


class Wall:
    """A wall of the scene; forces are those of the particles on it."""

    def __init__(self, simulation, number):
        self._simulation, self._number = simulation, number
        self.name = ffi.string(lib.dem_wall_name(simulation._d, number)).decode()

    def _pair(self, call):
        simulation = self._simulation
        one, other = ffi.new("double[3]"), ffi.new("double[3]")
        check(call(simulation._d, self._number, one, other))
        return numpy.array(list(one)), numpy.array(list(other))

    @property
    def load(self):
        """Present force [N] and torque about the origin [N m]. Collective."""
        return self._pair(lib.dem_wall_load)

    @property
    def impulse(self):
        """Impulse [N s] and its moment about the origin [N m s] since reset_impulses. Collective."""
        return self._pair(lib.dem_wall_impulse)

    @property
    def corners(self):
        """Corners of its triangles, n x 3 x 3 [m], on the first rank; none of planes, cylinders,
        spheres. Collective."""
        info = ffi.new("struct dem_wall_info *")
        lib.dem_wall_info(self._simulation._d, self._number, info)
        corners = numpy.empty((info.triangles, 3, 3))
        check(lib.dem_wall_corners(self._simulation._d, self._number,
                                   ffi.cast("double *", corners.ctypes.data)))
        return corners

    def __repr__(self):
        return f"Wall({self.name!r})"


class Simulation:
    """A simulation.

    scene         text in the dictionary syntax, a dict, or the path of a file
    settings      entries to override, {"effects/dry/restitution": 0.9}
    start         a snapshot to go on from
    comm          a communicator of mpi4py; without one a single rank without MPI
    energy        keep the energy balance
    orientation   integrate the orientation of particles
    virial        keep contact forces for the property virial
    without       an effect to leave out

    Particles may be added (add_particles, add_wall) until the first use of anything else, which
    sets the simulation up. Arrays are views into the core: read-only, of this rank's particles, and
    valid until the next call that advances or changes the simulation; copy what is to be kept.
    """

    def __init__(self, scene, settings=None, start=None, comm=None, energy=False,
                 orientation=False, virial=False, without=None):
        out = ffi.new("struct dem **")
        self._d = None
        check(lib.dem_create_fortran(out, -1 if comm is None else comm.py2f()))
        self._d, self._ready, self._keep = out[0], False, []
        try:
            self._read(scene)
            for path, value in (settings or {}).items():
                check(lib.dem_set(self._d, path.encode(), as_text(value).encode()))
            for path in PROGRAM:
                lib.dem_scene_skip(self._d, path.encode())
            if without is not None:
                check(lib.dem_remove_effect(self._d, without.encode()))
            if start is not None:
                check(lib.dem_load(self._d, os.fspath(start).encode()))
            if energy:
                check(lib.dem_energy_enable(self._d))
            if orientation:
                check(lib.dem_orientation_enable(self._d))
            if virial:
                check(lib.dem_virial_enable(self._d))
        except BaseException:
            self.close()
            raise

    def _read(self, scene):
        if isinstance(scene, dict):
            scene = as_scene(scene)
        path = os.fspath(scene)
        if "{" in path or ";" in path:
            check(lib.dem_scene_text(self._d, path.encode(), b"scene"))
        else:
            check(lib.dem_scene_file(self._d, path.encode()))

    def close(self):
        """Free the core's memory. Collective with a communicator."""
        if self._d is not None:
            lib.dem_free(self._d)
        self._d = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        # at the end of the interpreter MPI may be gone
        if getattr(self, "_d", None) is not None and lib is not None:
            self.close()

    # ---- before the set-up -----------------------------------------------------------------------

    def add_particles(self, position, diameter, material, velocity=0.0, spin=0.0, id=None,
                      frozen=False):
        """Add particles; each argument is one value for all or an array. The same on all ranks."""
        self._not_yet("add_particles")
        position = numpy.atleast_2d(numpy.asarray(position, float))
        n = len(position)
        particles = ffi.new("struct dem_new_particle[]", n)
        names = [ffi.new("char[]", name.encode())
                 for name in numpy.broadcast_to(numpy.asarray(material, object), n)]
        v = numpy.broadcast_to(numpy.asarray(velocity, float), (n, 3))
        w = numpy.broadcast_to(numpy.asarray(spin, float), (n, 3))
        d = numpy.broadcast_to(numpy.asarray(diameter, float), n)
        ids = numpy.broadcast_to(-1 if id is None else numpy.asarray(id), n)
        held = numpy.broadcast_to(frozen, n)
        for k, p in enumerate(particles):
            p.position, p.velocity, p.spin = list(position[k]), list(v[k]), list(w[k])
            p.diameter, p.id, p.material, p.frozen = d[k], int(ids[k]), names[k], bool(held[k])
        check(lib.dem_add_particles(self._d, n, particles))

    def add_wall(self, name, material, triangles):
        """Add a wall of triangles, n x 3 x 3 [m]. Collective."""
        self._not_yet("add_wall")
        triangles = numpy.ascontiguousarray(triangles, float).reshape(-1, 9)
        check(lib.dem_add_wall(self._d, name.encode(), material.encode(), len(triangles),
                               ffi.cast("double *", triangles.ctypes.data)))

    def _not_yet(self, what):
        if self._ready:
            raise SunaError(f"{what}: the simulation is set up already; call it before anything "
                            "that looks at particles or advances")

    def value(self, path):
        """Text of an entry of the scene, "time/end"; None where there is none."""
        text = lib.dem_scene_value(self._d, path.encode())
        return None if text == ffi.NULL else ffi.string(text).decode()

    def names(self, path=""):
        """Names of the entries of a group of the scene"""
        found, k = [], 0
        while (name := lib.dem_scene_name(self._d, path.encode(), k)) != ffi.NULL:
            found.append(ffi.string(name).decode())
            k += 1
        return found

    def setup(self):
        """Insert the particles and check all. Called by itself at first use. Collective."""
        if not self._ready:
            check(lib.dem_setup(self._d))
            self._ready = True
        return self

    @property
    def _set(self):
        return self.setup()._d

    # ---- advance ---------------------------------------------------------------------------------

    def advance(self, duration, progress=None, every=1.0):
        """Advance by a duration [s]. progress(time, steps) is called once in `every` seconds. Ctrl-C
        ends it after the present step. Collective."""
        d = self._set
        if progress is not None:
            call = ffi.callback("void(void *, double, int64_t)",
                                lambda _, time, steps: progress(time, steps))
            lib.dem_set_progress(d, every, call, ffi.NULL)
        with interrupt() as asked:
            lib.dem_set_stop_flag(d, asked)
            try:
                check(lib.dem_advance(d, duration))
                if lib.dem_stopped(d):
                    raise KeyboardInterrupt
            finally:
                lib.dem_set_stop_flag(d, ffi.NULL)
                if progress is not None:
                    lib.dem_set_progress(d, every, ffi.NULL, ffi.NULL)
        return self

    # ---- particles -------------------------------------------------------------------------------

    @property
    def _view(self):
        view = ffi.new("struct dem_view *")
        lib.dem_view(self._set, view)
        return view

    def _column(self, name, width=1, strided=True):
        view = self._view
        return column(getattr(view, name), view.n, width, view.stride if strided else None)

    @property
    def position(self):
        """n x 3 [m]"""
        return self._column("position", 3)

    @property
    def velocity(self):
        """n x 3 [m/s]"""
        return self._column("velocity", 3)

    @property
    def spin(self):
        """n x 3 [1/s]"""
        return self._column("spin", 3)

    @property
    def radius(self):
        """[m]"""
        return self._column("radius")

    @property
    def mass(self):
        """[kg]"""
        return self._column("mass")

    @property
    def id(self):
        return self._column("id")

    @property
    def frozen(self):
        return (self._column("flags") & 1).astype(bool)

    @property
    def force(self):
        """of contacts, n x 3 [N]"""
        return self._column("force", 3, False)

    @property
    def torque(self):
        """of contacts, n x 3 [N m]"""
        return self._column("torque", 3, False)

    @property
    def orientation(self):
        """unit quaternions, n x 4; needs orientation=True"""
        return self._column("orientation", 4, False)

    @property
    def scalars(self):
        """names of the particle scalars that the effects of the scene declare"""
        return [self._scalar_info(k)["name"] for k in range(lib.dem_scalar_count(self._set))]

    def _scalar_info(self, k):
        info = ffi.new("struct dem_scalar_info *")
        lib.dem_scalar_info(self._set, k, info)
        return {"name": ffi.string(info.name).decode(), "unit": ffi.string(info.unit).decode()}

    def scalar(self, name):
        """a particle scalar, e.g. "temperature": a view, which may be written between two advances"""
        k = lib.dem_scalar_index(self._set, name.encode())
        if k < 0:
            raise KeyError(f"no effect of the scene has the particle scalar {name}; it has "
                           + (", ".join(self.scalars) or "none"))
        values = column(lib.dem_scalar(self._set, k), len(self))
        values.flags.writeable = True
        return values

    @property
    def material(self):
        """names"""
        numbers = self._column("material")
        names = {k: ffi.string(lib.dem_material_name(self._d, int(k))).decode()
                 for k in numpy.unique(numbers)}
        return numpy.array([names[k] for k in numbers], object)

    def __len__(self):
        return self._view.n

    # ---- queries ---------------------------------------------------------------------------------

    @property
    def totals(self):
        """Sums over all particles and contacts, as a dict. Collective; resets largest_overlap."""
        totals = ffi.new("struct dem_totals *")
        check(lib.dem_totals(self._set, totals))
        return {name: numpy.array(list(value)) if isinstance(value, ffi.CData) else value
                for name, value in ((name, getattr(totals, name))
                                    for name, _ in ffi.typeof("struct dem_totals").fields)}

    @property
    def time(self):
        """[s]. Collective."""
        return self.totals["time"]

    @property
    def step(self):
        """The time step in use [s], its limit [s], and what sets that"""
        step = lib.dem_step_limit(self._set)
        return step.used, step.limit, ffi.string(step.why).decode()

    @property
    def energy(self):
        """Terms of the energy balance [J], as a dict; needs energy=True. Collective."""
        since, n = ffi.new("double *"), ffi.new("int *")
        item = ffi.new("struct dem_energy_item **")
        check(lib.dem_energy(self._set, since, n, item))
        return {ffi.string(item[0][k].name).decode(): item[0][k].value for k in range(n[0])}

    @property
    def hash(self):
        """64 bits of particles and history of contacts, the same on any ranks. Collective."""
        value = ffi.new("uint64_t *")
        check(lib.dem_hash(self._set, value))
        return f"{value[0]:016x}"

    @property
    def effects(self):
        """Names of the active effects"""
        return ffi.string(lib.dem_effect_names(self._set)).decode().split()

    @property
    def walls(self):
        """Walls by name"""
        walls = [Wall(self, k) for k in range(lib.dem_wall_count(self._set))]
        return {wall.name: wall for wall in walls}

    def reset_impulses(self):
        """Start the sums of Wall.impulse anew."""
        check(lib.dem_wall_impulse_reset(self._set))

    @property
    def bonds(self):
        """Intact bonds of this rank: a dict of arrays"""
        n, bond = ffi.new("int64_t *"), ffi.new("struct dem_bond **")
        check(lib.dem_bonds(self._set, n, bond))
        return _arrays(bond[0], n[0], ("id", "position", "branch", "force", "moment", "stored"))

    def broken_bonds(self):
        """Bonds that broke since the last call: a dict of arrays. Collective."""
        n, bond = ffi.new("int64_t *"), ffi.new("struct dem_broken_bond **")
        check(lib.dem_broken_bonds(self._set, n, bond))
        return _arrays(bond[0], n[0], ("id", "time", "position", "energy", "cause"))

    def lost(self):
        """Particles that left the domain or crossed a wall since the last call: a dict of arrays.
        Collective."""
        n, loss = ffi.new("int64_t *"), ffi.new("struct dem_loss **")
        check(lib.dem_lost(self._set, n, loss))
        found = _arrays(loss[0], n[0], ("id", "time", "position", "velocity", "diameter", "removed"))
        found["cause"] = [ffi.string(loss[0][k].cause).decode() for k in range(n[0])]
        return found

    @property
    def flows(self):
        """Streams and outlets: a list of dicts"""
        n, flow = ffi.new("int *"), ffi.new("struct dem_flow **")
        check(lib.dem_flows(self._set, n, flow))
        return [{"name": ffi.string(f.name).decode(), "enters": bool(f.enters),
                 "particles": f.particles, "mass": f.mass, "momentum": numpy.array(list(f.momentum)),
                 "energy": f.energy, "waiting": f.waiting}
                for f in (flow[0][k] for k in range(n[0]))]

    @property
    def virial(self):
        """Contact stress times volume of each particle [J], n x 6: xx yy zz xy yz zx, tension positive.
        Needs Simulation(..., virial=True)."""
        values = numpy.empty((len(self), 6))
        check(lib.dem_virial(self._set, ffi.from_buffer("double[]", values)))
        return values

    def total(self, name):
        """The sum over all particles of capacity times the particle scalar, e.g. the heat of
        "temperature" above 0 K [J]. Collective."""
        k, value = lib.dem_scalar_index(self._set, name.encode()), ffi.new("double *")
        if k < 0:
            raise KeyError(f"no effect of the scene has the particle scalar {name}")
        check(lib.dem_scalar_total(self._set, k, value))
        return value[0]

    def averages(self, folder):
        """Write NAME.csv and NAME.vti of each grid of the scene's `averages` that has samples into
        the folder, which must exist. Particle scalars have columns, too. Collective."""
        check(lib.dem_averages(self._set, os.fspath(folder).encode()))

    def profile(self):
        """Where the time of the run since the first step went, as text. Collective."""
        text = ffi.new("char **")
        check(lib.dem_profile_text(self._set, ffi.cast("const char **", text)))
        return ffi.string(text[0]).decode()

    def warnings(self, duration):
        """What of the scene is likely to be a mistake in a run of this duration [s], as text; "" when
        there is nothing. Collective."""
        info, text = ffi.new("struct dem_run_info *"), ffi.new("char **")
        info.duration = duration
        check(lib.dem_warnings(self._set, info, 0, ffi.NULL, ffi.cast("const char **", text)))
        return ffi.string(text[0]).decode()

    def plan(self, duration):
        """The plan of a run of this duration [s] as text: effects, steps, memory, time. Collective."""
        info, text = ffi.new("struct dem_run_info *"), ffi.new("char **")
        info.duration = duration
        check(lib.dem_plan(self._set, info, ffi.cast("const char **", text)))
        return ffi.string(text[0]).decode()

    # ---- files, pictures -------------------------------------------------------------------------

    def save(self, path):
        """Write a snapshot. Collective."""
        check(lib.dem_save(self._set, os.fspath(path).encode()))

    def to_vtk(self, path):
        """Write the particles of this rank for ParaView (.vtp), with the names of the program's files:
        id, material, diameter, velocity, spin, force, and the particle scalars."""
        write_vtp(path, {
            "points": self.position, "id": self.id,
            "material": self._column("material").astype(numpy.int64), "diameter": 2*self.radius,
            "velocity": self.velocity, "spin": self.spin, "force": self.force,
            **{name: self.scalar(name) for name in self.scalars}})

    def plot(self, axes=None, colour=None, plane="xz"):
        """Draw the particles as circles with matplotlib; `colour`: a number for each, else the
        speed. Returns the axes."""
        import matplotlib.pyplot as plt
        from matplotlib.collections import EllipseCollection
        axes = axes or plt.gca()
        across, up = ("xyz".index(letter) for letter in plane)
        depth = 3 - across - up
        order = numpy.argsort(-self.position[:, depth])
        d = 2*self.radius[order]
        values = numpy.linalg.norm(self.velocity, axis=1) if colour is None else numpy.asarray(colour)
        axes.add_collection(EllipseCollection(
            d, d, numpy.zeros_like(d), units="xy", offsets=self.position[order][:, [across, up]],
            offset_transform=axes.transData, array=values[order], cmap="cividis", ec="k", lw=0.2))
        axes.autoscale_view()
        axes.set(aspect="equal", xlabel=f"{plane[0]} [m]", ylabel=f"{plane[1]} [m]")
        return axes

    def __repr__(self):
        if self._d is None:
            return "Simulation(closed)"
        if not self._ready:
            return "Simulation(not set up)"
        t = self.totals
        return (f"Simulation({t['particles']} particles, {len(self.walls)} walls, "
                f"t = {t['time']:.6g} s, {' '.join(self.effects)})")


def _arrays(records, n, names):
    """Members of an array of structs, each as an array."""
    found = {}
    for name in names:
        values = [getattr(records[k], name) for k in range(n)]
        found[name] = numpy.array([list(v) if isinstance(v, ffi.CData) else v for v in values])
    return found


class interrupt:
    """While the core advances its own handler catches Ctrl-C: Python's runs only between two calls.
    In other threads than the main one nothing is caught."""

    def __enter__(self):
        self.old = None
        if threading.current_thread() is not threading.main_thread():
            return ffi.NULL
        self.old = signal.getsignal(signal.SIGINT)
        caught = lib.dem_catch_signals([signal.SIGTERM, signal.SIGUSR1], 2)
        ffi.cast("sig_atomic_t *", caught)[0] = 0
        return caught

    def __exit__(self, *_):
        if self.old is not None:
            signal.signal(signal.SIGINT, self.old)
