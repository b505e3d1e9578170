#!/usr/bin/env python3
"""analyse.py -- broken bonds over the impact speed of a ball.

    analyse.py [-store TEXT]      result.csv, breakage.png, ball.png; -store keeps them in stored/

Damage is the number of broken bonds over the number of bonds at the start. It grows with the
logarithm of the speed (Thornton, Yin, Adams, J. Phys. D 29 (1996) 424) until nothing is left to
break.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re
import sys
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from dem_case import OURS, POINTS, REFERENCE, Result, interval, panel, panels, pictures, read_table, \
    render, save, store     # noqa: E402


def damage(folder):
    """Broken bonds over all of them, from the last lines of the log."""
    counts = re.findall(r"(\d+) bonds\s+(\d+) broken", Path(f"{folder}.log").read_text())
    intact, broken = map(int, counts[-1])
    return broken/(intact + broken)


def residual(folder):
    """Largest residual of the energy balance over the kinetic energy of the impact."""
    energy = read_table(folder/"energy.csv")
    return abs(energy["residual"]).max()/energy["total"][0]


def draw(speed):
    """A ball at four instants, cut in half."""
    shown = pictures(f"runs/{speed:g}.1")
    instants = []
    for k in (0, 2, 4, 12):
        time, path = shown[k]
        p = panel(f"{1e3*time:.2g} ms", path)
        half = p.position[:, 1] > 0
        instants.append(render.Panel(p.title, *(x[half] for x in p[1:])))
    render.draw("ball.png", instants, render.box((-0.012, 0, 0), (0.012, 0.006, 0.0125)), "speed",
                speed)


def main():
    found = {}
    for folder in sorted(Path("runs").glob("*.?")):
        if folder.is_dir():
            speed = float(folder.name.rsplit(".", 1)[0])
            found.setdefault(speed, []).append((damage(folder), residual(folder)))
    result = Result()
    rows = []
    for speed, runs in sorted(found.items()):
        broken = interval([d for d, _ in runs])
        rows.append((speed, *broken))
        result.add("broken bonds", f"{speed:g} m/s", None, *broken, "1")
        result.add("residual of the energy balance over the energy of the impact", f"{speed:g} m/s",
                   0, max(r for _, r in runs), None, "1")
    rows = numpy.array(rows)
    # the straight part over the logarithm: neither a few bonds nor nearly all
    straight = rows[(rows[:, 1] > 0.05) & (rows[:, 1] < 0.7)]
    figure, (axes,) = panels(1, 5.5)
    axes.errorbar(rows[:, 0], rows[:, 1], numpy.nan_to_num(rows[:, 2]), marker="s", color=OURS,
                  label="Suna, mean and 95 % interval", **POINTS)
    if len(straight) > 1:
        slope, at_one = numpy.polyfit(numpy.log(straight[:, 0]), straight[:, 1], 1)
        v = numpy.geomspace(rows[0, 0], rows[-1, 0], 50)
        line = at_one + slope*numpy.log(v)
        axes.plot(v[line > 0], line[line > 0], color=REFERENCE, lw=1,
                  label=f"fit: {slope:.2f} ln(v / {numpy.exp(-at_one/slope):.2g} m/s)")
        result.add("slope of the damage over ln v", "straight part", None, slope, None, "1")
        result.add("speed at which it begins", "straight part", None, numpy.exp(-at_one/slope), None,
                   "m/s")
    result.write()
    axes.set(xscale="log", xlabel="speed v of the impact [m/s]", ylabel="damage: broken bonds over all bonds", ylim=(0, None),
             xticks=rows[:, 0], xticklabels=[f"{v:g}" for v in rows[:, 0]])
    axes.minorticks_off()
    axes.legend()
    save(figure, "breakage.png")
    draw(4.0 if 4.0 in found else max(found))
    if sys.argv[1:2] == ["-store"]:
        store(sys.argv[2], "breakage.png", "ball.png")


if __name__ == "__main__":
    main()
