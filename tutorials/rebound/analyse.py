#!/usr/bin/env python3
"""analyse.py -- restitution in liquids over the Stokes number, and flights of a bouncing sphere,
beside measurements.

    analyse.py [-store "text"]       result.csv, rebound.png; with -store also stored/ and the table of results.md

Stokes number  St = rho_p d v/(9 mu) of the impact
Computed e     rebound speed over impact speed; only the contact (and the film) acts
Measured e     from the flights of Gondret et al. (2002): speeds at the plate from parabolas through
               the last five points before an impact and the first five after it, without points
               within 0.1 mm of the plate; intervals from the scatter of the points. At St 27 no
               point was recorded before the impact: its speed follows from the Reynolds number,
               taken as exact
Bands          most of the e/e_max measured by Gondret et al. and by Joseph et al. (2001), as far as
               their figures can be read

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import numpy
from dem_case import GREY, MEASURED, OTHER, OURS, REFERENCE, Result, below, panels, pictures, read_vtp, \
    save, store, student

BEST = 0.97                                         # e_max, of the contact without liquid
# Re of the impact, St: diameter [m], density and viscosity of the liquid, speed [m/s]
SETS = {27: (6e-3, 965, 0.1, 0.518135), 100: (4e-3, 953, 0.02, 0.577125),
        152: (3e-3, 935, 0.01, 0.584670),
        193: (6e-3, 953, 0.02, 0.741518), 742: (5e-3, 920, 0.005, 0.856522)}
BANDS = [(9, 16, 0, 0.15), (27, 33, 0.25, 0.40), (45, 55, 0.42, 0.58), (93, 108, 0.62, 0.78),
         (140, 165, 0.72, 0.84),
         (275, 325, 0.82, 0.93), (900, 1100, 0.93, 1.0)]
FORMS = (("stokesDamping", "by the law of contact with the run's viscosity"),
         ("added", "by the law of contact with added mass"),
         ("instantaneous", "with the speed of the moment (LIGGGHTS)"),
         ("film", "by a film of roughness 1e-4 R"),
         ("rough", "by a film of roughness 1e-3 R"),
         ("acts", "by a film of 1e-4 R that acts on in contact of steel"),
         ("softActs", "by a film of 1e-4 R that acts on in contact of 1e9 Pa"))


def speeds(folder):
    """Vertical velocities at the start and at the end."""
    listed = pictures(folder)
    return read_vtp(listed[0][1])["velocity"].reshape(-1, 3)[:,
        2], read_vtp(listed[-1][1])["velocity"].reshape(-1, 3)[:, 2]


def restitution(folder):
    before, after = speeds(folder)
    return numpy.maximum(-after/before, 0.0)


def flight(folder, radius):
    """Height above the plate over the time since the first impact."""
    listed = pictures(folder)
    time = numpy.array([t for t, _ in listed])
    height = numpy.array([read_vtp(path)["points"].reshape(-1, 3)[0, 2]
                          for _, path in listed]) - radius
    low = numpy.flatnonzero((height[1:-1] < height[:-2]) & (height[1:-1] <= height[2:]))[0] + 1
    # the impact is between two pictures: the time at which the extrapolated path reaches the plate
    fall = (height[low - 2] - height[low - 1])/(time[low - 1] - time[low - 2])
    return time - time[low - 1] - height[low - 1]/fall, height


def at_plate(time, height):
    """Time and speed at height 0 of a parabola through points, and the 95 % interval of the
    speed."""
    fit, covariance = numpy.polyfit(time, height, 2, cov="unscaled")
    left = height - numpy.polyval(fit, time)
    freedom = len(time) - 3
    covariance = covariance*(left @ left)/freedom
    roots = numpy.roots(fit)
    root = roots[numpy.argmin(abs(roots - time[numpy.argmin(height)]))].real
    slope = numpy.array([2*root, 1.0, 0.0])
    return root, numpy.polyval(numpy.polyder(fit),
                               root), student(freedom)*numpy.sqrt(slope @ covariance @ slope)


def measured_impacts():
    """St, e and its interval of each impact in the measured trajectories."""
    found = []
    for st, arrivals in ((27, [None]), (152, [-0.0006, 0.0835, 0.1300])):
        d, density, viscosity, speed = SETS[st]
        t, h = numpy.loadtxt(f"measured/St{st}.csv", delimiter=",", skiprows=2).T
        for arrival in arrivals:
            # recorded from the impact on: the speed before follows from the Reynolds number
            if arrival is None:
                down, spread_down, after = speed, 0.0, t > 0
            else:
                early = numpy.flatnonzero((t < arrival) & (h > 1e-4))[-5:]
                _, slope, spread_down = at_plate(t[early], h[early])
                down, after = -slope, t > arrival
            late = numpy.flatnonzero(after & (h > 1e-4))[:5]
            _, up, spread_up = at_plate(t[late], h[late])
            found.append((7800*d*down/(9*viscosity), up/down,
                          up/down*numpy.hypot(spread_up/up, spread_down/down)))
    return numpy.array(found)


LOOKS = {"stokesDamping": (OURS, "s", "Suna, law of contact"),
         "instantaneous": (GREY, "v", "Suna, speed of the moment (LIGGGHTS)"),
         "film": (OTHER, "^", "Suna, film of roughness 1e-4 R"), "rough": (OTHER, "<", "Suna, film of 1e-3 R"),
         "acts": (OTHER, "x", "Suna, film of 1e-4 R that acts on in contact")}


def draw_restitution(axes, measured, computed):
    st = numpy.geomspace(4, 1100, 300)
    for k, (low, high, bottom, top) in enumerate(BANDS):
        axes.fill_between([low, high], bottom, top, color=REFERENCE, alpha=0.2, lw=0,
                          label=None if k else "measured: Gondret 2002, Joseph 2001 (bands)")
    axes.errorbar(measured[:, 0], measured[:, 1]/BEST, measured[:, 2]/BEST, capsize=3, lw=1,
                  label="from measured flights, 95 % interval", **MEASURED)
    axes.plot(st, numpy.exp(-35/st), color=OURS, lw=1, label="exp(-35/St), Legendre et al. 2006")
    axes.plot(st, numpy.maximum(1 - (1/BEST + 1)*numpy.log(1e3)/st, 0), color=OTHER, lw=1,
              label="closed form of the film")
    for form, (colour, mark, label) in LOOKS.items():
        points = [(x, e) for x, e in computed.get(form, [])]
        if Path(f"runs/twelve.{form}").is_dir():
            before, after = speeds(f"runs/twelve.{form}")
            points += list(zip(-7800*6e-3*before/0.9, numpy.maximum(-after/before, 0)))
        if points:
            x, e = numpy.array(points).T
            axes.plot(x, e/BEST, mark, ms=5, mfc="none", color=colour, label=label)
    axes.set(xscale="log", xlabel="Stokes number St", ylabel=r"restitution $e/e_{\max}$", ylim=(-0.02, 1.05))


def draw(measured, computed, flights):
    figure, (curve, early, late) = panels(3, 12, 3.6, width_ratios=(1.4, 1, 1))
    draw_restitution(curve, measured, computed)
    for axes, st in ((early, 27), (late, 152)):
        t, h = numpy.loadtxt(f"measured/St{st}.csv", delimiter=",", skiprows=2).T
        axes.plot(1e3*t, 1e3*h, label="measured flight, Gondret et al. 2002", **{**MEASURED, "ms": 3.5})
        for form, colour, text in (("bounce", OURS, "Suna, law of contact (line)"),
                                   ("bounceFilm", OTHER, "Suna, film of 1e-4 R (line)")):
            if (form, st) in flights:
                axes.plot(1e3*flights[form, st][0], 1e3*flights[form, st][1], color=colour, label=text)
        axes.set(xlabel="time since the impact [ms]", ylabel="height above the plate [mm]",
                 xlim=(-10, 1.1e3*t.max()), ylim=(-0.1, 1.8e3*h[t > 0].max()), title=f"flight at St {st}")
    below(figure, columns=3)
    save(figure, "rebound.png")


def main():
    result = Result()
    law = lambda st: BEST*numpy.exp(-35/st)
    there = [(form, text) for form, text in FORMS if Path(f"runs/{form}.27").is_dir()]
    computed = {}
    for form, text in there:
        for st, (d, density, viscosity, speed) in SETS.items():
            if not Path(f"runs/{form}.{st}").is_dir():
                continue
            stokes = 7800*d*speed/(9*viscosity)
            e = restitution(f"runs/{form}.{st}")[0]
            computed.setdefault(form, []).append((stokes, e))
            if form in ("stokesDamping", "added"):
                reference = law(stokes*(1 + 0.5*density/7800) if form == "added" else stokes)
            # in closed form, dry e: e - (1 + e) v_t/v, v_t = v/St ln(h_c/h_r)
            elif form in ("film", "rough"):
                reference = max(BEST - (1 + BEST)*numpy.log(1e2 if form == "rough" else 1e3)/stokes,
                                0)
            else:
                reference = None
            result.add("e " + text, f"St {stokes:.1f}", reference, e, None, "1")
    measured = measured_impacts()
    for st, e, ci95 in measured:
        # no runs at these St: closed forms of the two laws, with the measurement's interval
        for text, value in (("the law of contact", law(st)),
                            ("the film of 1e-4 R", BEST - (1 + BEST)*numpy.log(1e3)/st)):
            result.add(f"closed form (no run) of {text}; reference and interval: e out of the measured flights", f"St {st:.0f}", e, value, ci95, "1")
    coupled = Path("runs/coupled.csv")
    if coupled.exists():
        for form, st, e in (line.split(",") for line in coupled.read_text().split()):
            result.add("e in demPimpleFoam with the solver's viscosity and added mass", f"St {float(st):.1f}",
                       law(float(st)*(1 + 0.5*SETS[27][1]/7800)), float(e), None, "1")

    flights = {}
    for st in (27, 152):
        for form in ("bounce", "bounceFilm"):
            if not Path(f"runs/{form}.{st}").is_dir():
                continue
            d = SETS[st][0]
            t, h = flight(f"runs/{form}.{st}", 0.5*d)
            flights[form, st] = t, h
            way, height = numpy.loadtxt(f"measured/St{st}.csv", delimiter=",", skiprows=2).T
            until = 0.042 if st == 27 else 0.08
            text = "law of contact" if form == "bounce" else "film"
            result.add(f"height of the first bounce by the {text}", f"St {st}",
                       1e3*height[(way > 0) & (way < until)].max(),
                       1e3*h[(t > 0) & (t < until)].max(), None, "mm")
    result.write()

    draw(measured, computed, flights)
    if sys.argv[1:2] == ["-store"]:
        store(sys.argv[2], "rebound.png")


if __name__ == "__main__":
    main()
