"""The influence of the kernel on the flow.

- A moving cluster changes the void fraction and the pressure smoothly, however short the step.
- A random bed has the same void fraction and pressure drop on cells of 4 to 1/2 diameters.
- Steps that are too long are reported, and limited where they adapt.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

control = "system/controlDict"

# ---- a moving cluster ------------------------------------------------------------------------------


def cluster(name, kernel, step, material="density 1e9; youngsModulus 1e9;"):
    """216 spheres move along a duct that is open at both ends."""
    case = Case(name)
    places = " ".join(f"({x} 0.01 0.01)" for x in (0.003, 0.007, 0.011, 0.015, 0.019, 0.023, 0.027))
    case.controls(0.05, step, 1, f"""rate {{ type fieldMinMax; libs ("libfieldFunctionObjects.so"); fields (dem:dsdt);
    location no; writeControl timeStep; log no; }}
pressure {{ type probes; libs ("libsampling.so"); fields (p); writeControl timeStep;
    probeLocations ({places} (0.011 0.005 0.01) (0.015 0.005 0.01) (0.019 0.005 0.01)); }}""")
    case.box((0.032, 0.02, 0.02), (16, 10, 10), {"ends": ("patch", "x- x+"), "sides": ("wall", "y- y+ z- z+")})
    case.flow("(0 0 0)", "ends { type zeroGradient; } sides { type slip; }",
              "ends { type fixedValue; value uniform 0; } sides { type fixedFluxPressure; }")
    case.properties(f"tungsten {{ {material} }}", "hertz {} gidaspow {} pressureGradient {}",
                    "cluster { type lattice; diameter 1e-3; count 216; spacing 1.1; jitter 0; velocity (0.1 0 0); "
                    "min (0.0071 0.0067 0.0067); max (0.0138 0.0134 0.0134); }", f"rho 1000; kernel {kernel};")
    return case


def rates(case):
    """After the start: the largest |ds/dt| [1/s], and the largest change of pressure at a probe from one step to the
    next, over rho [m2/s2]."""
    rows = [line.split() for line in case.read("postProcessing/rate/0/fieldMinMax.dat").split("\n")
            if line and not line.startswith("#")]
    p = np.loadtxt(case/"postProcessing/pressure/0/p")
    extremes = [float(number) for time, *_, low, high in rows if float(time) > 0.01 for number in (low, high)]
    return largest(extremes), largest(np.diff(p[:, 1:], axis=0)[p[1:, 0] > 0.01])


# 0.5 mm and 0.25 mm, a quarter and an eighth of a cell, in a step
for kernel in ("diffusion", "particleCentre") + ("gaussian", "divided", "linear")*thorough:
    found = []
    for step in (2.5e-3, 1.25e-3):
        name = f"cluster, {kernel}, step {step} s"
        case = cluster(f"{kernel}-{step}", kernel, step)
        claim_runs(f"{name}: runs", case)
        claim(f"{name}: volume of the particles is kept", worst(case.log(), "volume error") < 1e-12)
        claim(f"{name}: exchange closes", worst(case.log(), "exchange error") < 1e-12)
        found.append(rates(case))
    (rate, jump), (rate2, jump2) = found
    print(f"# {kernel}: largest ds/dt {rate:g}, {rate2:g} 1/s, largest jump of pressure {jump:g}, {jump2:g} m2/s2")
    if kernel == "particleCentre":                    # 36 spheres change cells together, in however short a step
        claim(f"cluster, {kernel}: ds/dt doubles, as this kernel is discontinuous", rate2 > 1.7*rate)
        # with voidageFlux 0 (coupling/averaged/voidageFlux.H) the jump of pressure is 1.04 m2/s2
        claim(f"cluster, {kernel}: the voidage flux takes up 98 % of the jump of pressure", jump2 < 0.02*1.04)
    else:
        claim(f"cluster, {kernel}: ds/dt grows by less than 1.3 when the step is halved", rate2 < 1.3*rate)
        claim(f"cluster, {kernel}: the jump of pressure grows by less than 1.3", jump2 < 1.3*jump)

# ---- one random bed, frozen, on cells of 4, 2, 1 and 1/2 diameters ---------------------------------
# A duct of 12 x 12 x 32 diameters, gas from below, filled from end to end, or from 8 to 24 diameters.


def bed(name, n, low, high):
    """The bed on cells of 4/n diameters: the solid fraction in cells of 4 diameters, and the pressure drop over rho."""
    case = Case(f"bed-{high}-{n}")
    case.properties("glass { density 2500; youngsModulus 1e6; }", "hertz {} gidaspow {} pressureGradient {}",
                    f"""bed {{ type random; diameter 1e-3; solidFraction 0.55; frozen yes;
    min (0 0 {low}); max (0.012 0.012 {high}); }}""", "rho 1.2; kernel diffusion;")
    case.controls(0.004, 1e-3)
    case.duct((0.012, 0.012, 0.032), (3*n, 3*n, 8*n), 0.3, start=0.3)
    claim_runs(f"{name}, cells of 4/{n} d: runs", case)
    solid = 1 - case.field("0.004/voidFraction").reshape(8, n, 3, n, 3, n).mean((1, 3, 5))
    # pressure at the inlet, continued from the two layers of cells before it; it is 0 at the outlet
    p = case.field("0.004/p").reshape(8*n, -1).mean(1)
    return solid, 1.5*p[0] - 0.5*p[1]


# The filled duct has no surfaces: only the kernel makes a difference. A surface is a cell wide and more: with cells of
# 4 diameters the free bed is four cells thick, and its pressure drop a tenth less, because of the cells, not the kernel
for name, low, high, shares in (("filled bed", 0, 0.032, {1: 0.02, 2: 0.02, 4: 0.02}),
                                ("free bed", 0.008, 0.024, {1: None, 2: 0.04, 4: 0.02})):
    finest, drop = bed(name, 8, low, high)
    for n, share in shares.items():
        solid, p = bed(name, n, low, high)
        off = np.linalg.norm(solid - finest)/np.linalg.norm(finest)
        print(f"# {name}, cells of 4/{n} d: void fraction differs by {off:g}, drop {p:g} against {drop:g} m2/s2")
        claim(f"{name}, cells of 4/{n} d: solid's fraction is that on cells of d/2 (2 % in L2)", off < 0.02)
        if share:
            claim(f"{name}, cells of 4/{n} d: pressure drop is that on cells of d/2 (share {share})",
                  close(p, drop, share))

# ---- limits of the time step -----------------------------------------------------------------------
# A fixed step of 25 ms exceeds all limits: 2.5 mm for half of the kernel's 1.5 mm, a sixth of the void fraction; and,
# for spheres of 1000 kg/m3, two relaxation times (rho_p d^2/18 mu/G = 0.012 s, G = 4.5 in a cluster that the kernel
# has spread)


def reported_once(case, name):
    return len(re.findall(rf"is long: .*\({name}\)", case.log())) == 1


case = cluster("long", "diffusion", 2.5e-2)
claim_runs("a long step: runs", case)
for name in ("maxParticleCo", "maxVoidFractionChange"):
    claim(f"a long step: {name} is reported once", reported_once(case, name))

case = cluster("light", "diffusion", 2.5e-2, "density 1000; youngsModulus 1e6;")
case.run("demPimpleFoam")
claim("a step of two relaxation times is reported once", reported_once(case, "maxRelaxation"))

# The step grows up to the limit of the criterion, and not beyond by more than a share: the limit uses the rate of the
# previous step, and the rate of the void fraction changes by up to half here, as the layers of the lattice cross a cell
for name, limit, key, share in (("maxParticleCo", 0.2, "Particle Courant Number max:", 1.1),
                                ("maxVoidFractionChange", 0.02, "change of void fraction", 1.5),
                                ("maxRelaxation", 0.05, "step over relaxation time", 1.1)):
    light = ("density 5e3; youngsModulus 1e6;",)*(name == "maxRelaxation")
    case = cluster(f"limited-{name}", "diffusion", 1e-3, *light)
    case.edit(control, adjustTimeStep="yes", maxCo=5, maxDeltaT=1, **{name: limit})
    claim_runs(f"a step limited by {name}: runs", case)
    claim(f"a step limited by {name}: it is named", case.found(rf"time step limited by {name}$"))
    largest_seen = worst(case.log(), key)
    claim(f"a step limited by {name}: the limit holds", largest_seen < share*limit)
    claim(f"a step limited by {name}: the limit is reached (10 %)", largest_seen > 0.9*limit)

case = cluster("wrong", "diffusion", 1e-3)
for name, limit in (("maxParticleCo", 0), ("maxCo", -1)):
    case.edit(control, **{"maxParticleCo": 0.5, name: limit})
    claim_refused(f"{name} {limit} is refused", case, f"{name} is {limit}; it must be positive", "demPimpleFoam")
finish()
