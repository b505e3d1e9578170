"""Time controls of controlDict and of the function object apply to particles as to fields: timeStart, timeEnd,
enabled, purgeWrite, times to write that adjusted steps hit, stopping on request, -postProcess. Settings that would lose
steps or cells, unknown entries and particles in two regions are refused.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from closures import speed
from solvers.box import fallen, prepare, spheres_apart

control = "system/controlDict"
one = "insert { one { type list; diameter 1e-4; positions ( (0.0071 0.0083 0.037) ); } }\n"
many = """insert
{ all { type random; count 50; diameter 1e-3; velocity (0.1 0 0); min (0 0 0); max (0.02 0.02 0.04); } }
"""


def written(path):
    return path.is_file() and path.stat().st_size > 0


# ---- timeStart, timeEnd -----------------------------------------------------------------------------

for way in ("no", "yes"):
    what = f"timeStart, timeEnd, two-way {way}"
    case = prepare("pimpleFoam", one + f"coupling {{ rho 10; twoWay {way}; }}", f"window-{way}")
    case.sub(control, "type *demCloud;", r"\g<0> timeStart 0.02; timeEnd 0.1;")
    case.edit(control, endTime=0.15)
    claim_runs(f"{what}: runs", case, "pimpleFoam")
    claim(f"{what}: particles move in 81 steps, as other function objects",
          len(re.findall("Suna: 1 particles, .* DEM steps, void", case.log("pimpleFoam"))) == 81)
    # two-way the sphere drags its cells along: 2 %
    claim(f"{what}: the sphere has fallen for 81 ms", close(fallen(case, "0.1"), speed(0.081), 0.02))
    claim(f"{what}: it is written when it moves",
          written(case/"0.05/uniform/dem.snapshot") and not (case/"0.15/uniform/dem.snapshot").exists())

# ---- adjusted steps, which the particles limit, end at the times to write ---------------------------

case = prepare("pimpleFoam", """insert { all { type random; count 50; diameter 1e-3; velocity (1.7 0 0);
min (0 0 0.005); max (0.02 0.02 0.03); } }
coupling { rho 1; }
""", "adjusted")
case.edit(control, endTime=0.03, writeInterval=0.01, writeControl="adjustableRunTime", adjustTimeStep="yes", maxCo=1)
claim_runs("adjusted steps: runs", case, "pimpleFoam")
claim("adjusted steps: the particles limit them", "Suna: time step limited by maxParticleCo" in case.log("pimpleFoam"))
claim("adjusted steps: fluid and particles are written at the times that controlDict names",
      case.times() == ["0.01", "0.02", "0.03"] and all((case/t/"lagrangian").is_dir() for t in case.times()),
      case.times())
case.remove("0.*[0-9]")
case.sub(control, "^    particles", """    probe { type probes; libs ("libsampling.so"); fields (p);
            probeLocations ((0.01 0.01 0.01)); writeControl adjustableRunTime; writeInterval 0.004; }
    particles""")
case.run("pimpleFoam")
probed = np.loadtxt(case/"postProcessing/probe/0/p")[:, 0]
claim("adjusted steps: a function object before the particles writes at its times",
      all(min(abs(probed - 0.004*n)) < 1e-9 for n in range(1, 8)), probed)

# ---- changes of the function object in a run --------------------------------------------------------

switch = """functions
{{
    particles {{ type demCloud; libs ("libdemCoupling.so"); {entries} }}
    {update}
}}
OptimisationSwitches {{ fileModificationSkew 0; }}
"""
update = """update
    {
        type timeActivatedFileUpdate; libs ("libutilityFunctionObjects.so");
        fileToUpdate "<system>/controlDict";
        timeVsFile ( (-1 "<system>/first") (0.0495 "<system>/second") (0.0995 "<system>/first") );
    }"""


def changes(name, way, second, first=""):
    """A run to 0.15 s whose function object has entries `first`, and `second` in the steps from 0.05 to 0.1 s."""
    case = prepare("pimpleFoam", one + f"coupling {{ rho 10; twoWay {way}; }}", name)
    case.edit(control, endTime=0.15, runTimeModifiable="yes")
    plain = case.read(control)
    plain = plain[:plain.index("functions")]
    for file, entries in (("first", first), ("second", second)):
        case.write(f"system/{file}", plain + switch.format(entries=entries, update=update))
    case.copy(case/"system/first", control)
    return case


for way in ("no", "yes"):
    what = f"enabled no in a run, two-way {way}"
    case = changes(f"disabled-{way}", way, "enabled no;", "writeControl writeTime;" if way == "no" else "")
    claim_runs(f"{what}: runs", case, "pimpleFoam")
    claim(f"{what}: particles stand still in 50 of 150 steps",
          len(re.findall("Suna: 1 particles, .* DEM steps, void", case.log("pimpleFoam"))) == 100)
    claim(f"{what}: the sphere has fallen for 100 ms", lambda: close(fallen(case, "0.15"), speed(0.1), 0.02))
    claim(f"{what}: the log tells it", "functions/particles is disabled: the particles stand still" in
          case.log("pimpleFoam") and "functions/particles is enabled again" in case.log("pimpleFoam"))

# by hand: OpenFOAM deletes it before it has called it for the last step
case = prepare("pimpleFoam", one + "coupling { rho 10; }", "by-hand")
case.edit(control, endTime=1000, writeInterval=1000, runTimeModifiable="yes")
case.append(control, "OptimisationSwitches { fileModificationSkew 0; }\n")
solver = case.start("pimpleFoam")
until(lambda: "Suna: exchange error" in case.log("pimpleFoam"))
time.sleep(1)                                         # at least, between two dates of a file
case.sub(control, "type *demCloud;", r"\g<0> enabled no;")
claim("enabled no by hand: the log tells it",
      until(lambda: "functions/particles is disabled" in case.log("pimpleFoam")))
time.sleep(1)
case.edit(control, stopAt="writeNow")
claim("enabled no by hand: the run goes on and ends properly", case.ended(solver) == 0)
claim("enabled no by hand: the last step of the particles is complete",
      len(re.findall("DEM steps, void", case.log("pimpleFoam")))
      == len(re.findall("Suna: exchange error", case.log("pimpleFoam"))))

# it had no time control: OpenFOAM makes it anew; when the entry is taken out, OpenFOAM keeps it
case = changes("late-end", "yes", "timeEnd 0.08;")
claim_runs("timeEnd that is added in a run: runs", case, "pimpleFoam")
claim("timeEnd that is added in a run: particles stand still after it",
      len(re.findall("Suna: 1 particles, .* DEM steps, void", case.log("pimpleFoam"))) == 80
      == len(re.findall("Suna: exchange error", case.log("pimpleFoam"))))

# ---- purgeWrite, stopping on demand, -postProcess, on the same run ----------------------------------

case = prepare("pimpleFoam", many + "coupling { rho 1000; }", "run")
case.edit(control, endTime=0.1, writeInterval=0.02)
straight = case.read(control)


def run(**entries):
    """Continue the run from its last time with these entries of controlDict."""
    case.write(control, straight)
    case.edit(control, **entries)
    return case.run("pimpleFoam")


run()
claim_ran("the straight run: runs", case, "pimpleFoam")
(case/"0.1").rename(case/"straight")
case.remove("0.0*")

run(purgeWrite=2)
claim("purgeWrite 2: two times are left", case.times() == ["0.08", "0.1"])
claim("purgeWrite 2: the particles of both are there",
      written(case/"0.08/uniform/dem.snapshot") and written(case/"0.1/lagrangian/particles/U"))
case.remove("0.1")
run(purgeWrite=2)
claim("purgeWrite 2: a restart from the remaining times agrees with the uninterrupted run",
      spheres_apart(case, "straight", "0.1") < 1e-11)

# from 0.08 s, with this entry, the next step is the last
case.remove("0.1")
run(stopAt="writeNow")
claim_ran("stopAt writeNow: the run ends well", case, "pimpleFoam")
claim("stopAt writeNow: the particles are written at the last step",
      written(case/"0.081/uniform/dem.snapshot") and not (case/"0.1").exists())
run(writeInterval=0.019)
claim("stopAt writeNow: a restart agrees with the uninterrupted run", spheres_apart(case, "straight", "0.1") < 1e-11)

# the signal of OpenFOAM, in a run from 0.08 s: the particles are written with the fields, and the run ends
(case/"0.1").rename(case/"last")
case.remove("0.08[1-9]*", "0.09*")
case.write(control, straight + "OptimisationSwitches { stopAtWriteNowSignal 10; }\n")
case.edit(control, endTime=1000, writeInterval=1000)
solver = case.start("pimpleFoam")
if until(lambda: "DEM steps, void" in case.log("pimpleFoam")):
    solver.send_signal(signal.SIGUSR1)
claim("stopAtWriteNowSignal 10: SIGUSR1 ends the run properly", case.ended(solver) == 0)
now = case.times()[-1]
claim("stopAtWriteNowSignal 10: particles and fields are of the same time",
      now != "0.08" and written(case/now/"U") and written(case/now/"uniform/dem.snapshot"))
if now != "0.08":
    case.remove(now)
(case/"last").rename(case/"0.1")


def contents():
    """All files but logs."""
    return {path: path.read_bytes() for path in case.path.rglob("*")
            if path.is_file() and not path.name.startswith("log.")}


before = contents()
claim_runs("-postProcess: runs", case, "pimpleFoam", "-postProcess")
claim("-postProcess: nothing moves, no file changes", contents() == before)
case.run("pimpleFoam", "-postProcess", "-func", "mag(U)", "-latestTime")
claim("-postProcess -func: writes its field", written(case/"0.1/mag(U)"))

# ---- refused ----------------------------------------------------------------------------------------


def refused(what, sentence, solver):
    """The solver ends with an error within a minute, with this sentence."""
    ran = case.run(solver, limit=60)
    claim(f"{what} is refused", ran.status not in (0, 124) and sentence in ran.log, *ran.log.splitlines()[-12:])


def coupling(entries):
    case.write("constant/particles", many + f"coupling {{ rho 1000; {entries} }}")


case.remove("0.*[0-9]")
case.write(control, straight)
coupling("interval 1e-3;")
refused("coupling/interval in a solver with time", "interval is for steady solvers", "pimpleFoam")
coupling("relaxation 0.5;")
refused("coupling/relaxation in a solver with time", "relaxation is for steady solvers", "pimpleFoam")
coupling("")
case.sub("system/fvSchemes", "Euler", "steadyState")
refused("a steady solver without coupling/interval", "Add interval", "simpleFoam")
coupling("interval 1e-3; relaxation 0;")
refused("coupling/relaxation 0", "must be above 0", "simpleFoam")
coupling("interval -1e-3;")
refused("a negative coupling/interval", "must be positive", "simpleFoam")
coupling("interval 1e-3;")
refused("demPimpleFoam with steadyState", "demPimpleFoam needs Euler", "demPimpleFoam")

# a mesh that moves while the particles rest before timeStart or after timeEnd; a mesh that changes its topology
case = prepare("pimpleFoam", many + "coupling { rho 1000; }", "moving")
case.dictionary("constant/dynamicMeshDict", """
dynamicFvMesh dynamicMotionSolverFvMesh; motionSolverLibs ("libfvMotionSolvers.so");
motionSolver solidBody; solidBodyMotionFunction linearMotion; velocity (0.001 0 0);
""")
solution = case.read("system/fvSolution")
case.sub("system/fvSolution", "nOuterCorrectors [^;]*;", "nOuterCorrectors 2; moveMeshOuterCorrectors yes;")
refused("a mesh that moves again in outer correctors", "The mesh moves again", "pimpleFoam")
case.write("system/fvSolution", solution)
case.sub(control, "type *demCloud;", r"\g<0> timeStart 0.005;")
refused("a mesh that moves before timeStart", "The mesh moves, but the particles have stood still", "pimpleFoam")

# v2512 cannot refine between these cyclic patches
case = prepare("interFoam", many, "changing")
case.sub("system/blockMeshDict", "type cyclic; neighbourPatch [a-z]*;", "type symmetryPlane;")
for field in ("U", "alpha.water", "p_rgh"):
    case.sub(f"0/{field}", "type +cyclic;", "type symmetryPlane;")
case.sub("constant/demProperties", r"periodic \(x\);", "")
case.run("blockMesh")
case.run("setFields")
case.dictionary("constant/dynamicMeshDict", """
dynamicFvMesh dynamicRefineFvMesh; refineInterval 1; field alpha.water;
lowerRefineLevel 0.5; upperRefineLevel 1.5; unrefineLevel 10;
nBufferLayers 1; maxRefinement 1; maxCells 10000; dumpLevel true;
correctFluxes ( (phi none) (nHatf none) (rhoPhi none) (alphaPhi0.water none) (ghf none) );
""")
refused("a mesh that is refined", "The mesh changes", "interFoam")
case.sub(control, "type *demCloud;", r"\g<0> timeStart 0.005;")
refused("a mesh that is refined before timeStart", "The mesh changes", "interFoam")

# ---- entries that would do nothing, particles in two regions ------------------------------------------

case = prepare("pimpleFoam", many + "coupling { rho 1000; }", "entries")
good = case.read(control)
for entries, sentence in (
        ("timeSart 0.1;", 'functions/particles: unknown entry "timeSart"; did you mean timeStart?'),
        ("twoWay no;", 'functions/particles: unknown entry "twoWay"; it belongs to coupling of constant')):
    case.sub(control, "type *demCloud;", rf"\g<0> {entries}")
    refused(f"{entries} of the function object", sentence, "pimpleFoam")
    case.write(control, good)
for entries, name in (("fields (U);", "fields"), ("timeStart 0.1; duration 1;", "timeStart"), ("actve no;", "actve")):
    case.dictionary("constant/fvOptions", f'source {{ type demMomentumSource; libs ("libdemCoupling.so"); {entries} }}')
    refused(f"{entries} of the momentum source", f'fvOptions/source: unknown entry "{name}"', "pimpleFoam")
case.dictionary("constant/fvOptions", "source { type demMomentumSource; libs (\"libdemCoupling.so\"); active yes;"
                " log yes; selectionMode all; }")
case.sub(control, "type *demCloud;", r"\g<0> enabled yes; region region0; log yes; writeInterval 1; "
         "executeControl timeStep; executeInterval 1;")
case.edit(control, endTime=0.002)
claim_runs("entries of any function object and source: runs", case, "pimpleFoam")

case = prepare("buoyantPimpleFoam", many, "regions")
for folder, names in (("0", ("U", "p", "p_rgh", "T")), ("system", ("fvSchemes", "fvSolution")),
                      ("constant", ("polyMesh", "thermophysicalProperties", "turbulenceProperties", "g"))):
    for name in names:
        for region in ("gas", "air"):
            case.copy(case/folder/name, f"{folder}/{region}/{name}")
for region in ("gas", "air"):
    case.dictionary(f"constant/{region}/radiationProperties", "radiation off; radiationModel none;")
case.dictionary("constant/regionProperties", "regions (fluid (gas air) solid ());")
case.sub(control, r"^functions[\s\S]*", "functions { a { type demCloud; libs (\"libdemCoupling.so\"); region gas; } "
         "b { type demCloud; libs (\"libdemCoupling.so\"); region air; } }\n")
refused("a second region with particles", "functions/b adds particles to region air, but region gas has some already",
        "chtMultiRegionFoam")
finish()
