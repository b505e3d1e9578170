"""particles.py -- particles as arrays: copies, a view without copy, and what a function gets that gives
forces.

Memory of the library moves or goes with the next call that changes the simulation, while Python may
keep an array for ever. So arrays are copies; arrays of a view hold the memory that they show
(_core.py), and show the past once the simulation has gone on.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import re
from typing import Any

import numpy
from numpy.typing import ArrayLike, NDArray

from ._arguments import SunaError, numbers
from ._library import ffi

# kind and width of the quantities of struct dem_view
WIDTH = {"position": 3, "velocity": 3, "spin": 3, "radius": 1, "mass": 1, "id": 1, "material": 1,
         "flags": 1, "clump": 1, "force": 3, "torque": 3, "orientation": 4}
STRIDED = ("position", "velocity", "spin", "radius", "mass", "id", "material", "flags", "clump")


def _kind(pointer):
    return numpy.dtype({"double": numpy.float64, "int64_t": numpy.int64, "uint16_t": numpy.uint16}[
        re.match(r"(\w+)", ffi.typeof(pointer).item.cname)[0]])


def _brief(value):
    return f"an array of shape {value.shape}" if isinstance(value, numpy.ndarray) else repr(value)[:40]


def column(pointer, n, width=1, stride=None):
    """Numbers of the library as a read-only array, n or n x width: a copy."""
    kind = _kind(pointer)
    shape = (n, width) if width > 1 else (n,)
    array = numpy.empty(shape, kind)
    if n > 0:
        stride = stride or width*kind.itemsize
        raw = ffi.buffer(pointer, (n - 1)*stride + width*kind.itemsize)
        array[:] = numpy.ndarray(shape, kind, raw, strides=(stride, kind.itemsize)[:len(shape)])
    array.flags.writeable = False
    return array


def of_view(view, name):
    """A quantity of struct dem_view: a copy."""
    return column(getattr(view, name), view.n, WIDTH[name], view.stride if name in STRIDED else None)


class View:
    """Quantities of this rank's particles, without copy and read-only: position, velocity, spin,
    radius, mass, id, force, torque, orientation. It is valid in its `with` block; arrays that are kept longer keep
    their values."""

    position: NDArray[numpy.float64]
    velocity: NDArray[numpy.float64]
    spin: NDArray[numpy.float64]
    radius: NDArray[numpy.float64]
    mass: NDArray[numpy.float64]
    id: NDArray[numpy.int64]
    force: NDArray[numpy.float64]
    torque: NDArray[numpy.float64]
    orientation: NDArray[numpy.float64]

    def __init__(self, view: Any, lend: Any) -> None:
        self._view, self._lend = view, lend

    def __len__(self) -> int:
        return self._open().n

    def _open(self):
        if self._view is None:
            raise SunaError("the view is closed; use it in its `with` block")
        return self._view

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in WIDTH or name in ("material", "flags", "clump"):
            raise AttributeError(f"a view has no {name}")
        view = self._open()
        pointer, n, width = getattr(view, name), view.n, WIDTH[name]
        shape = (n, width) if width > 1 else (n,)
        if n == 0:
            return numpy.empty(shape, _kind(pointer))
        if pointer == ffi.NULL:
            raise SunaError(f"{name} is not kept; create Simulation(..., {name}=True)")
        kind = _kind(pointer)
        strided = name in STRIDED
        block = view.position if strided else pointer
        stride = view.stride if strided else width*kind.itemsize
        offset = int(ffi.cast("intptr_t", pointer)) - int(ffi.cast("intptr_t", block))
        return numpy.ndarray(shape, kind, self._lend(block, n*stride), offset,
                             (stride, kind.itemsize)[:len(shape)])


class Forces:
    """This rank's particles in a step, and the force [N] and torque [N m], 0 at first, that a function
    adds to: force and torque are arrays to be written, all else is read-only. Positions are at `time`
    [s], velocities half a step before; contact_force is of the step before."""

    position: NDArray[numpy.float64]
    velocity: NDArray[numpy.float64]
    spin: NDArray[numpy.float64]
    radius: NDArray[numpy.float64]
    mass: NDArray[numpy.float64]
    id: NDArray[numpy.int64]

    def __init__(self, time: float, view: Any, force: Any, torque: Any) -> None:
        self.time, self._view, self._to = time, view, {"force": force, "torque": torque}
        self._given: dict[str, NDArray[numpy.float64]] = {}

    def __len__(self) -> int:
        return self._view.n

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in WIDTH or name in ("material", "flags", "clump", "orientation"):
            raise AttributeError(f"a force has no {name} of the particles")
        value = of_view(self._view, name)
        self.__dict__[name] = value
        return value

    @property
    def contact_force(self) -> NDArray[numpy.float64]:
        return of_view(self._view, "force")

    @property
    def force(self) -> NDArray[numpy.float64]:
        return self._get("force")

    @force.setter
    def force(self, value: ArrayLike) -> None:
        self._given["force"] = numpy.array(numbers("force", value, (len(self), 3)))

    @property
    def torque(self) -> NDArray[numpy.float64]:
        return self._get("torque")

    @torque.setter
    def torque(self, value: ArrayLike) -> None:
        self._given["torque"] = numpy.array(numbers("torque", value, (len(self), 3)))

    def _get(self, name):
        if name not in self._given:
            self._given[name] = numpy.zeros((len(self), 3))
        return self._given[name]

    def ask(self, function):
        """Call the function and add what it gives."""
        answer = function(self)
        if answer is not None and all(answer is not value for value in self._given.values()):
            name = getattr(function, "__name__", function)
            raise SunaError(f"the force {name} returned {_brief(answer)}; a returned value does not act: add to p.force "
                            "instead, as in p.force += F, and return nothing")
        for name, value in self._given.items():
            if len(self):
                numpy.frombuffer(ffi.buffer(self._to[name], 24*len(self)))[:] += value.ravel()
        self._view = None
