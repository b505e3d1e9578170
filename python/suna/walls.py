"""walls.py -- a wall of a simulation: load, impulse, corners, wear, motion.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy
from numpy.typing import NDArray

from ._arguments import SunaError
from ._core import check, string
from ._library import ffi, lib


class Wall:
    """A wall of the scene; its forces are exerted by the particles."""

    def __init__(self, simulation, name):
        self._simulation, self.name = simulation, name

    def _number(self, d):
        for k in range(lib.dem_wall_count(d)):
            if string(lib.dem_wall_name(d, k)) == self.name:
                return k
        raise SunaError(f"the simulation has no wall {self.name} any more")

    def _entry(self):
        """The path of its entry in the scene; a face of a box is one of its `faces`."""
        box, face = self.name[:-4], self.name[-4:]
        if not self._simulation.names(f"walls/{self.name}") and self._simulation.names(f"walls/{box}"):
            return f"walls/{box}/faces/{face[0].lower()}{face[1:]}"
        return f"walls/{self.name}"

    def _pair(self, call):
        one, other = ffi.new("double[3]"), ffi.new("double[3]")
        with self._simulation._set_up() as d:
            check(call(d, self._number(d), one, other))
        return numpy.array(list(one)), numpy.array(list(other))

    @property
    def load(self) -> tuple[NDArray[numpy.float64], NDArray[numpy.float64]]:
        """Present force [N] and torque about the origin [N m]. Collective."""
        return self._pair(lib.dem_wall_load)

    @property
    def force(self) -> NDArray[numpy.float64]:
        """Present force [N]. Collective."""
        return self.load[0]

    @property
    def impulse(self) -> tuple[NDArray[numpy.float64], NDArray[numpy.float64]]:
        """Impulse [N s] and its moment about the origin [N m s] since reset_impulses. Collective."""
        return self._pair(lib.dem_wall_impulse)

    @property
    def corners(self) -> NDArray[numpy.float64]:
        """Corners of its triangles, n x 3 x 3 [m], on the first rank; none of planes, cylinders,
        spheres. Collective."""
        info = ffi.new("struct dem_wall_info *")
        with self._simulation._set_up() as d:
            number = self._number(d)
            lib.dem_wall_info(d, number, info)
            corners = numpy.empty((info.triangles, 3, 3))
            check(lib.dem_wall_corners(d, number, ffi.cast("double *", corners.ctypes.data)))
        return corners

    @property
    def wear(self) -> NDArray[numpy.float64]:
        """Volume that has worn off each of its triangles [m3], in the order of corners, on the first rank; the
        scene gives the wall a law of wear. Collective."""
        with self._simulation._set_up() as d:
            number = self._number(d)
            if not lib.dem_wall_wears(d, number):
                raise SunaError(f"wall {self.name} has no law of wear; give it `wear` in the scene")
            info = ffi.new("struct dem_wall_info *")
            lib.dem_wall_info(d, number, info)
            volumes = numpy.zeros(info.triangles)
            check(lib.dem_wall_wear(d, number, ffi.from_buffer("double[]", volumes)))
        return volumes

    def _motion(self):
        """The path of its motion in the scene; a face moves with its box, or alone."""
        own, box = self._entry(), f"walls/{self.name[:-4]}"
        names = self._simulation.names(box) if "/faces/" in own else []
        return f"{box}/motion" if "motion" in names else f"{own}/motion"

    @property
    def motion(self) -> Mapping[str, Any] | list[Mapping[str, Any]]:
        """Its motion as a dict of texts, a list of them if it has several, {} at rest. Set it to such entries of a
        scene, or None; the wall goes on from where it stands. Collective."""
        path, found = self._motion(), []    # type: str, list[Mapping[str, Any]]
        while self._simulation.names(f"{path}/{len(found)}"):
            found.append(self._simulation.entries(f"{path}/{len(found)}"))
        return found or self._simulation.entries(path)

    @motion.setter
    def motion(self, entries: Mapping[str, Any] | Sequence[Mapping[str, Any]] | None) -> None:
        path = self._motion()
        if not path.startswith(self._entry()):
            raise SunaError(f"{self.name} moves with its box; set the motion of all six with "
                            f'change({{"{path}": ...}}), None to end it')
        if entries or self.motion:
            self._simulation.change({path: entries or None})

    def remove(self) -> None:
        """Remove the wall. Collective."""
        if self._entry() != f"walls/{self.name}":
            raise SunaError(f"{self.name} is a face of a box, which has six; remove the box, "
                            'change({"walls/BOX": None}), or describe the walls as planes')
        self._simulation.change({f"walls/{self.name}": None})

    def __repr__(self):
        return f"Wall({self.name!r})"
