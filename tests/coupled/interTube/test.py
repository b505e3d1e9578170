"""Water in the lower half of a narrow ring oscillates through a plug of frozen particles with the period and the
damping of the linear equation for the displacement x of its ends,

    I x'' + R x' + 2 (rho1 - rho2) g x = 0,    I = sum rho dl/e,    R = sum K dl/e^2

summed along the ring. With a column L = 0.5 m and a sharp plug of l = 0.1 m, e = 0.5, K = 562.5 kg/m3/s: period 1.0994
s, amplitude after it 0.8137. The kernel spreads the ends of the plug, so e is the solver's.

Then fvOptions act in place of the plug: a porous zone of R = mu d l, and a force on the water of this zone, a pump, which
starts in level water.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

g, L, l, width = 9.81, 0.5, 0.1, 0.01
K, s, d = 562.5, 0.5, 1e-3
mu = K*d**2/18/s                                       # Stokes drag of the plug: K = 18 mu s/d^2
water, air = (1000, mu), (1, 1.8e-8)
radius, n, start = L/math.pi, 160, 0.003


def ring(case):
    """A ring around the y axis of one cell across, with n cells around it, and 4 blocks."""
    corners, arcs = [], ""
    for y in (0, width):
        for r in (radius - width/2, radius + width/2):
            corners += [(r*math.sin(a), y, -r*math.cos(a)) for a in np.arange(4)*math.pi/2]
    blocks = []
    for k in range(4):
        a, b = k, (k + 1) % 4
        blocks.append(f"({a} {b} {b + 4} {a + 4} {a + 8} {b + 8} {b + 12} {a + 12}) ({n//4} 1 1)")
        middle = (k + 0.5)*math.pi/2
        for layer, y in enumerate((0, width)):
            for ring, r in enumerate((radius - width/2, radius + width/2)):
                first = 8*layer + 4*ring
                arcs += f"arc {a + first} {b + first} {vector((r*math.sin(middle), y, -r*math.cos(middle)))}\n"
    patches = {}
    patches["rims"] = "type wall; faces (" + " ".join(
        f"({k + r} {(k + 1) % 4 + r} {(k + 1) % 4 + r + 8} {k + r + 8})" for k in range(4) for r in (0, 4)) + ");"
    patches["sides"] = "type wall; faces (" + " ".join(
        f"({k + y} {(k + 1) % 4 + y} {(k + 1) % 4 + y + 4} {k + y + 4})" for k in range(4) for y in (0, 8)) + ");"
    case.mesh(corners, blocks, patches, arcs)


def tube(name, end, start):
    """A case of this length of time [s], with the water displaced by `start` [m]."""
    global arc
    case = TwoFluids(name)
    case.controls(end, 5e-4, write=0.01)
    case.fluids(water, air, tolerance=1e-10, correctors=2)
    ring(case)
    case.fields(("rims", "sides"), slip=True)
    centres = case.centres()
    arc = radius*np.arctan2(centres[:, 0], -centres[:, 2])      # along the ring, from its lowest point
    case.alpha(lambda x: np.minimum((L/2 + start - arc)/h, (arc + L/2 - start)/h) + 0.5)
    return case


def displacement(case):
    """Times, and displacement of the water at each."""
    times = np.array([0, *map(float, case.times())])
    return times, np.array([np.sum(np.sign(arc)*case.field(f"{time:g}/alpha.water"))*h/2 for time in times])


h = 2*math.pi*radius/n
case = tube("plug", 1.3, start)
count = round(s*l*width**2/(math.pi/6*d**3))
angles = ((np.arange(count) + 0.5)/count - 0.5)*l/radius
positions = " ".join(vector((radius*math.sin(a), width/2, -radius*math.cos(a))) for a in angles)
case.grains("grain { density 2500; youngsModulus 1e6; }", "stokesDrag {}",
            f"plug {{ type list; diameter {d}; frozen yes; positions ({positions}); }}", "kernel linear;",
            "time { step 1e-3; }")
claim_runs("runs", case, "demInterFoam")

e = case.interior("voidFraction")
claim("the plug has the void fraction 0.5 (1 %)", close(np.sort(e)[n//40], 0.5, 0.01), np.sort(e)[:5])
wet = np.clip(np.minimum((L/2 - arc)/h, (arc + L/2)/h) + 0.5, 0, 1)
inertia = np.sum((water[0]*wet + air[0]*(1 - wet))*h/e)
resistance = np.sum(18*mu*(1 - e)/d**2*wet*h/e**2)
decay = resistance/inertia/2
omega = math.sqrt(2*(water[0] - air[0])*g/inertia - decay**2)
period, ratio = 2*math.pi/omega, math.exp(-2*math.pi*decay/omega)

times, x = displacement(case)
turns = [k for k in range(1, len(x) - 1) if x[k] > x[k - 1] and x[k] >= x[k + 1] and times[k] > period/2]


def top(k):
    """Time and value of the maximum of a parabola through three values."""
    a, b = (x[k + 1] - 2*x[k] + x[k - 1])/2, (x[k + 1] - x[k - 1])/2
    return times[k] - b/2/a*(times[k + 1] - times[k]), x[k] - b*b/4/a


claim("the water comes back once", len(turns) == 1, times[turns])
when, height = top(turns[0])
claim(f"the period is {period:.4f} s (0.5 %)", close(when, period, 5e-3), when, period)
claim(f"the amplitude after it is {ratio:.4f} (0.5 %)", close(height/x[0], ratio, 5e-3), height/x[0], ratio)
claim("the sharp plug has nearly the same (1 %)", close(period, 1.0994, 0.01) and close(ratio, 0.8137, 0.01), period,
      ratio)

# ---- a pump and a porous zone of fvOptions -------------------------------------------------------------

case = tube("pump", 0.6, 0)
zone = np.flatnonzero(abs(arc) < l/2)
final, darcy = 0.003, 2250/mu
f = 2*(water[0] - air[0])*g*final/np.sum(np.cos(arc[zone]/radius)*h)
case.dictionary("system/topoSetDict", f"""actions
(
    {{ name cells; type cellSet; action new; source labelToCell; value ({" ".join(map(str, zone))}); }}
    {{ name zone; type cellZoneSet; action new; source setToCellZone; set cells; }}
);""")
case.run("topoSet")
case.dictionary("constant/fvOptions", f"""
pump
{{
    type vectorSemiImplicitSource; selectionMode cellZone; cellZone zone; volumeMode specific;
    injectionRateSuSp {{ U (({f} 0 0) 0); }}
}}
resistance
{{
    type explicitPorositySource;
    explicitPorositySourceCoeffs
    {{
        selectionMode cellZone; cellZone zone; type DarcyForchheimer; d ({darcy} {darcy} {darcy}); f (0 0 0);
        coordinateSystem {{ type cartesian; origin (0 0 0); e1 (1 0 0); e2 (0 1 0); }}
    }}
}}
""")
case.grains("grain { density 2500; youngsModulus 1e6; }", "stokesDrag {}",
            f"grain {{ type list; diameter 1e-6; frozen yes; positions ((0 {width/2} {-radius})); }}",
            "kernel linear; record { interval 0.01; budget yes; }", "time { step 1e-3; }")
claim_runs("pump: runs", case, "demInterFoam")
inertia = np.sum((water[0]*wet + air[0]*(1 - wet))*h)
decay = mu*darcy*len(zone)*h/inertia/2
omega = math.sqrt(2*(water[0] - air[0])*g/inertia - decay**2)
times, x = displacement(case)
theory = final*(1 - np.exp(-decay*times)*(np.cos(omega*times) + decay/omega*np.sin(omega*times)))
claim("pump: the water moves as the linear equation says (1 % of the final displacement)",
      difference(x, theory) < 0.01*final, difference(x, theory)/final)
budget = case.table("postProcessing/dem/0/budget.csv")
terms = {name: largest(column) for name, column in budget.items() if name.endswith(".px")}
claim("pump: momentum closes with the impulse of the sources (1e-9 of the largest term)",
      0 < terms["sources.px"] and terms["rest.px"] < 1e-9*max(terms.values()), terms)
finish()
