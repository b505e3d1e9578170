"""evaluate.py -- exact properties of the coupled equations.

  bodies   2 g at 1 m/s and 1 g at rest, drag between them: momentum stays, both reach one velocity,
           neither overshoots it, for any step. Exact, with the common velocity v:
           v_f = v (1 - exp(-(m_p + m_f) t/(m_f tau)))
  swarm    momentum of 1000 spheres and the liquid in a periodic box stays
  rest     neutrally buoyant spheres do not move
  lattice  uniform flow through a uniform lattice has Ergun's pressure gradient, with each set of
           equations on any cells

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


def momenta(run):
    """Momentum of fluid and particles, carried-over impulse, and their sum, for each step [N s]."""
    text = (run/"log.demPimpleFoam").read_text(errors="replace")
    found = re.findall(r"momentum fluid \((.*?)\) particles \((.*?)\) owed \((.*?)\) sum \((.*?)\)",
                       text)
    return numpy.array([[word.split() for word in row] for row in found], float)


def number(run):
    return float(run.name)


def bodies(table):
    for run in sorted((HERE/"runs/bodies").glob("*"), key=number):
        ratio, m = number(run), 2e-3
        p = momenta(run)[:, :, 0]
        # the sphere's volume is missing in the liquid
        m_f = 1e-3*(1 - math.pi/6*1e-9/1e-6)
        common = m/(m + m_f)
        v_f = p[:, 0]/m_f
        part = f"two bodies, T/tau {ratio:g}"
        # random round-off of the cell's stress on itself, 12 x 2.1 x ratio times its inertia, in 20
        # steps of 80 iterations
        bound = 1e-12 + 2.2e-16*25*40*ratio
        table.add(part, "momentum after 20 steps, over 2e-3 N s, less 1", 0, p[-1, 3]/m - 1,
                  allowed=bound, source="conservation")
        # the solver includes the displacement of fluid by the sphere, 1/e^2 times its motion, which
        # one cell lacks: 2 s
        table.add(part, "largest velocity of the fluid over the common one, less 1", 0,
                  max(0, v_f.max()/common - 1),
                  allowed=2*math.pi/6*1e-3, source="no overshoot")
        for step in (1, 20):
            exact = common*-math.expm1(-(m + m_f)/m_f*ratio*step)
            table.add(part, f"the fluid's velocity after {step} step{'s'[:step > 1]}", exact,
                      v_f[step - 1], unit="m/s",
                      allowed=1e-3 if ratio*step >= 20 else None, source="exact")


def swarm(table):
    for run in sorted((HERE/"runs/swarm").glob("*")):
        step, ranks = re.fullmatch(r"step(.*)-ranks(\d)", run.name).groups()
        p = momenta(run)
        # speeds at the start are 0.05 to 0.11 m/s: the sum of magnitudes, as the two swarms'
        # momenta nearly cancel
        size = 2500*math.pi/6*8e-4**3*500*(math.hypot(0.05, 0.1) + 0.1)
        change = abs(p[:, 3] - p[0, 3]).max()/size
        part = f"swarm, steps of {step} s, {ranks} rank{'s'[:int(ranks) > 1]}"
        table.add(part, f"largest change of momentum in {len(p)} steps", 0, change, allowed=1e-10,
                  source="conservation")
        table.add(part, "largest error of the volume", 0, results.worst(run, "volume error"),
                  allowed=1e-12, source="conservation")
        table.add(part, "largest error of the exchange", 0, results.worst(run, "exchange error"),
                  allowed=1e-12, source="conservation")


def rest(table):
    for run in sorted((HERE/"runs/rest").glob("*")):
        time, _, velocity = results.record(run)
        table.add(f"at rest, set {run.name}", f"largest velocity of a sphere in {time[-1]:.2g} s",
                  0, abs(velocity).max(), unit="m/s",
                  allowed=1e-8, source="hydrostatics")


def ergun():
    s = math.pi/6/1.331
    return (150*1.8e-5*s*s*0.3/1e-6 + 1.75*1.2*s*0.09/1e-3)/(1 - s)**3


def lattice(table):
    found = {}
    for run in sorted((HERE/"runs/lattice").glob("*")):
        system, kernel, cells = run.name.split("-")
        n, _, layers = (int(x) for x in cells.split("x"))
        text = (run/"0.02/p").read_text()
        p = numpy.array(re.search(r"nonuniform List<scalar>\s*\d+\s*\(([^)]*)\)",
                                  text).group(1).split(), float)
        p = 1.2*p.reshape(layers, -1).mean(axis=1)
        fine = layers//18
        # between 2.2 and 8.8 mm: three diameters from the bottom face, thirteen from the surface
        gradient = (p[fine] - p[4*fine])/(3*0.0022)
        found[run.name] = gradient
        table.add(f"lattice, set {system}, {kernel}", f"pressure gradient, cells of {11/n:.2g} d",
                  ergun(), gradient, unit="Pa/m",
                  allowed=0.005, source="Ergun")
    names = [f"{system}-linear-5x5x18" for system in ("I", "II", "III")]
    if all(name in found for name in names):
        for name in (names[0], names[2]):
            table.add("lattice", f"set {name.split('-')[0]} over set II", 1,
                      found[name]/found[names[1]], allowed=0.005, source="the same law")


def draw(rows):
    """Each deviation beside the one that is allowed."""
    from style import OURS, REFERENCE, below, panels, save

    def kind(row):
        what = re.sub(r"^largest |^the |(,| after \d| over [\d.]| in \d).*$", "", row["quantity"])
        return row["part"].split(",")[0] + ": " + what
    rows = [row for row in rows if row["allowed"]]
    kinds = list(dict.fromkeys(map(kind, rows)))
    figure, (axes,) = panels(1, 8, 0.9 + 0.32*len(kinds))
    for k, name in enumerate(kinds):
        own = [row for row in rows if kind(row) == name]
        # rows of one kind a little above each other
        place = k + 0.5*((numpy.arange(len(own)) + 0.5)/len(own) - 0.5)
        axes.plot([max(abs(float(row["difference"])), 1e-17) for row in own], place, "o", ms=4.5, color=OURS,
                  label="Suna, one case each")
        axes.plot([float(row["allowed"]) for row in own], place, "|", ms=8, mew=1.5, color=REFERENCE,
                  label="allowed")
    axes.set(xscale="log", xlabel="deviation (0 stands at 1e-17)",
             yticks=range(len(kinds)))
    axes.set_yticklabels(kinds)
    axes.invert_yaxis()
    below(figure)
    save(figure, HERE/"deviations.png")


def main():
    table = results.Table()
    for part in (bodies, swarm, rest, lattice):
        part(table)
    table.write(HERE)
    try:
        draw(table.rows)
    except ImportError as reason:
        print(f"evaluate: no picture ({reason})")


if __name__ == "__main__":
    main()
