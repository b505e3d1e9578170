"""Sets I, II and III of the averaged equations agree where they must.

In each set the pressure drop of a fixed bed is Ergun's, a vessel at rest stays at rest, a uniform suspension settles
at the same speed, and momentum is conserved.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from hindered.make import column


def case_of(folder, name, equations):
    """A case of another test with this set of equations."""
    case = Case(f"{name}-{equations}", folder)
    case.sub("constant/demProperties", "^ *rho .*", rf"\g<0> equations {equations};")
    return case


def ergun(U):
    """Ergun's pressure gradient through the lattice [Pa/m]."""
    s = math.pi/6/1.331
    e, d, mu, rho = 1 - s, 1e-3, 1.8e-5, 1.2
    return 150*mu*s**2*U/(e**3*d**2) + 1.75*rho*s*U**2/(e**3*d)


def bed(equations):
    """A fixed bed; returns its whole pressure drop [Pa]."""
    what = f"set {equations}: the bed"
    case = case_of("fixedBed", "bed", equations)
    case.sub("constant/demProperties", "gidaspow", "ergun")
    claim_runs(f"{what} runs", case)
    p = 1.2*case.field("0.02/p").reshape(18, 25).mean(1)              # layers of cells
    claim(f"{what}: the pressure gradient is Ergun's (0.5 %)", close((p[0] - p[3])/(3*0.0022), ergun(0.3), 0.005))
    claim(f"{what}: exchange closes", worst(case.log(), "exchange error") < 1e-12)
    return p[0]


def vessel(equations):
    """Particles as dense as the fluid, at random positions at rest: weight, buoyancy and the fluid's own weight cancel
    to round-off."""
    case = case_of("hydrostatic", "vessel", equations)
    claim_runs(f"set {equations}: the vessel runs", case)
    # 1e-8 m/s: far above the round-off of g T, 1e-17, and far below a lack of buoyancy, g T = 0.5 m/s
    claim(f"set {equations}: no particle moves", largest(case.field("0.05/lagrangian/particles/U")) < 1e-8)
    claim(f"set {equations}: no fluid moves", largest(case.field("0.05/U")) < 1e-8)
    claim(f"set {equations}: volume of the particles is kept", worst(case.log(), "volume error") < 1e-12)


def suspension(equations):
    """A suspension that is and stays uniform: two spheres to a cell in each direction; returns its speed in the middle.
    Differences start at its ends, where it is not uniform, and decay over some cells: in set III particles there
    lack the pressure due to their neighbors."""
    case = case_of("hindered", "column", equations)
    column(case, (4.8144e-4, 4.8144e-4, 5.77728e-3), (2, 2, 24))
    for old, new in (("0.000963", "4.8144e-4"), ("0.00289", "5.77728e-3"), ("count 1536", "count 768")):
        case.sub("constant/demProperties", old, new)
    case.edit("system/controlDict", deltaT=2e-4, endTime=0.012, writeInterval=0.012)
    claim_runs(f"set {equations}: the suspension runs", case)
    spheres = case.particles("0.012", "positions", "U")
    middle = (spheres[:, 3] > 0.0024) & (spheres[:, 3] < 0.0034)
    return -spheres[middle, 6].mean()


def box(equations):
    case = case_of("momentum", "box", equations)
    case.edit("system/controlDict", endTime=0.01, writeInterval=0.01)
    claim_runs(f"set {equations}: the box runs", case)
    total = case.vectors("sum", "momentum fluid")
    # relative to the initial sum; the log has six digits, the linear solvers 1e-11 m2/s2
    claim(f"set {equations}: momentum is kept", len(total) == 10 and
          np.linalg.norm(total - total[0], axis=1).max() < 1e-8*np.linalg.norm(total[0]))


drop, speed = {}, {}
for equations in ("II", "I", "III"):
    drop[equations] = bed(equations)
    vessel(equations)
    speed[equations] = suspension(equations)
    box(equations)
for equations in ("I", "III"):
    # the kernel smooths the bed's surface: in set I also the part of the pressure gradient that acts through particles
    claim(f"set {equations}: the bed's whole pressure drop agrees with set II (0.5 %)",
          close(drop[equations], drop["II"], 0.005))
    # ten cells from either end the difference is 2e-7, further inside less
    claim(f"set {equations}: a uniform suspension settles as in set II (1e-6)",
          close(speed[equations], speed["II"], 1e-6))
finish()
