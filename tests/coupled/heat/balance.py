"""Heat of fluid and particles, for several tests: what the log says of it, and two cases.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from solvers.box import prepare

__all__ = ["capacities", "crossing", "drift", "gained", "heat", "hot", "relaxation", "temperatures"]


def heat(case, command="demPimpleFoam"):
    """Heat of the fluid, of the particles, owed, their sum, and received, one entry a step [J]."""
    return case.numbers(r"^Suna: heat fluid (\S+) particles (\S+) owed (\S+) sum (\S+) received (\S+) J$", command).T


def drift(case):
    """The largest change of the sum less the received heat in a run of ten steps or more, over the first one."""
    *_, total, received = heat(case)
    kept = total - received
    if kept.size < 10:
        raise ValueError(f"{kept.size} steps are too few")
    return largest(kept/kept[0] - 1)


def capacities(V, n, c=20, cf=1000):
    """Heat capacities [J/K] of n glass spheres of 1 mm and of the gas in a volume V, and the temperature of spheres of
    300 K mixed with gas of 500 K."""
    Cp, Cf = n*math.pi/6*1e-9*2500*c, (V - n*math.pi/6*1e-9)*1.25*cf
    return Cp, Cf, (Cp*300 + Cf*500)/(Cp + Cf)


def relaxation(case, V, n, Nu=2, t=0.04):
    """Error of the difference of the temperatures of these two at time t, over the first one; the closed form is
    exp(-t (B/C + N B/Cf)), with B = Nu pi d k."""
    Cp, Cf, _ = capacities(V, n)
    rate = n*Nu*math.pi*1e-3*0.025*(1/Cp + 1/Cf)
    fluid, particles, owed, *_ = heat(case)[:, -1]
    return abs((fluid/Cf - (particles + owed)/Cp)/200 - math.exp(-t*rate))


def temperatures(case, time):
    """All temperatures of fluid and particles."""
    return np.append(case.field(f"{time}/T"), case.field(f"{time}/lagrangian/particles/temperature"))


def crossing(case, up, down, more=""):
    """Make the case of heat/ a box of 12 mm with two beds that fly through each other; `up` and `down` are their
    diameters, counts and temperatures."""
    case.periodic((0.012, 0.012, 0.012), (6, 6, 6))
    case.edit("system/controlDict", endTime=0.02, deltaT=0.001)
    case.sub("system/fvSchemes", r"div\(alphaPhi,U\)", "div(alphaPhi,T) Gauss upwind; div(alphaPhi,U)")
    case.sub("constant/demProperties", "ranzMarshall", "dry { restitution 0.9; } gunn")
    case.sub("constant/demProperties", r"^insert(.|\n)*", f"""{more}
insert
{{
    up   {{ type lattice; {up} spacing 1.4; jitter 0.9; seed 3; velocity (0.5 0 1);
           min (0 0 0); max (0.012 0.012 0.006); }}
    down {{ type lattice; {down} spacing 1.4; jitter 0.9; seed 4; velocity (0 -1 0);
           min (0 0 0.006); max (0.012 0.012 0.012); }}
}}
coupling {{ rho 1.25; }}
""")


def hot(solver, name=None):
    """100 hot spheres in the box of ../solvers for buoyantPimpleFoam (enthalpy) or rhoPimpleFoam (internal energy),
    with no work of the pressure in their energy."""
    case = prepare(solver, """insert { hot { type random; count 100; seed 7; diameter 1e-3; temperature 400;
                                  min (0 0 0.01); max (0.02 0.02 0.03); } }
""", name)
    case.sub("constant/demProperties", "density 3000;", "density 3000; heatCapacity 50;")
    case.sub("constant/demProperties", "wenYu {}", "wenYu {} ranzMarshall {}")
    case.sub("system/fvSolution", r"\(U\|h\)", "(U|h|e)")
    case.edit("system/controlDict", endTime=0.02, writeInterval=0.02)
    case.append("constant/thermophysicalProperties", "dpdt no;\n")
    if solver == "rhoPimpleFoam":
        case.remove("constant/g", "0/p_rgh")
        case.sub("constant/thermophysicalProperties", "heRhoThermo", "hePsiThermo")
        case.sub("constant/thermophysicalProperties", "sensibleEnthalpy", "sensibleInternalEnergy")
        case.sub("0/p", r"\[0 2 -2", "[1 -1 -2")
        case.sub("0/p", "uniform 0", "uniform 1e5")
        case.sub("system/fvSolution", "pRefValue [^;]*", "pRefValue 1e5")
    return case


def gained(case, solver):
    """Heat that the fluid has gained, that the particles have lost with the heat owed to them, and that was received,
    from the first to the last of ten steps or more [J]; the heat of the particles at the end over their first one."""
    fluid, particles, owed, _, received = heat(case, solver)
    particles = particles + owed
    if fluid.size < 10:
        raise ValueError(f"{fluid.size} steps are too few")
    return (fluid[-1] - fluid[0], particles[0] - particles[-1], received[-1] - received[0],
            particles[-1]/particles[0])
