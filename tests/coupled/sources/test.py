"""Sources of fvOptions on U act on the faces, where the pressure gradient balances them.

- A frit (Darcy-Forchheimer) has its closed form's pressure drop on any cells: at a patch of given
  flux, in the middle of a duct and at its end, on graded cells, too. Velocity is uniform through its
  ends.
- A uniform force leaves the fluid of a closed box at rest, with a linear pressure.
- A uniform force and resistance in a periodic box accelerate the fluid as the Euler scheme does; the
  budget has the impulse, two ranks have the numbers of one, a restart has the bits, and a resistance
  that ends leaves nothing behind.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

rho, nu, U = 1.2, 1.5e-5, 0.3                         # kg/m3, m2/s, m/s
darcy, forchheimer = 2e8, 1e4                         # 1/m2, 1/m
gradient = rho*(nu*darcy*U + 0.5*forchheimer*U**2)    # Pa/m

# a grain so small that it acts on nothing
scene = """
materials { glass { density 2500; youngsModulus 1e-6; } }
effects { hertz {} stokesDrag {} pressureGradient {} }
insert { one { type list; diameter 4e-9; frozen yes; positions ((0.005 0.005 0.039)); } }
coupling { rho 1.2; kernel linear; record { interval 0.01; budget yes; } }
"""


def duct(name, cells, grading, options):
    """A duct of 11 x 11 x 39.6 mm without a bed, with these fvOptions."""
    case = Case(name, "fixedBed")
    case.dictionary("constant/demProperties", scene)
    case.dictionary("constant/fvOptions", options)
    case.edit("constant/transportProperties", nu=nu)
    case.duct((0.011, 0.011, 0.0396), (3, 3, cells), 0.3, 0.3, f"1 1 {grading}")
    return case


def porous(zone, d, f):
    """An fvOption: resistance by Darcy [1/m2] and Forchheimer [1/m] in a zone of cells."""
    return f"""
resistance
{{
    type explicitPorositySource;
    explicitPorositySourceCoeffs
    {{
        selectionMode cellZone; cellZone {zone}; type DarcyForchheimer; d ({d} {d} {d}); f ({f} {f} {f});
        coordinateSystem {{ type cartesian; origin (0 0 0); e1 (1 0 0); e2 (0 1 0); }}
    }}
}}
"""


def make_zone(case, name, low, high):
    """A zone of the cells whose centres are between these heights [m]."""
    case.dictionary("system/topoSetDict", f"""
actions
(
    {{ name cells; type cellSet; action new; source boxToCell; box (-1 -1 {low}) (1 1 {high}); }}
    {{ name {name}; type cellZoneSet; action new; source setToCellZone; set cells; }}
);
""")
    case.run("topoSet")


def layers(cells, grading):
    """Edges of the layers of cells along the duct [m]."""
    sizes = grading**(np.arange(cells)/(cells - 1))
    return np.concatenate(([0], 0.0396*np.cumsum(sizes)/sizes.sum()))


# ---- a frit ----------------------------------------------------------------------------------------

for where, cells, grading in ((0, 9, 1), (0, 18, 1), (0, 36, 1), (0, 18, 3), (0.0132, 18, 1), (0.0264, 18, 1),
                              (0.0264, 18, 3)):
    low, high = where, where + 0.0132
    edges = layers(cells, grading)
    # the zone has the cells whose centres are inside
    length = sum(b - a for a, b in zip(edges, edges[1:]) if low < (a + b)/2 < high)
    case = duct("frit", cells, grading, porous("frit", darcy, forchheimer))
    make_zone(case, "frit", low, high)
    case.run("demPimpleFoam")
    what = f"frit from {1000*low:g} mm on, {cells} cells, grading {grading}"
    claim_ran(f"{what}: runs", case)
    drop = rho*case.boundary("0.02/p", "inlet").mean()
    claim(f"{what}: the drop is the closed form's, {gradient*length:.4g} Pa (1e-6)",
          close(drop, gradient*length, 1e-6), drop)
    off = largest(case.field("0.02/U") - [0, 0, U])/U
    claim(f"{what}: the velocity is uniform (1e-6)", off < 1e-6, off)

# ---- a closed box ----------------------------------------------------------------------------------

case = duct("box", 18, 3, """
force
{
    type vectorSemiImplicitSource; selectionMode all; volumeMode specific;
    injectionRateSuSp { U ((1 2 3) 0); }
}
""")
case.sub("0/U", r"\b(inlet|outlet) \{.*", r"\1 { type noSlip; }")
case.sub("0/U", r"uniform \(0 0 0.3\)", "uniform (0 0 0)")
case.sub("0/p", r"\boutlet \{.*", "outlet { type fixedFluxPressure; }")
claim_runs("closed box: runs", case)
claim("closed box: the fluid is at rest (m/s)", largest(case.field("0.02/U")) < 1e-12)
case.run("postProcess", "-func", "writeCellCentres", "-time", "0.02", log="log.centres")
p, x = case.field("0.02/p"), case.field("0.02/C")
claim("closed box: the pressure is linear (1e-10)", difference(p - p[0], (x - x[0]) @ [1, 2, 3]) < 1e-10)

# ---- a periodic box --------------------------------------------------------------------------------

case = duct("periodic", 18, 1, """
force
{
    type vectorSemiImplicitSource; selectionMode all; volumeMode specific;
    injectionRateSuSp { U ((0 0 20) 0); }
}
""" + porous("all", 50/nu, 0))
for patch, other in (("inlet", "outlet"), ("outlet", "inlet")):
    case.sub("system/blockMeshDict", rf"{patch} \{{ type patch;", f"{patch} {{ type cyclic; neighbourPatch {other};")
for name in ("U", "p"):
    case.sub("0/" + name, r"\b(inlet|outlet) \{.*", r"\1 { type cyclic; }")
case.sub("0/U", r"uniform \(0 0 0.3\)", "uniform (0 0 0)")
case.edit("system/controlDict", writeInterval=0.01, writePrecision=17)
case.sub("system/fvSolution", "nCorrectors 2", "nCorrectors 10")
case.run("blockMesh")
make_zone(case, "all", -1, 1)
claim_runs("periodic box: runs", case)
# steps of 1 ms; of D U OpenFOAM's law takes trace(D) U implicitly, the rest explicitly
speeds = [0]
for step in range(20):
    speeds.append((1000*speeds[-1] + 20 + 2*50*speeds[-1])/(1000 + 3*50))
first, speed = speeds[1], speeds[-1]
claim("periodic box: the velocity of Euler's scheme (1e-5; the grain takes 4e-6 in its cell)",
      largest(case.field("0.02/U") - [0, 0, speed]) < 1e-5*speed)
budget = case.table("postProcessing/dem/0/budget.csv")
impulse = rho*0.011**2*0.0396*(speed - first)         # since the end of the first step
claim("periodic box: the budget has the sources' impulse (1e-9)", close(budget["sources.pz"][-1], impulse, 1e-9),
      budget["sources.pz"], impulse)
claim("periodic box: and nothing is left over (1e-12 of it)", largest(budget["rest.pz"]) < 1e-12*impulse)
shutil.move(case/"0.02", case/"straight")
case.edit("system/controlDict", startFrom="latestTime")
case.run("demPimpleFoam")
claim("periodic box: a restart has the same bits", agrees(case/"straight/U", case/"0.02/U"))
case.remove("0.01", "0.02")
case.edit("system/controlDict", startFrom="startTime")
case.run("decomposePar")
case.run("demPimpleFoam", ranks=2, log="log.ranks")
case.run("reconstructPar", "-time", "0.02")
claim("periodic box: two ranks have the velocity of one (1e-9)",
      difference(case.field("0.02/U"), read_field(case/"straight/U")) < 1e-9)

# after ten steps the force acts alone
case.sub("constant/fvOptions", "selectionMode cellZone;", "timeStart 0; duration 0.0105; selectionMode cellZone;")
case.run("demPimpleFoam")
speed = speeds[10] + 10*20e-3
claim("a resistance that ends leaves nothing behind (1e-5; the grain takes 4e-6 in its cell)",
      largest(case.field("0.02/U") - [0, 0, speed]) < 1e-5*speed, case.field("0.02/U")[0], speed)
finish()
