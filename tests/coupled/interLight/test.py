"""Light spheres that leave a liquid: they follow it (demReaction), and not the air above.

- Thirty that rise float at the surface, where the fluids around them weigh as much as they do, and come to rest.
- One that is thrown out of the water flies as in air, and falls back.
- Momentum closes to round-off while they cross the surface.
- Half of the step changes the way up through the water by less than 0.1 %.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

d, g, surface = 1e-3, 9.81, 0.012
walls = {"walls": ("wall", "x- x+ y- y+ z- z+")}
rng = np.random.default_rng(4)


def light(name, insert, end, step, liquid=(1000, 0.02), kernel=""):
    case = TwoFluids(name)
    case.controls(end, step, write=0.01)
    case.fluids(liquid, (1, 1.8e-5), tolerance=1e-12, correctors=2)
    case.box((0.024, 0.012, 0.024), (12, 6, 12), walls)
    case.fields(walls)
    case.alpha(lambda x: x[:, 2] < surface)
    case.grains("grain { density 500; youngsModulus 1e6; }", "hertz {} dry { restitution 0.3; } "
                "schillerNaumann {} virtualMass {}", insert, kernel + "record { interval 5e-4; budget yes; }",
                "walls { walls { material grain; } }")
    claim_runs(f"{name}: runs", case, "demInterFoam")
    table = case.table("postProcessing/dem/0/budget.csv")
    for axis in "xyz":
        terms = max(largest(table[term]) for term in table if term.endswith(f".p{axis}"))
        error = largest(table[f"rest.p{axis}"])
        claim(f"{name}: rest.p{axis} is 0 (1e-10 of the largest term)", error < 1e-10*terms, error, terms)
    return case


def path(case):
    """Time, height above the surface and vertical velocity of each sphere, by id."""
    times = case.times()
    rows = np.array([case.particles(time, "positions", "U")[:, [3, 6]] for time in times])
    return np.array([float(time) for time in times]), rows[..., 0] - surface, rows[..., 1]


at = [(0.002*(2*(k % 5) + 1) + 0.002, 0.002*(k//5) + 0.001, 0.003) for k in range(30)]
positions = " ".join(vector(np.array(x) + rng.uniform(-2e-4, 2e-4, 3)) for x in at)
insert = f"grains {{ type list; diameter {d}; positions ({positions}); }}"
raft = light("raft", insert, 1.6, 5e-4)
t, z, w = path(raft)
rise = 0.01232                                  # m/s: F = 24 mu/(rho d v) (1 + 0.15 Re^0.687) pi/8 d2 rho v2 = (1 - 0.5) rho V g
claim("raft: they rise with the law's velocity (3 %)", close(w[30].mean(), rise, 0.03), w[30].mean(), rise)
claim("raft: they float where the fluids weigh as much (0.15 d)", largest(z[-1]) < 0.15*d, z[-1].min(), z[-1].max())
claim("raft: spheres and fluids come to rest (3 % of the velocity before)",
      largest(w[-1]) < 0.03*rise and largest(raft.interior("U")) < 0.03*rise, largest(w[-1]), largest(raft.interior("U")))
half = light("half", insert, 0.3, 2.5e-4)
th, zh, wh = path(half)
ways = [part[len(th) - 1].mean() - part[0].mean() for part in (z, zh)]
claim("half: half of the step changes the way up by less than 0.1 %", close(*ways, 1e-3), *ways)
thrown = light("thrown", f"grain {{ type list; diameter {d}; positions ((0.0121 0.0062 0.0112)); velocity (0 0 0.8); }}",
               0.4, 2.5e-4, liquid=WATER, kernel="kernel linear; ")
t, z, w = path(thrown)
in_air = (z[:3, 0] > 2*0.002) & (z[:3, 0] < surface - d)    # two cells above the surface, below the lid
rho, mu = AIR
speed = w[0, 0]
for _ in range(2000):                           # 20 ms under drag, buoyancy and added mass of air
    Re = rho*abs(speed)*d/mu
    drag = 18*mu*(1 + 0.15*Re**0.687)/(500*d*d)*speed
    speed -= 1e-5*(drag + g*(1 - rho/500))/(1 + 0.5*rho/500)
claim("thrown: it flies as in air (0.5 %)", np.all(in_air) and close(w[2, 0] - w[0, 0], speed - w[0, 0], 5e-3),
      w[2, 0], speed)
claim("thrown: it floats at rest again (0.15 d, 1 % of its velocity)",
      largest(z[-5:]) < 0.15*d and largest(w[-5:]) < 0.01*0.8, z[-5:, 0], w[-5:, 0])
finish()
