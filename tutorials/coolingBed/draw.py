"""draw.py -- the mean temperature over time beside closed forms, the rate of heat loss, and the beads
coloured by temperature.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

import evaluate
import render           # of muellerBed, in the path by results, like style
from style import COLOURS, OURS, REFERENCE, SPEEDS, plt, save

ZERO = 273.15


def draw_cooling(case, run, window):
    figure, (above, below) = plt.subplots(2, 1, figsize=(8, 5.6), height_ratios=(1.5, 1))
    time = numpy.linspace(0, run.time[-1], 200)
    closed = run.closed(time)
    above.fill_between(time, closed["slowest"] - ZERO, closed["fastest"] - ZERO, color=COLOURS[5],
                       alpha=0.25, lw=0, label="between fastest and slowest closed form")
    above.plot(time, closed["perfect"] - ZERO, "--", color=REFERENCE, lw=1.3,
               label="closed form: air leaves at the mean of the beads")
    above.plot(run.time, run.mean - ZERO, color=OURS, lw=1.5, label="Suna, mean of the beads")
    above.set(xlabel="time [s]", ylabel="temperature [C]", xlim=(0, run.time[-1]))
    above.legend(loc="lower left")
    middle, rate = run.rate(window)
    below.axhline(1, color=REFERENCE, lw=1.3, ls="--")
    below.plot(middle, rate, "o-", ms=3, lw=0.9, color=OURS)
    below.set(xlabel="time [s]", ylabel="heat loss over the loss in\nperfect exchange",
              xlim=(0, run.time[-1]), ylim=(0, None))
    figure.tight_layout()
    save(figure, case/"cooling.png")


def draw_bed(case, run, height=0.12, panels=4):
    folders = run.folders()
    if not folders:
        return
    chosen = sorted({round(k) for k in numpy.linspace(0, len(folders) - 1, panels)})
    lines = render.box((0, 0, 0), (run.width, run.depth, height))
    figure, places = plt.subplots(1, len(chosen), squeeze=False,
                                  figsize=(2.4*len(chosen) + 0.5, 2.4*render.shape(lines)))
    for axes, k in zip(places.flat, chosen):
        time, folder = folders[k]
        position, temperature = evaluate.beads_of(folder)
        # relative to the mean of the instant: by how much a bead lags
        share = 0.5 + (temperature - temperature.mean())/8
        render.view(axes, lines, position, numpy.full(len(position), 0.5*run.diameter),
                    SPEEDS(numpy.clip(share, 0, 1))[:, :3], pixels=420)
        axes.set_title(f"{time:g} s, mean {temperature.mean() - ZERO:.1f} C", fontsize=8)
    bar = figure.colorbar(plt.cm.ScalarMappable(plt.Normalize(-4, 4), SPEEDS), ax=places, shrink=0.7,
                          pad=0.01, aspect=25, extend="both")
    bar.set_label("above the mean of the instant [K]", fontsize=8)
    save(figure, case/"bed.png", dpi=140)
