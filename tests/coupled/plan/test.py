"""demPimpleFoam -plan reports the planned run and makes no step.

- The fluid of the solver, the weight of the bed, the limit of the fluid's time step and its number of DEM steps.
- Two ranks report the same; a run reports it once and follows it.
- A plan leaves no files, looks up the schemes of the run, and uses the bed's own void fraction; so does the plan of a
  function object.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

control = "system/controlDict"
number = "([-+0-9.e]+)"
pressure_drop = "less buoyancy .* N,"


def plan(**options):
    return case.run("demPimpleFoam", "-plan", **options).log


def planned(log, words):
    """The number after these words, a regular expression, in the plan."""
    return float(re.search(f"{words} *{number}", log)[1])


def of_the_case(log):
    """Lines that do not depend on the machine, its load or the number of ranks."""
    return re.search("(?ms)^Effects.*?^Memory.*?$", log)[0]


def files():
    """All files but logs, with their contents."""
    return {path: path.read_bytes() for path in case.path.rglob("*")
            if path.is_file() and not path.name.startswith("log.")}


# ---- a column of 1536 spheres of 0.1 mm in water ----------------------------------------------------

case = Case("column", "hindered")
first = plan()
claim_ran("demPimpleFoam -plan ends well", case)
claim("nothing has run", not re.search("^Time = ", first, re.M) and not case.times())

# Wen and Yu (1966) in water of 1000 kg/m3 and 1e-3 Pa s; four digits are printed
archimedes = 1000*1500*9.81*1e-12/1e-6
umf = (math.sqrt(33.7**2 + 0.0408*archimedes) - 33.7)*1e-3/(1000*1e-4)
claim("minimum fluidisation in the solver's fluid", close(planned(first, "minimum fluidisation at"), umf, 6e-4))
weight = math.pi/6*1e-12*1500*9.81                    # of a sphere, less buoyancy [N]
section = 0.000963**2                                 # [m2]
claim("pressure drop over the mesh's section", close(planned(first, pressure_drop), 1536*weight/section, 6e-4))
claim("what sets the fluid's step", "fluid step 0.001 s, set by deltaT of controlDict" in first)
steps = planned(first, "set by deltaT of controlDict:")

case.edit(control, endTime=0.002)
log = case.run("demPimpleFoam").log
claim("a run reports it once", len(re.findall("^Coupling", log, re.M)) == 1)
made = case.numbers(r"^Suna: .* particles, (\d+) DEM steps")
claim("the run takes the planned number of steps", made[0, 0] == steps)
claim("the run ends with its profile, in which as many steps stand as in the log",
      case.numbers(r"^profile: .* (\d+) steps$")[-1, 0] == made.sum())
# the columns of the second profile: time and processor add up to what its first line says, without phases below a
# thousandth (time within a fifth: other programs may run between two phases)
profile = re.search(f"(?ms)^profile of fluid and coupling: wall clock {number} s, processor {number} s, 2 fluid steps$"
                    "(.*?)^$", log)
phases = np.array(re.findall(f"% +{number} s +{number} s$", profile[3], re.M), float)
shares = phases.sum(0)/[float(profile[1]), float(profile[2])]
claim("and with the profile of fluid and coupling, whose phases add up to the whole (processor: 3 %)",
      len(phases) > 4 and 0.8 < shares[0] < 1.01 and 0.97 < shares[1] < 1.01, profile[0], shares)
claim("the fluid has phases", all(re.search(f"^    {phase} +[0-9.]+ %", profile[3], re.M)
                                  for phase in ("momentum", "pressure")))

case.edit(control, endTime=0.04)
case.run("decomposePar")
claim("the same plan on two ranks", of_the_case(plan(ranks=2)) == of_the_case(first))

# at rest no Courant number limits the step
case.edit(control, adjustTimeStep="yes", maxCo=0.5, maxDeltaT=1e-3)
claim("a limit of the fluid's step is named", "fluid step 0.001 s, set by maxDeltaT" in plan())
case.edit(control, maxDeltaT=1e30)
log = plan()
claim("without maxDeltaT the step of a fluid at rest still grows when the run ends: no limit is named",
      "fluid step" in log and "it grows to" not in log)
case.edit(control, maxDeltaT=1e-3)

# one that grows: 1.2 times a step in OpenFOAM, so the first is far from the last
case.edit(control, deltaT=1e-5)
log = plan()
claim("the step that it grows to", "it grows to 0.001 s, set by maxDeltaT" in log)
claim("with as many DEM steps as a fixed one of that length",
      planned(log, "grows to 0.001 s, set by maxDeltaT:") == steps)

# a vessel of constant section up to 1.6 mm, twice as wide at its top: the bed of 12 layers of 9 x 9 is in the straight
# part
case.mesh([(x, y, z) for z, wide in ((0, 0), (0.0016, 0), (0.00289, 0.0005))
           for x, y in ((-wide, 0), (0.000963 + wide, 0), (0.000963 + wide, 0.000963), (-wide, 0.000963))],
          ["(0 1 2 3 4 5 6 7) (4 4 7)", "(4 5 6 7 8 9 10 11) (4 4 5)"],
          {"sides": "type wall; faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7) "
                    "(4 5 9 8) (5 6 10 9) (6 7 11 10) (7 4 8 11));",
           "bottom": "type patch; faces ((0 3 2 1));", "top": "type patch; faces ((8 9 10 11));"})
case.sub("constant/demProperties", "count 1536; spacing 1.2036;", "count 972; spacing 1.05;")
case.sub("0/U", "bottom { type noSlip; }", "bottom { type fixedValue; value uniform (0 0 0.002); }")
case.edit(control, adjustTimeStep="no")
log = plan()
claim("pressure drop over the section where the bed stands",
      close(planned(log, pressure_drop), 972*weight/section, 6e-4))
# 10 and 90 % of 12 layers are 9.6 layers apart; the error at each end is at most a gap of 0.05 and 0.096 of a layer:
# 3 % of 1 - e
void = 1 - 81*math.pi/6*1e-12/(section*1.05e-4)
claim("the void fraction of the bed", close(planned(log, "for a bed of void fraction"), void, 0.024))
claim("which is its own", "of the particles as they are" in log)
claim("the velocity at which the fluid enters", close(planned(log, "the inlet's"), 0.002, 1e-6))
claim("and what Richardson and Zaki make of it", "by Richardson and Zaki (1954)" in log)
fixed = case.read("0/U")
case.sub("0/U", "bottom {.*", "bottom { type uniformFixedValue; uniformValue table ((0 (0 0 0.002)) (1 (0 0 0.01))); }")
claim("a velocity that may change is the start's", "the inlet's 0.002 m/s at the start (superficial) " in plan()
      and "the inlet's 0.002 m/s (superficial) " in log)
case.write("0/U", fixed)

# ---- no files, the schemes of the run ---------------------------------------------------------------

case.sub(control, "(?s)^adjustTimeStep.*", "")
case.edit(control, endTime=0.001, writeInterval=0.001)
case.append(control, """
functions { probe { type probes; libs ("libsampling.so"); fields (p U); probeLocations ((5e-4 5e-4 1e-3)); } }
""")
case.sub("constant/demProperties", "kernel +linear;", r"\g<0> record { interval 1e-3; energy yes; }")
for table in ("walls", "flows", "lost", "energy", "budget"):
    case.write(f"postProcessing/dem/0/{table}.csv", "of an earlier run\n")
case.remove("processor*")
# OpenFOAM reports the schemes that are asked for; the switch is fvSchemes, and schemesLookup since v2106
case.write(work/"site/etc/controlDict", "DebugSwitches { fvSchemes 1; schemesLookup 1; }\n")
site = {"WM_PROJECT_SITE": str(work/"site")}


def schemes(log):
    return set(re.findall("^Lookup .*scheme.*", log, re.M | re.I))


before = files()
asked = schemes(plan(env=site))
claim_ran("with function objects and records it ends well", case)
claim("it leaves no files and removes none", files() == before)
needed = schemes(case.run("demPimpleFoam", env=site).log)
claim_ran("the run of these schemes", case)
claim("the run has files", (case/"postProcessing/probe/0/p").stat().st_size and (case/"0.001/U").stat().st_size)
claim("it asks for all schemes that the run asks for", len(needed) > 8 and needed <= asked, *sorted(needed - asked))
case.sub("system/fvSchemes", "divSchemes.*", "divSchemes { default none; div((nuEff*dev2(T(grad(U))))) Gauss linear; }")
missing = case.run("demPimpleFoam", "-plan")
claim("a missing scheme is found", missing.status)
claim("and named", re.search(r"(?s)FATAL.*div\(alphaPhi,U\)", missing.log))

# ---- a bed: cubic packing of spheres of 1 mm, 10 x 10 a layer of 1.05 mm in 11 x 11 mm, 20 layers ---

case = Case("bed", "fixedBed")
case.gravity()
case.sub("constant/demProperties", "frozen yes;", "")
case.sub("constant/demProperties", "spacing 1.1;", "spacing 1.05;")
log = plan()
claim_ran("bed: ends well", case)
void = planned(log, "with gidaspow for a bed of void fraction")
# the error at the ends of the slab is at most a gap of 0.05 and 0.11 of a layer of 16: 1.4 % of 1 - e
claim("bed: its own void fraction (1.4 %)", close(void, 1 - 100*math.pi/6/(11*11*1.05), 0.014))
# there Gidaspow's pressure gradient (Ergun, as it is dense) carries the bed, less buoyancy
s, d, mu = 1 - void, 1e-3, 1.8e-5
a, b = 1.75*s*1.2/(d*void**3), 150*s*s*mu/(void**3*d*d)
umf = (-b + math.sqrt(b*b + 4*a*s*(2500 - 1.2)*9.81))/(2*a)
claim("bed: minimum fluidisation at that void fraction (1 %)",
      close(float(re.search(f" and at {number} m/s with gidaspow", log)[1]), umf, 0.01))
# three diameters of 21
claim("bed: what the kernel takes (%)", planned(log, " m:") == 14)
claim("bed: and of which layer (m)", close(planned(log, "drag of a layer of"), 3e-3, 1e-6))

# a sphere of 7 mm in cells of 2.2 mm, a kernel for 1 mm: 180 mm3 over pi^1.5 3^3 mm3 is 1.2 at its centre
mixed = Case("mixed", "fixedBed")
mixed.gravity()
mixed.sub("constant/demProperties", r"(?s)bed \{.*?\}", "boulder { type list; positions ((5.5e-3 5.5e-3 1e-2)); diameter 7e-3; }")
mixed.sub("constant/demProperties", "kernel  diffusion;", "kernel diffusion; diameter 1e-3;")
claim("a sphere too large for cells and kernel is reported before the run",
      re.search("less than minVoidFraction 0.2 in [0-9]+ cells, .* the largest, 0.007 m, .* diameter 0.007 in coupling",
                mixed.run("demPimpleFoam", "-plan").log))
mixed.sub("constant/demProperties", "diameter 1e-3;", "diameter 7e-3;")
wide = mixed.run("demPimpleFoam", "-plan")
claim("with the diameter that it names it is not", wide and "minVoidFraction" not in wide.log, *wide.log.splitlines()[-9:])

mixed.edit(control, endTime=0)
none = mixed.run("demPimpleFoam")
claim("a run that ends where it begins says that it makes no step",
      none and re.search("WARNING: no step is made: the run begins at 0 s and ends at 0 s; raise endTime", none.log))

# the same of a function object
case.append(control, 'functions { particles { type demCloud; libs ("libdemCoupling.so"); plan yes; } }\n')
before = files()
log = case.run("pimpleFoam")
claim("function object: ends well", log.status == 0)
claim_ran("function object: and says so", case, "pimpleFoam")
claim("function object: has run nothing", not re.search("^Time = ", log.log, re.M))
claim("function object: left no files", files() == before)
claim("function object: plans the same bed", planned(log.log, "for a bed of void fraction") == void)
finish()
