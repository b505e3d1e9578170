"""Drag laws see the fluid without a particle's own wake and own volume (ownWake).

- One sphere that falls obliquely through liquid has the speed of its law, from the start at rest on, at Re 1 and 100
  (0.1 to 100 in a long run); without the entry it is up to 45 % too fast.
- Steps of 0.1 to 100 times the relaxation time are stable.
- The gain of speed by a second sphere remains.
- A random suspension settles, and a random frozen bed resists, as the law says at its void fraction (1 %).
- A restart continues with the same bits; two ranks agree with one.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from closures import gidaspow_gradient, lattice_void
from oblique import *


def relaxation(Re, density=2650):
    """Relaxation time of the law, as a part of d/speed."""
    return density/1000/18*Re/factor(Re)


def fall(name, kernel, cell, Re, own="yes", run=True, **way):
    case = Case(re.sub("[^a-z0-9]+", "-", name), source="shared")
    prepare(case, f"kernel {kernel}; ownWake {own};", cell, Re, **way)
    if run:
        claim_runs(f"{name}: runs", case)
        claim(f"{name}: exchange closes", worst(case.log(), "exchange error") < 1e-12)
    return case


def law(steps, T, Re, density):
    """The same as speeds(), from rest, of dv/dt = (f(Re) - f(Re v) v)/tau; T in d/speed."""
    v, result, parts = 0, [], 2000
    for _ in range(steps):
        for _ in range(parts):
            v += T/parts*(factor(Re) - factor(Re*v)*v)/(density/1000/18*Re)
        result.append(v)
    return np.array(result)


# ---- one sphere ------------------------------------------------------------------------------------

narrow, wide = ("linear", 2), ("diffusion; width 1.5", 1)          # with size of the cells [d]
for kernel, cell in (narrow, wide):
    for Re in (0.1, 1, 10, 100) if thorough else (1, 100) if cell == 2 else (1,):
        # at Re 0.1 a short way, or the walls matter; at high Re it starts with the law's speed
        way = dict(travel=2, step=0.1) if Re < 1 else dict(start=float(Re > 1), step=0.25*cell)
        name = f"{kernel}, cells of {cell} d, Re {Re}"
        with_own = mean(fall(f"{name}, yes", kernel, cell, Re, **way))
        claim(f"{name}: the law's speed (2 %)", close(with_own, 1, 0.02), with_own)
        if Re <= 1:
            without = mean(fall(f"{name}, no", kernel, cell, Re, own="no", **way))
            claim(f"{name}: more than 10 % too fast without", without > 1.1, without)

v = mean(fall("linear, cells of 1 d, Re 1", "linear", 1, 1))
claim("linear, cells of 1 d, Re 1: the law's speed (5 %)", close(v, 1, 0.05), v)
if thorough:                                          # with long steps it swings by 12 %
    v = speeds(fall("linear, cells of 1 d, short steps", "linear", 1, 1, step=0.05))
    swing = np.ptp(v[len(v)//2:])/2
    claim("linear, cells of 1 d, Re 1, a twentieth of a cell a step: swings by less than 5 %", swing < 0.05, swing)

for density in (2650, 20000):
    tau = relaxation(1, density)
    case = fall(f"start, density {density}", *narrow, 1, density=density, travel=8*tau, step=tau/4)
    v = speeds(case, density)
    error = difference(v, law(len(v), tau/4, 1, density))
    claim(f"start from rest, density {density}: the law's speed at all times (2 % of the last)", error < 0.02, error)

for steps in (0.1, 100):
    tau = relaxation(0.1)
    case = fall(f"steps of {steps} tau", *narrow, 0.1, step=steps*tau, travel=10 if steps > 1 else 100*steps*tau)
    v = speeds(case)
    claim(f"steps of {steps} relaxation times: stable", 0.8 < v[-1] <= v.max() < 1.05, v[-1], v.max())

# ---- two spheres -----------------------------------------------------------------------------------

short = dict(travel=2, step=0.1)
single = {own: mean(fall(f"alone, {own}", *narrow, 0.1, own, **short)) for own in ("no", "yes")}
for distance in (1.5, 3) if thorough else (1.5,):
    gain = {own: mean(fall(f"pair {distance}, {own}", *narrow, 0.1, own, behind=distance, **short))/2 - single[own]
            for own in ("no", "yes")}
    claim(f"two spheres, {distance} d in line: the gain of speed is kept (0.02)", abs(gain["yes"] - gain["no"]) < 0.02,
          gain)

# ---- restart and ranks -----------------------------------------------------------------------------

for kernel, cell in (narrow, wide):
    case = fall("restart", kernel, cell, 1, run=False)
    end = float(re.search("^endTime (.*);", case.read("system/controlDict"), re.M)[1])
    case.edit("system/controlDict", writeInterval=end/2, writePrecision=17)
    case.run("demPimpleFoam")
    middle, last = case.times()
    straight = snapshot_hash(case/last/"uniform/dem.snapshot"), case.read(f"{last}/U")
    shutil.rmtree(case/last)
    case.edit("system/controlDict", startTime=middle)
    case.run("demPimpleFoam")
    claim(f"{kernel}: a restart has the same bits",
          straight == (snapshot_hash(case/last/"uniform/dem.snapshot"), case.read(f"{last}/U")))

    alone = speeds(fall("one rank", kernel, cell, 1))
    case = fall("two ranks", kernel, cell, 1, run=False)
    case.dictionary("system/decomposeParDict",
                    "numberOfSubdomains 2; method simple; simpleCoeffs { n (2 1 1); delta 0.001; }")
    case.run("decomposePar")
    case.run("demPimpleFoam", ranks=2)
    claim(f"{kernel}: two ranks agree with one (solver's tolerance)", lambda: difference(alone, speeds(case)) < 1e-6)

# ---- many spheres ----------------------------------------------------------------------------------

side, weight, volume = 16, 1500*9.81, np.pi/6*1e-12   # periodic box [d], N/m3 less buoyancy, m3; d = 0.1 mm, water


def spheres(solid, seed):
    """Centres [d] at random, without overlap, in the periodic box."""
    rng, centres = np.random.default_rng(seed), np.empty((0, 3))
    while len(centres) < round(solid*side**3*6/np.pi):
        x = rng.uniform(0, side, 3)
        apart = centres - x
        apart -= side*np.round(apart/side)
        if (np.sum(apart**2, axis=1) > 1.0004).all():
            centres = np.vstack((centres, x))
    return centres


def drag(e, slip):
    """Of a sphere [N]: Wen and Yu (1966)."""
    return 3*np.pi*1e-7*e**-2.65*(1 + 0.15*(100*e*slip)**0.687)*slip


def settling_slip(e):
    """Drag is e V (rho_p - rho) g, as the pressure gradient carries the rest."""
    slip = 1e-3
    for _ in range(200):
        slip *= e*volume*weight/drag(e, slip)
    return slip


def suspension(own, centres, frozen):
    """Slip of free particles over the law's, or pressure gradient of frozen ones over the law's. The mean velocity of
    the fluid is kept: free 0, frozen the law's slip."""
    case = Case("suspension", source="shared")
    e, n, length = 1 - len(centres)*np.pi/6/side**3, side//2, side*1e-4
    mean = settling_slip(e) if frozen else 1e-9
    case.controls(0.08, 2e-3, nu=1e-6)
    case.box((length, length, length), (n, n, n), cyclic="xyz")
    case.flow(f"(0 0 {mean if frozen else 0})")
    case.gravity(f"(0 0 {0 if frozen else -9.81})")
    case.dictionary("constant/fvOptions", f"""
drive {{ type meanVelocityForce; selectionMode all; fields (U); Ubar (0 0 {mean}); }}
""")
    case.properties("glass { density 2500; youngsModulus 1e5; }", "hertz {} wenYu {} pressureGradient {}",
                    f"a {{ type list; diameter 1e-4; {'frozen yes;' if frozen else ''} "
                    f"positions ({' '.join(map(vector, centres*1e-4))}); }}",
                    f"rho 1000; kernel linear; ownWake {own};")
    claim_runs(f"suspension, frozen {frozen}, {own}: runs", case)
    u = case.vectors("fluid", "momentum")[:, 2]/(1000*e*length**3)
    v = case.vectors("particles", "momentum")[:, 2]/(2500*volume*len(centres))
    if frozen:
        gradient = 1000*float(case.found("^Pressure gradient source: .* pressure gradient = (.*)")[1])
        return gradient*length**3*e/(len(centres)*drag(e, u[-1]))
    return (u - v)[20:].mean()/settling_slip(e)


centres = [spheres(0.1, seed) for seed in range(3 if thorough else 1)]
for frozen in (False, True):
    what = "a random frozen bed: pressure gradient" if frozen else "a random suspension: slip"
    value = np.mean([suspension("yes", x, frozen) for x in centres])
    claim(f"{what} is the law's (1 %)", close(value, 1, 0.01), value)
value = suspension("no", centres[0], False)
claim("a random suspension: 2 % too fast without", value > 1.02, value)

# the frozen lattice of fixedBed
case = Case("lattice", source="fixedBed")
case.sub("constant/demProperties", "kernel .*", "kernel diffusion; ownWake yes;")
case.run("demPimpleFoam")
p = case.field("0.02/p").reshape(18, 25).mean(1)
claim("a frozen lattice: pressure gradient is the closure's (0.5 %)",
      close(1.2*(p[0] - p[3])/(3*0.0022), gidaspow_gradient(lattice_void), 0.005))
finish()
