"""side.py -- pictures of water and grains from the side, and animations of them.

A run needs its cell centres, `postProcess -func writeCellCentres -time 0`. The water is the mean of its fraction
across the run.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re

import numpy

import results


def times(run):
    """The folders of the written times after the start."""
    return sorted((path for path in run.iterdir() if re.fullmatch(r"\d+\.?\d*", path.name) and float(path.name) > 0),
                  key=lambda path: float(path.name))


def grains(folder):
    """Positions of the particles [m]."""
    path = folder/"lagrangian/particles/positions"
    return results.field(path)[:, :3] if path.exists() else numpy.empty((0, 3))


def to_walls(points, values):
    """Centres of cells in rows, and values there, with half a cell more at both ends of each row and below."""
    more, copied = [points], [values]
    for z in numpy.unique(points[:, 1]):
        row = numpy.nonzero(points[:, 1] == z)[0]       # in order of x
        for end, next_to in ((row[0], row[1]), (row[-1], row[-2])):
            more.append([1.5*points[end] - 0.5*points[next_to]])
            copied.append([values[end]])
    low, above = numpy.unique(points[:, 1])[:2]
    lowest = points[:, 1] == low
    more.append(points[lowest] - [0, (above - low)/2])
    copied.append(values[lowest])
    return numpy.concatenate(more), numpy.concatenate(copied)


def view(axis, run, folder, diameter):
    """Water and grains of one time from the side: x and z in mm."""
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Circle
    from style import OURS, REFERENCE

    places = numpy.round(1e3*results.field(run/"0/C")[:, [0, 2]], 6)
    points, column = numpy.unique(places, axis=0, return_inverse=True)
    alpha = numpy.resize(results.field(folder/"alpha.water")[:, 0], len(places))
    points, alpha = to_walls(points, numpy.bincount(column.ravel(), alpha)/numpy.bincount(column.ravel()))
    if alpha.max() > 0.5:
        axis.tricontourf(*points.T, alpha, [0.5, 2], colors=REFERENCE, alpha=0.25)
    at = 1e3*grains(folder)
    axis.add_collection(PatchCollection([Circle((x, z), 500*diameter) for x, _, z in at[numpy.argsort(-at[:, 1])]],
                                        facecolor=OURS, edgecolor="white", linewidth=0.2))
    axis.set(title=f"{float(folder.name):g} s", xlabel="x [mm]", aspect="equal")
    axis.grid(False)


def series(path, run, folders, diameter, height, finish, **options):
    """A picture with these times side by side; `finish(axis)` adds walls and limits."""
    from style import panels, save

    figure, axes = panels(len(folders), height=height, sharey=True, **options)
    for axis, folder in zip(axes, folders):
        view(axis, run, folder, diameter)
        finish(axis)
    axes[0].set_ylabel("z [mm]")
    save(figure, path)


def animate(path, run, diameter, seconds, finish, size=(4, 3.2)):
    """All written times one after the other, each for so many seconds, as an animated WebP file."""
    from style import image, plt

    images = []
    for folder in times(run):
        figure, axis = plt.subplots(figsize=size, layout="constrained")
        view(axis, run, folder, diameter)
        finish(axis)
        axis.set_ylabel("z [mm]")
        images.append(image(figure, dpi=90, bbox_inches=None).convert("RGB"))
        plt.close(figure)
    images[0].save(path, save_all=True, append_images=images[1:], duration=round(1000*seconds), loop=0, quality=45,
                   method=6)
