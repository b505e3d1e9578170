"""simulation.py -- a simulation of the core: scene, advance, particles as numpy arrays.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
from contextlib import contextmanager

import numpy

from ._arguments import (SunaError, as_scene, as_text, file_name, number, numbers, switch, switches,
                         text, texts, vectors, whole_numbers)
from ._core import Core, check, column, string
from ._library import ffi, lib
from .files import write_vtp

# entries of a scene that belong to the program dem
PROGRAM = ("time/end", "time/untilQuiet", "time/maxCreated", "write", "coupling",
           "accuracy")


class Wall:
    """A wall of the scene; its forces are exerted by the particles."""

    def __init__(self, simulation, number, name):
        self._simulation, self._number, self.name = simulation, number, name

    def _pair(self, call):
        one, other = ffi.new("double[3]"), ffi.new("double[3]")
        with self._simulation._set_up() as d:
            check(call(d, self._number, one, other))
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
        with self._simulation._set_up() as d:
            lib.dem_wall_info(d, self._number, info)
            corners = numpy.empty((info.triangles, 3, 3))
            check(lib.dem_wall_corners(d, self._number, ffi.cast("double *", corners.ctypes.data)))
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
    sets the simulation up. Arrays are copies, read-only, of this rank's particles at the moment of
    the call. A simulation is used by one thread at a time.
    """

    _core = None

    def __init__(self, scene, settings=None, start=None, comm=None, energy=False,
                 orientation=False, virial=False, without=None):
        if self._core is not None:
            raise SunaError("the simulation exists already; create another one")
        if comm is not None and not hasattr(comm, "py2f"):
            raise SunaError(f"comm is {comm!r}; give a communicator of mpi4py")
        wanted = [(call, switch(name, value)) for name, value, call in
                  (("energy", energy, lib.dem_case_enable_energy),
                   ("orientation", orientation, lib.dem_case_enable_orientation),
                   ("virial", virial, lib.dem_case_enable_virial))]
        self._core = Core(comm)
        try:
            with self._core.case("Simulation") as c:
                self._read(c, scene)
                self._override(c, settings)
                for entry in PROGRAM:
                    lib.dem_scene_skip(lib.dem_case_dict(c), entry.encode())
                if without is not None:
                    check(lib.dem_case_remove_effect(c, text("without", without)))
                if start is not None:
                    check(lib.dem_case_load(c, file_name("start", start)))
                for call, on in wanted:
                    if on:
                        check(call(c))
        except BaseException:
            self.close()
            raise

    @staticmethod
    def _read(c, scene):
        given = text("scene", as_scene(scene)) if isinstance(scene, dict) else file_name("scene", scene)
        if isinstance(scene, dict) or b"{" in given or b";" in given:
            check(lib.dem_case_scene_text(c, given, b"scene"))
        else:
            check(lib.dem_case_scene_file(c, given))

    @staticmethod
    def _override(c, settings):
        if not isinstance(settings, (dict, type(None))):
            raise SunaError(f"settings is {settings!r}; give a dict, {{\"time/step\": 1e-6}}")
        for entry, value in (settings or {}).items():
            check(lib.dem_case_set(c, text("a name in settings", entry),
                                   text(entry, as_text(f"settings, {entry}", value))))

    def close(self):
        """Free the core's memory. Collective with a communicator."""
        if self._core is not None:
            self._core.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        # at the end of the interpreter MPI may be gone
        if lib is not None:
            self.close()

    def __reduce__(self):
        raise TypeError("a simulation cannot be copied or pickled; save a snapshot, and start another "
                        "one from it: Simulation(scene, start=path)")

    # ---- before the set-up -----------------------------------------------------------------------

    def add_particles(self, position, diameter, material, velocity=0.0, spin=0.0, id=None,
                      frozen=False):
        """Add particles; each argument is one value for all or an array. The same on all ranks."""
        x = vectors("position", position, 3)
        n = len(x)
        v, w = numbers("velocity", velocity, (n, 3)), numbers("spin", spin, (n, 3))
        d = numbers("diameter", diameter, n)
        ids = numpy.broadcast_to(-1, n) if id is None else whole_numbers("id", id, n)
        held = switches("frozen", frozen, n)
        names = [ffi.new("char[]", name) for name in texts("material", material, n)]
        particles = ffi.new("struct dem_new_particle[]", n)
        for k, p in enumerate(particles):
            p.position, p.velocity, p.spin = list(x[k]), list(v[k]), list(w[k])
            p.diameter, p.id, p.material, p.frozen = d[k], ids[k], names[k], held[k]
        with self._before("add_particles") as c:
            check(lib.dem_case_add_particles(c, n, particles))

    def add_wall(self, name, material, triangles):
        """Add a wall of triangles, n x 3 x 3 [m]. Collective."""
        corners = vectors("triangles", triangles, 3, 3)
        name, material = text("name", name), text("material", material)
        with self._before("add_wall") as c:
            check(lib.dem_case_add_wall(c, name, material, len(corners),
                                        ffi.cast("double *", corners.ctypes.data)))

    def _before(self, what):
        return self._core_().case(what)

    def _core_(self):
        if self._core is None:
            raise SunaError("the simulation was never created; call Simulation(scene)")
        return self._core

    def _set_up(self):
        return self._core_().run()

    def value(self, path):
        """Text of an entry of the scene, "time/end"; None where there is none."""
        path = text("path", path)
        with self._core_().scene() as scene:
            found = lib.dem_scene_value(scene, path)
            return None if found == ffi.NULL else string(found)

    def names(self, path=""):
        """Names of the entries of a group of the scene"""
        path, found = text("path", path), []
        with self._core_().scene() as scene:
            while (name := lib.dem_scene_name(scene, path, len(found))) != ffi.NULL:
                found.append(string(name))
        return found

    def setup(self):
        """Insert the particles and check all. Called by itself at first use. Collective."""
        with self._set_up():
            return self

    # ---- advance ---------------------------------------------------------------------------------

    def advance(self, duration, progress=None, every=1.0):
        """Advance by a duration [s]. progress(time, steps) is called once in `every` seconds; it must
        not use the simulation. Its exceptions and Ctrl-C end the advance after a step. Collective."""
        duration, every = number("duration", duration), number("every", every)
        if progress is not None and not callable(progress):
            raise SunaError(f"progress is {progress!r}; give a function of time and steps")
        self.setup()
        self._core.advance(duration, progress, every)
        return self

    # ---- particles -------------------------------------------------------------------------------

    @contextmanager
    def _view(self):
        view = ffi.new("struct dem_view *")
        with self._set_up() as d:
            lib.dem_view(d, view)
            yield view

    def _column(self, name, width=1, strided=True):
        with self._view() as view:
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
        """unit quaternions, n x 4; needs Simulation(..., orientation=True)"""
        with self._view() as view:
            if view.n and view.orientation == ffi.NULL:
                raise SunaError("orientations are not kept; create Simulation(..., orientation=True)")
            return column(view.orientation, view.n, 4)

    @property
    def scalars(self):
        """names of the particle scalars that the effects of the scene declare"""
        with self._set_up() as d:
            return [string(self._scalar_info(d, k).name) for k in range(lib.dem_scalar_count(d))]

    @staticmethod
    def _scalar_info(d, k):
        info = ffi.new("struct dem_scalar_info *")
        lib.dem_scalar_info(d, k, info)
        return info

    def _scalar_number(self, d, name):
        k = lib.dem_scalar_index(d, text("the particle scalar", name))
        if k < 0:
            raise SunaError(f"no effect of the scene has the particle scalar {name}; it has "
                            + (", ".join(self.scalars) or "none"))
        return k

    def scalar(self, name):
        """a particle scalar, e.g. "temperature" """
        with self._view() as view, self._set_up() as d:
            return column(lib.dem_scalar(d, self._scalar_number(d, name)), view.n)

    def set_scalar(self, name, values):
        """Set a particle scalar between two advances: one value for all, or one for each."""
        with self._view() as view, self._set_up() as d:
            k = self._scalar_number(d, name)
            info, given = self._scalar_info(d, k), numbers(name, values, view.n)
            wrong = given[~((given >= info.min) & (given <= info.max) & numpy.isfinite(given))]
            if len(wrong):
                raise SunaError(f"{name} {wrong[0]:g} {string(info.unit)}; give a number from "
                                f"{info.min:g} to {info.max:g}")
            if view.n:
                numpy.frombuffer(ffi.buffer(lib.dem_scalar(d, k), 8*view.n))[:] = given

    @property
    def material(self):
        """names"""
        with self._set_up() as d:
            found = self._column("material")
            names = {k: string(lib.dem_material_name(d, int(k))) for k in numpy.unique(found)}
        return numpy.array([names[k] for k in found], object)

    def __len__(self):
        with self._view() as view:
            return view.n

    # ---- queries ---------------------------------------------------------------------------------

    @property
    def totals(self):
        """Sums over all particles and contacts, as a dict. Collective; resets largest_overlap."""
        totals = ffi.new("struct dem_totals *")
        with self._set_up() as d:
            check(lib.dem_totals(d, totals))
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
        with self._set_up() as d:
            step = lib.dem_step_limit(d)
        return step.used, step.limit, string(step.why)

    @property
    def energy(self):
        """Terms of the energy balance [J], as a dict; needs energy=True. Collective."""
        since, n = ffi.new("double *"), ffi.new("int *")
        item = ffi.new("struct dem_energy_item **")
        with self._set_up() as d:
            check(lib.dem_energy(d, since, n, item))
            return {string(item[0][k].name): item[0][k].value for k in range(n[0])}

    @property
    def hash(self):
        """64 bits of particles and history of contacts, the same on any ranks. Collective."""
        value = ffi.new("uint64_t *")
        with self._set_up() as d:
            check(lib.dem_hash(d, value))
        return f"{value[0]:016x}"

    @property
    def effects(self):
        """Names of the active effects"""
        with self._set_up() as d:
            return string(lib.dem_effect_names(d)).split()

    @property
    def walls(self):
        """Walls by name"""
        with self._set_up() as d:
            names = [string(lib.dem_wall_name(d, k)) for k in range(lib.dem_wall_count(d))]
        return {name: Wall(self, k, name) for k, name in enumerate(names)}

    def reset_impulses(self):
        """Start the sums of Wall.impulse anew."""
        with self._set_up() as d:
            check(lib.dem_wall_impulse_reset(d))

    @property
    def bonds(self):
        """Intact bonds of this rank: a dict of arrays"""
        n, bond = ffi.new("int64_t *"), ffi.new("struct dem_bond **")
        with self._set_up() as d:
            check(lib.dem_bonds(d, n, bond))
            return _arrays(bond[0], n[0], ("id", "position", "branch", "force", "moment", "stored"))

    def broken_bonds(self):
        """Bonds that broke since the last call: a dict of arrays. Collective."""
        n, bond = ffi.new("int64_t *"), ffi.new("struct dem_broken_bond **")
        with self._set_up() as d:
            check(lib.dem_broken_bonds(d, n, bond))
            return _arrays(bond[0], n[0], ("id", "time", "position", "energy", "cause"))

    def lost(self):
        """Particles that left the domain or crossed a wall since the last call: a dict of arrays.
        Collective."""
        n, loss = ffi.new("int64_t *"), ffi.new("struct dem_loss **")
        with self._set_up() as d:
            check(lib.dem_lost(d, n, loss))
            found = _arrays(loss[0], n[0],
                            ("id", "time", "position", "velocity", "diameter", "removed"))
            found["cause"] = [string(loss[0][k].cause) for k in range(n[0])]
        return found

    @property
    def flows(self):
        """Streams and outlets: a list of dicts"""
        n, flow = ffi.new("int *"), ffi.new("struct dem_flow **")
        with self._set_up() as d:
            check(lib.dem_flows(d, n, flow))
            return [{"name": string(f.name), "enters": bool(f.enters), "particles": f.particles,
                     "mass": f.mass, "momentum": numpy.array(list(f.momentum)), "energy": f.energy,
                     "waiting": f.waiting}
                    for f in (flow[0][k] for k in range(n[0]))]

    @property
    def virial(self):
        """Contact stress times volume of each particle [J], n x 6: xx yy zz xy yz zx, tension positive.
        Needs Simulation(..., virial=True)."""
        with self._view() as view, self._set_up() as d:
            values = numpy.empty((view.n, 6))
            check(lib.dem_virial(d, ffi.from_buffer("double[]", values)))
        return values

    def total(self, name):
        """The sum over all particles of capacity times the particle scalar, e.g. the heat of
        "temperature" above 0 K [J]. Collective."""
        value = ffi.new("double *")
        with self._set_up() as d:
            check(lib.dem_scalar_total(d, self._scalar_number(d, name), value))
        return value[0]

    def averages(self, folder):
        """Write NAME.csv and NAME.vti of each grid of the scene's `averages` that has samples into
        the folder, which must exist. Particle scalars have columns, too. Collective."""
        folder = file_name("folder", folder)
        with self._set_up() as d:
            check(lib.dem_averages(d, folder))

    def profile(self):
        """Where the time of the run since the first step went, as text. Collective."""
        return self._text(lib.dem_profile_text)

    def warnings(self, duration):
        """What of the scene is likely to be a mistake in a run of this duration [s], as text; "" when
        there is nothing. Collective."""
        return self._text(lib.dem_warnings, _run(duration), 0, ffi.NULL)

    def plan(self, duration):
        """The plan of a run of this duration [s] as text: effects, steps, memory, time. Collective."""
        return self._text(lib.dem_plan, _run(duration))

    def _text(self, call, *arguments):
        """What the core writes about the simulation"""
        found = ffi.new("char **")
        with self._set_up() as d:
            check(call(d, *arguments, ffi.cast("const char **", found)))
            return string(found[0])

    # ---- files, pictures -------------------------------------------------------------------------

    def save(self, path):
        """Write a snapshot. Collective."""
        path = file_name("path", path)
        with self._set_up() as d:
            check(lib.dem_save(d, path))

    def to_vtk(self, path):
        """Write the particles of this rank for ParaView (.vtp), with the names of the program's files:
        id, material, diameter, velocity, spin, force, and the particle scalars."""
        write_vtp(os.fsdecode(file_name("path", path)), {
            "points": self.position, "id": self.id,
            "material": self._column("material").astype(numpy.int64), "diameter": 2*self.radius,
            "velocity": self.velocity, "spin": self.spin, "force": self.force,
            **{name: self.scalar(name) for name in self.scalars}})

    def plot(self, axes=None, colour=None, plane="xz"):
        """Draw the particles as circles with matplotlib; `colour`: a number for each, else the
        speed. Returns the axes."""
        if not isinstance(plane, str) or len(plane) != 2 or not set(plane) < set("xyz"):
            raise SunaError(f"plane is {plane!r}; give two of the letters x, y, z, as in \"xz\"")
        import matplotlib.pyplot as plt
        from matplotlib.collections import EllipseCollection
        axes = axes or plt.gca()
        across, up = ("xyz".index(letter) for letter in plane)
        depth = 3 - across - up
        order = numpy.argsort(-self.position[:, depth])
        d = 2*self.radius[order]
        values = (numpy.linalg.norm(self.velocity, axis=1) if colour is None
                  else numbers("colour", colour, len(order)))
        axes.add_collection(EllipseCollection(
            d, d, numpy.zeros_like(d), units="xy", offsets=self.position[order][:, [across, up]],
            offset_transform=axes.transData, array=values[order], cmap="cividis", ec="k", lw=0.2))
        axes.autoscale_view()
        axes.set(aspect="equal", xlabel=f"{plane[0]} [m]", ylabel=f"{plane[1]} [m]")
        return axes

    def __repr__(self):
        if self._core is None or self._core.closed:
            return "Simulation(closed)"
        if not self._core.started:
            return "Simulation(not set up)"
        t = self.totals
        return (f"Simulation({t['particles']} particles, {len(self.walls)} walls, "
                f"t = {t['time']:.6g} s, {' '.join(self.effects)})")


def _run(duration):
    info = ffi.new("struct dem_run_info *")
    info.duration = number("duration", duration)
    return info


def _arrays(records, n, names):
    """Members of an array of structs, each as an array."""
    found = {}
    for name in names:
        values = [getattr(records[k], name) for k in range(n)]
        found[name] = numpy.array([list(v) if isinstance(v, ffi.CData) else v for v in values])
    return found
