"""demInterFoam with a zone of cells that rotates in a vessel (cyclicAMI, faces that do not match).

- Layers of water and air stay at rest while the zone rotates.
- A block of water falls from one side through the interface, with grains: volumes are kept, alpha stays in [0, 1], and
  without blades the rotation of the zone does not change the flow.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from rings import rings
from two_fluids import *

thin = (1000, 1e-9), (1, 1e-12)                         # hardly viscous fluids


def vessel(name, omega, end, write):
    """A closed vessel with a shaft; its inner ring rotates by omega [rad/s]."""
    case = TwoFluids(name)
    case.controls(end, 5e-4, write=write)
    case.fluids(*thin, tolerance=1e-11, sub_cycles=2)
    rings(case, (10, 20, 20, 40), 40, ((3, 6, 12), (5, 5, 12)), lids=True)
    case.sub("system/fvSolution", "solver PCG; preconditioner DIC;", "solver PBiCGStab; preconditioner DIC;")
    sliding = '"(inside|outside)" { type cyclicAMI; }'
    case.fields(("shaft", "vessel", "lids", "ends"), slip=True, more=(sliding, sliding, sliding))
    if omega:
        case.dictionary("constant/dynamicMeshDict", f"""dynamicFvMesh dynamicMotionSolverFvMesh;
motionSolverLibs ("libfvMotionSolvers.so"); motionSolver solidBody; cellZone rotor;
solidBodyMotionFunction rotatingMotion; origin (0 0 0); axis (0 0 1); omega {omega};""")
    return case


def run(what, case):
    claim_runs(f"{what}: runs", case, "demInterFoam")
    low, high, volume = case.bounds().T
    claim(f"{what}: alpha stays in [0, 1] (1e-12)", low.min() > -1e-12 and high.max() < 1e-12, low.min(), high.max())
    claim(f"{what}: the volume of water is kept (1e-12)", np.ptp(volume) < 1e-12*volume[0], np.ptp(volume)/volume[0])


material = "grain { density 2500; youngsModulus 1e6; }"
bed = "grains { type random; diameter 3e-3; count 100; seed 3; min (0.012 -0.02 0); max (0.03 0.02 0.03); }"

case = vessel("rest", 20, 0.02, 0.02)
case.alpha(lambda x: x[:, 2] < 0.02)
case.grains(material, "gidaspow {}", "grain { type list; diameter 1e-5; frozen yes; positions ((0.03 0 0.03)); }",
            "walls (lids ends);", "time { step 5e-4; }")
run("rest", case)
# the linear solvers' tolerance of 1e-11; g T is 5e-3 m/s a step
claim("rest: the fluids stay at rest (1e-9 m/s)", largest(case.interior("U")) < 1e-9, largest(case.interior("U")))

place = {}
for omega in (0, 20):
    what = "dam, turning" if omega else "dam"
    case = vessel(f"dam{omega}", omega, 0.05, 0.01)
    case.alpha(lambda x: (x[:, 0] < -0.01)*(x[:, 2] < 0.03))
    case.grains(material, "hertz {} dry { restitution 0.5; } gidaspow {}", bed,
                "walls (lids ends); kernel linear; record { interval 0.001; budget yes; }")
    run(what, case)
    log = case.log("demInterFoam")
    claim(f"{what}: exchange closes (1e-12)", worst(log, "exchange error") < 1e-12, worst(log, "exchange error"))
    budget = case.table("postProcessing/dem/0/budget.csv")
    for axis in "xz":
        terms = {name: largest(column) for name, column in budget.items() if name.endswith(".p" + axis)}
        off = terms["rest.p" + axis]/max(terms.values())
        claim(f"{what}: the interface keeps momentum in {axis} (1e-3 of the largest term)", off < 1e-3, off)
    for time in ("0", "0.05"):
        for field in ("writeCellCentres", "writeCellVolumes"):
            case.run("postProcess", "-func", field, "-time", time)
        water = case.field(f"{time}/alpha.water")*case.field(f"{time}/V")
        place[omega, time] = water @ case.field(f"{time}/C")/water.sum()
fall = place[0, "0.05"] - place[0, "0"]
off = difference(place[20, "0.05"], place[0, "0.05"])/np.linalg.norm(fall)
# the interpolation across the interface differs from step to step; fluid dragged along would turn by 57 degrees
claim("dam: the rotation moves the centre of the water by 2 % of its path at most", 0 < off < 0.02, off, fall)

case.controls(0.01, 5e-4)
case.remove("0.0*")
case.run("decomposePar")
claim_runs("dam, two ranks: runs", case, "demInterFoam", ranks=2)
low, high, volume = case.bounds().T
claim("dam, two ranks: alpha in [0, 1] and the volume of water are kept (1e-12)", low.min() > -1e-12 and
      high.max() < 1e-12 and np.ptp(volume) < 1e-12*volume[0], low.min(), high.max(), np.ptp(volume)/volume[0])
finish()
