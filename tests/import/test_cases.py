"""test_cases.py FOLDER -- `dem import` of coupled cases: each word of OpenFOAM's clouds and of
CFDEMcoupling has its place in the result, or a sentence with file, line and word. Prints TAP.

The cases are our own, as text below; a test changes a word and checks the result.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import gzip
import math
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy
from scipy.integrate import solve_ivp
from scipy.special import erfinv

from suna_import import cfdem, cfdem_models, cloud, cloud_injection, cloud_models, cloud_sizes
from suna_import.foam_reader import read_dictionary
from suna_import.liggghts_mesh import read_triangles, write_stl
from suna_import.mesh_patches import read_patches
from suna_import.mesh_surfaces import distance, samples
from suna_import.report import APPROXIMATED, HARMLESS, TRANSLATED, CannotTranslate, Report
from tap import finish, run_tests, skip

WORK = Path(sys.argv[1])/"cases"

HEAD = "FoamFile { version 2.0; format ascii; class %s; object %s; }\n"

SYSTEM = {
    "system/controlDict": """
application DPMFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 2e-3; deltaT 1e-3;
writeControl timeStep; writeInterval 2; timeFormat general; timePrecision 6;
""",
    "system/fvSchemes": """
ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes { default none; div(alphaPhi.air,U.air) Gauss upwind; div(phi,U) Gauss upwind; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
""",
    "system/fvSolution": """
solvers
{
    "(p|pFinal)" { solver PCG; preconditioner DIC; tolerance 1e-8; relTol 0; }
    "U.air.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-8; relTol 0; }
}
PISO { nCorrectors 3; pRefCell 0; pRefValue 0; }
""",
    "system/blockMeshDict": """
scale 0.01;
vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 4) (1 0 4) (1 1 4) (0 1 4));
blocks (hex (0 1 2 3 4 5 6 7) (2 2 8) simpleGrading (1 1 1));
edges ();
boundary
(
    inlet { type patch; faces ((0 3 2 1)); }
    outlet { type patch; faces ((4 5 6 7)); }
    sides { type wall; faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); }
);
""",
    "constant/g": "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n",
    "constant/transportProperties": """
continuousPhase air; rho.air 1.2; rhoInf 1.2; transportModel Newtonian; nu nu [0 2 -1 0 0 0 0] 1.5e-5;
""",
    "constant/turbulenceProperties": "simulationType laminar;\n",
}
FIELDS = {
    "0/U.air": """
dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField
{
    inlet { type interstitialInletVelocity; inletVelocity uniform (0 0 0.1); phi phi.air;
            alpha alpha.air; value $internalField; }
    outlet { type zeroGradient; }
    sides { type noSlip; }
}
""",
    "0/p": """
dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField
{
    inlet { type zeroGradient; }
    outlet { type fixedValue; value $internalField; }
    sides { type zeroGradient; }
}
""",
}
CLOUD = """
solution
{
    active true; coupled true; transient yes; cellValueSourceCorrection off;
    interpolationSchemes { rho.air cell; U.air cellPoint; mu.air cell; }
    integrationSchemes { U Euler; }
    sourceTerms { schemes { U semiImplicit 1; } }
}
constantProperties { rho0 2526; youngsModulus 1e7; poissonsRatio 0.35; alphaMax 0.9; }
subModels
{
    particleForces
    {
        ErgunWenYuDrag { alphac alpha.air; }
        gravity;
    }
    injectionModels
    {
        model1
        {
            type manualInjection; massTotal 0; parcelBasisType fixed; nParticle 1; SOI 0;
            positionsFile "positions"; U0 (0 0 -0.1);
            sizeDistribution { type fixedValue; fixedValueDistribution { value 0.002; } }
        }
    }
    dispersionModel none;
    patchInteractionModel localInteraction;
    localInteractionCoeffs
    {
        patches ( sides { type rebound; e 0.97; mu 0.09; } inlet { type rebound; } outlet { type escape; } );
    }
    surfaceFilmModel none;
    collisionModel pairCollision;
    pairCollisionCoeffs
    {
        maxInteractionDistance 0.002;
        pairModel pairSpringSliderDashpot;
        pairSpringSliderDashpotCoeffs
        {
            useEquivalentSize no; alpha 0.12; b 1.5; mu 0.52; cohesionEnergyDensity 0;
            collisionResolutionSteps 12;
        };
        wallModel wallSpringSliderDashpot;
        wallSpringSliderDashpotCoeffs
        {
            useEquivalentSize no; collisionResolutionSteps 12; youngsModulus 1e10; poissonsRatio 0.23;
            alpha 0.01; b 1.5; mu 0.43; cohesionEnergyDensity 0;
        };
    }
}
cloudFunctions { }
"""
POSITIONS = "(\n(0.003 0.003 0.004)\n(0.007 0.007 0.004) // two\n(5e-3 5e-3 9e-3)\n)\n"


# ---- helpers -------------------------------------------------------------------------------------

def write_case(folder, files):
    shutil.rmtree(folder, ignore_errors=True)
    for name, text in files.items():
        path = folder/name
        path.parent.mkdir(parents=True, exist_ok=True)
        kind = {"U.air": "volVectorField", "U": "volVectorField", "positions": "vectorField",
                "g": "uniformDimensionedVectorField"}.get(
                    path.name, "volScalarField" if path.parent.name == "0" else "dictionary")
        path.write_text(text if name.startswith("DEM") else HEAD % (kind, path.name) + text)


def changed(text, changes):
    for old, new in changes.items():
        assert old in text, f"the text has no {old!r}"
        text = text.replace(old, new, 1)
    return text


def cloud_case(**more):
    """A case of DPMFoam. Keywords: cloud, control, transport, mesh: {old: new} in that file; files."""
    files = {**SYSTEM, **FIELDS, "constant/kinematicCloudProperties": CLOUD,
             "constant/positions": POSITIONS, **more.pop("files", {})}
    names = {"cloud": "constant/kinematicCloudProperties", "control": "system/controlDict",
             "transport": "constant/transportProperties", "mesh": "system/blockMeshDict"}
    for key, changes in more.items():
        files[names[key]] = changed(files[names[key]], changes)
    write_case(WORK/"source", files)
    shutil.rmtree(WORK/"result", ignore_errors=True)
    report = Report()
    cloud.translate_cloud(WORK/"source", WORK/"result", report)
    return Result(report)


class Result:
    """What a translation wrote."""

    def __init__(self, report):
        self.report = report
        self.text = (WORK/"result/constant/demProperties").read_text()
        self.d = read_dictionary(WORK/"result/constant/demProperties", "demProperties", Report())

    def has(self, kind, *words):
        """Is there a row of the report of this kind with these words?"""
        return any(all(word in f"{row.place} {row.word}: {row.text}" for word in words)
                   for row in self.report.of(kind))


def refused(translate, file, line, *words):
    """The translation ends with a sentence that names file, line and words."""
    try:
        translate()
    except CannotTranslate as error:
        where = f"{file}:{line}:" if line else file
        assert str(error).startswith(where), str(error)
        assert all(word in str(error) for word in words), str(error)
        return
    raise AssertionError(f"nothing was refused; expected {words}")


def line_of(text, word, header=1):
    """Line of the word in a file that HEAD precedes."""
    return text[:text.index(word)].count("\n") + 1 + header


# ---- the reader ----------------------------------------------------------------------------------

def syntax():
    """patterns, macros, includes, lists, code, dimensions and compressed files are read as OpenFOAM does"""
    folder = WORK/"syntax"
    folder.mkdir(parents=True, exist_ok=True)
    (folder/"inner").write_text('a 2; sub { y 3; }\n')
    with gzip.open(folder/"packed.gz", "wt") as file:
        file.write("q 7;\n")
    (folder/"file").write_text("""// comment ; with { signs
a 1; sub { x 1; "k.*" { z 9; } }
#include "inner"
#include "packed"
b $a; c ${sub.x}; d { $sub; e $..a; f $:b; } /* over
lines */ nu nu [0 2 -1 0 0 0 0] 1.5e-4; flag;
list 3 ( (1 2 3) word "two words" ); cells (hex (0 1) (2 3)); names ( top { type wall; } );
div(phi,U) Gauss linear; code #{ int i; } ; #}; x { } ;
""")
    d = read_dictionary(folder/"file", "file", Report())
    assert d.number("a") == 2 and d.number("b") == 2 and d.number("c") == 1 and d.number("q") == 7
    assert d.sub("sub").number("x") == 1 and d.sub("sub").number("y") == 3
    assert d.sub("d").number("y") == 3 and d.sub("d").number("e") == 2 and d.sub("d").number("f") == 2
    assert d.sub("sub").sub("kOmega").number("z") == 9 and "other" not in d.sub("sub")
    assert d.number("nu") == 1.5e-4 and d.switch("flag", False) and d.list("list")[2] == "two words"
    assert d.list("cells")[1:] == [["0", "1"], ["2", "3"]] and d.word("div(phi,U)") == "linear"
    assert d.list("names")[1].word("type") == "wall"
    assert str(d.where("nu")) == "file:6" and str(d.where("y")).startswith("file:")
    assert [e.name for e in d.unread()] == ["code", "x"], [e.name for e in d.unread()]
    for text, line, word in (("a { b 1; ", 1, "}"), ("\na 1\nb", 3, ";"), ("a (1 2;", 1, ")")):
        (folder/"bad").write_text(text)
        refused(lambda: read_dictionary(folder/"bad", "bad", Report()), "bad", line, word)
    (folder/"bad").write_text("\n\na #calc \"1 + 1\";")
    refused(lambda: read_dictionary(folder/"bad", "bad", Report()).number("a"), "bad", 3, "no number")


def meshes():
    """patches have the corners of their faces, from blockMeshDict and from constant/polyMesh"""
    write_case(WORK/"mesh", {**SYSTEM, "system/blockMeshDict": """
convertToMeters 2;
vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));
blocks (hex (0 1 2 3 4 5 6 7) (1 1 1) simpleGrading (1 1 1));
edges (arc 0 1 (0.5 -0.2 0));
patches (patch in ((0 3 2 1)) wall sides ((0 1 5 4) (1 2 6 5)));
"""})
    patches = read_patches(WORK/"mesh", Report())
    assert {p.name: (p.type, len(p.faces)) for p in patches.values()} == {
        "in": ("patch", 1), "sides": ("wall", 2), "defaultFaces": ("empty", 3)}
    assert [-0.4 in face[:, 1] for face in patches["sides"].faces] == [True, False]
    (WORK/"mesh/constant/polyMesh").mkdir()
    for name, text in (("points", "3((0 0 0)(1 0 0)(0 1 2e0))"), ("faces", "1(3(0 1 2))"),
                       ("boundary", "1( floor { type wall; nFaces 1; startFace 0; } )")):
        (WORK/"mesh/constant/polyMesh"/name).write_text(HEAD % ("list", name) + text)
    patches = read_patches(WORK/"mesh", Report())
    assert patches["floor"].points.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 2]]


# ---- clouds --------------------------------------------------------------------------------------

def dpm():
    """a case of DPMFoam becomes one of demPimpleFoam, with its lines"""
    result = cloud_case()
    d, line = result.d, line_of(CLOUD, "rho0")
    assert f"// constant/kinematicCloudProperties:{line}" in result.text
    material = d.sub("materials").sub("particles")
    assert (material.number("density"), material.number("youngsModulus")) == (2526, 1e7)
    assert d.sub("materials").sub("wall").number("youngsModulus") == 1e10
    assert d.sub("effects").sub("gidaspow").word("blend") == "switch"
    assert d.sub("effects").sub("mindlin").number("friction") == 0.52
    assert abs(d.sub("effects").sub("dry").number("restitution") - 0.84466) < 1e-4
    assert result.has("translated", "restitution", "on walls"), result.report.of("translated")
    assert d.sub("pairs").sub("wallContact").sub("mindlin").number("friction") == 0.43
    assert d.sub("walls").sub("sides").word("material") == "wall"
    assert "inlet" in d.sub("walls") and d.sub("outlets").sub("outlet").word("patch") == "outlet"
    coupling = d.sub("coupling")
    assert coupling.number("rho") == 1.2 and coupling.word("equations") == "III"
    assert abs(coupling.number("minVoidFraction") - 0.1) < 1e-12 and coupling.word("kernel") == "linear"
    group = d.sub("insert").sub("model1")
    assert group.number("diameter") == 0.002 and group.vector("velocity") == (0, 0, -0.1)
    assert [[float(x) for x in v] for v in group.list("positions")] == [
        [0.003, 0.003, 0.004], [0.007, 0.007, 0.004], [0.005, 0.005, 0.009]]
    velocity = read_dictionary(WORK/"result/0/U", "U", Report()).sub("boundaryField").sub("inlet")
    assert velocity.word("type") == "fixedValue" and velocity.vector("value") == (0, 0, 0.1)
    pressure = read_dictionary(WORK/"result/0/p", "p", Report()).sub("boundaryField")
    assert pressure.sub("inlet").word("type") == "fixedFluxPressure"
    assert pressure.sub("sides").word("type") == "zeroGradient"
    assert not (WORK/"result/0/U.air").exists()
    for name in ("controlDict", "fvSchemes", "fvSolution"):
        assert (WORK/f"source/system/{name}").read_bytes() == \
            (WORK/f"result/system/{name}.original").read_bytes()
    schemes = read_dictionary(WORK/"result/system/fvSchemes", "fvSchemes", Report())
    assert schemes.sub("divSchemes").word("div(alphaPhi,U)") == "upwind"
    solution = read_dictionary(WORK/"result/system/fvSolution", "fvSolution", Report())
    assert solution.sub("PIMPLE").number("nCorrectors") == 3
    assert solution.sub("solvers").sub("UFinal").word("solver") == "PBiCGStab"
    assert result.has(HARMLESS, "sourceTerms") and result.has(APPROXIMATED, "kernel linear")


def restitution():
    """alpha has the coefficient of restitution of its equation of motion"""
    for alpha in (0.02, 0.12, 0.5, 1.0):
        touch = lambda t, y: y[0]
        touch.terminal, touch.direction = True, -1
        motion = solve_ivp(lambda t, y: (y[1], -max(y[0], 0)**1.5 - alpha*max(y[0], 0)**0.25*y[1]),
                           (0, 100), (1e-12, 1.0), events=touch, rtol=1e-10, atol=1e-14)
        assert abs(-motion.y[1, -1] - cloud_models.restitution(alpha)) < 1e-4, alpha
    assert cloud_models.restitution(3.0) == 0


def forces():
    """each force of particles has its effect, or a sentence"""
    drag = "ErgunWenYuDrag { alphac alpha.air; }"
    for new, effect in (("WenYuDrag { alphac alpha.air; }", "wenYu"), ("sphereDrag;", "schillerNaumann"),
                        (drag + " virtualMass { U U.air; Cvm 0.4; }", "virtualMass"),
                        (drag + " SaffmanMeiLiftForce { U U.air; }", "saffmanMei"),
                        (drag + " pressureGradient { U U.air; }", "pressureGradient")):
        assert effect in cloud_case(cloud={drag: new}).d.sub("effects"), new
    result = cloud_case(cloud={drag: drag + " virtualMass { U U.air; Cvm 0.4; }"})
    assert result.d.sub("effects").sub("virtualMass").number("coefficient") == 0.4
    line = line_of(CLOUD, drag)
    for name in cloud_models.REFUSED_FORCES:
        refused(lambda: cloud_case(cloud={drag: f"{name} {{ }}"}),
                "constant/kinematicCloudProperties", line, name)
    refused(lambda: cloud_case(cloud={drag: "magic;"}), "constant/kinematicCloudProperties", line, "magic")
    refused(lambda: cloud_case(cloud={drag: drag + " sphereDrag;"}), "constant/kinematicCloudProperties",
            line, "second law of drag")
    result = cloud_case(cloud={"gravity;": ""})
    assert result.has(APPROXIMATED, "without gravity")
    assert read_dictionary(WORK/"result/constant/g", "g", Report()).vector("value") == (0, 0, 0)


def contacts():
    """walls with their own constants, cohesion; other laws are refused"""
    local = """wallModel wallLocalSpringSliderDashpot;
        wallLocalSpringSliderDashpotCoeffs { useEquivalentSize no; collisionResolutionSteps 12;
            "si.*" { youngsModulus 2e9; poissonsRatio 0.2; alpha 0.2; b 1.5; mu 0.1;
                     cohesionEnergyDensity 100; } };"""
    start = CLOUD.index("wallModel wallSpring")
    end = CLOUD.index("};", start) + 2
    result = cloud_case(cloud={CLOUD[start:end]: local})
    d = result.d
    wall = d.sub("walls").sub("sides").word("material")
    assert d.sub("materials").sub(wall).number("youngsModulus") == 2e9
    pair = d.sub("pairs").sub(wall + "Contact")
    assert pair.sub("sjkr").number("energyDensity") == 100
    assert d.sub("effects").sub("sjkr").number("energyDensity") == 0
    for old, new, word in (("b 1.5; mu 0.52", "b 1; mu 0.52", "law of Hertz"),
                           ("useEquivalentSize no; alpha", "useEquivalentSize yes; alpha", "parcels"),
                           ("pairModel pairSpring", "pairModel otherSpring", "otherSpring"),
                           ("wallModel wallSpring", "wallModel noSpring", "noSpring"),
                           ("mu 0.52;", "mu 0.52; shear 3;", "does not know")):
        refused(lambda: cloud_case(cloud={old: new}), "constant/kinematicCloudProperties",
                line_of(CLOUD, old), word)
    refused(lambda: cloud_case(cloud={"collisionModel pairCollision": "collisionModel none"}),
            "constant/kinematicCloudProperties", line_of(CLOUD, "collisionModel pair"), "not DEM")


def patches():
    """rebound, escape, stick and symmetry"""
    result = cloud_case(cloud={"sides { type rebound;": "sides { type stick;",
                               "inlet { type rebound; }": "inlet { type escape; }"})
    assert result.d.sub("walls").sub("sides").switch("absorb", False)
    assert result.has(APPROXIMATED, "stick of sides")
    assert result.d.sub("outlets").sub("inlet").word("patch") == "inlet"
    result = cloud_case(mesh={"sides { type wall; faces ((0 1 5 4)": "sides { type wall; faces (",
                              "inlet {": "plane { type symmetry; faces ((0 1 5 4)); } inlet {"})
    pair = result.d.sub("pairs").sub("symmetryContact")
    assert pair.sub("dry").number("restitution") == 1 and pair.sub("mindlin").number("friction") == 0
    for model in ("none", "rebound", "standardWallInteraction"):
        result = cloud_case(cloud={"patchInteractionModel localInteraction": "patchInteractionModel "
                            + model, "localInteractionCoeffs": "standardWallInteractionCoeffs { type "
                            "rebound; } localInteractionCoeffs"})
        assert ("inlet" in result.d.sub("walls")) == (model == "rebound"), model
        assert ("outlet" in result.d.sub("outlets")) == (model != "rebound"), model
    refused(lambda: cloud_case(cloud={"patchInteractionModel local": "patchInteractionModel multi"}),
            "constant/kinematicCloudProperties", line_of(CLOUD, "patchInteractionModel"), "multi")


def injections():
    """each injection model has its group or stream, or a sentence"""
    start, end = CLOUD.index("type manualInjection"), CLOUD.index("sizeDistribution")
    old, line = CLOUD[start:end], line_of(CLOUD, "type manualInjection")
    size = "sizeDistribution { type fixedValue; fixedValueDistribution { value 0.002; } }"

    def group(new):
        return cloud_case(cloud={old: new})

    result = group("type patchInjection; patch inlet; massTotal 0.2; parcelBasisType mass; duration 4;"
                   " parcelsPerSecond 100; SOI 1; U0 (0 0 1); flowRateProfile constant 1;")
    d = result.d.sub("insert").sub("model1")
    assert (d.word("type"), d.word("patch"), d.number("massRate")) == ("stream", "inlet", 0.05)
    assert (d.number("start"), d.number("end"), d.vector("velocity")) == (1, 5, (0, 0, 1))
    assert result.has(APPROXIMATED, "single particles")
    d = group("type patchInjection; patch inlet; parcelBasisType fixed; nParticle 1; duration 4; "
              "parcelsPerSecond 100; SOI 0; U0 (0 0 1);").d.sub("insert").sub("model1")
    assert d.number("rate") == 100
    result = group("type coneInjection; positionAxis (((0 0 0.01) (0 0 2))); parcelsPerInjector 10; "
                   "massTotal 0.2; parcelBasisType mass; duration 4; SOI 0; Umag 3; thetaInner 0; "
                   "thetaOuter 30; flowRateProfile constant 1;")
    d = result.d.sub("insert").sub("model1")
    v, spread = d.vector("velocity"), d.vector("spread")
    assert abs(spread[0] - 1.5) < 1e-4 and spread[2] == 0 and 2.5 < v[2] < 3
    assert d.sub("disc").number("radius") == 0.002
    d = group("type cellZoneInjection; cellZone bed; numberDensity 1e6; parcelBasisType fixed; "
              "nParticle 1; massTotal 0; SOI 0; U0 (0 0 0);").d.sub("insert").sub("model1")
    assert d.word("zone") == "bed" and abs(d.number("solidFraction") - 1e6*math.pi*8e-9/6) < 1e-9
    for name in cloud_injection.REFUSED_INJECTIONS:
        refused(lambda: group(f"type {name};"), "constant/kinematicCloudProperties", line, name)
    refused(lambda: group("type magic;"), "constant/kinematicCloudProperties", line, "magic")
    for change, word in ((("nParticle 1", "nParticle 750"), "parcels of several particles"),
                         (("SOI 0", "SOI 2"), "from the start"),
                         (('"positions"', '"nowhere"'), "no file")):
        refused(lambda: cloud_case(cloud=dict([change])), "constant/kinematicCloudProperties",
                line_of(CLOUD, change[0]), word)
    result = cloud_case(cloud={old + size: "type none;"})
    assert result.d.sub("start").tokens("snapshot") == ["settled.dem"]
    assert result.has(APPROXIMATED, "no injection")


def distributions():
    """diameters have the distribution from which OpenFOAM draws them"""
    y = (numpy.arange(4000) + 0.5)/4000
    low, high = 1e-3, 3e-3

    def of(kind, text):
        (WORK/"sizes").write_text(f"d {{ type {kind}; {kind}Distribution {{ {text} }} }}")
        return read_dictionary(WORK/"sizes", "sizes", Report()).sub("d")

    limits = f"minValue {low}; maxValue {high};"
    a, b = (math.erf((x - 2e-3)/5e-4) for x in (low, high))
    k = 1 - math.exp(-((high - low)/8e-4)**1.5)
    drawn = {
        ("uniform", limits): low + (high - low)*y,
        ("normal", limits + "expectation 2e-3; variance 5e-4;"): 2e-3 + 5e-4*erfinv(y*(b - a) + a),
        ("RosinRammler", limits + "d 8e-4; n 1.5;"): low + 8e-4*(-numpy.log(1 - y*k))**(1/1.5),
        ("exponential", limits + "lambda 1000;"): -numpy.log(
            math.exp(-1) + y*(math.exp(-3) - math.exp(-1)))/1000,
        # the density rises from 0 at low to high
        ("general", "distribution ((1e-3 0) (3e-3 1));"): low + (high - low)*numpy.sqrt(y),
    }
    for (kind, text), expected in drawn.items():
        found = numpy.sort(cloud_sizes.diameters(of(kind, text), len(y), Report()))
        assert numpy.abs(found - expected).max() < 2e-3*(high - low), kind
    two = "expectation (1.5e-3 2.5e-3); variance (1e-4 1e-4); strength (1 3);"
    found = cloud_sizes.diameters(of("multiNormal", limits + two), 4000, Report())
    assert abs((found < 2e-3).mean() - 0.25) < 1e-3
    assert cloud_sizes.diameters(of("fixedValue", "value 2e-3;"), 9, Report()) is None
    text = cloud_sizes.sizes(of("RosinRammler", limits + "d 8e-4; n 1.5;"), "volume", Report())
    assert "type list; by volume" in text
    normal = cloud_sizes.sizes(of("normal", limits + "expectation 2e-3; variance 5e-4;"), "number",
                               Report())
    assert f"deviation {5e-4/math.sqrt(2):.12g}" in normal
    refused(lambda: cloud_sizes.sizes(of("binned", limits), "number", Report()), "sizes", 1, "binned")


def not_dem():
    """MP-PIC, reacting parcels and steady clouds are refused with the sentence"""
    refused(lambda: cloud_case(cloud={"dispersionModel none": "packingModel implicit; dispersionModel "
                                      "none"}), "constant/kinematicCloudProperties",
            line_of(CLOUD, "dispersionModel"), "MP-PIC", "is not DEM")
    refused(lambda: cloud_case(cloud={"dispersionModel none": "phaseChangeModel liquidEvaporation; "
                                      "dispersionModel none"}), "constant/kinematicCloudProperties",
            line_of(CLOUD, "dispersionModel"), "is not DEM")
    refused(lambda: cloud_case(files={"constant/reactingCloud1Properties": CLOUD}),
            "constant/reactingCloud1Properties", 0, "is not DEM")
    refused(lambda: cloud_case(cloud={"transient yes": "transient no"}),
            "constant/kinematicCloudProperties", line_of(CLOUD, "transient"), "steady")
    refused(lambda: cloud_case(control={"DPMFoam": "sprayFoam"}), "system/controlDict", 3, "sprayFoam")
    refused(lambda: cloud_case(cloud={"surfaceFilmModel none": "surfaceFilmModel thick"}),
            "constant/kinematicCloudProperties", line_of(CLOUD, "surfaceFilm"), "does not know")
    refused(lambda: cloud_case(cloud={"cloudFunctions": "moonPhase 3; cloudFunctions"}),
            "constant/kinematicCloudProperties", line_of(CLOUD, "cloudFunctions"), "moonPhase")
    refused(lambda: cloud_case(cloud={"dispersionModel none": "dispersionModel other"}),
            "constant/kinematicCloudProperties", line_of(CLOUD, "dispersionModel"), "other")
    for model in ("stochasticDispersionRAS", "gradientDispersionRAS"):
        assert "turbulentDispersion" in cloud_case(
            cloud={"dispersionModel none": f"dispersionModel {model}"}).d.sub("effects")


def uncoupled():
    """icoUncoupledKinematicParcelFoam stays the solver, with the function object"""
    name = "icoUncoupledKinematicParcelFoam"
    result = cloud_case(control={"DPMFoam": name}, cloud={"ErgunWenYuDrag { alphac alpha.air; }":
                                                          "sphereDrag;"})
    assert not result.d.sub("coupling").switch("twoWay", True)
    control = read_dictionary(WORK/"result/system/controlDict", "controlDict", Report())
    assert control.word("application") == name
    assert control.sub("functions").sub("particles").word("type") == "demCloud"
    assert (WORK/"result/constant/idleProperties").exists()
    assert result.has(APPROXIMATED, "does not solve for the fluid")
    refused(lambda: cloud_case(control={"DPMFoam": name}, transport={"rhoInf 1.2;": ""}, cloud={
        "ErgunWenYuDrag { alphac alpha.air; }": "sphereDrag;"}), "constant/transportProperties", 1, "rhoInf")


def cloud_runs():
    """the translated cases of DPMFoam and of icoUncoupledKinematicParcelFoam run"""
    for solver, drag in (("DPMFoam", "ErgunWenYuDrag { alphac alpha.air; }"),
                         ("icoUncoupledKinematicParcelFoam", "sphereDrag;")):
        # positions off the walls, on which spheres of 2 mm would lie
        cloud_case(control={"DPMFoam": solver}, cloud={"ErgunWenYuDrag { alphac alpha.air; }": drag})
        if solver != "DPMFoam":
            shutil.move(WORK/"result/0/U.air", WORK/"result/0/U")
            text = (WORK/"result/0/U").read_text()
            (WORK/"result/0/U").write_text(re.sub(r"inlet \{.*?\}", "inlet { type zeroGradient; }", text,
                                                  flags=re.S).replace("U.air", "U"))
        run([solver, "-cloud", "idle"] if solver != "DPMFoam" else ["demPimpleFoam"])


def run(command):
    for words in (["blockMesh"], command):
        done = subprocess.run(words, cwd=WORK/"result", text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)
        assert done.returncode == 0, done.stdout[-1500:]
    steps = re.findall(r"^Suna: (\d+) particles, (\d+) DEM steps", done.stdout, flags=re.M)
    assert len(steps) == 2 and all(int(n) > 0 for _, n in steps), done.stdout[-1500:]


# ---- CFDEMcoupling -------------------------------------------------------------------------------

COUPLING = """
modelType A;
couplingInterval 100;
voidFractionModel divided;
locateModel engine;
meshMotionModel noMeshMotion;
IOModel basicIO;
probeModel off;
dataExchangeModel twoWayMPI;
averagingModel dense;
clockModel off;
smoothingModel off;
forceModels
(
    gradPForce
    viscForce
    KochHillDrag
    Archimedes
    particleCellVolume
);
momCoupleModels
(
    implicitCouple
);
turbulenceModelType turbulenceProperties;
implicitCoupleProps { }
KochHillDragProps { interpolation true; implForceDEM true; }
gradPForceProps { interpolation true; }
viscForceProps { }
ArchimedesProps { }
constDiffSmoothingProps { lowerLimit 0.1; upperLimit 1e10; smoothingLength 2e-3; }
dividedProps { alphaMin 0.3; }
"(engineProps|turboEngineProps)" { treeSearch true; }
"(twoWayMPIProps|M2MProps)" { liggghtsPath "../DEM/in.run"; }
"""
COMMANDS = "liggghtsCommandModels ( runLiggghts writeLiggghts );\nwriteLiggghtsProps { writeLastOnly off; }\n"
DEM = """units           si
atom_style      granular
boundary        f f f
newton          off
communicate     single vel yes
region          reg block 0 0.01 0 0.01 0 0.04 units box
create_box      1 reg
neighbor        0.001 bin
fix  m1 all property/global youngsModulus peratomtype 5.e6
fix  m2 all property/global poissonsRatio peratomtype 0.45
fix  m3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix  m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style      gran model hertz tangential history
pair_coeff      * *
timestep        0.00001
fix  gravi all gravity 9.81 vector 0.0 0.0 -1.0
fix  low all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix  side all wall/gran model hertz tangential history primitive type 1 xplane 0.0
fix  inner all wall/gran model hertz tangential history primitive type 1 yplane 0.009
fix  far all wall/gran model hertz tangential history primitive type 1 zplane 0.05
fix  pipe all wall/gran model hertz tangential history primitive type 1 zcylinder 0.0075 0.005 0.005
"""
INSERT = """region  bc block 0.002 0.008 0.002 0.008 0.002 0.03 units box
fix  pts1 all particletemplate/sphere 15485863 atom_type 1 density constant 2000 radius constant 0.0005
fix  pdd1 all particledistribution/discrete 15485867 1 pts1 1.0
fix  ins all insert/pack seed 32452843 distributiontemplate pdd1 vel constant 0. 0. -1. insert_every once overlapcheck yes all_in yes particles_in_region 30 region bc
"""
RUN = """fix  cfd all couple/cfd couple_every 100 mpi
fix  cfd2 all couple/cfd/force/implicit
fix  integr all nve/sphere
"""
CFD_FIELDS = {
    "CFD/0/U": FIELDS["0/U.air"].replace("interstitialInletVelocity; inletVelocity uniform (0 0 0.1); "
                                         "phi phi.air;\n            alpha alpha.air; value "
                                         "$internalField;", "fixedValue; value uniform (0 0 0.1);"),
    "CFD/0/p": FIELDS["0/p"],
    "CFD/0/voidfraction": "dimensions []; internalField uniform 1;\n"
                          'boundaryField { ".*" { type zeroGradient; } }\n',
    "CFD/0/rho": "dimensions [1 -3 0 0 0 0 0]; internalField uniform 10;\n"
                 'boundaryField { ".*" { type zeroGradient; } }\n',
}


def cfdem_case(**more):
    """A case of CFDEMcoupling. Keywords as of cloud_case, and coupling, commands, script."""
    files = {"CFD/" + name: text for name, text in SYSTEM.items()}
    files["CFD/system/controlDict"] = files["CFD/system/controlDict"].replace(
        "DPMFoam", "cfdemSolverPiso")
    files.update({**CFD_FIELDS, "CFD/constant/couplingProperties": COUPLING,
                  "CFD/constant/liggghtsCommands": COMMANDS, "DEM/in.run": DEM + INSERT + RUN + "run 0\n",
                  **more.pop("files", {})})
    names = {"coupling": "CFD/constant/couplingProperties", "control": "CFD/system/controlDict",
             "commands": "CFD/constant/liggghtsCommands", "script": "DEM/in.run",
             "mesh": "CFD/system/blockMeshDict", "schemes": "CFD/system/fvSchemes"}
    for key, changes in more.items():
        files[names[key]] = changed(files[names[key]], changes)
    write_case(WORK/"source", files)
    shutil.rmtree(WORK/"result", ignore_errors=True)
    report = Report()
    cfdem.translate_cfdem(WORK/"source", WORK/"result", report)
    return Result(report)


def refuses(word, *sentence, **change):
    """A change of couplingProperties is refused at the line of `word`."""
    refused(lambda: cfdem_case(**change), "CFD/constant/couplingProperties",
            line_of(COUPLING, word), *sentence)


def cfdem_words():
    """a case of CFDEMcoupling becomes one of demPimpleFoam, with its lines"""
    result = cfdem_case()
    effects, coupling = result.d.sub("effects"), result.d.sub("coupling")
    assert {"kochHill", "pressureGradient", "viscousStress", "hertz", "dry", "mindlin"} <= {
        e.name for e in effects.entries}
    assert effects.sub("dry").number("restitution") == 0.3
    assert (coupling.number("rho"), coupling.word("equations"), coupling.word("kernel")) == (
        10, "II", "divided")
    assert coupling.number("minVoidFraction") == 0.3
    assert f"// CFD/constant/couplingProperties:{line_of(COUPLING, 'forceModels')}" in result.text
    assert result.has(HARMLESS, "particleCellVolume") and result.has(HARMLESS, "writeLiggghts")
    void = read_dictionary(WORK/"result/0/voidFraction", "voidFraction", Report())
    assert void.sub("boundaryField").sub("inlet").word("type") == "zeroGradient"
    pressure = read_dictionary(WORK/"result/0/p", "p", Report()).sub("boundaryField")
    assert pressure.sub("inlet").word("type") == "fixedFluxPressure"
    left = {path.name for path in (WORK/"result").rglob("*")}
    assert not left & {"couplingProperties", "liggghtsCommands", "voidfraction", "rho"}
    group = next(iter(result.d.sub("insert").subs()))[1]
    assert group.number("diameter") == 1e-3 and group.number("count") == 30


def equations():
    """models A, B and Bfull are sets II, III and I, each with the forces that it needs"""
    for model, number in (("A", "II"), ("Bfull", "I"), ("B", "III")):
        d = cfdem_case(coupling={"modelType A": f"modelType {model}"}).d
        assert d.sub("coupling").word("equations") == number
        assert "pressureGradient" in d.sub("effects")
        assert ("viscousStress" in d.sub("effects")) == (model != "B")
    result = cfdem_case(coupling={"    gradPForce\n": "", "    Archimedes\n": ""})
    assert "pressureGradient" in result.d.sub("effects") and result.has(APPROXIMATED, "with buoyancy")
    refuses("modelType", "has no averaged equations", coupling={"modelType A": "modelType none"})
    refuses("modelType", "A, B, Bfull", coupling={"modelType A": "modelType C"})


def kernels():
    """void fraction models are kernels; the width of smoothing has its variance"""
    for model, kernel in (("centre", "particleCentre"), ("bigParticle", "divided"),
                          ("trilinear", "linear"), ("Gauss", "gaussian")):
        d = cfdem_case(coupling={"voidFractionModel divided": f"voidFractionModel {model}"}).d
        assert d.sub("coupling").word("kernel") == kernel, model
        assert d.sub("coupling").number("minVoidFraction") == 0.1
    for model, word in (("IB", "resolved"), ("noVoidFraction", "no volume"), ("cube", "known are")):
        refuses("voidFractionModel", word,
                coupling={"voidFractionModel divided": f"voidFractionModel {model}"})
    d = cfdem_case(coupling={"smoothingModel off": "smoothingModel constDiffSmoothing"}).d.sub("coupling")
    assert (d.word("kernel"), d.word("base")) == ("diffusion", "divided")
    # one implicit step of diffusion with D dt = L^2 on cells of L/20, against b^2/2 of the kernel
    width, length, h, n = d.number("width")*1e-3, 2e-3, 1e-4, 1201
    matrix = numpy.diag(numpy.full(n, 1 + 2*(length/h)**2))
    for k in (1, -1):
        matrix += numpy.diag(numpy.full(n - 1, -(length/h)**2), k)
    x = h*(numpy.arange(n) - n//2)
    s = numpy.linalg.solve(matrix, (x == 0).astype(float))
    assert abs((s*x**2).sum()/s.sum()/(width**2/2) - 1) < 1e-3
    refuses("smoothingModel", "known are", coupling={"smoothingModel off": "smoothingModel magic"})
    refuses("dividedProps", "scales the volumes", coupling={"alphaMin 0.3;": "alphaMin 0.3; weight 2;"})
    refuses("dividedProps", "does not know", coupling={"alphaMin 0.3;": "alphaMin 0.3; moon 2;"})


def cfdem_forces():
    """each force model has its effect, or a sentence; settings that change the answer are refused"""
    for name, effect in (("DiFeliceDrag", "diFelice"), ("GidaspowDrag", "gidaspow"), ("RongDrag", "rong"),
                         ("BeetstraDrag", "beetstra"), ("SchillerNaumannDrag", "schillerNaumann"),
                         ("KochHillDrag virtualMassForce", "virtualMass"),
                         ("KochHillDrag MeiLift", "saffmanMei")):
        assert effect in cfdem_case(coupling={"    KochHillDrag": name}).d.sub("effects"), name
    for name in cfdem_models.REFUSED_FORCES:
        refuses("forceModels", name, coupling={"    KochHillDrag": name})
    refuses("forceModels", "magicDrag", coupling={"    KochHillDrag": "magicDrag"})
    refuses("forceModels", "two laws", coupling={"    KochHillDrag": "KochHillDrag RongDrag"})
    for setting, word in (("useFilteredDragModel true;", "filtered"), ("scale 2;", "only 1"),
                          ("scaleDrag 1.1;", "only 1"), ("velFieldName V;", "the field is U"),
                          ("treatForceDEM true;", "keeps momentum"), ("moon 3;", "does not know"),
                          ("scalarViscosity true; nu nu [0 2 -1 0 0 0 0] 1e-4;", "viscosity of its own")):
        refuses("KochHillDragProps", word, coupling={"KochHillDragProps {": "KochHillDragProps { " + setting})
    cfdem_case(coupling={"KochHillDragProps {": "KochHillDragProps { scalarViscosity false; nu nu [] 1; "
                         "scale 1; verbose; explicitCorr true; treatForceDEM false;"})
    d = cfdem_case(coupling={"    KochHillDrag": "KochHillDrag virtualMassForce",
                             "viscForceProps": "virtualMassForceProps { Cadd 0.4; } viscForceProps"}).d
    assert d.sub("effects").sub("virtualMass").number("coefficient") == 0.4


def exchange():
    """momentum coupling, coupling interval, data exchange, commands, solver"""
    assert cfdem_case().has(APPROXIMATED, "implicitCouple", "keeps momentum")
    assert cfdem_case(coupling={"    implicitCouple": "explicitCouple"}).has(APPROXIMATED, "explicitCouple")
    for new in ("off", ""):
        d = cfdem_case(coupling={"    implicitCouple": new}).d.sub("coupling")
        assert not d.switch("twoWay", True)
    refuses("momCoupleModels", "magic", coupling={"    implicitCouple": "magic"})
    refuses("dataExchangeModel", "VTK", coupling={"Model twoWayMPI": "Model oneWayVTK"})
    refuses("locateModel", "known are", coupling={"locateModel engine": "locateModel magic"})
    refuses("modelType", "solveFlow", coupling={"modelType A": "solveFlow off; modelType A"})
    refuses("turbulenceModelType", "moon", coupling={"turbulenceModelType": "moon 3; turbulenceModelType"})
    refuses('"(twoWay', "no such file", coupling={"in.run": "in.nowhere"})
    assert cfdem_case(coupling={"Interval 100": "Interval 200"}).has(APPROXIMATED, "each fluid step")
    cfdem_case(coupling={"Interval 100": "Interval 50"})
    control = read_dictionary(WORK/"result/system/controlDict", "controlDict", Report())
    assert control.number("deltaT") == 5e-4 and control.word("application") == "demPimpleFoam"
    execute = "liggghtsCommandModels ( execute );\nexecuteProps0 { command ( set region noBlanks x ); }\n"
    refused(lambda: cfdem_case(files={"CFD/constant/liggghtsCommands": execute}),
            "CFD/constant/liggghtsCommands", 3, "set region x")
    execute = execute.replace("set region", "write_restart")
    assert cfdem_case(files={"CFD/constant/liggghtsCommands": execute}).has(HARMLESS, "write_restart")
    for name in cfdem.REFUSED_SOLVERS:
        refused(lambda: cfdem_case(control={"cfdemSolverPiso": name}), "CFD/system/controlDict", 3, name)
    assert cfdem_case(schemes={"default Euler": "default backward"}).has(APPROXIMATED, "Euler")
    source = "momentum { type meanSupVelocityForce; meanSupVelocityForceCoeffs { Ubar (0 0 2); } }\n"
    assert cfdem_case(files={"CFD/system/fvOptions": source}).has(APPROXIMATED, "meanVelocityForce")
    options = read_dictionary(WORK/"result/system/fvOptions", "fvOptions", Report())
    assert options.sub("momentum").word("type") == "meanVelocityForce"
    refused(lambda: cfdem_case(files={"CFD/0/rho": "internalField nonuniform List<scalar> 1(1);"}),
            "CFD/0/rho", 2, "one density")


TWO_FLUIDS = {
    "CFD/constant/transportProperties": "phases ( oil { transportModel Newtonian; nu nu [0 2 -1 0 0 0 0] 1e-5; "
                                        "rho rho [1 -3 0 0 0 0 0] 900; } air { transportModel Newtonian; "
                                        "nu 1.5e-5; rho 1.2; } );\nsigmas ( (air oil) 0.03 );\n",
    "CFD/0/alpha.oil": "dimensions []; internalField uniform 1;\n"
                       'boundaryField { ".*" { type zeroGradient; } }\n',
    "CFD/0/alpha.air": "dimensions []; internalField uniform 0;\n"
                       'boundaryField { ".*" { type zeroGradient; } }\n',
    "CFD/0/p_rgh": "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;\nboundaryField { inlet { type "
                   "zeroGradient; } sides { type zeroGradient; } outlet { type fixedValue; value uniform 0; } }\n",
}


def two_fluids_case(**more):
    return cfdem_case(files={**TWO_FLUIDS, **more.pop("files", {})},
                      control={"cfdemSolverPiso": "cfdemSolverMultiphase"}, **more)


def two_fluids():
    """cfdemSolverMultiphase becomes demInterFoam: phases, sigma, alpha and walls"""
    result = two_fluids_case(coupling={"    KochHillDrag": "KochHillDrag surfaceTensionForce"})
    fluids = read_dictionary(WORK/"result/constant/transportProperties", "transportProperties", Report())
    assert [str(x) for x in fluids.list("phases")] == ["oil", "air"] and fluids.number("sigma") == 0.03
    assert (fluids.sub("oil").number("rho"), fluids.sub("oil").number("nu")) == (900, 1e-5)
    assert len(fluids.sub("oil").tokens("nu")) == 1
    control = read_dictionary(WORK/"result/system/controlDict", "controlDict", Report())
    assert control.word("application") == "demInterFoam"
    pressure = read_dictionary(WORK/"result/0/p_rgh", "p_rgh", Report()).sub("boundaryField")
    assert [pressure.sub(name).word("type") for name in ("inlet", "sides", "outlet")] == [
        "fixedFluxPressure", "fixedFluxPressure", "fixedValue"]
    left = {path.name for path in (WORK/"result/0").iterdir()}
    assert "alpha.oil" in left and "alpha.air" not in left
    assert "rho" not in result.d.sub("coupling") and "pressureGradient" in result.d.sub("effects")
    assert not result.has(APPROXIMATED, "capillary") and two_fluids_case().has(APPROXIMATED, "capillary")
    two_fluids_case(files={"CFD/system/fvSolution": changed(SYSTEM["system/fvSolution"], {
        "solvers\n{": "solvers\n{ alpha { nAlphaSubCycles 4; cAlpha 2; }"})})
    solution = read_dictionary(WORK/"result/system/fvSolution", "fvSolution", Report())
    settings = solution.sub("solvers").sub("alpha.oil")
    assert (settings.number("nAlphaSubCycles"), settings.number("cAlpha")) == (4, 2)
    name = "CFD/constant/transportProperties"
    for change, line, word in (({"air {": "gas {"}, 3, "no surface tension"), ({"rho 1.2;": ""}, 2, "rho"),
                               ({"1.2; }": "1.2; } water { rho 1000; }"}, 2, "two")):
        refused(lambda: two_fluids_case(files={name: changed(TWO_FLUIDS[name], change)}), name, line, word)
    refused(lambda: two_fluids_case(files={"CFD/0/alpha.oil": changed(TWO_FLUIDS["CFD/0/alpha.oil"], {
        "zeroGradient": "alphaContactAngle"})}), "CFD/0/alpha.oil", 3, "constantAlphaContactAngle")
    refuses("modelType", "set II", files=TWO_FLUIDS, control={"cfdemSolverPiso": "cfdemSolverMultiphase"},
            coupling={"modelType A": "modelType B"})


def walls():
    """walls of the script act once: patches stand for those on the mesh's boundary"""
    result = cfdem_case()
    walls = result.d.sub("walls")
    assert "inlet" in walls and "outlet" in result.d.sub("outlets")
    assert "low" not in walls and "side" not in walls and "far" not in walls and "pipe" not in walls
    inner = walls.sub("inner")
    assert inner.word("type") == "plane" and inner.vector("point")[1] == 0.009
    assert inner.vector("normal") == (0, -1, 0)
    assert result.has(APPROXIMATED, "outside the mesh") and result.has(APPROXIMATED, "its radius is")
    refused(lambda: cfdem_case(script={"boundary        f f f": "boundary p f f"}), "DEM/in.run", 3,
            "periodic")
    d = cfdem_case(script={"fix  inner all": "fix  sides all"}).d.sub("walls")
    assert d.sub("sides_2").word("type") == "plane"
    pipe = cfdem_case(script={"zcylinder 0.0075": "zcylinder 0.004"}).d.sub("walls").sub("pipe")
    assert pipe.number("radius") == 0.004 and pipe.word("particles") == "inside"
    assert pipe.vector("point") == (0.005, 0.005, 0)
    pipe = cfdem_case(script={"zcylinder 0.0075 0.005 0.005": "ycylinder 0.02 0.01 0.005"}).d.sub("walls").sub("pipe")
    assert pipe.vector("point") == (0.005, 0, 0.01)         # z, then x
    for fix in ("low all", "gravi all"):
        refused(lambda: cfdem_case(script={f"fix  {fix}": f"group g type 1\nfix  {fix.replace('all', 'g')}"}),
                "DEM/in.run", line_of(DEM, fix, 0) + 1, "group g", "acts on all particles")


def quad(a, b, c, d):
    return [(a, b, c), (a, c, d)]


def surfaces():
    """triangles of the script that lie on patches become these patches, with their distance"""
    x = numpy.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])*0.01
    top = x + (0, 0, 0.04)
    tub = numpy.array([t for k in range(4) for t in quad(x[k], x[k - 3], top[k - 3], top[k])])
    floor = numpy.array(quad(*x))

    def case(triangles, **more):
        path = WORK/"wall.stl"
        write_stl(path, triangles)
        lines = [line for line in DEM.splitlines() if "primitive" not in line]
        lines += ["fix  cad all mesh/surface file cad.stl type 1", "fix  w all wall/gran model hertz "
                  "tangential history mesh n_meshes 1 meshes cad\n"]
        return cfdem_case(files={"DEM/in.run": "\n".join(lines) + INSERT + RUN + "run 0\n",
                                 "DEM/cad.stl": path.read_text()}, **more)

    def entries(result, name):
        return [str(name) for name, _ in result.d.sub(name).subs()]

    result = case(numpy.concatenate([tub, floor]))
    assert entries(result, "walls") == ["inlet", "sides"] and entries(result, "outlets") == ["outlet"]
    line = len([line for line in DEM.splitlines() if "primitive" not in line]) + 1
    assert result.has(APPROXIMATED, f"in.run:{line}", "inlet (becomes a wall)", "sides (is already")
    # 1/20 of a diameter off the patch: reported; larger than the mesh: only the part inside counts
    assert case(floor + (0, 0, 5e-5)).has(APPROXIMATED, "inlet (becomes", "up to 5e-05 m")
    assert entries(case((floor - 0.005)*(9, 9, 1) + (0, 0, 0.005)), "walls") == ["inlet"]
    assert case(floor + (0, 0, 0.05)).has(APPROXIMATED, "outside the mesh")
    # a baffle, and a plate that covers half of the inlet, stay
    for triangles, word in ((floor + (0, 0, 0.02), "from the patches, more than 0.0001 m"),
                            (floor*(1, 0.5, 1), "only a part of patch inlet")):
        result = case(triangles)
        assert entries(result, "walls") == ["cad"] and "inlet" in entries(result, "outlets")
        assert result.d.sub("walls").sub("cad").word("file") == "cad.stl" and result.has(
            TRANSLATED, word)
        assert numpy.allclose(read_triangles(WORK/"result/constant/triSurface/cad.stl"), triangles)
    refused(lambda: case(floor, mesh={"inlet { type patch;": "inlet { type cyclic; neighbourPatch "
                                      "outlet;"}), "DEM/in.run", line, "coupled patch inlet")
    # round walls: corners of both lie on the cylinder, the largest distance is between them
    angle = 2*math.pi*numpy.arange(24)/24
    ring = numpy.column_stack([numpy.cos(angle), numpy.sin(angle), 0*angle])
    high = ring + (0, 0, 1)
    pipe = numpy.array([t for k in range(24) for t in quad(ring[k - 1], ring[k], high[k], high[k - 1])])
    assert distance(samples(pipe, 0.05), pipe, 0.05).max() < 1e-12
    coarse = [t for k in range(0, 24, 2) for t in quad(
        ring[k - 2], ring[k], high[k], high[k - 2])]
    # sagitta of a chord of 30 degrees less a part of the sagitta of 15 degrees
    away = distance(samples(pipe, 0.02), numpy.array(coarse), 0.02).max()
    assert 0.9*(1 - math.cos(math.pi/12)) < away < 1 - math.cos(math.pi/12), away


def units():
    """numbers of a script in cgs stay unchanged, and so do the numbers of the fields"""
    result = cfdem_case(script={"units           si": "units           cgs"})
    effects = result.d.sub("effects")
    assert result.d.sub("materials").sub("grains").number("density") == 2000
    assert effects.sub("hertz").number("impactSpeed") == 100
    assert result.has(APPROXIMATED, "DEM/in.run:1", "units cgs")
    assert not cfdem_case().d.sub("effects").sub("hertz").entries


def settled():
    """particles of a restart file come from the script that writes it"""
    init = DEM + INSERT + "fix integr all nve/sphere\nrun 100\nwrite_restart post/bed.restart\n"
    again = DEM.replace("region          reg block 0 0.01 0 0.01 0 0.04 units box\n"
                        "create_box      1 reg\n", "read_restart ../DEM/post/bed.restart\n")
    result = cfdem_case(files={"DEM/in.run": again + RUN + "run 0\n", "DEM/in.init": init})
    group = next(iter(result.d.sub("insert").subs()))[1]
    assert group.number("count") == 30
    assert result.d.sub("start").tokens("snapshot") == ["settled.dem"]
    assert abs(result.d.sub("time").number("end") - 1e-3) < 1e-12 and "untilQuiet" in result.d.sub("time")
    refused(lambda: cfdem_case(files={"DEM/in.run": again + RUN + "run 0\n"}), "DEM/in.run", 6,
            "bed.restart")


def cfdem_runs():
    """the translated cases of CFDEMcoupling run"""
    cfdem_case()
    run(["demPimpleFoam"])
    two_fluids_case()
    run(["demInterFoam"])


TESTS = [syntax, meshes, dpm, restitution, forces, contacts, patches, injections, distributions,
         not_dem, uncoupled, cfdem_words, equations, kernels, cfdem_forces, exchange, two_fluids, walls, surfaces, units,
         settled]
RUNS = [cloud_runs, cfdem_runs]


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    run_tests(*TESTS)
    if shutil.which("demPimpleFoam"):
        run_tests(*RUNS)
    else:
        skip("the translated cases run", "no demPimpleFoam")
    finish()


if __name__ == "__main__":
    main()
