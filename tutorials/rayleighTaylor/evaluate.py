"""evaluate.py -- growth of a wave between a suspension and the clear liquid below it.

References: the growth rate s of two deep layers of liquids of the same kinematic viscosity,

  short form   s^2 + 2 nu k^2 s - A g k = 0,   A = (rho_m - rho)/(rho_m + rho),
                                               rho_m = rho + alpha (rho_p - rho)
  exact        s^2 = A g k (1 - k/q),          q^2 = k^2 + s/nu,    for small A

(Chandrasekhar, Hydrodynamic and Hydromagnetic Stability (1961), chapter X). The short form includes
only the friction outside the interface. The liquids also slide past each other at the interface,
and a layer of thickness 1/q there takes more. The exact form follows from nu (D^2 - k^2)(D^2 - q^2)
w = (2 A g k^2/s) w(0) delta(z), with the solution exp(-k|z|)/k - exp(-q|z|)/q. A suspension of
beads with a short relaxation time is such a liquid as long as the beads settle little in the
meantime. On cells of length h the kernel smooths the density step over about h, which takes k h
from s^2 and k h/2 from s (a step that falls off exponentially over h: 1/(1 + k h)).

Ours: the wave of the lowest row of beads. It starts at rest, so a = a_0 cosh s t is fitted while
k a < 0.5.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"shared"))
import results      # noqa: E402

D, RHO, RHO_P, NU, G = 1e-4, 1000.0, 1200.0, 1e-6, 9.81


def growth(k, share):
    jump = share*(RHO_P - RHO)
    A = jump/(2*RHO + jump)
    return -NU*k*k + math.sqrt((NU*k*k)**2 + A*G*k)


def exact(k, share):
    """Fixed point from above."""
    jump = share*(RHO_P - RHO)
    most = jump/(2*RHO + jump)*G*k
    s = math.sqrt(most)
    for _ in range(200):
        s = math.sqrt(most*(1 - k/math.sqrt(k*k + s/NU)))
    return s


def amplitude(position, columns, length):
    """Amplitude of the first mode of the lowest row, over time [m]."""
    order = position[:, ::columns//2, :]            # beads are written column by column
    k = 2*math.pi/length
    x, z = order[:, :, 0], order[:, :, 2]
    # the wave changes the spacing of the row: least squares, not a sum
    return numpy.array([numpy.linalg.lstsq(numpy.stack([numpy.ones_like(a), numpy.cos(k*a),
        numpy.sin(k*a)], axis=1), b, rcond=None)[0][1]
                        for a, b in zip(x, z)]), z.mean(axis=1)


def fit(time, wave, k):
    """s of a_0 cosh s t, and its 95 % interval from four parts of the record, each fitted with the
    a_0 of all."""
    chosen = (k*wave < 0.5) & (time > 0)
    t, a = time[chosen], wave[chosen]

    def rate(pick, start):
        low, high = 0.0, 100.0
        for _ in range(60):
            s = 0.5*(low + high)
            low, high = (s, high) if numpy.sum(start*numpy.cosh(s*t[pick])) < numpy.sum(a[pick]) else (low, s)
        return s
    # a_0 by search: least squares in the logarithm
    starts = numpy.linspace(0.5, 1.5, 101)*a[0]
    everything = numpy.ones(len(t), bool)
    best = min(starts, key=lambda start: numpy.sum(numpy.log(a/(start*numpy.cosh(rate(everything,
        start)*t)))**2))
    late = numpy.array_split(numpy.flatnonzero(t > 0.3*t[-1]), 4)
    return rate(everything, best), results.mean_of([rate(part, best)
        for part in late])[1], best, t[-1]


def main():
    table, curves, shown = results.Table(), [], (math.inf, 0, None)
    for run in sorted((HERE/"runs").glob("length*"), key=lambda run: [float(x)
            for x in re.findall(r"[\d.]+", run.name)]):
        length, columns = re.fullmatch(r"length([\d.]+)-columns(\d+)", run.name).groups()
        length, columns = 1e-3*float(length), int(columns)
        k = 2*math.pi/length
        # one bead a cell of the slab, which is a diameter thick
        share = math.pi/6*D**2*columns**2/length**2
        time, position, _ = results.record(run)
        wave, level = amplitude(position, columns, length)
        own, interval, start, end = fit(time, wave, k)
        part = f"wave of {1e3*length:g} mm, solid's share {share:.3f}"
        # the bound is for waves long compared with a bead, k d < 0.05
        table.add(part, "growth rate, short form", growth(k, share), own, interval, "1/s",
                  0.20 if k*D < 0.05 else None, "Chandrasekhar")
        table.add(part, "growth rate, exact", exact(k, share), own, interval, "1/s",
                  0.5*k*length/columns, "Chandrasekhar")
        table.add(part, "k d", 0, k*D)
        # distance that the beads settle through the liquid meanwhile: small, else the suspension is
        # not like a heavier liquid
        table.add(part, "k times the way that the suspension has settled by the end of the fit", 0,
                  k*(level[0] - numpy.interp(end, time, level)))
        curves.append((part, time, k*wave, exact(k, share), k*start))
        shown = min(shown, (abs(columns - 56), length, run))
    table.write(HERE)
    with results.pictures():
        draw(curves)
        draw_suspension(*shown[:0:-1])


def draw(curves):
    from style import GREY, below, panels, save

    figure, (axis,) = panels(1, 6, 3.8)
    for n, (part, time, wave, rate, start) in enumerate(curves):
        length, share = re.fullmatch(r"wave of (\S+) mm, solid's share (\S+)", part).groups()
        axis.semilogy(time, wave, "o", ms=3.5, mfc="none", color=f"C{n}",
                      label=f"Suna, wavelength {length} mm, solid fraction {share}")
        axis.semilogy(time, start*numpy.cosh(rate*time), "-", color=f"C{n}", lw=1.2)
    axis.plot([], [], "-", color="k", lw=1.2, label="linear theory (lines)")
    axis.axhline(0.5, color=GREY, lw=0.8)
    axis.annotate("end of the fit", (0, 0.5), (0, 3), textcoords="offset points", fontsize=8, color=GREY)
    axis.set(xlabel="time [s]", ylabel="amplitude times wavenumber", ylim=(0.04, 1.2))
    below(figure, columns=1)
    save(figure, HERE/"growth.png")


def draw_suspension(case, length):
    """The beads at four instants, seen from the front."""
    import frames
    import render
    listed = frames.list_frames(case)
    shown = [listed[round(k*(len(listed) - 1)/3)] for k in range(4)]
    panels = [render.Panel(f"{time:.2f} s", *frames.read_frame(*place)) for time, *place in shown]
    render.draw(HERE/"suspension.png", panels, render.box((0, 0, 0), (length, 0, length)), "dark", 1, towards=(0, 1, 0), pixels=700)


if __name__ == "__main__":
    main()
