"""Particles in unmodified solvers and stock cases, by dictionary only.

One-way in icoFoam's cavity, two-way in pimpleFoam's TJunction; and the plate of DPMFoam's Goldschmidt case, a wall of
the mesh. The stock files are not changed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

tutorials = Path(os.environ.get("FOAM_TUTORIALS") or "none")
if not (tutorials/"incompressible/icoFoam/cavity/cavity").is_dir():
    skip("stock cases", "FOAM_TUTORIALS has none")
    finish()


def stock(path):
    """The stock case with two files added. Its controlDict is kept as controlDict.stock and included."""
    source = tutorials/"incompressible"/path
    case = Case(source.name, source, shared=False)
    (case/"system/controlDict").rename(case/"system/controlDict.stock")
    case.copy(here/source.name/"controlDict", "system/controlDict")
    case.copy(here/source.name/"demProperties", "constant/demProperties")
    return case


def unchanged(case, path):
    """All files of the stock case are in the case with the same bytes."""
    source = tutorials/"incompressible"/path
    files = [file.relative_to(source) for file in source.rglob("*") if file.is_file()]
    stocks = {Path("system/controlDict"): "system/controlDict.stock"}
    return len(files) > 5 and all((source/file).read_bytes() == (case/stocks.get(file, file)).read_bytes()
                                  for file in files)


def written(case):
    """The times with particles."""
    return [time for time in case.times() if (case/time/"lagrangian").is_dir()]


# ---- cavity, one-way --------------------------------------------------------------------------------

cavity = "icoFoam/cavity/cavity"
case = stock(cavity)
case.sub("system/controlDict", "endTime .*", "endTime 0.1; writeInterval 10;")
case.run("blockMesh")
claim_runs("cavity: runs", case, "icoFoam")
claim("cavity: particles are written when the fluid is", written(case) == ["0.05", "0.1"])
start, end = (case.particles(time, "positions")[:, 1:] for time in ("0.05", "0.1"))
claim("cavity: the particles drift with the fluid", np.linalg.norm(end - start, axis=1).max() > 1e-4)
claim("cavity: stock files are unchanged", unchanged(case, cavity))

case.sub("system/controlDict", "libs ", "writeControl timeStep; writeInterval 3; libs ")
case.sub("system/controlDict", "endTime .*", "endTime 0.04;")
(case/"0.1").rename(case/"with")
case.remove("0.[0-9]*")
case.run("icoFoam")
claim("cavity: or at the times of the user", written(case) == ["0.015", "0.03"])

case.remove("0.[0-9]*")
case.run("foamDictionary", "-entry", "functions", "-remove", "system/controlDict.stock")
case.copy(case/"system/controlDict.stock", "system/controlDict")
case.edit("system/controlDict", endTime=0.1, writeInterval=10)
case.run("icoFoam")
claim("cavity: one-way, the fluid is the same without particles", lambda: agrees(case/"0.1/U", case/"with/U"))

# ---- TJunction, two-way -----------------------------------------------------------------------------

junction = "pimpleFoam/RAS/TJunction"
case = stock(junction)
case.run("blockMesh")
claim_runs("TJunction: runs", case, "pimpleFoam")
claim("TJunction: exchange closes", worst(case.log("pimpleFoam"), "exchange error") < 1e-12)
claim("TJunction: volume of the particles is kept", worst(case.log("pimpleFoam"), "volume error") < 1e-12)
velocities = case.particles("0.02", "U")[:, 1:]
claim("TJunction: all particles are written", len(velocities) == 800)
claim("TJunction: the particles move", largest(velocities) > 1e-6)
claim("TJunction: stock files are unchanged", unchanged(case, junction))
(case/"0.02").rename(case/"with")
case.remove("0.0*")
case.sub("constant/demProperties", "rho ", "twoWay no; rho ")
case.run("pimpleFoam")
claim("TJunction: two-way, the particles change the fluid",
      lambda: (case/"0.02/U").read_bytes() != (case/"with/U").read_bytes())

# ---- Goldschmidt: the plate is of type wall ---------------------------------------------------------

bed = tutorials/"lagrangian/DPMFoam/Goldschmidt"
if not bed.is_dir():
    finish()
case = Case("plate", bed, shared=False)
added = here.parents[2]/"tutorials/goldschmidt/added/suna"
for name in ("controlDict", "fvSchemes", "fvSolution"):
    (case/"system"/name).rename(case/f"system/{name}.stock")
case.copy(added, ".")
voidFraction = case.read("0/voidFraction")
listed = re.search(r"(?ms)^\(.*?^\)", case.read("constant/kinematicCloudPositions"))
case.write("constant/positions", f"positions\n{listed[0]}\n;\n")
case.write("system/options", "endTime 4e-5; writeControl timeStep; writeInterval 2; writeFormat ascii;")
case.sub("system/controlDict", "areaAverage", "sum")
case.sub("system/controlDict", r"\(p\)", "(wholePhi)")
case.run("blockMesh")


def entering():
    """The velocity at which fluid enters through the plate [m/s]."""
    case.remove("4e-05", "postProcessing")
    case.run("demPimpleFoam")
    rows = np.loadtxt(case/"postProcessing/plate/0/surfaceFieldValue.dat", ndmin=2)
    return -rows[-1, 1]/(0.15*0.015)


# without 0/voidFraction the superficial velocity enters
case.remove("0/voidFraction")
velocity = entering()
claim_ran("Goldschmidt: runs without 0/voidFraction", case)
claim("Goldschmidt: 1.875 m/s enter through the plate, a wall (1e-6)", close(velocity, 1.875, 1e-6))
plate = re.search("(?ms)^ *bottom.*?}", case.read("4e-05/voidFraction"))
claim("Goldschmidt: the void fraction is 1 there", re.search("value *uniform 1;", plate[0]))
# the user's boundary condition is kept
case.write("0/voidFraction", voidFraction.replace("type fixedValue; value uniform 1;", "type zeroGradient;"))
claim("Goldschmidt: with zeroGradient in 0/voidFraction only that fraction enters", entering() < 1.5)
# a velocity that begins later is detected when it does
case.remove("0/voidFraction", "4e-05", "postProcessing")
case.sub("0/U", r"type fixedValue; value uniform \(0 0 1.875\);",
         "type uniformFixedValue; uniformValue table ((0 (0 0 0)) (1e-5 (0 0 1)));")
case.run("demPimpleFoam")
claim("Goldschmidt: a plate with a flow that begins later is refused, with the entry to give",
      case.found("wall bottom lets fluid in.*0/voidFraction.*fixedValue"))
finish()
