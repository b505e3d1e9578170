"""Waves of small amplitude on the surface between two fluids, without and with particles.

With the densities and drag coefficients per volume of the void space, n the rate of growth,

    sum over both fluids of (rho n^2 + K n/e) coth(k H) = (rho_above - rho_below) g k

- Sloshing of water under air in a box of 0.1 m, half full: 16.80/s, also with frozen particles without drag in all
  cells.
- The same with a drag of 1500 kg/m3/s in the water: it decays with 1.499/s.
- Rayleigh and Taylor's growth, 3:1, one wave in the box: 17.52/s, also with these particles.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

g, L = 9.81, 0.1


def box(name, k, cells, bottom, top, amplitude, end, step, solid=False, drag=False):
    """A box of one cell across with slip walls; the surface at mid-height is a cosine. Returns the case and the
    amplitude
    of the cosine at each written time."""
    case = TwoFluids(re.sub(r"\W+", "-", name))
    case.controls(end, step, write=end/40)
    case.fluids(bottom, top, tolerance=1e-9, correctors=3)
    h = L/cells
    case.box((L, h, L), (cells, 1, cells), {"walls": ("wall", "x- x+ z- z+"), "sides": ("wall", "y- y+")})
    case.fields(("walls", "sides"), slip=True)
    case.alpha(lambda x: (L/2 + amplitude*np.cos(k*x[:, 0]) - x[:, 2])/h + 0.5)
    solids = ""
    if solid:
        # one small sphere in the middle of each cell, so that the void fraction is 1/2
        d = h*(3/math.pi)**(1/3)
        solids = f"""grains {{ type list; diameter {d:.17g}; frozen yes; positions (
{" ".join(map(vector, case.centres()))}); }}"""
    case.grains("grain { density 2500; youngsModulus 1e6; }", "stokesDrag {}" if drag else "", solids, "kernel linear;", "time { step 1e-3; }")
    claim_runs(f"{name}: runs", case, "demInterFoam")
    x = case.centres()[:, 0]
    times = [0, *case.times()]
    return np.array([float(time) for time in times]), np.array(
        [2*np.sum(case.field(f"{time}/alpha.water")*np.cos(k*x))*h*h/L for time in times])


def fitted(t, a, rate):
    """The frequency and decay of a wave released from rest that fit best, near this frequency."""
    from scipy.optimize import curve_fit
    (a0, w, q), _ = curve_fit(
        lambda t, a0, w, q: a0*np.exp(-q*t)*(np.cos(w*t) + q/w*np.sin(w*t)), t, a, (a[0], rate, 0))
    return w, q


k = math.pi/L                                          # half a wave
coth = 1/math.tanh(k*L/2)
thin = 1e-9
theory = math.sqrt((1000 - 1)*g*k/((1000 + 1)*coth))
for name, solid in (("clear", False), ("particles", True)):
    t, a = box(f"sloshing, {name}", k, 24, (1000, thin*1000), (1, thin), 0.003, 0.4, 1e-3, solid)
    w, q = fitted(t, a, theory)
    claim(f"sloshing, {name}: the frequency is {theory:.2f}/s (1 %)", close(w, theory, 0.01), w, theory)
    claim(f"sloshing, {name}: it hardly decays (0.3/s)", abs(q) < 0.3, q)

# Stokes' drag in the water: K = 18 mu s/d^2 with s = 1/2 and one sphere in each cell
K, cells = 1500, 24
mu = K*(L/cells*(3/math.pi)**(1/3))**2/9
decay = K/0.5/2/(1000 + 1)
frequency = math.sqrt(theory**2 - decay**2)
t, a = box("sloshing, drag", k, cells, (1000, mu), (1, thin), 0.003, 0.4, 1e-3, True, True)
w, q = fitted(t, a, frequency)
claim(f"sloshing, drag: the frequency is {frequency:.2f}/s (1 %)", close(w, frequency, 0.01), w, frequency)
claim(f"sloshing, drag: the decay is {decay:.3f}/s (5 %)", close(q, decay, 0.05), q, decay)

# the heavier fluid above, a whole wave
k = 2*math.pi/L
theory = math.sqrt((3 - 1)*g*k/((3 + 1)/math.tanh(k*L/2)))
for name, solid in (("clear", False), ("particles", True)):
    t, a = box(f"growth, {name}", k, 32, (1, thin), (3, thin), 5e-4, 0.1, 5e-4, solid)
    rate = np.polyfit(t[10:], np.arccosh(np.maximum(a[10:]/a[0], 1)), 1)[0]
    claim(f"growth, {name}: the rate is {theory:.2f}/s (12 % below to 2 % above: the mesh)",
          0.88*theory < rate < 1.02*theory, rate, theory)
finish()
