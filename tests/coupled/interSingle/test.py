"""With one fluid in all cells demInterFoam solves the equations of demPimpleFoam.

Velocities of fluid and particles agree to 1e-10 m/s in a uniform suspension in a periodic box, in a swarm that settles
in a vessel, and in a duct whose inlet and source add particles and whose outlet takes them, laminar and with models of
turbulence. The outer iterations converge: the solvers convect the first one with different fluxes.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

d, end, step = 2e-3, 0.02, 5e-4
fields = (("U", "0 1 -1 0 0 0 0", "(0.1 0.02 0)"), ("p_rgh", "1 -1 -2 0 0 0 0", 0), ("p", "0 2 -2 0 0 0 0", 0),
          ("alpha.water", "0 0 0 0 0 0 0", 1))


def both(name, mesh, effects, insert, outer=12, more="", extra=()):
    """Velocities of fluid and particles of both solvers at the end, and of these fields; claims that they agree."""
    found = []
    for solver, coupling in (("demInterFoam", ""), ("demPimpleFoam", "rho 1000; ")):
        case = TwoFluids(f"{name}-{solver}")
        case.controls(end, step)
        case.fluids(tolerance=1e-14, correctors=6, outer=outer)
        mesh(case)
        if solver == "demPimpleFoam":
            case.dictionary("constant/transportProperties", "transportModel Newtonian; nu 1e-6;")
            case.sub("system/fvSchemes", "div.rhoPhi,U.", "div(alphaPhi,U)")
            case.sub("system/fvSolution", "p_rgh", "p")
        case.grains("grain { density 2500; youngsModulus 1e6; }", effects, insert,
                    coupling + "kernel diffusion; width 3;",
                    "time { step 1e-5; } " + more)
        claim_runs(f"{name}: {solver} runs", case, solver)
        found.append((case.interior("U"), case.particles(case.times()[-1], "U")[:, 1:],
                      *(case.interior(field) for field in extra)))
    here, there = found
    for what, a, b in zip(("the fluid", "the particles"), here, there):
        claim(f"{name}: the same velocity of {what} (1e-10 m/s)", difference(a, b) < 1e-10, difference(a, b))
    for field, a, b in zip(extra, here[2:], there[2:]):
        claim(f"{name}: the same {field} (1e-8 of it)", difference(a, b) < 1e-8*largest(a), difference(a, b), largest(a))
    return here


def periodic(case):
    case.box((0.016, 0.016, 0.016), (4, 4, 4), cyclic="xyz")
    for field in fields:
        case.initial(*field)


centres = " ".join(vector(0.004*(np.array(place) + 0.5)) for place in np.ndindex(4, 4, 4))
U, v = both("periodic", periodic, "gidaspow {} virtualMass {}",
            f"grains {{ type list; diameter {d}; velocity (0 0 0.3); positions ({centres}); }}", outer=1)
claim("periodic: particles and fluid have exchanged momentum", largest(v - (0, 0, 0.3)) > 0.05, v[0])


def vessel(case):
    case.box((0.02, 0.02, 0.04), (5, 5, 10), {"walls": ("wall", "x- x+ y- y+ z- z+")})
    case.fields(("walls",))
    case.initial("p", "0 2 -2 0 0 0 0", 0, "walls { type fixedFluxPressure; value uniform 0; }")
    case.sub("0/alpha.water", "uniform 0", "uniform 1")


U, v = both("vessel", vessel, "hertz {} dry { restitution 0.5; } gidaspow {}",
            f"grains {{ type random; diameter {d}; count 200; seed 4; min (0 0 0.02); max (0.02 0.02 0.04); }}")
claim("vessel: the particles sink", v[:, 2].mean() < -0.05, v[:, 2].mean())


def duct(case, model=""):
    """Up a duct, at 0.3 m/s."""
    size, cells = (0.02, 0.02, 0.04), (5, 5, 10)
    case.box(size, cells, {"walls": ("wall", "x- x+ y- y+"), "inlet": ("patch", "z-"), "outlet": ("patch", "z+")})
    flux, given = "type fixedFluxPressure; value uniform 0;", "type fixedValue; value uniform 0;"
    case.initial("U", "0 1 -1 0 0 0 0", "(0 0 0.3)", "walls { type noSlip; } inlet { type fixedValue; value uniform "
                 "(0 0 0.3); } outlet { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0.3); }")
    for name, dimensions in (("p_rgh", "1 -1 -2 0 0 0 0"), ("p", "0 2 -2 0 0 0 0")):
        case.initial(name, dimensions, 0, f"walls {{ {flux} }} inlet {{ {flux} }} outlet {{ {given} }}")
    case.initial("alpha.water", "0 0 0 0 0 0 0", 1, '".*" { type zeroGradient; }')
    if model:
        def entries(name, value):
            at_wall = "kqRWallFunction" if name == "k" else "epsilonWallFunction"
            return (f"walls {{ type {at_wall}; value uniform {value}; }} inlet {{ type fixedValue; value uniform {value}; }} "
                    "outlet { type zeroGradient; }")
        case.turbulence(model, 1e-3, 1e-2, entries, "walls { type nutkWallFunction; value uniform 0; } "
                        '"(inlet|outlet)" { type calculated; value uniform 0; }')


feed = (f"feed {{ type stream; patch inlet; rate 4000; diameter {d}; velocity (0 0 0.6); }}"
        f" inside {{ type stream; rate 2000; diameter {d}; min (0.002 0.002 0.012); max (0.018 0.018 0.018);"
        " velocity (0 0 0.4); }"
        f" first {{ type random; diameter {d}; count 60; seed 4; min (0 0 0.03); max (0.02 0.02 0.04); velocity (0 0 1); }}")
for model in ("", "kEpsilon", "kEqn"):
    U, v, *more = both(("duct-" + model).strip("-"), lambda case: duct(case, model),
                       "gidaspow {}", feed, more="outlets { out { patch outlet; } }",
                       extra=("k", "nut") if model else ())
    # 60 at the start and 120 fed: 180 if none left, 60 if none entered
    claim(f"duct {model}".strip() + ": particles have entered and left", 60 < len(v) < 160, len(v))
finish()
