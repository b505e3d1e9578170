"""simulation.py -- a simulation of the core: scene, advance, particles as numpy arrays.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import html
import os
from typing import Any, Callable, Mapping

import numpy
from numpy.typing import ArrayLike, NDArray

from ._arguments import File, SunaError, file_name, number, switch, text, whole_numbers
from ._core import Core, check, string
from ._library import ffi, lib
from ._scene import options, override, reader
from .editing import Editing, _new_particles
from .output import Output
from .particles import Forces
from .walls import Wall


class Simulation(Editing, Output):
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

    def __init__(self, scene: File | Mapping[str, Any], settings: Mapping[str, Any] | None = None,
                 start: File | None = None, comm: Any = None, energy: bool = False,
                 orientation: bool = False, virial: bool = False, without: str | None = None) -> None:
        if self._core is not None:
            raise SunaError("the simulation exists already; create another one")
        if comm is not None and not hasattr(comm, "py2f"):
            raise SunaError(f"comm is {comm!r}; give a communicator of mpi4py")
        wanted = [call for name, value, call in
                  (("energy", energy, lib.dem_case_enable_energy),
                   ("orientation", orientation, lib.dem_case_enable_orientation),
                   ("virial", virial, lib.dem_case_enable_virial)) if switch(name, value)]
        left_out = None if without is None else text("without", without)
        self._core, self._described = Core(comm), [reader(scene), override(settings)]
        self._balanced = bool(energy)
        self._forces: list[Callable[[Forces], None]] = []
        self._described += [lambda c: options(c, left_out, wanted)]
        try:
            with self._core.case("Simulation") as c:
                for call in self._described:
                    call(c)
                if start is not None:
                    check(lib.dem_case_load(c, file_name("start", start)))
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Free the core's memory. Collective with a communicator."""
        if self._core is not None:
            self._core.close()

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __del__(self):
        # at the end of the interpreter MPI may be gone
        if lib is not None:
            self.close()

    def __reduce__(self):
        raise TypeError("a simulation cannot be copied or pickled; save a snapshot, and start another "
                        "one from it: Simulation(scene, start=path)")

    # ---- before the set-up -----------------------------------------------------------------------

    def add_particles(self, position: ArrayLike, diameter: ArrayLike, material: str | list[str],
                      velocity: ArrayLike = 0.0, spin: ArrayLike = 0.0, id: ArrayLike | None = None,
                      frozen: ArrayLike = False) -> None:
        """Add particles; each argument is one value for all or an array. The same on all ranks."""
        n, particles, _names = _new_particles(position, diameter, material, velocity, spin, id, frozen)
        with self._core_().case("add_particles") as c:
            check(lib.dem_case_add_particles(c, n, particles))

    def setup(self) -> Simulation:
        """Insert the particles and check all. Called by itself at first use. Collective."""
        with self._set_up():
            return self

    # ---- advance ---------------------------------------------------------------------------------

    def advance(self, duration: float, progress: Callable[[float, int], object] | None = None,
                interval: float = 1.0, until: Callable[[Simulation], object] | None = None,
                every: int = 100) -> Simulation:
        """Advance by a duration [s].

        progress(time, steps) is called once in `interval` seconds of the clock; it must not use the
        simulation. until(sim) is called each `every` steps, where positions and velocities are at one
        time, and may use it; a true value ends the advance. Exceptions of both and Ctrl-C end the
        advance after a step. Collective."""
        duration, interval = number("duration", duration), number("interval", interval)
        for name, call in (("progress", progress), ("until", until)):
            if call is not None and not callable(call):
                raise SunaError(f"{name} is {call!r}; give a function")
        core = self._core_()
        if until is None:
            self.setup()
            core.advance(duration, progress, interval, self._forces)
            return self
        every = int(whole_numbers("every", every, ()))
        if every < 1 or not 0 < duration < float("inf"):
            raise SunaError(f"duration is {duration:g} s, every is {every}; give a time above 0 and a "
                            "number of steps from 1 on")
        end, window = self.time + duration, every*self.step[0]
        while (rest := end - self.time) > 1e-9*window and not core.any(lambda: until(self)):
            core.advance(rest if rest < 1.001*window else window, progress, interval, self._forces)
        return self

    def add_force(self, function: Callable[[Forces], None]) -> Callable[[Forces], None]:
        """Let a function give forces from now on; also as a decorator:

            @sim.add_force
            def trap(p):
                p.force -= 0.1*p.position

        It is called on each rank in each step, after the particles have moved, and at the beginning
        of an advance, with suna.Forces; it returns nothing. What it adds must depend on each particle alone for
        the same bits on any ranks. An exception, or a failure of the run, ends the advance on all ranks and
        puts back the state before it."""
        if not callable(function):
            raise SunaError(f"the force is {function!r}; give a function of the particles")
        self._core_()
        self._forces.append(function)
        return function

    def remove_force(self, function: Callable[[Forces], None]) -> None:
        """End a force of add_force."""
        if not callable(function) or function not in self._forces:
            raise SunaError(f"{function!r} is no force of the simulation")
        self._forces.remove(function)

    # ---- queries ---------------------------------------------------------------------------------

    @property
    def totals(self) -> dict[str, Any]:
        """Sums over all particles and contacts, as a dict. Collective; resets largest_overlap."""
        totals = ffi.new("struct dem_totals *")
        with self._set_up() as d:
            check(lib.dem_totals(d, totals))
        return _fields(totals)

    @property
    def time(self) -> float:
        """[s]. Collective."""
        return self.totals["time"]

    @property
    def step(self) -> tuple[float, float, str]:
        """The time step in use [s], its limit [s], and what sets that"""
        with self._set_up() as d:
            step = lib.dem_step_limit(d)
        return step.used, step.limit, string(step.why)

    @property
    def energy(self) -> dict[str, float]:
        """Terms of the energy balance [J], as a dict; needs energy=True. Collective."""
        since, n = ffi.new("double *"), ffi.new("int *")
        item = ffi.new("struct dem_energy_item **")
        with self._set_up() as d:
            if not self._balanced:
                raise SunaError("energy: this simulation keeps no energy balance; create it with "
                                "Simulation(..., energy=True)")
            check(lib.dem_energy(d, since, n, item))
            return {string(item[0][k].name): item[0][k].value for k in range(n[0])}

    @property
    def hash(self) -> str:
        """64 bits of particles and history of contacts, the same on any ranks. Collective."""
        value = ffi.new("uint64_t *")
        with self._set_up() as d:
            check(lib.dem_hash(d, value))
        return f"{value[0]:016x}"

    @property
    def effects(self) -> list[str]:
        """Names of the active effects"""
        with self._set_up() as d:
            return string(lib.dem_effect_names(d)).split()

    def wall(self, name: str) -> Wall:
        """The wall of this name"""
        text("name", name)
        found = self.walls
        if name not in found:
            raise SunaError(f"there is no wall {name!r}; the scene has " + (", ".join(found) or "none"))
        return found[name]

    @property
    def walls(self) -> dict[str, Wall]:
        """Walls by name"""
        with self._set_up() as d:
            names = [string(lib.dem_wall_name(d, k)) for k in range(lib.dem_wall_count(d))]
        return {name: Wall(self, name) for name in names}

    def reset_impulses(self) -> None:
        """Start the sums of Wall.impulse anew."""
        with self._set_up() as d:
            check(lib.dem_wall_impulse_reset(d))

    @property
    def bonds(self) -> dict[str, NDArray]:
        """Intact bonds of this rank: a dict of arrays"""
        n, bond = ffi.new("int64_t *"), ffi.new("struct dem_bond **")
        with self._set_up() as d:
            check(lib.dem_bonds(d, n, bond))
            return _arrays(bond[0], n[0], ("id", "position", "branch", "force", "moment", "stored"))

    def broken_bonds(self) -> dict[str, NDArray]:
        """Bonds that broke since the last call: a dict of arrays. Collective."""
        n, bond = ffi.new("int64_t *"), ffi.new("struct dem_broken_bond **")
        with self._set_up() as d:
            check(lib.dem_broken_bonds(d, n, bond))
            return _arrays(bond[0], n[0], ("id", "time", "position", "energy", "cause"))

    def lost(self) -> dict[str, Any]:
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
    def flows(self) -> list[dict[str, Any]]:
        """Streams and outlets: a list of dicts"""
        n, flow = ffi.new("int *"), ffi.new("struct dem_flow **")
        with self._set_up() as d:
            check(lib.dem_flows(d, n, flow))
            return [{"name": string(f.name), "enters": bool(f.enters), "particles": f.particles,
                     "mass": f.mass, "momentum": numpy.array(list(f.momentum)), "energy": f.energy,
                     "waiting": f.waiting}
                    for f in (flow[0][k] for k in range(n[0]))]

    @property
    def virial(self) -> NDArray[numpy.float64]:
        """Contact stress times volume of each particle [J], n x 6: xx yy zz xy yz zx, tension positive.
        Needs Simulation(..., virial=True)."""
        with self._view() as view, self._set_up() as d:
            values = numpy.empty((view.n, 6))
            check(lib.dem_virial(d, ffi.from_buffer("double[]", values)))
        return values

    @property
    def cell(self) -> dict[str, Any]:
        """The scene's domain/cell as it is now, as a dict: length [m], rate [1/s], stress [Pa], fabric, solid, ... Six
        values are xx yy zz xy yz zx, tension positive. Collective."""
        now = ffi.new("struct dem_cell_now *")
        with self._set_up() as d:
            check(lib.dem_cell(d, now))
        return _fields(now)

    def total(self, name: str) -> float:
        """The sum over all particles of capacity times the particle scalar, e.g. the heat of
        "temperature" above 0 K [J]. Collective."""
        value = ffi.new("double *")
        with self._set_up() as d:
            check(lib.dem_scalar_total(d, self._scalar_number(d, name), value))
        return value[0]

    def averages(self, folder: File) -> None:
        """Write NAME.csv and NAME.vti of each grid of the scene's `averages` that has samples into
        the folder, which must exist. Particle scalars have columns, too. Collective."""
        with self._set_up() as d:
            check(lib.dem_averages(d, file_name("folder", folder)))

    def profile(self) -> str:
        """Where the time of the run since the first step went, as text. Collective."""
        return self._text(lib.dem_profile_text)

    def warnings(self, duration: float) -> str:
        """What of the scene is likely to be a mistake in a run of this duration [s], as text; "" when
        there is nothing. Collective."""
        return self._text(lib.dem_warnings, _run(duration), 0, ffi.NULL)

    def plan(self, duration: float) -> str:
        """The plan of a run of this duration [s] as text: effects, steps, memory, time. Collective."""
        return self._text(lib.dem_plan, _run(duration))

    def _text(self, call, *arguments):
        """What the core writes about the simulation"""
        found = ffi.new("char **")
        with self._set_up() as d:
            check(call(d, *arguments, ffi.cast("const char **", found)))
            return string(found[0])

    def save(self, path: File) -> None:
        """Write a snapshot. Collective."""
        name = file_name("path", path)
        with self._set_up() as d:
            if os.path.isdir(name):
                raise SunaError(f"{path} is a folder; give the path of a file, as in state.dem")
            check(lib.dem_save(d, name))

    def _repr_html_(self) -> str:
        """A table for notebooks. Collective."""
        if self._core is None or not self._core.started or self._core.closed:
            return f"<p>{html.escape(repr(self))}</p>"
        t, n = self.totals, "\u2009"
        rows = {"particles": t["particles"], "contacts": t["contacts"], "time": f"{t['time']:.6g}{n}s",
                "time step": f"{self.step[0]:.3g}{n}s ({self.step[2]})", "mass": f"{t['mass']:.6g}{n}kg",
                "kinetic energy": f"{t['kinetic']:.3g}{n}J", "walls": ", ".join(self.walls),
                "effects": ", ".join(self.effects)}
        return "<table>" + "".join(f"<tr><th>{name}</th><td>{html.escape(str(value))}</td></tr>"
                                   for name, value in rows.items()) + "</table>"

    def __repr__(self) -> str:
        if self._core is None or self._core.closed:
            return "Simulation(closed)"
        if not self._core.started:
            return "Simulation(not set up)"
        t = self.totals
        counts = ((t["particles"], "particle"), (len(self.walls), "wall"))
        return ("Simulation(" + "".join(f"{n} {what}{'s' if n != 1 else ''}, " for n, what in counts) +
                f"t = {t['time']:.6g} s, {' '.join(self.effects)})")


def _run(duration):
    info = ffi.new("struct dem_run_info *")
    info.duration = number("duration", duration)
    return info


def _fields(struct):
    """A struct as a dict; its arrays as arrays"""
    return {name: numpy.array(list(value)) if isinstance(value, ffi.CData) else value
            for name, value in ((name, getattr(struct, name)) for name, _ in ffi.typeof(struct).item.fields)}


def _arrays(records, n, names):
    """Members of an array of structs, each as an array."""
    found = {}
    for name, field in ffi.typeof(records).item.fields:
        if name in names:
            several = field.type.kind == "array" and field.type.item.kind == "primitive"
            number = field.type.item if several else field.type
            kind = {"double": float, "int64_t": numpy.int64, "int": numpy.int64}.get(number.cname)
            values = [getattr(records[k], name) for k in range(n)]
            found[name] = numpy.array([list(v) if isinstance(v, ffi.CData) else v for v in values], kind).reshape(
                (n, field.type.length) if several else (n,))
    return {name: found[name] for name in names}
