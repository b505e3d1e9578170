"""draw.py -- profiles of the speed with the measured points, and pictures of the bed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

import frames           # of muellerBed, in the path by results, like render and style
import render
from style import OTHER, OURS, REFERENCE as MEASURED, plt, save

SHOWN = 3               # instants of the picture
APART = 6               # instants of the record between them


def draw_speeds(case, shares, centres, profiles, measured):
    figure, panels = plt.subplots(2, 3, figsize=(11, 5.6), sharex=True, sharey=True)
    for axes, share, (speed, half), points in zip(panels.flat, shares, profiles, measured):
        axes.fill_between(1e3*centres, speed - half, speed + half, color=OURS, alpha=0.22, lw=0)
        axes.plot(1e3*centres, speed, color=OURS, lw=1.8, label="Suna")
        for (x, of), mark, colour, side in zip(points, "os", (MEASURED, OTHER), ("left", "right")):
            axes.plot(1e3*x, of, mark, ms=3.5, mfc="none", color=colour,
                      label=f"measured, {side}, Yue et al. 2020")
        axes.set_title(f"at {share:.2f} of the height at rest", loc="left", fontsize=9.5)
    for axes in panels[1]:
        axes.set_xlabel("distance from the middle [mm]")
    for axes in panels[:, 0]:
        axes.set_ylabel("speed of the beads [m/s]")
    panels[0, 0].set(xlim=(0, 140), ylim=(0, None))     # of all, after the last curve
    panels[0, 2].legend(loc="upper right", fontsize=8)
    figure.tight_layout()
    save(figure, case/"speed.png")


def draw_bed(case, run):
    """A quarter with its mirror image at the plane x = 0, or the whole bed."""
    listed = frames.list_frames(run)
    panels = []
    for time, *place in listed[-1 - APART*(SHOWN - 1)::APART]:
        position, velocity, diameter = frames.read_frame(*place)
        if position[:, 0].min() > 0:
            mirror = numpy.array([-1, 1, 1])
            position, velocity = (numpy.concatenate([of*mirror, of]) for of in (position, velocity))
        panels.append(render.Panel(f"{time:.2f} s", position, velocity, numpy.full(len(position), diameter[0])))
    edges = render.box((-0.14, 0, 0), (0.14, position[:, 1].max(), 0.35))
    render.draw(case/"bed.png", panels, edges, "vertical", 1)
