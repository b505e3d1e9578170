"""plots.py -- profiles with the measured points, the pressure over time, and pictures of the bed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import frames
import picture

OURS, MEASURED = "#c8401f", "#1d3557"
RADIUS = 0.6e-3                                     # m
SPEED = 0.4                                         # m/s, end of the colours
HEIGHT = 0.085                                      # m of the column that is shown
SCALE = 13000                                       # pixels per metre

plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
                     "axes.grid": True,
                     "grid.alpha": 0.25, "savefig.dpi": 160, "savefig.bbox": "tight"})


def draw_profiles(case, profiles, centres):
    rows = 1 if len(profiles) == 2 else 2                   # void fraction above, velocity below
    figure, panels = plt.subplots(rows, 3, figsize=(11, 3.1*rows), squeeze=False)
    places = [*panels[0, :2], *panels[1:].flat]
    for axes, p in zip(places, profiles):
        axes.fill_between(1e3*centres, p.profile - p.interval, p.profile + p.interval, color=OURS,
                          alpha=0.22, lw=0)
        axes.plot(1e3*centres, p.profile, color=OURS, lw=1.8)
        axes.plot(1e3*p.measured[0], p.measured[1], "o", ms=4, mfc="none", color=MEASURED)
        name = "void fraction" if p.quantity == "voidFraction" else "vertical velocity [m/s]"
        axes.set(xlabel="x [mm]", xlim=(0, 44))
        axes.set_title(f"{name} at {p.height:g} mm", loc="left", fontsize=9.5)
        axes.set_title(f"rms {p.rms:.3f}", loc="right", fontsize=8.5, color="0.35")
    for axes in panels[0, :2]:
        axes.set_ylim(0.3, 0.9)
    legend = panels[0, 2]
    legend.axis("off")
    legend.plot([], [], "o", ms=4, mfc="none", color=MEASURED,
                label="measured, Mueller et al. 2008/2009")
    legend.plot([], [], color=OURS, lw=1.8, label="Suna, mean over beads")
    legend.fill_between([], [], [], color=OURS, alpha=0.22, lw=0, label="its 95 % interval")
    legend.legend(loc="center left", frameon=False, fontsize=10)
    figure.tight_layout()
    figure.savefig(case/"profiles.png")
    plt.close(figure)


def draw_pressure(case, balance):
    time, drop = balance.time, balance.drop
    figure, axes = plt.subplots(figsize=(9, 3))
    axes.plot(time, drop, color=OURS, lw=0.7)
    axes.axhline(balance.weight, color=MEASURED, lw=1.2,
                 label=f"weight of the beads {balance.weight:.1f} Pa")
    axes.axhline(balance.mean, color=OURS, lw=1.2, ls="--",
                 label=f"mean {balance.mean:.1f} $\\pm$ {balance.interval:.1f} Pa")
    low, high = numpy.percentile(drop, [0.5, 99.5])
    axes.set(xlabel="time [s]", ylabel="pressure drop [Pa]", xlim=(time[0], time[-1]),
             ylim=(min(0, 1.1*low), 1.15*max(high, balance.weight)))
    axes.legend(loc="upper right", ncols=2, fontsize=8)
    figure.savefig(case/"pressure.png")
    plt.close(figure)


def edges_of(camera, size):
    """The twelve edges of a column on the camera's plane, and whether they are behind the bed."""
    corner = numpy.array([(x, y, z) for x in (0, size[0]) for y in (0, size[1])
                          for z in (0, size[2])])
    at = corner @ camera.T
    return [(at[a, :2], at[b, :2], corner[a, 1] + corner[b, 1] > 1.5*size[1])
            for a in range(8) for b in range(a) if numpy.sum(corner[a] != corner[b]) == 1]


def draw_bed(case, instants, size=(0.044, 0.010, HEIGHT), radius=RADIUS, speed=SPEED, scale=SCALE,
             width=2.7):
    """The bed at some instants, beads coloured by their vertical velocity, in a column of glass of
    this size [m]; `width` of a panel in inches."""
    towards = (0.22, 1, -0.2)
    camera = picture.axes(towards, (0, 0, 1))
    edges = edges_of(camera, size)
    ends = numpy.array([end for edge in edges for end in edge[:2]])
    window = (*(ends.min(axis=0) - 1.5e-3), *(ends.max(axis=0) + 1.5e-3))
    colours = plt.get_cmap("RdYlBu_r")
    figure, panels = plt.subplots(1, len(instants), figsize=(width*len(instants) + 0.5,
                                                              width*(window[3] - window[1])/(window[2] - window[0])))
    for axes, (time, *place) in zip(numpy.atleast_1d(panels), instants):
        position, velocity, _ = frames.read_frame(*place)
        colour = colours(0.5 + 0.5*numpy.clip(velocity[:, 2]/speed, -1, 1))[:, :3]
        image = picture.draw(position, radius, colour, window, scale, towards)
        for a, b, behind in edges:
            axes.plot([a[0], b[0]], [a[1], b[1]], color="0.55", lw=0.8, zorder=0 if behind else 3)
        axes.imshow(image, extent=(window[0], window[2], window[1], window[3]), zorder=1,
                    interpolation="antialiased")
        axes.set(xlim=(window[0], window[2]), ylim=(window[1], window[3]))
        axes.set_title(f"{time:.2f} s", fontsize=9, y=0.97)
        axes.axis("off")
    bar = figure.colorbar(plt.cm.ScalarMappable(plt.Normalize(-speed, speed), colours), ax=panels,
                          shrink=0.5, pad=0.01,
                          aspect=25, extend="both")
    bar.set_label("vertical velocity of the beads [m/s]", fontsize=8)
    bar.ax.tick_params(labelsize=8)
    figure.savefig(case/"bed.png", dpi=200)
    plt.close(figure)


def draw_all(case, profiles, centres, balance):
    """Instants for the picture: from the second half, a few frames apart."""
    draw_profiles(case, profiles, centres)
    draw_pressure(case, balance)
    listed = frames.list_frames(case)
    chosen = sorted({max(0, len(listed) - 1 - back) for back in (12, 8, 4, 0)})
    draw_bed(case, [listed[k] for k in chosen])
