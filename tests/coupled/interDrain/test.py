"""Water drains through a bed of frozen spheres, l = 0.1 m, void fraction e = 0.4, drag K = 43200 kg/m3/s, whose foot
and head are open: the level above the bed decays with K l/(e^2 rho g) = 2.752 s, and inside the bed the surface
falls at rho g e/K = 0.0908 m/s.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

g, l, e, K, rho = 9.81, 0.1, 0.4, 43200, 1000
mu, d = 1e-3, 0.5e-3                                   # 18 mu (1 - e)/d^2 = K
width, height, cells = 0.005, 0.3, 60
speed = rho*g*e/K

case = TwoFluids()
case.controls(2.8, 5e-3, write=0.1)
case.fluids((rho, mu), (1, 1e-8), tolerance=1e-10, correctors=2)
case.box((width, width, height), (1, 1, cells),
         {"sides": ("wall", "x- x+ y- y+"), "foot": ("patch", "z-"), "head": ("patch", "z+")})
open_U = "type pressureInletOutletVelocity; value uniform (0 0 0);"
open_alpha = "type inletOutlet; inletValue uniform 0; value uniform 0;"
# the pressure of the air at the head, 0 at the foot; p_rgh = p - rho g.x
case.fields(("sides",), slip=True,
            more=(f"foot {{ {open_U} }} head {{ {open_U} }}",
                  f"foot {{ type fixedValue; value uniform 0; }} head {{ type fixedValue; value uniform {g*height}; }}",
                  f"foot {{ {open_alpha} }} head {{ {open_alpha} }}"))
case.alpha(lambda x: x[:, 2] < 2*l)
count = round((1 - e)*l*width**2/(math.pi/6*d**3))
positions = " ".join(vector((width/2, width/2, (k + 0.5)*l/count)) for k in range(count))
case.grains("grain { density 2500; youngsModulus 1e6; }", "stokesDrag {}",
            f"bed {{ type list; diameter {d}; frozen yes; positions ({positions}); }}", "kernel linear;",
            "time { step 1e-2; }")
claim_runs("runs", case, "demInterFoam")
void = case.interior("voidFraction")
claim("the bed has the void fraction 0.4 (1 %)", close(void[5], e, 0.01), void[:cells//2])
# with the ends of the bed that the kernel spreads
tau = np.sum(18*mu*(1 - void)/d**2/void**2)*height/cells/(rho*g)
claim("the time of the sharp bed, 2.752 s, is nearly the same (3 %)", close(tau, K*l/(e**2*rho*g), 0.03), tau)
times = np.array([float(time) for time in case.times()])
level = np.array([np.sum(case.field(f"{time}/alpha.water"))*height/cells for time in case.times()])
above = (level > l*1.1) & (times > 0.15)
inside = (level < l*0.9) & (level > l*0.2)
rate = -np.polyfit(times[above], np.log(level[above]), 1)[0]
claim(f"above the bed the level decays with {tau:.3f} s (1 %)", above.sum() > 10 and close(1/rate, tau, 0.01), 1/rate,
      tau)
fall = -np.polyfit(times[inside], level[inside], 1)[0]
claim(f"inside the bed the surface falls at {speed:.4f} m/s (1 %)", inside.sum() > 4 and close(fall, speed, 0.01),
      fall, speed)
finish()
