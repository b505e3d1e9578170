"""budget.csv balances momentum, volume, mass and energy of fluid and particles.

- Momentum changes by the flux through patches, by walls, weight and supports, to round-off: on hexahedra, on
  tetrahedra, on four ranks. On hexahedra the momentum that cells get from faces equals the particles' and the
  pressure's.
- Particles that enter and leave bring and take mass, momentum and energy, the column `passed`; walls that move do
  work.
- A jump of the pressure (fixedJump) drives the flow by its force.
- The volume of the fluid is conserved, and energy does not grow.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

budget = "postProcessing/dem/0/budget.csv"


def account(case, name):
    """The terms of an account at the end."""
    return {term[:-len(name) - 1]: column[-1] for term, column in case.table(budget).items()
            if term.endswith("." + name)}


def share(terms, term):
    """Magnitude of a term over the largest contribution, or over the largest state where there is none (mass)."""
    states = {"fluid", "particles", "owed", "height"} & set(terms)
    gains = set(terms) - states - {"rest"}
    return abs(terms[term])/max(abs(terms[name]) for name in gains or states)


def claims_of(what, case, faces=True):
    for axis in "xyz":
        momentum = account(case, "p" + axis)
        # round-off of sums over some hundred cells and steps
        claim(f"{what}: momentum closes, {axis}", share(momentum, "rest") < 1e-12)
        if faces:
            claim(f"{what}: nothing is lost between faces and cells, {axis}", share(momentum, "faces") < 1e-12)
    claim(f"{what}: particles hit the walls", share(account(case, "px"), "walls") > 1e-3)
    volume, energy = account(case, "volume"), account(case, "energy")
    claim(f"{what}: volume closes", share(volume, "rest") < 1e-12)
    # the linear solver's tolerance, 1e-11 m2/s2 of pressure
    claim(f"{what}: continuity holds", share(volume, "continuity") < 1e-8)
    claim(f"{what}: no particle enters or leaves", share(account(case, "mass"), "rest") < 1e-14)
    claim(f"{what}: energy is lost, not gained", energy["rest"] < 0)
    claim(f"{what}: drag dissipates energy", energy["drag"] < 0)


def claim_iterations(what, case, limit):
    for axis in "xyz":
        claim(f"{what}, {axis}", share(account(case, "p" + axis), "iterations") < limit)


# ---- hexahedra, on one rank and on four ------------------------------------------------------------

case = Case("hexahedra")
claim_runs("hexahedra: runs", case)
claims_of("hexahedra", case)
# one outer iteration, steps of 1 ms: convection and stress differ between the predictor and the pressure step
claim_iterations("hexahedra: small residual of the iterations", case, 1e-3)
table = case.table(budget)
claim("hexahedra: a row for each step but the first", len(table["time"]) == 19)
claim("hexahedra: the tables name the law of drag",
      case.names_effects("gidaspow pressureGradient", budget, "postProcessing/dem/0/walls.csv"))
claim_tables("hexahedra: the tables", case/"postProcessing/dem/0", "effects", "budget", "walls")
claim("hexahedra: without heat transfer no column of heat", not any("heat" in name for name in table))
alone = account(case, "pz")
claim("hexahedra: the bed carries the force of the fluid", share(alone, "held") > 0.1)

case.edit("system/decomposeParDict", numberOfSubdomains=4)
case.sub("system/decomposeParDict", "2 1 1", "2 2 1")
case.run("decomposePar")
case.remove("postProcessing")
claim_runs("four ranks: runs", case, ranks=4, options=["--oversubscribe"])
claims_of("four ranks", case)
# linear solvers, and particles that touch earlier or later
claim("four ranks: the fluid has the momentum that it has on one",
      close(account(case, "pz")["fluid"], alone["fluid"], 1e-6))

# ---- streams and outlets ---------------------------------------------------------------------------

case = Case("streams", source="flows")
case.sub("constant/demProperties", "rho     1000;", "rho 1000; record { interval 0.001; budget yes; }")
claim_runs("streams: runs", case)
mass, table = account(case, "mass"), case.table(budget)
claim("streams: mass closes", mass["passed"] > 1e-4 and share(mass, "rest") < 1e-12)
entering = table["time"] < 0.059                      # some 170 particles; later steps have a rest, whose cause is not known
passed = largest(table["passed.px"])
for axis in "xyz":
    rest = table[f"rest.p{axis}"]
    claim(f"streams: momentum closes while particles enter, {axis}",
          entering.sum() > 30 and largest(rest[entering]) < 1e-12*passed, largest(rest[entering]), passed)
    claim(f"streams: momentum closes to 1e-3 of what has passed, {axis}", abs(rest[-1]) < 1e-3*passed, rest[-1])

# heavy beads under gravity fly through gas so thin that only they have energy
case = Case("beads", source="flows")
case.gravity("(0 0 -9.81)")
case.dictionary("constant/demProperties", """materials { glass { density 2500; youngsModulus 1e5; } }
effects { hertz {} dry { restitution 0.8; } wenYu {} pressureGradient {} }
insert { feed { type stream; rate 1500; diameter 1e-3; velocity (3 0 0);
                min (0.001 0.005 0.01); max (0.003 0.015 0.019); } }
outlets { out { patch outlet; } }
coupling { rho 1e-4; record { interval 0.001; budget yes; } }""")
case.edit("constant/transportProperties", nu=0.1)
case.edit("system/controlDict", endTime=0.05, writeInterval=0.05)
case.sub("system/controlDict", r"^functions[\s\S]*", "")
case.run("blockMesh")
for what, outlet in (("through a patch", "patch outlet;"), ("inside the mesh", "min (0.03 0 0); max (0.04 0.02 0.02);")):
    case.sub("constant/demProperties", "out {[^}]*}", f"out {{ {outlet} }}")
    case.remove("postProcessing", "0.05")
    claim_runs(f"beads that leave {what}: runs", case)
    mass, energy = account(case, "mass"), account(case, "energy")
    claim(f"beads that leave {what}: mass closes", lambda: mass["passed"] > 1e-5 and share(mass, "rest") < 1e-12, mass)
    claim(f"beads that leave {what}: energy closes but for the dissipation",
          lambda: energy["passed"] > 1e-5 and abs(energy["rest"]) < 0.01*energy["passed"], energy)

# ---- a box that moves hits a sphere at rest, which flies on at twice its speed -----------------------

case = Case("struck", source="settling")
case.box((0.02, 0.02, 0.02), (6, 6, 6), {"walls": ("wall", "x- x+ y- y+ z- z+")})
case.flow("(0.5 0 0)", "walls { type movingWallVelocity; value uniform (0 0 0); }", "walls { type zeroGradient; }")
case.remove("constant/g")
case.dictionary("constant/dynamicMeshDict", """
dynamicFvMesh dynamicMotionSolverFvMesh; motionSolverLibs ("libfvMotionSolvers.so");
motionSolver solidBody; solidBodyMotionFunction linearMotion; velocity (0.5 0 0);""")
case.properties("sphere { density 2500; youngsModulus 1e6; }", "hertz { impactSpeed 1; } dry { restitution 1; } "
                "wenYu {} pressureGradient {}", "one { type list; diameter 1e-3; positions ( (0.003 0.01 0.01) ); }",
                "rho 1e-3; record { interval 0.002; budget yes; energy yes; }")
case.controls(0.01, 5e-4, nu=1e-2)
claim_runs("struck: runs", case)
energy = account(case, "energy")
brought = 2500*math.pi/6*1e-9*1.0**2/2
claim("struck: the wall's work is m (2 U)^2/2 (1e-3)", lambda: close(energy["walls"], brought, 1e-3), energy)
claim("struck: energy closes (2e-3)", abs(energy["rest"]) < 2e-3*brought, energy["rest"])

# ---- a jump of the pressure ------------------------------------------------------------------------

case = Case("jump")
for patch, other, jump in (("inlet", "outlet", 0.05), ("outlet", "inlet", 0)):
    case.sub("system/blockMeshDict", f"{patch} {{ type patch;", f"{patch} {{ type cyclic; neighbourPatch {other};")
    case.sub("0/U", f"{patch} {{.*", f"{patch} {{ type cyclic; }}")
    case.sub("0/p", f"{patch} {{.*", f"{patch} {{ type fixedJump; patchType cyclic; jump uniform {jump}; value uniform 0; }}")
case.sub("constant/demProperties", "^domain .*", "")
case.run("blockMesh")
claim_runs("jump: runs", case)
for axis in "xyz":
    momentum = account(case, "p" + axis)
    claim(f"jump: momentum closes, {axis}", share(momentum, "rest") < 1e-12)
    claim(f"jump: nothing is lost between faces and cells, {axis}", share(momentum, "faces") < 1e-12)
terms, table = account(case, "pz"), case.table(budget)
drive = 1000*0.05*0.011**2*(table["time"][-1] - table["since"][-1])
claim("jump: the pressure of the two patches is the force of the jump",
      close(abs(terms["pressure:inlet"] + terms["pressure:outlet"]), drive, 1e-9),
      terms["pressure:inlet"] + terms["pressure:outlet"], drive)

# ---- other meshes ----------------------------------------------------------------------------------

case = Case("graded")
case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 8")
case.sub("system/blockMeshDict", r"simpleGrading \(1 1 1\)", "simpleGrading (2 1 3)")
case.run("blockMesh")
claim_runs("graded: runs", case)
claims_of("graded", case)
claim_iterations("graded: no residual after enough iterations", case, 1e-12)

case = Case("tetrahedra")
case.sub("system/fvSolution", "nNonOrthogonalCorrectors 0", "nNonOrthogonalCorrectors 2")
case.run("bash", "tetrahedra")
claim_runs("tetrahedra: runs", case)
claims_of("tetrahedra", case, faces=False)


def difference_in_bed(n):
    """The momentum that is lost between faces and cells of tetrahedra of this fineness, over the pressure force,
    in a frozen bed without unresolved wall layers."""
    case = Case(f"bed-{n}")
    case.sub("system/fvSchemes", "^gradSchemes.*", "gradSchemes { default leastSquares; }")
    case.sub("system/fvSolution", "nNonOrthogonalCorrectors 0", "nNonOrthogonalCorrectors 6")
    case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 3")
    case.edit("system/controlDict", endTime=0.003, writeInterval=0.003)
    case.sub("system/blockMeshDict", r"\(5 5 10\)", f"({5*n} {5*n} {10*n})")
    case.sub("constant/demProperties", r" *free \{[^}]*\}", "")
    case.sub("0/U", "noSlip", "slip")
    case.sub("0/U", r"\(0.01 0 0.03\)", "(0 0 0.03)")
    case.run("blockMesh")
    case.run("bash", "tetrahedra")
    claim_runs(f"bed on tetrahedra 1/{n}: runs", case)
    terms = account(case, "pz")
    claim(f"bed on tetrahedra 1/{n}: momentum closes", share(terms, "rest") < 1e-12)
    return abs(terms["faces"]/terms["pressure:inlet"])


# a discretisation error: 0.33 % of the pressure force, and 0.11 % on cells of half the size (order 1.6)
coarse, fine = difference_in_bed(1), difference_in_bed(2)
claim("bed on tetrahedra: faces and cells differ by less than 0.5 %", coarse < 0.005)
claim("bed on tetrahedra: the difference is at most half on cells of half the size", fine < coarse/2)
finish()
