"""Small spheres, denser than the liquid, that surface tension holds at its surface (capillaryForce).

- The largest load is 2 pi sigma R sin2(theta/2): 1 % less floats, 1 % more sinks. Half of it rests where the force of
  the contact line, -2 pi sigma R sin(p) sin(p + theta) with cos(p) = z/R, is its weight.
- Below and above the surface the effect changes no bit of a sphere's path.
- The liquid carries the load: momentum closes to round-off, and a sphere that floats at rest leaves the fluids at rest.
- The surface pulls at a frozen sphere, too: momentum closes while another one sinks and the order of both changes.
- In water at the longest step a grain of glass comes to rest at the surface; a fixed step that is too long is told.
- A case without surface tension is refused.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

d, sigma, theta, g, surface = 1e-3, 0.05, math.radians(70), 9.81, 0.012
R, V, width = d/2, math.pi/6*d**3, 3*d
walls = {"walls": ("wall", "x- x+ y- y+ z- z+")}
capillary = f"capillaryForce {{ contactAngle {math.degrees(theta):.17g}; }}"


def force(z):
    """Upwards, with the centre at this height above the surface."""
    p = math.acos(z/R)
    return -2*math.pi*sigma*R*math.sin(p)*math.sin(p + theta)


def buoyancy(z):
    """Of the kernel's mean density, a Gaussian of the kernel's width."""
    return (1 + 999*math.erfc(z/width)/2)*V*g


def floats(name, effects, cells, spheres, coupling, end, kinds, liquid=(1000, 0.2), gas=(1, 1e-3)):
    case = TwoFluids(name)
    case.controls(end, 5e-4, write=end/4)
    case.fluids(liquid, gas, sigma=sigma, tolerance=1e-11, correctors=2)
    case.box((0.024, 0.012, 0.024), cells, walls)
    case.fields(walls)
    case.alpha(lambda x: x[:, 2] < surface)
    case.grains(" ".join(f"{kind} {{ density {density:.17g}; youngsModulus 1e6; }}" for kind, density in kinds.items()),
                f"hertz {{}} stokesDrag {{}} {effects}",
                " ".join(f"of_{kind} {{ type list; material {kind}; diameter {d}; positions ({vector(x)}); }}"
                         for kind, x in spheres.items()), coupling,
                f"walls {{ walls {{ material {next(iter(kinds))}; }} }}")
    return case


highest = -R*math.cos(theta/2)                      # of the sphere under the largest load, above the surface
load = force(highest)
claim("the largest load is 2 pi sigma R sin2(theta/2)", close(load, 2*math.pi*sigma*R*math.sin(theta/2)**2, 1e-12), load)
kinds = {"light": (0.99*load + buoyancy(highest))/V/g, "heavy": (1.01*load + buoyancy(highest))/V/g,
         "half": (load/2 + buoyancy(-R*math.cos(theta)))/V/g, "below": 1100, "above": 1100}
spheres = {kind: (0.003 + 0.0045*k, 0.0062, surface + highest + 0.15*R) for k, kind in enumerate(kinds)}
spheres["half"] = (*spheres["half"][:2], surface - R*math.cos(theta))
spheres["below"] = (*spheres["below"][:2], 0.009)
spheres["above"] = (*spheres["above"][:2], 0.0225)
paths = {}
for name, effects in (("with", capillary), ("without", "")):
    case = floats(name, effects, (12, 6, 24), spheres, "twoWay no;", 0.4, kinds)
    claim_runs(f"{name} the effect: runs", case, "demInterFoam")
    paths[name] = np.array([case.particles(time, "positions", "U")[:, 1:] for time in case.times()])
z = dict(zip(kinds, paths["with"][-1, :, 2] - surface))
claim("99 % of the largest load floats", abs(z["light"]) < R, z["light"]/R)
claim("101 % of it sinks", z["heavy"] < -R, z["heavy"]/R)
depths = np.linspace(highest, -R*math.cos(theta), 20001)
rest = depths[np.argmin([abs(force(x) + buoyancy(x) - kinds["half"]*V*g) for x in depths])]
claim(f"half of it rests at {rest/R:.4f} R (0.02 R)", abs(z["half"] - rest) < 0.02*R, z["half"]/R)
claim("without the effect all sink", np.all(paths["without"][-1, :3, 2] < surface - R), paths["without"][-1, :, 2])
claim("below and above the surface the paths have the same bits",
      np.array_equal(paths["with"][:2, 3:], paths["without"][:2, 3:]) and largest(paths["with"][:2, 3:, 5]) > 0.01,
      paths["with"][:2, 3:, 5])

case = floats("load", f"{capillary} virtualMass {{}}", (12, 6, 12), {"grain": (0.0117, 0.0064, surface - R/2)},
              "record { interval 5e-4; budget yes; }", 0.4, {"grain": 2500})
claim_runs("load: runs", case, "demInterFoam")
table = case.table("postProcessing/dem/0/budget.csv")
for axis in "xyz":
    terms = max(largest(table[name]) for name in table if name.endswith(f".p{axis}"))
    for name, bound in (("rest", 1e-11), ("particleTension", 1e-12)):
        error = largest(table[f"{name}.p{axis}"])
        claim(f"load: {name}.p{axis} is 0 ({bound:g} of the largest term)", error < bound*terms, error, terms)
z, w = case.particles(case.times()[-1], "positions", "U")[0, [3, 6]]
claim("load: a grain of 2500 kg/m3 floats", abs(z - surface) < R and abs(w) < 1e-4, (z - surface)/R, w)
speed = largest(case.interior("U"))
claim("load: the fluids rest (1 mm/s)", speed < 1e-3, speed)

# The surface holds a frozen sphere while another one sinks past its neighbors, so that the core sorts them anew
case = floats("frozen", capillary, (12, 6, 12), {"grain": (0.0117, 0.0064, surface + 1.2*R)},
              "record { interval 5e-4; budget yes; }", 0.2, {"grain": 9000})
case.sub("constant/demProperties", "of_grain ", "held { type list; material grain; diameter "
         f"{d}; frozen yes; positions ({vector((0.0163, 0.0064, surface - 0.3*R))}); }}\n    of_grain ")
claim_runs("frozen: runs", case, "demInterFoam")
table = case.table("postProcessing/dem/0/budget.csv")
terms = max(largest(table[name]) for name in table if name.endswith(".pz"))
claim("frozen: the other sphere has sunk", case.particles(case.times()[-1], "positions")[:, 3].min() < surface - 4*R)
claim("frozen: rest.pz is 0 (1e-11 of the largest term)", largest(table["rest.pz"]) < 1e-11*terms, largest(table["rest.pz"]), terms)

# In water drag damps little, and a step of the right size must not make the grain jump
case = floats("water", capillary, (12, 6, 12), {"grain": (0.0117, 0.0064, surface - R/2)}, "", 0.2, {"grain": 2500},
              WATER, AIR)
case.edit("system/controlDict", adjustTimeStep="yes", maxDeltaT=1, maxCo=10, maxParticleCo=100)
claim_runs("water: runs", case, "demInterFoam")
mass = 2500*V
step, limit = 0.5*math.sqrt(mass/(2*math.pi*sigma)), case.numbers("^deltaT = (.*)$", "demInterFoam")[1:-1, 0].max()
claim("water: the longest step is half of sqrt(m/(2 pi sigma))", close(limit, step, 0.05) and limit <= step*(1 + 1e-9),
      limit, step)
z, w = case.particles(case.times()[-1], "positions", "U")[0, [3, 6]]
claim("water: a grain of glass floats at rest", abs(z - surface) < R/2 and abs(w) < 2e-3, (z - surface)/R, w)

case.edit("system/controlDict", adjustTimeStep="no", deltaT=1.1*math.sqrt(mass/(math.pi*sigma)), endTime=0.01)
case.run("demInterFoam")
claim("water: a step that is too long is told", case.found("may jump off it: the step, .* is longer than", "demInterFoam"))

case.edit("system/controlDict", endTime=1e-3, deltaT=5e-4)
case.sub("constant/transportProperties", "^sigma .*", "sigma 0;")
claim_refused("no surface tension", case, "capillaryForce ... sigma of ... is 0", "demInterFoam")
finish()
