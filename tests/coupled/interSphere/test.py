"""Single spheres that do not act on the fluids.

- One sinks from a fluid into a heavier, thinner one, each wider than the kernel: in both it reaches the velocity of
  Stokes with the density and viscosity of that fluid.
- One of 0.9 times the liquid's density floats: as Archimedes says with the kernel `divided`, at the depth of the
  kernel's mean density with `diffusion`.
- Steel balls hit the floor under oil and the ceiling in air above it: they rebound by the Stokes number with viscosity
  and added mass of the fluid around each, as in the first set-up of Gondret et al. (tutorials/rebound), and by a film
  (lubrication) with that viscosity.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

d, rho_p, g = 0.5e-3, 2500, 9.81
light, heavy = (900, 0.1), (1200, 0.5)


def settling_velocity(rho, mu):
    """Of a single sphere with Stokes' drag, 3 pi mu d v."""
    return (rho_p - rho)*g*d**2/18/mu


walls = {"walls": ("wall", "x- x+ y- y+ z- z+")}
case = TwoFluids()
case.controls(20, 0.02, write=0.5)
case.fluids(heavy, light, tolerance=1e-10, correctors=2)
case.box((0.02, 0.02, 0.06), (10, 10, 30), walls)
case.fields(walls)
case.alpha(lambda x: x[:, 2] < 0.03)
# one-way: a single sphere without the flow that it makes, which the box would change
case.grains("ball { density 2500; youngsModulus 1e6; }", "hertz {} stokesDrag {}",
            f"ball {{ type list; diameter {d}; positions ((0.01 0.01 0.037)); }}",
            "twoWay no;")
claim_runs("runs", case, "demInterFoam")
times = case.times()
z, w = (np.array([case.field(f"{time}/lagrangian/particles/{name}")[0, 2] for time in times])
        for name in ("positions", "U"))
above, below = (z > 0.0345) & (z < 0.0365), z < 0.026
for name, where, fluid in (("light", above, light), ("heavy", below, heavy)):
    v = settling_velocity(*fluid)
    claim(f"in the {name} fluid: the velocity is {v*1e3:.4g} mm/s (0.1 %)",
          where.any() and np.all(abs(-w[where]/v - 1) < 1e-3), -w[where], v)

# ---- floating ---------------------------------------------------------------------------------------

d, above, h = 0.01, 1.0, 0.005
share = (900 - above)/(1000 - above)                            # of the weight of liquid it displaces
wet = (1 + np.linspace(-1, 1, 20001))**2*(2 - np.linspace(-1, 1, 20001))/4
archimedes = d/2*np.interp(share, wet, np.linspace(-1, 1, 20001))
# a Gaussian of width b, exp(-x2/b2): erfc(-depth/b)/2 of it are in the liquid
depths = np.linspace(-3, 3, 20001)
smeared = 3*d*np.interp(share, [math.erfc(-x)/2 for x in depths], depths)
for kernel, depth, width in (("divided", archimedes, d), ("diffusion; width 3", smeared, 3*d)):
    case = TwoFluids("floating-" + kernel.split(";")[0])
    case.controls(2, 2e-3)
    case.fluids((1000, 0.1), (above, 1e-3), tolerance=1e-10, correctors=2)
    case.box((0.02, 0.02, 0.24), (4, 4, 48), walls)
    case.fields(walls)
    case.alpha(lambda x: x[:, 2] < 0.12)
    case.grains("ball { density 900; youngsModulus 1e6; }", "hertz {} stokesDrag {}",
                f"ball {{ type list; diameter {d}; positions ((0.0101 0.0098 {0.12 - 0.95*depth})); }}",
                f"twoWay no; kernel {kernel};")
    claim_runs(f"floating, {kernel}: runs", case, "demInterFoam")
    z, w = case.particles("2", "positions", "U")[0, [3, 6]]
    claim(f"floating, {kernel}: it rests (1e-5 m/s)", abs(w) < 1e-5, w)
    claim(f"floating, {kernel}: its centre is {depth*1e3:.3f} mm below the surface (1 % of the kernel's width)",
          abs(0.12 - z - depth) < 0.01*width, 0.12 - z, depth)

# ---- rebound ----------------------------------------------------------------------------------------

d, steel, speed, oil, air = 6e-3, 7800, 0.518135, (965, 0.1), (1.2, 1.8e-5)


def stokes(mu, added):
    """Stokes number of the impact."""
    return (steel + added)*d*speed/(9*mu)


def by_contact(mu, added):
    """Legendre et al. 2006."""
    return 0.97*math.exp(-35/stokes(mu, added))


def by_film(mu, added):
    """A film takes v/St ln(cutOff/roughness) before and after a contact with a restitution of 0.97."""
    return 0.97 - 1.97*math.log(1e3)/stokes(mu, added)


contact = "stokesDamping { restitution 0.97; %s }"
film = f"dry {{ restitution 0.97; }} lubrication {{ roughness {1e-4*d/2}; cutOff {0.1*d/2}; }}"
for name, damping, law, added, step, bound in (
        ("stokesDamping without added mass", contact % "", by_contact, (0, 0), 2e-7, 2e-3),
        ("stokesDamping and virtualMass", contact % "" + " virtualMass {}", by_contact, (oil[0]/2, air[0]/2), 2e-7, 2e-3),
        ("stokesDamping with a density of its own", contact % "fluidDensity 965;", by_contact, (oil[0]/2, oil[0]/2), 2e-7,
         2e-3),
        # of the 0.5 %, 0.3 % are the step at the end of the film
        ("lubrication", film, by_film, (0, 0), 5e-8, 5e-3)):
    case = TwoFluids("rebound-" + name.replace(" ", "-"))
    case.controls(3e-3, 1e-3)
    case.fluids(oil, air, gravity="(0 0 0)")
    case.box((0.06, 0.06, 0.12), (6, 6, 12), walls)
    case.fields(walls)
    case.alpha(lambda x: x[:, 2] < 0.06)
    case.grains("steel { density 7800; youngsModulus 1e9; }", f"hertz {{}} {damping}",
                f"""down {{ type list; diameter {d}; positions ((0.0271 0.0323 3.35e-3)); velocity (0 0 {-speed}); }}
                    up {{ type list; diameter {d}; positions ((0.0271 0.0323 0.11665)); velocity (0 0 {speed}); }}""",
                "twoWay no;", f"time {{ step {step}; }}")
    claim_runs(f"{name}: runs", case, "demInterFoam")
    down, up = case.particles(case.times()[-1], "U")[:, 3]
    for fluid, e, form in (("oil", down/speed, law(oil[1], added[0])), ("air", -up/speed, law(air[1], added[1]))):
        claim(f"{name}: e in {fluid} is {form:.4f} ({bound:g} of it)", close(e, form, bound), e, form)
finish()
