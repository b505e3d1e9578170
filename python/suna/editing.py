"""editing.py -- what changes a simulation between two advances: particles by their ids, entries of the
scene, walls.

Particles change in place. An entry of the scene changes as in a restart with an edited scene: the
state is written, and a case with the entry is started from it. So all that a scene may say may change,
with the checks of the start; if they refuse it, the simulation is as before.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import os
import tempfile
from typing import Any, Mapping

import numpy
from numpy.typing import ArrayLike, NDArray

from ._arguments import (SunaError, as_text, number, numbers, switches, text, texts, vectors,
                         whole_numbers)
from ._core import check, string
from ._library import ffi, lib
from .arrays import Arrays


class Editing(Arrays):
    """Part of Simulation."""

    def _describe(self, what, call):
        """Tell the case what `call(c)` says; after the start, in a case that goes on from here."""
        core = self._core_()
        if not core.started:
            with core.case(what) as c:
                call(c)
        else:
            self._go_on(lambda c: [one(c) for one in (*self._described, call)])
        self._described.append(call)

    def _go_on(self, describe):
        core, path = self._core_(), None
        if core.rank == 0:
            # ranks of other machines see the present folder, as a rule, and not the one for temporary files
            file, path = tempfile.mkstemp(".suna", dir=None if core.single else ".")
            os.close(file)
        core.restart(describe, os.fsencode(core.shared(path)))

    def value(self, path: str) -> str | None:
        """Text of an entry of the scene, "time/end"; None where there is none."""
        at = text("path", path)
        with self._core_().scene() as scene:
            found = lib.dem_scene_value(scene, at)
            return None if found == ffi.NULL else string(found)

    def names(self, path: str = "") -> list[str]:
        """Names of the entries of a group of the scene"""
        at, found = text("path", path), []    # type: bytes, list[str]
        with self._core_().scene() as scene:
            while (name := lib.dem_scene_name(scene, at, len(found))) != ffi.NULL:
                found.append(string(name))
        return found

    def entries(self, path: str = "") -> dict[str, Any]:
        """A group of the scene as a dict of texts, with groups in it as dicts"""
        found: dict[str, Any] = {}
        for name in self.names(path):
            at = f"{path}/{name}" if path else name
            value = self.value(at)
            found[name] = self.entries(at) if value is None else value
        return found

    def change(self, entries: Mapping[str, Any]) -> None:
        """Change entries of the scene: {"effects/mindlin/friction": 0.5}. A dict replaces a group, None
        removes an entry or group: {"walls/gate": None}. Groups of `insert` that are new are inserted,
        walls go on from where they stand. Collective."""
        if not isinstance(entries, dict):
            raise SunaError(f"entries is {entries!r}; give a dict, {{\"effects/dry/restitution\": 0.5}}")
        given = [(text("a name of an entry", path),
                  None if value is None else text(path, as_text(path, value)))
                 for path, value in entries.items()]

        def call(c):
            removed = ffi.new("int *")
            for path, value in given:
                if value is None or value.startswith(b"{"):
                    check(lib.dem_case_remove(c, path, removed))
                if value is not None:
                    check(lib.dem_case_set(c, path, value))
                elif not removed[0]:
                    raise SunaError(f"the scene has no {path.decode()} to remove")

        self._describe("change", call)

    def add_wall(self, name: str, material: str, triangles: ArrayLike) -> None:
        """Add a wall of triangles, n x 3 x 3 [m]. Collective."""
        corners = vectors("triangles", triangles, 3, 3)
        path = "walls/" + text("name", name).decode(errors="surrogateescape")
        text("material", material)
        if self.names(path):
            raise SunaError(f"the scene has a wall {name}; choose another name, or remove that one before")
        self.change({path: {"type": "triangles", "material": material, "corners": corners.reshape(-1, 3)}})

    def allow_diameters(self, material: str, smallest: float, largest: float) -> None:
        """Particles of this material may get diameters between these [m] in `add`: time step and
        lists are made for them. Collective."""
        name = text("material", material)
        sizes = number("smallest", smallest), number("largest", largest)
        self._describe("allow_diameters",
                       lambda c: check(lib.dem_case_allow_diameters(c, name, *sizes)))

    # ---- particles -------------------------------------------------------------------------------

    def add(self, position: ArrayLike, diameter: ArrayLike, material: str | list[str],
            velocity: ArrayLike = 0.0, spin: ArrayLike = 0.0, id: ArrayLike | None = None,
            frozen: ArrayLike = False) -> NDArray[numpy.int64]:
        """Add particles: each argument is one value for all or an array, the same on all ranks. Returns
        their ids. Before the start they are among the particles that it places. Collective."""
        n, particles, _ = _new_particles(position, diameter, material, velocity, spin, id, frozen)
        ids = numpy.empty(n, numpy.int64)
        with self._changing() as d:
            check(lib.dem_add_particles(d, n, particles, ffi.from_buffer("int64_t[]", ids)))
        return ids

    def add_clumps(self, position: ArrayLike, shape: str | list[str], material: str | list[str],
                   orientation: ArrayLike = (1, 0, 0, 0), velocity: ArrayLike = 0.0, spin: ArrayLike = 0.0,
                   id: ArrayLike | None = None, frozen: ArrayLike = False) -> NDArray[numpy.int64]:
        """Add clumps of a shape of the scene, their centres of mass at these positions, turned by unit quaternions
        (w x y z): each argument is one value for all or an array, the same on all ranks. Returns the id of the first
        sphere of each; the others follow. Collective."""
        x = vectors("position", position, 3)
        n = len(x)
        v, w = numbers("velocity", velocity, (n, 3)), numbers("spin", spin, (n, 3))
        turn, held = numbers("orientation", orientation, (n, 4)), switches("frozen", frozen, n)
        first = numpy.broadcast_to(-1, n) if id is None else whole_numbers("id", id, n)
        names = [[ffi.new("char[]", name) for name in texts(what, value, n)]
                 for what, value in (("shape", shape), ("material", material))]
        clumps = ffi.new("struct dem_new_clump[]", n)
        for k, c in enumerate(clumps):
            c.position, c.velocity, c.spin, c.orientation = list(x[k]), list(v[k]), list(w[k]), list(turn[k])
            c.id, c.shape, c.material, c.frozen = first[k], names[0][k], names[1][k], held[k]
        ids = numpy.empty(n, numpy.int64)
        with self._changing() as d:
            check(lib.dem_add_clumps(d, n, clumps, ffi.from_buffer("int64_t[]", ids)))
        return ids

    def remove(self, ids: ArrayLike) -> None:
        """Remove the particles that have these ids; a clump needs the ids of all its spheres. Collective."""
        listed = _ids(ids)
        with self._changing() as d:
            check(lib.dem_remove_particles(d, len(listed), ffi.from_buffer("int64_t[]", listed)))

    def set(self, ids: ArrayLike, position: ArrayLike | None = None,
            velocity: ArrayLike | None = None, spin: ArrayLike | None = None,
            frozen: ArrayLike | None = None, **scalars: ArrayLike) -> None:
        """Set quantities of the particles that have these ids, and particle scalars by their names
        (temperature=300): one value for all, or an array in the order of the ids, the same on all
        ranks. The id of its first sphere moves a clump; particle scalars are set sphere by sphere. Collective."""
        listed = _ids(ids)
        n, new = len(listed), ffi.new("struct dem_particle_changes *")
        given = {name: numpy.ascontiguousarray(numbers(name, value, (n, 3))) for name, value in
                 (("position", position), ("velocity", velocity), ("spin", spin)) if value is not None}
        if frozen is not None:
            given["frozen"] = numpy.array(switches("frozen", frozen, n), numpy.intc)
        for name, array in given.items():
            kind = "int *" if name == "frozen" else "double *"
            setattr(new, name, ffi.cast(kind, array.ctypes.data))
        with self._changing() as d:
            # in the first call all that the core may refuse: of scalars only the temperature, of clumps
            names = sorted(scalars, key=lambda name: name != "temperature")
            values = [self._scalar_values(d, name, scalars[name], n) for name in names]
            chosen = ffi.from_buffer("int64_t[]", listed)
            for k, wanted in values or [(0, None)]:
                if wanted is not None:
                    wanted = numpy.ascontiguousarray(wanted)
                    new.value, new.scalar = ffi.cast("double *", wanted.ctypes.data), k
                check(lib.dem_set_particles(d, n, chosen, new))
                new = ffi.new("struct dem_particle_changes *")


def _ids(ids: ArrayLike) -> NDArray[numpy.int64]:
    try:
        array = numpy.atleast_1d(numpy.asarray(ids))
    except (ValueError, OverflowError):    # lists of unequal lengths
        raise SunaError(f"ids is {ids!r}; give one id or a list of ids") from None
    if array.ndim != 1:
        raise SunaError(f"ids has the shape {array.shape}; give one id or a list of ids")
    return numpy.ascontiguousarray(whole_numbers("ids", array, len(array)))


def _new_particles(position, diameter, material, velocity, spin, id, frozen):
    """Their number, the structs, and what these point to."""
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
    return n, particles, names
