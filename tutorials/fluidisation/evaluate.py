"""evaluate.py -- pressure drop of a bed over the superficial velocity, rising and falling; minimum
fluidisation.

References
  Ergun    Chem. Eng. Prog. 48 (1952) 89, for the fixed bed, at the bed's own void fraction in each
           layer of the mesh and for the flow relative to the beads: a bed that is relieved of its
           weight grows, here by about 1 % of the flow
  weight   of the beads less buoyancy over the cross-section, which fluid that lifts them carries
  knee     where Ergun's pressure drop at the void fractions of the fixed bed reaches the weight;
           ours: where a straight line through the values below 0.7 of the weight does
  Wen-Yu   Wen and Yu, AIChE J. 12 (1966) 610: Re = (33.7^2 + 0.0408 Ar)^0.5 - 33.7, without the
           void fraction

Intervals come from packings.

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

D, RHO, RHO_P, NU, G = 1e-3, 10.0, 2000.0, 1.5e-4, 9.81
SIDE, LAYERS, HEIGHT = 8e-3, 16, 0.032
MU = RHO*NU


def ergun(e, U):
    return 150*MU*(1 - e)**2*U/(e**3*D**2) + 1.75*RHO*(1 - e)*U**2/(e**3*D)


def knee(void, weight):
    """Superficial velocity at which Ergun's drop over these layers is `weight`; it grows with U, so
    bisection."""
    low, high = 1e-6, 1.0
    for _ in range(100):
        U = math.sqrt(low*high)
        low, high = (U, high) if layers(void, U) < weight else (low, U)
    return U


def layers(void, U):
    """Ergun's pressure drop over the layers of the mesh; zero in the clear liquid above the bed."""
    return sum(ergun(void[void < 0.999], U))*HEIGHT/LAYERS


def numbers(field):
    text = field.read_text()
    return numpy.array(re.search(r"nonuniform List<scalar>\s*\d+\s*\(([^)]*)\)",
                                 text).group(1).split(), float)


class Packing:
    def __init__(self, run):
        self.time, p = results.frames.read_columns(run, "plate", "surfaceFieldValue.dat")
        # (time (0 0 U)) ... of the inlet, or constant (0 0 U)
        text = (run/"0/U").read_text()
        self.course = numpy.array(re.findall(r"\(([\d.]+) \(0 0 ([\d.]+)\)\)", text)
                                  or [(0, re.search(r"constant \(0 0 ([\d.]+)\)", text).group(1))],
                                  float).T
        self.drop, self.U = RHO*p, self.flow(self.time)
        times, position, velocity = results.record(run)
        self.count = position.shape[1]
        self.slip = self.U - numpy.interp(self.time, times, velocity[:, :, 2].mean(axis=1))
        self.weight = self.count*math.pi/6*D**3*(RHO_P - RHO)*G/SIDE**2
        instants = sorted((float(folder.name), folder) for folder in run.iterdir()
                          if re.fullmatch(r"[\d.]+", folder.name) and folder.name != "0")
        self.at = numpy.array([time for time, _ in instants])
        # each cell has its own void fraction: the mean of Ergun's gradient over layers is the drop
        # of the law
        self.void = numpy.array([numbers(folder/"voidFraction").reshape(LAYERS, -1).mean(axis=1)
                                 for _, folder in instants])
        self.law = numpy.array([layers(e, numpy.interp(time, self.time, self.slip))
                                for time, e in zip(self.at, self.void)])
        # void fraction of the fixed bed, by the solid volume in its full layers
        self.inner = self.void[:, 1:6].mean(axis=1)

    def flow(self, time):
        return numpy.interp(time, *self.course)

    def drop_at(self, time):
        near = abs(self.time - time) < 0.012
        return self.drop[near].mean()

    def branch(self, up):
        turn = self.time[numpy.argmax(self.U)]
        return self.time <= turn if up else self.time > turn

    def line(self, up):
        """Velocity at which the straight line through the drops below 0.7 of the weight reaches the
        weight."""
        chosen = self.branch(up) & (self.drop < 0.7*self.weight) & (self.drop > 0.2*self.weight)
        return self.weight/(numpy.sum(self.drop[chosen]*self.slip[chosen])/numpy.sum(self.slip[chosen]**2)) if chosen.any() else None

    def plateau(self, up):
        """Mean drop above 1.2 times the minimum fluidisation velocity."""
        chosen = self.branch(up) & (self.U > 1.2*self.line(True))
        return self.drop[chosen].mean() if chosen.any() else None


def report(table, packings):
    for up in (True, False):
        part = "flow rises" if up else "flow falls"
        chosen = [p for p in packings if p.line(up) is not None]
        if not chosen:
            continue
        ratio, inner, lifts = [], [], []
        for p in chosen:
            fixed = [k for k, t in enumerate(p.at) if (t <= p.time[numpy.argmax(p.U)]) == up
                     and 0.2 < p.law[k]/p.weight < 0.8]
            ratio.append(numpy.mean([p.drop_at(p.at[k])/p.law[k] for k in fixed]))
            inner.append(p.inner[fixed].mean())
            lifts.append(knee(p.void[fixed].mean(axis=0), p.weight))
        mean, interval = results.mean_of(ratio)
        table.add(part, "fixed bed: pressure drop over Ergun's", 1, mean, interval, "", 0.05,
                  "Ergun")
        e, eInterval = results.mean_of(inner)
        table.add(part, "fixed bed: void fraction inside (the set-up's 0.4513)", 0.451335, e,
                  eInterval)
        line, lineInterval = results.mean_of([p.line(up) for p in chosen])
        # without a bound: it is the inverse of the first row
        table.add(part, "knee, Ergun at the layers' void fraction", numpy.mean(lifts), line,
                  lineInterval, "m/s", None, "Ergun")
        Ar = RHO*(RHO_P - RHO)*G*D**3/MU**2
        table.add(part, "knee, Wen and Yu's correlation",
                  (math.sqrt(33.7**2 + 0.0408*Ar) - 33.7)*NU/D, line, lineInterval, "m/s",
                  None, "Wen-Yu")
        if chosen[0].plateau(up) is None:
            continue
        plateau, pInterval = results.mean_of([p.plateau(up) for p in chosen])
        table.add(part, "pressure drop beyond 1.2 times that, the weight", chosen[0].weight,
                  plateau, pInterval, "Pa", 0.03, "weight")
        top, topInterval = results.mean_of([p.drop[p.branch(up)].max() for p in chosen])
        table.add(part, "largest pressure drop, the weight", chosen[0].weight, top, topInterval,
                  "Pa", None, "weight")


def kernels(table):
    """The same bed with each kernel; Ergun over the layers as spheres cut by the cells fill them
    (kernel divided)."""
    runs = {run.name.split("-")[1]: Packing(run) for run in (HERE/"runs").glob("kernel-*")}
    for name in ("divided", "linear", "gaussian", "diffusion"):
        if name in runs:
            own = runs["divided"]
            table.add("bed at rest, 4 mm/s", f"pressure drop, kernel {name}", own.law[-1],
                      runs[name].drop[-1], unit="Pa", source="Ergun")
            # between the middles of the second and the fifth layer of 2 diameters
            p = RHO*numbers(sorted(((HERE/f"runs/kernel-{name}").glob("0.*")),
                key=lambda f: float(f.name))[-1]/"p").reshape(LAYERS, -1).mean(axis=1)
            slip = numpy.interp(own.at[-1], own.time, own.slip)
            law = numpy.mean([ergun(e, slip) for e in own.void[-1][[1, 2, 2, 3, 3, 4]]])
            table.add("bed at rest, 4 mm/s", f"gradient inside, kernel {name}", law,
                      (p[1] - p[4])/(3*HEIGHT/LAYERS), unit="Pa/m", source="Ergun")


def draw(packings):
    from style import GREY, OURS, REFERENCE, below, panels, save

    figure, (axis,) = panels(1, 6, 3.8)
    for k, p in enumerate(packings):
        for up, dashes, way in ((True, "-", "rising"), (False, "--", "falling")):
            branch = p.branch(up)
            axis.plot(1e3*p.U[branch], p.drop[branch], dashes, color=OURS, lw=1.2,
                      label=None if k else f"Suna, {len(packings)} packings, {way} velocity")
    U = numpy.linspace(0, 0.02, 50)
    first = packings[0]
    for k, dashes in ((1, "-"), (-2, "--")):
        void = first.void[k]
        axis.plot(1e3*U, [layers(void, x) for x in U], dashes, color=REFERENCE, lw=1,
                  label=f"Ergun's law, void fraction {first.inner[k]:.3f} (packing 1 at {first.at[k]:.2g} s)")
    axis.axhline(first.weight, color=GREY, lw=1, label="weight of the bed over its area")
    axis.set(xlabel="superficial velocity [mm/s]", ylabel="pressure drop [Pa]", xlim=(0, None),
             ylim=(0, 1.25*first.weight))
    below(figure, columns=1)
    save(figure, HERE/"curve.png")


def main():
    table = results.Table()
    packings = [Packing(run) for run in sorted((HERE/"runs").glob("packing*"))]
    report(table, packings)
    kernels(table)
    table.write(HERE)
    with results.pictures():
        draw(packings)


if __name__ == "__main__":
    main()
