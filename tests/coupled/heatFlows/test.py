"""Heat in the budget of a duct: grains and hot gas enter and leave; walls, friction and a heater heat them.

- The heat of gas and grains, with the owed heat, changes by the contributions of budget.csv, to round-off. Each
  contribution is far larger than round-off, so none could be left out.
- Entering grains bring m c T; leaving grains take the heat in the energy balance of the particles.
- The same holds with parcels of 8 grains.
- Without that balance only the heat from walls and friction remains unexplained.
- On a moving mesh with several outer iterations the heat balance closes, too.
- A restarted run has the bits of the uninterrupted one, also of the budget's states; two ranks agree with one.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from heat.balance import heat

dem, scene = "postProcessing/dem/0", "constant/demProperties"
states = ("fluid", "particles", "owed")


def account(case, table=f"{dem}/budget.csv", row=-1):
    """The states of the heat and the contributions to it in this row of a budget.csv [J]."""
    return {name[:-len(".heat")]: column[row] for name, column in case.table(table).items() if name.endswith(".heat")}


def gains(terms):
    """The contributions alone."""
    return {name: value for name, value in terms.items() if name not in (*states, "rest")}


def share(terms, name):
    """The magnitude of a term over the largest contribution."""
    return abs(terms[name])/largest(list(gains(terms).values()))


def closes(name, case):
    """The claims of a run's whole budget; returns its terms."""
    terms, received = account(case), heat(case)[-1]
    claim(f"{name}: exchange closes", worst(case.log(), "heat exchange error") < 1e-13)
    claim(f"{name}: heat closes", share(terms, "rest") < 1e-14)
    for term in ("passed", "flow:inlet", "conduction:inlet", "flow:outlet", "conduction:walls", "sources", "walls",
                 "friction"):
        claim(f"{name}: {term} counts", share(terms, term) > 1e-8)
    # the solver's tolerance for the pressure
    claim(f"{name}: the continuity error brings no heat", share(terms, "continuity") < 1e-10)
    # the log counts from the end of the first step, as the budget does
    claim(f"{name}: the contributions agree with the log, to the round-off of the largest", received.size > 9 and
          abs(sum(gains(terms).values()) - (received[-1] - received[0])) < 1e-14*abs(terms["flow:inlet"]))
    return terms


def brought(case):
    """m c T of what has entered until 0.2 s [J]"""
    flows = case.table(f"{dem}/flows.csv")
    T = np.array([{"feed": 300, "fast": 320}.get(name, 700) for name in flows["name"]])
    entered = (flows["time"] == 0.2) & (np.array(flows["way"]) == "in")
    return (20*T*flows["mass"])[entered].sum()


def gas(case, T):
    """Hot gas with these temperatures of patches."""
    case.edit("constant/transportProperties", nu=1.5e-5, Cp=1000, kappa=0.025)
    case.sub("system/fvSchemes", r"div\(alphaPhi,U\)", "div(alphaPhi,T) Gauss upwind; div(alphaPhi,U)")
    case.initial("T", "0 0 0 1 0 0 0", 500, T)


case = Case()
case.controls(0.2, 0.001, 0.1, precision=17)
case.sub("system/fvSolution", '("p.*)1e-11; relTol 0;', r"\g<1>1e-12; relTol 0; maxIter 200;")
case.sub("system/fvSolution", r'"U\.\*"(.*)1e-11; relTol 0;', r'"(U|T).*"\g<1>1e-16; relTol 0; maxIter 50;')
case.box((0.04, 0.02, 0.02), (10, 5, 5),
         {"inlet": ("patch", "x-"), "outlet": ("patch", "x+"), "walls": ("wall", "y- y+ z- z+")})
case.flow("(0.4 0 0)", """inlet { type fixedValue; value uniform (0.4 0 0); } walls { type noSlip; }
    outlet { type inletOutlet; inletValue uniform (0 0 0); value uniform (0.4 0 0); }""",
          '"(inlet|walls)" { type fixedFluxPressure; } outlet { type fixedValue; value uniform 0; }')
case.gravity()
outflow = "type inletOutlet; inletValue uniform 500; value uniform 500;"
gas(case, f"""inlet {{ type fixedValue; value uniform 500; }} outlet {{ {outflow} }}
    walls {{ type fixedValue; value uniform 400; }}""")
claim_runs("duct: runs", case)
duct = closes("duct", case)
budget, energy = (case.table(f"{dem}/{name}.csv") for name in ("budget", "energy"))
came, left = energy["heat_came"][-1], energy["heat_left"][-1]
claim("duct: flow:inlet is rho Cp U A T of the time since the first step (1e-12)",
      close(duct["flow:inlet"], 1.25*1000*0.4*4e-4*500*(budget["time"][-1] - budget["since"][-1]), 1e-12))
# the gradient of T vanishes there, and grains pass: with the flux of both phases this would be the grains' part
claim("duct: nothing is conducted through the outlet", abs(duct["conduction:outlet"]/duct["flow:outlet"]) < 1e-14)
claim("duct: nothing flows through the walls", share(duct, "flow:walls") < 1e-14)
claim_tables("duct: the tables", case/dem, "effects", "budget", "energy", "flows")
# nine digits of the tables
claim("duct: grains bring the heat of their mass and temperature", close(came, brought(case), 1e-8))
claim("duct: a third of it leaves with others", left/came > 0.3)
# leaving grains also take the heat owed to them, which that balance does not know yet
claim("duct: passed is the heat that they bring less the heat that they take (0.01 %)",
      close(duct["passed"], came - left, 1e-4))
for state, logged in zip(states, heat(case)[:, -1]):
    claim(f"duct: {state} agrees with the log", close(duct[state], logged, 1e-15))
(case/"straight").mkdir()
for name in ("0.1", "0.2", "postProcessing"):
    (case/name).rename(case/"straight"/name)

# ---- restart ---------------------------------------------------------------------------------------

case.copy(case/"straight/0.1", "0.1")
case.edit("system/controlDict", startFrom="latestTime")
claim_runs("restart: runs", case)
for name in ("T", "lagrangian/particles/temperature", "lagrangian/particles/id"):
    claim(f"restart: the same bits, {name}", agrees(case/"0.2"/name, case/"straight/0.2"/name))
claim("restart: the snapshot, to the last bit",
      snapshot_hash(case/"0.2/uniform/dem.snapshot") == snapshot_hash(case/"straight/0.2/uniform/dem.snapshot"))
terms = account(case, "postProcessing/dem/0.1/budget.csv")
for state in states:
    claim(f"restart: the state of the budget, {state}, to the last digit", terms[state] == duct[state])
claim("restart: heat closes", share(terms, "rest") < 1e-14)

# ---- without the energy balance --------------------------------------------------------------------

case.remove("0.1", "0.2", "postProcessing")
case.edit("system/controlDict", startFrom="startTime")
case.sub(scene, "energy yes; ", "")
claim_runs("without the energy balance: runs", case)
claim("without the energy balance: the same bits", agrees(case/"0.2/T", case/"straight/0.2/T"))
terms = account(case)
claim("without the energy balance: no columns of walls and friction", not {"walls", "friction"} & set(terms))
claim("without the energy balance: only their heat is not counted",
      close(terms["rest"], duct["walls"] + duct["friction"], 1e-10))

# ---- parcels ---------------------------------------------------------------------------------------

# of 8 grains of half the diameter: as large as the grains before
case.remove("0.1", "0.2", "postProcessing")
case.sub(scene, "budget yes", "energy yes; budget yes")
grains = case.read(scene)
case.sub(scene, "^effects", "parcels { ratio 2; }\neffects")
case.sub(scene, "diameter 1e-3", "diameter 5e-4")
case.sub(scene, "diameter 0.8e-3", "diameter 4e-4")
claim_runs("parcels: runs", case)
closes("parcels", case)
claim("parcels: they bring the heat of their mass and temperature",
      close(case.table(f"{dem}/energy.csv")["heat_came"][-1], brought(case), 1e-8))

# ---- two ranks -------------------------------------------------------------------------------------

# until 0.08 s; later, grains have touched earlier or later, by the rounding of the gas, and their paths differ
case.remove("0.1", "0.2", "postProcessing")
case.write(scene, grains)
case.edit("system/controlDict", endTime=0.08)
case.run("decomposePar")
claim_runs("two ranks: runs", case, ranks=2)
two, one = closes("two ranks", case), account(case, f"straight/{dem}/budget.csv", 78)
for term in ("fluid", "particles", "passed", "walls", "conduction:walls"):
    claim(f"two ranks: {term} as on one", close(two[term], one[term], 1e-9))

# ---- a mesh that moves -----------------------------------------------------------------------------

# the floor of tests/coupled/moving rises under its grains; three outer iterations, and the last one counts
case = Case("moving", "moving")
gas(case, f"floor {{ type fixedValue; value uniform 400; }} top {{ {outflow} }} sides {{ type zeroGradient; }}")
for name, old, new in (
        (scene, "youngsModulus 1e6;", "youngsModulus 1e6; heatCapacity 20;"),
        (scene, "gidaspow {}", "gidaspow {} gunn {}"),
        (scene, "rho 1;", "rho 1.25;"), (scene, "interval 0.005;", "interval 0.001; budget yes;"),
        ("system/fvSolution", r'"U\.\*"', '"(U|T).*"'),
        ("system/fvSolution", "1e-12; relTol 0; }$", "1e-16; relTol 0; maxIter 100; }"),
        ("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 3")):
    case.sub(name, old, new)
claim_runs("moving mesh: runs", case)
claim("moving mesh: exchange closes", worst(case.log(), "heat exchange error") < 1e-13)
# the heat of the gas is ten times the largest gain, and its round-off is the rest
terms = account(case)
claim("moving mesh: heat closes, to 1e-14 of the gas's", abs(terms["rest"]/terms["fluid"]) < 1e-14)
for term in ("flow:top", "conduction:floor"):
    claim(f"moving mesh: {term} counts", share(terms, term) > 1e-4)
finish()
