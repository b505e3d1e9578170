"""Water with particles enters a channel, flows over a weir and leaves, with the turbulence model kEpsilon.

- The head upstream of the broad crest is 1.5 (q^2/g)^(1/3), because the flow on the crest is critical; q: discharge
  per width; the water starts 10 mm above the crest.
- Particles that entered are in the channel or have left over the weir; none is lost.
- alpha stays in [0, 1] and the exchange closes.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

h, speed, foot, crest, end = 5e-3, 0.1, 0.05, (0.14, 0.2), 1.2
xs, zs = (0, *crest, 0.3), (0, foot, 0.12)


def corner(i, k, y):
    return i + 4*k + 12*y


def face(*corners):
    return "(" + " ".join(str(corner(*c)) for c in corners) + ")"


def across(i, k):
    """The face of block row k at the column of corners i."""
    return face((i, k, 0), (i, k, 1), (i, k + 1, 1), (i, k + 1, 0))


def level(i, k):
    """The face of block column i at the row of corners k."""
    return face((i, k, 0), (i + 1, k, 0), (i + 1, k, 1), (i, k, 1))


case = TwoFluids()
case.controls(end, 1e-3, write=0.1)
case.fluids(tolerance=1e-8, correctors=2, sub_cycles=2)
blocks = [(i, k) for k in (0, 1) for i in (0, 1, 2) if (i, k) != (1, 0)]
case.mesh([(x, y, z) for y in (0, h) for z in zs for x in xs],
          ["(" + " ".join(str(corner(*c)) for c in (
              (i, k, 0), (i + 1, k, 0), (i + 1, k, 1), (i, k, 1), (i, k + 1, 0), (i + 1, k + 1, 0), (i + 1, k + 1, 1),
              (i, k + 1, 1))) + f") {vector([round(x/h) for x in (xs[i + 1] - xs[i], h, zs[k + 1] - zs[k])])}"
           for i, k in blocks],
          {"inlet": f"type patch; faces ({across(0, 0)});",
           "outlet": f"type patch; faces ({across(3, 0)} {across(3, 1)});",
           "top": f"type patch; faces ({' '.join(level(i, 2) for i in range(3))});",
           "ground": "type wall; faces (" + " ".join((level(0, 0), across(1, 0), level(1, 1), across(2, 0), level(2, 0),
                                                     across(0, 1))) + ");",
           "sides": "type wall; faces (" + " ".join(
               face((i, k, y), (i + 1, k, y), (i + 1, k + 1, y), (i, k + 1, y)) for i, k in blocks for y in (0, 1)) + ");"})
flux = "type fixedFluxPressure; value uniform 0;"
case.fields(("ground", "sides"), slip=True,
            more=(f"inlet {{ type fixedValue; value uniform ({speed} 0 0); }} "
                  "outlet { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } "
                  "top { type pressureInletOutletVelocity; value uniform (0 0 0); }",
                  f"inlet {{ {flux} }} outlet {{ type zeroGradient; }} "
                  "top { type totalPressure; p0 uniform 0; value uniform 0; }",
                  "inlet { type fixedValue; value uniform 1; } "
                  '"(outlet|top)" { type inletOutlet; inletValue uniform 0; value uniform 0; }'))
case.alpha(lambda x: (x[:, 0] < crest[0]) & (x[:, 2] < foot + 0.01))
case.turbulence("kEpsilon", 1e-5, 1e-4, lambda name, value: '".*" { type inletOutlet; '
                f'inletValue uniform {value}; value uniform {value}; }} "(ground|sides)" {{ type zeroGradient; }}',
                '".*" { type calculated; value uniform 0; }')
case.sub("system/fvSchemes", r"div\(phi,alpha\)", "div(phi,k) Gauss upwind; div(phi,epsilon) Gauss upwind; div(phi,alpha)")
case.grains("grain { density 990; youngsModulus 1e5; }", "hertz {} dry { restitution 0.5; } gidaspow {}",
            f"feed {{ type stream; patch inlet; rate 100; diameter 1.5e-3; velocity ({speed} 0 0); }}"
            f" near {{ type random; count 60; diameter 1.5e-3; min (0.06 0 {foot}); max ({crest[0]} {h} {foot + 0.008}); }}",
            "walls (top);", "outlets { out { patch outlet; } }")
claim_runs("runs", case, "demInterFoam")
low, high, volume = case.bounds().T
claim("alpha stays in [0, 1] (1e-12)", low.min() > -1e-12 and high.max() < 1e-12, low.min(), high.max())
q, g = speed*foot, 9.81
theory = 1.5*(q**2/g)**(1/3)
x = case.centres()
pool = x[:, 0] < 0.07
heads = [np.sum(case.field(f"{time}/alpha.water")[pool])*h**2/0.07 - foot
         for time in case.times() if float(time) > end/2]
claim(f"the head above the crest is {theory*1e3:.1f} mm (half a cell, {h*500:g} mm)",
      abs(np.mean(heads) - theory) < h/2, *heads)
entered, left = case.numbers("since the start ([0-9]*) particles entered, ([0-9]*) left", "demInterFoam")[-1]
inside = len(case.particles(case.times()[-1], "positions"))
claim("particles enter, and leave over the weir", entered > 100 and left > 10, entered, left)
claim("what entered or was there has left or is inside", inside == 60 + entered - left, inside, entered, left)
claim("no particle is lost", not (case/"postProcessing/dem/0/lost.csv").exists())
claim("exchange closes", worst(case.log("demInterFoam"), "exchange error") < 1e-12)
finish()
