"""output.py -- a simulation as files, tables and pictures of other programs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import importlib
import os
from typing import Any

import numpy
from numpy.typing import ArrayLike, NDArray

from ._arguments import File, SunaError, file_name, numbers
from .arrays import Arrays
from .files import write_vtp


class Output(Arrays):
    """Part of Simulation."""

    def to_vtk(self, path: File) -> None:
        """Write the particles of this rank for ParaView (.vtp), with the names of the program's files:
        id, material, diameter, velocity, spin, force, clump, and the particle scalars."""
        write_vtp(os.fsdecode(file_name("path", path)), self._arrays())

    def to_dataframe(self) -> Any:
        """The particles of this rank as a pandas.DataFrame: a row for each id, in rising order, with units
        in `attrs`. Needs pandas."""
        pandas = _optional("pandas", "python3-pandas")
        columns, units = {}, {}
        for name, unit in (("position", "m"), ("velocity", "m/s"), ("spin", "1/s"), ("force", "N"), ("torque", "N m")):
            values = getattr(self, name)
            for k, axis in enumerate("xyz"):
                label = axis if name == "position" else f"{name}_{axis}"
                columns[label], units[label] = values[:, k], unit
        columns.update(diameter=2*self.radius, mass=self.mass, material=self.material, frozen=self.frozen,
                       **self._clumps_and_scalars())
        units.update(diameter="m", mass="kg")
        table = pandas.DataFrame(columns, index=pandas.Index(self.id, name="id")).sort_index()
        table.attrs["units"] = units
        return table

    def to_pyvista(self) -> Any:
        """The particles of this rank as pyvista.PolyData, with the arrays of to_vtk; draw them with
        sim.to_pyvista().glyph(scale="diameter", geom=pyvista.Sphere()). Needs pyvista."""
        points = _optional("pyvista", None).PolyData(numpy.array(self.position))
        for name, values in self._arrays().items():
            if name != "points":
                points[name] = values
        return points

    def _arrays(self) -> dict[str, NDArray]:
        """Arrays for ParaView, with the names of the program's files."""
        return {"points": self.position, "id": self.id,
                "material": self._column("material").astype(numpy.int64), "diameter": 2*self.radius,
                "velocity": self.velocity, "spin": self.spin, "force": self.force, **self._clumps_and_scalars()}

    def _clumps_and_scalars(self):
        clump = self.clump
        return {**({"clump": clump} if clump.any() else {}), **{name: self.scalar(name) for name in self.scalars}}

    def plot(self, axes: Any = None, colour: ArrayLike | None = None, plane: str = "xz") -> Any:
        """Draw the particles as circles with matplotlib; `colour`: a number for each, else the
        speed. Returns the axes."""
        if not isinstance(plane, str) or len(plane) != 2 or len(set(plane)) != 2 or not set(plane) < set("xyz"):
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


def _optional(module, package):
    """A module that only some calls need."""
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError:
        way = f"on Debian it is {package}" if package else f"pip install {module}; Debian 12 has no package"
        raise ImportError(f"this call needs {module}: {way}") from None
