"""Wrong input ends a coupled run, in serial and on several ranks, with a sentence that names the cure. No run hangs or
continues without particles.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

control, scene, transport = "system/controlDict", "constant/demProperties", "constant/transportProperties"


def files(case):
    """What the case contains and when it was written, without logs and the lock that MPI_Abort leaves."""
    return {(path, path.stat().st_mtime_ns) for path in case.path.rglob("*")
            if path.is_file() and not path.name.startswith("log.") and path != case/"lock"}


def refused(what, case, sentence, *command, ranks=1):
    """The run ends with an error within a minute, with this sentence in one line, and writes nothing."""
    before = files(case)
    run = case.run(*command or ("demPimpleFoam",), ranks=ranks, log="log.refused", limit=60)
    written = files(case) - before
    claim(f"{what}: fails and says '{sentence}'", run.status not in (0, 124) and not written
          and not re.search("sigFpe|sigSegv", run.log) and re.search(sentence, run.log, re.M),
          f"status {run.status}, wrote {sorted(written)}", *run.log.splitlines()[-12:])


def reported(what, case, sentence, *command):
    """Not a mistake, but the log must report it."""
    run = case.run(*command or ("demPimpleFoam",), log="log.reported")
    claim(f"{what}: runs and says '{sentence}'",
          re.search("^End", run.log, re.M) and re.search(sentence, run.log, re.M), *run.log.splitlines()[-12:])


def changed(check, what, case, sentence, changes, *command, **options):
    """Check a run whose file has these changes, (expression, replacement), and take them back."""
    good = case.read(scene)
    for pattern, to in changes:
        case.sub(scene, pattern, to)
    check(what, case, sentence, *command, **options)
    case.write(scene, good)


def coupling(entries):
    """The change that adds these entries to coupling."""
    return "^ *rho .*", rf"\g<0> {entries}"


def before(block, entries):
    """The change that puts these entries before a block of the scene."""
    return f"^{block}", rf"{entries}\n{block}"


def at_rest(case, time):
    """The 1500 particles of the hydrostatic bed, on all ranks, have velocities of round-off."""
    U = np.vstack([case.field(folder/"U").reshape(-1, 3)
                   for folder in case.path.glob(f"processor*/{time}/lagrangian/particles")])
    return len(U) == 1500 and largest(U) < 1e-8


# ---- the solver ------------------------------------------------------------------------------------

case = Case("solver", "hydrostatic")
case.edit(control, endTime=0.002, writeInterval=1)
case.run("decomposePar")
claim_runs("the case without a slip runs", case)
claim_runs("the case without a slip runs on two ranks", case, ranks=2)

steel = ("neutral {[^}]*}", r"\g<0> steel { density 7800; youngsModulus 1e5; }")
# two centers in a cube of 0.5 mm are never 1 mm apart
packing = before("insert", "insert { crowd { type random; count 2; diameter 1e-3;"
                           " min (0 0 0); max (1.5e-3 1.5e-3 1.5e-3); } }")
smoothing = "is a setting of the smoothing"
slips = [                                             # what, sentence, changes
    ("no density", "add rho", ("^ *rho .*", "")),
    ("unknown effect", "hertz", ("hertz", "herz")),
    ("misspelt setting", "restitution", ("restitution", "restituton")),
    ("misspelt word in coupling", "width", ("width", "widht")),
    ("unknown kernel", "kernel", ("diffusion", "difusion")),
    *((f"the kernel {other} of another code", f'unknown kernel "?{other}"?; did you mean {own}',
       ("diffusion", other), ("width.*", ""))
      for other, own in (("dividedVoidFraction", "divided"), ("bigParticle", "divided"), ("gaussianKernel", "gaussian"),
                         ("centre", "particleCentre"), ("trilinear", "linear"))),
    *((f"the entry {other} of another code", f'unknown entry "{other}"; did you mean {own}\\?',
       coupling(f"{other} some;"))
      for other, own in (("voidfractionModel", "kernel"), ("voidFractionModel", "kernel"), ("modelType", "equations"))),
    ("the entry couplingInterval of another code", 'unknown entry "couplingInterval"; .*deltaT of system/controlDict',
     coupling("couplingInterval 50;")),
    ("an unknown base", "base.*linear", ("diffusion;", "diffusion; base linaer;")),
    ("width without smoothing", f"coupling/width {smoothing}", ("diffusion", "linear")),
    ("base without smoothing", f"coupling/base {smoothing}", ("diffusion;", "linear; base linear;"), ("width.*", "")),
    ("a diameter without smoothing", f"coupling/diameter {smoothing}",
     ("diffusion;", "linear; diameter 1e-3;"), ("width.*", "")),
    ("lawWidth without smoothing", f"coupling/lawWidth {smoothing}",
     ("diffusion;", "linear; lawWidth 1;"), ("width.*", "")),
    ("lawWidth above the width", "coupling/lawWidth is 4; give a number from 0, for none, to the width, 3", ("diffusion;", "diffusion; lawWidth 4;")),
    ("width of spheres", f"coupling/width {smoothing}", ("diffusion", "divided")),
    ("a Gaussian without width", "coupling/width 0 is no width for kernel gaussian",
     ("diffusion", "gaussian"), ("width .*", "width 0;")),
    ("a Gaussian as a base", "base.*linear", ("diffusion;", "diffusion; base gaussian;")),
    ("a Gaussian with a base", f"coupling/base {smoothing}", ("diffusion;", "gaussian; base linear;")),
    ("a viscosity that the solver has", "nu comes from", coupling("nu 1e-6;")),
    ("gravity twice, not the same", "one place only",
     ("pressureGradient {}", r"\g<0> gravity { acceleration (0 0 -9); }")),
    *((f"a least void fraction of {e}",
       f"coupling/minVoidFraction is {e}; give a number above 0 and below 1",
       coupling(f"minVoidFraction {e};")) for e in (0, 1)),
    ("driven particles", "driven particles, which the balances of a coupled run",
     ("count 1500;", r"\g<0> driven yes;")),
    ("prescribed forces", "the scene has forces, which the balances of a coupled run",
     before("insert", "forces { pull { ids (0); force (0 0 1e-3); } }")),
    ("clumps with added mass", "shapes: .*virtualMass acts on single spheres", ("pressureGradient {}", r"\g<0> virtualMass {}"),
     before("insert", "shapes { pair { spheres ((0 0 0 1e-4) (1e-4 0 0 1e-4)); } }")),
    ("an unknown set of equations", 'unknown equations "?IV', coupling("equations IV;")),
    *((f"model {other} of another code", f'unknown equations "{other}"; did you mean {own}, model {other}\\?',
       coupling(f"equations {other};")) for other, own in (("A", "II"), ("Bfull", "I"), ("B", "III"))),
    ("equations of a fluid that feels nothing", "equations says how the fluid feels.*twoWay no",
     coupling("equations II; twoWay no;")),
    *((f"{effect} in set III", f"Equations III hold.*{effect}", ("pressureGradient {}", rf"\g<0> {effect} {{}}"),
       coupling("equations III;")) for effect in ("virtualMass", "viscousStress")),
    *((f"no pressureGradient in set {equations}", f"Equations {equations} need pressureGradient",
       ("pressureGradient {}", ""), coupling(f"equations {equations};")) for equations in ("I", "II", "III")),
    ("a budget or none", "budget", coupling("record { interval 1; budget maybe; }")),
    ("a budget of a fluid that feels nothing", "record/budget is yes, but twoWay is no.*twoWay yes",
     coupling("twoWay no; record { interval 1; budget yes; }")),
    ("a misspelt word in record", "bugdet.*budget", coupling("record { interval 1; bugdet yes; }")),
    ("the mixture's flux through an unknown patch", "mixtureFlux.*nowhere", coupling("mixtureFlux (nowhere);")),
    ("the mixture's flux through a wall", "mixtureFlux names patch walls, a wall without flow.*name inlets or outlets",
     coupling("mixtureFlux (walls);")),
    ("copies or none", "lastGood", coupling("lastGood maybe;")),
    ("a misspelt word for copies", "lastGod.*lastGood", coupling("lastGod yes;")),
    ("a fluid in the scene", "take out fluid", before("coupling", "fluid { density 1; viscosity 1; }")),
    ("two materials, and walls without one", "What is wall walls made of", steel),
    ("a patch without a material, of two", "walls/top misses its material.*neutral.*steel",
     steel, before("insert", "walls { walls { material steel; } top {} }")),
    ("a misspelt patch", "walls/tob .*did you mean top. known: top, walls(?!,)",
     before("insert", "walls { tob { material neutral; } }")),
    ("a misspelt patch of type patch", "walls/tob .*did you mean top",
     before("insert", "walls { tob { type patch; material neutral; } }")),
    ("a wall that is no dictionary", "walls/top is not a dictionary", before("insert", "walls { top neutral; }")),
    ("a patch with a place", "walls/top .*Take out point",
     before("insert", "walls { top { type patch; point (0 0 0); } }")),
    ("wear of a plane", "wall chute has no triangles, whose wear could be summed",
     before("insert", "walls { chute { type plane; material neutral; point (0 0 -1); normal (0 0 1);"
                      " wear { coefficient 1; hardness 1; } } }")),
    ("a temperature of a patch without heat",
     "unknown entry .temperature. in walls/top; it acts only with .* conduction, .*radiation",
     before("insert", "walls { top { type patch; temperature { value 300; } } }")),
    ("a misspelt patch in coupling", "coupling/walls.*did you mean top", coupling("walls ( tob );")),
    ("a pattern in coupling that matches no patch", "coupling/walls.*matches no patch.*walls top",
     coupling('walls ( "to[b]" );')),
    ("walls of an unknown material", "steal", before("insert", "walls { walls { material steal; } }")),
    ("a pattern for walls that matches no patch", "matches no patch",
     before("insert", 'walls { "sids.*" { material neutral; } }')),
    ("a packing without room", "2 of 2 particles still overlap", packing),
    ("means of no time, before a packing without room", "interval 0 s; give a time above 0",
     packing, before("coupling", "averages { a { min (0 0 0); max (1 1 1); interval 0; } }")),
    ("a misspelt entry, before a packing without room", "avarages.*averages",
     packing, before("coupling", "avarages { }")),
    ("a snapshot that is not there", "nothere", before("insert", 'start { snapshot "nothere"; }')),
    ("particles outside the mesh", "outside", (r"max \(0.02 0.02 0.02\)", "max (0.02 0.02 0.03)")),
]
if os.environ.get("WM_LABEL_SIZE", "32") != "64":
    slips.append(("an id beyond 31 bits", "Particle id 2147483648 does not fit .*up to 2147483647",
                  (r"^    grains(.|\n)*?\); }", "    one { type list; material neutral; diameter 1e-3;"
                   " positions ((0.01 0.01 0.01)); ids (2147483648); }")))
on_two_ranks = ["no density", "a misspelt patch", "particles outside the mesh"]
if thorough:
    on_two_ranks += ["unknown effect", "a viscosity that the solver has", "an unknown set of equations",
                     "no pressureGradient in set II"]
for what, sentence, *changes in slips:
    changed(refused, what, case, sentence, changes)
    if what in on_two_ranks:
        changed(refused, f"{what}, two ranks", case, sentence, changes, ranks=2)

changed(reported, "entries of the program dem", case, "not read.*write time/end.*controlDict",
        [before("coupling", r"write { interval 1; }\ntime { end 1; }")])
changed(reported, "a patch without a material, of one", case, "1500 particles, 2 walls",
        [before("insert", "walls { top {} }")])
changed(reported, "a patch of type patch", case, "1500 particles, 2 walls",
        [before("insert", "walls { top { type patch; } }")])
reported("gravity", case, r"gravity \(0 0 -9.81\) m/s2 from constant/g")
(case/"constant/g").rename(case/"g")
reported("no gravity", case, "no gravity: neither constant/g nor effects/gravity")
(case/"g").rename(case/"constant/g")

(case/scene).rename(case/"scene")
refused("no file", case, "demProperties")
(case/"scene").rename(case/scene)
nu = case.read(transport)
for value, shown in ((-1e-6, "-0.001"), (0, "0")):
    case.edit(transport, nu=value)
    refused(f"nu {value}", case, f"viscosity of the fluid is {shown} Pa s; it must be positive")
case.write(transport, nu)
case.sub(transport, "^nu .*", r"\g<0> rho 900;")
refused("two densities", case, "one place only")
case.write(transport, nu)
for step in (-1e-3, 0):
    case.edit(control, deltaT=step)
    refused(f"deltaT {step}", case, "deltaT is .* s; give a time step above 0")
if thorough:
    refused("deltaT 0, two ranks", case, "deltaT is .* s; give a time step above 0", ranks=2)
case.edit(control, deltaT=0.001)
for scheme in ("backward", "CrankNicolson 0.9"):
    case.sub("system/fvSchemes", r"\bEuler;", f"{scheme};")
    refused(f"ddtSchemes {scheme}", case,
            f"ddtSchemes of system/fvSchemes is {scheme.split()[0]}; .* needs Euler")
    case.sub("system/fvSchemes", rf"\b{scheme};", "Euler;")
for kind, sentence, entries in (
        ("buoyancyForce", "gravity would act twice", "fields (U);"),
        ("tabulatedAccelerationSource", "an acceleration that the particles would not feel",
         'timeDataFileName "constant/frame"; fields (U);')):
    case.write("constant/frame", "(" + "".join(f"({t} ((5 0 0) (0 0 0) (0 0 0)))" for t in (0, 1)) + ")")
    case.dictionary("constant/fvOptions", f"s {{ type {kind}; selectionMode all; {entries} }}")
    refused(f"fvOptions with {kind}", case, sentence)
case.remove("constant/fvOptions")
for value, shown in ((40, "is 40"), (0, "is 0"), (-1, "is -1")):
    case.dictionary("0/voidFraction", "dimensions [0 0 0 0 0 0 0]; internalField uniform 1; boundaryField { walls { "
                    f"type zeroGradient; }} top {{ type fixedValue; value uniform {value}; }} }}", "volScalarField")
    refused(f"a void fraction of {value} at a patch", case,
            f"voidFraction of patch top in .*/0/voidFraction. {shown}; give")
case.dictionary("0/voidFraction", "dimensions [0 1 0 0 0 0 0]; internalField uniform 1; "
                'boundaryField { ".*" { type zeroGradient; } }', "volScalarField")
refused("a void fraction in metres", case, r"voidFraction\" has dimensions \[0 1 0 0 0 0 0\]; give \[0 0 0 0 0 0 0\]")
case.remove("0/voidFraction")
solution = case.read("system/fvSolution")
for name, n, least in (("nOuterCorrectors", 0, 1), ("nCorrectors", 0, 1), ("nNonOrthogonalCorrectors", -1, 0)):
    case.sub("system/fvSolution", f"{name} [0-9]", f"{name} {n}")
    refused(f"{name} {n}", case, f"{name} in PIMPLE of system/fvSolution is {n}; give {least} or more")
    case.write("system/fvSolution", solution)
case.append(control, 'functions { particles { type demCloud; libs ("libdemCoupling.so"); } }\n')
refused("the solver's particles and a function object's", case, "has particles already")

# ---- a shelf, both sides of which have the same points -----------------------------------------------

case = Case("baffle", "hydrostatic")
case.edit(control, endTime=0.001, writeInterval=1)
case.sub(scene, "count 1500", "count 100")
case.sub(scene, r"max \(0.02 0.02 0.02\)", "max (0.02 0.02 0.007)")
case.dictionary("system/createBafflesDict", """internalFacesOnly true;
baffles { shelf { type searchableSurface; surface plate; origin (0 0 0.008); span (0.012 0.02 0);
                  patches { master { name shelf; type wall; } slave { name shelf; type wall; } } } }""")
(case/"0").rename(case/"0.held")                       # createBaffles rewrites its fields
case.run("createBaffles", "-overwrite")
case.remove("0")
(case/"0.held").rename(case/"0")
for field in "Up":
    case.sub(f"0/{field}", "^ *walls ", '"(walls|shelf)" ')
shared = re.compile(r"patch shelf: both sides of a baffle share their points \(15 faces\).*mergeOrSplitBaffles -split")
run = case.run("demPimpleFoam", "-plan")
claim("a baffle whose sides share their points is reported", run and shared.search(run.log),
      *run.log.splitlines()[-12:])
# one side on each rank
case.dictionary("constant/cellRanks", f"125 ({'0 '*50}{'1 '*75})", "labelList")
case.dictionary("system/decomposeParDict", 'numberOfSubdomains 2; method manual; coeffs { dataFile "cellRanks"; }')
case.run("decomposePar")
run = case.run("demPimpleFoam", "-plan", ranks=2)
claim("a baffle whose sides share their points is reported on two ranks", run and shared.search(run.log),
      *run.log.splitlines()[-12:])
case.run("mergeOrSplitBaffles", "-split", "-overwrite")
run = case.run("demPimpleFoam", "-plan")
claim("and not after mergeOrSplitBaffles", run and "both sides" not in run.log, *run.log.splitlines()[-12:])

# ---- the function object ---------------------------------------------------------------------------

cavity = Path(os.environ.get("FOAM_TUTORIALS", ""))/"incompressible/icoFoam/cavity/cavity"
if cavity.is_dir():
    case = Case("cavity", cavity)
    (case/control).rename(case/"system/controlDict.stock")
    case.copy("stock/cavity/controlDict", control)
    case.copy("stock/cavity/demProperties", scene)
    case.copy("shared/system/decomposeParDict", "system/decomposeParDict")    # some versions have one of 9 ranks
    case.edit(control, endTime=0.01)
    case.run("blockMesh")
    case.run("decomposePar")
    claim_runs("the cavity without a slip runs", case, "icoFoam")
    ranks_and_name = ((1, ""), (2, ", two ranks"))
    for ranks, on in ranks_and_name if thorough else ranks_and_name[:1]:
        changed(refused, f"unknown effect in a function object{on}", case, "hertz", [("hertz", "herz")],
                "icoFoam", ranks=ranks)
    changed(refused, "viscosity that the solver has", case, "take it out", [coupling("nu 1e-6;")], "icoFoam")
    changed(refused, "equations of a solver that has its own", case, "equations is for demPimpleFoam",
            [("twoWay .*", "equations I;")], "icoFoam")
    # icoFoam reaches the end of its first step
    for ranks, on in ranks_and_name:
        changed(refused, f"two-way in a solver that never asks{on}", case, "does not call fvOptions",
                [("twoWay .*", "")], "icoFoam", ranks=ranks)
    case.dictionary("constant/fvOptions", "s { type buoyancyForce; selectionMode all; fields (U); }")
    run = case.run("icoFoam", log="log.reported")
    claim("one-way in a solver without sources: fvOptions is not read",
          re.search("^End", run.log, re.M) and "fvOptions" not in run.log, *run.log.splitlines()[-12:])
    case.remove("constant/fvOptions")
    (case/scene).rename(case/"scene")
    for ranks, on in ranks_and_name:
        refused(f"no file for a function object{on}", case, "demProperties", "icoFoam", ranks=ranks)
    (case/"scene").rename(case/scene)

    good = case.read(control)
    for entry in ("executeControl writeTime", "executeInterval 2", "triggerStart 1"):
        case.sub(control, "libs", f"{entry}; libs")
        refused(f"a function object with {entry}", case, "Take out executeControl", "icoFoam")
        case.write(control, good)
    case.sub(control, "libs", "executeControl timeStep; executeInterval 1; libs")
    reported("each step said in words", case, "400 particles, ", "icoFoam")
    case.write(control, good)
    reported("looking at results", case, "particles stay as they are", "icoFoam", "-postProcess")
    claim("-postProcess writes no particles", not list(case.path.rglob("dem.snapshot")))

# ---- repeated starts -------------------------------------------------------------------------------

case = Case("again", "hydrostatic")
case.edit(control, endTime=0.002, writeInterval=0.001)
case.run("demPimpleFoam")
case.copy(case/"0.002", "first")
case.run("demPimpleFoam")
positions = "lagrangian/particles/positions"
claim("a second run in the same folders has the same results",
      agrees(case/"first"/positions, case/"0.002"/positions))

# 0.003 is run from 0.002
case.edit(control, startFrom="latestTime", endTime=0.003)
changed(refused, "a snapshot of other materials", case, 'dem.snapshot: unknown material "neutral".*known: wax',
        [("neutral", "wax")])
changed(refused, "a snapshot of another density", case, "density 1000 kg/m3, the scene says 900",
        [("density 1000", "density 900")])

# a time of a coupled run that lacks a part: no fresh start in the middle of a run
uniform, aside = case/"0.002/uniform", case/"aside"
(case/"0.001").rename(aside)
parts = {uniform/"dem.snapshot": case/"dem.snapshot", case/"0.002/lagrangian": case/"lagrangian",
         uniform/"dem.kernel": case/"dem.kernel", uniform/"lagrangian": case/"properties"}
for what, (part, away), found in zip(
        ("a time with positions, but without the snapshot",
         "a time with the numbers of the coupling, but without the snapshot",
         "a time with the cloud's properties, but without the snapshot"), parts.items(),
        ("lagrangian/particles.*, but no snapshot uniform/dem.snapshot", "uniform/dem.kernel.*, but no snapshot",
         "uniform/lagrangian/particles.*, but no snapshot")):
    part.rename(away)
    refused(what, case, f"Time 0.002 has particles .*{found}")
(uniform/"lagrangian").rename(case/"properties")
reported("a time of the fluid alone", case,
         "fluid of time 0.002 was computed without particles; they begin here")
case.remove("0.003")
for part in (uniform/"dem.snapshot", case/"0.002/lagrangian", uniform/"lagrangian"):
    parts[part].rename(part)
refused("a snapshot without its numbers", case,
        "no file .*0.002/uniform/dem.kernel.?, which belongs to the snapshot")
case.copy(aside/"uniform/dem.kernel", "0.002/uniform/dem.kernel")
case.copy(aside/"uniform/dem.snapshot", "0.002/uniform/dem.snapshot")
refused("snapshot and numbers of another time", case,
        "dem.snapshot is of time 0.001 s, but the run starts at 0.002 s.*start . snapshot <file>")
(case/"dem.kernel").rename(uniform/"dem.kernel")
refused("a snapshot of another time", case, "dem.snapshot is not the snapshot that was written here: "
        "its fingerprint is [0-9a-f]+, .* says [0-9a-f]+")
case.copy(case/"first/uniform/dem.snapshot", "0.002/uniform/dem.snapshot")
aside.rename(case/"0.001")
claim_runs("the complete time continues", case)
case.remove("0.003")

(uniform/"dem.snapshot").unlink()
refused("a time without its particles", case, "Time 0.002 has particles .* no snapshot")
case.remove("0.002/lagrangian", "0.002/uniform/lagrangian", "0.002/uniform/dem.kernel")
refused("a time of the fluid alone, after one with particles", case,
        "Time 0.002 has no particles .*remove this time.s folder 0.002 and start again from 0.001")
for folder in ("lagrangian", "uniform"):
    case.copy(case/"first"/folder, f"0.002/{folder}")
os.truncate(uniform/"dem.snapshot", 100000)
refused("a snapshot cut short", case, "dem.snapshot is damaged")
case.copy(case/"first/uniform/dem.snapshot", "0.002/uniform/dem.snapshot")
case.run("decomposePar", "-latestTime")
refused("more ranks than folders", case,
        "number of processor directories = 2|is not equal to the number of ranks", ranks=3)
claim_runs("from one rank to two", case, ranks=2)
claim("from one rank to two the particles stay at rest", at_rest(case, 0.003))

case.edit("system/decomposeParDict", numberOfSubdomains=4)
case.sub("system/decomposeParDict", r"\( 2 1 1 \)", "( 4 1 1 )")
case.edit(control, endTime=0.004)
case.run("reconstructPar", "-latestTime")
case.remove("processor*")
case.run("decomposePar", "-time", "0.002:0.003")
claim_runs("from two ranks to four", case, ranks=4)
claim("from two ranks to four the particles stay at rest", at_rest(case, 0.004))
case.remove("processor*/0.004", "processor0/0.003/uniform/dem.snapshot")
refused("a time without its particles, four ranks", case, "Time 0.003 has particles .* no snapshot", ranks=4)
case.remove("processor[012]/0.003/lagrangian", "processor*/0.003/uniform/dem.kernel",
            "processor*/0.003/uniform/lagrangian")
refused("a time with particles on the last of four ranks only", case,
        "Time 0.003 has particles .*lagrangian/particles.* no snapshot", ranks=4)
case.remove("processor*/0.003/lagrangian")
refused("a time of the fluid alone, after one with particles, four ranks", case,
        "Time 0.003 has no particles .*folders processor./0.003 and start again from 0.002", ranks=4)

# ---- the particles' reaction twice, or in a zone ------------------------------------------------------

case = Case("twice", "hydrostatic")
case.append(control, 'functions { particles { type demCloud; libs ("libdemCoupling.so"); } }\n')
source = 'type demMomentumSource; libs ("libdemCoupling.so");'
case.dictionary("constant/fvOptions", f"a {{ {source} }} b {{ {source} }}")
refused("two momentum sources", case, r"fvOptions has 2 sources of type demMomentumSource .*\(a b\)", "pimpleFoam")
case.dictionary("constant/fvOptions", f"a {{ {source} selectionMode cellZone; cellZone all; }}")
refused("a momentum source in a zone", case, "fvOptions/a has a selectionMode", "pimpleFoam")
finish()
