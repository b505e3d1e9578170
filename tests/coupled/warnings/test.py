"""A coupled run warns before its first step, and names the entry to change, if fluid steps are too long for the
particles, in any solver, or the fluid is faster than impactSpeed. If the solver adjusts its step, the criteria of the
particles limit it.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

tutorials = Path(os.environ.get("FOAM_TUTORIALS") or "none")
if not (tutorials/"heatTransfer/buoyantPimpleFoam/hotRoom").is_dir():
    skip("stock cases", "FOAM_TUTORIALS has none")
    finish()
control = "system/controlDict"


def stock(path):
    """A stock case with the function object in its controlDict."""
    source = tutorials/path
    case = Case(source.name, source, shared=False)
    case.append(control, 'functions { particles { type demCloud; libs ("libdemCoupling.so"); } }\n')
    return case


def particles(group, effects, coupling, rest="", drag="schillerNaumann {}"):
    case.dictionary("constant/demProperties", f"""
materials {{ sand {{ density 2600; youngsModulus 1e7; poissonsRatio 0.3; }} }}
effects {{ hertz {{}} dry {{ restitution 0.8; }} {drag} {effects} }}
insert {{ some {{ type lattice; material sand; {group} }} }}
coupling {{ kernel linear; {coupling} }} {rest}
""")


def run(solver="pimpleFoam", **options):
    """Run from the beginning; what it prints is in `log`."""
    global log
    log = case.run(solver, **options).log


def reported(what, pattern):
    claim(what, re.search(pattern, log, re.M))


def listed(what, pattern, number="[0-9]+"):
    """An item of the list of warnings begins with this expression."""
    reported(what, rf"^ +{number}\. {pattern}")


def number(pattern):
    """What the group of this expression matches first in the log."""
    return float(re.search(pattern, log)[1])


# ---- hotRoom: the stock step of 2 s, buoyantPimpleFoam ----------------------------------------------

case = stock("heatTransfer/buoyantPimpleFoam/hotRoom")
particles("diameter 1e-3; count 10; spacing 2; min (4 2 4); max (6 3 6);", "pressureGradient {}", "twoWay no;")
case.run("blockMesh")
case.run("setFields")
case.edit(control, endTime=6)
run("buoyantPimpleFoam")
listed("hotRoom: before the first step the list has the DEM steps of a step of 2 s, and their time",
       "a fluid step of 2 s is [0-9]+ DEM steps, .* of processor time for 10 particles, .* for the run; "
       "take a shorter deltaT")
claim("hotRoom: ... as many as 2 s over the longest step (1e-3)",
      lambda: close(number("a fluid step of 2 s is ([0-9]*) DEM steps"),
                    2/number("time step of the particles at most ([-0-9.e+]*) s"), 1e-3))
# particles fall from 2 m in 2 s: 19.6 m/s without air; the list names a step in which none crosses half a cell of 0.5 m
listed("hotRoom: the list has a sufficiently short step",
       r"a fluid step of 2 s is long: at .* \(maxParticleCo 0.5\); take deltaT [0-9.e-]+ s in system/controlDict, "
       "or adjustTimeStep yes")
claim("hotRoom: ... all before the first step",
      lambda: re.search("^WARNINGS", log, re.M).start() < log.index("DEM steps, void fraction"))

# ---- TJunction: steps that are too long for fast particles, fixed and adjusted by the solver --------

case = stock("incompressible/pimpleFoam/RAS/TJunction")
case.edit(control, endTime=0.004, writeInterval=1, adjustTimeStep="no", deltaT=0.001)
thrown = "diameter 1e-3; count 10; spacing 2; min (0.05 -0.005 0.005); max (0.15 0.005 0.015);"
particles(thrown + " velocity (5 0 0);", "pressureGradient {}", "rho 1.2;", "time { step 1e-5; force yes; }")
case.run("blockMesh")
run()
claim_ran("TJunction: particles at 5 m/s, a fixed step", case, "pimpleFoam")
reported("TJunction: the function object reports the fixed step as demPimpleFoam does",
         r"^Suna: deltaT 0.001 s is long: Courant number of particles [0-9.]+, above 0.5 \(maxParticleCo\); "
         "take [0-9.e-]+ s, or adjustTimeStep yes$")
claim("TJunction: it names the step at which the Courant number is 0.5 (1e-3)",
      lambda: close(0.001*0.5/number("Courant number of particles ([0-9.]*), above"),
                    number("Courant number of particles .*; take ([-0-9.e]*) s"), 1e-3))
claim("TJunction: it is reported once", log.count("is long: Courant number of particles") == 1)
case.edit(control, adjustTimeStep="yes", maxCo=1000, endTime=0.002, writeControl="timeStep")
run()
claim_ran("TJunction: an adjusted step", case, "pimpleFoam")
reported("TJunction: the criterion that limits the step is named", "^Suna: time step limited by maxParticleCo to")
claim("TJunction: with that step no particle crosses half a cell", worst(log, "Particle Courant Number max:") < 0.5001)

# ---- a scheme of the time derivative that does not keep the momentum --------------------------------

case.edit(control, adjustTimeStep="no", deltaT=1e-4, endTime=1e-4)
particles(thrown, "pressureGradient {}", "rho 1.2;")
case.sub("system/fvSchemes", "Euler;", "backward;")
run()
listed("TJunction: backward, with the entry", "ddtSchemes backward does not keep the momentum .* give Euler")
case.sub("system/fvSchemes", "backward;", "Euler;")
run()
claim("TJunction: Euler is not", log and "ddtSchemes" not in log and "relax the last" not in log)
solution = case.read("system/fvSolution")
case.write("system/fvSolution", re.sub(r"(?ms)^relaxationFactors.*?^}", "", solution)
           + 'relaxationFactors { equations { "U.*" 0.7; } }\n')
run()
listed("TJunction: relaxation of the last iteration, with the entry",
       "relaxationFactors of system/fvSolution relax the last iteration of U by 0.7, .* give UFinal 1 in equations")
case.write("system/fvSolution", solution)

# ---- a long step, after which particles are outside: the cause is the step --------------------------

case.edit(control, deltaT=1, endTime=2)
particles(thrown, "gravity { acceleration (9.81 0 0); }", "rho 1.2; twoWay no;", drag="")
run()
listed("TJunction: a step of 1 s is reported before it", "a fluid step of 1 s is long: at .* take deltaT")
reported("TJunction: when particles are outside after it, the step is named as the cause",
         r"outside the mesh.*deltaT 1 s is long: Courant number of particles .* above 0.5 \(maxParticleCo\); "
         "take .* s, or adjustTimeStep yes")
claim("TJunction: the walls are not named", log and not re.search("outside the mesh.*make walls of all patches", log))

# ---- a fluid faster than impactSpeed, an inlet without a velocity, a fluid without drag -------------


def inlet(condition):
    case.run("foamDictionary", "-entry", "boundaryField.inlet", "-set", f"{{ {condition} }}", "0/U")


case.edit(control, deltaT=1e-5, endTime=1e-5)
particles(thrown, "pressureGradient {}", "rho 1.2; twoWay no;")
inlet("type fixedValue; value uniform (25.7 0 0);")
run()
listed("TJunction: an inlet of 25.7 m/s",
       "the fluid: 25.7 m/s is above effects/hertz/impactSpeed 1 m/s, and an impact at it overlaps by 5[0-9.]+ % of a "
       r"diameter, .*; take effects/hertz/impactSpeed 25.7 and materials/sand/youngsModulus [0-9.e+]+ Pa")
inlet("type zeroGradient;")
particles(thrown, "pressureGradient {}", "rho 1.2; twoWay no;", drag="")
run()
listed("TJunction: a zero-gradient inlet, with the entry to give",
       "U on patch inlet is zeroGradient: .* fixedValue in 0/U", 1)
listed("TJunction: a fluid without drag", "a fluid, and no drag: .* add a drag law to effects")

# ---- open patches, files that are not read, a decomposition that OpenFOAM does not have -------------

listed("TJunction: open patches",
       "particles that reach patch inlet, outlet1, outlet2 end the run: .* outlets . NAME . patch inlet; . ., "
       r"or .* coupling . walls \(inlet\); .$")
case.copy(case/"constant/demProperties", "constant/air/demProperties")
case.dictionary("system/decomposeParDict", "numberOfSubdomains 2; method scotch;\n")
particles(thrown, "pressureGradient {}", "rho 1.2; twoWay no; walls (inlet);",
          "outlets { a { patch outlet1; } b { patch outlet2; } }")
case.write("dummy/libscotchDecomp.so", "")
run(env={"LD_LIBRARY_PATH": f"{case/'dummy'}:{os.environ['LD_LIBRARY_PATH']}"})
claim("TJunction: no open patch where all are walls or outlets", log and "that reach patch" not in log)
listed("TJunction: a demProperties in the folder of a region", "constant/air/demProperties is not read")
listed("TJunction: scotch, where OpenFOAM has a stand-in",
       r"method scotch of system/decomposeParDict is not in this OpenFOAM .* take hierarchical or simple")

# ---- angledDuct: the stock step of 1 s, rhoPimpleFoam -----------------------------------------------

# later versions have another duct, without m4
if (tutorials/"compressible/rhoPimpleFoam/RAS/angledDuct/system/blockMeshDict.m4").exists() and shutil.which("m4"):
    case = stock("compressible/rhoPimpleFoam/RAS/angledDuct")
    particles("diameter 1e-3; count 50; spacing 2; min (-0.12 0.015 -0.01); max (-0.05 0.03 0.01);",
              "pressureGradient {} gravity { acceleration (0 0 -9.81); }", "twoWay no;")
    case.run("m4", "system/blockMeshDict.m4", log="system/blockMeshDict")
    case.run("blockMesh")
    run("rhoPimpleFoam")
    listed("angledDuct: the stock step of 1 s is reported before the particles move",
           "a fluid step of 1 s is long: at .* that the fluid gives to a particle in it, .* take deltaT [0-9.e-]+ s")
    reported("angledDuct: particles outside after it have the step as cause",
             r"50 particle\(s\) outside the mesh.*deltaT 1 s is long: Courant number of particles .*; "
             "take [0-9.e-]+ s, or adjustTimeStep yes")
finish()
