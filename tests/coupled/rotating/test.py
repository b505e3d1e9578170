"""Rotors: a sliding interface (cyclicAMI) between a rotating and a resting zone of cells, and MRF zones.

- Particles cross the interface with the velocities and paths of closed forms, on one rank and on two.
- Walls rotate with their zone or in an MRF zone.
- Du/Dt of fluid in an MRF zone has closed forms.
- Unsupported settings are refused before the run.

The mesh is two rings about z: a rotor of 10 to 20 mm, 24 cells around, in a stator of 20 to 40 mm with 20, so that the
faces of the interface do not match.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from rings import rings

OBJECT = 'particles { type demCloud; libs ("libdemCoupling.so"); }'
GLASS = "glass { density 2500; youngsModulus 1e6; }"


class Rings(Case):
    """A case on the two rings; `interface` is the type of the patches inside and outside between them."""

    def __init__(self, name, interface="cyclicAMI"):
        super().__init__(name)
        self.controls(1, 1)
        self.interface = interface
        rings(self, (10, 20, 20, 40), 6, ((4, 6, 2), (6, 5, 2)), interface, lids=True)

    def fields(self, shaft, interface=None):
        """U and p at rest, U with this entry at the shaft."""
        between = f'"(inside|outside)" {{ type {interface or self.interface}; value'
        self.flow("(0 0 0)", f'shaft {{ {shaft} }} vessel {{ type noSlip; }} "(lids|ends)" {{ type slip; }} '
                  f"{between} uniform (0 0 0); }}",
                  f'"(shaft|vessel|lids|ends)" {{ type zeroGradient; }} {between} uniform 0; }}')

    def turning(self, omega):
        """The rotor's cells rotate about z."""
        self.fields("type movingWallVelocity; value uniform (0 0 0);")
        self.dictionary("constant/dynamicMeshDict", f"""dynamicFvMesh dynamicMotionSolverFvMesh;
motionSolverLibs ("libfvMotionSolvers.so");
motionSolver solidBody;
cellZone rotor;
solidBodyMotionFunction rotatingMotion;
origin (0 0 0); axis (0 0 1); omega {omega};""")

    def frame(self, omega, axis="(0 0 1)", patches=""):
        """The rotor is an MRF zone."""
        self.dictionary("constant/MRFProperties", f"""rotor
{{ cellZone rotor; active yes; nonRotatingPatches ({patches}); origin (0 0 0); axis {axis}; omega {omega}; }}""")

    def column(self, time, name):
        """A field of the particles, sorted by id."""
        return self.particles(time, name)[:, 1:]


def lattice(count, diameter, spacing, velocity, low, high, jitter=0.2):
    return (f"shots {{ type lattice; count {count}; diameter {diameter}; spacing {spacing}; jitter {jitter}; "
            f"velocity {velocity}; min {low}; max {high}; }}")


# ---- particles cross a rotating interface ----------------------------------------------------------

# without forces: 96 particles move through rotor and stator at 1 m/s by 28 mm, while the rotor rotates by 16 degrees
case = Rings("across")
case.turning(10)
case.properties(GLASS, "hertz {} dry { restitution 0.5; }",
                lattice(96, 0.8e-3, 1.5, "(1 0.1 0)", "(-0.013 0.0125 0.0005)", "(0.003 0.0185 0.0055)"),
                "rho 1; twoWay no;")
for solver, functions in (("demPimpleFoam", ""), ("pimpleFoam", OBJECT)):
    case.remove("0.0*")
    case.controls(0.028, 0.0004, 0.0004, functions)
    claim_runs(f"across, {solver}: runs", case, solver)
    first, last = case.column("0.0004", "positions"), case.column("0.028", "positions")
    claim(f"across, {solver}: all particles are there", len(last) == 96)
    claim(f"across, {solver}: they fly straight on",
          np.linalg.norm(last - first - 0.0276*np.array([1, 0.1, 0]), axis=1).max() < 1e-12)
    claim(f"across, {solver}: the cells hold their volume", worst(case.log(solver), "volume error") < 1e-12)

# ---- walls of a rotating zone ----------------------------------------------------------------------

# Grains hit the lid of the rotor, z = 0, at 0.1 m/s without damping, while it rotates at 20 rad/s: the impact slides
# throughout, so they gain mu times twice 0.1 m/s = 0.02 m/s along the lid's velocity, with any contact law.


def carried(case):
    """Velocities differ from 0.02 m/s across the radius and 0.1 m/s up by less than 2 % of 0.02 m/s."""
    place, U = case.column("0.0005", "positions"), case.column("0.02", "U")
    r = np.hypot(place[:, 0], place[:, 1])
    expected = np.column_stack((-0.02*place[:, 1]/r, 0.02*place[:, 0]/r, 0.1 + 0*r))
    return np.linalg.norm(U - expected, axis=1).max() < 0.02*0.02


for how in ("mesh", "frame"):
    case = Rings(f"walls.{how}")
    case.controls(0.02, 0.0005, 0.0005, OBJECT)
    case.properties(GLASS, "hertz {} dry { restitution 1; } mindlin { friction 0.1; }",
                    lattice(21, 0.8e-3, 2, "(0 0 -0.1)", "(-0.006 0.0125 0.0003)", "(0.006 0.0175 0.0015)", jitter=0),
                    "rho 1; twoWay no; walls (lids);")
    if how == "mesh":
        case.turning(20)
    else:
        case.fields("type noSlip;")
        case.frame(20, axis="(0 0 2)")
    claim_runs(f"walls, {how}: runs", case, "pimpleFoam")
    claim(f"walls, {how}: an impact that slides gives the velocity of friction", carried(case))
claim("walls, frame: the log says which walls rotate",
      case.found(r"surface of wall lids rotates by \(0 0 20\) rad/s", "pimpleFoam"))
case.append("constant/demProperties", "walls { lids { absorb no; } }\n")
claim_runs("walls, frame, with another entry of the wall: runs", case, "pimpleFoam")
claim("walls, frame, with another entry of the wall: it rotates as well", carried(case))

# ---- drag ------------------------------------------------------------------------------------------

# The shaft rotates in a viscous liquid, which drags the particles.
DROPS = (GLASS, "hertz {} dry { restitution 0.5; } schillerNaumann {} pressureGradient {}",
         "drops { type lattice; count 60; diameter 0.5e-3; spacing 2.5; jitter 0.2; "
         "min (-0.018 -0.018 0.0005); max (0.018 0.018 0.0055); }", "rho 1000; diameter 0.5e-3;")

case = Rings("drag")
case.turning(20)
case.properties(*DROPS)
case.controls(0.05, 0.001, nu=1e-4)
claim_runs("drag: runs", case)
claim("drag: exchange closes", worst(case.log(), "exchange error") < 1e-12)
claim("drag: the cells hold their volume", worst(case.log(), "volume error") < 1e-12)
U = case.column("0.05", "U")
claim("drag: all particles are there", len(U) == 60)
case.run("decomposePar")
claim_runs("drag: runs on two ranks", case, ranks=2)
claim("drag: exchange closes on two ranks", worst(case.log(), "exchange error") < 1e-12)
claim("drag: the cells hold their volume on two ranks", worst(case.log(), "volume error") < 1e-12)
both = np.concatenate([case.particles(f"processor{k}/0.05", "U") for k in range(2)])
both = both[both[:, 0].argsort(), 1:]
# the fluid alone differs by 1e-3 between one rank and two, in stock pimpleFoam as well: its equations over cyclicAMI
# are not symmetric
claim("drag: on two ranks particles have the velocities of one",
      lambda: np.linalg.norm(both - U) < 0.01*np.linalg.norm(U))

# ---- closed forms in a velocity field that is held -------------------------------------------------


def hold(case, velocity):
    """U of every cell is this function of x and y [m], and pimpleFoam solves nothing; returns the cells' centres."""
    case.fields("type zeroGradient;")
    case.sub("0/U", r"\{ type (noSlip|slip); \}", "{ type zeroGradient; }")
    case.sub("system/fvSolution", "^PIMPLE.*", "PIMPLE { momentumPredictor no; nOuterCorrectors 1; nCorrectors 0; "
             "nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; }")
    case.sub("system/fvSchemes", "^gradSchemes.*", "gradSchemes { default leastSquares; }")
    case.run("postProcess", "-func", "writeCellCentres", "-time", 0)
    centres = case.field("0/C")
    case.remove("0/C*")
    case.sub("0/U", "^internalField .*", "internalField nonuniform List<vector> "
             f"{len(centres)} (\n" + "\n".join(vector((*velocity(x, y), 0)) for x, y, _ in centres) + "\n);")
    return centres


# Uniform flow through the rotor that rotates, and Stokes drag: v = u + (v0 - u) exp(-t/tau), x its integral
case = Rings("held.drag")
case.turning(10)
case.properties(GLASS, "hertz {} dry { restitution 0.5; } stokesDrag {}",
                lattice(96, 0.4e-3, 3, "(0.5 0.3 0)", "(-0.013 0.0125 0.0005)", "(0.003 0.0185 0.0055)"),
                "rho 1000; twoWay no;")
case.controls(0.028, 0.0004, 0.0004, OBJECT)
hold(case, lambda x, y: (1, 0.1))
claim_runs("held, drag: runs", case, "pimpleFoam")
(x0, x1), (v0, v1) = ([case.column(t, name) for t in ("0.0004", "0.028")] for name in ("positions", "U"))
within = [np.hypot(x[:, 0], x[:, 1]) < 0.02 for x in (x0, x1)]
claim("held, drag: particles have crossed the interface", (within[0] != within[1]).sum() > 30)
tau, t, u = 2500*0.16e-6/(18*1e-3), 0.0276, np.array([1, 0.1, 0])
decay = math.exp(-t/tau)
claim("held, drag: velocities across the interface have the closed form",
      difference(v1, u + (v0 - u)*decay) < 1e-13)
# the path is of second order in the DEM step h: 0.5 m/s tau (h/tau)^2/12, with h = 5e-6 s at most 2e-11 m a time
# constant
claim("held, drag: paths across the interface have the closed form",
      difference(x1, x0 + u*t + (v0 - u)*tau*(1 - decay)) < 1e-10)

# Du/Dt of fluid in an MRF zone, by virtual mass alone: dv/dt = C rho/(rho_p + C rho) Du/Dt = Du/Dt/3, with particles of
# the fluid's density at rest at centres of cells, which read the cell's value. Du/Dt is -W^2 r where the fluid rotates
# by W as a solid, whatever the frame's omega (W = omega: it is at rest in the frame). A uniform u that is steady in the
# frame turns with it, so that Du/Dt is omega x u there, and 0 in the zone at rest.
for name, velocity, in_frame, at_rest, words in (
        ("solid", lambda x, y: (-20*y, 20*x), (-400, 0), (-400, 0), "of fluid at rest in the frame is -omega^2 r"),
        ("faster", lambda x, y: (-30*y, 30*x), (-900, 0), (-900, 0), "of fluid that rotates faster is -W^2 r"),
        ("turning", lambda x, y: (1, 0), (0, 20), (0, 0),
         "of a uniform velocity that turns with the frame is omega x u")):
    case = Rings(f"held.{name}")
    case.controls(0.004, 0.001, 0.001, OBJECT)
    seeds = hold(case, velocity)
    r = np.hypot(seeds[:, 0], seeds[:, 1])
    inner = ((r > 0.0125) & (r < 0.0175)) | ((r > 0.0235) & (r < 0.0365))
    seeds = seeds[inner & (np.arange(1, len(r) + 1) % 3 == 0)]
    case.properties("water { density 1000; youngsModulus 1e6; }", "hertz {} dry { restitution 0.5; } virtualMass {}",
                    f"seeds {{ type list; diameter 0.2e-3; positions ({' '.join(map(vector, seeds))}); }}",
                    "rho 1000; twoWay no; kernel particleCentre;")
    case.frame(20, patches="shaft lids")
    claim_runs(f"held, {name}: runs", case, "pimpleFoam")
    rotor = np.hypot(seeds[:, 0], seeds[:, 1]) < 0.02
    along_r, along_y = np.where(rotor[:, None], in_frame, at_rest).T
    expected = np.column_stack((along_r*seeds[:, 0], along_r*seeds[:, 1] + along_y, 0*along_r))
    gained = case.column("0.004", "U") - case.column("0.001", "U")
    claim(f"held, {name}: Du/Dt {words}", min(rotor.sum(), (~rotor).sum()) > 20
          and np.linalg.norm(gained - 0.003/3*expected, axis=1).max() < 1e-12)

# The same beside the axis of a mesh that rotates by w: cells keep their velocity U = W k x X, X their place at first, so
# that Du/Dt = ((U - w k x x).grad) U with x = R X and (v.grad) U = W k x (R^-1 v)
case = Rings("held.mesh")
case.controls(0.004, 0.001, 0.001, OBJECT)
case.turning(10)
seeds = hold(case, lambda x, y: (-20*y, 20*x))
r = np.hypot(seeds[:, 0], seeds[:, 1])
case.sub("0/p", "type zeroGradient;", "type fixedValue; value uniform 0;")         # else its outflow must balance
seeds = seeds[(r > 0.0125) & (r < 0.0175)]
case.properties("water { density 1000; youngsModulus 1e6; }", "hertz {} dry { restitution 0.5; } virtualMass {}",
                f"seeds {{ type list; diameter 0.2e-3; positions ({' '.join(map(vector, seeds))}); }}",
                "rho 1000; twoWay no; kernel particleCentre;")
claim_runs("held, mesh: runs", case, "pimpleFoam")
X, expected = seeds @ [1, 1j, 0], 0         # k x is a product with i
for t in (0.002, 0.003, 0.004):
    turn = np.exp(10j*t)
    expected += 0.001/3*20j*(20j*X - 10j*X*turn)/turn
gained = (case.column("0.004", "U") - case.column("0.001", "U")) @ [1, 1j, 0]
# cells move by the chord of the step, 1e-2/2, and by the mean of their points: 3e-3 of w r
claim("held, mesh: Du/Dt of fluid in a mesh that rotates", len(seeds) > 20
      and abs(gained - expected).max() < 0.01*abs(expected).max(), abs(gained - expected).max()/abs(expected).max())

# ---- sides that do not cover each other -------------------------------------------------------------

# two boxes of 10 mm side by side, the right one 5.5 mm further back: of its 4 rows of faces, and of the left one's, one
# is whole, one has 80 %
case = Case("uncovered")
case.controls(0.01, 1e-3, functions=OBJECT, nu=1e-5)
case.mesh([(10*(x + side), 10*y + 5.5*side, 10*z) for side in (0, 1) for z in (0, 1) for y in (0, 1) for x in (0, 1)],
          [f"({n} {n + 1} {n + 3} {n + 2} {n + 4} {n + 5} {n + 7} {n + 6}) (4 4 4)" for n in (0, 8)],
          {"left": "type cyclicAMI; neighbourPatch right; lowWeightCorrection 0.2; faces ((1 3 7 5));",
           "right": "type cyclicAMI; neighbourPatch left; lowWeightCorrection 0.2; faces ((8 12 14 10));",
           "walls": "type wall; faces ((0 4 6 2) (9 11 15 13) (0 1 5 4) (2 6 7 3) (8 9 13 12) (10 14 15 11) (0 2 3 1) "
                    "(4 5 7 6) (8 10 11 9) (12 13 15 14));"}, scale=0.001)
between = '"(left|right)" { type cyclicAMI; value uniform '
case.flow("(0 0 0)", f"walls {{ type noSlip; }} {between} (0 0 0); }}",
          f"walls {{ type zeroGradient; }} {between} 0; }}")
case.properties(GLASS, "hertz {} dry { restitution 0.5; } wenYu {}",
                "one { type list; diameter 1e-4; velocity (1 0 0); positions ((0.009 0.001 0.005)); }", "rho 1;")
ran = case.run("pimpleFoam")
text = " ".join(ran.log.split())
claim("faces that the other side covers in part are warned of before the run",
      "the other side covers less than 90 % of 24 of 32 faces of cyclicAMI patches" in text, text[-3000:])
claim("a particle that reaches a face without cover ends the run",
      ran.status == 1 and "1 particle(s) outside the mesh" in text, text[-3000:])

# ---- refused ---------------------------------------------------------------------------------------

case = Rings("refused")
case.fields("type noSlip;")
case.properties(*DROPS)
case.controls(0.01, 0.001)
case.frame(10)
claim_refused("an MRF zone in demPimpleFoam is refused", case,
              "Zone rotor of constant/MRFProperties is active, but demPimpleFoam", "demPimpleFoam")
case.controls(0.01, 0.001, functions=OBJECT)
case.frame(10)
case.gravity()
case.append("constant/demProperties", 'start { snapshot "settled.dem"; }\n')
claim_runs("-settle with an MRF zone: runs", case, "demPimpleFoam", "-settle")
claim("-settle with an MRF zone: its wall rotates, its open patches that hold the particles do not",
      case.found("the surface of wall shaft rotates") and not case.found("the surface of wall lids rotates")
      and case.found("open patches are walls .*lids"))
claim("-settle with an MRF zone: the particles come to rest", case.found("at rest at t"))
case.remove("constant/g")
case.properties(*DROPS)
case.frame(10, axis="(0 1 0)")
claim_refused("a wall of an MRF zone that would push is refused", case,
              "Patch shaft rotates with zone rotor ... no surface of revolution", "pimpleFoam")
case.frame("table ((0 1) (1 2))")
claim_refused("an MRF zone of variable speed is refused", case, "omega of zone rotor changes in time", "pimpleFoam")
case.remove("constant/MRFProperties")
case.sub("constant/polyMesh/boundary", "transform *unknown;",
         "transform rotational; rotationAxis (0 0 1); rotationCentre (0 0 0);")
claim_refused("an interface with a rotation is refused", case, "is of type cyclicAMI with transform rotational",
              "pimpleFoam")

# An interface that may be partly blocked: ACMI patches and walls on the same faces, as createBaffles makes them
case = Rings("blocked", "patch")
case.properties(*DROPS)
case.controls(0.01, 0.001, functions=OBJECT)
case.fields("type noSlip;", "zeroGradient")
for field in ("0/U", "0/p"):
    case.sub(field, r"^boundaryField\n\{", 'boundaryField\n{ "(one|two)" { type cyclicACMI; value $internalField; } '
             '"(one|two)Wall" { type zeroGradient; }')
case.dictionary("system/topoSetDict", "actions\n(" + "".join(f"""
    {{ name {name}; type faceSet; action new; source patchToFace; sourceInfo {{ patch {patch}; }} patch {patch}; }}
    {{ name {name}; type faceZoneSet; action new; source setToFaceZone;
       sourceInfo {{ faceSet {name}; }} faceSet {name}; }}
""" for name, patch in (("one", "inside"), ("two", "outside"))) + ");")
case.dictionary("system/createBafflesDict", "internalFacesOnly false;\nbaffles\n{" + "".join(f"""
    {name}
    {{
        type faceZone; zoneName {name};
        patches
        {{
            master {{ name {name}; type cyclicACMI; neighbourPatch {other}; nonOverlapPatch {name}Wall;
                      transform noOrdering; }}
            slave {{ name {name}; type patch; }}
            master2 {{ name {name}Wall; type wall; }}
            slave2 {{ name {name}Wall; type wall; }}
        }}
    }}
""" for name, other in (("one", "two"), ("two", "one"))) + "}")
case.run("topoSet")
(case/"0").rename(case/"0.held")
case.run("createBaffles", "-overwrite")
case.remove("0")
(case/"0.held").rename(case/"0")
claim_refused("an interface that is partly blocked is refused", case,
              "patch one is of type cyclicACMI, but of the sliding interfaces particles pass cyclicAMI", "pimpleFoam")

# Stock cases with our function object
stock = Path(os.environ.get("FOAM_TUTORIALS", ""))/"incompressible"
if (stock/"SRFSimpleFoam/mixer").is_dir():
    for what, words, path, solver in (
            ("a periodic interface",
             "is of type cyclicPeriodicAMI, but of the sliding interfaces particles pass cyclicAMI",
             "pimpleFoam/RAS/oscillatingInletPeriodicAMI2D", "pimpleFoam"),
            ("a velocity in a rotating frame (SRF)", "velocity is relative to a rotating frame", "SRFSimpleFoam/mixer",
             "SRFSimpleFoam"),
            ("an MRF zone with blades", "Patch rotor rotates with zone ... no surface of revolution",
             "simpleFoam/mixerVessel2D", "simpleFoam")):
        case = Case("stock", stock/path)
        case.append("system/controlDict", f"functions {{ {OBJECT} }}\n")
        case.properties(*DROPS)
        if (case/"system/blockMeshDict.m4").exists():
            case.run("m4", "system/blockMeshDict.m4", log="system/blockMeshDict")
        case.run("blockMesh")
        if (case/"system/topoSetDict").exists():
            case.run("topoSet")
        claim_refused(f"{what} is refused", case, words, solver)
else:
    skip("interfaces, frames and blades of stock cases are refused", "FOAM_TUTORIALS has no mixer")
finish()
