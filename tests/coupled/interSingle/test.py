"""With one fluid in all cells demInterFoam solves the equations of demPimpleFoam.

- A uniform suspension in a periodic box: fluid and particles have the same velocities to 1e-10.
- A swarm that settles in a vessel: the two interpolate inertia to the faces differently, so velocities differ by a part
  of the error of the mesh: mean velocities agree to 1 %.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

d, end, step = 2e-3, 0.02, 5e-4
sides = {"left": ("cyclic; neighbourPatch right", "x-"), "right": ("cyclic; neighbourPatch left", "x+"),
         "front": ("cyclic; neighbourPatch back", "y-"), "back": ("cyclic; neighbourPatch front", "y+"),
         "floor": ("cyclic; neighbourPatch roof", "z-"), "roof": ("cyclic; neighbourPatch floor", "z+")}
fields = (("U", "0 1 -1 0 0 0 0", "(0.1 0.02 0)"), ("p_rgh", "1 -1 -2 0 0 0 0", 0), ("p", "0 2 -2 0 0 0 0", 0),
          ("alpha.water", "0 0 0 0 0 0 0", 1))


def both(name, mesh, effects, insert):
    """Velocities of fluid and particles of both solvers at the end."""
    found = []
    for solver, coupling in (("demInterFoam", ""), ("demPimpleFoam", "rho 1000; ")):
        case = TwoFluids(f"{name}-{solver}")
        case.controls(end, step)
        case.fluids(tolerance=1e-14, correctors=8)
        mesh(case)
        if solver == "demPimpleFoam":
            case.dictionary("constant/transportProperties", "transportModel Newtonian; nu 1e-6;")
            case.sub("system/fvSchemes", "div.rhoPhi,U.", "div(alphaPhi,U)")
            case.sub("system/fvSolution", "p_rgh", "p")
        case.grains("grain { density 2500; youngsModulus 1e6; }", effects, insert,
                    coupling + "kernel diffusion; width 3;",
                    "time { step 1e-5; }")
        case.run(solver)
        claim_ran(f"{name}: {solver} runs", case, solver)
        found.append((case.interior("U"), case.particles(case.times()[-1], "U")[:, 1:]))
    return found


def periodic(case):
    case.box((0.016, 0.016, 0.016), (4, 4, 4), sides)
    for name, dimensions, value in fields:
        case.initial(name, dimensions, value, " ".join(f"{side} {{ type cyclic; }}" for side in sides))


centres = " ".join(vector(0.004*(np.array(place) + 0.5)) for place in np.ndindex(4, 4, 4))
(U, v), (U1, v1) = both("periodic", periodic, "gidaspow {} virtualMass {}",
                        f"grains {{ type list; diameter {d}; velocity (0 0 0.3); positions ({centres}); }}")
claim("periodic: particles and fluid have exchanged momentum", largest(v - (0, 0, 0.3)) > 0.05, v[0])
claim("periodic: the same velocity of the fluid (1e-10 m/s)", difference(U, U1) < 1e-10, difference(U, U1))
claim("periodic: the same velocity of the particles (1e-10 m/s)", difference(v, v1) < 1e-10, difference(v, v1))


def vessel(case):
    case.box((0.02, 0.02, 0.04), (5, 5, 10), {"walls": ("wall", "x- x+ y- y+ z- z+")})
    case.fields(("walls",))
    case.initial("p", "0 2 -2 0 0 0 0", 0, "walls { type fixedFluxPressure; value uniform 0; }")
    case.sub("0/alpha.water", "uniform 0", "uniform 1")


(U, v), (U1, v1) = both("vessel", vessel, "hertz {} dry { restitution 0.5; } gidaspow {}",
                        f"grains {{ type random; diameter {d}; count 200; seed 4; min (0 0 0.02); max (0.02 0.02 0.04); }}")
claim("vessel: the particles sink", v[:, 2].mean() < -0.05, v[:, 2].mean())
claim("vessel: the same mean velocity of the particles (1 %)", close(v[:, 2].mean(), v1[:, 2].mean(), 0.01),
      v[:, 2].mean(), v1[:, 2].mean())
finish()
