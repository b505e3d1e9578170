"""draw.py -- height and pressure over time with the measured points, and pictures of the bed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import plots            # of muellerBed, in the path by results, like style
import series
from style import OURS, REFERENCE as MEASURED, below, plt, save

SHOWN = 3.0             # s of each course


def draw_course(case, start, height, pressure, measured_height, measured_pressure):
    """Time counts from the first point of each, as the phase of bubbles is random."""
    figure, panels = plt.subplots(3, 1, figsize=(9, 7.5), height_ratios=(1, 1, 1.1))
    time, values = pressure[0][pressure[0] >= start], pressure[1][pressure[0] >= start]
    rows = [(panels[0], "height of the bed [mm]", height[0], 1e3*height[1], measured_height[0],
             1e3*measured_height[1]),
            (panels[1], "pressure at 45 mm\nless its mean [Pa]", time, values - values.mean(),
             *measured_pressure)]
    for axes, name, ours_at, ours, at, theirs in rows:
        axes.plot(ours_at - ours_at[0], ours, color=OURS, lw=1.2, label="Suna")
        axes.plot(at - at[0], theirs, "o-", ms=2.5, lw=0.8, mfc="none", color=MEASURED,
                  label="measured, van Wachem et al. 2001")
        axes.set(ylabel=name, xlim=(0, SHOWN), xlabel="time [s]")
    for at, p, colour in ((time, values, OURS), (*measured_pressure, MEASURED)):
        even = series.even(at, p)[1]
        frequency, power = series.power(even)
        # Hann's window has 3/8 of the square: power over frequency, twice for the negative ones
        panels[2].semilogy(frequency, 2*series.STEP*power/(0.375*len(even)), color=colour, lw=1.2)
    panels[2].set(xlim=(0, 10), ylim=(1, None), xlabel="frequency [Hz]",
                  ylabel="spectrum of the pressure\n[Pa$^2$/Hz]")
    figure.tight_layout()
    below(figure, panels[0])
    save(figure, case/"course.png")


def draw_bed(case, bed, height=0.2):
    chosen = sorted({max(0, len(bed.listed) - 1 - back) for back in (36, 24, 12, 0)})
    plots.draw_bed(case, [bed.listed[k] for k in chosen], (bed.width, bed.depth, height), 0.6)
