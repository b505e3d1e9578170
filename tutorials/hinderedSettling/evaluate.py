"""evaluate.py -- settling speeds of lattices and of random suspensions.

References
  balance   the speed v at which the drag law carries the suspension: zero net flux, so slip v/e,
            and drag on a sphere e V (rho_p - rho) g; the pressure gradient of the suspension's
            weight carries the rest. Laws: Wen and Yu 1966; Di Felice 1994
  measured  Garside and Al-Dibouni, Ind. Eng. Chem. Process Des. Dev. 16 (1977) 206: v = v_t e^n,
            (5.1 - n)/(n - 2.7) = 0.1 Re_t^0.9; Richardson and Zaki, Trans. Inst. Chem. Eng. 32
            (1954) 35. v_t by Schiller and Naumann

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

G, RHO, RHO_P, NU = 9.81, 1000.0, 2500.0, 1e-6


# drag over Stokes drag, 3 pi mu d (u - v); Re of the superficial slip
def wen_yu(Re, e):
    return e**-2.65*(1 + 0.15*Re**0.687 if Re < 1000 else 0.44*Re/24)


def di_felice(Re, e):
    chi = 3.7 - 0.65*math.exp(-0.5*(1.5 - math.log10(Re))**2)
    return (0.63*Re**0.5 + 4.8)**2/24*e**(1 - chi)


LAWS = {"wenYu": wen_yu, "diFelice": di_felice}


def speed(law, e, d):
    """Speed at which the drag law carries the suspension, by bisection."""
    carried = e*math.pi/6*d**3*(RHO_P - RHO)*G
    low, high = 1e-9, 10.0
    for _ in range(200):
        v = math.sqrt(low*high)
        low, high = (v, high) if 3*math.pi*RHO*NU*d*law(v*d/NU, e)*v/e < carried else (low, v)
    return math.sqrt(low*high)


def measured(e, d):
    """Garside and Al-Dibouni; Richardson and Zaki."""
    v = speed(wen_yu, 1 - 1e-12, d)
    Re = v*d/NU
    q = 0.1*Re**0.9
    garside = (5.1 + 2.7*q)/(1 + q)
    zaki = 4.65 if Re < 0.2 else 4.35*Re**-0.03 if Re < 1 else 4.45*Re**-0.1 if Re < 500 else 2.39
    return v*e**garside, v*e**zaki


def allowed(e):
    """Bound of a drag law against measurements, which differ among themselves by this."""
    return 0.15 if e >= 0.7 else 0.35


# ---- cases ---------------------------------------------------------------------------------------

def middle(position, velocity, height):
    """Mean settling speed of the particles in the middle fifth, and its variation."""
    there = abs(position[:, 2] - 0.5*height) < 0.1*height
    return -velocity[there, 2].mean(), velocity[there, 2].std()


def lattices(table, points):
    change = 0
    for run in sorted((HERE/"runs/lattices").glob("*"), key=lambda run: (float(run.name.split("-",
            1)[1].rsplit("-", 1)[0]), run.name)):
        law, d, e = re.fullmatch(r"([A-Za-z]+)-([\de-]+)-(0\.\d)", run.name).groups()
        d, e = float(d), float(e)
        _, position, velocity = results.record(run)
        height = {0.9: 40, 0.7: 80, 0.5: 100}[e]*d*(math.pi/6/(1 - e))**(1/3)
        ours, _ = middle(position[-1], velocity[-1], height)
        before, _ = middle(position[-3], velocity[-3], height)
        own, (garside, _) = speed(LAWS[law], e, d), measured(e, d)
        part = f"{law}, {1e3*d:g} mm, e {e:g}"
        table.add(part, "speed in the middle, balance of the law", own, ours, unit="m/s",
                  allowed=0.02, source="balance")
        change = max(change, abs(ours/before - 1))
        table.add(part, "Garside and Al-Dibouni", garside, ours, unit="m/s", source="measured")
        points.append((law, d, e, ours, None))
    # steady: the rest of a tenth after 2.5 relaxation times
    table.add("all lattices", "largest change over the last time of relaxation", 0, change,
              allowed=0.01, source="steady")


def interface(time, position, height):
    """Speed of the upper interface, below which are 98 of 100 particles; least squares from half of
    the time on."""
    top = numpy.quantile(position[:, :, 2], 0.98, axis=1)
    late = time > 0.5*time[-1]
    return -numpy.polyfit(time[late], top[late], 1)[0]


def suspensions(table, points):
    runs = sorted((HERE/"runs/random").glob("*"))
    for name in dict.fromkeys(run.name.rsplit("-", 1)[0] for run in runs):
        law, e = name.split("-")
        e, d = float(e), 5e-4
        height = 0.12 if e == 0.9 else 0.03
        read = [results.record(run) for run in runs if run.name.startswith(name)]
        front, frontCi = results.mean_of([interface(time, position, height)
                                          for time, position, _ in read])
        # from a quarter to half of the time, before the ends affect the middle
        inside, insideCi = results.mean_of([numpy.mean([middle(p, v, height)[0] for p, v in
                                           zip(position[len(time)//4:len(time)//2],
                                               velocity[len(time)//4:len(time)//2])])
                                           for time, position, velocity in read])
        own, (garside, zaki) = speed(LAWS[law], e, d), measured(e, d)
        part = f"random, {law}, 0.5 mm, e {e:g}"
        for what, reference, bound in (("balance of the law", own, None),
                                       ("Garside and Al-Dibouni", garside, allowed(e)),
                                       ("Richardson and Zaki", zaki, allowed(e))):
            table.add(part, f"speed of the interface, {what}", reference, front, frontCi, "m/s",
                      bound, "measured" if bound else "balance")
        table.add(part, "speed in the middle, balance of the law", own, inside, insideCi, "m/s",
                  None, "balance")
        points.append((law + ", random", d, e, front, frontCi))


def draw(points):
    from style import below, panels, save, shades

    figure, (axis,) = panels(1, 6.2, 4)
    e = numpy.linspace(0.48, 0.95, 60)
    sizes = sorted({point[1] for point in points})
    for d, colour in zip(sizes, shades(len(sizes))):
        lone = speed(wen_yu, 1 - 1e-12, d)
        axis.plot(e, [measured(x, d)[0]/lone for x in e], "-", color=colour, lw=1.2,
                  label=f"measured, Garside and Al-Dibouni, {1e3*d:g} mm")
        for law, mark, aside in (("wenYu", "o", 0), ("diFelice", "s", 0.006), ("wenYu, random", "x", -0.006)):
            mine = [(p[2] + aside, p[3]/lone, (p[4] or 0)/lone) for p in points if p[0] == law
                    and p[1] == d]
            if mine:
                x, y, error = zip(*mine)
                axis.errorbar(x, y, error, fmt=mark, color=colour, ms=5, mfc="none", capsize=2)
    for law, mark in (("lattice, wenYu", "o"), ("lattice, diFelice", "s"), ("random suspension, wenYu", "x")):
        axis.plot([], [], mark, color="k", mfc="none", label="Suna, " + law)
    axis.set(xlabel="void fraction", ylabel="settling speed over the speed of one sphere alone", yscale="log")
    below(figure, columns=2)
    save(figure, HERE/"speeds.png")


def main():
    table, points = results.Table(), []
    lattices(table, points)
    suspensions(table, points)
    table.write(HERE)
    with results.pictures():
        draw(points)


if __name__ == "__main__":
    main()
