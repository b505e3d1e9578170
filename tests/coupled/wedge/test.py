"""Wedges: the fluid is a sector of 5 degrees, the particles are all around its axis.

- A fixed bed in a pipe has the pressure gradient of the closure; a sphere settles by its equation of motion, on the
  axis and off it.
- Momentum along the axis and volume are conserved; walls are round; two ranks agree with one.
- Cases that are not axisymmetric are refused.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from pipe import *
from closures import gidaspow_gradient, speed

GLASS = "glass { density 2500; youngsModulus 1e6; }"

# ---- a fixed bed in a pipe -------------------------------------------------------------------------

h = 1.16e-3                                           # distance of the spheres [m]
void = 1 - 0.5*(1e-3/h)**3

for kernel in ("divided", "diffusion"):
    case = Pipe(f"bed-{kernel}", 5.8e-3, 41.76e-3, (5, 18))
    case.controls(0.02, 0.001, nu=1.5e-5)
    case.flow("(0 0 0.3)",
              "bottom { type fixedValue; value uniform (0 0 0.3); } wall { type slip; } top { type zeroGradient; }",
              '"(bottom|wall)" { type fixedFluxPressure; } top { type fixedValue; value uniform 0; }')
    case.properties(GLASS, "hertz {} gidaspow {} pressureGradient {}",
                    f"bed {{ type list; diameter 1e-3; frozen yes; positions ({rings_of_spheres(h, 20)}); }}",
                    f"rho 1.2; kernel {kernel};")
    claim_runs(f"bed, {kernel}: runs", case)
    voids, U, p = case.field("0.02/voidFraction"), case.field("0.02/U"), case.field("0.02/p").reshape(18, 5).mean(1)
    # the spheres of a ring are in its cells, as `divided` has them; linear weights move some of their volume to other
    # cells
    claim(f"bed, {kernel}: the pressure gradient is the closure's (0.5 %)",
          close(1.2*(p[1] - p[5])/(4*0.00232), gidaspow_gradient(void), 0.005))
    area = np.array([1, 3, 5, 7, 9])/25               # of the five rings of cells
    claim(f"bed, {kernel}: the first cells carry the flux (1 %)", close((area*voids[:5]*U[:5, 2]).sum(), 0.3, 0.01))
    claim(f"bed, {kernel}: volume of the particles is kept", worst(case.log(), "volume error") < 1e-12)
    claim(f"bed, {kernel}: exchange closes", worst(case.log(), "exchange error") < 1e-12)
    if kernel == "divided":
        claim(f"bed, {kernel}: each cell has its ring's void fraction (1e-9)", largest(voids[:45] - void) < 1e-9)

# ---- a sphere settles ------------------------------------------------------------------------------

# cells of the same size as in tests/coupled/settling: a pipe of the same cross-section
for place, position in (("axis", "(0 0 0.0457)"), ("off-axis", "(-0.0123 0.0111 0.0457)")):
    for way, share in (("no", 0.005), ("yes", 0.01)):
        name = f"settling, {place}, two-way {way}"
        case = Pipe(f"settling-{place}-{way}", 0.033851, 0.06, (6, 6))
        case.controls(0.2, 0.002, 0.1, nu=1e-5)
        case.flow("(0 0 0)", '"(bottom|wall)" { type noSlip; } '
                  "top { type pressureInletOutletVelocity; value uniform (0 0 0); }",
                  '"(bottom|wall)" { type fixedFluxPressure; } top { type fixedValue; value uniform 0; }')
        case.gravity()
        case.properties("sphere { density 3000; youngsModulus 1e6; }", "hertz {} wenYu {} pressureGradient {}",
                        f"one {{ type list; diameter 1e-4; positions ({position}); }}",
                        f"rho 10; twoWay {way}; walls (bottom);")
        claim_runs(f"{name}: runs", case)
        for t in (0.1, 0.2):
            claim(f"{name}: speed after {t} s (share {share})",
                  close(-case.field(f"{t}/lagrangian/particles/U")[0, 2], speed(t), share))
        # the fluid that it drags flows in along the floor: 1e-4 of the fall
        claim(f"{name}: straight down",
              np.linalg.norm(case.field("0.2/lagrangian/particles/U")[0, :2]) < 1.4e-5)

# ---- momentum: groups of particles in a periodic pipe, against its wall ----------------------------

case = Pipe("momentum", 6e-3, 0.012, (6, 6), ends="cyclic")
# of low viscosity: OpenFOAM's stress at a slip wall is not zero to round-off; with water's it changes the sum by 2e-7
case.controls(0.02, 0.0005, 0.005, nu=1e-8)
ends = '"(bottom|top)" { type cyclic; }'
case.flow("(0 0 0)", f"wall {{ type slip; }} {ends}", f"wall {{ type fixedFluxPressure; }} {ends}")
case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 8")
case.properties("glass { density 2500; youngsModulus 1e5; }",
                "hertz {} dry { restitution 0.9; } gidaspow {} pressureGradient {}",
                """up { type random; diameter 8e-4; count 150; seed 2; velocity (0.1 0.05 0.2);
         cylinder { from (0 0 0); to (0 0 0.006); radius 0.006; } }
    down { type random; diameter 8e-4; count 150; seed 3; velocity (-0.1 -0.05 -0.4);
           cylinder { from (0 0 0.006); to (0 0 0.012); radius 0.006; } }""", "rho 1000;")
claim_runs("momentum: runs", case)
claim("momentum: exchange closes", worst(case.log(), "exchange error") < 1e-12)
claim("momentum: volume of the particles is kept", worst(case.log(), "volume error") < 1e-12)
case.run("postProcess", "-func", "writeCellVolumes", "-latestTime")
V = case.field("0.02/V")
claim("momentum: the mean void fraction is the whole pipe's",
      close(1 - (case.field("0.02/voidFraction")*V).sum()/V.sum(), 300/6*8e-4**3/(0.006**2*0.012), 1e-9))
total, particles = (case.vectors(word, "momentum")[:, 2] for word in ("sum", "particles"))
claim("momentum: the particles lose more than half of their momentum", abs(particles[-1]) < abs(particles[0])/2)
# linear solvers of 1e-11, as in three dimensions; slip at the wall
claim("momentum: total momentum along the axis is kept",
      len(total) > 20 and abs(total - total[0]).max() < 1e-8*abs(particles[0]))

place, positions = (case.particles("0.02", name)[:, 1:] for name in ("place", "positions"))
r = np.hypot(place[:, 0], place[:, 1])
# corners of the 72 sides lie 6e-4 R off the circle, and no particle overlaps the wall by more than the log reports
claim("momentum: all stay inside the round wall",
      len(r) == 300 and r.max() < 0.006*(1 + 7e-4) - 4e-4 + 8e-4*worst(case.log(), "overlap at most"))
claim("momentum: some particles touch the wall", r.max() > 0.0055)
# for OpenFOAM's tools positions are in the middle plane of the sector
turned = np.column_stack((math.cos(math.pi/72)*r, 0*r, place[:, 2]))
claim("momentum: written positions are those rotated to the middle plane (1e-9 m)",
      np.linalg.norm(positions - turned, axis=1).max() < 1e-9)

(case/"0.005").rename(case/"one")
case.sub("system/controlDict", "^endTime .*", "endTime 0.005;")
case.run("decomposePar")
claim_runs("momentum: two ranks run", case, ranks=2)
case.run("reconstructPar", "-latestTime")
# the bound of tests/coupled/ranks; so early that collisions have not amplified round-off much
claim("momentum: two ranks agree (1e-8)",
      lambda: difference(case.particles("one", "place", "U"), case.particles("0.005", "place", "U")) < 1e-8)

# ---- refused ---------------------------------------------------------------------------------------

good = case.read("constant/demProperties")
for what, more, words in (
        ("the budget", " record { interval 0.001; budget yes; }", "coupling/record/budget is not available on a wedge"),
        ("stress as a field", " fields (alpha stress);", "fields: stress is not available on a wedge"),
        ("gravity across the axis", "", "let gravity point along the axis")):
    case.write("constant/demProperties", good.replace("rho 1000;", "rho 1000;" + more))
    if not more:
        case.gravity("(9.81 0 0)")
    claim_refused(f"{what} is refused", case, words, "demPimpleFoam")
finish()
