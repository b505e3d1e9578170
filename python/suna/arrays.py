"""arrays.py -- the particles of a simulation as arrays: quantities, scalars, a view.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from contextlib import contextmanager
from typing import Iterator

import numpy
from numpy.typing import ArrayLike, NDArray

from ._arguments import SunaError, numbers, text
from ._core import Core, check, string
from ._library import ffi, lib
from .particles import View, column, of_view


class Arrays:
    """Part of Simulation. Arrays are copies, read-only, of this rank's particles."""

    _core: Core | None = None
    _described: list    # calls that describe the case, for one that goes on from here

    def _core_(self) -> Core:
        if self._core is None:
            raise SunaError("the simulation was never created; call Simulation(scene)")
        return self._core

    def _set_up(self):
        return self._core_().run()

    def _changing(self):
        return self._core_().changing()

    @contextmanager
    def _view(self):
        view = ffi.new("struct dem_view *")
        with self._set_up() as d:
            lib.dem_view(d, view)
            yield view

    def _column(self, name):
        with self._view() as view:
            return of_view(view, name)

    @contextmanager
    def view(self) -> Iterator[View]:
        """`with sim.view() as p`: particles without copy (suna.View); the simulation cannot change
        meanwhile."""
        with self._core_().view() as (view, lend):
            p = View(view, lend)
            try:
                yield p
            finally:
                p._view = None

    @property
    def position(self) -> NDArray[numpy.float64]:
        """n x 3 [m]"""
        return self._column("position")

    @property
    def velocity(self) -> NDArray[numpy.float64]:
        """n x 3 [m/s]"""
        return self._column("velocity")

    @property
    def spin(self) -> NDArray[numpy.float64]:
        """n x 3 [1/s]"""
        return self._column("spin")

    @property
    def radius(self) -> NDArray[numpy.float64]:
        """[m]"""
        return self._column("radius")

    @property
    def mass(self) -> NDArray[numpy.float64]:
        """[kg]"""
        return self._column("mass")

    @property
    def id(self) -> NDArray[numpy.int64]:
        return self._column("id")

    @property
    def clump(self) -> NDArray[numpy.int64]:
        """1 + the smallest id of the clump that a sphere belongs to; 0: none"""
        with self._view() as view:
            return numpy.zeros(view.n, numpy.int64) if view.clump == ffi.NULL else of_view(view, "clump")

    @property
    def frozen(self) -> NDArray[numpy.bool_]:
        return (self._column("flags") & 1).astype(bool)

    @property
    def force(self) -> NDArray[numpy.float64]:
        """of contacts, n x 3 [N]"""
        return self._column("force")

    @property
    def torque(self) -> NDArray[numpy.float64]:
        """of contacts, n x 3 [N m]"""
        return self._column("torque")

    @property
    def orientation(self) -> NDArray[numpy.float64]:
        """unit quaternions, n x 4; needs Simulation(..., orientation=True)"""
        with self._view() as view:
            if view.n and view.orientation == ffi.NULL:
                raise SunaError("orientations are not kept; create Simulation(..., orientation=True)")
            return of_view(view, "orientation")

    @property
    def scalars(self) -> list[str]:
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

    def scalar(self, name: str) -> NDArray[numpy.float64]:
        """a particle scalar, e.g. "temperature" """
        with self._view() as view, self._set_up() as d:
            return column(lib.dem_scalar(d, self._scalar_number(d, name)), view.n)

    def _scalar_values(self, d, name, values, n):
        """The number of a particle scalar, and n values within its limits."""
        k = self._scalar_number(d, name)
        info, given = self._scalar_info(d, k), numbers(name, values, n)
        wrong = given[~((given >= info.min) & (given <= info.max) & numpy.isfinite(given))]
        if len(wrong):
            raise SunaError(f"{name} {wrong[0]:g} {string(info.unit)}; give a number from "
                            f"{info.min:g} to {info.max:g}")
        return k, given

    def set_scalar(self, name: str, values: ArrayLike) -> None:
        """Set a particle scalar between two advances: one value for all, or one for each of this rank's
        particles. Collective."""
        given, number = [], []    # type: list[NDArray[numpy.float64]], list[int]

        def prepare():
            with self._view() as view, self._set_up() as d:
                k, wanted = self._scalar_values(d, name, values, view.n)
                if name == "temperature" and view.n and view.clump != ffi.NULL:
                    _check_clumps(of_view(view, "clump"), wanted)
            given.append(numpy.ascontiguousarray(wanted))
            number.append(k)

        self._core_().any(prepare)    # an exception on one rank is one on all
        with self._set_up() as d:
            check(lib.dem_set_scalar(d, number[0], ffi.cast("double *", given[0].ctypes.data)))

    @property
    def material(self) -> NDArray[numpy.object_]:
        """names"""
        with self._set_up() as d:
            found = self._column("material")
            names = {k: string(lib.dem_material_name(d, int(k))) for k in numpy.unique(found)}
        return numpy.array([names[k] for k in found], object)

    def __len__(self) -> int:
        with self._view() as view:
            return view.n


def _check_clumps(clump, temperature):
    """Refuse temperatures that differ within a clump."""
    found, at = numpy.unique(clump, return_inverse=True)
    low, high = numpy.full(len(found), numpy.inf), numpy.full(len(found), -numpy.inf)
    numpy.minimum.at(low, at, temperature)
    numpy.maximum.at(high, at, temperature)
    wrong = found[(low < high) & (found > 0)]
    if len(wrong):
        raise SunaError(f"the spheres of the clump of particle {wrong[0] - 1} get different temperatures; "
                        "give all of them the same")
