"""render.py -- pictures of the particles of a run: a panel an instant, spheres coloured by a
velocity, walls and edges as lines; and the same as an animation.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from collections import namedtuple

import numpy

import spheres
from style import SIGNED, SPEEDS, image, plt, save

# position, velocity: n x 3 [m], [m/s]; diameter: n [m]
Panel = namedtuple("Panel", "title position velocity diameter")

PLAIN = {"plain": 0.4, "dark": 0.05}     # places on the scale SIGNED
FRONT = (0.22, 1, -0.2)         # view from the front, a little from above and the left


def box(low, high):
    """Edges of a box, those at its far side first."""
    low, high = numpy.asarray(low, float), numpy.asarray(high, float)
    corner = numpy.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)]
                          for k in range(8)])
    pairs = [(a, a | 1 << axis) for a in range(8) for axis in range(3) if not a >> axis & 1]
    return [corner[[a, b]] for a, b in sorted(pairs, key=lambda ab: -corner[list(ab), 1].sum())]


def colours(panel, quantity, top):
    """Red, green, blue of each particle: of `vertical` velocity or of `speed`, `top` [m/s] at the
    end of the colours; one colour for `plain` and `dark`."""
    if quantity in PLAIN:
        return numpy.tile(SIGNED(PLAIN[quantity])[:3], (len(panel.position), 1))
    if quantity == "vertical":
        return SIGNED(0.5 + 0.5*numpy.clip(panel.velocity[:, 2]/top, -1, 1))[:, :3]
    return SPEEDS(numpy.clip(numpy.linalg.norm(panel.velocity, axis=1)/top, 0, 1))[:, :3]


def frame(lines, towards=FRONT):
    """Left, lower, right and upper end [m] of what the camera sees of lines, with a margin."""
    ends = numpy.concatenate([line @ spheres.axes(towards, (0, 0, 1)).T for line in lines])[:, :2]
    margin = 0.01*numpy.ptp(ends, axis=0).max()
    return (*(ends.min(axis=0) - margin), *(ends.max(axis=0) + margin))


def shape(lines, towards=FRONT):
    """Height over width of the frame of lines."""
    window = frame(lines, towards)
    return (window[3] - window[1])/(window[2] - window[0])


def view(axes, lines, position, radius, colour, towards=FRONT, pixels=500):
    """Draw spheres into axes; `lines`: arrays of points [m], drawn behind the spheres if they lie behind
    their own middle; `pixels`: of the width."""
    camera = spheres.axes(towards, (0, 0, 1))
    window = frame(lines, towards)
    middle = numpy.mean([line.mean(axis=0) for line in lines], axis=0)[1]
    picture = spheres.draw(position, radius, colour, window, pixels/(window[2] - window[0]), towards)
    for line in lines:
        at = line @ camera.T
        axes.plot(at[:, 0], at[:, 1], color="0.55", lw=0.8,
                  zorder=0 if line[:, 1].mean() > middle else 3)
    axes.imshow(picture, extent=(window[0], window[2], window[1], window[3]), zorder=1,
                interpolation="antialiased")
    axes.set(xlim=window[0::2], ylim=window[1::2])
    axes.axis("off")


def figure(panels, lines, quantity, top, towards=FRONT, width=2.7, pixels=500, rows=1):
    """A figure with the panels side by side, each as `view` draws it; `width` [inches] of a panel."""
    columns = -(-len(panels)//rows)
    drawn, places = plt.subplots(rows, columns, squeeze=False,
                                 figsize=(width*columns + 0.5, rows*width*shape(lines, towards)))
    for axes, panel in zip(places.flat, panels):
        view(axes, lines, panel.position, 0.5*panel.diameter, colours(panel, quantity, top), towards,
             pixels)
        axes.set_title(panel.title, fontsize=9, y=0.97)
    for axes in places.flat:
        axes.axis("off")
    if quantity in PLAIN:
        return drawn
    signed = quantity == "vertical"
    bar = drawn.colorbar(plt.cm.ScalarMappable(plt.Normalize(-top if signed else 0, top),
                                               SIGNED if signed else SPEEDS),
                         ax=places, shrink=0.6, pad=0.01, aspect=25,
                         extend="both" if signed else "max")
    bar.set_label("vertical velocity [m/s]" if signed else "speed [m/s]", fontsize=8)
    bar.ax.tick_params(labelsize=8)
    return drawn


def draw(path, panels, lines, quantity, top=1, **options):
    """Write the panels as one picture."""
    save(figure(panels, lines, quantity, top, **options), path, dpi=160)


def animate(path, panels, lines, quantity, top, seconds, **options):
    """Write the panels one after the other as an animated WebP file, each for so many seconds."""
    options = {"pixels": 240, "width": 2.2, **options}
    images = []
    for panel in panels:
        drawn = figure([panel], lines, quantity, top, **options)
        images.append(image(drawn, dpi=110, bbox_inches=None).convert("RGB"))
        plt.close(drawn)
    images[0].save(path, save_all=True, append_images=images[1:], duration=round(1000*seconds),
                   loop=0, quality=40, method=6)
